# SPDX-License-Identifier: BSD-3-Clause
"""Tells bodies, which can stand on a ground, from other surfaces."""

from __future__ import annotations

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

CLOSED = 0.2
"""A surface is closed, but for small holes, where the sum of its area vectors is at most this share
of its area: that of a closed surface is none, that of a sheet all, that of half a ball a half."""
COMPACT = 0.1
"""A body holds at least this share of the volume of a ball whose surface has the same area: a cube
holds 0.72 of it, a brain 0.14, streamlines as tubes 0.02 and the atoms of a protein 0.01."""


def _triangles(surface: vtkPolyData) -> np.ndarray:
    """Return the corners of a surface's triangles, around their middle."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    found = triangles.GetOutput()
    corners = vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    if len(corners) == 0:
        return np.zeros((0, 3, 3))
    points = vtk_to_numpy(found.GetPoints().GetData()).astype(float)
    return (points - points.mean(axis=0))[corners]


def can_stand(surface: vtkPolyData) -> bool:
    """Return whether a surface is closed and compact.

    Slices and terrain, bundles of tubes, and molecules are not.
    """
    first, second, third = np.moveaxis(_triangles(surface), 1, 0)
    vectors = 0.5 * np.cross(second - first, third - first)
    area = float(np.linalg.norm(vectors, axis=1).sum())
    volume = abs(float((first * vectors).sum())) / 3.0
    if area == 0.0 or np.linalg.norm(vectors.sum(axis=0)) > CLOSED * area:
        return False
    return volume >= COMPACT * area**1.5 / (6.0 * math.sqrt(math.pi))
