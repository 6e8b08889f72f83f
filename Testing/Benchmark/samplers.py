#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to choose virtual lights: error by their number and by time, and what drawing them takes.

    Testing/Benchmark/samplers.py [--size WxH] [--frames N] FILE.png SCENE...
    Testing/Benchmark/samplers.py --warping SCENE

The gather at every pixel with nothing hidden, so that what differs is the lights: spread over whole
maps, even on the texels that send light, drawn by importance, and those of the tree. Errors are root
mean squares of the difference to the sum over all texels (R1: maps of 256 x 256), over its mean; times are processor
time of the frame. Prints a page, with the number of lights that importance needs for the error of
256 even ones.

--warping: table 2 of Dachsbacher and Stamminger 2006, the time that warping takes by levels and
method for 32 x 32 and 64 x 64 lights, over that of one level of method B with 32 x 32. The frames of
all of these come in turn.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import plot
import vtkindirect
from vtkindirect import frames, images, methods
from vtkindirect.scene import Scene

COUNTS = (64, 128, 256, 512, 1024)
KINDS: dict[str, tuple[str, dict[str, Any]]] = {
    "whole maps": ("uniform", {"LitTexels": False}),
    "uniform": ("uniform", {"LitTexels": True}),
    "importance": ("importance", {}),
    "tree": ("tree", {}),
}
STYLES = {"whole maps": "x:", "uniform": "o-", "importance": "s-", "tree": "^--"}
# The paper's milliseconds, by method and edge of the pattern, from one level to four.
TABLE_2 = {
    ("apart", 32): (0.123, 0.238, 0.541, 1.739),
    ("apart", 64): (0.148, 0.358, 1.019, 3.484),
    ("together", 32): (0.111, 0.183, 0.422, 1.274),
    ("together", 64): (0.125, 0.258, 0.754, 2.584),
}
LEVELS = (1, 2, 3, 4, 0)


@dataclass
class Row:
    """One choice of lights: their number, the frame's time, the error and that of the mean."""

    count: int
    seconds: float
    error: float
    bias: float


def open_scene(path: str, size: tuple[int, int]) -> Scene:
    """Return a scene in a window."""
    scene = vtkindirect.load_scene(path)
    frames.open_window(scene, size)
    return scene


def render(scene: Scene, count: int) -> tuple[np.ndarray, float]:
    """Return the irradiance, and the median processor time of frames."""
    seconds = []
    for _ in range(count + 1):
        begin = time.process_time()
        scene.render_window.Render()
        seconds.append(time.process_time() - begin)
    return vtkindirect.copy_buffer(scene.renderer, "bounce"), float(np.median(seconds[-max(1, count):]))


def measure(path: str, size: tuple[int, int], count: int) -> dict[str, list[Row]]:
    """Return the rows of a scene, by kind."""
    scene = open_scene(path, size)
    common = {
        "Visibility": "none",
        "Interpolation": False,
        "Caching": False,
        "ReflectiveShadowMapResolution": 256,
        "NumberOfBounces": 1,
    }

    def show(sampler: str, turns: int = count, **settings: Any) -> tuple[np.ndarray, float]:
        methods.enable(scene.renderer, "gather", sampler, **common, **settings)
        return render(scene, turns)

    truth = show("uniform", 0, Mode="all_texels")[0].astype(float)
    mean = truth.mean()
    found: dict[str, list[Row]] = {kind: [] for kind in KINDS}
    for number in COUNTS:
        for kind, (sampler, settings) in KINDS.items():
            image, seconds = show(
                sampler, Mode="virtual_lights", NumberOfLights=number, **settings
            )
            error = float(np.sqrt(((image - truth) ** 2).mean()) / mean)
            found[kind].append(Row(number, seconds, error, float(image.mean() / mean - 1.0)))
    scene.render_window.Finalize()
    return found


def lights_for(rows: list[Row], error: float) -> float:
    """Return the number of lights that leaves an error: the line through the logarithms."""
    slope, offset = np.polyfit([np.log(row.error) for row in rows],
                               [np.log(row.count) for row in rows], 1)  # fmt: skip
    return float(np.exp(slope * np.log(error) + offset))


def usual(rows: list[Row]) -> float:
    """Return the geometric mean of errors, in which the luck of single patterns counts little."""
    return float(np.exp(np.mean([np.log(row.error) for row in rows])))


def draw(found: dict[str, dict[str, list[Row]]], path: Path) -> None:
    """Write the plot: error against lights and against time, a column for each scene."""
    pyplot = plot.require_plots()
    columns = min(4, len(found))
    lines = -(-len(found) // columns)
    figure, axes = pyplot.subplots(
        2 * lines, columns, figsize=(3.6 * columns, 6.0 * lines), squeeze=False
    )
    for axis in axes.ravel()[len(found) :]:
        axis.set_visible(False)
    for place, (name, kinds) in enumerate(found.items()):
        line, column = divmod(place, columns)
        pair = axes[2 * line][column], axes[2 * line + 1][column]
        for axis, label in zip(pair, ("virtual lights", "processor time of a frame, s")):
            for kind, rows in kinds.items():
                values = [row.count if axis is pair[0] else row.seconds for row in rows]
                axis.loglog(values, [row.error for row in rows], STYLES[kind], label=kind)
            axis.set_xlabel(label)
            axis.set_visible(True)
            axis.grid(True, which="both", alpha=0.3)
        pair[0].set_title(name)
    for line in range(2 * lines):
        axes[line][0].set_ylabel("RMSE to all texels over the mean")
    axes[0][0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def print_errors(found: dict[str, dict[str, list[Row]]]) -> None:
    """Print the page of errors."""
    heads = [f"{kind} {n}" for kind in KINDS for n in (256, 512)]
    print("| scene | " + " | ".join(KINDS) + " | " + " | ".join(heads) + " | bias, importance 256"
          " | importance for uniform 256 | time, importance / uniform |")  # fmt: skip
    print("|---" * (len(KINDS) + len(heads) + 4) + "|")
    for name, kinds in found.items():
        cells = [f"{usual(rows):.3f}" for rows in kinds.values()]
        cells += [f"{row.error:.3f}" for rows in kinds.values() for row in rows
                  if row.count in (256, 512)]  # fmt: skip
        own = kinds["importance"]
        bias = next(row.bias for row in own if row.count == 256)
        seconds = [own[i].seconds / kinds["uniform"][i].seconds for i in range(len(own))]
        even = next(row.error for row in kinds["uniform"] if row.count == 256)
        cells += [f"{100 * bias:+.1f} %", f"{lights_for(own, even):.0f}",
                  f"{np.median(seconds):.2f}"]  # fmt: skip
        print(f"| {name} | " + " | ".join(cells) + " |")


def measure_warping(path: str, count: int) -> dict[tuple[str, int, int], float]:
    """Return the median time of making virtual lights, ms, by method, edge and levels."""
    scene = open_scene(path, (8, 8))
    indirect = methods.enable(
        scene.renderer, "gather", "importance", Visibility="none", Mode="virtual_lights"
    )
    sampler = indirect.GetSampler()
    cases = [(method, edge, levels) for method, edge in TABLE_2 for levels in LEVELS]
    times: dict[tuple[str, int, int], list[float]] = {case: [] for case in cases}
    for turn in range(count + 1):
        for case in cases:
            method, edge, levels = case
            sampler.SetWarping(0 if method == "apart" else 1)
            sampler.SetLevels(levels)
            sampler.SetNumberOfLights(edge * edge)
            sampler.Modified()
            begin = time.process_time()
            scene.render_window.Render()
            if turn > 0:
                times[case].append(1000.0 * (time.process_time() - begin))
    scene.render_window.Finalize()
    return {case: float(np.median(values)) for case, values in times.items()}


def print_warping(times: dict[tuple[str, int, int], float]) -> None:
    """Print table 2 beside the paper's, as ratios."""
    unit, paper_unit = times["together", 32, 1], TABLE_2["together", 32][0]
    print("| method | lights | " + " | ".join(f"{n or 'all'} levels" for n in LEVELS) + " |")
    print("|---" * (len(LEVELS) + 2) + "|")
    for (method, edge), paper in TABLE_2.items():
        cells = [f"{times[method, edge, n] / unit:.2f}" for n in LEVELS]
        for i, value in enumerate(paper):
            cells[i] += f" ({value / paper_unit:.2f})"
        print(f"| {method} | {edge} x {edge} | " + " | ".join(cells) + " |")
    print(f"\nOf frames of 8 x 8 pixels, in shares of {unit:.2f} ms; in parentheses the paper's "
          f"warping alone, in shares of {paper_unit:.3f} ms.")  # fmt: skip


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, draw, print the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--warping", action="store_true")
    parser.add_argument("--size", default="96x96")
    parser.add_argument("--frames", type=int, default=1)
    parser.add_argument("paths", nargs="+", metavar="FILE.png SCENE...")
    given = parser.parse_args(arguments)
    if given.warping:
        print_warping(measure_warping(given.paths[0], max(given.frames, 15)))
        return 0
    if len(given.paths) < 2:
        parser.error("a file and a scene are needed")
    file = Path(given.paths[0])
    images.check_output(file, (".png",))
    width, height = (int(n) for n in given.size.split("x"))
    found = {
        Path(scene).stem: measure(scene, (width, height), given.frames)
        for scene in given.paths[1:]
    }
    draw(found, file)
    print_errors(found)
    return 0


if __name__ == "__main__":
    sys.exit(main())
