# SPDX-License-Identifier: BSD-3-Clause
"""Small scenes, each hard for some method: nothing set, and left alone, beside path tracing of all bounces."""

from __future__ import annotations

import unittest

import support
import vtkindirect
from vtkindirect import frames, metrics, references

BOUNDS = {
    "contact_corner": (0.0005, 0.0005, 0.004),
    "grazing_light": (0.0041, 0.0016, 0.015),
    "two_rooms": (0.0014, 0.0014, 0.006),
    "folded_sheet": (0.006, 0.0017, 0.005),
    "low_sun": (0.016, 0.0048, 0.034),
    "sky_groove": (0.0002, 0.0001, 0.009),
    "sky_machine": (0.0008, 0.0004, 0.008),
}
"""relMSE (best 99 %) of the first picture, and refined once; bias of both. A fifth above what was found."""


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Truth(unittest.TestCase):
    def measure(self, name: str, refinements: int) -> metrics.Errors:
        scene = vtkindirect.load_scene(support.SCENES / f"{name}.json")
        stored = support.SCENES.parent / "Reference" / "data" / f"{name}.exr"
        size = references.natural_size(stored)
        window = frames.open_window(scene, size)
        self.addCleanup(window.Finalize)
        judges = references.collect(scene, size, stored)
        vtkindirect.enable(
            scene.renderer, "auto", lighting="scene", NumberOfRefinements=refinements
        )
        window.Render()
        for _ in frames.fill([scene.renderer.GetPass()]):
            window.Render()
        seen = {name: vtkindirect.copy_buffer(scene.renderer, name) for name in judges.buffers()}
        return judges.errors(seen)[judges.main]

    def test_hard_scenes(self) -> None:
        for name, (first, refined, bias) in BOUNDS.items():
            for refinements, most in ((0, first), (1, refined)):
                with self.subTest(scene=name, refinements=refinements):
                    found = self.measure(name, refinements)
                    print(f"{name} {refinements}: relMSE {found.relmse_trimmed:.4f}, bias {found.bias:+.4f}")
                    self.assertLess(found.relmse_trimmed, most)
                    self.assertLess(abs(found.bias), bias)


if __name__ == "__main__":
    unittest.main()
