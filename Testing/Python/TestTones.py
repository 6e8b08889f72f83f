# SPDX-License-Identifier: BSD-3-Clause
"""Curves from light to colours: by their formulas, above 1, in chains, and the exposure "auto"."""

import json
import unittest
from typing import Any
from unittest import mock

import numpy as np
import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from rooms import make_actor, make_ball, make_room
from vtkindirect import UsageError, chain, images, screenshot, tones, windows, wrapped

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = WHY_NOT or support.why_no_pyvista()

BACKGROUND = (0.2, 0.4, 0.9)


def room(strength: float = 1.0) -> vtkRenderer:
    """Return a room whose light has a strength."""
    renderer = make_room(make_actor(make_ball()))
    renderer.GetLights().GetItemAsObject(0).SetIntensity(strength)
    renderer.SetBackground(BACKGROUND)
    return renderer


def curve(name: str, light: np.ndarray, exposure: float = 1.0) -> np.ndarray:
    """Return the picture of the buffer `final`, in bytes."""
    x = np.maximum(light, 0.0) ** 2.2 * exposure
    if name == "filmic":
        into = np.array(
            [
                [0.5972782409, 0.3545713181, 0.0482176639],
                [0.0760130499, 0.9083220973, 0.0156579968],
                [0.0284085382, 0.1338243154, 0.8375684636],
            ]
        )
        out = np.array(
            [
                [1.6047539945, -0.5310794927, -0.0736720338],
                [-0.1020831870, 1.1081322801, -0.0060518756],
                [-0.0032670420, -0.0727552477, 1.0760219533],
            ]
        )
        x = x @ into.T
        x = x**1.6773 / (x ** (1.6773 * 0.9714) * 1.117427 + 0.244676)
        y = x @ out.T
    else:
        y = {"none": x, "reinhard": x / (1 + x), "exponential": 1 - np.exp(-x)}[name]
    return 255.0 * np.clip(y, 0.0, 1.0) ** (1 / 2.2)


@unittest.skipUnless(wrapped.has(chain.PASS), "the module vtkRenderingIndirect was not built")
class Words(unittest.TestCase):
    """Words of `enable`, without a frame."""

    def test_the_chain(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, antialiasing=False)
        self.assertIs(renderer.GetPass(), indirect)
        for words, kind in (
            ({"tone_mapping": "reinhard"}, 1),
            ({"tone_mapping": "exponential"}, 2),
            ({"exposure": 0.5}, 2),
            ({"tone_mapping": "filmic"}, 3),
            ({"tone_mapping": None}, 3),
        ):
            vtkindirect.enable(renderer, **words)
            tone = renderer.GetPass()
            self.assertTrue(tone.IsA("vtkToneMappingPass"))
            self.assertIs(tone.GetDelegatePass(), indirect)
            self.assertEqual(tone.GetToneMappingType(), kind)
            self.assertEqual(tone.GetExposure(), 0.5 if kind == 3 or "exposure" in words else 1.0)
        self.assertIs(vtkindirect.pass_of(renderer), indirect)
        vtkindirect.enable(renderer, exposure=1)
        self.assertIs(renderer.GetPass(), indirect)
        vtkindirect.enable(renderer, tone_mapping="filmic", antialiasing=True)
        self.assertIs(renderer.GetPass().GetDelegatePass(), indirect)
        vtkindirect.disable(renderer)
        self.assertIsNone(renderer.GetPass())

    def test_antialiasing_behind_the_curve(self) -> None:
        """VTK's FXAA, which takes a window of one sample; what was there comes back."""
        renderer, window = vtkRenderer(), windows.render_window((8, 8), offscreen=True)
        window.SetMultiSamples(4)
        window.AddRenderer(renderer)
        indirect = vtkindirect.enable(renderer, tone_mapping="filmic")
        names = [found.GetClassName() for found, _, _ in chain.links(renderer.GetPass())]
        self.assertEqual(names, ["vtkOpenGLFXAAPass", "vtkToneMappingPass", chain.PASS])
        self.assertEqual(window.GetMultiSamples(), 0)
        vtkindirect.enable(renderer, antialiasing=False)
        self.assertIs(renderer.GetPass().GetDelegatePass(), indirect)
        vtkindirect.enable(renderer, antialiasing=True)
        self.assertTrue(renderer.GetPass().IsA("vtkOpenGLFXAAPass"))
        vtkindirect.disable(renderer)
        self.assertEqual(window.GetMultiSamples(), 4)
        self.assertIsNone(renderer.GetPass())

    def test_other_effects(self) -> None:
        """Around what needs depth, inside of what holds no value above 1; all comes back."""
        for kinds, place in (
            ((opengl.vtkSSAAPass,), 1),
            ((opengl.vtkOpenGLFXAAPass,), 1),
            ((opengl.vtkSSAAPass, opengl.vtkDepthOfFieldPass), 1),
            ((opengl.vtkSSAAPass, opengl.vtkGaussianBlurPass, opengl.vtkEDLShading), 2),
        ):
            effects = [kind() for kind in kinds]
            for effect, following in zip(effects, [*effects[1:], opengl.vtkRenderStepsPass()]):
                effect.SetDelegatePass(following)
            before = [effect.GetDelegatePass() for effect in effects]
            renderer = vtkRenderer()
            renderer.SetPass(effects[0])
            indirect = vtkindirect.enable(renderer, tone_mapping="reinhard")
            names = [found.GetClassName() for found, _, _ in chain.links(renderer.GetPass())]
            expected = [effect.GetClassName() for effect in effects] + [chain.PASS]
            expected.insert(place, "vtkToneMappingPass")
            self.assertEqual(names, expected)
            self.assertIs(vtkindirect.pass_of(renderer), indirect)
            vtkindirect.disable(renderer)
            self.assertIs(renderer.GetPass(), effects[0])
            self.assertEqual([effect.GetDelegatePass() for effect in effects], before)

    def test_mistakes(self) -> None:
        renderer = vtkRenderer()
        vtkindirect.enable(renderer, tone_mapping="exponential", exposure=2)
        tone = renderer.GetPass()
        for words, expected in (
            ({"tone_mapping": "reinhardt"}, "unknown tone_mapping 'reinhardt' (did you mean"),
            ({"tone_mapping": 2}, "tone_mapping must be text, not 2"),
            ({"exposure": 0}, 'exposure must be a finite number above 0 or "auto", not 0'),
            ({"exposure": -1}, "exposure must be a finite number above 0"),
            ({"exposure": float("inf")}, "exposure must be a finite number above 0"),
            ({"exposure": "much"}, "exposure must be a finite number above 0"),
            ({"exposure": None}, "exposure must be a finite number above 0"),
            ({"exposure": True}, "exposure must be a finite number above 0"),
            ({"tone_mapping": "filmic", "number_of_lihgts": 3}, "unknown property"),
        ):
            with self.subTest(words=words), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(renderer, **words)
            self.assertIn(expected, str(caught.exception))
            self.assertIs(renderer.GetPass(), tone)
            self.assertEqual((tone.GetToneMappingType(), tone.GetExposure()), (2, 2.0))
        other = vtkRenderer()
        other.SetPass(opengl.vtkToneMappingPass())
        with self.assertRaisesRegex(UsageError, "has a vtkToneMappingPass already"):
            vtkindirect.enable(other, tone_mapping="filmic")
        self.assertIsNone(vtkindirect.pass_of(other))
        with self.assertRaisesRegex(UsageError, "method 'off' has no property 'exposure'"):
            vtkindirect.enable(renderer, "off", exposure=1)


class Brightness(unittest.TestCase):
    def test_percentile(self) -> None:
        final = np.zeros((40, 50, 3), np.float32)
        self.assertIsNone(tones.brightness(final))
        final[:10] = np.linspace(0, 2, 501)[1:].reshape(10, 50, 1)
        self.assertAlmostEqual(tones.brightness(final), 1.98**2.2, delta=0.01)
        final[20] = np.nan
        self.assertAlmostEqual(tones.brightness(final), 1.98**2.2, delta=0.01)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Pictures(support.DirectoryTest):
    def show(self, renderer: vtkRenderer) -> Any:
        window = windows.render_window((160, 120), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        return window

    def test_curves_of_light_above_one(self) -> None:
        renderer = room(6.0)
        vtkindirect.enable(renderer, antialiasing=False)
        window = self.show(renderer)
        plain = screenshot(window)
        final = images.copy_buffer(renderer, "final")[::-1]
        lit = images.copy_buffer(renderer, "depth")[::-1, :, 0] > 0
        self.assertGreater(float(final.max()), 2.0)
        self.assertEqual(int(plain[lit].max()), 255)
        for name in tones.CURVES:
            for exposure in (1, 0.25):
                with self.subTest(name=name, exposure=exposure):
                    vtkindirect.enable(renderer, tone_mapping=name, exposure=exposure)
                    found = screenshot(window)
                    expected = curve(name, final[lit], exposure)
                    self.assertLess(float(np.abs(found[lit] - expected).max()), 1.0)
                    # A plain background stays.
                    np.testing.assert_allclose(found[~lit], plain[~lit].astype(int), atol=1)
        vtkindirect.enable(renderer, tone_mapping=None, exposure=1)
        np.testing.assert_array_equal(screenshot(window), plain)

    def test_edges_and_alpha(self) -> None:
        """Edges between object and background are between their colours."""
        renderer = room(6.0)
        vtkindirect.enable(renderer, tone_mapping="filmic", exposure="auto")
        window = self.show(renderer)
        opaque = screenshot(window).astype(float)
        found = screenshot(window, transparent=True)
        alpha = found[:, :, 3:] / 255.0
        over = found[:, :, :3] * alpha + 255.0 * np.array(BACKGROUND) * (1.0 - alpha)
        inside = (alpha[:, :, 0] == 1.0) | (alpha[:, :, 0] == 0.0)
        self.assertLess(float(np.abs(over - opaque)[inside].max()), 1.6)
        # The curve bends mixtures of both, so that only near edges they differ.
        self.assertLess(float(np.mean(~inside)), 0.1)

    def test_auto(self) -> None:
        """Pictures of light of any strength are alike, in the first frame as later."""
        pictures, exposures = [], []
        for strength in (0.5, 5.0, 5000.0):
            renderer = room(strength)
            vtkindirect.enable(renderer, tone_mapping="reinhard", exposure="auto")
            window = self.show(renderer)
            pictures.append(screenshot(window).astype(float))
            final = images.copy_buffer(renderer, "final")
            report = vtkindirect.report(renderer)["tone_mapping"]
            self.assertEqual((report["curve"], report["auto"]), ("reinhard", True))
            exposures.append(report["exposure"] * tones.brightness(final))
        np.testing.assert_allclose(exposures, 1.0, rtol=1e-5)
        for picture in pictures[1:]:
            self.assertLess(float(np.abs(picture - pictures[0]).mean()), 1.0)

    def test_auto_on_an_orbit(self) -> None:
        """The exposure changes seldom, by no less than its band, and stays within it."""
        renderer = room(3.0)
        vtkindirect.enable(renderer, exposure="auto", tone_mapping="exponential")
        window = self.show(renderer)
        camera = renderer.GetActiveCamera()
        exposures, free = [], []
        for _ in range(72):
            camera.Azimuth(5)
            renderer.ResetCameraClippingRange()
            window.Render()
            found = tones.brightness(images.copy_buffer(renderer, "final"))
            if found is None:
                continue
            exposures.append(vtkindirect.report(renderer)["tone_mapping"]["exposure"])
            free.append(1.0 / found)
            self.assertTrue(0.8 <= found * exposures[-1] <= 1.25)
        steps = np.abs(np.diff(np.log(exposures)))
        changes = np.count_nonzero(steps)
        print(f"{changes} changes in 72 frames; the best: {min(free):.3g} to {max(free):.3g}")
        self.assertGreater(max(free) / min(free), 1.05)
        self.assertLessEqual(changes, 12)
        self.assertTrue(np.all((steps == 0) | (steps > np.log(1.25) - 1e-6)))

    def test_auto_follows_changes_alone(self) -> None:
        """The buffer is read where something has changed, such as the strength of a light."""
        renderer = room(2.0)
        vtkindirect.enable(renderer, exposure="auto")
        window = self.show(renderer)
        screenshot(window)
        read = mock.patch.object(tones, "brightness", side_effect=tones.brightness)
        with read as called:
            for _ in range(3):
                window.Render()
            self.assertLessEqual(called.call_count, 1)
            renderer.GetLights().GetItemAsObject(0).SetIntensity(20.0)
            window.Render()
            self.assertGreaterEqual(called.call_count, 1)
        found = tones.brightness(images.copy_buffer(renderer, "final"))
        exposure = vtkindirect.report(renderer)["tone_mapping"]["exposure"]
        self.assertTrue(0.8 <= found * exposure <= 1.25)

    def test_windows_of_several_samples(self) -> None:
        """They come after or before; the first frame has no antialiasing, and none is black."""
        pictures = []
        for late in (False, True):
            renderer = room(6.0)
            window = windows.render_window((160, 120), offscreen=True)
            self.addCleanup(window.Finalize)
            window.SetMultiSamples(4)
            if not late:
                window.AddRenderer(renderer)
            vtkindirect.enable(renderer, tone_mapping="filmic", exposure="auto")
            if late:
                window.AddRenderer(renderer)
                window.Render()
                self.assertGreater(float(images.window_bytes(window).mean()), 50.0)
            pictures.append(screenshot(window))
            self.assertTrue(renderer.GetPass().IsA("vtkOpenGLFXAAPass"))
            window.Render()
            vtkindirect.disable(renderer)
            self.assertEqual(window.GetMultiSamples(), 4)
        np.testing.assert_array_equal(*pictures)

    def test_nothing_to_see(self) -> None:
        renderer = vtkRenderer()
        vtkindirect.enable(renderer, exposure="auto")
        with vtkindirect.messages.capture() as said:
            self.show(renderer).Render()
        self.assertEqual(said.errors, [])
        self.assertEqual(vtkindirect.report(renderer)["tone_mapping"]["exposure"], 1.0)

    @unittest.skipIf(WHY_NO_PYVISTA, WHY_NO_PYVISTA or "")
    def test_pyvista(self) -> None:
        """Effects come and go beside the curve; a plotter that closes frees its memory."""
        if not windows.has_display():
            vtkindirect.use_headless()
        import pyvista

        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 60))
        plotter.add_mesh(pyvista.ParametricTorus(), color="tan")
        vtkindirect.enable(plotter, tone_mapping="filmic", exposure="auto")
        with vtkindirect.messages.capture() as said:
            plotter.show(auto_close=False)
            before = screenshot(plotter)
            plotter.enable_anti_aliasing("ssaa")
            plotter.render()
            top = plotter.renderer.GetPass()
            names = [found.GetClassName() for found, _, _ in chain.links(top)]
            self.assertEqual(names[1:3], ["vtkToneMappingPass", chain.PASS])
            self.assertGreater(float(before.mean()), 100.0)  # mostly white background
            plotter.disable_anti_aliasing()
            plotter.render()
            np.testing.assert_allclose(screenshot(plotter), before.astype(int), atol=1)
            plotter.close()
        self.assertEqual(said.errors, [])

    def test_command_line(self) -> None:
        path = self.write("small.json", support.small_scene())
        report = self.directory / "report.json"
        words = ("--tone-mapping", "filmic", "--exposure")
        for value, auto in (("2", False), ("auto", True)):
            result = support.command_line_here("render", path, *words, value, "--report", report)
            self.assertEqual(result.returncode, 0, result.stderr)
            found = json.loads(report.read_text())["tone_mapping"]
            self.assertEqual((found["curve"], found["auto"]), ("filmic", auto))
        for words, expected in (
            (("--tone-mapping", "filmc"), "unknown tone_mapping 'filmc' (did you mean 'filmic'?)"),
            (("--exposure", "lots"), "exposure must be a finite number above 0"),
        ):
            result = support.command_line_here("render", path, *words, "--report", report)
            self.assertEqual(result.returncode, 2)
            self.assertIn(expected, result.stderr)
