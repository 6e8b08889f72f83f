# SPDX-License-Identifier: BSD-3-Clause
"""Slices through the data sets of Testing/Data, in colours: what area lights show as a video.

A film runs through a brain's MRI from below, through a frog's tissues, and through the hot air above
a fire, one after the other; `frame` has any of its pictures.
"""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLUnstructuredGridReader

DATA = Path(__file__).resolve().parents[1] / "Data"
NAMES = ("brain", "frog", "fire")
Colors = tuple[tuple[float, float, float], ...]

# From the least value to the greatest, at equal distances.
ICE: Colors = ((0.0, 0.0, 0.02), (0.1, 0.2, 0.45), (0.35, 0.6, 0.85), (0.9, 0.97, 1.0))
EMBERS: Colors = ((0.03, 0.0, 0.06), (0.45, 0.03, 0.2), (0.95, 0.35, 0.05), (1.0, 0.95, 0.6))
TISSUES: Colors = (
    (0.3, 0.6, 0.42), (0.8, 0.1, 0.1), (0.9, 0.6, 0.3), (0.2, 0.7, 0.3), (0.5, 0.2, 0.6),
    (0.9, 0.9, 0.8), (0.9, 0.2, 0.3), (0.2, 0.8, 0.6), (0.6, 0.5, 0.1), (0.3, 0.6, 0.2),
    (0.1, 0.5, 0.3), (0.5, 0.9, 0.4), (0.9, 0.8, 0.2), (0.6, 0.9, 0.7), (0.4, 0.1, 0.3),
    (0.1, 0.6, 0.5),
)  # fmt: skip


def _array(data: Any, name: str | None = None) -> np.ndarray:
    """Return point scalars as depth x height x width."""
    points = data.GetPointData()
    found = points.GetArray(name) if name else points.GetScalars()
    return vtk_to_numpy(found).reshape(data.GetDimensions()[::-1])


def _read(reader: Any, name: str) -> Any:
    reader.SetFileName(str(DATA / name))
    reader.Update()
    return reader.GetOutput()


@functools.cache
def volume(name: str) -> tuple[np.ndarray, Colors]:
    """Return a data set, slices first and bottom rows first, from 0 to 1, with its colours."""
    if name == "brain":
        values = _array(_read(vtkNIFTIImageReader(), "brain_mri_colin27_ch2bet.nii.gz"))
        return np.clip(values[30:150, 20:200, 20:162] / 160.0, 0.0, 1.0), ICE
    if name == "frog":
        labels = _array(_read(vtkXMLImageDataReader(), "frog_tissues.vti"))
        # Every slice upright, the nose above.
        return labels.transpose(0, 2, 1)[20:116, 40:490, 60:440] / 15.0, TISSUES
    fire = _read(vtkXMLUnstructuredGridReader(), "room_fire_cfd.vtu")
    x0, x1, y0, y1, z0, z1 = fire.GetBounds()
    grid = vtkImageData()
    grid.SetDimensions(160, 80, 40)
    grid.SetOrigin(x0, y0, z0)
    grid.SetSpacing((x1 - x0) / 159.0, (y1 - y0) / 79.0, (z1 - z0) / 39.0)
    probe = vtkProbeFilter()
    probe.SetInputData(grid)
    probe.SetSourceData(fire)
    probe.Update()
    heat = (_array(probe.GetOutput(), "t") - 298.0) / (600.0 - 298.0)
    return np.clip(heat, 0.0, 1.0), EMBERS


def slice_of(name: str, share: float, edge: int) -> np.ndarray:
    """Return a slice, `share` of the way through, as edge x edge x 3 values from 0 to 1."""
    values, colors = volume(name)
    depth, height, width = values.shape
    # Labels are not mixed.
    whole = name == "frog"
    at = min(max(share, 0.0), 1.0) * (depth - 1)
    below = int(at)
    mixed = values[round(at)] if whole else values[below]
    if not whole and at > below:
        mixed = (below + 1 - at) * mixed + (at - below) * values[below + 1]
    rows = (np.arange(edge) * height) // edge
    columns = (np.arange(edge) * width) // edge
    picked = mixed[np.ix_(rows, columns)]
    places = np.linspace(0.0, 1.0, len(colors))
    return np.stack([np.interp(picked, places, [c[k] for c in colors]) for k in range(3)], axis=-1)


def frame(share: float, edge: int) -> np.ndarray:
    """Return the film's picture, `share` of the way through the film, in 0 to 1."""
    number = min(int(share * len(NAMES)), len(NAMES) - 1)
    return slice_of(NAMES[number], share * len(NAMES) - number, edge)


def as_image(picture: np.ndarray) -> vtkImageData:
    """Return a picture as a vtkImageData of bytes, as videos have them."""
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    pixels = np.round(255.0 * np.clip(picture, 0.0, 1.0)).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=1))
    return image
