# SPDX-License-Identifier: BSD-3-Clause
"""Bonds as rows of spheres, held to rays that meet cylinders."""

from __future__ import annotations

import unittest

import proxy_bonds


class BondTest(unittest.TestCase):
    """Sticks of which all that is seen is bonds."""

    def test_sticks(self) -> None:
        """Spheres are as near to rays as maps in motion; without those of bonds they are not."""
        errors = proxy_bonds.measure("LiquoriceStick", 60)
        # 256 rays of a receiver have an error of about 0.01; tables of atoms alone have 0.05.
        self.assertLess(errors["spheres"], 0.03)
        self.assertGreater(errors["spheres of atoms alone"], 0.03)
        self.assertLess(errors["spheres"], errors["64 maps, moving"])


if __name__ == "__main__":
    unittest.main()
