# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of tests that trace: running the tracer, the surfaces that it met, Lambert's formula."""

from __future__ import annotations

import math
import tempfile
import unittest
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import description
import tools


def image_of(values: np.ndarray) -> vtkImageData:
    """Return an array (rows, columns, components), bottom row first, as an image."""
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    flat = np.ascontiguousarray(values).reshape(-1, values.shape[2])
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def polygon_factor(corners: np.ndarray, points: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Return the form factors from points with a normal to a polygon above their horizon.

    Lambert's formula (1760): F = 1 / (2 pi) times the sum over the edges of the angle under which
    an edge is seen times the cosine between the normal and that of the plane through it. `corners`
    (n, 3) clockwise as seen from the points; points (m, 3).
    """
    ways = corners[None] - points[:, None]
    ways /= np.linalg.norm(ways, axis=-1, keepdims=True)
    total = np.zeros(len(points))
    for i in range(len(corners)):
        a, b = ways[:, i], ways[:, (i + 1) % len(corners)]
        across = np.cross(a, b)
        length = np.linalg.norm(across, axis=-1)
        angle = np.arctan2(length, np.einsum("ij,ij->i", a, b))
        total += angle * (across @ normal) / np.where(length > 0.0, length, 1.0)
    return np.abs(total) / (2.0 * math.pi)


class Traced(unittest.TestCase):
    """A test with a folder for descriptions; skipped where there is no tracer."""

    def setUp(self) -> None:
        try:
            tools.tracer_python()
        except tools.ToolError as error:
            self.skipTest(str(error))
        holder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def trace(self, scene: Path, size: tuple[int, int] = (48, 48), **job: Any) -> dict[str, str]:
        tools.describe(scene).save(self.folder)
        return tools.trace(self.folder, {"size": list(size), "surfaces": "seen.npz", **job})

    def batch(self, kind: str, samples: int, depth: int = 1, **more: Any) -> dict[str, Any]:
        return {
            "file": f"{kind}.npz", "kind": kind, "samples": samples, "depth": depth, "seed": [1],
            **more,
        }  # fmt: skip

    def load(self, name: str) -> dict[str, np.ndarray]:
        with np.load(self.folder / name) as arrays:
            return dict(arrays)

    def receivers(self, size: tuple[int, int] = (48, 48)) -> dict[str, np.ndarray]:
        """Return points, normals and albedo of the pixels that have a surface, and where."""
        seen = self.load("seen.npz")
        camera = description.load(self.folder).camera
        origins, ways = camera.rays(*size)
        lengths = seen["depth"] - (origins - np.array(camera.position)) @ np.array(camera.forward)
        points = origins + ways * (lengths / (ways @ np.array(camera.forward)))[..., None]
        where = seen["valid"] > 0
        return {"where": where, "points": points[where], "normals": seen["normal"][where],
                "albedo": seen["albedo"][where]}  # fmt: skip
