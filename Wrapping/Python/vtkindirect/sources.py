# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that a scene file describes itself. One row of `SOURCES` is one source."""

from __future__ import annotations

import math
from collections.abc import Callable
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

Values = dict[str, Any]


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


def _plane(values: Values) -> vtkPolyData:
    source = vtkPlaneSource()
    source.SetOrigin(values["origin"])
    source.SetPoint1(values["point1"])
    source.SetPoint2(values["point2"])
    source.SetResolution(*values["resolution"])
    source.Update()
    return source.GetOutput()


def _box(values: Values) -> vtkPolyData:
    source = vtkCubeSource()
    source.SetBounds(values["bounds"])
    source.Update()
    return source.GetOutput()


def _sphere(values: Values) -> vtkPolyData:
    source = vtkSphereSource()
    source.SetCenter(values["center"])
    source.SetRadius(values["radius"])
    source.SetThetaResolution(values["resolution"])
    source.SetPhiResolution(max(3, values["resolution"] // 2 + 1))
    source.Update()
    return source.GetOutput()


def _disk(values: Values) -> vtkPolyData:
    source = vtkDiskSource()
    source.SetInnerRadius(values["inner"])
    source.SetOuterRadius(values["outer"])
    source.SetCircumferentialResolution(values["resolution"])
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    normals.Update()
    return _turned(normals.GetOutput(), [0.0, 0.0, 1.0], values, "normal")


def _cylinder(values: Values, capping: bool = True) -> vtkPolyData:
    source = vtkCylinderSource()
    source.SetRadius(values["radius"])
    source.SetHeight(values["height"])
    source.SetResolution(values["resolution"])
    source.SetCapping(capping)
    source.Update()
    return _turned(source.GetOutput(), [0.0, 1.0, 0.0], values, "axis")


def _ring(values: Values) -> vtkPolyData:
    inward = vtkReverseSense()
    inward.SetInputData(_cylinder(values, capping=False))
    inward.ReverseCellsOn()
    inward.ReverseNormalsOn()
    inward.Update()
    return inward.GetOutput()


SOURCES: dict[str, Callable[[Values], vtkPolyData]] = {
    "plane": _plane,
    "box": _box,
    "sphere": _sphere,
    "disk": _disk,
    "cylinder": _cylinder,
    "ring": _ring,
}
