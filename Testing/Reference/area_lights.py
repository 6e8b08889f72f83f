# SPDX-License-Identifier: BSD-3-Clause
"""The area lights of a description for the tracer: their radiance, and places drawn by it.

Rays do not meet them, as VTK does not draw them. Each pixel of an image is one colour, as
vtkAreaLight has it. Mitsuba's own rectangles, which are surfaces, are what tests compare this with.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import description

import drjit as dr  # isort: skip  needs the variant that shading chooses
import mitsuba as mi  # isort: skip


class Rectangle:
    """Radiance of an `AreaLight` of a description, in tracer coordinates."""

    def __init__(self, light: description.AreaLight, center: np.ndarray, scale: float) -> None:
        self.image = light.image.astype(np.float64)
        self.rows, self.columns = self.image.shape[:2]
        self.two_sided = light.two_sided
        edge1, edge2 = light.edge1 * scale, light.edge2 * scale
        # A place is the corner + u edge1 + v edge2; u and v are its products with these.
        across1, across2 = np.cross(edge2, light.normal), np.cross(light.normal, edge1)
        vectors = (edge1, edge2, across1 / (edge1 @ across1), across2 / (edge2 @ across2))
        self.edge1, self.edge2, self.dual1, self.dual2 = (
            mi.ScalarVector3f(vector.tolist()) for vector in vectors
        )
        self.corner = mi.ScalarPoint3f(((light.corner - center) * scale).tolist())
        self.normal = mi.ScalarVector3f(light.normal.tolist())
        self.area = light.area * scale**2
        brightness = self.image.mean(axis=-1)
        self.mean = float(brightness.mean())
        self.pixels = mi.DiscreteDistribution(brightness.ravel())
        self.table = mi.Float(self.image.astype(np.float32).ravel())

    def radiance(self, u: Any, v: Any) -> Any:
        """Return the radiance at a place of 0 to 1: of the pixel that it lies in."""
        if self.rows * self.columns == 1:
            return mi.Color3f(*self.image[0, 0].tolist())
        row = dr.minimum(mi.UInt32(v * self.rows), self.rows - 1)
        column = dr.minimum(mi.UInt32(u * self.columns), self.columns - 1)
        return dr.gather(mi.Color3f, self.table, row * self.columns + column)

    def sample(self, numbers: Any) -> tuple[Any, Any]:
        """Return u and v of a place drawn with the density that `density` has."""
        index, rest = self.pixels.sample_reuse(numbers.x)
        row = index // self.columns
        return (index - row * self.columns + rest) / self.columns, (row + numbers.y) / self.rows

    def place(self, u: Any, v: Any) -> Any:
        """Return the point at u and v."""
        edges = mi.Vector3f(self.edge1) * u + mi.Vector3f(self.edge2) * v
        return mi.Point3f(self.corner) + edges

    def meet(self, point: Any, direction: Any) -> tuple[Any, Any, Any]:
        """Return whether a ray from a point meets it, and u and v there, 0 where it does not."""
        normal, away = mi.Vector3f(self.normal), mi.Point3f(self.corner) - point
        slope = dr.dot(normal, direction)
        distance = dr.dot(normal, away) / dr.select(slope == 0.0, 1.0, slope)
        offset = direction * distance - away
        u, v = dr.dot(mi.Vector3f(self.dual1), offset), dr.dot(mi.Vector3f(self.dual2), offset)
        met = (slope != 0.0) & (distance > 0.0)
        met &= (u >= 0.0) & (u <= 1.0) & (v >= 0.0) & (v <= 1.0)
        return met, dr.select(met, u, 0.0), dr.select(met, v, 0.0)

    def density(self, radiance: Any, way: Any) -> Any:
        """Return the density per steradian of `sample`, and where light is sent along a way.

        `way`: from a receiver to the place that has the radiance. The density is in proportion to
        the mean of the colours.
        """
        square = dr.squared_norm(way)
        slope = dr.dot(mi.Vector3f(self.normal), way) * dr.rsqrt(square)
        sent = dr.abs(slope) > 0.0 if self.two_sided else slope < 0.0
        share = (radiance.x + radiance.y + radiance.z) / (3.0 * self.mean * self.area)
        return share * square / dr.select(sent, dr.abs(slope), 1.0), sent
