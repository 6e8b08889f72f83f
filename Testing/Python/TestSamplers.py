# SPDX-License-Identifier: BSD-3-Clause
"""Samplers of the lights' maps from Python: by name, by properties, and what they draw."""

import unittest

import numpy as np

import support
import vtkindirect
from vtkindirect import UsageError, frames, settings, wrapped

PAGE = support.SOURCE / "Documentation" / "methods" / "importance-sampling.md"
NAME = "vtkImportanceLightSampler"


@unittest.skipUnless(wrapped.has(NAME), f"{NAME} was not built")
class Samplers(unittest.TestCase):
    def setUp(self) -> None:
        self.scene = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(self.scene, (48, 48))
        self.addCleanup(self.scene.render_window.Finalize)

    def render(self, sampler: str, **values: object) -> np.ndarray:
        vtkindirect.enable(
            self.scene.renderer,
            "gather",
            sampler,
            visibility="none",
            interpolation=False,
            reflective_shadow_map_resolution=128,
            # Lights of samplers alone; lights of later bounces would stand beside them.
            number_of_bounces=1,
            **values,
        )
        self.scene.render_window.Render()
        return vtkindirect.copy_buffer(self.scene.renderer, "bounce").astype(float)

    def lights(self) -> np.ndarray:
        return vtkindirect.copy_buffer(self.scene.renderer, "lights").reshape(-1, 12)

    def test_every_property_is_on_its_page(self) -> None:
        text = PAGE.read_text(encoding="utf-8")
        for sampler in (vtkindirect.vtkImportanceLightSampler(),
                        vtkindirect.vtkUniformLightSampler()):  # fmt: skip
            for name in settings.properties(sampler):
                self.assertIn(f"`{name}`", text)
                for choice in settings.choices(sampler, name):
                    self.assertIn(f"`{choice}`", text)

    def test_it_is_nearer_to_all_texels(self) -> None:
        truth = self.render("uniform", mode="all_texels")
        errors = {}
        for sampler in ("uniform", "importance"):
            logarithms = []
            for count in (64, 128, 256):
                image = self.render(sampler, mode="virtual_lights", number_of_lights=count)
                logarithms.append(np.log(np.sqrt(((image - truth) ** 2).mean())))
                self.assertEqual(
                    vtkindirect.report(self.scene.renderer)["virtual_lights"], count
                )
            errors[sampler] = np.exp(np.mean(logarithms))
        # The light falls on little of what it sees; measured 0.65 with maps of 512 texels.
        self.assertLess(errors["importance"], 0.85 * errors["uniform"])

    def test_properties(self) -> None:
        self.render("importance", mode="virtual_lights", number_of_lights=100, warping="together",
                    levels=3, evenness=0.5, occlusion=0.0)  # fmt: skip
        rows = self.lights()
        self.assertEqual(len(rows), 100)
        self.assertTrue((rows[:, 8:11].max(axis=1) > 0.0).all())
        with self.assertRaises(UsageError):
            self.render("importance", evenness=1.5)
        with self.assertRaises(UsageError):
            self.render("importance", warping="both")

    def test_whole_maps(self) -> None:
        self.render("uniform", mode="virtual_lights", lit_texels=False)
        dark = (self.lights()[:, 8:11].max(axis=1) == 0.0).sum()
        self.render("uniform", lit_texels=True)
        self.assertGreater(dark, 0)
        self.assertEqual((self.lights()[:, 8:11].max(axis=1) == 0.0).sum(), 0)


class Tree(unittest.TestCase):
    def lights(self) -> int:
        self.scene.render_window.Render()
        return int(vtkindirect.report(self.scene.renderer)["virtual_lights"])

    def test_scattered_light_takes_more_lights_where_there_is_time(self) -> None:
        self.scene = vtkindirect.load_scene(support.SCENES / "many_objects.json")
        frames.open_window(self.scene, (48, 48))
        window, renderer = self.scene.render_window, self.scene.renderer
        self.addCleanup(window.Finalize)
        vtkindirect.enable(renderer, "gather", visibility="none")
        still = self.lights()
        self.assertGreater(still, 512)
        self.assertLessEqual(still, 1024)
        # A camera that moves changes nothing, a light that moves does.
        window.SetDesiredUpdateRate(30.0)
        renderer.GetActiveCamera().Azimuth(1.0)
        self.assertEqual(self.lights(), still)
        light = renderer.GetLights().GetItemAsObject(0)
        x, y, z = light.GetPosition()
        light.SetPosition(1.001 * x, y, z)
        moving = self.lights()
        self.assertLessEqual(moving, 256)
        self.assertEqual(self.lights(), moving)
        window.SetDesiredUpdateRate(0.0001)
        self.assertGreater(self.lights(), 512)
        # The user's choice is kept.
        vtkindirect.enable(renderer, "gather", visibility="none", number_of_lights=100)
        self.assertLessEqual(self.lights(), 100)


if __name__ == "__main__":
    unittest.main()
