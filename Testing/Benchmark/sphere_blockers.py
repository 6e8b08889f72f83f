#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What stands between virtual lights and receivers: voxels and depth maps beside spheres.

    Testing/Benchmark/sphere_blockers.py [--program build/bin/IndirectBlockersBenchmark]
    Testing/Benchmark/sphere_blockers.py --frames [--method gather] [--edge 256]

Spheres that move, and meshes for which spheres of vtkSphereProxyFilter stand. 400 receivers that an
eye sees and 256 places that a light sees, all pairs that face each other, as a gather sums them;
held to the true geometry in double precision. All are C++ of one process and one thread: the
library's own voxels and its own kernels. A second table has the same sums in shaders, for 128 x 128
receivers of a picture, the processor's time of all threads: compare within a scene. With --frames
instead what depth maps, spheres (Visibility voxels) and voxels of the same spheres as meshes cost in
whole frames of a lamp's bounce. Prints tables for
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
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

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


def baked(moving: Moving) -> Moving:
    """Draw the spheres as meshes of 120 triangles, which voxels can hold."""
    ball = vtkSphereSource()
    ball.SetRadius(1.0)
    ball.SetThetaResolution(12)
    ball.SetPhiResolution(7)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(moving.data)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.SetInputArrayToProcess(0, 0, 0, 0, "size")
    glyphs.SetScaleFactor(1.0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(glyphs.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actors = moving.view.renderer.GetActors()
    for i in range(actors.GetNumberOfItems()):
        actor = actors.GetItemAsObject(i)
        if actor.GetMapper().GetInputDataObject(0, 0) is moving.data:
            actor.SetMapper(mapper)
    return moving


def frames(scenes: dict[str, np.ndarray], method: str, edge: int) -> None:
    """Print what visibility adds to frames of a lamp's bounce, over the same without any."""
    print("| scene | by | camera turns | all moves |")
    print("|---|---|---:|---:|")
    ways = {
        "depth maps": (False, "Maps"),
        "spheres": (False, "Voxels"),
        "voxels of meshes": (True, "Voxels"),
    }
    for name, spheres in scenes.items():
        kinds = {}
        for kind in (Turning, Moving):
            for meshes in (False, True):
                for visible in ("None", "Voxels") if meshes else ("None", "Maps", "Voxels"):
                    moving = with_lamp(kind(spheres, (edge, edge)))
                    moving = baked(moving) if meshes else moving
                    indirect = methods.enable(moving.view.renderer, method)
                    getattr(indirect, f"SetVisibilityTo{visible}")()
                    moving.view.window.Render()
                    kinds[f"{kind.__name__}, {meshes}, {visible}"] = moving
        spent = in_turn(kinds, 5)
        for by, (meshes, visible) in ways.items():
            added = [
                spent[f"{kind.__name__}, {meshes}, {visible}"]
                - spent[f"{kind.__name__}, {meshes}, None"]
                for kind in (Turning, Moving)
            ]
            print(f"| {name} | {by} | {added[0]:.0f} | {added[1]:.0f} |", flush=True)
        for moving in kinds.values():
            moving.view.close()


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--frames", action="store_true")
    parser.add_argument("--method", default="gather")
    parser.add_argument("--edge", type=int, default=256)
    arguments = parser.parse_args()
    scenes = {"protein": protein()}
    scenes |= {f"{count:,} particles": particles(count) for count in (1000, 5000)}
    if arguments.frames:
        frames(scenes, arguments.method, arguments.edge)
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
