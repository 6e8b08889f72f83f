# SPDX-License-Identifier: BSD-3-Clause
"""Speed against error: methods on scenes, each row with its times and its errors.

For every scene the rows of a sweep are rendered with nothing reused between frames; times are medians
over frames after one to warm up, by wall clock with the pipeline drained around each stage. Errors are
those of the very image that was timed. In the same run plain VTK and VTK's screen-space ambient
occlusion are timed as yardsticks. A row that fails is a row with its error, and the run goes on.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import subprocess
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from vtkindirect import frames, images, methods, references
from vtkindirect.errors import IndirectError
from vtkindirect.frames import Job
from vtkindirect.references import References
from vtkindirect.scene import Scene
from vtkindirect.sweep import Row

SCHEMA = "vtkindirect.comparison/1"
FRAMES = 10
STAGES = ("rsm", "geometry", "lights", "estimate", "upsample", "composite")
METRICS = ("nrmse", "relmse", "relmse_trimmed", "bias", "p99", "shape", "leak")
YARDSTICKS = ("vtk", "ssao")

Result = dict[str, Any]


@dataclass
class Comparison:
    """What to run and where the results go."""

    rows: list[Row]
    directory: Path
    frames: int = FRAMES
    stored: Path | None = None
    """Directory of stored references (R2, R3), or None."""
    size: tuple[int, int] | None = None

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


def _fingerprint(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:12]


def _render(scene: Scene, row: Row, count: int) -> dict[str, Any]:
    """Time a method; the report of its frames."""
    methods.disable(scene.renderer)
    settings = dict(row.settings)
    if row.method != "off":
        settings.setdefault("Caching", False)
    return frames.render(scene, scene.render_window, Job(row.method, row.sampler, settings, count))


def _errors(result: Result, found: dict[str, Any]) -> None:
    for name, errors in found.items():
        values = errors.as_dict()
        for metric in METRICS:
            result[f"{metric}_{name.lower()}"] = values[metric]


def _stage_times(result: Result, report: dict[str, Any]) -> None:
    for stage in STAGES:
        times = report.get("stages", {}).get(stage)
        result[f"{stage}_ms"] = times["median_ms"] if times else 0.0
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
        self.stored = stored / f"{scene.name}.exr" if stored else None
        self.size = comparison.size or references.natural_size(self.stored) or scene.size
        self.common: Result = {
            "schema": SCHEMA,
            "scene": scene.name,
            "width": self.size[0],
            "height": self.size[1],
            "frames": comparison.frames,
            "scene_hash": _fingerprint(scene.path),
            "commit": commit(scene.path.parent),
            "vtk": vtkVersion.GetVTKVersion(),
        }
        self._references: References | None = None

    def _key(self, row: Row) -> str:
        identity = {k: v for k, v in self.common.items() if k != "schema"}
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
        """References of the scene, made on first use."""
        if self._references is None:
            self._references = references.collect(self.scene, self.size, self.stored)
            scale = 0.5 / float(self._references.images["R1"].mean())
            self._write("R1", shown(self._references.images["R1"], scale))
        return self._references

    def _write(self, label: str, picture: np.ndarray) -> str:
        safe = "".join(c if c.isalnum() or c in "-=._" else "_" for c in label)
        path = self.comparison.directory / f"{self.scene.name}-{safe}.png"
        images.write_png(path, picture)
        return path.name

    def _yardstick(self, name: str) -> Result:
        renderer = self.scene.renderer
        row = Row(name, "off")
        if name == "ssao":
            low_high = self.scene.bounds
            diagonal = sum((low_high[2 * i + 1] - low_high[2 * i]) ** 2 for i in range(3)) ** 0.5
            # Usual choices for these: a tenth and a thousandth of the scene.
            renderer.SetSSAORadius(0.1 * diagonal)
            renderer.SetSSAOBias(0.001 * diagonal)
            renderer.SetSSAOKernelSize(32)
            renderer.SSAOBlurOn()
            renderer.UseSSAOOn()
        try:
            report = _render(self.scene, row, self.comparison.frames)
        finally:
            renderer.UseSSAOOff()
        result: Result = {}
        _stage_times(result, report)
        result["indirect_ms"] = None
        return result

    def _method(self, row: Row) -> Result:
        reference = self.references()
        report = _render(self.scene, row, self.comparison.frames)
        result: Result = {}
        _stage_times(result, report)
        if row.method != "off":
            irradiance = images.copy_buffer(self.scene.renderer, "irradiance")
            _errors(result, reference.errors(irradiance))
            first = reference.images["R1"]
            result["image"] = self._write(row.label, shown(irradiance, 0.5 / float(first.mean())))
            result["difference"] = self._write(
                f"{row.label}-difference", difference_image(irradiance, first)
            )
        methods.disable(self.scene.renderer)
        return result

    def run(self, step: Callable[[str], None]) -> list[Result]:
        """All rows of the scene, yardsticks first; `step` is called before each."""
        finished = self.finished()
        frames.open_window(self.scene, self.size)
        results = []
        jobs: list[tuple[Row, Callable[[Row], Result]]] = [
            (Row(name, name), lambda row: self._yardstick(row.method)) for name in YARDSTICKS
        ]
        jobs += [(row, self._method) for row in self.comparison.rows]
        for row, work in jobs:
            step(f"{self.scene.name}: {row.label}")
            key = self._key(row)
            result = finished.get(key)
            if result is None:
                result = {**self.common, "label": row.label, "method": row.method,
                          "settings": row.settings, "error": ""}
                try:
                    result.update(work(row))
                except IndirectError as error:
                    result["error"] = " ".join(str(error).split())
                    methods.disable(self.scene.renderer)
                self._record(key, result)
            results.append(result)
        for name, why in (self._references.missing if self._references else {}).items():
            for result in results:
                result.setdefault("missing", {})[name] = why
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
