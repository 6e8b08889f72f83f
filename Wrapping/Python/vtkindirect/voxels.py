# SPDX-License-Identifier: BSD-3-Clause
"""Values of a grid's cells as values at points, which contours need, and missing values."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataSet,
    vtkDataSetAttributes,
    vtkImageData,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkCleanPolyData

from vtkindirect import arrays


def _centers(image: vtkImageData) -> vtkImageData:
    """Return an image whose points are the centres of another image's cells, with their data.

    Values stay as they are, so that labels stay labels. An axis with one point has no cells along
    it and stays.
    """
    extent = list(image.GetExtent())
    half = [0.0, 0.0, 0.0]
    for axis in range(3):
        if extent[2 * axis + 1] > extent[2 * axis]:
            extent[2 * axis + 1] -= 1
            half[axis] = 0.5
    origin = [0.0, 0.0, 0.0]
    image.TransformContinuousIndexToPhysicalPoint(*half, origin)
    made = vtkImageData()
    made.SetExtent(extent)
    made.SetSpacing(image.GetSpacing())
    made.SetDirectionMatrix(image.GetDirectionMatrix())
    made.SetOrigin(origin)
    made.GetPointData().ShallowCopy(image.GetCellData())
    return made


def at_points(data: vtkDataSet, found: arrays.Found) -> tuple[vtkDataSet, arrays.Found]:
    """Return data with an array at its points, and the array there.

    Cells of an image become voxels: points at their centres. Else each point has the mean of the
    cells around it.
    """
    if found.on_points:
        return data, found
    if isinstance(data, vtkImageData):
        made = _centers(data)
    else:
        mean = vtkCellDataToPointData()
        mean.SetInputData(data)
        mean.Update()
        made = mean.GetOutput()
    return made, arrays.Found(made.GetPointData().GetArray(found.name), True)


def without_missing(surface: vtkPolyData) -> vtkPolyData:
    """Return a contour without what it has where a value is missing (NaN).

    There VTK's contour makes cells with points that are NaN, which are not drawn.
    """
    if surface.GetNumberOfPoints() == 0 or arrays.finite(surface.GetPoints().GetData()):
        return surface
    places = vtk_to_numpy(surface.GetPoints().GetData())
    bad = ~np.isfinite(places).all(axis=1)
    kinds = surface.GetVerts(), surface.GetLines(), surface.GetPolys(), surface.GetStrips()
    marks = np.concatenate([_touches(cells, bad) for cells in kinds])
    # Not a product: with NumPy 2 that is of 64 bits, which VTK does not take for marks.
    ghosts = np.where(marks, int(vtkDataSetAttributes.HIDDENCELL), 0).astype(np.uint8)
    kept = vtkPolyData()
    kept.ShallowCopy(surface)
    array = numpy_to_vtk(ghosts, deep=True)
    array.SetName(vtkDataSetAttributes.GhostArrayName())
    kept.GetCellData().AddArray(array)
    kept.RemoveGhostCells()
    kept.GetCellData().RemoveArray(vtkDataSetAttributes.GhostArrayName())
    used = vtkCleanPolyData()
    used.SetInputData(kept)
    used.PointMergingOff()
    used.ConvertLinesToPointsOff()
    used.ConvertPolysToLinesOff()
    used.ConvertStripsToPolysOff()
    used.Update()
    return used.GetOutput()


def _touches(cells, bad: np.ndarray) -> np.ndarray:
    """Return for each cell whether one of its points is bad."""
    starts = vtk_to_numpy(cells.GetOffsetsArray())
    if len(starts) < 2:
        return np.zeros(0, dtype=bool)
    return np.logical_or.reduceat(bad[vtk_to_numpy(cells.GetConnectivityArray())], starts[:-1])


def number_missing(found: arrays.Found) -> int:
    """Return how many values of an array's first component are NaN."""
    if arrays.finite(found.array):
        return 0
    values = found.numbers()
    return int(np.isnan(values if values.ndim == 1 else values[:, 0]).sum())
