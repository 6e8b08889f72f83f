#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tolerances that are asked for beside what pictures reach, and the estimated beside the measured error.

    Testing/Benchmark/tolerance.py [--tolerances T,T... | --refinements N,N...] SCENE...

SCENE is the name of a file of Testing/Scenes that has a stored reference. Each is rendered with nothing
set, and then by each tolerance, or with each number of refinements. Prints a table: the estimated
error, the RMS error over the mean to the reference, relMSE and bias to it, refinements, and seconds of wall clock: of the picture, with the first one's maps, and of
the report, which traces paths where a tolerance has not. The reference has noise of its own
(Documentation/reference.md), which the error to it contains.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import vtkindirect
from vtkindirect import frames, methods, references

HERE = Path(__file__).resolve().parents[1]
AT_ONCE = 1e-4
"""VTK's default rate of a window: pictures off screen are finished in one render."""
TOLERANCES = (0.2, 0.1, 0.05, 0.02)


def row(name: str, asked: str, settings: dict[str, float]) -> str:
    """Render a scene with these settings; returns a row of the table."""
    scene = vtkindirect.load_scene(HERE / "Scenes" / f"{name}.json")
    stored = HERE / "Reference" / "data" / f"{name}.exr"
    size = references.natural_size(stored)
    window = frames.open_window(scene, size)
    try:
        found = references.collect(scene, size, stored)
        indirect = methods.enable(scene.renderer, "auto", **settings)
        window.SetDesiredUpdateRate(AT_ONCE)
        began = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        seconds = time.perf_counter() - began
        began = time.perf_counter()
        report = methods.report(indirect)
        judged = time.perf_counter() - began
        seen = {buffer: vtkindirect.copy_buffer(scene.renderer, buffer) for buffer in found.buffers()}
        errors = found.errors(seen)
        if not found.main:
            raise vtkindirect.UsageError(f"{name} has no stored reference")
        to_it = errors[found.main]
        return (
            f"| {name} | {asked} | {report['estimated_error']:.3f} | {to_it.nrmse:.3f} "
            f"| {to_it.relmse:.4f} | {to_it.bias:+.3f} | {report['counters']['refinements']} | {seconds:.1f} | {judged:.2f} |"
        )
    finally:
        window.Finalize()


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", metavar="SCENE", nargs="+")
    parser.add_argument("--tolerances", default=",".join(map(str, TOLERANCES)))
    parser.add_argument("--refinements", help="numbers of refinements, in place of tolerances")
    options = parser.parse_args(arguments)
    asked: list[tuple[str, dict[str, float]]] = [("none", {})]
    if options.refinements:
        numbers = [int(number) for number in options.refinements.split(",")]
        asked += [(f"{number} refinements", {"NumberOfRefinements": number}) for number in numbers]
    else:
        tolerances = [float(tolerance) for tolerance in options.tolerances.split(",")]
        asked += [(str(tolerance), {"ErrorTolerance": tolerance}) for tolerance in tolerances]
    print(
        "| scene | asked | estimated | to the reference | relMSE | bias | refinements | picture, s "
        "| report, s |"
    )
    print("|---|---|---:|---:|---:|---:|---:|---:|---:|")
    for name in options.scenes:
        for words, settings in asked:
            print(row(name, words, settings), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
