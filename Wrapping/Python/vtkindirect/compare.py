# SPDX-License-Identifier: BSD-3-Clause
"""The command ``vtk-indirect compare``: methods on scenes, each row with its times and its errors.

For every scene the rows are rendered while the camera turns by less than a pixel; times are medians over
frames after some to warm up, by wall clock with the pipeline drained around each stage. Errors are
those of the very image that was timed. A row that fails is a row with its error, and the run goes
on. ``Testing/Benchmark/comparison.py`` of the project's sources adds yardsticks, plots and a page.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import importlib
import io
import json
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from vtkindirect import (
    console,
    frames,
    images,
    lighting,
    locations,
    methods,
    references,
    sweep,
    wrapped,
)
from vtkindirect.errors import IndirectError, UsageError
from vtkindirect.frames import Job
from vtkindirect.metrics import MetricError
from vtkindirect.progress import Progress
from vtkindirect.references import References
from vtkindirect.scene import Scene
from vtkindirect.sweep import Row

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
NOTHING = "vtk"
"""The row of plain VTK, whose indirect light is none."""
SSAO = "ssao"
"""The row of VTK's screen-space ambient occlusion, where a run has one."""
PROGRAM = "Testing/Benchmark/comparison.py"
TIMES_ALONE = "none"
"""Value of --reference for rows of times, without errors."""
REFINED = "refined"
"""Value of --reference for references that the default method makes."""

Result = dict[str, Any]


def fingerprint(path: Path | None) -> str:
    """Return a short hash of a file; empty when there is none."""
    if path is None or not path.exists():
        return ""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:12]


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split())
    # Errors of other packages are not written to be read alone.
    readable = isinstance(error, (IndirectError, MetricError))
    return text if readable else f"{type(error).__name__}: {text}"


def _times(report: dict[str, Any]) -> Result:
    """Return the times of a report, and what else it says of its frames."""
    result: Result = {}
    stages = report.get("stages", {})
    for stage in dict.fromkeys((*STAGES, *(name for name in stages if name != "delegate"))):
        times = stages.get(stage, {"median_ms": 0.0, "p95_ms": 0.0})
        result[f"{stage}_ms"] = times["median_ms"]
        result[f"{stage}_p95_ms"] = times["p95_ms"]
    result["indirect_ms"] = report.get("indirect_ms")
    result["frame_ms"] = report["wall_ms"]["median_ms"]
    result["frame_p95_ms"] = report["wall_ms"]["p95_ms"]
    result["processor_ms"] = report["processor_ms"]["median_ms"]
    result["processor_p95_ms"] = report["processor_ms"]["p95_ms"]
    for name in ("pace", "first_ms", "warm_up_frames"):
        if name in report:
            result[name] = report[name]
    result["virtual_lights"] = report.get("virtual_lights")
    result["bytes"] = report.get("bytes")
    result["shader_hash"] = report.get("shader_hash", "")
    result["gl"] = report.get("gl", {}).get("renderer", "")
    result["gl_version"] = report.get("gl", {}).get("version", "")
    result["version"] = report.get("version", "")
    return result


def add_differences(results: Iterable[Result]) -> None:
    """Note in a scene's rows what each adds to the frame of plain VTK, and that over SSAO's.

    ``added_ms`` and ``added_processor_ms`` are differences of medians; the ratios ``…_over_ssao``
    are there where the run has a row of `SSAO` that takes longer than plain VTK. ``sky_over_ssao`` is
    that of the stage ``sky`` alone, of which wall clock is all that is known.
    """
    rows = [row for row in results if not row["error"]]
    for time, added in (("frame_ms", "added"), ("processor_ms", "added_processor")):
        found = {row["method"]: row.get(time) for row in rows}
        plain, occluded = found.get(NOTHING), found.get(SSAO)
        if plain is None:
            continue
        for row in rows:
            if row["method"] == NOTHING or row.get(time) is None:
                continue
            row[f"{added}_ms"] = row[time] - plain
            if row["method"] != SSAO and occluded is not None and occluded > plain:
                row[f"{added}_over_ssao"] = row[f"{added}_ms"] / (occluded - plain)
                if time == "frame_ms" and row.get("sky_ms"):
                    row["sky_over_ssao"] = row["sky_ms"] / (occluded - plain)


class Run:
    """One comparison of one scene."""

    def __init__(
        self,
        scene: Scene,
        count: int,
        stored: Path | None,
        size: tuple[int, int] | None = None,
        *,
        with_errors: bool = True,
        makes: bool = False,
    ) -> None:
        """`stored` is a file with references, a directory of one file a scene, or None.

        `with_errors`: whether there are errors beside the times; R1 takes long in large images.
        `makes`: the default method makes references that are not stored.
        """
        self.scene = scene
        self.count = count
        self.with_errors = with_errors
        if stored is not None and stored.is_dir():
            stored = stored / f"{scene.name}.exr"
        self.stored = stored
        self.size = size or references.natural_size(stored) or scene.size
        self.makes = makes and with_errors and (stored is None or not stored.exists())
        names = references.names_of(scene)
        self.missing = (
            {} if self.makes else references.stored_images(stored, self.size, names)[1]
        )
        if not self.with_errors:
            self.missing = {"errors": "times alone were asked for"}
        elif not references.has_r1(scene):
            whole = "A3 knows area lights" if scene.area_lights else "S3 knows the sky"
            self.missing["R1, R2 and R3"] = f"they know VTK's lights only, {whole} as well"
        elif not wrapped.has(wrapped.ORACLE):
            self.missing["R1"] = str(wrapped.explain(wrapped.ORACLE))
        self.common: Result = {
            "schema": SCHEMA,
            "scene": scene.name,
            "width": self.size[0],
            "height": self.size[1],
            "frames": count,
            "scene_hash": fingerprint(scene.path),
            "reference_hash": fingerprint(stored),
            "vtk": vtkVersion.GetVTKVersion(),
        }
        self._references: References | Exception | None = None
        self.show: Callable[[str], None] = lambda _what: None

    def _show(self, what: str, _left: int = 0) -> None:
        self.show(what)

    def references(self) -> References:
        """References of the scene, made on first use; what made them fail once fails again."""
        if not self.with_errors:
            return References(np.zeros((0, 0), dtype=bool))
        if self._references is None:
            try:
                self._references = references.collect(
                    self.scene, self.size, self.stored, makes=self.makes, step=self._show
                )
            except Exception as error:
                self._references = error
        if isinstance(self._references, Exception):
            raise self._references
        return self._references

    def judge(self, seen: references.Buffers) -> Result:
        """Errors of a frame's buffers against each reference."""
        result: Result = {}
        for name, errors in self.references().errors(seen).items():
            values = errors.as_dict()
            result.update({f"{metric}_{name.lower()}": values[metric] for metric in METRICS})
        for name, error in self.references().estimated.items():
            result[f"estimated_error_{name.lower()}"] = error
        result["masked_share"] = self.references().masked_share()
        return result

    def timed(self, row: Row) -> Result:
        """Time a method; its image is in the window afterwards."""
        methods.disable(self.scene.renderer)
        # The references have the scene's lights.
        given = row.method == "off" or any(map(lighting.is_property, row.settings))
        light = None if given else "scene"
        job = Job(
            row.method, row.sampler, dict(row.settings), self.count, row.pace, lighting=light
        )
        return _times(frames.render(self.scene, self.scene.render_window, job, self._show))

    def nothing(self, row: Row) -> Result:
        """The frame without any pass, and the error of leaving indirect light out."""
        result = self.timed(Row(row.label, "off"))
        result["indirect_ms"] = None
        nothing = np.zeros((self.size[1], self.size[0], 3))
        result.update(self.judge(dict.fromkeys(self.references().buffers(), nothing)))
        return result

    def method(self, row: Row) -> Result:
        """Times and errors of a row."""
        self.references()
        result = self.timed(row)
        if row.method != "off":
            seen = {
                name: images.copy_buffer(self.scene.renderer, name)
                for name in self.references().buffers()
            }
            result.update(self.judged(row, seen))
        return result

    def judged(self, _row: Row, seen: references.Buffers) -> Result:
        """Return what a row says of its frame."""
        return self.judge(seen)

    def attempt(self, row: Row, work: Callable[[], Result]) -> Result:
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
        return result

    def run(self, rows: list[Row], step: Callable[[str], None]) -> list[Result]:
        """All rows, that of plain VTK first; `step` is called before each."""
        frames.open_window(self.scene, self.size)
        results = []
        for row in (Row(NOTHING, NOTHING), *rows):
            step(f"{self.scene.name}: {row.label}")
            work = self.nothing if row.method == NOTHING else self.method
            results.append(self.attempt(row, lambda row=row, work=work: work(row)))
        add_differences(results)
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


# The command --------------------------------------------------------------------------------------


def add_arguments(
    parser: argparse.ArgumentParser,
    size: Callable[[str], tuple[int, int]],
    count: Callable[[str], int],
) -> None:
    """Add the arguments of the command; `size` and `count` parse those words."""
    parser.add_argument("scenes", nargs="+", metavar="SCENE", help="scene files (.json)")
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--methods", metavar="NAME,NAME", help="methods with their own settings (default: gather)"
    )
    what.add_argument("--sweep", metavar="FILE", help="a sweep file: methods and settings to run")
    parser.add_argument(
        "--reference",
        metavar="PATH",
        help="an .exr file with the layers R2 and R3, S1 and S3, A1 and A3, or the directory of SCENE.exr "
        f"(default: beside the scenes, if there, else '{REFINED}'); '{REFINED}': pictures of the default "
        f"method, left alone; '{TIMES_ALONE}': times alone, without errors",
    )
    parser.add_argument(
        "-o", "--output", default="report", metavar="DIRECTORY", help="(default: report)"
    )
    parser.add_argument(
        "--size",
        type=size,
        metavar="WxH",
        help="picture size in pixels (default: three times the stored reference's, else the "
        "scene's)",
    )
    parser.add_argument(
        "--frames",
        type=count,
        default=FRAMES,
        metavar="N",
        help=f"frames to measure, after some to warm up (default: {FRAMES})",
    )
    outside = f"done by {PROGRAM} of the project's sources, where they are"
    parser.add_argument(
        "--flicker",
        action="store_true",
        help=f"also along a path of the camera, whatever the sweep says; {outside}",
    )
    parser.add_argument(
        "--reference-python",
        metavar="FILE",
        help=f"Python with a path tracer and HDR-FLIP for more columns and rows; {outside}; 'none' "
        "leaves both out",
    )


def sweep_of(arguments: argparse.Namespace) -> sweep.Sweep:
    """Return what the command line asks to be run."""
    if arguments.sweep:
        return sweep.load(arguments.sweep)
    return sweep.default((arguments.methods or "gather").split(","))


def _given(stored: Path, scenes: int) -> Path:
    """Return the path that --reference names, a directory or a file of references."""
    if not stored.exists():
        raise UsageError(f"{stored}: no such file or directory")
    if stored.is_dir():
        return stored
    if stored.suffix.lower() != ".exr":
        raise UsageError(f"{stored}: is neither an .exr file nor a directory of them")
    if scenes > 1:
        raise UsageError(f"{stored}: one file is for one scene, not {scenes}; name a directory")
    if not any(references.read_layer(stored, name) is not None for name in references.STORED):
        names = " or ".join(f"'{name}'" for name in references.STORED)
        raise UsageError(f"{stored}: has no layer {names}")
    return stored


def wants_errors(arguments: argparse.Namespace) -> bool:
    """Return whether the command line asks for errors beside the times."""
    return bool(arguments.reference != TIMES_ALONE)


def _stored(arguments: argparse.Namespace) -> Path | None:
    if arguments.reference in (TIMES_ALONE, REFINED):
        return None
    if arguments.reference:
        return _given(Path(arguments.reference), len(arguments.scenes))
    try:
        beside = locations.scene_directory().parent / "Reference" / "data"
    except UsageError:
        return None
    return beside if beside.is_dir() else None


def check_inputs(arguments: argparse.Namespace) -> tuple[Path, Path | None]:
    """Return where results go and where stored references are; raises before any work is done."""
    for name in arguments.scenes:
        if Path(name).suffix.lower() != ".json":
            raise UsageError(f"{name}: a comparison needs a scene file (.json)")
    stored = _stored(arguments)
    directory = Path(arguments.output)
    if not directory.exists():
        images.check_directory(directory.parent)
        directory.mkdir()
    images.check_directory(directory)
    return directory, stored


def write(results: list[Result], directory: Path) -> list[Path]:
    """Write the table in both forms; returns the paths."""
    images.write_text(directory / "rows.json", json.dumps(results, indent=1) + "\n")
    images.write_text(directory / "rows.csv", table(results))
    return [directory / "rows.json", directory / "rows.csv"]


def _cell(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)


def text_table(results: list[Result]) -> str:
    """Return results for people: of each row its times and the errors that it has."""
    errors = sorted({name for row in results for name in row if name.startswith("nrmse_")})
    biases = [name.replace("nrmse", "bias") for name in errors]
    names = ["scene", "label", "frame_ms", "indirect_ms", *sum(zip(errors, biases), ()), "error"]
    if not any(row["error"] for row in results):
        names.remove("error")
    lines = [names, *([_cell(row.get(name)) for name in names] for row in results)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(names))]
    left = ("scene", "label", "error")
    return "\n".join(
        "  ".join(
            cell.ljust(width) if name in left else cell.rjust(width)
            for name, cell, width in zip(names, line, widths)
        ).rstrip()
        for line in lines
    )


def _estimated(results: list[Result]) -> dict[str, str]:
    """Return what is estimated of the errors of references that are made, by scene."""
    start = "estimated_error_"
    return {
        row["scene"]: "RMS error over the mean about "
        + ", ".join(
            f"{row[name]:.2g} of {name[len(start):].upper()}" for name in row if name.startswith(start)
        )
        for row in results
        if any(name.startswith(start) for name in row)
    }


def say(results: list[Result], written: list[Path]) -> None:
    """Print the table, its files, what is left out and why, and which rows failed."""
    console.say(text_table(results))
    for path in written:
        console.say(str(path))
    missing: dict[str, list[str]] = {}
    for result in results:
        for name, why in result["missing"].items():
            missing.setdefault(f"left out: {name}, because {why}", []).append(result["scene"])
    for sentence, scenes in missing.items():
        console.say(f"{sentence} ({', '.join(dict.fromkeys(scenes))})")
    for scene, errors in _estimated(results).items():
        console.say(f"{scene}: references are refined pictures of the default method, {errors}")
    for result in results:
        if result["error"]:
            console.say(f"failed: {result['scene']}, {result['label']}: {result['error']}")


def _whole_program(option: str) -> Any:
    """Return the module of the sources that does what is not in the package."""
    try:
        found = locations.scene_directory().parent.parent / PROGRAM
    except UsageError:
        found = Path(PROGRAM)
    if not found.is_file():
        raise UsageError(f"{option}: is done by {PROGRAM}, and the project's sources are not here")
    sys.path.insert(0, str(found.parent))
    return importlib.import_module(found.stem)


def run(arguments: argparse.Namespace, load: Callable[[str], Scene]) -> None:
    """Run the comparison; print the paths of its table and what is missing from it."""
    python = arguments.reference_python
    if arguments.flicker or python not in (None, "none"):
        option = "--flicker" if arguments.flicker else "--reference-python"
        _whole_program(option).run(arguments, load)
        return
    what = sweep_of(arguments)
    directory, stored = check_inputs(arguments)
    results: list[Result] = []
    with Progress("comparing", (len(what.rows) + 1) * len(arguments.scenes)) as bar:
        for name in arguments.scenes:
            one = Run(
                load(name),
                max(2, arguments.frames),
                stored,
                arguments.size,
                with_errors=wants_errors(arguments),
                makes=True,
            )
            if what.flicker:
                one.missing["flicker"] = f"{PROGRAM} of the project's sources measures it"
            one.show = bar.show
            results += one.run(what.rows, bar.step)
    say(results, write(results, directory))
