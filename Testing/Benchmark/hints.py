# SPDX-License-Identifier: BSD-3-Clause
"""Cost of radiance hints by their parameters.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/hints.py
        [--rounds N] [--size N] [--triangles N]... [--figure FILE.png]

With --figure: plots the time of cornell_box by the number of hints, samples, bounces and pixels, for
order 2 and order 3, over that of the paper's usual settings (its figure 10).

Else prints a Markdown table for rooms of any number of triangles: the paper's settings, grids and
numbers of samples (its table 2) in procedural rooms, milliseconds to bring the first bounce to the
hints, for the second, and for look-up and interpolation, with order 2 and with order 3, and the ratio of their sums. Frames of the
two alternate in one run on one window, so that other load falls on both alike: only ratios are
results, and times beside them tell how long it took here. Light is brought to the hints anew in
every frame; maps and surfaces stay. Times are medians over rounds.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from pathlib import Path
from typing import Any

import plot
from multiresolution import procedural, table
from vtkindirect import load_scene, methods, windows

TRIANGLES = (12_000, 80_000, 150_000, 330_000)
BALLS = 24
GRIDS = {
    "Cellar": ((13, 5, 16), 20),
    "Containers": ((16, 8, 16), 50),
    "Sponza": ((24, 11, 15), 30),
}
"""Hints along the axes and samples a hint, of the paper's table 2: its least, middle and most."""

CORNELL_BOX = Path(__file__).resolve().parents[1] / "Scenes" / "cornell_box.json"
USUAL = {"hints": 16, "samples": 28, "bounces": 1, "pixels": 1024}
"""Hints along an axis, samples a hint, bounces, and pixels along an edge, of the paper's figure 10."""
PANELS = {
    "hints": ("hints", (8, 12, 16, 24, 32)),
    "samples": ("samples a hint", (10, 20, 28, 40, 60)),
    "bounces": ("bounces", (1, 2, 3, 4)),
    "pixels": ("pixels", (256, 512, 768, 1024, 1440)),
}

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


def time_of(values: dict[str, int], rounds: int) -> dict[int, float]:
    """Milliseconds of hints, bounces and look-up in cornell_box, by the order of harmonics."""
    scene = load_scene(CORNELL_BOX)
    window = windows.render_window((values["pixels"], values["pixels"]), offscreen=True)
    windows.start(window)
    window.AddRenderer(scene.renderer)
    indirect = methods.enable(
        scene.renderer, "hints", lighting="scene", preset="paper", NumberOfBounces=values["bounces"]
    )
    hints = indirect.GetEstimator()
    hints.SetGridResolution(*[values["hints"]] * 3)
    hints.SetNumberOfSamples(values["samples"])
    found: dict[int, list[float]] = {2: [], 3: []}
    for turn in range(rounds + 1):
        for order, times in found.items():
            milliseconds = sum(measure(indirect, window, order))
            if turn > 0:  # the first builds shaders
                times.append(milliseconds)
    window.Finalize()
    return {order: statistics.median(times) for order, times in found.items()}


def draw(path: Path, rounds: int) -> None:
    """Plot times over the usual settings' of order 2, a panel for each parameter."""
    pyplot = plot.require_plots()
    time_of(USUAL, 1)  # the first frames of a process take longer
    measured = {
        name: [time_of({**USUAL, name: step}, rounds) for step in steps]
        for name, (_, steps) in PANELS.items()
    }
    # Each panel has the usual settings, too.
    usual = statistics.median(
        measured[name][steps.index(USUAL[name])][2] for name, (_, steps) in PANELS.items()
    )
    figure, axes = pyplot.subplots(1, len(PANELS), figsize=(12, 3), sharey=True)
    for axis, (name, (label, steps)) in zip(axes, PANELS.items()):
        found = measured[name]
        power = {"hints": 3, "pixels": 2}.get(name, 1)
        for order, marker in ((2, "o-"), (3, "s--")):
            times = [entry[order] / usual for entry in found]
            axis.plot([step**power for step in steps], times, marker, label=f"order {order}")
            print(f"{label}, order {order}:", ", ".join(
                f"{step**power}: {ratio:.2f}" for step, ratio in zip(steps, times)
            ))  # fmt: skip
        axis.set_xlabel(label)
        axis.set_ylim(bottom=0.0)
    axes[0].set_ylabel("time over the usual")
    axes[0].legend()
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)


def main() -> int:
    """Measure and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5, help="frames a median is of (default: 5)")
    parser.add_argument("--size", type=int, default=1024, help="edge of the window (default: 1024)")
    parser.add_argument("--triangles", type=int, action="append", help="of a room, about")
    parser.add_argument("--figure", type=Path, metavar="FILE.png", help="plot instead")
    words = parser.parse_args()
    if words.rounds < 1 or words.size < 16:
        parser.error("--rounds must be 1 or more, --size 16 or more")
    if words.figure:
        draw(words.figure, words.rounds)
        return 0
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
