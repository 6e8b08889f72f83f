# SPDX-License-Identifier: BSD-3-Clause
"""Renderers that go from window to window, and estimators and samplers of several passes."""

import unittest

import numpy as np
import support
from rooms import make_actor, make_ball, make_room
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter

import vtkindirect
from vtkindirect import windows, wrapped

SIZE = (48, 36)
# One without resources that follow it, those with samplers of their own, one with a grid, one with
# spheres, and the automatic one.
METHODS = ("auto", "hints", "reference", "gather", "splatting", "proxies")
ESTIMATORS = (
    "vtkIndirectSplattingPass",
    "vtkMultiresolutionSplattingPass",
    "vtkProxyAccumulationPass",
    "vtkRSMGatherPass",
    "vtkRSMReferencePass",
    "vtkRadianceHintsPass",
)
SAMPLERS = (
    "vtkImportanceLightSampler",
    "vtkLightTreeSampler",
    "vtkRandomWalkLightSampler",
    "vtkUniformLightSampler",
)


def make_scene(radius: float = 0.4) -> vtkRenderer:
    """Return a floor, a wall and a red ball under a spot."""
    return make_room(make_actor(make_ball(radius)))


def make_window(renderer: vtkRenderer):
    window = windows.render_window(SIZE, offscreen=True)
    window.AddRenderer(renderer)
    return window


def shoot(window, frames: int = 1) -> np.ndarray:
    for _ in range(frames):
        window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).astype(int)


def settings(method: str) -> dict:
    return {"environment": (1, 1, 1)} if method == "proxies" else {}


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Sharing(unittest.TestCase):
    def test_a_renderer_moves(self) -> None:
        """Into another window, whether or not the first has been finalized, with another current;
        and its window begins again."""
        for method in METHODS:
            with self.subTest(method=method):
                renderer = make_scene()
                window = make_window(renderer)
                vtkindirect.enable(renderer, method, lighting="scene", **settings(method))
                before = shoot(window)
                self.assertEqual(np.abs(before - shoot(window)).max(), 0)
                third = make_window(vtkRenderer())
                third.Render()
                window.RemoveRenderer(renderer)
                other = make_window(renderer)
                self.assertEqual(np.abs(before - shoot(other)).max(), 0, "in another window")
                other.Finalize()
                self.assertEqual(np.abs(before - shoot(other)).max(), 0, "begun again")
                other.Finalize()
                other.RemoveRenderer(renderer)
                window.AddRenderer(renderer)
                self.assertEqual(np.abs(before - shoot(window)).max(), 0, "back in the first")

    def check_shared(self, name: str, share, same_window: bool) -> None:
        """Two passes with what `share` gives them have the pictures of passes on their own."""

        def make(shared: bool):
            thing = wrapped.get(name)()
            views = []
            renderers = [make_scene(radius) for radius in (0.4, 0.25)]
            window = None
            for number, renderer in enumerate(renderers):
                if window is None or not same_window:
                    window = make_window(renderer)
                else:
                    window.AddRenderer(renderer)
                if same_window:
                    renderer.SetViewport(0.5 * number, 0, 0.5 + 0.5 * number, 1)
                kind = "proxies" if name == "vtkProxyAccumulationPass" else ""
                indirect = vtkindirect.enable(renderer, lighting="scene", **settings(kind))
                share(indirect, thing if shared else wrapped.get(name)())
                views.append((window, indirect))
            return views

        own = make(False)
        shared = make(True)
        expected = [shoot(window) for window, _ in own]
        for _ in range(2):
            for picture, (window, _) in zip(expected, shared):
                self.assertEqual(np.abs(picture - shoot(window)).max(), 0, name)
        # A buffer that the second frame has replaced is refused, and nothing is lost by it.
        if not same_window:
            image = vtkImageData()
            for buffer in ("irradiance", "lights"):
                with support.quiet():
                    shared[0][1].CopyBuffer(buffer, image)
            self.assertTrue(shared[1][1].CopyBuffer("irradiance", image))
            shared[0][0].Finalize()
            self.assertEqual(np.abs(expected[1] - shoot(shared[1][0])).max(), 0, name)

    def test_an_estimator_of_two_passes(self) -> None:
        for same_window in (False, True):
            for name in ESTIMATORS:
                with self.subTest(name=name, same_window=same_window):
                    self.check_shared(
                        name, lambda indirect, thing: indirect.SetEstimator(thing), same_window
                    )

    def test_a_sampler_of_two_passes(self) -> None:
        for name in SAMPLERS:
            with self.subTest(name=name):
                self.check_shared(name, lambda indirect, thing: indirect.SetSampler(thing), False)

    def test_a_further_sampler_of_two_passes(self) -> None:
        light = wrapped.get("vtkAreaLight")()
        light.SetOrigin(-0.5, 1.9, -0.5)
        light.SetPoint1(0.5, 1.9, -0.5)
        light.SetPoint2(-0.5, 1.9, 0.5)

        def share(indirect, sampler) -> None:
            sampler.AddLight(light)
            indirect.AddSampler(sampler)

        self.check_shared("vtkAreaLightSampler", share, False)


if __name__ == "__main__":
    unittest.main()
