# SPDX-License-Identifier: BSD-3-Clause
"""The table of bounces, on one small scene."""

from __future__ import annotations

import io
import unittest
from contextlib import redirect_stdout

import bounces
import support


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Bounces(unittest.TestCase):
    def test_all_bounces_are_nearer_to_the_path_tracer(self) -> None:
        said = io.StringIO()
        with redirect_stdout(said):
            scene = support.SCENES / "contact_corner.json"
            self.assertEqual(bounces.main(["--frames", "2", str(scene)]), 0)
        cells = said.getvalue().splitlines()[-1].split("|")
        one, every = float(cells[2]), float(cells[4])
        # Measured 0.033 and 0.0008: a fifth of the light is of later bounces.
        self.assertGreater(one, 0.02)
        self.assertLess(every, 0.004)


if __name__ == "__main__":
    unittest.main()
