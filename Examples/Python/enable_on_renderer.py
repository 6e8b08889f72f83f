#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A white sphere in a red and a green corner, with indirect light: one line on top of plain VTK.

Writes enable_on_renderer.png; with a display it shows the window too.
"""

from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)

import vtkindirect

renderer = vtkRenderer()
window = vtkindirect.render_window((640, 480))
window.AddRenderer(renderer)


def add(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)


def plane(point1, point2):
    source = vtkPlaneSource()
    source.SetOrigin(0, 0, 0)
    source.SetPoint1(point1)
    source.SetPoint2(point2)
    return source


sphere = vtkSphereSource()
sphere.SetCenter(0.6, 0.4, 0.6)
sphere.SetRadius(0.4)
sphere.SetThetaResolution(64)
sphere.SetPhiResolution(64)
add(sphere, (0.9, 0.9, 0.9))
add(plane((0, 0, 2), (2, 0, 0)), (0.9, 0.9, 0.9))  # floor
add(plane((0, 2, 0), (0, 0, 2)), (0.9, 0.1, 0.1))  # left wall
add(plane((2, 0, 0), (0, 2, 0)), (0.1, 0.7, 0.1))  # back wall

lamp = vtkLight()
lamp.PositionalOn()
lamp.SetPosition(1.9, 1.9, 1.3)
lamp.SetFocalPoint(0.5, 0.4, 0.5)
lamp.SetConeAngle(40)
lamp.SetExponent(0)
renderer.AddLight(lamp)
renderer.GetActiveCamera().SetPosition(4.2, 2.6, 4.6)
renderer.GetActiveCamera().SetFocalPoint(0.8, 0.7, 0.8)
renderer.ResetCameraClippingRange()

vtkindirect.enable(renderer)

window.Render()
picture = vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetFileName("enable_on_renderer.png")
writer.SetInputConnection(picture.GetOutputPort())
writer.Write()
if vtkindirect.has_display():
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.Start()
