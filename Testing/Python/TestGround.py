# SPDX-License-Identifier: BSD-3-Clause
"""``ground=``: a plane that shows nothing but the shadows on it and the light that it catches."""

import unittest
from typing import Any

import numpy as np
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

import support
import vtkindirect
from vtkindirect import UsageError, cli, ground, images, methods, windows

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = WHY_NOT or support.why_no_pyvista()
if not WHY_NO_PYVISTA:
    if not windows.has_display():
        vtkindirect.use_headless()
    import pyvista

# For speed: few virtual lights and directions of the sky.
FEW: dict[str, Any] = {"number_of_lights": 16, "error_tolerance": 0.1}
WHITE = (1.0, 1.0, 1.0)


class Values(unittest.TestCase):
    def test_what_ground_may_be(self) -> None:
        for value, expected in (
            (None, None),
            (False, None),
            (True, ground.Place()),
            (2, ground.Place(None, 2.0)),
            ("-y", ground.Place("-y")),
            (("z", 0.5), ground.Place("z", 0.5)),
        ):
            self.assertEqual(ground.from_value(value), expected)

    def test_what_it_may_not_be(self) -> None:
        for value in ("w", ("x", "y"), (1, 2), (), float("nan"), {}, ("z", True)):
            with self.assertRaisesRegex(UsageError, "^ground"):
                ground.from_value(value)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Scenes(unittest.TestCase):
    """A cube of VTK's own under a light that somebody has placed."""

    def make(self, background: tuple[float, ...] = WHITE) -> None:
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(*background)
        source = vtkCubeSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        self.cube = vtkActor()
        self.cube.SetMapper(mapper)
        self.renderer.AddActor(self.cube)
        light = vtkLight()
        light.SetPosition(2.0, 5.0, 1.0)
        self.renderer.AddLight(light)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(2.0, 2.0, 4.0)
        self.renderer.ResetCamera()
        self.window = windows.render_window((96, 80), offscreen=True)
        self.window.AddRenderer(self.renderer)

    def grab(self) -> np.ndarray:
        self.window.Render()
        return images.window_bytes(self.window).astype(int)

    def enable(self, **words: Any) -> Any:
        return vtkindirect.enable(self.renderer, environment=(0.5, 0.5, 0.5), **FEW, **words)

    def caught(self) -> np.ndarray:
        return vtkindirect.copy_buffer(self.renderer, "caught")

    def test_shadow_below_the_cube_alone(self) -> None:
        self.make()
        self.enable(ground=False)
        without = self.grab()
        self.assertEqual(self.caught().max(), 0.0)
        self.enable(ground=True)
        image = self.grab()
        share = self.caught()
        self.assertGreater((share > 0.0).mean(), 0.2)
        self.assertLess(share[share > 0.0].min(), 0.5)
        self.assertGreater((image[share.min(axis=2) > 0.0] > 250).mean(), 0.5)
        self.assertLessEqual(np.abs(image[-1] - without[-1]).max(), 1)

    def test_renderer_has_it_only_in_a_frame(self) -> None:
        self.make()
        self.enable(ground=True)
        bounds = self.renderer.ComputeVisiblePropBounds()
        near_and_far = self.camera.GetClippingRange()
        self.grab()
        self.assertEqual(self.renderer.GetViewProps().GetNumberOfItems(), 1)
        self.assertEqual(self.renderer.ComputeVisiblePropBounds(), bounds)
        self.assertEqual(self.camera.GetClippingRange(), near_and_far)
        self.grab()
        self.assertEqual(vtkindirect.report(self.renderer)["changed"], [])

    def test_follows_what_moves(self) -> None:
        self.make()
        self.enable(ground=True)
        self.grab()
        actor = methods._records[self.renderer.__this__].ground.actor
        low = -0.5 - ground.GAP * np.sqrt(3.0)
        self.assertAlmostEqual(actor.GetUserMatrix().GetElement(1, 3), low)
        self.cube.SetPosition(0.0, 2.0, 0.0)
        self.grab()
        self.assertAlmostEqual(actor.GetUserMatrix().GetElement(1, 3), low + 2.0)
        # The box of a turned sphere or cube is larger than the body: points decide.
        self.cube.SetPosition(0.0, 0.0, 0.0)
        self.cube.RotateX(45.0)
        self.cube.RotateY(45.0)
        self.grab()
        self.assertGreater(actor.GetUserMatrix().GetElement(1, 3), -0.87)
        self.cube.VisibilityOff()
        empty = self.grab()
        self.assertEqual(int(empty.min()), 255)

    def test_place_that_is_given(self) -> None:
        self.make()
        self.enable(ground=("y", -1.0))
        self.grab()
        record = methods._records[self.renderer.__this__]
        first = record.ground
        self.assertEqual(first.actor.GetUserMatrix().GetElement(1, 3), -1.0)
        self.enable(ground="-x")
        self.grab()
        self.assertIsNot(record.ground, first)
        self.assertGreater(record.ground.actor.GetUserMatrix().GetElement(0, 3), 0.5)
        self.enable()
        self.assertIsNotNone(record.ground)
        with self.assertRaises(UsageError):
            self.enable(ground="up")
        self.assertIsNotNone(record.ground)

    def test_not_there_from_below(self) -> None:
        self.make()
        self.camera.SetPosition(2.0, -2.0, 4.0)
        self.renderer.ResetCamera()
        self.enable(ground=False)
        without = self.grab()
        self.enable(ground=True)
        difference = np.abs(self.grab() - without)
        self.assertEqual(self.caught().max(), 0.0)
        self.assertLessEqual(difference.max(), 6)

    def test_disable_restores(self) -> None:
        self.make()
        plain = self.grab()
        self.enable(ground=True)
        self.grab()
        vtkindirect.disable(self.renderer)
        np.testing.assert_array_equal(self.grab(), plain)
        self.assertEqual(self.renderer.GetViewProps().GetNumberOfItems(), 1)

    def test_pass_that_somebody_takes_away(self) -> None:
        self.make()
        plain = self.grab()
        self.enable(ground=True)
        self.grab()
        self.renderer.SetPass(None)
        np.testing.assert_array_equal(self.grab(), plain)

    def test_method_off_has_none(self) -> None:
        self.make()
        with self.assertRaisesRegex(UsageError, "'ground'"):
            vtkindirect.enable(self.renderer, "off", ground=True)


@unittest.skipIf(WHY_NO_PYVISTA, WHY_NO_PYVISTA or "")
class Plotters(unittest.TestCase):
    def plotter(
        self, background: str = "white", first: bool = False, words: dict[str, Any] = FEW
    ) -> Any:
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 100))
        self.addCleanup(plotter.close)
        plotter.set_background(background)
        if first:
            vtkindirect.enable(plotter, ground=True, **words)
        plotter.add_mesh(pyvista.Sphere(), color="tan", name="ball")
        if not first:
            vtkindirect.enable(plotter, ground=True, **words)
        plotter.show(auto_close=False)
        return plotter

    def test_before_and_after_meshes(self) -> None:
        before = self.plotter(first=True)
        after = self.plotter()
        one, other = before.screenshot().astype(int), after.screenshot().astype(int)
        np.testing.assert_array_equal(one, other)
        share = vtkindirect.copy_buffer(after, "caught")
        self.assertLess(share[share > 0.0].min(), 0.9)
        self.assertEqual(list(after.actors), ["ball"])
        self.assertLess(after.bounds[1] - after.bounds[0], 1.1)

    def test_transparent_over_white_is_the_picture_on_white(self) -> None:
        white = self.plotter(words={})
        picture = white.screenshot().astype(float)[..., :3]
        for plotter in (white, self.plotter("black", words={})):
            cut = vtkindirect.screenshot(plotter, transparent=True).astype(float)
            alpha = cut[..., 3:] / 255.0
            over = cut[..., :3] * alpha + 255.0 * (1.0 - alpha)
            shadow = (cut[..., 3] > 10.0) & (cut[..., 3] < 245.0)
            self.assertGreater(shadow.sum(), 50)
            # Three roundings to 8 bits. One alpha leaves the shadow's colour out: 7 in a channel.
            apart = over - picture
            self.assertLess(np.abs(apart.mean(-1))[shadow].max(), 2.0)
            self.assertLess(np.abs(apart)[shadow].max(), 8.0)

    def test_orbit_shows_no_horizon(self) -> None:
        plotter = self.plotter(words={"number_of_lights": 16})
        plotter.render_window.SetDesiredUpdateRate(15.0)
        for elevation in (5.0, -25.0, -8.0):
            plotter.camera.elevation = elevation
            plotter.camera.azimuth += 30.0
            plotter.render()
            picture = plotter.screenshot().astype(int)
            # Moving frames sum few directions of the sky, each with a shadow: 253 in the topmost rows. The
            # border of the soft shadow reaches the first columns: 3.5 from row to row.
            self.assertGreaterEqual(picture[:3].min(), 253)
            steps = np.abs(np.diff(picture[:, :4].mean(axis=(1, 2))))
            self.assertLessEqual(steps.max(), 4.0)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class CommandLine(support.DirectoryTest):
    def test_render(self) -> None:
        scene = support.small_scene()
        del scene["actors"][1:]
        path = self.write("scene.json", scene)
        for words in ([], ["--ground"]):
            output = self.directory / f"{len(words)}.png"
            cli.main(["render", str(path), "-o", str(output), *words])
        self.assertNotEqual(
            (self.directory / "0.png").read_bytes(), (self.directory / "1.png").read_bytes()
        )


if __name__ == "__main__":
    unittest.main()
