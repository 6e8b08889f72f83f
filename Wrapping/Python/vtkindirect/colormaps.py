# SPDX-License-Identifier: BSD-3-Clause
"""Colours for scalars: a few well-known maps as control points, or a scene's own list."""

from __future__ import annotations

from collections.abc import Sequence

from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVariant
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction


# Evenly spaced control points, from the lowest value to the highest.
CONTINUOUS = {
    "inferno": "000004 1f0c48 550f6d 88226a ba3655 e35933 f98c0a f9c932 fcffa4",
    "magma": "000004 1d1147 51127c 832681 b73779 e75263 fc8961 fec488 fcfdbf",
    "plasma": "0d0887 4c02a1 7e03a8 aa2395 cc4778 e66c5c f89540 fdc527 f0f921",
    "viridis": "440154 472d7b 3b528b 2c728e 21918c 28ae80 5ec962 addc30 fde725",
    "turbo": "30123b 4662d7 36aaf9 1ae4b6 72fe5e c7ef34 faba39 f66b19 ca2a04 7a0403",
    "coolwarm": "3b4cc0 688aef 99baff c9d8ef edd1c2 f7a789 e26952 b40426",
    "gray": "000000 ffffff",
}

# One colour for each distinct value of the array, in ascending order, from the start again when
# there are more values.
CATEGORICAL = {
    "set1": "e41a1c 377eb8 4daf4a 984ea3 ff7f00 ffff33 a65628 f781bf 999999",
    "tab10": "1f77b4 ff7f0e 2ca02c d62728 9467bd 8c564b e377c2 7f7f7f bcbd22 17becf",
    "vivid": "1a6bff ffb400 19c832 ff6e9b 00c8d2 c81ee6 ff2a1a 96dc14",
}

NAMES = (*CONTINUOUS, *CATEGORICAL)


def _points(text: str) -> list[tuple[float, ...]]:
    return [tuple(byte / 255 for byte in bytes.fromhex(word)) for word in text.split()]


def lookup_table(
    colors: str | Sequence[Sequence[float]], span: Sequence[float], values: Sequence[float]
) -> vtkLookupTable:
    """Return the table that maps scalars to colours.

    `span` are the scalars of the first and last colour of a continuous map; `values` are the
    distinct scalars that a categorical map gives colours to.
    """
    table = vtkLookupTable()
    if isinstance(colors, str) and colors in CATEGORICAL:
        points = _points(CATEGORICAL[colors])
        table.IndexedLookupOn()
        table.SetNumberOfTableValues(len(points))
        for index, rgb in enumerate(points):
            table.SetTableValue(index, *rgb, 1.0)
        for value in values:
            table.SetAnnotation(vtkVariant(value), f"{value:g}")
    else:
        points = _points(CONTINUOUS[colors]) if isinstance(colors, str) else list(colors)
        ramp = vtkColorTransferFunction()
        for index, rgb in enumerate(points):
            ramp.AddRGBPoint(index / (len(points) - 1), *rgb)
        count = 256
        table.SetNumberOfTableValues(count)
        for index in range(count):
            table.SetTableValue(index, *ramp.GetColor(index / (count - 1)), 1.0)
        table.SetTableRange(*span)
    return table
