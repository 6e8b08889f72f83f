#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What stands between virtual lights and receivers: voxels and depth maps beside spheres.

    Testing/Benchmark/sphere_blockers.py [--frames] [--program build/bin/IndirectBlockersBenchmark]

Spheres that move, and meshes for which spheres of vtkSphereProxyFilter stand. 400 receivers that an
eye sees and 256 places that a light sees, all pairs that face each other, as a gather sums them;
held to the true geometry in double precision. All are C++ of one process and one thread: the
library's own voxels and its own kernels. A second table has the same sums in shaders, for 128 x 128
receivers of a picture, the processor's time of all threads: compare within a scene. With --frames
instead what depth maps cost in whole frames of a lamp's bounce. Prints tables for
Documentation/methods/sphere-proxies.md.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import vtkindirect
from proxies import fit
from proxy_pass import FOLDER, Moving, in_turn, particles, protein, with_lamp
from vtkindirect import methods
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

PROGRAM = FOLDER.parent / "build" / "bin" / "IndirectBlockersBenchmark"
HEAD = """\
| scene | by | let through | taken away | light of wrong answers | bias | nRMSE | ns a segment \
| build, ms | frame, ms |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|"""

SHADER_HEAD = """
| scene | by | picture, ms | ns a segment | bias |
|---|---|---:|---:|---:|"""


def triangles_of(scene: str, part: str) -> vtkPolyData:
    """Return the mesh of an actor."""
    actor = vtkindirect.load_scene(FOLDER / "Scenes" / f"{scene}.json").actors[part]
    actor.GetMapper().Update()
    triangles = vtkTriangleFilter()
    triangles.SetInputData(actor.GetMapper().GetInput())
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    return triangles.GetOutput()


def proxies_of(mesh: vtkPolyData, number: int) -> np.ndarray:
    """Return the spheres that stand for a mesh: x, y, z, radius."""
    output = fit(mesh, number).GetOutput()
    radii = vtk_to_numpy(output.GetPointData().GetArray("Radius"))
    return np.c_[vtk_to_numpy(output.GetPoints().GetData()), radii]


def rows(
    program: Path,
    name: str,
    spheres: np.ndarray,
    mesh: vtkPolyData | None = None,
    *options: str,
) -> str:
    """Return the table's rows of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / "spheres", Path(folder) / "triangles"]
        spheres.astype(np.float64).tofile(files[0])
        if mesh is None:
            files.pop()
        else:
            points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(np.float64)
            corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
            points[corners].tofile(files[1])
        run = [str(program), name, *map(str, files), *options]
        return subprocess.run(run, check=True, stdout=subprocess.PIPE, text=True).stdout


class Turning(Moving):
    """Spheres that stay while the camera turns."""

    def frame(self, number: int) -> float:
        """Turn, render, and return the processor's milliseconds."""
        self.view.renderer.GetActiveCamera().Azimuth(0.5 if number % 2 else -0.5)
        start = time.process_time()
        self.view.window.Render()
        return 1e3 * (time.process_time() - start)


def frames(scenes: dict[str, np.ndarray]) -> None:
    """Print what visibility adds to frames of 512 x 512: depth maps, over frames without any."""
    print("| scene | look-ups alone | all maps drawn again | 15 frames a second asked for |")
    print("|---|---:|---:|---:|")
    for name, spheres in scenes.items():
        kinds = {}
        for label, kind, rate in (
            ("turning", Turning, None),
            ("exact", Moving, None),
            ("awaited", Moving, 15.0),
        ):
            for visible in ("none", "maps"):
                moving = with_lamp(kind(spheres, (512, 512)))
                indirect = methods.enable(moving.view.renderer, "multiresolution")
                if visible == "none":
                    indirect.SetVisibilityToNone()
                if rate:
                    moving.view.window.SetDesiredUpdateRate(rate)
                moving.view.window.Render()
                kinds[f"{label}, {visible}"] = moving
        spent = in_turn(kinds, 5)
        added = [
            f"{spent[f'{label}, maps'] - spent[f'{label}, none']:.0f}"
            for label in ("turning", "exact", "awaited")
        ]
        print(f"| {name} | {' | '.join(added)} |", flush=True)
        for moving in kinds.values():
            moving.view.close()


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--frames", action="store_true")
    arguments = parser.parse_args()
    scenes = {"protein": protein()}
    scenes |= {f"{count:,} particles": particles(count) for count in (1000, 5000)}
    if arguments.frames:
        frames(scenes)
        return 0
    print(HEAD)
    for name, spheres in scenes.items():
        print(rows(arguments.program, name, spheres), end="", flush=True)
    for scene, part, number in (("brain", "cortex", 1000), ("frog", "liver", 256)):
        mesh = triangles_of(scene, part)
        spheres = proxies_of(mesh, number)
        print(rows(arguments.program, part, spheres, mesh), end="", flush=True)
    print(SHADER_HEAD)
    for name, spheres in scenes.items():
        print(rows(arguments.program, name, spheres, None, "--shaders"), end="", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
