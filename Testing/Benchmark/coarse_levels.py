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

import argparse
import statistics
import sys
import time
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import frames, metrics, references
from vtkindirect.scene import Scene

FOLDER = Path(__file__).resolve().parents[1]
SCENES = ("sky_brain", "sky_frog")
LEAST = 10_000
"""Triangles of an actor that gets levels."""
SAME = 2e-3
"""Relative difference of depths under which a pixel shows the surface that was traced."""


def counters(scene: Scene) -> dict[str, int]:
    """Return the counters of the last frame."""
    return vtkindirect.report(scene.renderer)["counters"]


def complete(scene: Scene) -> float:
    """Render until nothing is left to be drawn, and return the processor's milliseconds."""
    begin = time.process_time()
    scene.render_window.Render()
    while counters(scene).get("tiles_left"):
        scene.render_window.Render()
    return 1e3 * (time.process_time() - begin)


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


def stale(scene: Scene, way: int) -> None:
    """Move all that is dense a little, and back, so that every map is drawn again."""
    size = np.ptp(np.array(scene.bounds).reshape(3, 2), axis=1).max()
    for actor in scene.actors.values():
        if actor.GetMapper().GetInput().GetNumberOfPolys() >= LEAST:
            actor.AddPosition(1e-4 * size * way, 0.0, 0.0)


def errors(scene: Scene, stored: Path) -> tuple[str, np.ndarray]:
    """Return the cells of the sky's error, and the sky's irradiance."""
    centre = slice(references.FACTOR // 2, None, references.FACTOR)
    depth = vtkindirect.copy_buffer(scene.renderer, "depth")[centre, centre][..., 0]
    sky = vtkindirect.copy_buffer(scene.renderer, "sky")[centre, centre]
    traced = references.read_layer(stored, "depth")[..., 0]
    same = (depth > 0.0) & (np.abs(depth - traced) < SAME * traced)
    found = metrics.compare(sky, references.read_layer(stored, "S1"), same)
    return f"{found.nrmse:.4f} | {found.bias:+.2%}", np.asarray(sky[same])


def measure(name: str, shares: list[float], passes: int) -> None:
    """Print the rows of a scene."""
    stored = FOLDER / "Reference" / "data" / f"{name}.exr"
    scenes = {}
    for label in ("full", "levels"):
        scene = scenes[label] = vtkindirect.load_scene(FOLDER / "Scenes" / f"{name}.json")
        frames.open_window(scene, references.natural_size(stored))
        vtkindirect.enable(
            scene.renderer, "auto", lighting="scene", NumberOfBounces=1, SpheresInMotion=False
        )
        scene.render_window.SetDesiredUpdateRate(1e-4)
        complete(scene)
    seconds, counts = add_levels(scenes["levels"], shares)
    cells, spent, tiles = {}, {"full": [], "levels": []}, {}
    skies = {}
    for label, scene in scenes.items():
        complete(scene)
        cells[label], skies[label] = errors(scene, stored)
    for number in range(2 * passes):
        for label, scene in scenes.items():
            before = counters(scene).get("tiles_drawn", 0)
            stale(scene, 1 - 2 * (number % 2))
            spent[label].append(complete(scene))
            tiles[label] = counters(scene).get("tiles_drawn", 0) - before
    apart = np.sqrt(np.mean((skies["full"] - skies["levels"]) ** 2)) / np.mean(skies["full"])
    for label in scenes:
        print(
            f"| {name} | {label} | {counts if label == 'levels' else ''} | {cells[label]} |"
            f" {statistics.median(spent[label]):.0f} | {tiles[label]} |"
            f" {seconds if label == 'levels' else 0:.1f} |"
        )
    found = [
        entry["why"]
        for entry in vtkindirect.report(scenes["levels"].renderer)["modelled"]
        if entry["what"] == "coarse geometry in depth maps"
    ]
    print(f"{name}: apart by {apart:.4f} of the mean (RMS); {found[0]}", flush=True)
    for scene in scenes.values():
        scene.render_window.Finalize()


def main() -> int:
    """Measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=list(SCENES), metavar="SCENE")
    parser.add_argument("--shares", default="0.003", help="of the diagonal, separated by commas")
    parser.add_argument("--passes", type=int, default=2)
    given = parser.parse_args()
    print(
        "| scene | maps of | triangles | nRMSE, sky | bias | all maps, ms | tiles | levels, s |\n"
        "|---|---|---|---:|---:|---:|---:|---:|"
    )
    for name in given.scenes:
        measure(name, [float(share) for share in given.shares.split(",")], given.passes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
