# SPDX-License-Identifier: BSD-3-Clause
"""The command ``vtk-indirect compare``."""

from __future__ import annotations

import argparse
import dataclasses
import json
from collections.abc import Callable
from pathlib import Path

from vtkindirect import (
    compare,
    compare_page,
    compare_plot,
    images,
    locations,
    methods,
    reference_environment,
    references,
    sweep,
)
from vtkindirect.compare import Comparison, Run
from vtkindirect.errors import UsageError
from vtkindirect.progress import Progress
from vtkindirect.scene import Scene


def add_arguments(
    parser: argparse.ArgumentParser,
    size: Callable[[str], tuple[int, int]],
    frames: Callable[[str], int],
) -> None:
    """Add the arguments of the command; `size` and `frames` parse those words."""
    parser.add_argument("scenes", nargs="+", metavar="SCENE", help="scene files (.json)")
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--methods", metavar="NAME,NAME", help="methods with their own settings (default: gather)"
    )
    what.add_argument("--sweep", metavar="FILE", help="a sweep file: methods and settings to run")
    parser.add_argument(
        "--reference",
        metavar="PATH",
        help="an .exr file with the layers R2 and R3, or the directory of SCENE.exr "
        "(default: beside the scenes, if there)",
    )
    parser.add_argument(
        "-o", "--output", default="report", metavar="DIRECTORY", help="(default: report)"
    )
    parser.add_argument(
        "--size",
        type=size,
        metavar="WxH",
        help="picture size in pixels (default: three times the stored reference's, else the scene's)",
    )
    parser.add_argument(
        "--frames",
        type=frames,
        default=compare.FRAMES,
        metavar="N",
        help=f"frames to measure, after one to warm up (default: {compare.FRAMES})",
    )
    parser.add_argument(
        "--flicker",
        action="store_true",
        help="also along a path of the camera, whatever the sweep says",
    )
    parser.add_argument(
        "--reference-python",
        metavar="FILE",
        help="Python of the environment that Testing/Reference/make_environment makes, for the "
        f"path tracer and HDR-FLIP (default: {reference_environment.VARIABLE} in the environment, "
        "else build/reference-venv beside the scenes, if there); 'none' leaves both out",
    )


def _sweep(arguments: argparse.Namespace) -> sweep.Sweep:
    if arguments.sweep:
        found = sweep.load(arguments.sweep)
    else:
        found = sweep.default((arguments.methods or "gather").split(","))
    return dataclasses.replace(found, flicker=found.flicker or arguments.flicker)


def _directory(name: str) -> Path:
    directory = Path(name)
    if not directory.exists():
        images.check_directory(directory.parent)
        directory.mkdir()
    images.check_directory(directory)
    return directory


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


def _stored(arguments: argparse.Namespace) -> Path | None:
    if arguments.reference:
        return _given(Path(arguments.reference), len(arguments.scenes))
    try:
        beside = locations.scene_directory().parent / "Reference" / "data"
    except UsageError:
        return None
    return beside if beside.is_dir() else None


def _outside(comparison: Comparison, given: str | None) -> None:
    """Find the reference environment, or note why the comparison goes without."""
    names = ("HDR-FLIP", compare.TRACER)
    try:
        comparison.python = reference_environment.find_python(given)
    except reference_environment.LeftOut as reason:
        comparison.left_out = dict.fromkeys(names, str(reason))
        return
    try:
        reference_environment.tracer_tools()
    except reference_environment.LeftOut as reason:
        comparison.left_out[compare.TRACER] = str(reason)
    try:
        comparison.flip = reference_environment.Flip(comparison.python)
    except reference_environment.LeftOut as reason:
        comparison.left_out["HDR-FLIP"] = str(reason)


def run(arguments: argparse.Namespace, load: Callable[[str], Scene]) -> None:
    """Run the comparison, print the paths of its page and its table."""
    what = _sweep(arguments)
    methods.check_method("reference")
    compare_plot.require_plots()
    for name in arguments.scenes:
        if Path(name).suffix.lower() != ".json":
            raise UsageError(f"{name}: a comparison needs a scene file (.json)")
    comparison = Comparison(
        sweep=what,
        directory=_directory(arguments.output),
        frames=max(2, arguments.frames),
        stored=_stored(arguments),
        size=arguments.size,
    )
    _outside(comparison, arguments.reference_python)
    rows = len(what.rows) + len(compare.YARDSTICKS)
    if comparison.python is not None:
        rows += sum(map(len, what.path_tracer.values()))
    results: list[compare.Result] = []
    try:
        with Progress("comparing", rows * len(arguments.scenes)) as bar:
            for name in arguments.scenes:
                results += Run(comparison, load(name)).run(bar.step)
    finally:
        if comparison.flip is not None:
            comparison.flip.close()
    directory = comparison.directory
    images.write_text(directory / "rows.json", json.dumps(results, indent=1) + "\n")
    images.write_text(directory / "rows.csv", compare.table(results))
    written = [directory / "rows.json", directory / "rows.csv"]
    written += compare_page.write(results, directory)
    for path in written:
        print(path)
    missing: dict[str, list[str]] = {}
    for result in results:
        for name, why in result["missing"].items():
            missing.setdefault(f"left out: {name}, because {why}", []).append(result["scene"])
    for sentence, scenes in missing.items():
        print(f"{sentence} ({', '.join(dict.fromkeys(scenes))})")
    failed = [result for result in results if result["error"]]
    for result in failed:
        print(f"failed: {result['scene']}, {result['label']}: {result['error']}")
