# SPDX-License-Identifier: BSD-3-Clause
"""Cost of the order of harmonics for radiance hints in rooms of any number of triangles.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/hints.py
        [--rounds N] [--size N] [--triangles N]...

Prints a Markdown table: the paper's settings, grids and numbers of samples (its table 2) in
procedural rooms, milliseconds to bring the first bounce to the hints, for the second, and for
look-up and interpolation, with order 2 and with order 3, and the ratio of their sums. Frames of the
two alternate in one run on one window, so that other load falls on both alike: only ratios are
results, and times beside them tell how long it took here. Light is brought to the hints anew in
every frame; maps and surfaces stay. Times are medians over rounds.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from typing import Any

from multiresolution import procedural, table
from vtkindirect import methods, windows

TRIANGLES = (12_000, 80_000, 150_000, 330_000)
BALLS = 24
GRIDS = {
    "Cellar": ((13, 5, 16), 20),
    "Containers": ((16, 8, 16), 50),
    "Sponza": ((24, 11, 15), 30),
}
"""Hints along the axes and samples a hint, of the paper's table 2: its least, middle and most."""

STAGES = (("inject",), ("bounces",), ("estimate", "upsample"))


def resolution_for(triangles: int) -> int:
    """Resolution of each ball's sphere that gives a room about so many triangles."""
    # A sphere has 2 r (r - 2) of them but for its poles, r along each angle.
    return max(4, round((triangles / BALLS / 2.0) ** 0.5 + 1.0))


def measure(indirect: Any, window: Any, order: int) -> list[float]:
    """Milliseconds of each group of stages in one frame."""
    hints = indirect.GetEstimator()
    hints.SetOrder(order)
    window.Render()  # a change of order allocates
    indirect.SetTiming(False)  # forgets
    indirect.SetTiming(True)
    hints.Modified()
    window.Render()
    stages = methods.report(indirect)["stages"]
    return [sum(stages[name]["median_ms"] for name in group if name in stages) for group in STAGES]


def main() -> int:
    """Measure and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5, help="frames a median is of (default: 5)")
    parser.add_argument("--size", type=int, default=1024, help="edge of the window (default: 1024)")
    parser.add_argument("--triangles", type=int, action="append", help="of a room, about")
    words = parser.parse_args()
    if words.rounds < 1 or words.size < 16:
        parser.error("--rounds must be 1 or more, --size 16 or more")
    rows = []
    for wanted in words.triangles or TRIANGLES:
        renderer, triangles = procedural(BALLS, resolution_for(wanted))
        window = windows.render_window((words.size, words.size), offscreen=True)
        windows.start(window)
        window.AddRenderer(renderer)
        indirect = methods.enable(renderer, "hints", NumberOfBounces=2)
        hints = indirect.GetEstimator()
        hints.SetPresetToPaper()
        for name, (grid, samples) in GRIDS.items():
            hints.SetGridResolution(*grid)
            hints.SetNumberOfSamples(samples)
            found: dict[int, list[list[float]]] = {2: [], 3: []}
            for turn in range(words.rounds + 1):
                for order, times in found.items():
                    measured = measure(indirect, window, order)
                    if turn > 0:  # the first builds shaders
                        times.append(measured)
            medians = {
                order: [statistics.median(column) for column in zip(*times)]
                for order, times in found.items()
            }
            rows.append(
                (f"{triangles / 1000:.0f}K", name, " x ".join(map(str, grid)), samples,
                 *(" ".join(f"{ms:.1f}" for ms in medians[order]) for order in (2, 3)),
                 f"{sum(medians[3]) / sum(medians[2]):.2f}")
            )  # fmt: skip
        window.Finalize()
    print(f"Radiance hints, the paper's settings, {words.size} x {words.size}\n")
    head = ("triangles", "grid of", "hints", "samples", "order 2", "order 3", "order 3 / 2")
    table(head, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
