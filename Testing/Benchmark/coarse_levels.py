#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Coarse levels in depth maps: those that the pass makes, and those of vtkMeshSimplificationFilter.

    Testing/Benchmark/coarse_levels.py [--rounds N]    the table of Documentation/methods/depth-maps.md

A mesh over a ground is lit by a uniform sky, or by a lamp, whose virtual lights lie on ground and
mesh. A still picture is drawn until no map is missing, with the mesh itself in the maps, with the
pass's levels, and with two of the filter's. Errors are those of the sky's or of the reflected light at
pixels that show surfaces, to the picture with the mesh itself: RMS and bias, over the mean. Times are
the processor's; those of maps are medians of rounds, and only their ratios mean something.
"""

from __future__ import annotations

import argparse
import re
import statistics
import sys
import time
from dataclasses import dataclass, field

import numpy as np
import vtkindirect
from vtkindirect import methods
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

from proxy_pass import View, part_of

MESHES = (("brain", "cortex"), ("frog", "liver"), ("frog", "lung"))
SHARES = (0.0025, 0.01)
"""Largest distances of the filter's levels, over the diagonal."""
CASES = ("sky", "lamp")
TOO_FAR = 1e30
"""Distance of a level that no map takes, so that maps have the mesh itself."""
MOST_FRAMES = 500
UPDATE_RATE = 1e-4
Levels = list[tuple[vtkPolyData, float]]


@dataclass
class Row:
    """Measurements of one kind of levels."""

    making: list[float] = field(default_factory=list)
    drawing: list[float] = field(default_factory=list)
    counted: np.ndarray = field(default_factory=lambda: np.zeros(2))
    light: np.ndarray = field(default_factory=lambda: np.zeros(0))


def simplify(mesh: vtkPolyData) -> tuple[Levels, float]:
    """Return the filter's levels with their distances, and the time that they take."""
    levels = []
    start = time.process_time()
    for share in SHARES:
        simple = vtkindirect.vtkMeshSimplificationFilter()
        simple.SetInputData(mesh)
        simple.SetMaximumError(share)
        simple.Update()
        levels.append((simple.GetOutput(), simple.GetMaximumDistance()))
    return levels, time.process_time() - start


class Scene:
    """A mesh over a ground, in a window with the pass."""

    def __init__(self, mesh: vtkPolyData, case: str) -> None:
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.buffer = "bounce" if case == "lamp" else "sky"
        box = np.array(mesh.GetBounds()).reshape(3, 2).T
        middle, length = box.mean(axis=0), float(np.linalg.norm(box[1] - box[0]))
        self.view = View([self.actor], box, (256, 192))
        if case == "lamp":
            lamp = vtkLight()
            lamp.PositionalOn()
            lamp.SetConeAngle(35)
            lamp.SetPosition(*(middle + length * np.array((0.6, 0.9, 0.4))))
            lamp.SetFocalPoint(*middle)
            self.view.renderer.AddLight(lamp)
        sky = None if case == "lamp" else (1.0, 1.0, 1.0)
        self.indirect = methods.enable(self.view.renderer, environment=sky, NumberOfBounces=1)
        self.view.window.SetDesiredUpdateRate(UPDATE_RATE)

    def counted(self) -> np.ndarray:
        """Return the triangles of levels that maps have drawn, and those of the mesh in their place."""
        said = str(vtkindirect.report(self.view.renderer)["modelled"])
        found = re.search(r"(\d+) triangles drawn in place of (\d+)", said)
        return np.array(found.groups(), dtype=float) if found else np.zeros(2)

    def draw(self, row: Row, levels: Levels) -> tuple[float, float]:
        """Draw all maps with levels, none: the pass's. Return the time, and that of the first frame."""
        self.indirect.RemoveCoarseLevels(self.actor)
        for mesh, error in levels:
            self.indirect.AddCoarseLevel(self.actor, mesh, error)
        before = self.counted()
        seconds = []
        for _ in range(MOST_FRAMES):
            start = time.process_time()
            self.view.window.Render()
            seconds.append(time.process_time() - start)
            if not vtkindirect.report(self.view.renderer)["counters"]["tiles_left"]:
                break
        else:
            raise SystemExit("coarse_levels.py: maps are missing")
        row.counted = self.counted() - before
        surfaces = vtkindirect.copy_buffer(self.view.renderer, "depth")[..., 0] > 0.0
        row.light = vtkindirect.copy_buffer(self.view.renderer, self.buffer)[surfaces].astype(float)
        return sum(seconds), seconds[0]


def measure(mesh: vtkPolyData, case: str, levels: Levels, rounds: int) -> dict[str, Row]:
    """Return rows of a scene."""
    itself, made, simple, everywhere = Row(), Row(), Row(), Row()
    whole = [(levels[0][0], TOO_FAR)]
    for _ in range(rounds):
        scene = Scene(mesh, case)
        scene.draw(everywhere, [(levels[-1][0], 0.0)])  # builds shaders
        _, with_making = scene.draw(made, [])
        itself.drawing.append(scene.draw(itself, whole)[0])
        spent, without_making = scene.draw(made, [])
        made.drawing.append(spent)
        made.making.append(with_making - without_making)
        simple.drawing.append(scene.draw(simple, levels)[0])
        scene.view.close()
    # Only maps with a level are counted: here those with one that is as good as the mesh.
    itself.counted = np.array((everywhere.counted[1],) * 2)
    return {"the mesh itself": itself, "the pass's": made, "the filter's": simple}


def print_rows(name: str, case: str, rows: dict[str, Row]) -> None:
    """Print a scene's rows of the table."""
    true = rows["the mesh itself"]
    full = true.counted[1]
    for kind, row in rows.items():
        # Maps without a level that is near enough have the mesh itself, and are not counted.
        drawn = (row.counted[0] + full - row.counted[1]) / full
        ratio = statistics.median(row.drawing) / statistics.median(true.drawing)
        apart = np.sqrt(np.mean((row.light - true.light) ** 2)) / true.light.mean()
        bias = row.light.mean() / true.light.mean() - 1.0
        making = f"{statistics.median(row.making):.1f}" if row.making else ""
        print(f"| {name} | {case} | {kind} | {making} | {drawn:.2f} | {ratio:.2f} | {apart:.4f} "
              f"| {bias:+.2%} |", flush=True)  # fmt: skip


def main() -> int:
    """Print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    print("| mesh | light | levels | making, s | triangles drawn | time of the maps | RMS | bias |")
    print("|---|---|---|---:|---:|---:|---:|---:|")
    for scene, part in MESHES:
        _, mesh = part_of(scene, part)
        levels, seconds = simplify(mesh)
        counts = " and ".join(f"{level.GetNumberOfPolys():,}" for level, _ in levels)
        name = f"{part}, {mesh.GetNumberOfPolys():,} triangles; filtered {counts}"
        for case in CASES:
            rows = measure(mesh, case, levels, max(given.rounds, 1))
            rows["the filter's"].making.append(seconds)
            print_rows(name, case, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
