# SPDX-License-Identifier: BSD-3-Clause
"""The tables and figures of splatting, in small."""

from __future__ import annotations

import io
import unittest
from contextlib import redirect_stdout

import numpy as np
import splatting
import splatting_figures
import support


class Parts(unittest.TestCase):
    """Tests that need no picture."""

    def test_warp_keeps_shares(self) -> None:
        places = splatting_figures.sobol(4000)
        moved = splatting_figures.warp(places, np.full(len(places), 0.8), 1)
        # Four fifths of the places in the lower half, each half still even.
        self.assertAlmostEqual(float((moved[:, 1] < 0.5).mean()), 0.8, delta=2e-3)
        for low in (True, False):
            part = moved[(moved[:, 1] < 0.5) == low, 1] % 0.5
            self.assertAlmostEqual(float(part.mean()), 0.25, delta=2e-3)
        np.testing.assert_array_equal(moved[:, 0], places[:, 0])

    def test_interpolation(self) -> None:
        times, lights = [1.0, 4.0, 16.0], [10, 20, 40]
        self.assertEqual(splatting.at(8.0, times, lights), "28")
        self.assertEqual(splatting.at(32.0, times, lights), "above 40")
        self.assertEqual(splatting.at(0.5, times, lights), "below 10")
        # Errors fall with the number of lights.
        self.assertEqual(splatting.at(3.0, [2.0, 1.0], [10, 20]), "below 10")

    def test_packed_lights(self) -> None:
        random = np.random.default_rng(5)
        lights = random.normal(size=(2000, 3, 4))
        lights[:, 1, :3] /= np.linalg.norm(lights[:, 1, :3], axis=1, keepdims=True)
        lights[:, 2, :3] = np.abs(lights[:, 2, :3])
        for paper, angle, colour in ((False, 1e-4, 2.0**-9), (True, 8e-3, 1.0 / 255.0)):
            held = splatting.packed(lights, paper)
            turned = np.linalg.norm(held[:, 1, :3] - lights[:, 1, :3], axis=1).max()
            self.assertLess(turned, angle)
            self.assertGreater(turned, 0.0)
            largest = lights[:, 2, :3].max()
            self.assertLess(np.abs(held[:, 2, :3] - lights[:, 2, :3]).max(), colour * largest)


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Pictures(support.DirectoryTest):
    """Figures and tables of few pixels."""

    def test_figures(self) -> None:
        for number in ("5", "7", "10"):
            path = self.directory / f"figure{number}.png"
            self.assertEqual(splatting.main(["--figure", number, str(path), "--size", "32"]), 0)
            self.assertGreater(path.stat().st_size, 4000, number)

    def test_tables(self) -> None:
        said = io.StringIO()
        with redirect_stdout(said):
            code = splatting.main(["occlusion", "bits", "--size", "32", "--rounds", "1"])
        self.assertEqual(code, 0)
        rows = [line for line in said.getvalue().splitlines() if line.startswith("| ")]
        self.assertEqual(len(rows), 5 + 4)
        # With the same I_low, lights that are dimmed have smaller splats.
        splats = [float(row.split("|")[-2]) for row in rows[1:5]]
        self.assertLess(splats[1], splats[0])
        self.assertLess(splats[3], splats[2])


if __name__ == "__main__":
    unittest.main()
