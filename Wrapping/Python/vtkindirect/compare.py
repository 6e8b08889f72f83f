# SPDX-License-Identifier: BSD-3-Clause
"""Speed against error: methods on scenes, each row with its times and its errors.

For every scene the rows of a sweep are rendered with nothing reused between frames; times are
medians over frames after one to warm up, by wall clock with the pipeline drained around each stage.
Errors are those of the very image that was timed. In the same run there are yardsticks: plain VTK,
whose indirect light is none, VTK's screen-space ambient occlusion, and where there is a reference
environment a path tracer at rising numbers of samples. A row that fails is a row with its error,
and the run goes on.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import statistics
import subprocess
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from vtkindirect import frames, images, methods, orbit, reference_environment, references
from vtkindirect.errors import IndirectError, RenderError
from vtkindirect.frames import Job
from vtkindirect.metrics import MetricError
from vtkindirect.reference_environment import Flip, Traced
from vtkindirect.references import References
from vtkindirect.scene import Scene
from vtkindirect.sweep import Row, Sweep

SCHEMA = "vtkindirect.comparison/1"
FRAMES = 10
STAGES = (
    "rsm",
    "geometry",
    "lights",
    "visibility",
    "inject",
    "bounces",
    "estimate",
    "upsample",
    "composite",
)
METRICS = ("nrmse", "relmse", "relmse_trimmed", "bias", "p99", "shape", "leak")
YARDSTICKS = ("vtk", "ssao")
TRACER = "mitsuba"
CURVES = {"one_bounce": "one bounce", "all_bounces": "all bounces"}
"""The path tracer's curves: it converges to R2 and to R3."""

Result = dict[str, Any]


@dataclass
class Comparison:
    """What to run and where the results go."""

    sweep: Sweep
    directory: Path
    frames: int = FRAMES
    stored: Path | None = None
    """Stored references (R2, R3): a directory of one file a scene, a scene's file, or None."""
    size: tuple[int, int] | None = None
    python: Path | None = None
    """Python of the reference environment, or None."""
    flip: Flip | None = None
    left_out: dict[str, str] = field(default_factory=dict)
    """Why there is no HDR-FLIP or no path tracer, by its name."""

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
            timeout=10,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def _fingerprint(path: Path | None) -> str:
    if path is None or not path.exists():
        return ""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:12]


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split())
    # What is not one of the package's own errors is not written to be read alone.
    readable = isinstance(error, (IndirectError, MetricError))
    return text if readable else f"{type(error).__name__}: {text}"


def record_of(stored: Path | None) -> dict[str, Any]:
    """What is recorded of a stored reference; empty when there is no record."""
    path = stored.with_suffix(".json") if stored is not None else None
    if path is None or not path.exists():
        return {}
    return json.loads(path.read_text(encoding="utf-8"))


def _render(scene: Scene, row: Row, count: int) -> dict[str, Any]:
    """Time a method; the report of its frames."""
    methods.disable(scene.renderer)
    settings = dict(row.settings)
    if row.method != "off":
        settings.setdefault("Caching", False)
    return frames.render(scene, scene.render_window, Job(row.method, row.sampler, settings, count))


def _stage_times(result: Result, report: dict[str, Any]) -> None:
    stages = report.get("stages", {})
    for stage in dict.fromkeys((*STAGES, *(name for name in stages if name != "delegate"))):
        times = stages.get(stage, {"median_ms": 0.0, "p95_ms": 0.0})
        result[f"{stage}_ms"] = times["median_ms"]
        result[f"{stage}_p95_ms"] = times["p95_ms"]
    result["indirect_ms"] = report.get("indirect_ms")
    result["frame_ms"] = report["wall_ms"]["median_ms"]
    result["frame_p95_ms"] = report["wall_ms"]["p95_ms"]
    result["virtual_lights"] = report.get("virtual_lights")
    result["bytes"] = report.get("bytes")
    result["shader_hash"] = report.get("shader_hash", "")
    result["gl"] = report.get("gl", {}).get("renderer", "")
    result["version"] = report.get("version", "")


def difference_image(irradiance: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Where an image is too bright (red) and too dark (blue); full colour at half the mean."""
    signed = (irradiance - reference).mean(axis=-1) / (0.5 * reference.mean())
    strength = np.clip(np.abs(signed), 0.0, 1.0)[..., np.newaxis]
    towards = np.where(signed[..., np.newaxis] > 0.0, (0.75, 0.05, 0.05), (0.05, 0.15, 0.75))
    return (1.0 - strength) + strength * towards


def shown(irradiance: np.ndarray, scale: float) -> np.ndarray:
    """Irradiance for the eye: scaled, clamped and encoded with gamma 2.2."""
    return np.clip(irradiance * scale, 0.0, 1.0) ** (1.0 / 2.2)


class Run:
    """One comparison of one scene; rows that the journal holds already are not run again."""

    def __init__(self, comparison: Comparison, scene: Scene) -> None:
        self.comparison = comparison
        self.scene = scene
        stored = comparison.stored
        if stored is not None and stored.is_dir():
            stored = stored / f"{scene.name}.exr"
        self.stored = stored
        self.size = comparison.size or references.natural_size(self.stored) or scene.size
        self.missing = {
            **references.stored_images(self.stored, self.size)[1],
            **comparison.left_out,
        }
        self.record = record_of(self.stored)
        self.common: Result = {
            "schema": SCHEMA,
            "scene": scene.name,
            "width": self.size[0],
            "height": self.size[1],
            "frames": comparison.frames,
            "scene_hash": _fingerprint(scene.path),
            "reference_hash": _fingerprint(self.stored),
            "commit": commit(scene.path.parent),
            "vtk": vtkVersion.GetVTKVersion(),
            "flip": comparison.flip.version if comparison.flip else "",
            **{
                f"noise_{name.lower()}": self.record.get(name, {}).get("noise_relmse")
                for name in references.STORED
            },
        }
        self._references: References | Exception | None = None
        self._truth: orbit.Truth | Exception | None = None

    def _key(self, row: Row) -> str:
        identity = {k: v for k, v in self.common.items() if k != "schema"}
        identity["flicker"] = self.comparison.sweep.flicker
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

    def references(self) -> References:
        """References of the scene, made on first use; what made them fail once fails again."""
        if self._references is None:
            try:
                self._references = references.collect(self.scene, self.size, self.stored)
                scale = 0.5 / float(self._references.images["R1"].mean())
                for name, image in self._references.images.items():
                    self._write(name, shown(image, scale))
            except Exception as error:
                self._references = error
        if isinstance(self._references, Exception):
            raise self._references
        return self._references

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

    def _judge(self, irradiance: np.ndarray) -> Result:
        """Errors of an image against each reference."""
        result: Result = {}
        for name, errors in self.references().errors(irradiance).items():
            values = errors.as_dict()
            result.update({f"{metric}_{name.lower()}": values[metric] for metric in METRICS})
        if self.comparison.flip is not None:
            for name, pair in self.references().pairs(irradiance):
                result[f"flip_{name.lower()}"] = self.comparison.flip.error(*pair)
        return result

    def _pictures(self, row: Row, irradiance: np.ndarray) -> Result:
        first = self.references().images["R1"]
        return {
            "image": self._write(row.label, shown(irradiance, 0.5 / float(first.mean()))),
            "difference": self._write(
                f"{row.label}-difference", difference_image(irradiance, first)
            ),
        }

    def _yardstick(self, row: Row) -> Result:
        renderer = self.scene.renderer
        if row.method == "ssao":
            low_high = self.scene.bounds
            diagonal = sum((low_high[2 * i + 1] - low_high[2 * i]) ** 2 for i in range(3)) ** 0.5
            # Usual choices for these: a tenth and a thousandth of the scene.
            renderer.SetSSAORadius(0.1 * diagonal)
            renderer.SetSSAOBias(0.001 * diagonal)
            renderer.SetSSAOKernelSize(32)
            renderer.SSAOBlurOn()
            renderer.UseSSAOOn()
        try:
            report = _render(self.scene, Row(row.label, "off"), self.comparison.frames)
        finally:
            renderer.UseSSAOOff()
        result: Result = {}
        _stage_times(result, report)
        result["indirect_ms"] = None
        if row.method == "vtk":
            # What leaving indirect light out costs; of SSAO there is nothing to compare, it darkens
            # the light that is there.
            result.update(self._judge(np.zeros_like(self.references().images["R1"])))
        return result

    def _method(self, row: Row) -> Result:
        self.references()
        report = _render(self.scene, row, self.comparison.frames)
        result: Result = {}
        _stage_times(result, report)
        if row.method != "off":
            irradiance = images.copy_buffer(self.scene.renderer, "irradiance")
            result.update(self._judge(irradiance))
            result.update(self._pictures(row, irradiance))
            if self.comparison.sweep.flicker:
                result.update(self._flicker(row))
        return result

    def _flicker(self, row: Row) -> Result:
        truth = self.truth()
        methods.enable(self.scene.renderer, row.method, row.sampler, **row.settings)
        return orbit.judge(self.scene, truth)

    def _attempt(self, row: Row, work: Callable[[], Result]) -> Result:
        """Do the work of a row; whatever goes wrong becomes the row's error."""
        result = {
            **self.common,
            "label": row.label,
            "method": row.method,
            "settings": row.settings,
            "error": "",
        }
        try:
            result.update(work())
        except Exception as error:
            result["error"] = _one_line(error) or type(error).__name__
        methods.disable(self.scene.renderer)
        self._record(self._key(row), result)
        return result

    def traced_rows(self) -> list[Row]:
        """Rows of the path tracer, or none, with the reason in `missing`."""
        if self.comparison.python is None or TRACER in self.missing:
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

    def _traced(self, row: Row, traced: Traced) -> Result:
        times = [1000.0 * seconds for seconds in traced.seconds]
        result: Result = {
            "frames": len(times),
            "indirect_ms": statistics.median(times),
            "indirect_p95_ms": frames.percentile_95(times),
        }
        irradiance = traced.image
        result.update(self._judge(irradiance))
        result.update(self._pictures(row, irradiance))
        return result

    def _trace(self, rows: list[Row], step: Callable[[Row], None]) -> Iterator[Result]:
        """Results of the path tracer's rows, by one process for all of them."""
        wanted = [{"name": str(index), **row.settings} for index, row in enumerate(rows)]
        for entry in wanted:
            entry["depth"] = entry.pop("bounces")
        failed: Exception | None = None
        found = reference_environment.trace(
            self.comparison.python, self.scene.path, self.size, wanted
        )
        for row in rows:
            step(row)
            traced: Traced | None = None
            if failed is None:
                try:
                    traced = next(found)
                except Exception as error:
                    failed = error if not isinstance(error, StopIteration) else RenderError(
                        "the path tracer ended too early"
                    )

            def work(row: Row = row, traced: Traced | None = traced) -> Result:
                if traced is None:
                    assert failed is not None
                    raise failed
                return self._traced(row, traced)

            yield self._attempt(row, work)
        found.close()

    def run(self, step: Callable[[str], None]) -> list[Result]:
        """All rows of the scene, yardsticks first, the path tracer last.

        `step` is called before each.
        """
        finished = self.finished()
        frames.open_window(self.scene, self.size)
        results = []
        jobs: list[tuple[Row, Callable[[Row], Result]]] = [
            (Row(name, name), self._yardstick) for name in YARDSTICKS
        ]
        jobs += [(row, self._method) for row in self.comparison.sweep.rows]
        for row, work in jobs:
            step(f"{self.scene.name}: {row.label}")
            known = finished.get(self._key(row))
            results.append(known or self._attempt(row, lambda row=row, work=work: work(row)))
        traced = self.traced_rows()
        made = self._trace(
            [row for row in traced if self._key(row) not in finished],
            lambda row: step(f"{self.scene.name}: {row.label}"),
        )
        for row in traced:
            known = finished.get(self._key(row))
            results.append(known or next(made))
        for result in results:
            result["missing"] = self.missing
        self.scene.render_window.Finalize()
        return results


def table(results: Iterable[Result]) -> str:
    """Results as CSV; settings and reasons as JSON in their cells."""
    rows = list(results)
    columns: list[str] = []
    for row in rows:
        columns += [name for name in row if name not in columns]
    stream = io.StringIO()
    writer = csv.DictWriter(stream, columns, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow(
            {k: json.dumps(v, sort_keys=True) if isinstance(v, (dict, list)) else v
             for k, v in row.items()}
        )
    return stream.getvalue()
