# SPDX-License-Identifier: BSD-3-Clause
"""Windows: with and without a display, of any size that is allowed."""

import contextlib
import gc
import io
import os
import unittest
import warnings
from unittest import mock

import numpy as np
import support
from rooms import make_actor, make_ball
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

import vtkindirect
from vtkindirect import RenderError, UsageError, cli, windows, wrapped

HAVE_HEADLESS = wrapped.has("vtkEGLHeadlessRenderWindow")
NO_HEADLESS = "the module vtkIndirectHeadless was not built"


class IdleCard:
    """A window that renders in software beside a card, and reports it as VTK's windows do."""

    text = "OpenGL renders in software although there is a graphics card: no driver."
    reports = True

    def Initialize(self) -> None:
        if self.reports:
            vtkOutputWindow.GetInstance().DisplayWarningText(
                f"Warning: In a.cxx, line 1\nvtkWindow (0x1): {self.text}\n\n"
            )

    def SupportsOpenGL(self) -> int:
        return 1

    def GetSize(self) -> tuple[int, int]:
        return (4, 3)

    def GetLastWarningMessage(self) -> str:
        return self.text


class Windows(unittest.TestCase):
    def test_size(self) -> None:
        for size in ((0, 5), (5, 0), (-1, 5), (windows.LARGEST + 1, 5)):
            with self.subTest(size=size), self.assertRaisesRegex(UsageError, "must be from 1x1"):
                vtkindirect.render_window(size)

    def test_display_that_does_not_answer(self) -> None:
        with mock.patch.dict(os.environ, {"DISPLAY": ":987"}):
            self.assertFalse(windows.has_display())
            with self.assertRaisesRegex(RenderError, "cannot connect to DISPLAY ':987'"):
                vtkindirect.render_window(offscreen=False)

    def test_no_display(self) -> None:
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        with mock.patch.dict(os.environ, environment, clear=True):
            with self.assertRaisesRegex(RenderError, "no display.*DISPLAY is not set"):
                vtkindirect.render_window(offscreen=False)
            with mock.patch.object(windows, "_headless", return_value=None):
                with self.assertRaisesRegex(RenderError, "no way to render without one"):
                    vtkindirect.render_window()

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_wide(self) -> None:
        # Lines of both directions do not fit into one image of OpenGL's: one error, and a picture.
        scene = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        window = vtkindirect.render_window((16381, 4), offscreen=True)
        window.AddRenderer(scene.renderer)
        indirect = vtkindirect.enable(scene)
        output = vtkStringOutputWindow()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(output)
        try:
            window.Render()
            window.Render()
        finally:
            vtkOutputWindow.SetInstance(before)
        if window.GetSize() != (16381, 4):
            self.skipTest("this OpenGL's windows are smaller")
        found = vtkindirect.report(indirect)
        why = [e["why"] for e in found["left_out"] if e["what"] == "antialiased edges"]
        if not why:
            self.skipTest("this OpenGL's images are larger")
        self.assertEqual(output.GetOutput().count("ERROR"), 1, output.GetOutput())
        self.assertIn("16381 and 4 pixels", why[0])
        self.assertNotIn("antialiased edges", [e["what"] for e in found["modelled"]])
        self.assertGreater(vtkindirect.copy_buffer(scene.renderer, "final").mean(), 0.0)
        window.Finalize()

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_end_of_another_window(self) -> None:
        """A window that ends takes no objects of OpenGL from another window."""
        first = vtkindirect.render_window((160, 120), offscreen=True)
        # The room reaches beyond the picture: the pass draws a map of what the camera sees, in the
        # second frame by its own drawer.
        room = vtkindirect.load_scene(support.SCENES / "apartment_living.json").renderer
        vtkindirect.enable(room, lighting="scene", Caching=False)
        first.AddRenderer(room)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # glass takes no part
            first.Render()
            first.Render()
        second = vtkindirect.render_window((160, 120), offscreen=True)
        balls = vtkRenderer()
        for i in range(100):
            ball = make_actor(make_ball(0.02 + 0.0005 * i))
            ball.SetPosition(0.1 * (i % 10), 0.1 * (i // 10), 0)
            balls.AddActor(ball)
        second.AddRenderer(balls)

        def draw() -> np.ndarray:
            second.Render()
            pixels = vtkUnsignedCharArray()
            second.GetPixelData(0, 0, 159, 119, 0, pixels, 0)
            return vtk_to_numpy(pixels).copy()

        before = draw()
        self.assertGreater(len(np.unique(before)), 10)
        del first, room
        gc.collect()
        np.testing.assert_array_equal(draw(), before)

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_headless(self) -> None:
        window = vtkindirect.render_window((40, 30), offscreen=True)
        self.assertEqual(window.GetSize(), (40, 30))
        self.assertEqual(window.GetMultiSamples(), 0)

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_use_headless(self) -> None:
        vtkindirect.use_headless()
        try:
            self.assertEqual(vtkRenderWindow().GetClassName(), "vtkEGLHeadlessRenderWindow")
        finally:
            vtkindirect.use_headless(False)

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_no_context(self) -> None:
        window = vtkindirect.vtkEGLHeadlessRenderWindow()
        window.SetDeviceIndex(10**6)
        with self.assertRaisesRegex(RenderError, "OpenGL does not work here: "):
            windows.start(window)

    @unittest.skipUnless(HAVE_HEADLESS, NO_HEADLESS)
    def test_devices(self) -> None:
        window = vtkindirect.vtkEGLHeadlessRenderWindow
        count = window().GetNumberOfDevices()
        for index in range(count):
            self.assertRegex(
                window.GetDeviceDescription(index), f"^EGL device {index}: (hard|soft)ware"
            )
        for index in (-1, count, 10**6):
            self.assertEqual(window.GetDeviceDescription(index), "")

    def test_idle_card(self) -> None:
        window = IdleCard()
        with self.assertWarnsRegex(RuntimeWarning, f"^{window.text}$"):
            windows.start(window)
        # As the second window of a process.
        window.reports = False
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            windows.start(window)

    def test_idle_card_on_the_command_line(self) -> None:
        with mock.patch.object(cli, "_dispatch", lambda *_: windows.start(IdleCard())):
            with contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(cli.main([]), 0)
        self.assertEqual(said.getvalue(), f"vtk-indirect: note: {IdleCard.text}\n")
