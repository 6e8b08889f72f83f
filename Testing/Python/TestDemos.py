# SPDX-License-Identifier: BSD-3-Clause
"""The demonstration: its scenes load, stay of moderate size, and indirect light adds to them."""

import unittest

import numpy as np
import pytest

import support
import vtkindirect
from vtkindirect import demo, frames, load_scene, locations, wrapped
from vtkindirect.frames import Job

WHY_NOT = support.why_no_rendering()
MAXIMUM_TRIANGLES = 1_000_000


def triangles(scene: vtkindirect.Scene) -> int:
    return sum(a.GetMapper().GetInput().GetNumberOfCells() for a in scene.actors.values())


@pytest.mark.parametrize("name", locations.DEMOS)
def test_scene(name: str) -> None:
    scene = load_scene(locations.scene_directory() / f"{name}.json")
    assert scene.name == name
    assert triangles(scene) < MAXIMUM_TRIANGLES
    assert max(scene.size) <= 800
    if WHY_NOT:
        pytest.skip(WHY_NOT)
    window = frames.open_window(scene, (160, 120))
    frames.render(scene, window, Job("gather", settings={"NumberOfLights": 64}))
    direct = vtkindirect.copy_buffer(scene.renderer, "direct")[..., :3]
    indirect = vtkindirect.copy_buffer(scene.renderer, "indirect")[..., :3]
    assert np.isfinite(indirect).all()
    assert indirect.mean() > 0.02 * direct.mean()
    lit = direct.max(axis=2) > 0.02
    assert lit.mean() > 0.2
    assert (direct[lit].min(axis=1) >= 1).mean() < 0.05, "direct light clips"
    revealed = ~lit & (indirect.max(axis=2) > 0.02)
    assert revealed.mean() > 0.03, "shadows are not filled"
    window.Finalize()


class Files(support.DirectoryTest):
    @unittest.skipIf(WHY_NOT, WHY_NOT or "")
    def test_files_of_the_demonstration(self) -> None:
        scene = load_scene(support.SCENES / "cornell_box.json")
        steps: list[str] = []
        pictures = self.directory / "pictures"
        line = demo.run(scene, pictures, (96, 64), steps.append)
        names = ["cornell_box.exr"] if wrapped.has("vtkOpenEXRWriter") else []
        self.assertEqual(sorted(p.name for p in pictures.iterdir()), [*names, "cornell_box.png"])
        self.assertIn("frame ", line)
        self.assertIn("virtual lights", line)
        self.assertNotIn("\n", line)
        # Frames that draw depth maps are not measured, however many these are.
        warming_up = sum("warming up" in step for step in steps)
        self.assertGreaterEqual(warming_up, 2)
        self.assertEqual(len(steps) - warming_up, 2 * demo.FRAMES)
        from TestImages import read
        from vtkmodules.vtkIOImage import vtkPNGReader

        picture = read(pictures / "cornell_box.png", vtkPNGReader).astype(float)
        self.assertEqual(picture.shape[:2], (64, 2 * 96 + 4))
        self.assertIsNone(vtkindirect.pass_of(scene.renderer))
        window = scene.make_window((96, 64))
        window.SetMultiSamples(demo.MULTISAMPLES)
        window.Render()
        plain = vtkindirect.images.window_bytes(window).astype(float)
        window.Finalize()
        above = slice(24, None)  # of the caption
        self.assertLess(np.abs(picture[:, :96] - plain)[above].max(), 1.0)
        # Shadows, and light that walls reflect: plain VTK has neither.
        self.assertGreater(np.abs(picture[:, 100:] - plain)[above].mean(), 10.0)
