# SPDX-License-Identifier: BSD-3-Clause
"""The sky of a description for the tracer: its radiance, and directions drawn by it.

Both take each pixel of the image as one colour, as vtkEnvironmentLight does. Mitsuba's own emitter
interpolates between pixels; it is what tests compare this with.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import description

import drjit as dr  # isort: skip  needs the variant that shading chooses
import mitsuba as mi  # isort: skip


class Sky:
    """Radiance from infinitely far away, of an `Environment` of a description."""

    def __init__(self, environment: description.Environment) -> None:
        self.image = environment.image.astype(np.float64)
        self.rows, self.columns = self.image.shape[:2]
        self.is_uniform = self.rows * self.columns == 1
        self.axes = [
            mi.ScalarVector3f(axis.tolist())
            for axis in (environment.right, environment.up, environment.back)
        ]
        # Sines of the latitudes between rows: the height over the horizon on the unit sphere.
        heights = np.sin(np.pi * (np.arange(self.rows + 1) / self.rows - 0.5))
        light = self.image.mean(axis=-1) * environment.solid_angles()[:, None]
        self.total = float(light.sum())
        self.pixels = mi.DiscreteDistribution(light.ravel()) if self.total > 0.0 else None
        self.table = mi.Float(self.image.astype(np.float32).ravel())
        self.height_table = mi.Float(heights.astype(np.float32))

    def radiance(self, direction: Any) -> Any:
        """Return the radiance from a unit direction in world coordinates: of the nearest pixel."""
        if self.is_uniform:
            return mi.Color3f(*self.image[0, 0].tolist())
        x, y, z = (dr.dot(mi.Vector3f(axis), direction) for axis in self.axes)
        across = dr.atan2(x, -z) * (0.5 * dr.inv_pi) + 0.5
        upward = dr.asin(dr.clip(y, -1.0, 1.0)) * dr.inv_pi + 0.5
        row = dr.minimum(mi.UInt32(upward * self.rows), self.rows - 1)
        column = dr.minimum(mi.UInt32(across * self.columns), self.columns - 1)
        return dr.gather(mi.Color3f, self.table, row * self.columns + column)

    def sample(self, numbers: Any) -> Any:
        """Return a direction drawn with `density` from two numbers of 0 to 1."""
        if self.pixels is None:  # a black sky: any direction will do
            return mi.warp.square_to_uniform_sphere(numbers)
        index, rest = self.pixels.sample_reuse(numbers.x)
        row = index // self.columns
        longitude = 2.0 * math.pi * ((index - row * self.columns + rest) / self.columns - 0.5)
        below = dr.gather(mi.Float, self.height_table, row)
        above = dr.gather(mi.Float, self.height_table, row + 1)
        y = below + numbers.y * (above - below)
        flat = dr.sqrt(dr.maximum(1.0 - y * y, 0.0))
        right, up, back = (mi.Vector3f(axis) for axis in self.axes)
        return right * (flat * dr.sin(longitude)) + up * y - back * (flat * dr.cos(longitude))

    def density(self, radiance: Any) -> Any:
        """Return the density, per steradian, of `sample` at a direction with a radiance.

        It is in proportion to the mean of the colours; 0 where nothing is drawn by the radiance.
        """
        if self.is_uniform or self.pixels is None:
            return 0.0
        return (radiance.x + radiance.y + radiance.z) / (3.0 * self.total)
