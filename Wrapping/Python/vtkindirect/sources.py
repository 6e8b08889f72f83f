# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that a scene file describes itself. One row of `SOURCES` is one source."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkCylinderSource,
    vtkDiskSource,
    vtkPlaneSource,
    vtkSphereSource,
)

from vtkindirect.fields import (
    Field,
    Table,
    array,
    bounds,
    direction,
    fail,
    integer,
    member,
    number,
    point,
    required,
)

Values = dict[str, Any]

_round = integer(minimum=3, maximum=2048)
_length = number(above=0)


def _turned(data: vtkPolyData, axis_from: list[float], values: Values, key: str) -> vtkPolyData:
    """Turn `axis_from` onto the direction `values[key]` and move the origin to the centre."""
    length = math.hypot(*values[key])
    target = [component / length for component in values[key]]
    half = [a + b for a, b in zip(axis_from, target)]
    if math.hypot(*half) < 1e-9:  # opposite: half a turn about any perpendicular axis
        half = [axis_from[1], axis_from[2], axis_from[0]]
    transform = vtkTransform()
    transform.Translate(values["center"])
    if target != axis_from:
        transform.RotateWXYZ(180.0, half)
    turn = vtkTransformPolyDataFilter()
    turn.SetInputData(data)
    turn.SetTransform(transform)
    turn.Update()
    return turn.GetOutput()


def _plane(values: Values, path: str) -> vtkPolyData:
    edges = [[b - a for a, b in zip(values["origin"], values[end])] for end in ("point1", "point2")]
    (ax, ay, az), (bx, by, bz) = edges
    area = math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    if not area > 1e-9 * math.hypot(*edges[0]) * math.hypot(*edges[1]):
        raise fail(member(path, "point2"), "origin, point1 and point2 must span an area")
    source = vtkPlaneSource()
    source.SetOrigin(values["origin"])
    source.SetPoint1(values["point1"])
    source.SetPoint2(values["point2"])
    source.SetResolution(*values["resolution"])
    source.Update()
    return source.GetOutput()


def _box(values: Values, _path: str) -> vtkPolyData:
    source = vtkCubeSource()
    source.SetBounds(values["bounds"])
    source.Update()
    return source.GetOutput()


def _sphere(values: Values, _path: str) -> vtkPolyData:
    source = vtkSphereSource()
    source.SetCenter(values["center"])
    source.SetRadius(values["radius"])
    source.SetThetaResolution(values["resolution"])
    source.SetPhiResolution(max(3, values["resolution"] // 2 + 1))
    source.Update()
    return source.GetOutput()


def _disk(values: Values, path: str) -> vtkPolyData:
    if values["inner"] >= values["outer"]:
        raise fail(member(path, "inner"), "must be less than outer")
    source = vtkDiskSource()
    source.SetInnerRadius(values["inner"])
    source.SetOuterRadius(values["outer"])
    source.SetCircumferentialResolution(values["resolution"])
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    normals.Update()
    return _turned(normals.GetOutput(), [0.0, 0.0, 1.0], values, "normal")


def _cylinder(values: Values, _path: str, capping: bool = True) -> vtkPolyData:
    source = vtkCylinderSource()
    source.SetRadius(values["radius"])
    source.SetHeight(values["height"])
    source.SetResolution(values["resolution"])
    source.SetCapping(capping)
    source.Update()
    return _turned(source.GetOutput(), [0.0, 1.0, 0.0], values, "axis")


def _ring(values: Values, path: str) -> vtkPolyData:
    inward = vtkReverseSense()
    inward.SetInputData(_cylinder(values, path, capping=False))
    inward.ReverseCellsOn()
    inward.ReverseNormalsOn()
    inward.Update()
    return inward.GetOutput()


@dataclass(frozen=True)
class Source:
    """What a source is, its keys and how it is made."""

    meaning: str
    fields: Table
    build: Callable[[Values, str], vtkPolyData]


_cylinder_fields = {
    "center": Field(point, (0.0, 0.0, 0.0)),
    "axis": Field(direction, (0.0, 1.0, 0.0)),
    "radius": Field(_length, 0.5),
    "height": Field(_length, 1.0),
    "resolution": Field(_round, 64),
}

SOURCES = {
    "plane": Source(
        "a parallelogram; its normal is (point1 - origin) x (point2 - origin)",
        {
            "origin": required(point),
            "point1": required(point),
            "point2": required(point),
            "resolution": Field(array(integer(minimum=1, maximum=2048), length=2), (1, 1)),
        },
        _plane,
    ),
    "box": Source("a closed box along the axes", {"bounds": required(bounds)}, _box),
    "sphere": Source(
        "a sphere of flat faces with smooth normals",
        {
            "center": Field(point, (0.0, 0.0, 0.0)),
            "radius": Field(_length, 0.5),
            "resolution": Field(_round, 32),
        },
        _sphere,
    ),
    "disk": Source(
        "a flat disk, or a flat ring when inner is not 0",
        {
            "center": Field(point, (0.0, 0.0, 0.0)),
            "normal": Field(direction, (0.0, 1.0, 0.0)),
            "inner": Field(number(minimum=0), 0.0),
            "outer": Field(_length, 0.5),
            "resolution": Field(_round, 64),
        },
        _disk,
    ),
    "cylinder": Source("a closed cylinder", _cylinder_fields, _cylinder),
    "ring": Source("a cylinder without ends whose normals point inwards", _cylinder_fields, _ring),
}
