# SPDX-License-Identifier: BSD-3-Clause
"""Path traces a description with Mitsuba 3; runs in the environment that make_environment makes.

    python tracer.py DESCRIPTION_FOLDER job.json

A job names what to compute, see `run`; results are .npz files beside the description. All images
are (height, width, ...), bottom row first, irradiance in VTK's units: outgoing = albedo * E.
"""

from __future__ import annotations

import hashlib
import json
import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np

import description
from area_lights import Rectangle
from shading import (
    VARIANT,
    albedo_at,
    direct,
    first_hit,
    make_scene,
    ray_origin,
    sides,
    specular_at,
    take,
)
from sky import Sky

import drjit as dr  # isort: skip  needs the variant that shading chooses

# Samples that are traced at once; about 1 kB of memory each with several bounces.
LANES = 1 << 20

# After how many seconds a timed batch is not repeated any more.
LONG_ENOUGH = 2.0


# Light -----------------------------------------------------------------------------------------------


# Facts of a receiver that an estimator needs.
RECEIVER = ("point", "back", "facet", "normal")


@dataclass
class World:
    """Things that rays meet: the scene, area lights, and the sky beyond if there is one."""

    scene: mi.Scene
    sky: Sky | None = None
    area_lights: list[Rectangle] = field(default_factory=list)
    specular: bool = False  # whether a surface has VTK's specular term


Estimator = Callable[[World, dict[str, Any], mi.Sampler, int], Iterator[tuple[Any, Any]]]


def _numbers(sampler: mi.Sampler, lane: Any) -> Any:
    """Return two random numbers for each of the lanes that are left."""
    return take(sampler.next_2d(), lane)


def sky_at(world: World, receiver: dict[str, Any], sampler: mi.Sampler, lane: Any) -> Any:
    """Return one sample of the irradiance that comes directly from the sky, in VTK's units.

    E = 1/pi times the integral of radiance times cosine over the directions in which no surface is
    met. One direction is drawn by the cosine and, unless the sky is the same everywhere, one by the
    radiance. Weighted by the balance heuristic (Veach 1997, section 9.2) each of them counts
    radiance * p / (p + q), p and q the two densities at it.
    """
    facet, normal = receiver["facet"], receiver["normal"]
    start = ray_origin(receiver["point"], facet, receiver["back"])
    local = mi.warp.square_to_cosine_hemisphere(_numbers(sampler, lane))
    directions = [mi.Frame3f(normal).to_world(local)]
    if not world.sky.is_uniform:
        directions.append(world.sky.sample(_numbers(sampler, lane)))
    total = dr.zeros(mi.Color3f, dr.width(start))
    for direction in directions:
        cosine = dr.dot(normal, direction)
        free = receiver["active"] & (cosine > 0.0) & (dr.dot(facet, direction) > 0.0)
        free &= ~world.scene.ray_test(mi.Ray3f(start, direction), free)
        radiance = world.sky.radiance(direction)
        density = cosine * dr.inv_pi
        weight = density / (density + world.sky.density(radiance))
        total += dr.select(free, radiance * weight, 0.0)
    return total


def area_at(world: World, receiver: dict[str, Any], sampler: mi.Sampler, lane: Any) -> Any:
    """Return one sample of the irradiance that comes directly from area lights, in VTK's units.

    E = 1/pi times the integral of radiance times cosine over the directions in which an area light
    is met before any surface. One direction is drawn by the cosine, which counts where a light is
    near, and for each light one place by the radiance; weighted as in `sky_at`.
    """
    facet, normal, point = receiver["facet"], receiver["normal"], receiver["point"]
    start = ray_origin(point, facet, receiver["back"])
    local = mi.warp.square_to_cosine_hemisphere(_numbers(sampler, lane))
    direction = mi.Frame3f(normal).to_world(local)
    total = dr.zeros(mi.Color3f, dr.width(start))
    for light in world.area_lights:
        met, *by_cosine = light.meet(point, direction)
        for drawn, (u, v) in (
            (met, by_cosine),
            (True, light.sample(_numbers(sampler, lane))),
        ):
            place, radiance = light.place(u, v), light.radiance(u, v)
            way = place - point
            cosine = dr.dot(normal, way) * dr.rsqrt(dr.squared_norm(way))
            density, sent = light.density(radiance, way)
            free = receiver["active"] & sent & drawn
            free &= (cosine > 0.0) & (dr.dot(facet, way) > 0.0)
            along = place - start
            length = dr.norm(along)
            far = length * (1.0 - mi.math.ShadowEpsilon)
            free &= ~world.scene.ray_test(mi.Ray3f(start, along / length, far, 0.0, []), free)
            share = cosine * dr.inv_pi
            total += dr.select(free, radiance * (share / (share + density)), 0.0)
    return total


def emitted_at(world: World, receiver: dict[str, Any], sampler: mi.Sampler, lane: Any) -> Any:
    """Return one sample of what comes directly from the sky and from area lights."""
    light = mi.Color3f(0.0)
    if world.sky is not None:
        light = light + sky_at(world, receiver, sampler, lane)
    if world.area_lights:
        light = light + area_at(world, receiver, sampler, lane)
    return light


def _directly(what: Callable[..., Any]) -> Estimator:
    """Return the estimator of one sample of light that comes directly to the receivers."""

    def estimate(
        world: World, start: dict[str, Any], sampler: mi.Sampler, _depth: int
    ) -> Iterator[tuple[Any, Any]]:
        lane = dr.arange(mi.UInt32, dr.width(start["point"]))
        light = what(world, {**start, "active": mi.Bool(True)}, sampler, lane)
        dr.eval(light, lane)
        yield light, lane

    return estimate


def bounces(
    world: World,
    start: dict[str, Any],
    sampler: mi.Sampler,
    depth: int,
    with_emitters: bool = False,
) -> Iterator[tuple[Any, Any]]:
    """Yield the incident irradiance at receivers by bounce 1, 2, ... `depth`, one sample each.

    It is light of the lights, and of sky and area lights where that is asked for. Each is the light and the
    lanes that it belongs to; other lanes have none. Surfaces with VTK's specular term also show the
    lights in it; light of other surfaces they reflect diffusely. There is no Russian roulette: a path ends where
    it leaves the scene, or at `depth`.
    """
    scene = world.scene
    point, back = start["point"], start["back"]
    facet, normal = start["facet"], start["normal"]
    throughput = mi.Color3f(1.0)
    lane = dr.arange(mi.UInt32, dr.width(point))
    for _ in range(depth):
        local = mi.warp.square_to_cosine_hemisphere(_numbers(sampler, lane))
        direction = mi.Frame3f(normal).to_world(local)
        active = dr.dot(direction, facet) > 0.0
        hit = scene.ray_intersect(mi.Ray3f(ray_origin(point, facet, back), direction), active)
        active &= hit.is_valid()
        # Paths that left the scene cost nothing more.
        dr.eval(hit, active, direction)
        alive = dr.compress(active)
        if dr.width(alive) == 0:
            return
        hit, direction = dr.gather(type(hit), hit, alive), take(direction, alive)
        throughput, lane = take(throughput, alive), take(lane, alive)
        point, back = hit.p, -direction
        facet, normal, there = sides(hit, direction)
        mirrored = mi.Color3f(0.0)
        if world.specular:
            color, power = specular_at(hit, there)
            shown = direct(scene, point, back, facet, normal, there, power)
            mirrored = throughput * color * shown
        throughput = throughput * albedo_at(hit, there)
        light = direct(scene, point, back, facet, normal, there)
        if with_emitters:
            receiver = dict(zip(RECEIVER, (point, back, facet, normal)), active=there)
            light += emitted_at(world, receiver, sampler, lane)
        light = throughput * light + mirrored
        dr.eval(light, point, back, facet, normal, throughput, lane)
        yield light, lane


def all_bounces(
    world: World, start: dict[str, Any], sampler: mi.Sampler, depth: int
) -> Iterator[tuple[Any, Any]]:
    """Yield the same as `bounces`, of the lights, the sky and area lights."""
    return bounces(world, start, sampler, depth, with_emitters=True)


def through_everything(
    world: World, start: dict[str, Any], sampler: mi.Sampler, layers: int
) -> Iterator[tuple[Any, Any]]:
    """Yield one sample of the irradiance by one bounce that nothing stands in the way of.

    The way from light to sender is shadowed, that from sender to receiver is not: a ray counts all
    surfaces along it, at most `layers`. Each surface is yielded by itself, and all are one bounce.
    """
    scene = world.scene
    point = start["point"]
    local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
    direction = mi.Frame3f(start["normal"]).to_world(local)
    lane = dr.arange(mi.UInt32, dr.width(point))
    for _ in range(layers):
        hit = scene.ray_intersect(mi.Ray3f(ray_origin(point, direction, 0.0), direction))
        active = hit.is_valid()
        dr.eval(hit, direction)
        alive = dr.compress(active)
        if dr.width(alive) == 0:
            return
        hit, direction = dr.gather(type(hit), hit, alive), take(direction, alive)
        lane = take(lane, alive)
        point = hit.p
        facet, normal, there = sides(hit, direction)
        light = direct(scene, point, -direction, facet, normal, there)
        light = light * albedo_at(hit, there)
        if world.specular:
            color, power = specular_at(hit, there)
            light += color * direct(scene, point, -direction, facet, normal, there, power)
        dr.eval(light, point, direction, lane)
        yield light, lane


# Jobs ---------------------------------------------------------------------------------------------

ESTIMATORS: dict[str, Estimator] = {
    "bounces": bounces,
    "all": all_bounces,
    "sky": _directly(sky_at),
    "area": _directly(area_at),
    "open": through_everything,
}


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
    world: World, start: dict[str, Any], samples: int, seed: int, depth: int, what: Estimator
) -> np.ndarray:
    """Return the mean of `samples` samples at receivers, in lanes: (receivers, depth, 3)."""
    count = dr.width(start["point"])
    index = dr.arange(mi.UInt32, count * samples) // samples
    lanes = {key: take(value, index) for key, value in start.items()}
    result = np.zeros((count, depth, 3))
    sampler = _sampler(samples, seed, count * samples)
    for bounce, (light, lane) in enumerate(what(world, lanes, sampler, depth)):
        # Sums in fixed order, so that the same seed gives the same bits.
        each = dr.zeros(mi.Color3f, count * samples)
        dr.scatter(each, light, lane)
        total = [dr.block_sum(each[channel], samples) for channel in range(3)]
        result[:, bounce] = _columns(total) / samples
    return result


def progress(fraction: float) -> None:
    """Tell the parent process that a part of a batch is done."""
    print(f"progress {fraction:.6f}", flush=True)


def _image(values: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    return values.reshape(size[1], size[0], *values.shape[1:]).astype(np.float32)


def _columns(value: Any) -> np.ndarray:
    """Return vectors as an array of (count, 3)."""
    return np.stack([np.array(value[i]) for i in range(3)], axis=-1)


def _first_hits(scene: mi.Scene, origins: np.ndarray, along: np.ndarray, far: np.ndarray) -> dict:
    """Return `first_hit` of all rays."""

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
        environment = self.description.environment
        center, scale = self.description.center, self.description.scale
        self.world = World(
            make_scene(self.description),
            None if environment is None else Sky(environment),
            [Rectangle(light, center, scale) for light in self.description.area_lights],
            self.description.surface.specular is not None,
        )
        camera = self.description.camera
        origins, directions = (v.reshape(-1, 3) for v in camera.rays(*size))
        lengths = (camera.far - camera.near) / (directions @ np.array(camera.forward)) * scale
        origins = (origins - center) * scale
        self.start = _first_hits(self.world.scene, origins, directions, lengths)

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

        `kind`: "bounces" of the lights, "all" for those of lights, sky and area lights, "sky" and
        "area" for what comes directly from the sky and from area lights (`depth` is 1), or "open"
        for one bounce with nothing in the way and `depth` layers.
        `most`: how many receivers to trace, the others stay black; default: all of them.
        `means` are those of each bounce over the receivers, (bounces, 3).
        """
        valid = np.array(self.start["valid"]) > 0
        receivers = np.nonzero(valid)[0][:most]
        found = np.zeros((len(valid), depth, 3))
        chunk = max(1, LANES // samples)
        for begin in range(0, len(receivers), chunk):
            part = receivers[begin : begin + chunk]
            index = mi.UInt32(part.astype(np.uint32))
            start = {key: take(self.start[key], index) for key in RECEIVER}
            own = seed_of(*seed, begin)
            found[part] = _average(self.world, start, samples, own, depth, ESTIMATORS[kind])
            progress(len(part) / len(receivers))
        if not np.isfinite(found).all():
            raise FloatingPointError(f"{np.isnan(found).sum()} values are not numbers")
        image = _image(found[:, first - 1 :].sum(axis=1), self.size)
        return {"image": image, "means": found[valid].mean(axis=0)}


def _path_means(folder: Path, size: tuple[int, int], samples: int) -> dict[str, list[float]]:
    """Return the mean radiance of bounces 0, 1 and 2 by Mitsuba's own path integrator.

    Sky and area lights are Mitsuba's own emitters there. Bounce 0 is what it shows of all light on
    surfaces.
    """
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
    made = make_scene(scene, with_emitters=True)
    images = []
    for depth in (1, 2, 3, 4):
        integrator = mi.load_dict({"type": "path", "max_depth": depth, "rr_depth": 1000})
        image = mi.render(made, sensor=sensor, integrator=integrator, seed=1, spp=samples)
        images.append(np.array(image)[..., :3].mean(axis=(0, 1)))
    return {f"bounce{i}": (images[i + 1] - images[i]).tolist() for i in range(3)}


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
