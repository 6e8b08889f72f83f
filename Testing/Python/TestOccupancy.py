# SPDX-License-Identifier: BSD-3-Clause
"""Occupancy by name: the methods that sum over virtual lights, the report, the command line."""

import json
import unittest

import support
import vtkindirect
from vtkindirect import frames, settings, sweep, wrapped

METHODS = ("gather", "multiresolution", "reference")
PAGES = ("gather", "multiresolution-splatting", "radiance-hints")
SWEEP = support.SOURCE / "Testing" / "Benchmark" / "occupancy.json"


@unittest.skipUnless(wrapped.has("vtkRSMGatherPass"), "vtkRSMGatherPass was not built")
class Occupancy(unittest.TestCase):
    def test_is_on_the_pages(self) -> None:
        for name in PAGES:
            path = support.SOURCE / "Documentation" / "methods" / f"{name}.md"
            text = path.read_text(encoding="utf-8")
            self.assertIn("`Occupancy`", text)
            self.assertIn("`OccupancyResolution`", text)

    def test_off_but_for_hints(self) -> None:
        self.assertFalse(vtkindirect.vtkRSMGatherPass().GetOccupancy())
        self.assertFalse(vtkindirect.vtkMultiresolutionSplattingPass().GetOccupancy())
        self.assertTrue(vtkindirect.vtkRadianceHintsPass().GetOccupancy())

    def test_sweep_names_properties(self) -> None:
        indirect = vtkindirect.vtkIndirectIlluminationPass()
        for row in sweep.load(SWEEP).rows:
            with self.subTest(row=row.label):
                own = {"gather": vtkindirect.vtkRSMGatherPass}.get(
                    row.method, vtkindirect.vtkMultiresolutionSplattingPass
                )
                parts = [own(), vtkindirect.vtkUniformLightSampler(), indirect]
                settings.apply(parts, row.settings)

    def test_hides_light(self) -> None:
        loaded = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(loaded, (48, 48))
        for method in METHODS:
            with self.subTest(method=method):
                means = {}
                for occupancy in (False, True):
                    # The lights of a map of this size are few enough for the processor.
                    indirect = vtkindirect.enable(
                        loaded.renderer,
                        method,
                        occupancy=occupancy,
                        occupancy_resolution=64,
                        reflective_shadow_map_resolution=32,
                    )
                    loaded.render_window.Render()
                    image = vtkindirect.images.copy_buffer(loaded.renderer, "irradiance")
                    means[occupancy] = image.mean()
                    report = json.loads(indirect.GetReport())
                    what = "visibility between sender and receiver"
                    modelled = {entry["what"]: entry["why"] for entry in report["modelled"]}
                    left_out = [entry["what"] for entry in report["left_out"]]
                    self.assertEqual(what in modelled, occupancy)
                    self.assertEqual(what in left_out, not occupancy)
                self.assertIn("of 64 along the longest edge", modelled[what])
                # Its blocks hide a fifth of the light; the pictures of both are lit.
                self.assertLess(means[True], 0.95 * means[False])
                self.assertGreater(means[True], 0.5 * means[False])
        vtkindirect.disable(loaded.renderer)
        loaded.render_window.Finalize()
