# SPDX-License-Identifier: BSD-3-Clause
"""The camera of a data file: it sees what is there from a side that shows it, and near."""

from __future__ import annotations

import math
import reprlib
from collections.abc import Sequence
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera

from vtkindirect import surroundings
from vtkindirect.environments import is_number
from vtkindirect.errors import UsageError, unknown

OBLIQUE = {"x": (1.0, 1.0, 1.0), "y": (0.5, -1.0, 0.4), "z": (1.0, 1.0, 1.0)}
"""Default direction from the data to the camera, to the east, north and up, if an axis or its
opposite points up: PyVista's isometric view for z, and for y a view from the front that shows the
top and a side, too."""

ISO = "iso"
NAMES = (ISO, *surroundings.AXES)
"""Names of views: the oblique one, and those from the sides of the axes."""

LEAST_SHARE = 0.5
"""Share of the area of the side with the largest outline: a default view that shows less is
replaced by that side. A square that lies in a plane of coordinates shows 0.58 from (1, 1, 1)."""

MARGIN = 0.05
"""Share of the picture that stays empty on each side."""

SHADOW = 0.2
"""A picture has room for shadows around what stands on a ground: by this share of its height, or of
its breadth where that is less."""

_DIRECTIONS = 256


def _unit(vector: Sequence[float]) -> np.ndarray:
    return np.asarray(vector, float) / np.linalg.norm(vector)


def extremes(points: np.ndarray) -> np.ndarray:
    """Return those points that lie farthest out in many directions: all that an outline needs.

    An outline loses less than a hundredth of its radius: no direction is more than 0.13 radians
    from one of these, and 1 - cos(0.13) is 0.0084.
    """
    if len(points) <= _DIRECTIONS:
        return np.asarray(points, float)
    index = np.arange(_DIRECTIONS) + 0.5
    height, angle = 1.0 - 2.0 * index / _DIRECTIONS, math.pi * (1.0 + math.sqrt(5.0)) * index
    ring = np.sqrt(1.0 - height**2)
    # In single precision: twice as fast, and what is lost is a millionth of the size.
    directions = np.stack((ring * np.cos(angle), ring * np.sin(angle), height), axis=1)
    directions = directions.astype(np.float32)
    centered = (points - np.mean(points, axis=0, dtype=float)).astype(np.float32)
    best = np.full(_DIRECTIONS, -np.inf)
    which = np.zeros(_DIRECTIONS, int)
    for start in range(0, len(centered), 20_000):  # 20 MB at once
        values = directions @ centered[start : start + 20_000].T
        first = values.argmax(axis=1)
        value = values[np.arange(_DIRECTIONS), first]
        which[value > best] = first[value > best] + start
        best = np.maximum(best, value)
    return np.asarray(points, float)[np.unique(which)]


def _axes(toward: np.ndarray, up: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return what is right and up in the picture of a camera in a direction."""
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    return right, np.cross(toward, right)


def _outline_area(points: np.ndarray, toward: np.ndarray) -> float:
    """Return the area of the convex outline of points, seen from a direction."""
    helper = np.eye(3)[np.argmin(np.abs(toward))]
    right, over = _axes(toward, helper)
    flat = np.stack((points @ right, points @ over), axis=1)
    angle = np.linspace(0.0, 2.0 * math.pi, 65)[:-1]
    corners = flat[np.argmax(flat @ np.stack((np.cos(angle), np.sin(angle))), axis=0)]
    x, y = corners.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def from_value(value: Any) -> str | tuple[float, ...] | None:
    """Return a checked value of ``view=``: a name of `NAMES`, a direction, or None for no word."""
    if value is None:
        return None
    if isinstance(value, str):
        if value not in NAMES:
            raise UsageError(unknown("view", value, NAMES))
        return value
    numbers = tuple(value) if isinstance(value, (tuple, list, np.ndarray)) else ()
    if len(numbers) != 3 or not all(map(is_number, numbers)) or not any(numbers):
        raise UsageError(
            f"view must be one of {', '.join(NAMES)} or a direction from the data to the camera, "
            f"three finite numbers, not {reprlib.repr(value)}"
        )
    return tuple(map(float, numbers))


def _oblique(up: str) -> np.ndarray:
    """Return the direction of the oblique view."""
    over, east, north = (np.array(axis) for axis in surroundings.directions(up))
    shares = OBLIQUE[up[-1]]
    return _unit(shares[0] * east + shares[1] * north + shares[2] * over)


def direction(
    points: np.ndarray, up: str = "z", view: str | tuple[float, ...] | None = None
) -> np.ndarray:
    """Return from where data are seen.

    `view` is a checked value, or None: the oblique view, or, where that is thin, the broad side.
    """
    if view == ISO:
        return _oblique(up)
    if view is not None:
        return _unit(surroundings.directions(view)[0] if isinstance(view, str) else view)
    usual = _oblique(up)
    centered = points - points.mean(axis=0)
    side = np.linalg.svd(centered, full_matrices=False)[2][-1]
    if abs(side @ usual) > 1e-6:
        side = side * np.sign(side @ usual)
    broad = _outline_area(points, side)
    return usual if _outline_area(points, usual) >= LEAST_SHARE * broad else side


def with_ground(points: np.ndarray, up: str) -> np.ndarray:
    """Return points, and those of the shadows that they have around them on a ground below."""
    over, east, north = (np.array(axis) for axis in surroundings.directions(up))
    heights, flat = points @ over, np.stack((points @ east, points @ north), axis=1)
    breadth = np.ptp(flat, axis=0).max()
    angle = np.linspace(0.0, 2.0 * math.pi, 17)[:-1]
    ring = SHADOW * min(np.ptp(heights), breadth) * np.stack((np.cos(angle), np.sin(angle)), axis=1)
    around = (flat[:, None] + ring).reshape(-1, 2)
    return np.concatenate((points, heights.min() * over + around @ np.stack((east, north))))


def place(
    camera: vtkCamera, points: np.ndarray, toward: np.ndarray, up: str, aspect: float
) -> None:
    """Put a camera into a direction, as near as it sees all points with a margin around them.

    `aspect` is width over height of the picture. In a perspective view a point (x, y, z) of the
    camera's axes is in the picture where |x - cx| <= t (cz - z), t the tangent of half of the
    angle: two planes a side, whose tightest camera is a closed form.
    """
    axis, _, north = (np.array(one) for one in surroundings.directions(up))
    if abs(axis @ toward) > 0.95:  # seen from above
        axis = north
    right, over = _axes(toward, axis)
    x, y, z = points @ right, points @ over, points @ toward
    tangent = (1.0 - 2.0 * MARGIN) * math.tan(math.radians(camera.GetViewAngle()) / 2.0)
    where, distance = [], []
    for values, slope in ((x, tangent * aspect), (y, tangent)):
        high, low = (values + slope * z).max(), (slope * z - values).max()
        where.append(0.5 * (high - low))
        distance.append(0.5 * (high + low) / slope)
    eye = where[0] * right + where[1] * over + max(distance) * toward
    middle = 0.5 * (z.min() + z.max())
    camera.SetPosition(eye)
    camera.SetFocalPoint(eye + (middle - max(distance)) * toward)
    camera.SetViewUp(over)
