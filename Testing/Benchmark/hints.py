# SPDX-License-Identifier: BSD-3-Clause
"""Cost of radiance hints by their parameters.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/hints.py
        [--rounds N] [--size N] [--triangles N]... [--figure FILE.png]

With --figure: plots the time of cornell_box by the number of hints, samples, bounces and pixels, for
order 2 and order 3, over that of the paper's usual settings (its figure 10).

Else prints a Markdown table: the paper's settings, grids and numbers of samples (its table 2) in
procedural rooms about as large as its scenes, or of --triangles. A cell holds milliseconds to bring
the first bounce to the hints, for the second, and for look-up and interpolation; ratios are those of
their sums, order 3 over order 2. Frames of the two alternate in one run on one window, so that other
load falls on both alike: only ratios are results, and times beside them tell how long it took here.
Light is brought to the hints anew in every frame; maps and surfaces stay. Times are medians over
rounds.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import plot
from multiresolution import procedural, table
from vtkindirect import load_scene, methods, windows

BALLS = 24


class Published(NamedTuple):
    """A scene of the paper's table 2."""

    triangles: int
    grid: tuple[int, int, int]
    samples: int
    """Samples of maps for each hint."""
    order_2: tuple[float, float, float]
    """Milliseconds on a GeForce GTX 285: first bounce, second bounce, look-up at 1024 x 1024."""
    order_3: tuple[float, float, float]


PUBLISHED = {
    "Containers": Published(12_528, (16, 8, 16), 50, (1.90, 1.55, 2.17), (3.87, 2.70, 4.55)),
    "Cellar": Published(15_220, (13, 5, 16), 20, (1.25, 0.90, 2.95), (2.81, 2.39, 6.16)),
    "Cargo bay": Published(18_297, (16, 9, 16), 50, (3.14, 1.74, 2.95), (6.80, 2.91, 6.16)),
    "Sibenik": Published(80_062, (16, 13, 7), 30, (1.18, 1.23, 2.93), (1.97, 1.63, 6.27)),
    "Sponza": Published(267_235, (24, 11, 15), 30, (2.26, 1.87, 2.88), (4.13, 2.79, 6.03)),
    "Cornell box": Published(326_383, (10, 10, 10), 60, (2.36, 0.73, 2.57), (2.94, 1.53, 5.58)),
}
LEGEND = """\
Cells: milliseconds for the first bounce at the hints + the second + look-up and interpolation at the
pixels. Order 3 / 2: ratio of their sums with harmonics of order 3 and of order 2; the paper's is that
of the sums of its table 2 (GeForce GTX 285). Rooms have about as many triangles as the paper's scenes.
"""

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


def cell(milliseconds: Iterable[float], digits: int = 1) -> str:
    """Times of the stages, as LEGEND says."""
    return " + ".join(f"{ms:.{digits}f}" for ms in milliseconds)


def row_of(name: str, published: Published, wanted: int, size: int, rounds: int) -> tuple[Any, ...]:
    """A row of the table: a room of about so many triangles with a scene's grid and samples."""
    renderer, triangles = procedural(BALLS, resolution_for(wanted))
    window = windows.render_window((size, size), offscreen=True)
    windows.start(window)
    window.AddRenderer(renderer)
    indirect = methods.enable(renderer, "hints", NumberOfBounces=2)
    hints = indirect.GetEstimator()
    hints.SetPresetToPaper()
    hints.SetGridResolution(*published.grid)
    hints.SetNumberOfSamples(published.samples)
    found: dict[int, list[list[float]]] = {2: [], 3: []}
    for turn in range(rounds + 1):
        for order, times in found.items():
            measured = measure(indirect, window, order)
            if turn > 0:  # the first builds shaders
                times.append(measured)
    window.Finalize()
    two, three = ([statistics.median(column) for column in zip(*found[order])] for order in (2, 3))
    return (
        name, f"{triangles / 1000:.0f}K", " x ".join(map(str, published.grid)), published.samples,
        cell(two), cell(three), f"{sum(three) / sum(two):.2f}",
        cell(published.order_2, 2), cell(published.order_3, 2),
        f"{sum(published.order_3) / sum(published.order_2):.2f}",
    )  # fmt: skip


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
    for name, published in PUBLISHED.items():
        for wanted in words.triangles or (published.triangles,):
            rows.append(row_of(name, published, wanted, words.size, words.rounds))
    print(f"Radiance hints, the paper's settings, {words.size} x {words.size}\n")
    print(LEGEND)
    table(("grid of", "triangles", "hints", "samples", "order 2", "order 3", "order 3 / 2",
           "paper's order 2", "paper's order 3", "paper's order 3 / 2"), rows)  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main())
