# SPDX-License-Identifier: BSD-3-Clause
"""Finished pictures: of all targets, at multiples of a size, over any background, in files."""

import io
import sys
import unittest
from typing import Any
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from rooms import make_actor, make_ball, make_room
from vtkindirect import UsageError, load_scene, methods, screenshot, windows

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = WHY_NOT or support.why_no_pyvista()


def window_with(renderer: vtkRenderer, size: tuple[int, int] = (80, 60)) -> Any:
    window = windows.render_window(size, offscreen=True)
    window.AddRenderer(renderer)
    return window


def read(reader: Any, path: Any) -> np.ndarray:
    """Return the picture of a file, top row first."""
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Screenshots(support.DirectoryTest):
    def room(self) -> vtkRenderer:
        renderer = make_room(make_actor(make_ball()))
        renderer.SetBackground(0.2, 0.4, 0.9)
        return renderer

    def test_all_depth_maps_are_drawn(self) -> None:
        renderer = self.room()
        indirect = vtkindirect.enable(renderer)
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        window.SetDesiredUpdateRate(15.0)  # of somebody who drags: maps come over many frames
        window.Render()
        self.assertGreater(vtkindirect.report(renderer)["counters"]["tiles_left"], 0)
        first = screenshot(renderer)
        self.assertEqual(vtkindirect.report(renderer)["counters"]["tiles_left"], 0)
        self.assertEqual((first.shape, first.dtype), ((60, 80, 3), np.uint8))
        self.assertFalse(indirect.GetMapsFirst())
        self.assertEqual(window.GetDesiredUpdateRate(), 15.0)
        np.testing.assert_array_equal(first, screenshot(window))

    def test_targets(self) -> None:
        """A window, its renderer, a scene and a renderer without a window; also without light."""
        scene = load_scene(self.write("small.json", support.small_scene()))
        self.assertEqual(screenshot(scene).shape, (48, 64, 3))
        self.addCleanup(scene.render_window.Finalize)
        plain = screenshot(scene.render_window)
        vtkindirect.enable(scene)
        lit = screenshot(scene.renderer)
        self.assertGreater(float(lit.mean()), float(plain.mean()) + 1.0)
        renderer = self.room()
        vtkindirect.enable(renderer)
        self.assertEqual(screenshot(renderer).shape, (512, 512, 3))
        self.assertIsNone(renderer.GetRenderWindow())
        window = window_with(renderer)  # and it can be shown afterwards
        self.addCleanup(window.Finalize)
        self.assertEqual(screenshot(renderer).shape, (60, 80, 3))

    def test_top_row_first(self) -> None:
        renderer = vtkRenderer()
        ball = vtkSphereSource()
        ball.SetCenter(0, 1, 0)
        renderer.AddActor(make_actor(ball, (1, 1, 1)))
        renderer.GetActiveCamera().SetPosition(0, 0, 8)
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        picture = screenshot(window)
        self.assertGreater(int(picture[:30].max()), 100)
        self.assertEqual(int(picture[30:].max()), 0)

    def test_scale_is_a_window_of_that_size(self) -> None:
        renderer = self.room()
        vtkindirect.enable(renderer)
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        scaled = screenshot(window, scale=3)
        self.assertEqual(tuple(window.GetSize()), (80, 60))
        other = self.room()
        vtkindirect.enable(other)
        larger = window_with(other, (240, 180))
        self.addCleanup(larger.Finalize)
        np.testing.assert_array_equal(scaled, screenshot(larger))
        self.assertEqual(screenshot(window).shape, (60, 80, 3))

    def check_transparency(self, target: Any, renderer: vtkRenderer) -> np.ndarray:
        """Over its background, the picture with alpha is the one without."""
        before = renderer.GetBackground()
        opaque = screenshot(target).astype(float)
        found = screenshot(target, transparent=True)
        self.assertEqual(renderer.GetBackground(), before)
        np.testing.assert_array_equal(opaque, screenshot(target).astype(float))
        alpha = found[:, :, 3:] / 255.0
        over = found[:, :, :3] * alpha + 255.0 * np.array(before) * (1.0 - alpha)
        # The error of three roundings: of the picture, of alpha and of the colours.
        self.assertLess(float(np.abs(over - opaque).max()), 1.6)
        return found

    def test_transparent(self) -> None:
        renderer = vtkRenderer()
        renderer.AddActor(make_actor(make_ball(), (0.9, 0.8, 0.1)))
        translucent = make_actor(make_ball(0.3), (0.1, 0.9, 0.2))
        translucent.SetPosition(0.4, 0.3, 0)
        translucent.GetProperty().SetOpacity(0.4)
        renderer.AddActor(translucent)
        renderer.SetBackground(0.2, 0.4, 0.9)
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        for on in (False, True):
            if on:
                vtkindirect.enable(renderer)
            found = self.check_transparency(window, renderer)
            self.assertEqual(int(found[0, 0, 3]), 0)
            self.assertEqual(int(found[30, 30, 3]), 255)
            # Two layers of the translucent ball.
            self.assertTrue((np.abs(found[:, :, 3].astype(int) - 163) < 2).sum() > 20)

    @unittest.skipIf(WHY_NO_PYVISTA, WHY_NO_PYVISTA or "")
    def test_pyvista(self) -> None:
        """A plotter that was not shown yet looks as it does afterwards."""
        if not windows.has_display():
            vtkindirect.use_headless()
        import pyvista

        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 60))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.ParametricTorus(), color="tan")
        plotter.add_mesh(pyvista.Sphere(center=(1, 1, 1)), opacity=0.5)
        plotter.enable_depth_peeling()
        vtkindirect.enable(plotter)
        early = screenshot(plotter)
        self.assertGreater(float(np.ptp(early)), 100.0)
        self.check_transparency(plotter, plotter.renderer)
        plotter.show(auto_close=False)
        np.testing.assert_array_equal(early, screenshot(plotter))
        np.testing.assert_array_equal(early, plotter.screenshot(return_img=True))
        if hasattr(pyvista, "register_plotter_component"):
            np.testing.assert_array_equal(early, plotter.indirect.screenshot())

    def test_files(self) -> None:
        renderer = self.room()
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        picture = screenshot(window, self.directory / "a.png")
        np.testing.assert_array_equal(read(vtkPNGReader(), self.directory / "a.png"), picture)
        clear = screenshot(window, str(self.directory / "b.PNG"), transparent=True)
        np.testing.assert_array_equal(read(vtkPNGReader(), self.directory / "b.PNG"), clear)
        for name in ("a.jpg", "a.jpeg"):
            picture = screenshot(window, self.directory / name, scale=2)
            found = read(vtkJPEGReader(), self.directory / name).astype(float)
            self.assertLess(float(np.abs(found - picture).mean()), 3.0)

    def test_mistakes(self) -> None:
        renderer = self.room()
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        here = self.directory
        for words, expected in (
            ({"scale": 0}, "scale must be a whole number from 1 on, not 0"),
            ({"scale": 1.5}, "scale must be a whole number from 1 on, not 1.5"),
            ({"scale": True}, "scale must be a whole number from 1 on, not True"),
            ({"scale": 100000}, "size 8000000x6000000: this OpenGL driver goes up to"),
            ({"transparent": "yes"}, "transparent must be True or False, not 'yes'"),
            ({"path": 3}, "path must be the path of a file or None, not 3"),
            ({"path": here / "a.exr"}, "the file name must end in .png or .jpg or .jpeg"),
            ({"path": here / "no" / "a.png"}, "no such directory"),
            ({"path": here / "a.jpg", "transparent": True}, "JPEG has no transparency"),
        ):
            with self.subTest(words=words), self.assertRaises(UsageError) as caught:
                screenshot(window, **words)
            self.assertIn(expected, str(caught.exception))
            self.assertEqual(tuple(window.GetSize()), (80, 60))
        with self.assertRaisesRegex(UsageError, "a renderer, a render window or a plotter"):
            screenshot(None)
        self.assertEqual(self.names(), [])

    def test_a_bar_on_a_terminal_alone(self) -> None:
        renderer = self.room()
        vtkindirect.enable(renderer)
        window = window_with(renderer)
        self.addCleanup(window.Finalize)
        for terminal in (False, True):
            with mock.patch.object(sys, "stderr", io.StringIO()) as said:
                said.isatty = lambda terminal=terminal: terminal
                screenshot(window)
            self.assertEqual("screenshot" in said.getvalue(), terminal)

    def test_several_renderers(self) -> None:
        """Each has its own pass, and its own maps to wait for."""
        window = windows.render_window((80, 40), offscreen=True)
        self.addCleanup(window.Finalize)
        for place in (0.0, 0.5):
            renderer = self.room()
            renderer.SetViewport(place, 0.0, place + 0.5, 1.0)
            window.AddRenderer(renderer)
        vtkindirect.enable(window)
        picture = screenshot(window)
        np.testing.assert_array_equal(picture[:, :40], picture[:, 40:])
        for renderer in methods.renderers_of(window):
            self.assertEqual(vtkindirect.report(renderer)["counters"]["tiles_left"], 0)
