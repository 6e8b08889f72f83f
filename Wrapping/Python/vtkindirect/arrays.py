# SPDX-License-Identifier: BSD-3-Clause
"""Finds the arrays of a data set by name; makes images of arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkImageData

from vtkindirect.errors import suggestion
from vtkindirect.schema import fail


@dataclass(frozen=True)
class Found:
    """An array and whether it belongs to the points or to the cells."""

    array: vtkDataArray
    on_points: bool

    @property
    def name(self) -> str:
        return self.array.GetName()

    @property
    def association(self) -> int:
        """VTK's number for the place, as filters want it."""
        kinds = vtkDataObject
        return kinds.FIELD_ASSOCIATION_POINTS if self.on_points else kinds.FIELD_ASSOCIATION_CELLS

    @property
    def span(self) -> tuple[float, float]:
        """Smallest and greatest value of the first component; missing ones (NaN) do not count.

        Where all are missing the first is greater than the second.
        """
        return self.array.GetFiniteRange(0)

    def numbers(self) -> np.ndarray:
        """The values as a NumPy array that shares memory with VTK's."""
        return vtk_to_numpy(self.array)


def names(data: vtkDataSet, on_cells: bool = True) -> list[str]:
    """Return the names of the numeric arrays, those on points first."""
    sets = [data.GetPointData()] + ([data.GetCellData()] if on_cells else [])
    found = []
    for attributes in sets:
        for index in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(index)
            if array is not None and array.GetName():
                found.append(array.GetName())
    return list(dict.fromkeys(found))


def find(data: vtkDataSet, name: str | None, path: str, on_cells: bool = True) -> Found:
    """Return the array `name`, looked for on the points and then on the cells.

    Without a name it is the active scalars, or the only array that there is.
    """
    points, cells = data.GetPointData(), data.GetCellData()
    known = names(data, on_cells)
    if name is None:
        scalars = points.GetScalars()
        if scalars is not None:
            return Found(scalars, True)
        if len(known) != 1:
            some = f": one of {', '.join(known)}" if known else ", and the data has none"
            raise fail(path, f"must name an array{some}")
        name = known[0]
    array = points.GetArray(name)
    if array is not None:
        return Found(array, True)
    array = cells.GetArray(name) if on_cells else None
    if array is not None:
        return Found(array, False)
    place = "" if on_cells else " on points"
    some = ", ".join(known) if known else "none"
    raise fail(path, f"no array '{name}'{place}{suggestion(name, known)}; known: {some}")


def default(data: vtkDataSet) -> Found | None:
    """Return the array that data are shown by when nobody has named one, or None.

    The active scalars, those on points first, else the first array that is nothing of VTK's own;
    among others one with a single component comes first.
    """
    sets = (data.GetPointData(), True), (data.GetCellData(), False)
    for attributes, on_points in sets:
        if isinstance(attributes.GetScalars(), vtkDataArray) and attributes.GetScalars().GetName():
            return Found(attributes.GetScalars(), on_points)
    known = []
    for attributes, on_points in sets:
        special = (
            attributes.GetNormals(),
            attributes.GetTCoords(),
            attributes.GetTangents(),
            attributes.GetGlobalIds(),
            attributes.GetPedigreeIds(),
        )
        names_of_special = {one.GetName() for one in special if one is not None}
        for index in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(index)
            if array is None or not array.GetName():
                continue
            if not array.GetName().startswith("vtk") and array.GetName() not in names_of_special:
                known.append(Found(array, on_points))
    known.sort(key=lambda found: found.array.GetNumberOfComponents() > 1)
    return known[0] if known else None


def finite(array: vtkDataArray | None) -> bool:
    """Return whether an array, if there is one, is free of NaN and infinity."""
    if array is None or array.GetDataTypeAsString() not in ("float", "double"):
        return True
    return bool(np.isfinite(vtk_to_numpy(array)).all())


def as_image(values: np.ndarray) -> vtkImageData:
    """Return an array of height x width x components as an image, bottom row first."""
    height, width, components = values.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(values).reshape(-1, components)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def as_array(image: vtkImageData) -> np.ndarray:
    """Return a copy of the scalars of an image of one slice as height x width x components."""
    width, height, _ = image.GetDimensions()
    scalars = image.GetPointData().GetScalars()
    return vtk_to_numpy(scalars).reshape(height, width, scalars.GetNumberOfComponents()).copy()
