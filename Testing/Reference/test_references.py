# SPDX-License-Identifier: BSD-3-Clause
"""The references that are stored: each belongs to its scene file and is what its record says."""

from __future__ import annotations

import unittest

import numpy as np
from vtkindirect import wrapped
from vtkmodules.util.numpy_support import vtk_to_numpy

import make_references
import provenance

LAYERS = ("R2", "R3", "R2_error", "R3_error", "albedo", "direct", "depth")


def read_layer(path: str, layer: str) -> np.ndarray:
    """Return a layer of an EXR file, (height, width, components), bottom row first."""
    reader = wrapped.get("vtkOpenEXRReader")()
    reader.SetFileName(path)
    reader.SetLayer(layer)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1).astype(np.float64)


class Stored(unittest.TestCase):
    def test_all_are_current(self) -> None:
        for name in make_references.SCENES:
            with self.subTest(name):
                self.assertIsNone(provenance.why_stale(name))

    def test_noise_is_low_enough(self) -> None:
        settings = make_references.Settings()
        for name in make_references.SCENES:
            with self.subTest(name):
                record = provenance.read(name)
                self.assertLessEqual(record["R2"]["noise_relmse"], 2 * settings.noise)
                self.assertLessEqual(record["R3"]["noise_relmse"], 2 * settings.deep_noise)
                self.assertLessEqual(record["R3"]["left_out_by_depth"], 2 * settings.tail)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_images_hold_what_the_records_say(self) -> None:
        for name in make_references.SCENES:
            with self.subTest(name):
                record = provenance.read(name)
                path = str(provenance.paths(name)[0])
                layers = {layer: read_layer(path, layer) for layer in LAYERS}
                seen = read_layer(path, "")[..., 3] > 0.5
                self.assertEqual(seen.shape, tuple(record["image"]["size"][::-1]))
                self.assertEqual(int(seen.sum()), record["receivers"])
                for layer, values in layers.items():
                    self.assertTrue(np.isfinite(values).all(), layer)
                    self.assertTrue((values >= 0.0).all(), layer)
                for layer in ("R2", "R3"):
                    mean = layers[layer][seen].mean(axis=0)
                    self.assertTrue(np.allclose(mean, record[layer]["mean"], rtol=2e-3), layer)
                beyond = layers["R3"] - layers["R2"]
                self.assertTrue((beyond >= -1e-3 * layers["R3"].max()).all())

    def test_they_are_small(self) -> None:
        size = sum(path.stat().st_size for path in provenance.DATA.iterdir())
        self.assertLess(size, 20e6)
