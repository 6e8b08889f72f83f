# SPDX-License-Identifier: BSD-3-Clause
"""Colours for scalars: Matplotlib's maps by name, one of the project's own, or a scene's list."""

from __future__ import annotations

import reprlib
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVariant
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from vtkindirect.environments import is_number
from vtkindirect.errors import UsageError, suggestion

VIVID = "1a6bff ffb400 19c832 ff6e9b 00c8d2 c81ee6 ff2a1a 96dc14"
"""Colours that stay apart when a scene is dim, for categories."""

DEFAULT = "viridis"
"""The map of data that nobody has chosen colours for: Matplotlib's and PyVista's default."""

MISSING = (0.66, 0.66, 0.66)
"""Colour of missing values (NaN): grey, which no map between two colours has."""

Color = tuple[float, float, float]

_MOST_CATEGORIES = 20
"""A map of Matplotlib's with no more colours than this is for categories; others have 256."""


def _matplotlib() -> Any:
    try:
        import matplotlib.colors
    except ImportError as error:
        raise ImportError(
            "colour maps and names of colours need Matplotlib 3.5 or later (Debian: "
            f"python3-matplotlib): {error}"
        ) from None
    return matplotlib


def color(word: str, value: Any) -> Color:
    """Return the red, green and blue of a colour: by Matplotlib's name for it, or three numbers.

    `word` is what an error calls the value.
    """
    if isinstance(value, str):
        known = _matplotlib().colors
        if known.is_color_like(value):
            return known.to_rgb(value)
        raise UsageError(
            f"{word}: unknown colour '{value}'{suggestion(value, known.CSS4_COLORS)}: a name such "
            "as white, #rrggbb, or red, green and blue from 0 to 1"
        )
    numbers = value.tolist() if hasattr(value, "tolist") else value
    numbers = numbers if isinstance(numbers, (tuple, list)) else ()
    if len(numbers) != 3 or not all(is_number(one) and 0.0 <= one <= 1.0 for one in numbers):
        raise UsageError(
            f"{word} must be the name of a colour, #rrggbb, or red, green and blue from 0 to 1, "
            f"not {reprlib.repr(value)}"
        )
    return tuple(map(float, numbers))


@cache
def _maps() -> dict[str, Any]:
    """Return all maps by their names in lower case."""
    matplotlib = _matplotlib()
    found = {name.lower(): one for name, one in matplotlib.colormaps.items()}
    found["vivid"] = matplotlib.colors.ListedColormap([f"#{word}" for word in VIVID.split()])
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
