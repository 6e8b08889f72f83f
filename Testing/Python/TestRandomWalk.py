# SPDX-License-Identifier: BSD-3-Clause
"""The random walk from Python: the sampler by name, its page, the report, all bounces of a scene."""

import re
import unittest

import support
from rooms import make_actor
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkLightKit, vtkRenderer

import vtkindirect
from vtkindirect import frames, images, metrics, references, settings, wrapped

PAGE = support.SOURCE / "Documentation" / "methods" / "random-walk.md"


@unittest.skipUnless(
    wrapped.has("vtkRandomWalkLightSampler"), "vtkRandomWalkLightSampler was not built"
)
class RandomWalk(unittest.TestCase):
    def test_every_property_is_on_its_page(self) -> None:
        text = PAGE.read_text(encoding="utf-8")
        names = settings.properties(vtkindirect.vtkRandomWalkLightSampler())
        self.assertGreater(len(names), 2)
        for name in names:
            self.assertIn(f"`{name}`", text)

    def test_frame_and_report(self) -> None:
        loaded = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(loaded, (48, 48))
        vtkindirect.enable(
            loaded.renderer,
            "gather",
            "random_walk",
            number_of_lights=500,
            number_of_bounces=3,
            shadows=False,
        )
        loaded.render_window.Render()
        report = vtkindirect.report(loaded.renderer)
        modelled = {entry["what"]: entry["why"] for entry in report["modelled"]}
        self.assertIn("paths through 34 triangles", modelled["random walk"])
        self.assertIn("lights without maps", modelled)
        self.assertNotIn("bounces beyond 1", [entry["what"] for entry in report["left_out"]])
        self.assertAlmostEqual(report["virtual_lights"], 500, delta=50)
        self.assertEqual(report["counters"]["faces_drawn"], 0)
        lights = images.copy_buffer(loaded.renderer, "lights").reshape(-1, 12)
        self.assertTrue((lights[:, 3] > 0.0).all())
        loaded.render_window.Finalize()

    def test_few_paths_where_nearly_all_leave_the_scene(self) -> None:
        """Cubes far apart reflect to each other little: eight paths for each vertex at most."""
        renderer = vtkRenderer()
        for x in range(3):
            cube = vtkCubeSource()
            cube.SetCenter(3 * x, 0, 0)
            renderer.AddActor(make_actor(cube))
        window = vtkindirect.render_window((48, 48), offscreen=True)
        window.AddRenderer(renderer)
        self.addCleanup(window.Finalize)
        vtkLightKit().AddLightsToRenderer(renderer)
        renderer.ResetCamera()
        vtkindirect.enable(renderer)
        window.Render()
        modelled = vtkindirect.report(renderer)["modelled"]
        walk = next(entry["why"] for entry in modelled if entry["what"] == "random walk")
        paths, _, vertices = (int(number) for number in re.findall(r"\d+", walk))
        self.assertGreater(vertices, 0)
        self.assertLess(8 * vertices, paths)  # fewer than one of eight meets another surface
        self.assertLess(paths, 530000)  # 65,536 vertices were wanted

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "references are OpenEXR files")
    def test_all_bounces(self) -> None:
        # Beside all bounces of the path tracer; the page has all scenes. One bounce is half as
        # bright. Bounds are twice what was measured.
        for name, relmse in (("cornell_box", 0.018), ("two_rooms", 0.006)):
            stored = support.SOURCE / "Testing" / "Reference" / "data" / f"{name}.exr"
            expected = references.read_layer(stored, "R3")
            loaded = vtkindirect.load_scene(support.SCENES / f"{name}.json")
            frames.open_window(loaded, (expected.shape[1], expected.shape[0]))
            vtkindirect.enable(loaded.renderer, number_of_bounces=16)
            for _ in range(20):
                loaded.render_window.Render()
                report = vtkindirect.report(loaded.renderer)
                if not report["counters"]["tiles_left"]:
                    break
            modelled = [entry["what"] for entry in report["modelled"]]
            self.assertIn("bounces 2 to 16", modelled)
            irradiance = images.copy_buffer(loaded.renderer, "irradiance")
            found = metrics.compare(irradiance, expected, references.mask(loaded))
            self.assertLess(found.relmse, relmse, name)
            self.assertLess(abs(found.bias), 0.05, name)
            loaded.render_window.Finalize()


if __name__ == "__main__":
    unittest.main()
