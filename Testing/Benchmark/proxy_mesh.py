#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The published rates of Sloan et al. 2007 (figures 6, 7, 9) on a mesh of 60,000 vertices.

    Testing/Benchmark/proxy_mesh.py [--vertices N] [--spheres N] [--size N] [--frames N]

A cortex in a uniform sky, hidden by 60 spheres of vtkSphereProxyFilter, which turns a little in
every frame. Per vertex, as in figure 6: a vertex program with the library's own kernels and the
same spheres, whose irradiance VTK's mapper interpolates; beside receivers in image space. Neither
has groups of spheres. Prints a table for Documentation/methods/sphere-proxies.md: the processor's
time of all threads, of frames of each kind in turn; compare within one run.
"""

from __future__ import annotations

import argparse
import re
import statistics
import sys
import time
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import methods
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkQuadricDecimation, vtkTriangleFilter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

FOLDER = Path(__file__).resolve().parents[1]
LIBRARY = FOLDER.parent / "Module" / "Rendering" / "glsl" / "lib"
TABLE = FOLDER.parent / "Module/Rendering/Private/Proxies/vtkIndirectProxyTable.h"
VERTICES, SPHERES = 60_767, 60
"""As in the paper's figure 6; how many spheres it had there it does not say."""
REACH = 15.0
"""`InfluenceScale`, the paper's."""
LIGHT_REACH = 4.0
"""`IndirectInfluenceScale`, the same."""
RADIANCE = 0.8
"""Of the sky: less than what a window can show."""
WARM_UP = 2


# The scene ---------------------------------------------------------------------------------------


def cortex(vertices: int) -> vtkPolyData:
    """Return the cortex of the scene brain with about as many vertices, and smooth normals."""
    loaded = vtkindirect.load_scene(FOLDER / "Scenes" / "brain.json")
    mapper = loaded.actors["cortex"].GetMapper()
    mapper.Update()
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mapper.GetInput())
    triangles.Update()
    whole = triangles.GetOutput().GetNumberOfPoints()
    fewer = vtkQuadricDecimation()
    fewer.SetInputConnection(triangles.GetOutputPort())
    fewer.SetTargetReduction(max(0.0, 1.0 - vertices / whole))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(fewer.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    mesh = normals.GetOutput()
    kept = vtkPolyData()
    kept.SetPoints(mesh.GetPoints())
    kept.SetPolys(mesh.GetPolys())
    kept.GetPointData().SetNormals(mesh.GetPointData().GetNormals())
    return kept


def spheres_of(mesh: vtkPolyData, count: int) -> vtkPolyData:
    """Return at most as many spheres in place of a mesh."""
    made = vtkindirect.vtkSphereProxyFilter()
    made.SetInputData(mesh)
    made.SetNumberOfSpheres(count)
    made.Update()
    return made.GetOutput()


class View:
    """The mesh in a window; it turns in every frame."""

    def __init__(self, mesh: vtkPolyData, size: int) -> None:
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.SetOrigin(*mesh.GetCenter())
        self.renderer.AddActor(self.actor)
        camera = self.renderer.GetActiveCamera()
        camera.SetViewUp(0.0, 0.0, 1.0)
        middle = np.array(mesh.GetCenter())
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + mesh.GetLength() * np.array((-1.0, 0.8, 0.4))))
        camera.SetViewAngle(26.0)
        self.renderer.ResetCameraClippingRange()
        self.window = vtkindirect.render_window((size, size))
        self.window.AddRenderer(self.renderer)

    def frame(self, number: int) -> float:
        """Turn, render, and return the processor's milliseconds."""
        self.actor.SetOrientation(0.0, 0.0, 0.5 * (number % 7))
        begin = time.process_time()
        self.window.Render()
        return 1e3 * (time.process_time() - begin)

    def picture(self) -> np.ndarray:
        """Return what the window shows of the first frame, 0 to 1."""
        self.frame(0)
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1) / 255.0


def by_pixels(view: View, spheres: vtkPolyData, **settings: object) -> View:
    """Sum in image space."""
    found = methods.enable(
        view.renderer,
        "proxies",
        environment=(RADIANCE,) * 3,
        groups=False,
        influence_scale=REACH,
        indirect_influence_scale=LIGHT_REACH,
        **settings,
    )
    found.GetEstimator().SetProxies(view.actor, spheres)
    view.window.SetDesiredUpdateRate(15.0)
    return view


# Per vertex --------------------------------------------------------------------------------------


def kernel_text(name: str, known: set[str] | None = None) -> str:
    """Return a file of the library with what it includes."""
    known = set() if known is None else known
    if name in known:
        return ""
    known.add(name)
    lines = []
    for line in (LIBRARY / name).read_text(encoding="utf-8").splitlines():
        include = re.match(r'#include "(.*)"', line)
        lines.append(kernel_text(include[1], known) if include else line)
    return "\n".join(lines)


def vectors(name: str, rows: np.ndarray) -> str:
    """Return a GLSL constant of four-component vectors."""
    texts = ", ".join(f"vec4({', '.join(f'{value:.9g}' for value in row)})" for row in rows)
    return f"const vec4 {name}[{len(rows)}] = vec4[{len(rows)}]({texts});"


def table() -> np.ndarray:
    """Return the zonal logarithms that the pass has."""
    rows = re.findall(r"^  \{(.*)\},$", TABLE.read_text(encoding="ascii"), re.MULTILINE)
    return np.array([[float(value.rstrip("f")) for value in row.split(",")] for row in rows])


SUM = """
vec4 zonalLog(float sine)
{
  float place = vtkiProxyRow(sine) * float(TABLE.length() - 1);
  int row = min(int(place), TABLE.length() - 2);
  return vtkiProxyRow(sine) * mix(TABLE[row], TABLE[row + 1], place - float(row));
}

// What vtkIndirectProxySum.glsl does of a receiver, without bounce and polygons.
vec3 irradianceOf(vec3 place, vec3 normal)
{
  vtkiHarmonics4 hidden = vtkiHarmonics4(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  for (int i = 0; i < SPHERES.length(); ++i)
  {
    vec4 sphere = SPHERES[i];
    vec3 toCenter = sphere.xyz - place;
    float d = length(toCenter);
    float weight = vtkiProxyWithin(d, REACH * sphere.w);
    float sine = vtkiProxySine(toCenter, sphere.w, normal, false);
    if (weight > 0.0 && sine > 0.0)
    {
      hidden = vtkiHarmonicsAdd(hidden, weight, vtkiZonalTo(zonalLog(sine), toCenter / d));
    }
  }
  vtkiHarmonics4 seen = vtkiHarmonicsExp(hidden);
  vec3 irradiance;
  for (int color = 0; color < 3; ++color)
  {
    vtkiHarmonics4 light = vtkiHarmonics4(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (int i = 0; i < 9; ++i)
    {
      int row = 36 * color + 4 * i;
      float value = vtkiHarmonicsDot(
        vtkiHarmonics4(LIGHT[row], LIGHT[row + 1], LIGHT[row + 2], LIGHT[row + 3]), seen);
      if (i < 4) light.A[i] = value;
      else if (i < 8) light.B[i - 4] = value;
      else light.C.x = value;
    }
    irradiance[color] = max(vtkiHarmonicsDot(light, vtkiClampedCosine(normal)), 0.0);
  }
  return irradiance;
}
"""


def by_vertices(view: View, spheres: vtkPolyData) -> View:
    """Sum in the mapper's vertex program, in the mesh's own coordinates, under a uniform sky.

    A uniform sky multiplies by a constant; the sums are those of any sky all the same.
    """
    radii = vtk_to_numpy(spheres.GetPointData().GetArray("Radius"))
    rows = np.c_[vtk_to_numpy(spheres.GetPoints().GetData()), radii]
    light = np.tile(np.eye(9, 16).reshape(36, 4), (3, 1)) * RADIANCE
    text = "\n".join(
        (
            kernel_text("vtkIndirectLibSphereProxy.glsl"),
            kernel_text("vtkIndirectLibProxyRegion.glsl"),
            vectors("SPHERES", rows),
            vectors("TABLE", table()),
            vectors("LIGHT", light),
            f"const float REACH = {REACH};",
            SUM,
            "in vec3 normalMC;\nout vec3 irradianceVSOutput;",
        )
    )
    view.actor.GetMapper().SetVBOShiftScaleMethod(0)  # vertices as they are
    shader = view.actor.GetShaderProperty()
    shader.AddVertexShaderReplacement(
        "//VTK::Normal::Dec", True, f"{text}\n//VTK::Normal::Dec", False
    )
    shader.AddVertexShaderReplacement(
        "//VTK::Normal::Impl",
        True,
        "//VTK::Normal::Impl\n"
        "  irradianceVSOutput = irradianceOf(vertexMC.xyz, normalize(normalMC));",
        False,
    )
    shader.AddFragmentShaderReplacement(
        "//VTK::Normal::Dec", True, "//VTK::Normal::Dec\nin vec3 irradianceVSOutput;", False
    )
    shader.AddFragmentShaderReplacement(
        "//VTK::Light::Impl",
        True,
        "//VTK::Light::Impl\n  gl_FragData[0] = vec4(irradianceVSOutput, 1.0);",
        False,
    )
    return view


# The table ---------------------------------------------------------------------------------------


def difference(one: np.ndarray, other: np.ndarray) -> float:
    """Return the RMS difference of two pictures over the mean, of pixels that both have."""
    both = (one.max(axis=-1) > 0.0) & (other.max(axis=-1) > 0.0)
    apart = (one - other)[both]
    return float(np.sqrt((apart**2).mean()) / other[both].mean())


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--vertices", type=int, default=VERTICES)
    parser.add_argument("--spheres", type=int, default=SPHERES)
    parser.add_argument("--size", type=int, default=1024)
    parser.add_argument("--frames", type=int, default=7)
    given = parser.parse_args()
    mesh = cortex(given.vertices)
    spheres = spheres_of(mesh, given.spheres)
    count, vertices = spheres.GetNumberOfPoints(), mesh.GetNumberOfPoints()

    def view() -> View:
        return View(mesh, given.size)

    per_vertex = f"per vertex, {vertices:,}"
    kinds = {"vtk": view(), per_vertex: by_vertices(view(), spheres)}
    for step in (1, 2, 4, 8):
        name = f"1/{step * step} of the pixels" if step > 1 else "all pixels"
        kinds[name] = by_pixels(view(), spheres, receiver_step=step, indirect_light="off")
    for light in ("averaged", "shadowed"):
        kinds[f"1/16, {light} light"] = by_pixels(
            view(), spheres, receiver_step=4, indirect_light=light
        )
    spent: dict[str, list[float]] = {name: [] for name in kinds}
    for number in range(given.frames + WARM_UP):
        for name, kind in kinds.items():
            took = kind.frame(number)
            if number >= WARM_UP:
                spent[name].append(took)
    found = {name: statistics.median(values) for name, values in spent.items()}
    every = kinds["all pixels"].picture()
    base = found["all pixels"]
    added = {name: value - found["vtk"] for name, value in found.items()}
    print(
        f"{count} spheres, {given.size} x {given.size}; {100 * (every.max(-1) > 0).mean():.0f} % of"
        f" the pixels; VTK alone {found['vtk']:.0f} ms\n\n"
        "| receivers | frame, ms | added, ms | frame rate over that of all pixels "
        "| of what is added | difference to all pixels |\n|---|---:|---:|---:|---:|---:|"
    )
    for name, value in found.items():
        if name != "vtk":
            apart = "" if "light" in name else f"{difference(kinds[name].picture(), every):.3f}"
            print(
                f"| {name} | {value:.0f} | {added[name]:.0f} | {base / value:.1f} |"
                f" {added['all pixels'] / added[name]:.1f} | {apart} |"
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
