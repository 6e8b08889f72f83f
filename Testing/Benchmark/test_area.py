# SPDX-License-Identifier: BSD-3-Clause
"""The figures of area lights, at small sizes."""

from __future__ import annotations

import io
import unittest
from contextlib import redirect_stdout
from importlib.util import find_spec
from pathlib import Path
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import area_clusters
import area_methods
import area_sweep
import area_video
import slices
import support


def read(path: Path) -> np.ndarray:
    """Return a PNG's pixels, bottom row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[..., :3].astype(int)


class Film(unittest.TestCase):
    def test_every_data_set_has_pictures(self) -> None:
        count = len(slices.NAMES)
        shown = [slices.frame((k + 0.5) / count, 48) for k in range(count)]
        for picture in shown:
            self.assertEqual(picture.shape, (48, 48, 3))
            self.assertTrue((picture >= 0.0).all() and (picture <= 1.0).all())
            self.assertGreater(picture.std(), 0.05)
        for first, second in ((0, 1), (0, 2), (1, 2)):
            self.assertGreater(np.abs(shown[first] - shown[second]).mean(), 0.1)
        # The film ends in the last one.
        self.assertTrue((slices.frame(1.0, 48) == slices.slice_of(slices.NAMES[-1], 1.0, 48)).all())


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Figures(support.DirectoryTest):
    def run_main(self, main: object, *arguments: str) -> tuple[np.ndarray, str]:
        """Run a figure's command; returns its picture and what it says."""
        path = self.directory / "figure.png"
        said = io.StringIO()
        with redirect_stdout(said):
            self.assertEqual(main([*arguments, str(path)]), 0)
        return read(path), said.getvalue()

    def test_video(self) -> None:
        size = ("--size", "48x48", "--rounds", "2", "--strip", "96x72")
        # Two frames in place of 24: the later ones refine penumbrae.
        with mock.patch.object(area_video, "FILLING_FRAMES", 2):
            picture, said = self.run_main(area_video.main, *size)
        self.assertEqual(picture.shape, (72, 3 * 96 + 2 * area_video.GAP, 3))
        parts = [picture[:, i * (96 + area_video.GAP) :][:, :96] for i in range(3)]
        # The brain's light is blue, the fire's red: also where the display is not seen.
        sofa = [part[10:30, :40].mean(axis=(0, 1)) for part in parts]
        self.assertGreater(sofa[0][2], sofa[0][0])
        self.assertGreater(sofa[2][0] / sofa[2][2], sofa[0][0] / sofa[0][2])
        self.assertRegex(said, r"^48 x 48, .* frames a second .* what plain VTK's frame takes")

    def test_sweep(self) -> None:
        said = io.StringIO()
        with redirect_stdout(said):
            code = area_sweep.main(
                ["--size", "96x96", "--rounds", "1", "--lamps", "1", "2", "--receivers", "200"]
            )
        self.assertEqual(code, 0)
        rows = [line.split("|")[1:-1] for line in said.getvalue().splitlines() if line[:2] == "| "]
        self.assertEqual(len(rows), 1 + 3 * 2 * 2)
        for row in rows[1:]:
            # A fifth: 16 points of a lamp in a picture of 96 pixels. Shadows left out at 0.05.
            self.assertLess(float(row[-2]), 0.2 if row[2].strip() == "yes" else 0.05, row)
            self.assertLess(abs(float(row[-1])), 0.03, row)

    def test_reference(self) -> None:
        # Without blocks a point under a lamp gets what Lambert's polygon says, off a block's shadow.
        place = area_sweep.corner(0) + (0.08, -0.5, 0.08)
        receivers = area_sweep.Receivers(
            (np.zeros(1, int), np.zeros(1, int)), place[None], np.array([[0.0, 1.0, 0.0]])
        )
        reference = area_sweep.Reference(receivers, 1)
        lamp = area_sweep.make_lamp("c", 0)
        half = 0.08 / 0.5
        angle = half / np.sqrt(1.0 + half * half)
        expected = area_sweep.RADIANCE * 4.0 / np.pi * angle * np.arctan(angle)
        found = reference.sum([lamp], False)[0, 0]
        self.assertAlmostEqual(found / expected, 1.0, delta=2e-3)
        # A segment through the tall block, and one beside it.
        inside = np.array([[[0.33, 0.3, 0.9], [0.95, 0.3, 0.05]]])
        hidden = area_sweep.are_hidden(np.array([[0.33, 0.3, 0.02]]), inside)
        self.assertEqual(hidden.tolist(), [[True, False]])

    @unittest.skipUnless(find_spec("matplotlib"), "matplotlib is not installed")
    def test_clusters(self) -> None:
        picture, said = self.run_main(area_clusters.main, "--lights", "24", "--dense", "8")
        self.assertGreater(picture.std(), 10.0)
        lines = said.splitlines()
        self.assertEqual(len(lines), 4)
        for line in lines:
            count = int(line.split(": ")[1].split()[0])
            self.assertLessEqual(count, 24)
            self.assertGreaterEqual(count, 24 if "variance" in line else 8)
            # Single precision of some ten thousand pixels.
            self.assertLess(float(line.split()[-1]), 1e-5)

    def test_methods(self) -> None:
        said = io.StringIO()
        with redirect_stdout(said), mock.patch.object(area_methods, "FRAMES", 1):
            self.assertEqual(area_methods.main(["area_cornell"]), 0)
        rows = [line.split(" | ") for line in said.getvalue().splitlines()[2:]]
        errors = {row[1]: float(row[2]) for row in rows}
        self.assertEqual(set(errors), set(area_methods.METHODS))
        self.assertLess(errors["virtual lights"], 0.005)
        # The paper has no shadows.
        self.assertGreater(errors.popitem()[1], 0.1)


if __name__ == "__main__":
    unittest.main()
