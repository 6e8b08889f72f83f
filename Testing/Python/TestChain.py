# SPDX-License-Identifier: BSD-3-Clause
"""Indirect light in chains of passes: effects on the picture stay, and nothing goes in silence."""

import unittest
import warnings

import numpy as np
import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from vtkindirect import chain, images, wrapped

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkRenderPassCollection, vtkSequencePass
except ImportError:  # later versions of VTK
    from vtkmodules.vtkRenderingCore import vtkRenderPassCollection, vtkSequencePass

WHY_NOT = support.why_no_rendering()

EFFECTS = (
    opengl.vtkSSAAPass,
    opengl.vtkGaussianBlurPass,
    opengl.vtkDepthOfFieldPass,
    opengl.vtkEDLShading,
    opengl.vtkOpenGLFXAAPass,
    opengl.vtkToneMappingPass,
    opengl.vtkPanoramicProjectionPass,
)


def sequence(*passes):
    """Return a vtkSequencePass of the given passes."""
    collection = vtkRenderPassCollection()
    for each in passes:
        collection.AddItem(each)
    result = vtkSequencePass()
    result.SetPasses(collection)
    return result


def around(outer, inner):
    """Make one pass the delegate of another; returns the outer one."""
    outer.SetDelegatePass(inner)
    return outer


def drawn_by_vtk(with_shadows: bool = False):
    """Return VTK's usual steps as PyVista puts them together."""
    passes = [opengl.vtkRenderStepsPass()]
    if with_shadows:
        shadows = opengl.vtkShadowMapPass()
        passes += [shadows.GetShadowMapBakerPass(), shadows]
    return around(opengl.vtkCameraPass(), sequence(*passes))


@unittest.skipUnless(wrapped.has(chain.PASS), "the module vtkRenderingIndirect was not built")
class Chain(unittest.TestCase):
    def setUp(self) -> None:
        self.renderer = vtkRenderer()
        caught = warnings.catch_warnings(record=True)
        self.said = caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("always")

    def names(self) -> list[str]:
        """Return the class names along the delegates, from the renderer's pass on."""
        found, each = [], self.renderer.GetPass()
        while each is not None:
            found.append(each.GetClassName())
            each = each.GetDelegatePass() if hasattr(each, "GetDelegatePass") else None
        return found

    def test_effects_stay_around_it(self) -> None:
        for make in EFFECTS:
            for base in (opengl.vtkRenderStepsPass(), drawn_by_vtk()):
                effect = around(make(), base)
                self.renderer.SetPass(effect)
                indirect = vtkindirect.enable(self.renderer)
                self.assertIs(self.renderer.GetPass(), effect)
                self.assertIs(effect.GetDelegatePass(), indirect)
                self.assertIs(vtkindirect.pass_of(self.renderer), indirect)
                self.assertIs(vtkindirect.enable(self.renderer, "gather"), indirect)
                vtkindirect.disable(self.renderer)
                self.assertIs(self.renderer.GetPass(), effect)
                self.assertIs(effect.GetDelegatePass(), base)
                self.assertIsNone(vtkindirect.pass_of(self.renderer))
        self.assertEqual(self.said, [])

    def test_several_effects(self) -> None:
        inner = around(opengl.vtkGaussianBlurPass(), drawn_by_vtk())
        self.renderer.SetPass(around(opengl.vtkSSAAPass(), inner))
        before = self.names()
        vtkindirect.enable(self.renderer)
        self.assertEqual(self.names(), ["vtkSSAAPass", "vtkGaussianBlurPass", chain.PASS])
        vtkindirect.disable(self.renderer)
        self.assertEqual(self.names(), before)
        self.assertEqual(self.said, [])

    def test_what_cannot_be_combined_is_left_out_with_a_warning(self) -> None:
        occlusion = around(opengl.vtkSSAOPass(), drawn_by_vtk(with_shadows=True))
        self.renderer.SetPass(around(opengl.vtkSSAAPass(), occlusion))
        before = self.names()
        vtkindirect.enable(self.renderer)
        self.assertEqual(self.names(), ["vtkSSAAPass", chain.PASS])
        self.assertEqual(len(self.said), 1, self.said)
        text = str(self.said[0].message)
        for words in (
            "without effect until vtkindirect.disable",
            "vtkSSAOPass",
            "vtkShadowMapPass",
        ):
            self.assertIn(words, text)
        self.assertNotIn("Baker", text)
        self.assertEqual(self.said[0].filename, __file__)
        vtkindirect.enable(self.renderer, "gather")
        self.assertEqual(len(self.said), 1)
        vtkindirect.disable(self.renderer)
        self.assertEqual(self.names(), before)

    def test_a_pass_that_draws_otherwise_is_named(self) -> None:
        self.renderer.SetPass(opengl.vtkDualDepthPeelingPass())
        vtkindirect.enable(self.renderer)
        self.assertIn("vtkDualDepthPeelingPass", str(self.said[0].message))

    def test_put_into_a_chain_by_hand(self) -> None:
        indirect = vtkindirect.vtkIndirectIlluminationPass()
        steps = opengl.vtkRenderStepsPass()
        for top, after in (
            (indirect, []),
            (around(opengl.vtkSSAAPass(), indirect), ["vtkSSAAPass", "vtkRenderStepsPass"]),
            (around(opengl.vtkCameraPass(), indirect), ["vtkCameraPass", "vtkRenderStepsPass"]),
            (sequence(opengl.vtkClearZPass(), indirect), ["vtkSequencePass"]),
            (steps, ["vtkRenderStepsPass"]),
        ):
            if top is steps:
                steps.SetPostProcessPass(indirect)
            self.renderer.SetPass(top)
            with self.subTest(top=top.GetClassName()):
                self.assertIs(vtkindirect.pass_of(self.renderer), indirect)
                self.assertIs(vtkindirect.enable(self.renderer, NumberOfLights=99), indirect)
                self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 99)
                vtkindirect.disable(self.renderer)
                self.assertIsNone(vtkindirect.pass_of(self.renderer))
                self.assertEqual(self.names(), after)

    def test_wrapped_after_it_was_enabled(self) -> None:
        mine = opengl.vtkRenderStepsPass()
        self.renderer.SetPass(mine)
        indirect = vtkindirect.enable(self.renderer)
        effect = around(opengl.vtkSSAAPass(), indirect)
        self.renderer.SetPass(effect)
        self.assertIs(vtkindirect.pass_of(self.renderer), indirect)
        vtkindirect.disable(self.renderer)
        self.assertIs(self.renderer.GetPass(), effect)
        self.assertIs(effect.GetDelegatePass(), mine)

    def test_a_chain_that_runs_in_a_circle(self) -> None:
        first, second = opengl.vtkSSAAPass(), opengl.vtkGaussianBlurPass()
        first.SetDelegatePass(second)
        second.SetDelegatePass(first)
        self.renderer.SetPass(first)
        self.assertIsNone(vtkindirect.pass_of(self.renderer))
        second.SetDelegatePass(None)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Pictures(support.DirectoryTest):
    """An effect around the pass works on the pass's picture."""

    def picture(self, effect, light: str) -> np.ndarray:
        scene = vtkindirect.load_scene(self.write("scene.json", support.small_scene()))
        window = scene.make_window()
        self.addCleanup(window.Finalize)
        if effect is not None:
            scene.renderer.SetPass(around(effect, drawn_by_vtk()))
        if light == "nothing modelled":
            vtkindirect.enable(scene.renderer, IndirectScale=0, Shadows=False)
        elif light == "indirect":
            vtkindirect.enable(scene.renderer)
        for _ in range(2):  # the first frame that VTK's depth of field draws is black
            window.Render()
        if light == "indirect":
            self.assertEqual(vtkindirect.report(scene.renderer)["method"], "multiresolution")
            depth = vtkindirect.copy_buffer(scene.renderer, "depth")
            factor = 2 if isinstance(effect, opengl.vtkSSAAPass) else 1
            self.assertGreaterEqual(depth.shape[0], factor * 48)
        return images.window_bytes(window).astype(int)

    def test_same_as_around_vtk_when_nothing_is_modelled(self) -> None:
        alone = self.picture(None, "indirect")
        for make in EFFECTS:
            with self.subTest(make=make.__name__):
                vtk = self.picture(make(), "off")
                self.assertGreater(vtk.max(), 100)
                # Only the delegate draws then, and its picture is VTK's to the bit.
                self.assertTrue(np.array_equal(self.picture(make(), "nothing modelled"), vtk))
                both = self.picture(make(), "indirect")
                self.assertTrue((both != vtk).any(), "indirect light is not in the picture")
                self.assertTrue((both != alone).any(), "the effect is not in the picture")
