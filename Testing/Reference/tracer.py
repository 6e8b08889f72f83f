# SPDX-License-Identifier: BSD-3-Clause
"""Path traces a description with Mitsuba 3; runs in the environment that make_environment makes.

    python tracer.py DESCRIPTION_FOLDER job.json

A job names what to compute, see `JOBS`; results are .npz files beside the description. All images
are (height, width, ...), bottom row first, irradiance in VTK's units: outgoing = albedo * E.

Side and shading are VTK's: the winding of a triangle decides which side a ray sees, the vertices'
normal is turned to that side, and light counts by its cosine to that normal when it comes from that
side of the triangle. A surface that is lit from behind is dark.
"""

from __future__ import annotations

import ctypes.util
import hashlib
import json
import math
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np

import description


def _choose_variant() -> str:
    """Take the vectorising variant, or the scalar one with a note when there is no LLVM."""
    forced = os.environ.get("VTKINDIRECT_MITSUBA_VARIANT")
    if forced:
        return forced
    known = ["LLVM-19", "LLVM-20", "LLVM-18", "LLVM-17", "LLVM"]
    if os.environ.get("DRJIT_LIBLLVM_PATH") or any(map(ctypes.util.find_library, known)):
        return "llvm_ad_rgb"
    print(
        "note: no LLVM was found, so the slow variant scalar_rgb is used; "
        "on Debian: apt-get install libllvm19",
        file=sys.stderr,
        flush=True,
    )
    return "scalar_rgb"


VARIANT = _choose_variant()
mi.set_variant(VARIANT)
SCALAR = VARIANT.startswith("scalar")

import drjit as dr  # noqa: E402  needs the variant

# Samples that are traced at once; about 1 kB of memory each with several bounces.
LANES = 1 << 20

# After how many seconds a timed batch is not repeated any more.
LONG_ENOUGH = 2.0


# The scene ----------------------------------------------------------------------------------------


class VTKLight(mi.Emitter):
    """A positional light of VTK that no built-in emitter equals.

    Its irradiance on a surface that faces it is `irradiance` times cos^exponent inside a cone with
    a hard edge, divided by c + l d + q d^2.
    """

    def __init__(self, properties: mi.Properties) -> None:
        mi.Emitter.__init__(self, properties)
        self.position = mi.ScalarPoint3f(properties["position"])
        self.direction = mi.ScalarVector3f(properties["direction"])
        self.irradiance = mi.ScalarColor3f(properties["irradiance"])
        self.attenuation = list(mi.ScalarVector3f(properties["attenuation"]))
        self.cutoff = float(properties["cutoff"])
        self.exponent = float(properties["exponent"])
        self.m_flags = mi.EmitterFlags.DeltaPosition

    def sample_direction(self, reference: Any, _sample: Any, active: Any = True) -> tuple[Any, Any]:
        offset = mi.Point3f(self.position) - reference.p
        distance = dr.norm(offset)
        sample = mi.DirectionSample3f() if SCALAR else dr.zeros(mi.DirectionSample3f)
        sample.p = mi.Point3f(self.position)
        sample.dist = distance
        sample.d = offset / distance
        sample.n = -sample.d
        sample.time = reference.time
        sample.pdf = 1.0
        sample.delta = True
        constant, linear, quadratic = self.attenuation
        cosine = -dr.dot(sample.d, mi.Vector3f(self.direction))
        value = 1.0 / (constant + distance * (linear + distance * quadratic))
        if self.exponent > 0.0:
            value *= dr.power(dr.maximum(cosine, 0.0), self.exponent)
        value = dr.select(active & (cosine >= self.cutoff), value, 0.0)
        return sample, mi.Color3f(self.irradiance) * value

    # A ray never meets a point.

    def eval(self, _interaction: Any, _active: Any = True) -> Any:
        return mi.Color3f(0.0)

    def eval_direction(self, _reference: Any, _sample: Any, _active: Any = True) -> Any:
        return mi.Color3f(0.0)

    def pdf_direction(self, _reference: Any, _sample: Any, _active: Any = True) -> Any:
        return mi.Float(0.0)

    def bbox(self) -> mi.ScalarBoundingBox3f:
        return mi.ScalarBoundingBox3f(self.position)


mi.register_emitter("vtk_light", VTKLight)


def make_emitter(values: dict[str, Any]) -> dict[str, Any]:
    """Return Mitsuba's dictionary for an emitter of `description.emitter`."""

    def rgb(key: str) -> dict[str, Any]:
        return {"type": "rgb", "value": values[key]}

    kind = values["type"]
    if kind == "directional":
        return {"type": kind, "direction": values["direction"], "irradiance": rgb("irradiance")}
    if kind == "point":
        return {"type": kind, "position": values["position"], "intensity": rgb("intensity")}
    if kind == "spot":
        x, y, z = np.abs(values["direction"])
        up = [1.0, 0.0, 0.0] if x < max(y, z) else [0.0, 1.0, 0.0]
        target = [p + d for p, d in zip(values["position"], values["direction"])]
        look = mi.ScalarTransform4f().look_at(values["position"], target, up)
        return {
            "type": kind,
            "to_world": look,
            "intensity": rgb("intensity"),
            "cutoff_angle": values["cone"],
            "beam_width": values["cone"],
        }
    cone = values["cone"]
    return {
        "type": kind,
        "position": mi.ScalarVector3f(values["position"]),
        "direction": mi.ScalarVector3f(values["direction"]),
        "irradiance": mi.ScalarVector3f(values["irradiance"]),
        "attenuation": mi.ScalarVector3f(values["attenuation"]),
        "cutoff": -2.0 if cone is None else math.cos(math.radians(cone)),
        "exponent": values["exponent"],
    }


def make_scene(scene: description.Description) -> mi.Scene:
    """Return the Mitsuba scene of a description, in tracer coordinates."""
    surface = scene.surface
    properties = mi.Properties()
    properties["mesh_bsdf"] = mi.load_dict(
        {
            "type": "twosided",
            "material": {
                "type": "diffuse",
                "reflectance": {"type": "mesh_attribute", "name": "vertex_color"},
            },
        }
    )
    mesh = mi.Mesh(
        scene.name,
        vertex_count=len(surface.points),
        face_count=len(surface.faces),
        has_vertex_normals=True,
        has_vertex_texcoords=False,
        props=properties,
    )
    mesh.add_attribute("vertex_color", 3, surface.albedo.astype(np.float32).ravel())
    parameters = mi.traverse(mesh)
    points = (surface.points - scene.center) * scene.scale
    parameters["faces"] = surface.faces.astype(np.uint32).ravel()
    parameters["vertex_positions"] = points.astype(np.float32).ravel()
    parameters["vertex_normals"] = surface.normals.astype(np.float32).ravel()
    parameters.update()
    objects: dict[str, Any] = {"type": "scene", "surface": mesh}
    for index, light in enumerate(scene.lights):
        emitted = description.emitter(light, scene.center, scene.scale)
        objects[f"light{index}"] = make_emitter(emitted)
    return mi.load_dict(objects)


# Light --------------------------------------------------------------------------------------------


def _origin(point: Any, facet: Any, back: Any) -> Any:
    """Return where rays from a surface start: off its facet, and back towards where it was seen.

    The way to the eye is free, so `back` keeps a point in a corner from ending up behind the other
    wall.
    """
    return point + (facet + back) * ((1.0 + dr.max(dr.abs(point))) * mi.math.RayEpsilon)


def _sides(hit: Any, direction: Any) -> tuple[Any, Any, Any]:
    """Return the facet's and the shading normal at hits, on the side that the ray sees, and where.

    Where there is none (normals of opposite signs that cancel, slivers without area) the surface is
    drawn but takes no part in lighting, as in the passes.
    """
    front = dr.dot(hit.n, direction) < 0.0
    facet, normal = hit.n, hit.sh_frame.n
    # False for NaN too.
    there = (dr.dot(facet, facet) > 0.5) & (dr.dot(normal, normal) > 0.5)
    sign = dr.select(front, 1.0, -1.0)
    anything = mi.Normal3f(0.0, 0.0, 1.0)
    return (
        dr.select(there, facet * sign, anything),
        dr.select(there, normal * sign, anything),
        there,
    )


def _albedo(hit: Any, there: Any) -> Any:
    """Return the diffuse reflectance at hits, black where there is none.

    Interpolation in a triangle that is all but a line gives numbers that are no colours.
    """
    value = hit.bsdf().eval_diffuse_reflectance(hit, there)
    return dr.select(there & dr.all((value >= 0.0) & (value < 2.0)), value, 0.0)


def direct(scene: mi.Scene, point: Any, back: Any, facet: Any, normal: Any, active: Any) -> Any:
    """Return the direct irradiance at a point in VTK's units, shadowed; see `_origin`."""
    total = mi.Color3f(0.0)
    reference = mi.Interaction3f() if SCALAR else dr.zeros(mi.Interaction3f)
    reference.p = point
    reference.n = facet
    origin = _origin(point, facet, back)
    for emitter in scene.emitters():
        sample, weight = emitter.sample_direction(reference, mi.Point2f(0.5, 0.5), active)
        cosine = dr.dot(normal, sample.d)
        lit = active & (cosine > 0.0) & (dr.dot(facet, sample.d) > 0.0)
        lit &= dr.max(weight) > 0.0
        way = sample.p - origin
        length = dr.norm(way)
        ray = mi.Ray3f(origin, way / length, length * (1.0 - mi.math.ShadowEpsilon), 0.0, [])
        lit &= ~scene.ray_test(ray, lit)
        total += dr.select(lit, weight * (cosine * dr.inv_pi), 0.0)
    return total


def first_hit(scene: mi.Scene, ray: mi.Ray3f) -> dict[str, Any]:
    """Return what rays from the eye meet: receivers, and their albedo and direct irradiance."""
    hit = scene.ray_intersect(ray)
    valid = hit.is_valid()
    if SCALAR and not valid:
        zero = [0.0, 0.0, 0.0]
        names = ("point", "back", "facet", "normal", "albedo", "direct")
        return {"valid": False, **{name: zero for name in names}}
    facet, normal, there = _sides(hit, ray.d)
    valid &= there
    return {
        "valid": valid,
        "point": hit.p,
        "back": -ray.d,
        "facet": facet,
        "normal": normal,
        "albedo": _albedo(hit, valid),
        "direct": direct(scene, hit.p, -ray.d, facet, normal, valid),
    }


def bounces(
    scene: mi.Scene, start: dict[str, Any], sampler: mi.Sampler, depth: int
) -> Iterator[tuple[Any, Any]]:
    """Yield the incident irradiance at receivers by bounce 1, 2, ... `depth`, one sample each.

    Each is the light and the lanes that it belongs to; other lanes have none. There is no Russian
    roulette: a path ends where it leaves the scene, or at `depth`.
    """
    point, back = start["point"], start["back"]
    facet, normal = start["facet"], start["normal"]
    throughput = mi.Color3f(1.0)
    lane = None if SCALAR else dr.arange(mi.UInt32, dr.width(point))
    for _ in range(depth):
        local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
        if not SCALAR:
            local = dr.gather(mi.Vector3f, local, lane)
        direction = mi.Frame3f(normal).to_world(local)
        active = dr.dot(direction, facet) > 0.0
        hit = scene.ray_intersect(mi.Ray3f(_origin(point, facet, back), direction), active)
        active &= hit.is_valid()
        if SCALAR:
            if not active:
                return
        else:
            # Paths that left the scene cost nothing more.
            dr.eval(hit, active, direction)
            alive = dr.compress(active)
            if dr.width(alive) == 0:
                return
            hit, direction = dr.gather(type(hit), hit, alive), _take(direction, alive)
            throughput, lane = _take(throughput, alive), _take(lane, alive)
        point, back = hit.p, -direction
        facet, normal, there = _sides(hit, direction)
        throughput = throughput * _albedo(hit, there)
        light = throughput * direct(scene, point, back, facet, normal, there)
        dr.eval(light, point, back, facet, normal, throughput, lane)
        yield light, lane


def through_everything(
    scene: mi.Scene, start: dict[str, Any], sampler: mi.Sampler, layers: int
) -> Iterator[tuple[Any, Any]]:
    """Yield one sample of the irradiance by one bounce that nothing stands in the way of.

    The way from light to sender is shadowed, that from sender to receiver is not: a ray counts all
    surfaces along it, at most `layers`. Each surface is yielded by itself, and all are one bounce.
    """
    point = start["point"]
    local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
    direction = mi.Frame3f(start["normal"]).to_world(local)
    lane = None if SCALAR else dr.arange(mi.UInt32, dr.width(point))
    for _ in range(layers):
        hit = scene.ray_intersect(mi.Ray3f(_origin(point, direction, 0.0), direction))
        active = hit.is_valid()
        if SCALAR:
            if not active:
                return
        else:
            dr.eval(hit, direction)
            alive = dr.compress(active)
            if dr.width(alive) == 0:
                return
            hit, direction = dr.gather(type(hit), hit, alive), _take(direction, alive)
            lane = _take(lane, alive)
        point = hit.p
        facet, normal, there = _sides(hit, direction)
        light = direct(scene, point, -direction, facet, normal, there)
        light = light * _albedo(hit, there)
        dr.eval(light, point, direction, lane)
        yield light, lane


def _take(values: Any, where: Any) -> Any:
    return dr.gather(type(values), values, where)


# Jobs ---------------------------------------------------------------------------------------------

# What an estimator needs to know of a receiver.
RECEIVER = ("point", "back", "facet", "normal")

Estimator = Callable[[mi.Scene, dict[str, Any], mi.Sampler, int], Iterator[tuple[Any, Any]]]

ESTIMATORS: dict[str, Estimator] = {"bounces": bounces, "open": through_everything}


def seed_of(*parts: Any) -> int:
    """Return a 32 bit seed that depends on all parts and nothing else."""
    digest = hashlib.sha256("/".join(map(str, parts)).encode()).digest()
    return int.from_bytes(digest[:4], "little")


def _sampler(samples: int, seed: int, lanes: int) -> mi.Sampler:
    sampler = mi.load_dict({"type": "multijitter", "sample_count": samples})
    if sampler.sample_count() != samples:
        raise ValueError(f"multijitter makes {sampler.sample_count()} samples, not {samples}")
    sampler.set_samples_per_wavefront(samples)
    sampler.seed(seed, lanes)
    return sampler


def _average(
    scene: mi.Scene, start: dict[str, Any], samples: int, seed: int, depth: int, what: Estimator
) -> np.ndarray:
    """Return the mean of `samples` samples at receivers, in lanes: (receivers, depth, 3)."""
    count = dr.width(start["point"])
    index = dr.arange(mi.UInt32, count * samples) // samples
    lanes = {key: _take(value, index) for key, value in start.items()}
    result = np.zeros((count, depth, 3))
    sampler = _sampler(samples, seed, count * samples)
    for bounce, (light, lane) in enumerate(what(scene, lanes, sampler, depth)):
        # Sums in fixed order, so that the same seed gives the same bits.
        each = dr.zeros(mi.Color3f, count * samples)
        dr.scatter(each, light, lane)
        total = [dr.block_sum(each[channel], samples) for channel in range(3)]
        result[:, bounce] = _columns(total) / samples
    return result


def _average_scalar(
    scene: mi.Scene, start: dict[str, Any], samples: int, seed: int, depth: int, what: Estimator
) -> np.ndarray:
    """Return the same as `_average`, one sample after the other."""
    points, backs, facets, normals = (_columns(start[key]) for key in RECEIVER)
    result = np.zeros((len(points), depth, 3))
    sampler = mi.load_dict({"type": "independent", "sample_count": samples})
    sampler.seed(seed)
    for i, (point, back, facet, normal) in enumerate(zip(points, backs, facets, normals)):
        lane = {
            "point": mi.Point3f(point),
            "back": mi.Vector3f(back),
            "facet": mi.Normal3f(facet),
            "normal": mi.Normal3f(normal),
        }
        for _ in range(samples):
            for bounce, (light, _none) in enumerate(what(scene, lane, sampler, depth)):
                result[i, bounce] += np.array(light)
    return result / samples


def progress(fraction: float) -> None:
    """Tell the parent process that a part of a batch is done."""
    print(f"progress {fraction:.6f}", flush=True)


def _image(values: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    return values.reshape(size[1], size[0], *values.shape[1:]).astype(np.float32)


def _columns(value: Any) -> np.ndarray:
    """Return vectors as an array of (count, 3)."""
    if isinstance(value, np.ndarray):
        return value
    return np.stack([np.array(value[i]) for i in range(3)], axis=-1)


def _first_hits(scene: mi.Scene, origins: np.ndarray, along: np.ndarray, far: np.ndarray) -> dict:
    """Return `first_hit` of all rays: arrays of the variant, or NumPy's in the scalar one."""
    if SCALAR:
        rows = [
            first_hit(scene, mi.Ray3f(mi.Point3f(o), mi.Vector3f(d), float(t), 0.0, []))
            for o, d, t in zip(origins, along, far)
        ]
        return {key: np.array([np.array(row[key]) for row in rows]) for key in rows[0]}

    def vectors(values: np.ndarray, kind: Any) -> Any:
        return kind(*(mi.Float(np.ascontiguousarray(values[:, i], np.float32)) for i in range(3)))

    length = mi.Float(far.astype(np.float32))
    ray = mi.Ray3f(vectors(origins, mi.Point3f), vectors(along, mi.Vector3f), length, 0.0, [])
    result = first_hit(scene, ray)
    dr.eval(result)
    return result


class Tracer:
    """A description, its Mitsuba scene and what the eye sees of it."""

    def __init__(self, folder: Path, size: tuple[int, int]) -> None:
        self.description = description.load(folder)
        self.size = size
        self.scene = make_scene(self.description)
        camera = self.description.camera
        origins, directions = (v.reshape(-1, 3) for v in camera.rays(*size))
        scale = self.description.scale
        lengths = (camera.far - camera.near) / (directions @ np.array(camera.forward)) * scale
        origins = (origins - self.description.center) * scale
        self.start = _first_hits(self.scene, origins, directions, lengths)

    def surfaces(self) -> dict[str, np.ndarray]:
        """Return what the eye sees: valid, depth (scene units), normal, albedo, direct."""
        camera, start = self.description.camera, self.start
        valid = np.array(start["valid"]) > 0
        points = _columns(start["point"]) / self.description.scale + self.description.center
        depth = (points - np.array(camera.position)) @ np.array(camera.forward)
        images = {
            "valid": valid,
            "depth": np.where(valid, depth, 0.0),
            "normal": np.where(valid[:, None], _columns(start["normal"]), 0.0),
            "albedo": _columns(start["albedo"]),
            "direct": _columns(start["direct"]),
        }
        return {key: _image(value, self.size) for key, value in images.items()}

    def batch(
        self,
        kind: str,
        samples: int,
        depth: int,
        seed: list[Any],
        first: int = 1,
        most: int | None = None,
    ) -> dict[str, np.ndarray]:
        """Return `image`, the irradiance by bounces `first` to `depth`, (height, width, 3).

        `kind`: "bounces", or "open" for one bounce with nothing in the way and `depth` layers.
        `most`: how many receivers to trace, the others stay black; default: all of them.
        `means` are those of each bounce over the receivers, (bounces, 3).
        """
        valid = np.array(self.start["valid"]) > 0
        receivers = np.nonzero(valid)[0][:most]
        found = np.zeros((len(valid), depth, 3))
        chunk = max(1, LANES // samples)
        for begin in range(0, len(receivers), chunk):
            part = receivers[begin : begin + chunk]
            if SCALAR:
                start = {key: self.start[key][part] for key in RECEIVER}
                average = _average_scalar
            else:
                index = mi.UInt32(part.astype(np.uint32))
                start = {key: _take(self.start[key], index) for key in RECEIVER}
                average = _average
            own = seed_of(*seed, begin)
            found[part] = average(self.scene, start, samples, own, depth, ESTIMATORS[kind])
            progress(len(part) / len(receivers))
        if not np.isfinite(found).all():
            raise FloatingPointError(f"{np.isnan(found).sum()} values are not numbers")
        image = _image(found[:, first - 1 :].sum(axis=1), self.size)
        return {"image": image, "means": found[valid].mean(axis=0)}


def _path_means(folder: Path, size: tuple[int, int], samples: int) -> dict[str, list[float]]:
    """Return the mean radiance of bounces 1 and 2 by Mitsuba's own path integrator."""
    if SCALAR:
        raise ValueError("needs a vectorising variant")
    scene = description.load(folder)
    camera = scene.camera
    position = (np.array(camera.position) - scene.center) * scene.scale
    look = mi.ScalarTransform4f().look_at(
        position.tolist(), (position + np.array(camera.forward)).tolist(), camera.up
    )
    sensor = mi.load_dict(
        {
            "type": "perspective",
            "fov": 2.0 * math.degrees(math.atan(camera.half_height)),
            "fov_axis": "y",
            "to_world": look,
            "film": {
                "type": "hdrfilm",
                "width": size[0],
                "height": size[1],
                "rfilter": {"type": "box"},
            },
            "sampler": {"type": "multijitter", "sample_count": samples},
        }
    )
    made = make_scene(scene)
    images = []
    for depth in (2, 3, 4):
        integrator = mi.load_dict({"type": "path", "max_depth": depth, "rr_depth": 1000})
        image = mi.render(made, sensor=sensor, integrator=integrator, seed=1, spp=samples)
        images.append(np.array(image)[..., :3].mean(axis=(0, 1)))
    return {f"bounce{i + 1}": (images[i + 1] - images[i]).tolist() for i in range(2)}


def run(folder: Path, job: dict[str, Any]) -> None:
    """Do a job: {"size", "surfaces": file or None, "path": samples, "batches": [...]}.

    A batch is {"file", "kind", "samples", "depth", "seed": [...]} and maybe "first" and "repeats":
    with those it is warmed up by as many samples as are traced at once, so that compiling and the
    first use of memory do not count, and repeated until it has taken `LONG_ENOUGH`; `seconds` are
    then those of each time.
    """
    size = tuple(job["size"])
    if job.get("path"):
        means = _path_means(folder, size, job["path"])
        (folder / "path.json").write_text(json.dumps(means))
    tracer = Tracer(folder, size)
    if job.get("surfaces"):
        np.savez(folder / job["surfaces"], **tracer.surfaces())
    for batch in job.get("batches", []):
        values = {key: value for key, value in batch.items() if key not in ("file", "repeats")}
        repeats = batch.get("repeats", 0)
        if repeats:
            tracer.batch(**values, most=max(1, LANES // batch["samples"]))
        times: list[float] = []
        while not times or (len(times) < repeats and sum(times) < LONG_ENOUGH):
            began = time.perf_counter()
            found = tracer.batch(**values)
            times.append(time.perf_counter() - began)
        seconds = times if repeats else times[0]
        unfinished = folder / (batch["file"] + ".part.npz")
        np.savez(unfinished, **found, seconds=seconds)
        unfinished.replace(folder / batch["file"])
        print(f"batch {batch['file']} {sum(times):.3f}", flush=True)
    versions = {"mitsuba": mi.__version__, "drjit": dr.__version__, "variant": VARIANT}
    print("versions " + json.dumps(versions), flush=True)


if __name__ == "__main__":
    run(Path(sys.argv[1]), json.loads(Path(sys.argv[2]).read_text()))
