# SPDX-License-Identifier: BSD-3-Clause
"""HDR-FLIP, and the path tracer as a row of a comparison.

Skipped, with the reason, where there is no reference environment.
"""

from __future__ import annotations

import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkindirect import RenderError, windows, wrapped

import comparison
import reference_environment
import tools


def setUpModule() -> None:
    try:
        tools.tracer_python()
    except tools.ToolError as error:
        raise unittest.SkipTest(str(error)) from None


def spread(shape: tuple[int, ...], seed: int) -> np.ndarray:
    """Values that look random, the same on every machine."""
    count = np.arange(np.prod(shape), dtype=np.float64) + 1000.0 * seed
    return (np.sin(count * 12.9898) * 43758.5453 % 1.0).reshape(shape)


class Flip(unittest.TestCase):
    """HDR-FLIP through the process that computes it."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.flip = reference_environment.Flip(tools.tracer_python())

    @classmethod
    def tearDownClass(cls) -> None:
        cls.flip.close()

    def setUp(self) -> None:
        self.reference = 0.2 + 0.8 * spread((64, 64, 3), 1)
        self.everywhere = np.ones((64, 64), dtype=bool)

    def test_its_version_is_known(self) -> None:
        self.assertRegex(self.flip.version, r"^flip-evaluator \d+\.\d+")

    def test_equal_images_do_not_differ(self) -> None:
        self.assertEqual(self.flip.error(self.reference, self.reference, self.everywhere), 0.0)

    def test_more_difference_is_more(self) -> None:
        errors = [
            self.flip.error(factor * self.reference, self.reference, self.everywhere)
            for factor in (1.01, 1.1, 2.0)
        ]
        self.assertGreater(errors[0], 0.0)
        self.assertEqual(errors, sorted(errors))
        # Two images as different as can be; FLIP's largest answer is 1.
        black = self.flip.error(0.0 * self.reference, self.reference, self.everywhere)
        self.assertGreater(black, 0.5)
        self.assertLessEqual(black, 1.0)

    def test_what_does_not_count_does_not_count(self) -> None:
        mask = self.everywhere.copy()
        mask[:, 40:] = False
        image = self.reference.copy()
        image[:, 40:] = 1000.0
        self.assertEqual(self.flip.error(image, self.reference, mask), 0.0)
        self.assertGreater(self.flip.error(image, self.reference, ~mask), 0.1)

    def test_exposures_are_those_of_the_receivers(self) -> None:
        """Background that is dark, or brighter than all else, changes nothing far from it."""
        image, mask = 1.1 * self.reference, self.everywhere.copy()
        mask[:, 24:] = False
        found = []
        for background in (0.5, 0.0, 1e4):
            reference = self.reference.copy()
            reference[:, 40:] = background
            found.append(self.flip.error(image, reference, mask))
        self.assertGreater(found[0], 0.01)
        # FLIP's filters reach over 16 pixels only with what single precision leaves of them.
        self.assertAlmostEqual(found[1] / found[0], 1.0, delta=1e-3)
        self.assertAlmostEqual(found[2] / found[0], 1.0, delta=1e-3)

    def test_what_cannot_be_compared_is_an_error_and_the_next_is_fine(self) -> None:
        broken = self.reference.copy()
        broken[0, 0, 0] = np.nan
        with self.assertRaisesRegex(RenderError, "not finite"):
            self.flip.error(broken, self.reference, self.everywhere)
        with self.assertRaisesRegex(RenderError, "three channels"):
            self.flip.error(broken[..., 1:2], self.reference[..., 1:2], self.everywhere)
        self.assertEqual(self.flip.error(self.reference, self.reference, self.everywhere), 0.0)

    def test_a_process_that_died_is_an_error(self) -> None:
        flip = reference_environment.Flip(tools.tracer_python())
        flip._process.kill()
        flip._process.wait()
        with self.assertRaisesRegex(RenderError, "HDR-FLIP failed"):
            flip.error(self.reference, self.reference, self.everywhere)


class Traced(unittest.TestCase):
    """The path tracer as rows."""

    def test_a_scene_that_is_not_there_is_an_error(self) -> None:
        rows = [{"name": "0", "samples": 4, "depth": 1}]
        found = reference_environment.trace(
            tools.tracer_python(), tools.SCENES / "none.json", (8, 8), rows
        )
        with self.assertRaisesRegex(RenderError, "the path tracer failed"):
            list(found)

    def test_comparison(self) -> None:
        if not wrapped.has("vtkIndirectIlluminationPass"):
            self.skipTest(wrapped.explain("vtkIndirectIlluminationPass"))
        try:
            windows.start(windows.render_window((8, 8), offscreen=True))
        except RenderError as error:
            self.skipTest(str(error))
        with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
            folder = Path(name)
            sweep = folder / "sweep.json"
            sweep.write_text(
                '{"schema": "vtkindirect.sweep/1", "rows": [{"method": "gather"}],'
                ' "flicker": ["mitsuba one bounce 4 spp", "mitsuba one bounce denoised 4 spp"],'
                ' "path_tracer": {"one_bounce": [4, 64], "all_bounces": [4, 64]}}'
            )
            words = [
                tools.SCENES / "contact_corner.json", "--sweep", sweep,
                "--size", "128x128", "--frames", 2, "-o", folder / "report",
                "--reference-python", tools.tracer_python(),
            ]  # fmt: skip

            def run() -> dict[str, dict[str, str]]:
                done = subprocess.run(
                    [sys.executable, "-B", comparison.__file__, *map(str, words)],
                    env=os.environ, capture_output=True, text=True, check=False,
                )  # fmt: skip
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("left out", done.stdout)
                self.assertNotIn("failed", done.stdout)
                text = (folder / "report" / "rows.csv").read_text()
                return {row["label"]: row for row in csv.DictReader(text.splitlines())}

            rows = run()
            for curve, truth in (("one bounce", "r2"), ("all bounces", "r3")):
                few, many = (rows[f"mitsuba {curve} {n} spp"] for n in (4, 64))
                # Independent samples would make it sixteen times less; stratified ones more than
                # that.
                ratio = float(few[f"relmse_{truth}"]) / float(many[f"relmse_{truth}"])
                self.assertGreater(ratio, 8.0, curve)
                self.assertLess(abs(float(many[f"bias_{truth}"])), 0.01, curve)
                if truth == "r3":
                    self.assertLess(float(many["flip_r3"]), float(few["flip_r3"]))
                self.assertGreater(float(many["indirect_ms"]), 0.0)
            # Noise is new in each frame of the camera's path.
            raw, clean = (float(rows[f"mitsuba one bounce {word}4 spp"]["flicker"])
                          for word in ("", "denoised "))  # fmt: skip
            self.assertGreater(raw, 2.0 * clean)
            self.assertGreater(clean, 0.0)
            self.assertFalse(rows["mitsuba one bounce 64 spp"]["flicker"])
            self.assertGreater(float(rows["gather"]["flip_r3"]), 0.0)
            # Nothing is done twice, and the page is the same.
            journal = (folder / "report" / "rows.jsonl").read_text()
            self.assertEqual(run(), rows)
            self.assertEqual((folder / "report" / "rows.jsonl").read_text(), journal)
