# SPDX-License-Identifier: BSD-3-Clause
"""Splatting by name: its properties, what it reports, its buffer, and that its sums are the gather's."""

import json
import unittest

import numpy as np
import support
import vtkindirect
from vtkindirect import frames, images, methods, settings, sweep, wrapped

SWEEP = support.SOURCE / "Testing" / "Benchmark" / "all.json"
COMMON = {"visibility": "none", "number_of_lights": 96}


@unittest.skipUnless(wrapped.has("vtkIndirectSplattingPass"), "vtkIndirectSplattingPass not built")
class Splatting(unittest.TestCase):
    def open(self) -> object:
        loaded = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(loaded, (64, 48))
        self.addCleanup(loaded.render_window.Finalize)
        return loaded

    def test_properties(self) -> None:
        splatting = vtkindirect.vtkIndirectSplattingPass()
        self.assertEqual(splatting.GetMethodName(), "splatting")
        self.assertTrue(splatting.GetFarField())
        self.assertEqual(splatting.GetFarFieldStep(), 8)
        self.assertAlmostEqual(splatting.GetIntensityThreshold(), 0.02)
        for asked, given in ((-1.0, 0.0), (2.0, 1.0)):
            splatting.SetIntensityThreshold(asked)
            self.assertEqual(splatting.GetIntensityThreshold(), given)
        settings.apply([splatting], {"FarField": False})

    def test_page_has_properties(self) -> None:
        path = support.SOURCE / "Documentation" / "methods" / "splatting.md"
        text = path.read_text(encoding="utf-8")
        for name in ("IntensityThreshold", "FarField", "FarFieldStep"):
            self.assertIn(f"`{name}`", text)

    def test_default_sampler(self) -> None:
        plain = vtkindirect.vtkIndirectIlluminationPass()
        for method in ("gather", "splatting", "multiresolution"):
            indirect = vtkindirect.enable(self.open().renderer, method)
            self.assertEqual(
                indirect.GetActiveSampler().GetClassName(),
                plain.GetActiveSampler().GetClassName(),
            )

    def test_sweep_has_rows(self) -> None:
        rows = [row for row in sweep.load(SWEEP).rows if row.method == "splatting"]
        self.assertGreaterEqual(len(rows), 2)

    def test_sums_and_report(self) -> None:
        loaded = self.open()
        renderer = loaded.renderer
        vtkindirect.enable(renderer, "gather", "uniform", interpolation=False, **COMMON)
        loaded.render_window.Render()
        gathered = images.copy_buffer(renderer, "irradiance")

        def splat(**given: object) -> tuple[np.ndarray, dict, float]:
            indirect = vtkindirect.enable(renderer, "splatting", "uniform", **COMMON, **given)
            loaded.render_window.Render()
            report = methods.report(indirect)
            share = [
                float(entry["why"].split()[0]) / 100.0
                for entry in (*report["modelled"], *report["left_out"])
                if entry["what"] == "light beyond the bounds of splats"
            ]
            return images.copy_buffer(renderer, "irradiance"), report, sum(share)

        everything, report, share = splat(intensity_threshold=0.0)
        np.testing.assert_allclose(everything, gathered, rtol=1e-5, atol=1e-6 * gathered.max())
        self.assertEqual(report["method"], "splatting")
        self.assertEqual(share, 0.0)
        self.assertNotIn("beyond the bounds", json.dumps(report["left_out"]))

        cut, report, share = splat(intensity_threshold=0.05, far_field=False)
        self.assertGreater(share, 0.2)
        self.assertLess(cut.sum(), 0.8 * gathered.sum())
        self.assertIn("beyond the bounds", json.dumps(report["left_out"]))

        whole, report, share = splat(
            intensity_threshold=0.05, far_field=True, far_field_step=4
        )
        self.assertGreater(share, 0.2)
        # In an image this small a sample of the far field stands for a tenth of a wall.
        self.assertAlmostEqual(whole.sum() / gathered.sum(), 1.0, delta=0.02)
        self.assertIn("beyond the bounds", json.dumps(report["modelled"]))

    def test_overdraw(self) -> None:
        loaded = self.open()
        vtkindirect.enable(loaded.renderer, "splatting", intensity_threshold=0.0, **COMMON)
        loaded.render_window.Render()
        counts = 256.0 * images.copy_buffer(loaded.renderer, "splat.overdraw")[..., 0]
        # Lights that send nothing have no splat.
        self.assertLessEqual(counts.max(), methods.report(loaded.renderer)["virtual_lights"])
        self.assertGreater(counts.max(), 40)
        np.testing.assert_array_equal(counts, np.round(counts))
        with self.assertRaises(vtkindirect.errors.UsageError):
            images.copy_buffer(loaded.renderer, "splat.nothing")


if __name__ == "__main__":
    unittest.main()
