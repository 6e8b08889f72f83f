# SPDX-License-Identifier: BSD-3-Clause
"""A ground below a scene that shows nothing but the shadows on it and the light that it catches.

It is a plane with the property key CATCHES_LIGHT of vtkIndirectIlluminationPass, below the lowest
point of what is visible. A renderer has it only while it draws a frame, so that bounds, pickers,
exporters and PyVista's lists of actors do not know it.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkMapper,
    vtkPolyDataMapper,
    vtkProp,
    vtkProp3D,
    vtkRenderer,
)

from vtkindirect import names, surroundings, wrapped
from vtkindirect.errors import UsageError, unknown

REACH = 20.0
"""The plane reaches so far from the scene's middle, in diagonals of the scene. From five on less
than a five-hundredth of a sky's light is missing; the shadow of a light 3 degrees above the plane
ends within it."""
GAP = 1e-3
"""It lies so far below the lowest point, in diagonals: faces that stand on it stay before it."""
_NO_SURFACE = ("vtkAxesActor", "vtkCubeAxesActor", "vtkSkybox", "vtkAnnotatedCubeActor")


@dataclass(frozen=True)
class Place:
    """Where a ground lies: the axis that points up, and the height along it. None: by itself."""

    axis: str | None = None
    height: float | None = None


def from_value(value: Any) -> Place | None:
    """Return the place that a value of ``ground=`` stands for; None for no ground.

    `value` is True, False or None, a height, the name of an axis that points up, or an axis and a
    height. Raises `UsageError`.
    """
    if value is None or value is False:
        return None
    if value is True:
        return Place()
    parts = value if isinstance(value, (tuple, list)) else (value,)
    axes = [part for part in parts if isinstance(part, str)]
    heights = [
        float(part)
        for part in parts
        if isinstance(part, numbers.Real) and not isinstance(part, (bool, np.bool_))
    ]
    if len(axes) > 1 or len(heights) > 1 or not parts or len(axes) + len(heights) < len(parts):
        raise UsageError(
            "ground is True, False, a height, the axis that points up, such as 'z', or an axis and "
            f"a height, not {value!r}"
        )
    if axes and axes[0] not in surroundings.AXES:
        raise UsageError(f"ground: {unknown('axis', axes[0], surroundings.AXES)}")
    if heights and not math.isfinite(heights[0]):
        raise UsageError(f"ground: the height {heights[0]} is not finite")
    return Place(axes[0] if axes else None, heights[0] if heights else None)


def _axis(name: str) -> tuple[int, float]:
    """Return the coordinate of an axis that points up, and its sign."""
    return "xyz".index(name[-1]), -1.0 if name[0] == "-" else 1.0


class Ground:
    """The ground of a renderer."""

    def __init__(self, place: Place) -> None:
        self.place = place
        self._up: tuple[int, float] | None = _axis(place.axis) if place.axis else None
        self._lowest: dict[str, tuple[Any, float]] = {}
        self._box: tuple[float, ...] | None = None
        source = vtkPlaneSource()
        source.SetOrigin(-1.0, -1.0, 0.0)
        source.SetPoint1(1.0, -1.0, 0.0)
        source.SetPoint2(-1.0, 1.0, 0.0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.UseBoundsOff()
        self.actor.PickableOff()
        self.actor.SetUserMatrix(vtkMatrix4x4())
        look = self.actor.GetProperty()
        look.SetColor(1.0, 1.0, 1.0)
        look.SetAmbient(0.0)
        look.SetDiffuse(1.0)
        look.SetSpecular(0.0)
        look.BackfaceCullingOn()  # from below it is not there
        keys = vtkInformation()
        keys.Set(wrapped.get("vtkIndirectIlluminationPass").CATCHES_LIGHT(), 1)
        self.actor.SetPropertyKeys(keys)
        names.give(self.actor, "ground")

    def begin(self, renderer: vtkRenderer) -> None:
        """At the begin of a frame: put the plane below what is visible, unless nothing is."""
        box = _bounds(self._standing(renderer))
        if box is None or renderer.GetSelector() is not None:
            return
        if self._up is None:
            self._up = _axis(surroundings.up_of_camera(renderer))
        axis, sign = self._up
        low, high = np.array(box[0::2]), np.array(box[1::2])
        diagonal = float(np.linalg.norm(high - low)) or 1.0
        middle = 0.5 * (low + high)
        if self.place.height is not None:
            middle[axis] = self.place.height
        else:
            middle[axis] = self._find_lowest(renderer, axis, sign) - sign * GAP * diagonal
        # Multiples of a power of two: the plane keeps its place while the scene changes a little.
        half = REACH * 2.0 ** math.ceil(math.log2(diagonal))
        matrix = np.eye(4)
        up = np.zeros(3)
        up[axis] = sign
        right = np.roll(np.abs(up), 1)
        matrix[:3, 0] = half * right
        matrix[:3, 1] = half * np.cross(up, right)
        matrix[:3, 2] = up
        step = half / 64.0
        matrix[:3, 3] = np.where(np.abs(up) > 0.0, middle, step * np.round(middle / step))
        user = self.actor.GetUserMatrix()
        values = tuple(matrix.ravel())
        if self._box != values:
            self._box = values
            user.DeepCopy(values)
        # The renderer's own methods would free graphics memory after each frame.
        props = renderer.GetViewProps()
        if not props.IsItemPresent(self.actor):
            props.AddItem(self.actor)

    def end(self, renderer: vtkRenderer) -> None:
        """At the end of a frame: take the plane out of the renderer."""
        renderer.GetViewProps().RemoveItem(self.actor)

    def release(self, renderer: vtkRenderer) -> None:
        """Free graphics memory, when the ground is not needed any more."""
        self.end(renderer)
        if renderer.GetRenderWindow() is not None:
            self.actor.ReleaseGraphicsResources(renderer.GetRenderWindow())

    def _standing(self, renderer: vtkRenderer) -> Iterator[vtkProp]:
        """Yield what may stand on the ground: visible props with a place of their own."""
        casts = wrapped.get("vtkIndirectIlluminationPass").CASTS_SHADOWS()
        props = renderer.GetViewProps()
        for index in range(props.GetNumberOfItems()):
            prop = props.GetItemAsObject(index)
            if prop is self.actor or not prop.GetVisibility() or not prop.GetUseBounds():
                continue
            if not isinstance(prop, vtkProp3D) or any(prop.IsA(name) for name in _NO_SURFACE):
                continue
            if isinstance(prop, vtkActor) and prop.GetMapper() is None:
                continue
            keys = prop.GetPropertyKeys()
            if keys is not None and keys.Has(casts) and not keys.Get(casts):
                continue
            yield prop

    def _find_lowest(self, renderer: vtkRenderer, axis: int, sign: float) -> float:
        """Return the lowest coordinate; points decide where a box is turned with its actor."""
        known, self._lowest = self._lowest, {}
        lowest = math.inf
        for prop in self._standing(renderer):
            bounds = prop.GetBounds()
            if not _is_box(bounds):
                continue
            low = min(sign * bounds[2 * axis], sign * bounds[2 * axis + 1])
            if low >= lowest:
                continue
            row = _turned_row(prop, axis)
            if row is not None:
                points = prop.GetMapper().GetInput().GetPoints()
                key = (points.GetMTime(), prop.GetMapper().GetInput().GetMTime(), row, sign)
                found = known.get(prop.__this__)
                if found is None or found[0] != key:
                    heights = vtk_to_numpy(points.GetData()) @ np.array(row[:3]) + row[3]
                    found = key, float(np.min(sign * heights))
                self._lowest[prop.__this__] = found
                low = max(low, found[1]) if math.isfinite(found[1]) else low
            lowest = min(lowest, low)
        return sign * lowest


def _is_box(bounds: Any) -> bool:
    return bounds is not None and bounds[0] <= bounds[1] and all(map(math.isfinite, bounds))


def _bounds(props: Iterator[vtkProp]) -> tuple[float, ...] | None:
    boxes = [prop.GetBounds() for prop in props]
    boxes = [box for box in boxes if _is_box(box)]
    if not boxes:
        return None
    table = np.array(boxes)
    both = np.empty(6)
    both[0::2] = table[:, 0::2].min(axis=0)
    both[1::2] = table[:, 1::2].max(axis=0)
    return tuple(both)


def _turned_row(prop: vtkProp3D, axis: int) -> tuple[float, ...] | None:
    """Return the row of an actor's matrix for a coordinate, where it mixes coordinates of points.

    None where the box tells the lowest point, or where the mapper's points are unknown.
    """
    matrix = prop.GetMatrix()
    row = tuple(matrix.GetElement(axis, column) for column in range(4))
    mapper = prop.GetMapper() if isinstance(prop, vtkActor) else None
    if sum(value != 0.0 for value in row[:3]) < 2 or not isinstance(mapper, vtkMapper):
        return None
    if mapper.GetClassName() != "vtkOpenGLPolyDataMapper":
        data = mapper.GetInput() if mapper.IsA("vtkDataSetMapper") else None
    else:
        data = mapper.GetInput()
    if data is None or not hasattr(data, "GetPoints") or data.GetPoints() is None:
        return None
    return row if data.GetNumberOfPoints() > 0 else None
