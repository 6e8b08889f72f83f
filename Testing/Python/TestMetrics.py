# SPDX-License-Identifier: BSD-3-Clause
"""Each metric against values worked out by hand, and a case in which it must complain."""

from __future__ import annotations

import unittest

import numpy as np

from support import noise
from vtkindirect import metrics


class Compare(unittest.TestCase):
    """Errors of one image."""

    def setUp(self) -> None:
        self.reference = 0.5 + noise((40, 50, 3))

    def test_equal_images_have_no_error(self) -> None:
        errors = metrics.compare(self.reference, self.reference)
        for name, value in errors.as_dict().items():
            self.assertAlmostEqual(value, 1.0 if name == "scale" else 0.0, places=14, msg=name)

    def test_scaled_image(self) -> None:
        errors = metrics.compare(1.03 * self.reference, self.reference)
        self.assertAlmostEqual(errors.bias, 0.03, places=12)
        self.assertAlmostEqual(errors.scale, 1.0 / 1.03, places=12)
        self.assertLess(errors.shape, 1e-12)
        self.assertGreater(errors.nrmse, 0.03)

    def test_constant_offset(self) -> None:
        mean = self.reference.mean()
        errors = metrics.compare(self.reference + 0.1 * mean, self.reference)
        self.assertAlmostEqual(errors.nrmse, 0.1, places=12)
        self.assertAlmostEqual(errors.p99, 0.1, places=12)
        self.assertAlmostEqual(errors.bias, 0.1, places=12)
        self.assertGreater(errors.shape, 0.01)

    def test_relative_error_by_hand(self) -> None:
        reference = np.array([[1.0, 3.0]])
        image = np.array([[2.0, 3.0]])
        expected = 0.5 * 1.0 / (1.0 + 0.01 * 4.0)
        self.assertAlmostEqual(metrics.compare(image, reference).relmse, expected, places=14)

    def test_bias_cancels_what_rmse_keeps(self) -> None:
        ripple = np.where(np.arange(50) % 2 == 0, 0.1, -0.1)[np.newaxis, :, np.newaxis]
        errors = metrics.compare(self.reference + ripple, self.reference)
        self.assertAlmostEqual(errors.bias, 0.0, places=12)
        self.assertGreater(errors.nrmse, 0.09)
        self.assertGreater(errors.shape, 0.09)

    def test_trimming_forgives_one_firefly_only(self) -> None:
        image = self.reference.copy()
        image[3, 4] = 1000.0
        errors = metrics.compare(image, self.reference)
        self.assertGreater(errors.relmse, 10.0)
        self.assertEqual(errors.relmse_trimmed, 0.0)
        image[::2] *= 1.5
        self.assertGreater(metrics.compare(image, self.reference).relmse_trimmed, 0.01)

    def test_percentile_sees_two_per_cent_of_pixels(self) -> None:
        image = self.reference.copy()
        image.reshape(-1, 3)[:40] += 1.0
        self.assertGreater(metrics.compare(image, self.reference).p99, 0.5)
        image = self.reference.copy()
        image.reshape(-1, 3)[:10] += 1.0
        self.assertEqual(metrics.compare(image, self.reference).p99, 0.0)

    def test_leak(self) -> None:
        reference = np.zeros((10, 10))
        reference[:, :5] = 1.0
        image = reference.copy()
        image[:, 5:] = 0.25
        self.assertAlmostEqual(metrics.compare(image, reference).leak, 0.2, places=12)
        self.assertEqual(metrics.compare(reference, reference).leak, 0.0)

    def test_mask_hides_the_rest(self) -> None:
        image = self.reference.copy()
        image[:, 25:] *= 2.0
        mask = np.zeros((40, 50), dtype=bool)
        mask[:, :25] = True
        self.assertEqual(metrics.compare(image, self.reference, mask).nrmse, 0.0)
        self.assertGreater(metrics.compare(image, self.reference, ~mask).nrmse, 0.9)

    def test_what_cannot_be_compared_is_an_error(self) -> None:
        reference = self.reference
        broken = reference.copy()
        broken[0, 0, 0] = np.nan
        cases = (
            (reference[:-1], reference, None),
            (broken, reference, None),
            (reference, broken, None),
            (reference, np.zeros_like(reference), None),
            (reference, reference, np.zeros((40, 50), dtype=bool)),
            (reference, reference, np.ones((4, 5), dtype=bool)),
        )
        for image, against, mask in cases:
            with self.assertRaises(metrics.MetricError):
                metrics.compare(image, against, mask)


class ReceiverMask(unittest.TestCase):
    """Silhouettes and creases are left out, slanted planes are not."""

    def test_slanted_plane_in_perspective(self) -> None:
        x = np.linspace(-0.5, 0.5, 64)
        depth = np.broadcast_to(1.0 / (1.0 - 0.9 * x), (48, 64))
        normal = np.broadcast_to(np.array([0.6, 0.0, 0.8]), (48, 64, 3))
        mask = metrics.receiver_mask(depth, normal)
        self.assertTrue(mask[1:-1, 1:-1].all())
        self.assertFalse(mask[0].any())

    def test_edge_crease_and_background(self) -> None:
        depth = np.ones((20, 30))
        depth[:, 15:] = 2.0
        depth[:, 25:] = 0.0
        normal = np.zeros((20, 30, 3))
        normal[..., 2] = 1.0
        normal[10:, :15] = (0.0, 1.0, 0.0)
        mask = metrics.receiver_mask(depth, normal)
        self.assertFalse(mask[5, 14] or mask[5, 15] or mask[5, 24] or mask[5, 27])
        self.assertFalse(mask[9, 5] or mask[10, 5])
        self.assertTrue(mask[5, 5] and mask[15, 5] and mask[5, 20])
