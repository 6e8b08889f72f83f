# SPDX-License-Identifier: BSD-3-Clause
"""The channels that a pass prints can be copied, are as it says, and stand on the guide's page."""

import re
import unittest

import numpy as np
import support
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
)

from vtkindirect import windows, wrapped

ROW = re.compile(r"^\s+(\S+): (.+) \((.+), (\d) components?\)$")


def printed() -> dict[str, int]:
    """Return the names and numbers of components that the pass prints."""
    lines = str(wrapped.get("vtkIndirectIlluminationPass")()).splitlines()
    start = next(i for i, line in enumerate(lines) if line.strip() == "Buffers:")
    rows = {}
    for line in lines[start + 1 :]:
        match = ROW.match(line)
        if not match:
            break
        rows[match[1]] = int(match[4])
    return rows


class Buffers(unittest.TestCase):
    def test_the_page_has_each(self):
        text = (support.SOURCE / "Documentation" / "guide.md").read_text(encoding="utf-8")
        rows = printed()
        self.assertGreater(len(rows), 12)
        for name in rows:
            self.assertIn(f"`{name}`", text)

    def test_each_can_be_copied(self):
        why = support.why_no_rendering()
        if why:
            self.skipTest(why)
        sphere = vtkSphereSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetSpecular(0.5)
        light = vtkLight()
        light.SetPosition(1, 1, 1)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        renderer.AddLight(light)
        window = windows.render_window((32, 24))
        window.AddRenderer(renderer)
        illumination = wrapped.get("vtkIndirectIlluminationPass")()
        renderer.SetPass(illumination)
        window.Render()
        image = vtkImageData()
        for name, components in printed().items():
            self.assertTrue(illumination.CopyBuffer(name.replace("<i>", "0"), image), name)
            self.assertEqual(image.GetNumberOfScalarComponents(), components, name)
        # A row a light: direction, exponent; flux. The sphere's specular power is VTK's default.
        self.assertTrue(illumination.CopyBuffer("lights", image))
        lights = image.GetDimensions()[1]
        self.assertTrue(illumination.CopyBuffer("lobes", image))
        self.assertEqual(image.GetDimensions(), (2, lights, 1))
        lobes = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(lights, 2, 4)
        lit = lobes[:, 1, 0] > 0.0
        self.assertTrue(lit.any())
        lengths = np.linalg.norm(lobes[lit, 0, :3], axis=1)
        self.assertLess(abs(lengths - 1.0).max(), 1e-5)
        self.assertTrue((lobes[lit, 0, 3] <= actor.GetProperty().GetSpecularPower() + 1e-3).all())
        renderer.SetPass(None)
        window.Finalize()
