# SPDX-License-Identifier: BSD-3-Clause
"""The command ``vtk-indirect compare``."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path

from vtkindirect import compare, compare_page, images, locations, methods, sweep
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
        metavar="DIRECTORY",
        help="where SCENE.exr with the layers R2 and R3 is (default: beside the scenes, if there)",
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


def _rows(arguments: argparse.Namespace) -> list[sweep.Row]:
    if arguments.sweep:
        return sweep.load(arguments.sweep)
    return sweep.default((arguments.methods or "gather").split(","))


def _directory(name: str) -> Path:
    directory = Path(name)
    if not directory.exists():
        images.check_directory(directory.parent)
        directory.mkdir()
    images.check_directory(directory)
    return directory


def _stored(arguments: argparse.Namespace) -> Path | None:
    if arguments.reference:
        stored = Path(arguments.reference)
        if not stored.is_dir():
            raise UsageError(f"{stored}: is no directory of references")
        return stored
    try:
        beside = locations.scene_directory().parent / "Reference" / "data"
    except UsageError:
        return None
    return beside if beside.is_dir() else None


def run(arguments: argparse.Namespace, load: Callable[[str], Scene]) -> None:
    """Run the comparison, print the paths of its page and its table."""
    rows = _rows(arguments)
    methods.check_method("reference")
    compare_page.require_plots()
    comparison = Comparison(
        rows=rows,
        directory=_directory(arguments.output),
        frames=max(2, arguments.frames),
        stored=_stored(arguments),
        size=arguments.size,
    )
    results: list[compare.Result] = []
    total = len(arguments.scenes) * (len(rows) + len(compare.YARDSTICKS))
    with Progress("comparing", total) as bar:
        for name in arguments.scenes:
            if Path(name).suffix.lower() != ".json":
                raise UsageError(f"{name}: a comparison needs a scene file (.json)")
            results += Run(comparison, load(name)).run(bar.step)
    directory = comparison.directory
    images.write_text(directory / "rows.json", json.dumps(results, indent=1) + "\n")
    images.write_text(directory / "rows.csv", compare.table(results))
    written = [directory / "rows.json", directory / "rows.csv"]
    written += compare_page.write(results, directory)
    for path in written:
        print(path)
    failed = [result for result in results if result["error"]]
    for result in failed:
        print(f"failed: {result['scene']}, {result['label']}: {result['error']}")
