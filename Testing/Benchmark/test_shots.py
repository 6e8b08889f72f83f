# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the gallery and of the benchmark of readability, and their measures."""

from __future__ import annotations

import json
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from vtkindirect import images, scene

import caustics
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
        # The ring is no shot; what it is made of is there all the same.
        self.assertLessEqual({*gallery.NAMES}, {*shots.SHOTS, gallery.RING})
        document = json.loads(caustics.SCENE.read_text(encoding="utf-8"))
        self.assertTrue(scene.check(document)["actors"])
        self.assertTrue(caustics.REFERENCE.is_file())
        for name in readability.NAMES:
            self.assertTrue(readability.find(name).document()["actors"])

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
        # The first two receive least, and what is not the object none at all.
        openness = np.array([[0.2, 0.2, 0.5, 1.0], [0.0, 0.0, 0.0, 0.0]])
        seen = readability.measure(picture, mask, openness)
        self.assertEqual(seen.black, 0.25)
        self.assertAlmostEqual(seen.brightness, (11 + 12 + 12 + 255) / 4)
        self.assertAlmostEqual(seen.pits, 11.5 / seen.brightness)

    def test_row(self) -> None:
        plain, other = readability.Seen(0.16, 100.0, 0.8), readability.Seen(0.484, 90.0, 0.5)
        ways = dict.fromkeys(readability.WAYS, other) | {"VTK": plain}
        cells = readability.row("molecule", "one sun", ways)
        others = ["0.90, 48.40%, 0.50"] * (len(ways) - 1)
        self.assertEqual(cells, ("molecule", "one sun", "100, 16.00%, 0.80", *others))


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Rendering(unittest.TestCase):
    def test_object_and_ways(self) -> None:
        found = readability.see_all("machine", ("one sun",), 96)["one sun"]
        self.assertEqual(list(found), list(readability.WAYS))
        plain, shadowed = found["VTK"], found["scene"]
        # A pass that is on casts shadows and adds light; SSAO takes some.
        self.assertGreater(shadowed.black, plain.black)
        self.assertLess(found["UseSSAO"].brightness, plain.brightness)
        self.assertLess(found["UseSSAO"].pits, plain.pits)
        self.assertEqual(len({way.brightness for way in found.values()}), len(found))

    def test_the_mask_lies_within_the_object(self) -> None:
        held = shots.SHOTS["machine"].alone().load(size=(96, 72))
        window = held.make_window()
        mask = readability.object_mask(held)
        self.assertEqual(held.renderer.GetBackground(), shots.WHITE)
        window.Render()
        white = (images.window_bytes(window) == 255).all(axis=-1)
        self.assertTrue(0.1 < mask.mean() < 0.7)
        for axis in (0, 1):
            for step in (-1, 0, 1):
                self.assertFalse((mask & np.roll(white, step, axis)).any())
        with ssao.used(held.renderer):
            self.assertTrue(held.renderer.GetUseSSAO())
        self.assertFalse(held.renderer.GetUseSSAO())
        window.Finalize()

    def test_a_row_of_the_gallery(self) -> None:
        picture, seconds = gallery.row(shots.SHOTS["machine"], (96, 72))
        self.assertEqual(picture.shape, (72, 3 * 96 + 2 * gallery.GAP, 3))
        parts = [picture[:, i * (96 + gallery.GAP) :][:, :96].astype(int) for i in range(3)]
        for first, second in ((0, 1), (0, 2), (1, 2)):
            self.assertGreater(np.abs(parts[first] - parts[second]).mean(), 1.0)
        self.assertEqual(len(seconds), 3)
        self.assertGreater(min(seconds), 0.0)


if __name__ == "__main__":
    unittest.main()
