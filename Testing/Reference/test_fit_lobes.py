# SPDX-License-Identifier: BSD-3-Clause
"""Transformed cosines for the lobe of VTK's PBR: the fit, and that the table is the script's."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

import numpy as np

import fit_lobes

TABLE = (
    Path(__file__).resolve().parents[2]
    / "Module/Rendering/Private/Maps/vtkIndirectLobeTable.inl"
)


def read_table() -> np.ndarray:
    """Return the table that is compiled."""
    numbers = re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", TABLE.read_text(encoding="utf-8"))
    return np.array(numbers, dtype=float).reshape(fit_lobes.ENTRIES, fit_lobes.ENTRIES, 6)


class Table(unittest.TestCase):
    def test_rows_are_those_of_the_script(self) -> None:
        table = read_table()
        for number in (2, fit_lobes.ENTRIES - 1):
            made = fit_lobes.make_row(number)
            # Five digits are written; where the fit ends is known to a thousandth.
            self.assertLess(np.abs(made - table[number]).max(), 5e-3, number)


class Fit(unittest.TestCase):
    def test_integral_of_the_lobe(self) -> None:
        # By sums over the hemisphere, against 1600 samples.
        count = 400
        u, v = np.meshgrid((np.arange(count) + 0.5) / count, (np.arange(count) + 0.5) / count)
        sine = np.sqrt(1.0 - u.ravel() ** 2)
        phi = 2.0 * np.pi * v.ravel()
        light = np.stack((sine * np.cos(phi), sine * np.sin(phi), u.ravel()), axis=1)
        for roughness in (0.5, 1.0):
            for cosine in (1.0, 0.6, 0.2):
                value, facing = fit_lobes.lobe(roughness, fit_lobes.view_of(cosine), light)
                whole, grazing, _ = fit_lobes.integrals(roughness, cosine)
                self.assertAlmostEqual(whole, 2.0 * np.pi * value.mean(), delta=5e-3)
                expected = 2.0 * np.pi * (value * (1.0 - facing) ** 5).mean()
                self.assertAlmostEqual(grazing, expected, delta=5e-3)

    def test_share_above_the_horizon(self) -> None:
        # The density is one over the part above, whatever the transform.
        count = 1000
        u, v = np.meshgrid((np.arange(count) + 0.5) / count, (np.arange(count) + 0.5) / count)
        sine = np.sqrt(1.0 - u.ravel() ** 2)
        phi = 2.0 * np.pi * v.ravel()
        light = np.stack((sine * np.cos(phi), sine * np.sin(phi), u.ravel()), axis=1)
        middle = np.array((-0.8, 0.0, 0.6))
        matrix = fit_lobes.transform((0.5, 0.3, -0.4), middle)
        self.assertLess(fit_lobes.share_above(matrix), 0.97)
        total = 2.0 * np.pi * fit_lobes.transformed(matrix, light).mean()
        self.assertAlmostEqual(total, 1.0, delta=5e-3)

    def test_errors(self) -> None:
        for roughness, cosine, most in ((0.1, 0.9, 0.02), (0.4, 0.8, 0.06), (1.0, 0.5, 0.06)):
            start = (roughness**2, roughness**2, 0.0)
            _, matrix = fit_lobes.fit(roughness, cosine, start)
            self.assertLess(fit_lobes.compare(roughness, cosine, matrix, 1.0), most)


if __name__ == "__main__":
    unittest.main()
