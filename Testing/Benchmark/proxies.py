#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of spheres in the place of real data, as a table, and a picture of them.

    Testing/Benchmark/proxies.py                  the table of Documentation/methods/sphere-proxies.md
    Testing/Benchmark/proxies.py --picture FILE   the picture of the gallery

Python finds the package by PYTHONPATH, as with the other programs here. Lengths are shares of the
diagonal of a mesh's bounds, volumes of what it encloses; times are the processor's.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import images
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SCENES = Path(__file__).resolve().parents[1] / "Scenes"
LEAST_TRIANGLES = 500
"""Planes and the like have no part in it."""


def meshes_of(scene: vtkindirect.Scene) -> Iterator[tuple[str, vtkActor, vtkPolyData]]:
    """Yield what stands for data: name, actor, mesh."""
    for name, actor in scene.actors.items():
        actor.GetMapper().Update()
        mesh = actor.GetMapper().GetInput()
        if mesh.GetNumberOfPolys() >= LEAST_TRIANGLES:
            yield name, actor, mesh


def fit(mesh: vtkPolyData, number: int) -> vtkindirect.vtkSphereProxyFilter:
    """Return the filter after its work."""
    spheres = vtkindirect.vtkSphereProxyFilter()
    spheres.SetInputData(mesh)
    spheres.SetNumberOfSpheres(number)
    spheres.Update()
    return spheres


def row(name: str, mesh: vtkPolyData, number: int) -> str:
    """Return a line of the table."""
    start = time.process_time()
    spheres = fit(mesh, number)
    spent = time.process_time() - start
    length = mesh.GetLength()
    volume = spheres.GetSolidVolume()
    return (
        f"| {name} | {mesh.GetNumberOfPolys():,} | {spheres.GetOutput().GetNumberOfPoints()} "
        f"| {spheres.GetRootMeanSquareError() / length:.2%} | {spheres.GetError() / length:.2%} "
        f"| {spheres.GetMaximumGap() / length:.2%} | {spheres.GetCoveredArea():.1%} "
        f"| {spheres.GetCoveredVolume():.1%} | {spheres.GetProtrudingVolume() / volume:.1%} "
        f"| {spent:.1f} |"
    )


def table() -> None:
    """Print the table."""
    print(
        "| mesh | triangles | spheres | RMS | sticks out | largest gap | area | volume "
        "| outside | s |\n|---|---|---|---|---|---|---|---|---|---|"
    )
    for scene in ("brain", "frog"):
        loaded = vtkindirect.load_scene(SCENES / f"{scene}.json")
        for name, _, mesh in meshes_of(loaded):
            for number in (200, 1000):
                print(row(name, mesh, number), flush=True)


def picture(path: Path) -> None:
    """Draw the frog's organs, and beside them 200 spheres for each."""
    found = []
    for number in (0, 200):
        scene = vtkindirect.load_scene(SCENES / "frog.json")
        for _, actor, mesh in meshes_of(scene) if number else ():
            glyphs = vtkGlyph3D()
            glyphs.SetInputData(fit(mesh, number).GetOutput())
            ball = vtkSphereSource()
            ball.SetRadius(1.0)
            ball.SetThetaResolution(16)
            ball.SetPhiResolution(12)
            glyphs.SetSourceConnection(ball.GetOutputPort())
            glyphs.SetScaleModeToScaleByScalar()
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(glyphs.GetOutputPort())
            mapper.ScalarVisibilityOff()
            actor.SetMapper(mapper)
        window = scene.make_window()
        window.SetSize(400, 300)
        vtkindirect.enable(scene, lighting="full")
        window.Render()
        found.append(images.window_bytes(window))
        window.Finalize()
    gap = np.full((found[0].shape[0], 4, 3), 255, dtype=np.uint8)
    images.write_png(path, np.hstack([found[0], gap, found[1]]))


def main() -> int:
    """Print the table or draw the picture; returns the exit code."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("--picture", type=Path, metavar="FILE")
    words = parser.parse_args()
    if words.picture:
        picture(words.picture)
    else:
        table()
    return 0


if __name__ == "__main__":
    sys.exit(main())
