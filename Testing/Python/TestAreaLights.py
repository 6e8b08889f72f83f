# SPDX-License-Identifier: BSD-3-Clause
"""Light from rectangles in scene files and in `enable`."""

import json
import unittest
from typing import Any

import numpy as np

import support
import vtkindirect
from vtkindirect import images, lighting, load_scene, wrapped
from vtkindirect.errors import SceneError

LAMP = {
    "type": "area",
    "origin": [-0.5, -0.5, 1],
    "point1": [-0.5, 0.5, 1],
    "point2": [0.5, -0.5, 1],
    "radiance": [4, 2, 1],
}


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "the module vtkRenderingIndirect was not built")
class Scenes(support.DirectoryTest):
    def load(self, *lamps: dict[str, Any]) -> Any:
        """Load a scene of a floor under these lights."""
        floor = {"source": "plane", "origin": [-2, -2, 0], "point1": [2, -2, 0], "point2": [-2, 2, 0]}
        values = {
            "schema": "vtkindirect.scene/1",
            "size": [64, 48],
            "camera": {"position": [0, -3, 4], "focal_point": [0, 0, 0], "view_up": [0, 0, 1]},
            "lights": lamps,
            "actors": [floor],
        }
        path = self.directory / "lamp.json"
        path.write_text(json.dumps(values), encoding="utf-8")
        return load_scene(path)

    def test_read(self) -> None:
        scene = self.load(LAMP, {**LAMP, "two_sided": True})
        first, second = scene.area_lights
        self.assertEqual(first.GetRadiance(), (4.0, 2.0, 1.0))
        self.assertEqual(first.GetPoint2(), (0.5, -0.5, 1.0))
        self.assertFalse(first.GetTwoSided())
        self.assertTrue(second.GetTwoSided())
        self.assertFalse(first.GetVisible())
        self.assertEqual(scene.lights, [])

    def test_visible(self) -> None:
        # Seen from below, the side that it sends light to.
        eye = {"position": [0, -1.5, 0.1], "focal_point": [0, 0, 1], "view_up": [0, 0, 1]}
        scene = self.load({**LAMP, "radiance": [0.2, 0.4, 0.6], "visible": True})
        (lamp,) = scene.area_lights
        self.assertTrue(lamp.GetVisible())
        camera = scene.renderer.GetActiveCamera()
        camera.SetPosition(eye["position"])
        camera.SetFocalPoint(eye["focal_point"])
        window = scene.make_window()
        vtkindirect.enable(scene)
        window.Render()
        pixel = images.copy_buffer(scene.renderer, "final")[24, 32]
        self.assertTrue(np.allclose(pixel, (0.2, 0.4, 0.6)), pixel)
        lamp.VisibleOff()
        window.Render()
        pixel = images.copy_buffer(scene.renderer, "final")[24, 32]
        self.assertFalse(np.allclose(pixel, (0.2, 0.4, 0.6)), pixel)
        window.Finalize()

    @unittest.skipUnless(wrapped.has("vtkOpenEXRWriter"), "built without OpenEXR")
    def test_texture(self) -> None:
        values = np.zeros((4, 8, 3), dtype=np.float32)
        values[3, 0] = (1, 2, 4)  # upper left
        images.write_exr(self.directory / "glow.exr", values)
        (light,) = self.load({**LAMP, "texture": "glow.exr"}).area_lights
        mean = [0.0, 0.0, 0.0]
        light.GetMeanRadiance(mean)
        self.assertTrue(np.allclose(mean, np.array([4, 4, 4]) / 32.0))

    def test_texture_that_is_not_there(self) -> None:
        with self.assertRaisesRegex(SceneError, r"lights\[0\].texture: .*none.exr"):
            self.load({**LAMP, "texture": "none.exr"})

    def test_enable(self) -> None:
        scene = self.load(LAMP)
        window = scene.make_window()
        indirect = vtkindirect.enable(scene)
        self.assertEqual(indirect.GetNumberOfAreaLights(), 1)
        window.Render()
        found = vtkindirect.report(indirect)
        self.assertGreater(vtkindirect.images.copy_buffer(scene.renderer, "area").mean(), 0.0)
        self.assertIn("light of area lights", [entry["what"] for entry in found["modelled"]])
        self.assertEqual(
            lighting.choose(scene.renderer, None, 1), ("scene", "there are area lights")
        )
        # Set up anew it is not added twice.
        self.assertIs(vtkindirect.enable(scene, "gather"), indirect)
        self.assertEqual(indirect.GetNumberOfAreaLights(), 1)
        window.Finalize()


if __name__ == "__main__":
    unittest.main()
