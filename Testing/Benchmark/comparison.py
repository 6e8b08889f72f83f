#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against error in full: ``vtk-indirect compare`` with yardsticks, plots and a page.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/comparison.py SCENE...

Yardsticks of the same run are plain VTK, VTK's screen-space ambient occlusion, and where there is a
reference environment a path tracer at rising numbers of samples and HDR-FLIP. Finished rows are
kept in a journal, so that a run that was stopped goes on where it was.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import os
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from vtkindirect import cli, compare, frames, images, methods, references
from vtkindirect.compare import Result
from vtkindirect.errors import RenderError
from vtkindirect.progress import Progress
from vtkindirect.scene import Scene
from vtkindirect.sweep import Row, Sweep

import orbit
import page
import plot
import reference_environment
import ssao
from reference_environment import Denoiser, Flip, Traced

YARDSTICKS = (compare.NOTHING, compare.SSAO)
TRACER = "mitsuba"
LEFT_ALONE = "convergence"
"""The sweep file of pictures left alone: its plots have the time until a picture is there."""
DENOISED = "denoised"
"""Word in the label of a path tracer's row whose image is denoised."""
CURVES = {"one_bounce": "one bounce", "all_bounces": "all bounces"}
"""The path tracer's curves: it converges to R2 and to R3."""
LIGHTS_ALONE = {
    TRACER: "its rows trace VTK's lights only",
    "flicker": "the path's reference R1 knows VTK's lights only",
}
"""The reasons why something is not measured in a scene with an environment or area lights."""


@dataclass
class Comparison:
    """Work of a comparison and the place of its results."""

    sweep: Sweep
    directory: Path
    frames: int = compare.FRAMES
    stored: Path | None = None
    """Stored references: a directory of one file a scene, a scene's file, or None."""
    with_errors: bool = True
    """True if rows have errors beside the times."""
    size: tuple[int, int] | None = None
    python: Path | None = None
    """Python of the reference environment, or None."""
    flip: Flip | None = None
    left_out: dict[str, str] = field(default_factory=dict)
    """The reason why there is no HDR-FLIP, no path tracer or no denoiser, by its name."""
    denoiser: Denoiser | None = None

    @property
    def journal(self) -> Path:
        """One JSON object a line: finished rows, so that a run that was stopped goes on."""
        return self.directory / "rows.jsonl"


def commit(directory: Path) -> str:
    """The commit that a directory is checked out from; empty outside a checkout."""
    try:
        done = subprocess.run(
            ["git", "-C", str(directory), "rev-parse", "--short=12", "HEAD"],
            capture_output=True,
            text=True,
            check=False,
        )
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def machine() -> str:
    """The processor's cores that this process may use, and its model where Linux names one."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{cores} cores" + (f" of {models[0]}" if models else "")


def record_of(stored: Path | None) -> dict[str, Any]:
    """Return what is recorded of a stored reference; empty when there is no record."""
    path = stored.with_suffix(".json") if stored is not None else None
    if path is None or not path.exists():
        return {}
    return json.loads(path.read_text(encoding="utf-8"))


def _elsewhere(scenes: list[str]) -> str:
    return "the sweep has it in other scenes: " + ", ".join(scenes)


def difference_image(irradiance: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Return a picture of errors: red too bright, blue too dark, full colour at half the mean."""
    signed = (irradiance - reference).mean(axis=-1) / (0.5 * reference.mean())
    strength = np.clip(np.abs(signed), 0.0, 1.0)[..., np.newaxis]
    towards = np.where(signed[..., np.newaxis] > 0.0, (0.75, 0.05, 0.05), (0.05, 0.15, 0.75))
    return (1.0 - strength) + strength * towards


def shown(irradiance: np.ndarray, scale: float) -> np.ndarray:
    """Irradiance for the eye: scaled, clamped and encoded with gamma 2.2."""
    return np.clip(irradiance * scale, 0.0, 1.0) ** (1.0 / 2.2)


class Run(compare.Run):
    """One comparison of one scene; rows that the journal holds already are not run again."""

    def __init__(self, comparison: Comparison, scene: Scene) -> None:
        super().__init__(
            scene,
            comparison.frames,
            comparison.stored,
            comparison.size,
            with_errors=comparison.with_errors,
            makes=True,
        )
        self.comparison = comparison
        self.missing |= comparison.left_out
        self.record = record_of(self.stored)
        vtk = self.common.pop("vtk")
        self.common |= {
            "commit": commit(scene.path.parent),
            "vtk": vtk,
            "machine": machine(),
            "flip": comparison.flip.version if comparison.flip else "",
            **{
                f"noise_{name.lower()}": self.record.get(name, {}).get("noise_relmse")
                for name in references.STORED
            },
        }
        self._truth: orbit.Truth | Exception | None = None
        self._normal: np.ndarray | None = None
        self._normals: list[np.ndarray] = []
        if comparison.sweep.flicker and not self.with_errors:
            self.missing["flicker"] = self.missing["errors"]
        flickering = comparison.sweep.flicker_scenes
        if comparison.sweep.flicker and flickering is not None and scene.name not in flickering:
            self.missing["flicker"] = _elsewhere(flickering)
        if not references.has_r1(scene):
            traced = comparison.python is not None
            asked = {
                TRACER: traced and any(comparison.sweep.path_tracer.values()),
                "flicker": comparison.sweep.flicker,
            }
            self.missing |= {name: why for name, why in LIGHTS_ALONE.items() if asked[name]}

    def _key(self, row: Row) -> str:
        identity = {k: v for k, v in self.common.items() if k != "schema"}
        identity["flicker"] = self._flickers(row)
        identity["moving"] = row.label in self.comparison.sweep.moving
        identity["with_errors"] = self.with_errors
        return json.dumps([identity, row.key()], sort_keys=True)

    def finished(self) -> dict[str, Result]:
        """Rows of earlier runs by key, failures left out so that they are tried again."""
        found: dict[str, Result] = {}
        if self.comparison.journal.exists():
            for line in self.comparison.journal.read_text(encoding="utf-8").splitlines():
                try:
                    entry = json.loads(line)
                except json.JSONDecodeError:
                    continue  # the last line of a run that was stopped while writing
                if not entry["result"].get("error"):
                    found[entry["key"]] = entry["result"]
        return found

    def _record(self, key: str, result: Result) -> None:
        with self.comparison.journal.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps({"key": key, "result": result}) + "\n")

    def references(self) -> references.References:
        """The same, and their pictures."""
        first = self._references is None
        found = super().references()
        if first and found.main is not None:
            scale = 0.5 / float(found.images[found.main].mean())
            for name, image in found.images.items():
                self._write(name, shown(image, scale))
        return found

    def truth(self) -> orbit.Truth:
        """The reference along the camera's path, made on first use like `references`."""
        if self._truth is None:
            try:
                self._truth = orbit.truth(self.scene, self.size)
            except Exception as error:
                self._truth = error
        if isinstance(self._truth, Exception):
            raise self._truth
        return self._truth

    def _write(self, label: str, picture: np.ndarray) -> str:
        safe = "".join(c if c.isalnum() or c in "-=._" else "_" for c in label)
        path = self.comparison.directory / f"{self.scene.name}-{safe}.png"
        images.write_png(path, picture)
        return path.name

    def judge(self, seen: references.Buffers) -> Result:
        """Errors of a frame's buffers against each reference, and HDR-FLIP to the main one."""
        result = super().judge(seen)
        if self.comparison.flip is not None:
            for name, pair in self.references().pairs(seen):
                if name == self.references().main:
                    result[f"flip_{name.lower()}"] = self.comparison.flip.error(*pair)
        return result

    def _pictures(self, row: Row, seen: references.Buffers) -> Result:
        main = self.references().main
        if main is None:
            return {}
        image, reference, _ = dict(self.references().pairs(seen))[main]
        irradiance = seen[references.ALL_LIGHT]
        return {
            "image": self._write(row.label, shown(irradiance, 0.5 / float(reference.mean()))),
            "difference": self._write(
                f"{row.label}-difference", difference_image(image, reference)
            ),
        }

    def ssao(self, row: Row) -> Result:
        """VTK's screen-space ambient occlusion; it darkens the light that is there, no more."""
        with ssao.used(self.scene.renderer):
            return self.timed(Row(row.label, "off")) | {"indirect_ms": None}

    def method(self, row: Row) -> Result:
        """Times, errors and pictures of a row."""
        result = super().method(row)
        if row.label in self.comparison.sweep.moving:
            result["moving_ms"] = frames.moving(
                self.scene, self.scene.render_window, self.comparison.frames
            )
        if row.method != "off" and self._flickers(row) and "flicker" not in self.missing:
            result.update(self._flicker(row))
        return result

    def judged(self, row: Row, seen: references.Buffers) -> Result:
        """Errors of a frame and its pictures."""
        return self.judge(seen) | self._pictures(row, seen)

    def _flickers(self, row: Row) -> bool:
        """Return whether a row is measured along the camera's path, too."""
        wanted = self.comparison.sweep.flicker
        return wanted if isinstance(wanted, bool) else row.label in wanted

    def _flicker(self, row: Row) -> Result:
        truth = self.truth()
        methods.enable(self.scene.renderer, row.method, row.sampler, **row.settings)
        return orbit.judge(orbit.frames(self.scene, truth.factor), truth)

    def attempt(self, row: Row, work: Callable[[], Result]) -> Result:
        """The same, kept in the journal."""
        result = super().attempt(row, work)
        self._record(self._key(row), result)
        return result

    def traced_rows(self) -> list[Row]:
        """Rows of the path tracer, or none, with the reason in `missing`."""
        if self.comparison.python is None or TRACER in self.missing:
            return []
        traced = self.comparison.sweep.path_traced_scenes
        if traced is not None and self.scene.name not in traced:
            self.missing[TRACER] = _elsewhere(traced)
            return []
        bounces = {"one_bounce": 1, "all_bounces": self.record.get("R3", {}).get("bounces")}
        rows = []
        for curve, samples in self.comparison.sweep.path_tracer.items():
            if samples and bounces[curve] is None:
                self.missing[f"{TRACER} {CURVES[curve]}"] = (
                    "there is no record of a stored R3 that says how many bounces to follow"
                )
                continue
            rows += [
                Row(
                    f"{TRACER} {CURVES[curve]} {number} spp",
                    TRACER,
                    settings={"samples": number, "bounces": bounces[curve]},
                )
                for number in samples
            ]
        return rows

    def _names_for_flicker(self, row: Row) -> bool:
        """True where the sweep names a row of the path tracer: each frame of a path is traced."""
        named = self.comparison.sweep.flicker
        return not isinstance(named, bool) and row.label in named and "flicker" not in self.missing

    def _traced(self, row: Row, traced: Traced, path: list[np.ndarray]) -> Result:
        times = [1000.0 * seconds for seconds in traced.seconds]
        result: Result = {
            "frames": len(times),
            "indirect_ms": statistics.median(times),
            "indirect_p95_ms": frames.percentile_95(times),
        }
        result.update(self.judged(row, {references.ALL_LIGHT: traced.image}))
        if path and self._names_for_flicker(row):
            truth = self.truth()
            result.update(orbit.judge([orbit.thin(image, truth.factor) for image in path], truth))
        return result

    def _denoised(self, row: Row, traced: Traced, path: list[np.ndarray]) -> Result:
        """Times and errors of a traced image after denoising, guided by the normals of its pixels."""
        denoiser = self.comparison.denoiser
        assert denoiser is not None
        if self._normal is None:
            self._normal = references.eye(self.scene)[1]
        image, seconds = denoiser.denoised(traced.image, self._normal)
        times = [second + seconds for second in traced.seconds]
        if path and self._names_for_flicker(row):
            self._normals = self._normals or orbit.normals(self.scene)
            path = [denoiser.denoised(*pair, repeats=1)[0] for pair in zip(path, self._normals)]
        return self._traced(row, Traced(traced.name, image, times), path)

    def _trace(self, rows: list[Row], step: Callable[[Row], None]) -> Iterator[list[Result]]:
        """Results of each of the path tracer's rows, raw and denoised, by one process for all.

        Frames along the camera's path come first, those of one azimuth together: they share a process.
        """
        wanted = [
            {"name": row.label, "samples": row.settings["samples"], "depth": row.settings["bounces"]}
            for row in rows
        ]
        turning = [
            entry
            for row, entry in zip(rows, wanted)
            if self._names_for_flicker(row) or self._names_for_flicker(denoised_row(row))
        ]
        turned = [{**entry, "azimuth": angle} for angle in orbit.ANGLES for entry in turning]
        numbered = [{**entry, "name": str(i)} for i, entry in enumerate(turned + wanted)]
        failed: Exception | None = None
        found = reference_environment.trace(
            self.comparison.python, self.scene.path, self.size, numbered
        )
        paths: dict[str, list[np.ndarray]] = {}
        try:
            for entry in turned:
                paths.setdefault(entry["name"], []).append(next(found).image)
        except Exception as error:
            failed = _reason(error)
        for row in rows:
            step(row)
            traced: Traced | None = None
            path = paths.get(row.label, [])
            if failed is None:
                try:
                    traced = next(found)
                except Exception as error:
                    failed = _reason(error)

            def work() -> Result:
                if traced is None:
                    assert failed is not None
                    raise failed
                return self._traced(row, traced, path)

            results = [self.attempt(row, work)]
            if self.comparison.denoiser is not None and traced is not None:
                clean = denoised_row(row)
                results.append(self.attempt(clean, lambda: self._denoised(clean, traced, path)))
            yield results
        found.close()

    def run(self, rows: list[Row], step: Callable[[str], None]) -> list[Result]:
        """All rows of the scene, yardsticks first, the path tracer last.

        `step` is called before each.
        """
        finished = self.finished()
        frames.open_window(self.scene, self.size)
        results = []
        kinds = {compare.NOTHING: self.nothing, compare.SSAO: self.ssao}
        for row in (*(Row(name, name) for name in YARDSTICKS), *rows):
            step(f"{self.scene.name}: {row.label}")
            work = kinds.get(row.method, self.method)
            known = finished.get(self._key(row))
            results.append(known or self.attempt(row, lambda row=row, work=work: work(row)))
        traced = {row.label: [row] for row in self.traced_rows()}
        if self.comparison.denoiser is not None:
            for some in traced.values():
                some.append(denoised_row(some[0]))
        made = self._trace(
            [some[0] for some in traced.values() if not all(self._key(row) in finished for row in some)],
            lambda row: step(f"{self.scene.name}: {row.label}"),
        )
        for some in traced.values():
            known = [finished.get(self._key(row)) for row in some]
            results += known if all(known) else next(made)
        compare.add_differences(results)
        for result in results:
            result["missing"] = self.missing
        self.scene.render_window.Finalize()
        return results


def _reason(error: Exception) -> Exception:
    """The error itself, or the one that a path tracer which ended too early stands for."""
    if isinstance(error, StopIteration):
        return RenderError("the path tracer ended too early")
    return error


def denoised_row(row: Row) -> Row:
    """The row of a path tracer's denoised image."""
    label, samples, unit = row.label.rsplit(" ", 2)
    return Row(
        f"{label} {DENOISED} {samples} {unit}",
        row.method,
        settings={**row.settings, DENOISED: True},
    )


def _outside(comparison: Comparison, given: str | None) -> None:
    """Find the reference environment, or note why the comparison goes without."""
    names = ("HDR-FLIP", TRACER, "the denoiser")
    try:
        comparison.python = reference_environment.find_python(given)
    except reference_environment.LeftOut as reason:
        comparison.left_out = dict.fromkeys(names, str(reason))
        return
    try:
        comparison.flip = reference_environment.Flip(comparison.python)
    except reference_environment.LeftOut as reason:
        comparison.left_out["HDR-FLIP"] = str(reason)
    if any(comparison.sweep.path_tracer.values()):
        try:
            comparison.denoiser = Denoiser(comparison.python)
        except reference_environment.LeftOut as reason:
            comparison.left_out["the denoiser"] = str(reason)


def run(arguments: argparse.Namespace, load: Callable[[str], Scene]) -> None:
    """Run the comparison, print the paths of its page and its table."""
    what = compare.sweep_of(arguments)
    what = dataclasses.replace(what, flicker=arguments.flicker or what.flicker)
    plot.require_plots()
    directory, stored = compare.check_inputs(arguments)
    comparison = Comparison(
        sweep=what,
        directory=directory,
        frames=max(2, arguments.frames),
        stored=stored,
        with_errors=compare.wants_errors(arguments),
        size=arguments.size,
    )
    _outside(comparison, arguments.reference_python)
    rows = len(what.rows) + len(YARDSTICKS)
    if comparison.python is not None:
        each = 1 if comparison.denoiser is None else 2
        rows += each * sum(map(len, what.path_tracer.values()))
    results: list[Result] = []
    try:
        with Progress("comparing", rows * len(arguments.scenes)) as bar:
            for name in arguments.scenes:
                results += Run(comparison, load(name)).run(what.rows, bar.step)
    finally:
        for worker in (comparison.flip, comparison.denoiser):
            if worker is not None:
                worker.close()
    written = compare.write(results, directory)
    whole = Path(arguments.sweep or "").stem == LEFT_ALONE
    compare.say(results, [*written, *page.write(results, directory, whole)])


if __name__ == "__main__":
    sys.exit(cli.main(["compare", *sys.argv[1:]], run))
