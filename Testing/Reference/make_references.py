#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the references R2, R3, S1 to S3, A1, A3 of scenes: path traced irradiance, with its error.

    make_references.py [SCENE...] [--quick] [--force] [--list]

SCENE is a name in Testing/Scenes; default: all of `SCENES`. A reference that is current is left
alone, and work that was interrupted goes on where it stopped. Documentation/reference.md explains.
"""

from __future__ import annotations

import argparse
import datetime
import hashlib
import json
import math
import platform
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

import estimates
import exporter
import provenance
import tools
from description import Description
from estimates import Estimate

DEMOS = ("cornell_box", "room_fire", "apartment_living", "frog", "protein", "brain")

# Small procedural scenes, each of one thing that is hard for some method.
HARD = (
    "contact_corner",
    "grazing_light",
    "two_rooms",
    "folded_sheet",
    "many_objects",
    "low_sun",
)

# Scenes under a sky: things as they are, and four whose answer is known.
SKY = ("sky_machine", "sky_statue", "sky_terrain", "sky_courtyard")
SKY_KNOWN = ("sky_plane", "sky_wall", "sky_disk", "sky_groove")

# Scenes under a sky that can be told as spheres: atoms, particles, and two of meshes.
SKY_SPHERES = ("sky_protein", "sky_particles", "sky_frog", "sky_brain")

# Scenes under area lights.
AREA = ("area_cornell", "area_machine", "area_apartment")

# Scenes whose senders are specular.
SPECULAR = ("ring_caustic",)

SCENES = (*DEMOS, *HARD, *SPECULAR, *SKY, *SKY_KNOWN, *SKY_SPHERES, *AREA)


@dataclass(frozen=True)
class Settings:
    """Size and quality. `noise`: the relMSE that the noise of R2 may make, `deep_noise` that
    of R3, S3 and A3, `emitted_noise` S1's and A1's, for which 1e-4 is 1 % of a typical pixel.
    `emitted_error`: the root mean square error over the mean that S1 and A1 may have.

    Samples are those of one batch; there are `least` to `most` batches. `tail`: the part of the
    light that bounces beyond the last may hold; `deepest` caps them where that is out of reach.
    """

    width: int = 256
    samples: int = 1024
    deep_samples: int = 256
    least: int = 4
    most: int = 16
    noise: float = 3e-4
    deep_noise: float = 1e-3
    emitted_noise: float = 1e-4
    emitted_error: float = 0.01
    pilot_samples: int = 16
    tail: float = 1e-3
    deepest: int = 32


QUICK = Settings(width=96, samples=256, deep_samples=64, least=2, most=2, pilot_samples=16)


def settings_of(name: str) -> Settings:
    """The settings of a scene's stored reference; simple ones need fewer pixels to be judged."""
    if name in SKY_SPHERES:  # millions of triangles, and a light that makes little noise
        return Settings(width=128, samples=256, deep_samples=64)
    if name == "low_sun":  # few paths meet what the sun lights
        return Settings(width=128, most=64)
    return Settings(width=128) if name in (*HARD, *SPECULAR, *SKY_KNOWN) else Settings()


class Meter:
    """A progress bar for work whose plan may grow on the way; there is none but on a terminal."""

    def __init__(self, label: str) -> None:
        self._bar = tqdm(desc=label, total=0.0, leave=False, disable=None)

    def plan(self, cost: float) -> None:
        """Add work that is to be done."""
        self._bar.total = (self._bar.total or 0.0) + cost

    def advance(self, cost: float) -> None:
        """Say that a part of the planned work is done."""
        self._bar.update(cost)

    def clear(self) -> None:
        """Remove the bar."""
        self._bar.close()


@dataclass(frozen=True)
class Part:
    """Purpose of batches: their label, the tracer's kind, and the first bounce."""

    label: str
    kind: str
    first: int = 1


class Work:
    """A scene being traced. A folder, named by all that it depends on, holds the finished work."""

    def __init__(self, path: Path, settings: Settings, meter: Meter) -> None:
        self.settings = settings
        self.meter = meter
        self.scene = tools.describe(path)
        width, height = self.scene.size
        self.size = (settings.width, max(1, round(settings.width * height / width)))
        self.name = path.stem
        self.scene_hash = provenance.scene_hash(path)
        self.data_hashes = provenance.data_hashes(path)
        parts = (self.scene_hash, self.data_hashes, self.size, provenance.METHOD)
        key = hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:16]
        self.folder = tools.SOURCE / "build" / "reference-work" / f"{self.name}-{key}"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.scene.save(self.folder)
        self.versions: dict[str, str] = {}
        self.seconds = 0.0
        self._met: set[str] = set()

    def trace(self, batches: list[dict[str, Any]]) -> list[dict[str, np.ndarray]]:
        """Return batches of one kind, tracing those that are not there yet."""
        wanted = [batch for batch in batches if not (self.folder / batch["file"]).exists()]
        for batch in batches:
            if batch not in wanted and batch["file"] not in self._met:
                self.meter.advance(batch["samples"] * batch["depth"])
            self._met.add(batch["file"])
        surfaces = self.folder / "surfaces.npz"
        versions = self.folder / "versions.json"
        if wanted or not surfaces.exists() or not versions.exists():
            job = {"size": list(self.size), "surfaces": surfaces.name, "batches": wanted}
            each = wanted[0]["samples"] * wanted[0]["depth"] if wanted else 0
            found = tools.trace(
                self.folder, job, lambda part: self.meter.advance(part * each), niceness=10
            )
            versions.write_text(json.dumps(found))
        self.versions = json.loads(versions.read_text())
        arrays = []
        for batch in batches:
            with np.load(self.folder / batch["file"]) as loaded:
                arrays.append(dict(loaded))
        self.seconds += sum(float(found["seconds"]) for found in arrays)
        return arrays

    def batch(self, part: Part, index: int, samples: int, depth: int) -> dict[str, Any]:
        """Return the description of a batch; its seed depends on scene, label and index only."""
        label, kind, first = part.label, part.kind, part.first
        return {
            "file": f"{label}-{samples}-{depth}-{index}.npz",
            "kind": kind,
            "samples": samples,
            "depth": depth,
            "first": first,
            "seed": [self.name, label, index],
        }

    @property
    def surfaces(self) -> dict[str, np.ndarray]:
        """Return what the eye sees; see `tracer.Tracer.surfaces`."""
        with np.load(self.folder / "surfaces.npz") as loaded:
            return dict(loaded)

    def estimate(
        self,
        part: Part,
        samples: int,
        depth: int,
        limit: float,
        of: Estimate | None = None,
        error: float = math.inf,
    ) -> tuple[Estimate, np.ndarray, list[list[Any]]]:
        """Trace batches until the noise is at most `limit`, and the error over the mean `error`.

        Returns the estimate, the mean light of each bounce and the seeds. `of`: what the estimate
        will be added to, and its noise compared with.
        """
        batches: list[dict[str, Any]] = []
        while True:
            count = len(batches)
            more = self.settings.least if count == 0 else 2
            batches += [
                self.batch(part, index, samples, depth)
                for index in range(count, min(count + more, self.settings.most))
            ]
            if count:
                self.meter.plan((len(batches) - count) * samples * depth)
            found = self.trace(batches)
            valid = self.surfaces["valid"] > 0
            result = estimates.combine([arrays["image"] for arrays in found], valid)
            whole = result if of is None else of + result
            done = len(batches) >= self.settings.most
            fine = whole.noise(valid) <= limit and whole.rmse_over_mean(valid) <= error
            if done or fine:
                means = np.mean([arrays["means"] for arrays in found], axis=0)
                return result, means, [batch["seed"] for batch in batches]
            for arrays in found:
                self.seconds -= float(arrays["seconds"])


def _summary(estimate: Estimate, valid: np.ndarray) -> dict[str, Any]:
    return {
        "mean": estimate.mean().tolist(),
        "standard_error_of_mean": estimate.error_of_mean().tolist(),
        "noise_relmse": estimate.noise(valid),
    }


@dataclass(frozen=True)
class Pair:
    """The two references of some light: its first part, and all of it.

    `pilot` finds how many bounces matter. `one` is traced well, `rest` is what is added to it.
    `emitted`: `one` is what comes directly from emitters, and `rest` counts all bounces of all light.
    """

    names: tuple[str, str]
    pilot: Part
    one: Part
    rest: Part
    emitted: bool = True


LIGHTS = Pair(
    ("R2", "R3"),
    Part("pilot", "bounces"),
    Part("one", "bounces"),
    Part("rest", "bounces", first=2),
    emitted=False,
)
SKY_LIGHT = Pair(
    ("S1", "S3"), Part("sky-pilot", "all"), Part("sky", "sky"), Part("sky-rest", "all")
)
FIRST_BOUNCE = Part("sky-bounce", "all")
"""S2: what the first bounce of the sky's light adds to S1, of `SKY_SPHERES`."""
AREA_LIGHT = Pair(
    ("A1", "A3"), Part("area-pilot", "all"), Part("area", "area"), Part("area-rest", "all")
)
PAIRS = (LIGHTS, SKY_LIGHT, AREA_LIGHT)


def pairs_of(scene: Description) -> list[Pair]:
    """Return the references of a scene. Without light of a kind there is nothing in them."""
    wanted = [
        (LIGHTS, scene.lights),
        (SKY_LIGHT, scene.environment is not None),
        (AREA_LIGHT, scene.area_lights),
    ]
    return [pair for pair, there in wanted if there] or [LIGHTS]


def trace_one(work: Work, pair: Pair) -> tuple[Estimate, dict[str, Any]]:
    """Trace the first of a pair's references; returns it and what the record says of it."""
    settings = work.settings
    work.meter.plan(settings.least * settings.samples)
    limit = settings.emitted_noise if pair.emitted else settings.noise
    error = settings.emitted_error if pair.emitted else math.inf
    one, _, seeds = work.estimate(pair.one, settings.samples, 1, limit, error=error)
    valid = work.surfaces["valid"] > 0
    record = {
        "samples": settings.samples * len(seeds),
        "batches": len(seeds),
        "seeds": seeds,
        "bounces": pair.rest.first - 1,
        **_summary(one, valid),
    }
    if pair.emitted:
        record["rmse_over_mean"] = one.rmse_over_mean(valid)
    return one, record


def trace_rest(work: Work, pair: Pair, known: Estimate) -> tuple[Estimate, dict[str, Any]]:
    """Trace what the second of a pair's references adds to `known`; returns as `trace_one`."""
    settings, meter = work.settings, work.meter
    meter.plan(settings.pilot_samples * settings.deepest)
    first = work.batch(pair.pilot, 0, settings.pilot_samples, settings.deepest)
    pilot = work.trace([first])[0]["means"].mean(axis=1)
    depth = estimates.depth_for(pilot, settings.tail)
    meter.plan(settings.least * settings.deep_samples * depth)
    rest, means, seeds = work.estimate(
        pair.rest, settings.deep_samples, depth, settings.deep_noise, known
    )
    everything = known + rest
    whole = means.mean(axis=1)
    of = "of_bounces" if pair.emitted else "beyond_first_bounce"
    return everything, {
        f"samples_{of}": settings.deep_samples * len(seeds),
        f"batches_{of}": len(seeds),
        "seeds": seeds,
        "bounces": depth,
        "capped": depth == settings.deepest,
        "left_out_by_depth": estimates.tail(whole, depth),
        "fraction_of_bounce": (whole / whole.sum()).tolist() if whole.sum() else [],
        **_summary(everything, work.surfaces["valid"] > 0),
    }


def trace_bounce(work: Work, known: Estimate) -> tuple[Estimate, dict[str, Any]]:
    """Trace S2: one diffuse bounce of all light, added to `known`; returns as `trace_one`."""
    settings = work.settings
    work.meter.plan(settings.least * settings.samples)
    found, _, seeds = work.estimate(
        FIRST_BOUNCE, settings.samples, 1, settings.deep_noise, known
    )
    return found, {
        "samples": settings.samples * len(seeds),
        "batches": len(seeds),
        "seeds": seeds,
        "bounces": 1,
        **_summary(found, work.surfaces["valid"] > 0),
    }


def trace_pairs(work: Work) -> tuple[dict[str, Estimate], dict[str, dict[str, Any]]]:
    """Trace all references of a scene; returns them and their records, by their names.

    Each of several kinds of emitters has its first reference, and the last kind has all light.
    """
    found: dict[str, Estimate] = {}
    records: dict[str, dict[str, Any]] = {}
    emitted: Estimate | None = None
    pairs = pairs_of(work.scene)
    for pair in pairs:
        first, second = pair.names
        one, records[first] = trace_one(work, pair)
        found[first] = one
        if pair.emitted:
            emitted = one if emitted is None else emitted + one
        if pair is SKY_LIGHT and work.name in SKY_SPHERES:
            found["S2"], records["S2"] = trace_bounce(work, one)
        if pair.emitted and pair is not pairs[-1]:
            continue
        found[second], records[second] = trace_rest(work, pair, emitted or one)
    return found, records


def _vtk_image(values: np.ndarray) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    height, width, components = values.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(values.reshape(-1, components), dtype=np.float32)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def write_image(path: Path, picture: np.ndarray, layers: dict[str, np.ndarray]) -> None:
    """Write an EXR file of halves, ZIP compressed."""
    import vtkindirect

    writer = vtkindirect.vtkOpenEXRWriter()
    writer.SetPixelTypeToHalf()
    writer.SetCompressionToZIP()
    writer.SetInputData(_vtk_image(picture))
    for name, values in layers.items():
        writer.AddLayer(name, _vtk_image(values))
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise tools.ToolError(f"{path}: cannot be written")


def _geometry(scene: Description) -> dict[str, Any]:
    points = scene.surface.points
    return {
        "triangles": len(scene.surface.faces),
        "area": scene.surface.area,
        "bounds": [points.min(axis=0).tolist(), points.max(axis=0).tolist()],
        "left_out": scene.left_out,
    }


def make(path: Path, settings: Settings, directory: Path) -> dict[str, Any]:
    """Make the reference of a scene file; returns its provenance."""
    import vtkindirect
    from vtkmodules.vtkCommonCore import vtkVersion

    began = time.perf_counter()
    meter = Meter(path.stem)
    work = Work(path, settings, meter)
    found, records = trace_pairs(work)
    meter.clear()

    seen = work.surfaces
    valid = seen["valid"] > 0
    mask = valid[..., None]
    shown = list(found.values())[-1]
    picture = seen["albedo"] * (seen["direct"] + shown.image)
    image, record = provenance.paths(path, directory)
    layers: dict[str, np.ndarray] = {}
    for name, estimate in found.items():
        layers[name] = estimate.image
        layers[f"{name}_error"] = np.sqrt((estimate.error**2).mean(axis=-1, keepdims=True))
    layers.update(
        {"albedo": seen["albedo"], "direct": seen["direct"], "depth": seen["depth"][..., None]}
    )
    write_image(image, np.concatenate([picture * mask, mask], axis=-1), layers)
    values: dict[str, Any] = {
        "schema": provenance.SCHEMA,
        "method": provenance.METHOD,
        "scene": {"name": work.name, "sha256": work.scene_hash},
        "data": work.data_hashes,
        "image": {"file": image.name, "size": list(work.size)},
        "settings": asdict(settings),
        "receivers": int(valid.sum()),
        **records,
        "geometry": _geometry(work.scene),
        "versions": {
            **work.versions,
            "vtk": vtkVersion.GetVTKVersion(),
            "vtkindirect": vtkindirect.__version__,
            "python": platform.python_version(),
        },
        "seconds": {"tracing": round(work.seconds, 1)},
        "made": datetime.date.today().isoformat(),
    }
    values["seconds"]["all"] = round(time.perf_counter() - began, 1)
    values["image"]["sha256"] = provenance.file_hash(image)
    record.write_text(json.dumps(values, indent=1) + "\n")
    return values


def rows(values: dict[str, Any]) -> list[str]:
    """Return a line for each pair of references that a record holds."""
    lines = []
    size = "x".join(map(str, values["image"]["size"]))
    for names in (pair.names for pair in PAIRS):
        if names[1] not in values:
            continue
        one, every = (values[name] for name in names)
        lines.append(
            f"{values['scene']['name']:20} {'+'.join(names)} {size:>9} "
            f"{np.mean(one['mean']):9.5f} {one['noise_relmse']:9.1e} "
            f"{np.mean(every['mean']):9.5f} {every['noise_relmse']:9.1e} {every['bounces']:7d} "
            f"{every['left_out_by_depth']:9.1e} {values['seconds']['tracing']:7.1f}"
        )
    return lines


HEADER = (
    f"{'scene':20} {'what':5} {'size':>9} {'1st mean':>9} {'noise':>9} {'all mean':>9} "
    f"{'noise':>9} {'bounces':>7} {'left out':>9} {'s':>7}"
)


def main() -> int:
    """Make what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=list(SCENES), metavar="SCENE")
    parser.add_argument("--quick", action="store_true", help="small and noisy, into --output")
    parser.add_argument("--force", action="store_true", help="also those that are current")
    parser.add_argument("--list", action="store_true", help="say which are current and exit")
    parser.add_argument("--output", type=Path, help="default: Testing/Reference/data")
    options = parser.parse_args()
    directory = options.output or provenance.DATA
    if options.quick and options.output is None:
        directory = tools.SOURCE / "build" / "reference-quick"
    for name in options.scenes:
        if not provenance.scene_file(name).is_file():
            return tools.fail(tools.ToolError(f"{provenance.scene_file(name)}: no such scene"))
    if options.list:
        for name in options.scenes:
            print(f"{name:20} {provenance.why_stale(name, directory) or 'current'}")
        return 0
    try:
        tools.tracer_python()
        directory.mkdir(parents=True, exist_ok=True)
        print(HEADER)
        for name in options.scenes:
            if options.force or provenance.why_stale(name, directory) is not None:
                settings = QUICK if options.quick else settings_of(name)
                make(provenance.scene_file(name), settings, directory)
            print("\n".join(rows(provenance.read(name, directory))), flush=True)
    except (tools.ToolError, exporter.ExportError) as error:
        return tools.fail(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
