# SPDX-License-Identifier: BSD-3-Clause
"""Normals of surfaces: computed anew where what they were computed from has changed."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals


def has(data: vtkPolyData) -> bool:
    """Return whether points have normals."""
    return data.GetPointData().GetNormals() is not None


def without(data: vtkPolyData) -> vtkPolyData:
    """Return a surface without normals: newer versions of vtkPolyDataNormals keep what they find."""
    bare = vtkPolyData()
    bare.ShallowCopy(data)
    bare.GetPointData().SetNormals(None)
    bare.GetCellData().SetNormals(None)
    return bare


def smooth(data: vtkPolyData) -> vtkPolyData:
    """Return a surface with smooth normals of its triangles, and the points and cells it has."""
    computed = vtkPolyDataNormals()
    computed.SetInputData(without(data))
    computed.SplittingOff()
    computed.ConsistencyOff()
    computed.Update()
    return computed.GetOutput()


def anew(data: vtkPolyData, had_normals: bool) -> vtkPolyData:
    """Compute smooth normals anew where a filter moved or dropped points that had them."""
    return smooth(data) if had_normals else data


def mend(surface: vtkPolyData) -> vtkPolyData:
    """Give the points of an image's contour the normals that its gradient does not have.

    Between voxels with opposite gradients, as in sheets one voxel thin, vtkFlyingEdges3D makes zero
    of them, and NaN where the spacing is not one. The triangles have a normal there; where they
    have no area either, nothing shows which one is taken.
    """
    normals = vtk_to_numpy(surface.GetPointData().GetNormals())
    good = np.linalg.norm(normals, axis=1) > 0.5  # not so for NaN
    if good.all():
        return surface
    normals[~good] = (0.0, 0.0, 1.0)
    other = vtk_to_numpy(smooth(surface).GetPointData().GetNormals())
    agreement = np.einsum("ij,ij->", normals[good], other[good])
    usable = ~good & (np.linalg.norm(other, axis=1) > 0.5)
    normals[usable] = other[usable] if agreement >= 0.0 else -other[usable]
    return surface
