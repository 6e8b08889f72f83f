# SPDX-License-Identifier: BSD-3-Clause
"""What the gallery and the benchmark of readability show, and how they measure it."""

from __future__ import annotations

import unittest
from pathlib import Path
from unittest import mock

import numpy as np
import vtkindirect
from vtkindirect import images, scene
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

import gallery
import readability
import shots
import ssao
import support


class Documents(unittest.TestCase):
    """Every shot is a scene file, with data that is there."""

    def test_all(self) -> None:
        for name, shot in shots.SHOTS.items():
            with self.subTest(name):
                document = scene.check(shot.document())
                self.assertTrue(all(Path(a["file"]).is_file() for a in document["actors"] if "file" in a))
                names = {actor.get("name") for actor in document["actors"]}
                self.assertTrue(names.isdisjoint(shot.without))
                self.assertLessEqual(set(shot.ground), names)
        self.assertLessEqual({*gallery.NAMES, *readability.NAMES}, set(shots.SHOTS))

    def test_what_is_left_out_was_there(self) -> None:
        for name, shot in shots.SHOTS.items():
            with self.subTest(name):
                whole = shots.Shot(shot.title, shot.scene, shot.sun).document()
                names = {actor.get("name") for actor in whole["actors"]}
                self.assertLessEqual(set(shot.without), names)


class Measuring(unittest.TestCase):
    def test_numbers(self) -> None:
        picture = np.full((2, 4, 3), 200, dtype=np.uint8)
        mask = np.zeros((2, 4), dtype=bool)
        mask[0] = True
        picture[0] = [[0, 0, 33], [0, 0, 36], [12, 12, 12], [255, 255, 255]]
        seen = readability.measure(picture, mask)
        self.assertEqual(seen.black, 0.25)
        self.assertAlmostEqual(seen.brightness, (11 + 12 + 12 + 255) / 4)

    def test_rows(self) -> None:
        plain, other = readability.Seen(0.16, 100.0), readability.Seen(0.484, 90.0)
        ways = dict.fromkeys(readability.WAYS, other) | {"VTK": plain, "soft": None}
        black, bright = readability.rows({("molecule", "one sun"): ways})
        self.assertEqual(
            black, [("molecule", "one sun", "16.0%", "48.4%", "48.4%", "skipped", "48.4%")]
        )
        self.assertEqual(bright, [("molecule", "one sun", "100", "0.90", "0.90", "skipped", "0.90")])

    def test_presets_that_are_not_there_are_skipped(self) -> None:
        with mock.patch.object(shots, "HAS_LIGHTING", False):
            with self.assertRaises(shots.Skipped):
                shots.enable(mock.sentinel.scene, "soft")
        with mock.patch.object(shots, "HAS_LIGHTING", True):
            with mock.patch.object(vtkindirect, "enable") as enable:
                shots.enable(mock.sentinel.scene, "soft")
        enable.assert_called_once_with(mock.sentinel.scene, lighting="soft")

    def test_lights_come_back(self) -> None:
        renderer, light = vtkRenderer(), vtkLight()
        light.SetIntensity(0.5)
        renderer.AddLight(light)
        with shots.lights_kept(renderer):
            light.SwitchOff()
            renderer.RemoveAllLights()
            renderer.AddLight(vtkLight())
        lights = renderer.GetLights()
        self.assertEqual(lights.GetNumberOfItems(), 1)
        self.assertIs(lights.GetItemAsObject(0), light)
        self.assertEqual((light.GetSwitch(), light.GetIntensity()), (1, 0.5))


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Rendering(unittest.TestCase):
    def test_object_and_ways(self) -> None:
        shot = shots.SHOTS["machine"].alone()
        found = readability.see(shot, shot.one_sun(), 96)
        self.assertEqual(list(found), list(readability.WAYS))
        plain, shadowed = found["VTK"], found["scene"]
        # A pass that is on casts shadows and adds light; SSAO takes some.
        self.assertGreater(shadowed.black, plain.black)
        self.assertLess(found["UseSSAO"].brightness, plain.brightness)
        for name in ("soft", "full"):
            self.assertEqual(found[name] is None, not shots.HAS_LIGHTING)

    def test_the_mask_is_the_object(self) -> None:
        held = shots.SHOTS["machine"].alone().load(size=(96, 72))
        window = held.make_window()
        mask = readability.object_mask(held)
        self.assertEqual(held.renderer.GetBackground(), shots.WHITE)
        window.Render()
        white = (images.window_bytes(window) == 255).all(axis=-1)
        self.assertFalse((~mask & ~white).any())
        self.assertTrue(0.1 < mask.mean() < 0.7)
        with ssao.used(held.renderer):
            self.assertTrue(held.renderer.GetUseSSAO())
        self.assertFalse(held.renderer.GetUseSSAO())
        window.Finalize()

    def test_a_row_of_the_gallery(self) -> None:
        with mock.patch.object(shots, "SIZE", (96, 72)):
            picture = gallery.row(shots.SHOTS["machine"])
        self.assertEqual(picture.shape, (72, 3 * 96 + 2 * gallery.GAP, 3))
        parts = [picture[:, i * (96 + gallery.GAP) :][:, :96].astype(int) for i in range(3)]
        for first, second in ((0, 1), (0, 2), (1, 2)):
            self.assertGreater(np.abs(parts[first] - parts[second]).mean(), 1.0)


if __name__ == "__main__":
    unittest.main()
