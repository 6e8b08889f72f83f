# SPDX-License-Identifier: BSD-3-Clause
"""Looks of data files: words of `load_scene` and of the command line, checked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from vtkindirect import colormaps, surroundings, views
from vtkindirect.colormaps import Color
from vtkindirect.errors import check_text

BACKGROUND = (1.0, 1.0, 1.0)
"""The background of a data file: that of paper."""

NONE = "none"
"""A value of ``color_by``: no array, the surface has one colour."""


@dataclass(frozen=True)
class Look:
    """Words about a data file; None is what suits the data."""

    view: str | tuple[float, ...] | None = None
    color_by: str | None = None
    up: str | None = None
    background: Color | None = None

    @property
    def first_of_data(self) -> str | None:
        """Return the first word that a scene file has an answer of its own to."""
        words = {"view": self.view, "color_by": self.color_by, "up": self.up}
        return next((name for name, value in words.items() if value is not None), None)


def check(view: Any, color_by: Any, up: Any, background: Any) -> Look:
    """Check the words of a call."""
    if color_by is not None:
        check_text("color_by", color_by)
    return Look(
        views.from_value(view),
        color_by,
        surroundings.check_up(up),
        None if background is None else colormaps.color("background", background),
    )
