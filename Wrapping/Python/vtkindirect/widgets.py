# SPDX-License-Identifier: BSD-3-Clause
"""Keeps the handles of PyVista's 3D widgets out of the lights' maps.

VTK's older 3D widgets, which PyVista uses, put actors into the renderer like any others. Their
property tells them: a widget has methods that return the properties of its actors.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkRenderingCore import vtkProperty, vtkRenderer

from vtkindirect import wrapped


def _widgets(renderer: vtkRenderer) -> list[Any]:
    """Return the widgets of the plotter that a renderer belongs to, if that is PyVista's."""
    attributes = getattr(getattr(renderer, "parent", None), "__dict__", {})
    lists = [found for name, found in attributes.items() if name.endswith("_widgets")]
    return [
        widget
        for found in lists
        if isinstance(found, list)
        for widget in found
        if hasattr(widget, "IsA") and widget.IsA("vtk3DWidget")
    ]


@cache
def _getters(kind: type) -> tuple[str, ...]:
    """Return the methods of a class of widgets by which it tells its properties."""
    return tuple(name for name in dir(kind) if re.fullmatch(r"Get\w*Property", name))


def _properties(widget: Any) -> Iterator[vtkProperty]:
    for name in _getters(type(widget)):
        found = getattr(widget, name)()
        if isinstance(found, vtkProperty):
            yield found


def leave_out_of_maps(renderer: vtkRenderer) -> None:
    """Give the actors of all widgets the property key CASTS_SHADOWS with the value 0.

    An actor that has the key already keeps its value.
    """
    widgets = _widgets(renderer)
    if not widgets:
        return
    key = wrapped.get("vtkIndirectIlluminationPass").CASTS_SHADOWS()
    of_widgets = {found for widget in widgets for found in _properties(widget)}
    actors = renderer.GetActors()
    for index in range(actors.GetNumberOfItems()):
        actor = actors.GetItemAsObject(index)
        if actor.GetProperty() not in of_widgets:
            continue
        keys = actor.GetPropertyKeys()
        if keys is None:
            keys = vtkInformation()
            actor.SetPropertyKeys(keys)
        if not keys.Has(key):
            keys.Set(key, 0)
