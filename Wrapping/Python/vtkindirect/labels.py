# SPDX-License-Identifier: BSD-3-Clause
"""Images of labels: whether an image is one, and the surfaces of its labels."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D

from vtkindirect import arrays, normals, working

NAME = "label"

MOST_LABELS = 1024
"""As many as a map for categories takes; images of intensities often have more values."""

LEAST_EQUAL = 0.5
"""Share of equal pairs among neighbours that are not both background. In an image of labels most
voxels are inside of something; an MRI of a brain has 0.12, a segmented frog 0.79."""

FEW_LABELS = 8
LEAST_JUMPS = 0.25
"""Share of pairs whose values are not neighbours in the list of all values, among unequal pairs.
Where many values are passed through one by one they measure something, such as a distance."""

# As in 3D Slicer's and VTK's examples of models from labels: no steps of voxels, volume kept.
SMOOTHING_ITERATIONS = 20
SMOOTHING_PASS_BAND = 0.05


@dataclass(frozen=True)
class Labels:
    """The labels of an image, ascending, without the one that stands for nothing."""

    background: float
    values: list[float]


def _neighbours(values: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield views of an image and of itself moved by a voxel, along each axis."""
    for axis in range(3):
        moved = np.moveaxis(values, axis, 0)
        yield moved[1:], moved[:-1]


def grid(image: vtkImageData, found: arrays.Found) -> np.ndarray:
    """Return an array of one component by z, y, x."""
    return found.numbers().reshape(image.GetDimensions()[::-1])


def box(inside: np.ndarray, margin: int = 0) -> tuple[tuple[slice, ...], list[int]]:
    """Return the part of an image that holds all that is inside, and its first voxel x, y, z."""
    part = []
    for axis in range(3):
        others = tuple(other for other in range(3) if other != axis)
        (where,) = np.nonzero(inside.any(axis=others))
        last = min(inside.shape[axis], int(where[-1]) + margin + 1)
        part.append(slice(max(0, int(where[0]) - margin), last))
    return tuple(part), [one.start for one in reversed(part)]


def part_of(image: vtkImageData, values: np.ndarray, first: Sequence[int]) -> vtkImageData:
    """Return an image of values by z, y, x that begins at voxel `first` of another image."""
    made = vtkImageData()
    made.SetDimensions(values.shape[::-1])
    made.SetSpacing(image.GetSpacing())
    made.SetDirectionMatrix(image.GetDirectionMatrix())
    corner = [0.0, 0.0, 0.0]
    start = image.GetExtent()[::2]
    image.TransformIndexToPhysicalPoint(*(a + b for a, b in zip(start, first)), corner)
    made.SetOrigin(corner)
    made.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return made


def find(image: vtkImageData, found: arrays.Found) -> Labels | None:
    """Return the labels of an image's array, or None when it holds no labels.

    It holds labels if its values are whole, of one component and at most `MOST_LABELS` different
    ones, if most neighbours are equal, and if many values come without those between them.
    """
    if found.array.GetNumberOfComponents() != 1 or min(image.GetDimensions()) < 2:
        return None
    numbers = found.numbers()
    some = np.unique(numbers[:: max(1, numbers.size // 100_000)])  # spares sorting all of most
    if some.size > MOST_LABELS or not np.isfinite(some).all() or (some != np.rint(some)).any():
        return None
    values, counts = np.unique(numbers, return_counts=True)
    if not 2 <= values.size <= MOST_LABELS:
        return None
    if not np.isfinite(values).all() or (values != np.rint(values)).any():
        return None
    background = 0 if (values == 0).any() else values[np.argmax(counts)]
    whole = grid(image, found)
    pairs = equal = jumps = 0
    for one, other in _neighbours(whole):
        inside = (one != background) | (other != background)
        unequal = one != other
        pairs += int(inside.sum())
        equal += int((inside & ~unequal).sum())
        if values.size > FEW_LABELS:
            steps = np.searchsorted(values, one[unequal]) - np.searchsorted(values, other[unequal])
            jumps += int((np.abs(steps) > 1).sum())
    if equal < LEAST_EQUAL * pairs:
        return None
    if values.size > FEW_LABELS and jumps < LEAST_JUMPS * (pairs - equal):
        return None
    return Labels(float(background), [float(value) for value in values if value != background])


def _surface_of_one(mask: vtkImageData, value: float) -> vtkPolyData:
    """Return the smooth surface of a mask, with normals and the label at its points."""
    contour = vtkDiscreteFlyingEdges3D()
    contour.SetInputData(mask)
    contour.SetValue(0, 1)
    contour.ComputeScalarsOff()
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(contour.GetOutputPort())
    smooth.SetNumberOfIterations(SMOOTHING_ITERATIONS)
    smooth.SetPassBand(SMOOTHING_PASS_BAND)
    smooth.NormalizeCoordinatesOn()
    smooth.NonManifoldSmoothingOn()
    smooth.FeatureEdgeSmoothingOff()
    smooth.Update()
    surface = normals.smooth(smooth.GetOutput())
    label = numpy_to_vtk(np.full(surface.GetNumberOfPoints(), value, np.float32), deep=True)
    label.SetName(NAME)
    surface.GetPointData().AddArray(label)
    return surface


def surface(image: vtkImageData, found: arrays.Found, labels: Labels) -> vtkPolyData:
    """Return the surfaces of all labels, each closed, with the array `NAME` at their points."""
    whole = grid(image, found)
    every = vtkAppendPolyData()
    for value in labels.values:
        working.say(f"label {value:g}")
        inside = whole == value
        part, first = box(inside)
        # With a margin of 0 surfaces are closed, at the image's border as well.
        padded = np.pad(inside[part].astype(np.uint8), 1)
        mask = part_of(image, padded, [index - 1 for index in first])
        every.AddInputData(_surface_of_one(mask, value))
    every.Update()
    return every.GetOutput()
