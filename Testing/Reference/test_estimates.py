# SPDX-License-Identifier: BSD-3-Clause
"""Errors of means, where bounces may stop, and how stale references are found out."""

from __future__ import annotations

import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import estimates
import provenance


class Noise(unittest.TestCase):
    def setUp(self) -> None:
        random = np.random.default_rng(11)
        self.truth = random.uniform(0.5, 1.5, size=(40, 30, 3))
        self.valid = np.ones((40, 30), dtype=bool)
        self.batches = [self.truth + random.normal(0, 0.1, self.truth.shape) for _ in range(8)]

    def test_standard_error(self) -> None:
        found = estimates.combine(self.batches, self.valid)
        expected = 0.1 / np.sqrt(8)
        self.assertAlmostEqual(float(np.sqrt((found.error**2).mean())), expected, delta=0.002)
        actual = float(np.sqrt(((found.image - self.truth) ** 2).mean()))
        self.assertAlmostEqual(actual, expected, delta=0.002)

    def test_noise_is_the_relmse_to_the_truth(self) -> None:
        found = estimates.combine(self.batches, self.valid)
        floor = 0.01 * self.truth.mean() ** 2
        actual = (((found.image - self.truth) ** 2) / (self.truth**2 + floor)).mean()
        self.assertAlmostEqual(found.noise(self.valid) / actual, 1.0, delta=0.1)

    def test_sum(self) -> None:
        found = estimates.combine(self.batches, self.valid)
        both = found + found
        self.assertTrue(np.allclose(both.image, 2 * found.image))
        self.assertTrue(np.allclose(both.error, np.sqrt(2) * found.error))
        self.assertTrue(np.allclose(both.mean(), 2 * found.mean()))

    def test_receivers_only(self) -> None:
        self.valid[:20] = False
        found = estimates.combine(self.batches, self.valid)
        self.assertTrue(np.allclose(found.mean(), found.image[20:].mean(axis=(0, 1))))


class Bounces(unittest.TestCase):
    def test_geometric_series(self) -> None:
        means = 0.5 ** np.arange(1, 13)
        for depth in (2, 5, 9):
            self.assertAlmostEqual(estimates.tail(means, depth), 0.5**depth, delta=1e-6)
        self.assertEqual(estimates.depth_for(means, 1.01 * 0.5**6), 6)

    def test_room_that_never_gets_dark(self) -> None:
        means = np.ones(10)
        self.assertEqual(estimates.depth_for(means, 1e-3), 10)
        self.assertGreater(estimates.tail(means, 10), 0.9)

    def test_dark(self) -> None:
        self.assertEqual(estimates.tail(np.zeros(10), 2), 0.0)
        self.assertEqual(estimates.depth_for(np.zeros(10), 1e-3), 2)
        self.assertEqual(estimates.tail(np.array([1.0, 0, 0, 0, 0, 0, 0, 0]), 1), 0.0)


class Staleness(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.scene = self.folder / "some.json"
        (self.folder / "mesh.stl").write_bytes(b"solid")
        self.values = {"name": "some", "actors": [{"file": "mesh.stl"}, {"source": "plane"}]}
        self.scene.write_text(json.dumps(self.values))
        self.data = self.folder / "data"
        self.data.mkdir()
        self.image, self.record = provenance.paths(self.scene, self.data)
        self.image.write_bytes(b"picture")
        self.write()

    def write(self, **changes: object) -> None:
        values = {
            "schema": provenance.SCHEMA,
            "method": provenance.METHOD,
            "scene": {"name": "some", "sha256": provenance.scene_hash(self.scene)},
            "data": provenance.data_hashes(self.scene),
            "image": {"sha256": provenance.file_hash(self.image)},
            **changes,
        }
        self.record.write_text(json.dumps(values))

    def why(self) -> str | None:
        return provenance.why_stale(self.scene, self.data)

    def test_current(self) -> None:
        self.assertIsNone(self.why())
        self.assertTrue(provenance.is_current(self.scene, self.data))

    def test_layout_of_the_text_does_not_matter(self) -> None:
        self.scene.write_text(json.dumps(self.values, indent=4, sort_keys=True))
        self.assertIsNone(self.why())

    def test_changes(self) -> None:
        self.scene.write_text(json.dumps({**self.values, "size": [3, 4]}))
        self.assertEqual(self.why(), "the scene file has changed")
        self.write()
        self.assertIsNone(self.why())
        (self.folder / "mesh.stl").write_bytes(b"other")
        self.assertEqual(self.why(), "a data file has changed")
        self.write()
        self.image.write_bytes(b"another picture")
        self.assertEqual(self.why(), "the image is not the one that was made")
        self.write(method=provenance.METHOD - 1)
        self.assertEqual(self.why(), "it was made by another version of the tools")
        self.image.unlink()
        self.assertEqual(self.why(), "there is no reference")
