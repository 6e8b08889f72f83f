# SPDX-License-Identifier: BSD-3-Clause
"""The references that are stored: each belongs to its scene file and is what its record says."""

from __future__ import annotations

import unittest

import numpy as np
from vtkindirect import wrapped
from vtkmodules.util.numpy_support import vtk_to_numpy

import make_references
import provenance

PAIRS = (("R2", "R3"), ("S1", "S3"), ("A1", "A3"))


def pairs_of(record: dict) -> list[tuple[str, str]]:
    """Return the pairs of references that a record holds: the first part, and all of it."""
    return [pair for pair in PAIRS if pair[0] in record]


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
                self.assertTrue(pairs_of(record))
                for one, every in pairs_of(record):
                    limit = settings.emitted_noise if one in ("S1", "A1") else settings.noise
                    self.assertLessEqual(record[one]["noise_relmse"], 2 * limit)
                    self.assertLessEqual(record[every]["noise_relmse"], 2 * settings.deep_noise)
                    self.assertLessEqual(record[every]["left_out_by_depth"], 2 * settings.tail)
                for name in {"S1", "A1"} & record.keys():
                    self.assertLessEqual(record[name]["rmse_over_mean"], 0.01)
                    self.assertGreaterEqual(record[name]["samples"], 1024)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_images_hold_what_the_records_say(self) -> None:
        for name in make_references.SCENES:
            with self.subTest(name):
                record = provenance.read(name)
                path = str(provenance.paths(name)[0])
                names = [name for pair in pairs_of(record) for name in pair]
                wanted = [*names, *(f"{name}_error" for name in names), "albedo", "direct", "depth"]
                layers = {layer: read_layer(path, layer) for layer in wanted}
                seen = read_layer(path, "")[..., 3] > 0.5
                self.assertEqual(seen.shape, tuple(record["image"]["size"][::-1]))
                self.assertEqual(int(seen.sum()), record["receivers"])
                for layer, values in layers.items():
                    self.assertTrue(np.isfinite(values).all(), layer)
                    self.assertTrue((values >= 0.0).all(), layer)
                for layer in names:
                    mean = layers[layer][seen].mean(axis=0)
                    self.assertTrue(np.allclose(mean, record[layer]["mean"], rtol=2e-3), layer)
                for one, every in pairs_of(record):
                    beyond = layers[every] - layers[one]
                    self.assertTrue((beyond >= -1e-3 * layers[every].max()).all())

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_first_bounce_of_the_sky(self) -> None:
        """S2 is the part of S3 beyond S1 that the first bounce holds, by paths of other seeds.

        The standard errors of the means are below 0.1 % of S2, those of S3 beyond S1 likewise, and
        halves keep 0.05 % of each.
        """
        for name in make_references.SKY_SPHERES:
            with self.subTest(name):
                record = provenance.read(name)
                path = str(provenance.paths(name)[0])
                seen = read_layer(path, "")[..., 3] > 0.5
                mean = read_layer(path, "S2")[seen].mean()
                self.assertAlmostEqual(mean / np.mean(record["S2"]["mean"]), 1.0, delta=2e-3)
                beyond = np.mean(record["S3"]["mean"]) - np.mean(record["S1"]["mean"])
                first = beyond * record["S3"]["fraction_of_bounce"][0]
                self.assertAlmostEqual(mean / first, 1.0, delta=5e-3)

    def test_they_are_small(self) -> None:
        size = sum(path.stat().st_size for path in provenance.DATA.iterdir())
        self.assertLess(size, 20e6)
