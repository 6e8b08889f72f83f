# SPDX-License-Identifier: BSD-3-Clause
"""Colours for scalars: Matplotlib's maps by name, one of the project's own, or a scene's list."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVariant
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from vtkindirect.errors import suggestion

VIVID = "1a6bff ffb400 19c832 ff6e9b 00c8d2 c81ee6 ff2a1a 96dc14"
"""Colours that stay apart when a scene is dim, for categories."""

DEFAULT = "viridis"
"""The map of data that nobody has chosen colours for: Matplotlib's and PyVista's default."""

MISSING = (0.66, 0.66, 0.66)
"""Colour of missing values (NaN): grey, which no map between two colours has."""

_MOST_CATEGORIES = 20
"""A map of Matplotlib's with no more colours than this is for categories; others have 256."""


@cache
def _maps() -> dict[str, Any]:
    """Return all maps by their names in lower case."""
    try:
        import matplotlib
        from matplotlib.colors import ListedColormap
    except ImportError as error:
        raise ImportError(
            f"colour maps need Matplotlib 3.5 or later (Debian: python3-matplotlib): {error}"
        ) from None
    found = {name.lower(): one for name, one in matplotlib.colormaps.items()}
    found["vivid"] = ListedColormap([f"#{word}" for word in VIVID.split()])
    return found


def unknown(name: str) -> str | None:
    """Return what to say of a name that no map has, or None."""
    known = _maps()
    if name.lower() in known:
        return None
    return f"unknown map '{name}'{suggestion(name, known)}; known: vivid and Matplotlib's"


def is_categorical(colors: Any) -> bool:
    """Return whether a map has one colour for each distinct value."""
    return isinstance(colors, str) and _maps()[colors.lower()].N <= _MOST_CATEGORIES


def lookup_table(
    colors: str | Sequence[Sequence[float]], span: Sequence[float], values: Sequence[float]
) -> vtkLookupTable:
    """Return the table that maps scalars to colours.

    `span` are the scalars of the first and last colour of a continuous map; `values` are the
    distinct scalars that a categorical map gives colours to, in ascending order, from the first
    colour again when there are more.
    """
    table = vtkLookupTable()
    if isinstance(colors, str):
        found = _maps()[colors.lower()]
        points = found(np.arange(found.N))[:, :3].tolist()
    else:
        ramp = vtkColorTransferFunction()
        for index, rgb in enumerate(colors):
            ramp.AddRGBPoint(index / (len(colors) - 1), *rgb)
        points = [ramp.GetColor(position) for position in np.linspace(0.0, 1.0, 256)]
    table.SetNumberOfTableValues(len(points))
    for index, rgb in enumerate(points):
        table.SetTableValue(index, *rgb, 1.0)
    if is_categorical(colors):
        table.IndexedLookupOn()
        for value in values:
            table.SetAnnotation(vtkVariant(value), f"{value:g}")
    else:
        table.SetTableRange(*span)
    return table
