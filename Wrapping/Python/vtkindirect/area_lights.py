# SPDX-License-Identifier: BSD-3-Clause
"""Light from rectangles: making it for a scene file, and where a renderer keeps it.

A renderer keeps its area lights in VTK's information about it, as it does its environment:
`vtkindirect.enable` finds them there, and they go when the renderer goes.
"""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkRenderingCore import vtkRenderer

from vtkindirect import environments, wrapped

CLASS = "vtkAreaLight"


def attach(renderer: vtkRenderer, light: Any) -> None:
    """Add a vtkAreaLight to those of a renderer."""
    key = wrapped.get(CLASS).AREA_LIGHTS()
    lights = renderer.GetInformation().Get(key)
    if lights is None:
        lights = vtkCollection()
        renderer.GetInformation().Set(key, lights)
    lights.AddItem(light)


def attached(renderer: vtkRenderer) -> list[Any]:
    """Return the vtkAreaLights of a renderer."""
    if not wrapped.has(CLASS):
        return []
    lights = renderer.GetInformation().Get(wrapped.get(CLASS).AREA_LIGHTS())
    if lights is None:
        return []
    return [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]


def detach_all(renderer: vtkRenderer) -> None:
    """Take those of a renderer away; a pass that has them keeps them."""
    if wrapped.has(CLASS):
        renderer.GetInformation().Remove(wrapped.get(CLASS).AREA_LIGHTS())


def build(values: dict[str, Any]) -> Any:
    """Return the vtkAreaLight of a checked light of a scene file; `texture` is a whole path."""
    light = wrapped.get(CLASS)()
    light.SetOrigin(values["origin"])
    light.SetPoint1(values["point1"])
    light.SetPoint2(values["point2"])
    light.SetRadiance(values["radiance"])
    light.SetTwoSided(values["two_sided"])
    light.SetVisible(values["visible"])
    methods = ("automatic", "closed_form", "virtual_lights")
    light.SetMethod(methods.index(values["method"]))
    if "texture" in values:
        light.SetImage(environments.read_picture(values["texture"]))
    return light
