# SPDX-License-Identifier: BSD-3-Clause
"""A small room with a ball for tests that compare pictures with each other."""

from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

from vtkindirect import wrapped

RED = (0.9, 0.1, 0.1)


def make_mapper(source) -> vtkPolyDataMapper:
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    return mapper


def make_actor(source, color=RED) -> vtkActor:
    made = vtkActor()
    made.SetMapper(make_mapper(source))
    made.GetProperty().SetColor(*color)
    return made


def make_ball(radius: float = 0.4) -> vtkSphereSource:
    ball = vtkSphereSource()
    ball.SetCenter(0, 0.5, 0)
    ball.SetRadius(radius)
    return ball


def make_room(prop=None, lit: bool = True) -> vtkRenderer:
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for point2 in ((-1, 0, -1), (-1, 2, 1)):
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, 0, 1)
        plane.SetPoint1(1, 0, 1)
        plane.SetPoint2(*point2)
        renderer.AddActor(make_actor(plane, (0.8, 0.8, 0.8)))
    if prop:
        renderer.AddViewProp(prop)
    if lit:
        light = vtkLight()
        light.SetPositional(True)
        light.SetPosition(1, 2, -2)
        light.SetFocalPoint(0, 0, 0)
        light.SetConeAngle(40)
        light.SetLightTypeToSceneLight()
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1, 1.5, -4)
    camera.SetFocalPoint(0, 0.5, 0)
    camera.SetClippingRange(1, 10)
    return renderer


def make_area(x: float, radiance=(4, 4, 4)):
    light = wrapped.get("vtkAreaLight")()
    light.SetOrigin(x - 0.3, 1.9, -0.3)
    light.SetPoint1(x + 0.3, 1.9, -0.3)
    light.SetPoint2(x - 0.3, 1.9, 0.3)
    light.SetRadiance(*radiance)
    return light
