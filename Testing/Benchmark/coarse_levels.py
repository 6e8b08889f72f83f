#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Depth maps of the sky with coarse levels and without: triangles, time and error.

    Testing/Benchmark/coarse_levels.py [SCENE...] [--shares S,S] [--passes N]

Scenes have references by path tracing (S1). Levels are vtkMeshSimplificationFilter's, within these
shares of each mesh's diagonal, of actors of 10,000 triangles and more; what it takes to make them
is the column `levels, s`. Times are the processor's, of all frames until the picture is complete
after all maps have become stale, with and without levels in turn, and the difference of both over
the tiles drawn. Prints a table for Documentation/methods/sphere-proxies.md.
"""

from __future__ import annotations

import statistics
import sys
import time

import numpy as np
import vtkindirect
from traced import Traced, parser
from vtkindirect.scene import Scene

SCENES = ("sky_brain", "sky_frog")
LEAST = 10_000
"""Triangles of an actor that gets levels."""


def add_levels(scene: Scene, shares: list[float]) -> tuple[float, str]:
    """Give dense actors levels; return the seconds it took, and their triangles."""
    begin = time.process_time()
    counts = []
    for actor in scene.actors.values():
        mesh = actor.GetMapper().GetInput()
        if mesh.GetNumberOfPolys() < LEAST:
            continue
        of_mesh = [str(mesh.GetNumberOfPolys())]
        for share in shares:
            simple = vtkindirect.vtkMeshSimplificationFilter()
            simple.SetInputData(mesh)
            simple.SetMaximumError(share)
            simple.Update()
            level = simple.GetOutput()
            of_mesh.append(str(level.GetNumberOfPolys()))
            vtkindirect.pass_of(scene.renderer).AddCoarseLevel(
                actor, level, simple.GetMaximumDistance()
            )
        counts.append(" > ".join(of_mesh))
    return time.process_time() - begin, ", ".join(counts)


def stale(traced: Traced, way: int) -> None:
    """Move all that is dense a little, and back, so that every map is drawn again."""
    for actor in traced.scene.actors.values():
        if actor.GetMapper().GetInput().GetNumberOfPolys() >= LEAST:
            actor.AddPosition(1e-4 * traced.length() * way, 0.0, 0.0)


def measure(name: str, shares: list[float], passes: int) -> None:
    """Print the rows of a scene."""
    scenes = {}
    for label in ("full", "levels"):
        scenes[label] = Traced(name)
        settings = {"NumberOfBounces": 1, "SpheresInMotion": False}
        vtkindirect.enable(scenes[label].renderer, "auto", lighting="scene", **settings)
        scenes[label].window.SetDesiredUpdateRate(1e-4)
        scenes[label].complete()
    seconds, counts = add_levels(scenes["levels"].scene, shares)
    cells, spent, tiles = {}, {"full": [], "levels": []}, {}
    skies = {}
    for label, traced in scenes.items():
        traced.complete()
        found = traced.errors("sky")
        cells[label] = f"{found.nrmse:.4f} | {found.bias:+.2%}"
        skies[label] = traced.buffer("sky")[traced.same()]
    for number in range(2 * passes):
        for label, traced in scenes.items():
            before = traced.counters().get("tiles_drawn", 0)
            stale(traced, 1 - 2 * (number % 2))
            spent[label].append(traced.complete())
            tiles[label] = traced.counters().get("tiles_drawn", 0) - before
    apart = np.sqrt(np.mean((skies["full"] - skies["levels"]) ** 2)) / np.mean(skies["full"])
    for label in scenes:
        print(
            f"| {name} | {label} | {counts if label == 'levels' else ''} | {cells[label]} |"
            f" {statistics.median(spent[label]):.0f} | {tiles[label]} |"
            f" {seconds if label == 'levels' else 0:.1f} |"
        )
    said = [
        entry["why"]
        for entry in vtkindirect.report(scenes["levels"].renderer)["modelled"]
        if entry["what"] == "coarse geometry in depth maps"
    ]
    print(f"{name}: apart by {apart:.4f} of the mean (RMS); {said[0]}", flush=True)
    for traced in scenes.values():
        traced.window.Finalize()


def main() -> int:
    """Measure, print."""
    options = parser(__doc__, SCENES)
    options.add_argument("--shares", default="0.003", help="of the diagonal, separated by commas")
    options.add_argument("--passes", type=int, default=2)
    given = options.parse_args()
    print(
        "| scene | maps of | triangles | nRMSE, sky | bias | all maps, ms | tiles | levels, s |\n"
        "|---|---|---|---:|---:|---:|---:|---:|"
    )
    for name in given.scenes:
        measure(name, [float(share) for share in given.shares.split(",")], given.passes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
