# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a scene file itself: short names for VTK's sources, or any by its class.

One row of `SOURCES` is one short name: the source that it stands for and filters after it, with
``$key`` where the actor's own keys go.
"""

from __future__ import annotations

import math
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform

from vtkindirect import objects
from vtkindirect.schema import member

Values = dict[str, Any]

_CYLINDER = {"Radius": "$radius", "Height": "$height", "Resolution": "$resolution"}
_TURN = {"vtkTransformPolyDataFilter": {"Transform": "$turn"}}

SOURCES: dict[str, Values] = {
    "plane": {
        "vtkPlaneSource": {
            "Origin": "$origin",
            "Point1": "$point1",
            "Point2": "$point2",
            "XResolution": "$columns",
            "YResolution": "$rows",
        }
    },
    "box": {"vtkCubeSource": {"Bounds": "$bounds"}},
    "sphere": {
        "vtkSphereSource": {
            "Center": "$center",
            "Radius": "$radius",
            "ThetaResolution": "$resolution",
            "PhiResolution": "$rings",
        }
    },
    "disk": {
        "vtkDiskSource": {
            "InnerRadius": "$inner",
            "OuterRadius": "$outer",
            "CircumferentialResolution": "$resolution",
        },
        "vtkPolyDataNormals": {},
        **_TURN,
    },
    "cylinder": {"vtkCylinderSource": _CYLINDER, **_TURN},
    "ring": {
        "vtkCylinderSource": {**_CYLINDER, "Capping": False},
        **_TURN,
        "vtkReverseSense": {"ReverseCells": True, "ReverseNormals": True},
    },
}


def _turn(axis_from: list[float], direction: list[float], center: list[float]) -> vtkTransform:
    """Return what turns `axis_from` onto a direction and moves the origin to the centre."""
    length = math.hypot(*direction)
    target = [component / length for component in direction]
    half = [a + b for a, b in zip(axis_from, target)]
    if math.hypot(*half) < 1e-9:  # opposite: half a turn about any perpendicular axis
        half = [axis_from[1], axis_from[2], axis_from[0]]
    transform = vtkTransform()
    transform.Translate(center)
    if target != axis_from:
        transform.RotateWXYZ(180.0, half)
    return transform


def build(values: Values, path: str) -> vtkDataSet:
    """Make the source of a checked actor, given by its short name or by its class."""
    if not isinstance(values["source"], str):
        ((name, properties),) = values["source"].items()
        return objects.make(name, properties, member(member(path, "source"), name))
    derived = {}
    if values["source"] == "plane":
        derived["columns"], derived["rows"] = values["resolution"]
    elif values["source"] == "sphere":
        derived["rings"] = max(3, int(values["resolution"]) // 2 + 1)
    elif "axis" in values:
        derived["turn"] = _turn([0.0, 1.0, 0.0], values["axis"], values["center"])
    elif "normal" in values:
        derived["turn"] = _turn([0.0, 0.0, 1.0], values["normal"], values["center"])
    (name, first), *others = objects.filled(
        SOURCES[values["source"]], {**values, **derived}
    ).items()
    data = objects.make(name, first, path)
    for name, properties in others:
        data = objects.apply(name, properties, data, path)
    return data
