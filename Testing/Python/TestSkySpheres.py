# SPDX-License-Identifier: BSD-3-Clause
"""Sums over spheres beside path traced references: light of the sky, and its first bounce."""

import unittest

import numpy as np

import support
import vtkindirect
from vtkindirect import frames, metrics, references, wrapped
from vtkindirect.metrics import Errors

SAME = 2e-3
"""Relative difference of depths under which a pixel shows the surface that was traced: half floats
keep 5e-4, spheres are traced as triangles within 4e-3 of their radius."""
LAYERS = {"sky": "S1", "bounce": "S2"}
"""The layer of the reference that each buffer is compared with: light of the sky, its first bounce."""

# The scene, and the most of nRMSE that its kind may have of the direct light: atoms and particles
# are spheres as they are, meshes are covered by at most 256 each. Measured: 0.076, 0.019, 0.052,
# 0.066. Without groups and all beyond 15 radii 0.23 and 0.32.
SCENES = {"sky_protein": 0.1, "sky_particles": 0.04, "sky_frog": 0.15, "sky_brain": 0.15}
BIAS = 0.03
"""Bias of the direct light, over the mean. Measured: -0.017, +0.009, -0.014, -0.007."""
BOUNCE = 0.1
"""Bias of the bounce, likewise. Measured: -0.055, +0.006, -0.057, -0.038."""


class Traced:
    """A scene in a window of its own, an odd number of times the size of its reference."""

    def __init__(self, name: str, factor: int) -> None:
        self.stored = support.TESTING / "Reference" / "data" / f"{name}.exr"
        self.factor = factor
        self.traced = references.read_layer(self.stored, "depth")[..., 0]
        height, width = self.traced.shape
        self.scene = vtkindirect.load_scene(support.SCENES / f"{name}.json")
        frames.open_window(self.scene, (factor * width, factor * height))
        self.window = self.scene.render_window
        self.renderer = self.scene.renderer

    def buffer(self, name: str) -> np.ndarray:
        """Return a buffer of the last frame at the reference's pixels."""
        middle = slice(self.factor // 2, None, self.factor)
        return vtkindirect.copy_buffer(self.renderer, name)[middle, middle]

    def same(self) -> np.ndarray:
        """Return which of these show the surface that was traced."""
        depth = self.buffer("depth")[..., 0]
        return (depth > 0.0) & (np.abs(depth - self.traced) < SAME * self.traced)

    def errors(self, name: str) -> Errors:
        """Return the errors of a buffer there."""
        layer = references.read_layer(self.stored, LAYERS[name])
        return metrics.compare(self.buffer(name), layer, self.same())


@unittest.skipUnless(wrapped.has("vtkProxyAccumulationPass"), "vtkProxyAccumulationPass not built")
@unittest.skipUnless(wrapped.has("vtkSphereProxyFilter"), "vtkIndirectProxies was not built")
@unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
class SkySpheres(unittest.TestCase):
    def errors(self, name: str, factor: int = 1, step: int = 1) -> tuple[Errors, Errors]:
        """Return errors of direct light and of the first bounce; every pixel is a receiver, or every
        `step`-th of an image `factor` times the size of the reference, whose middles count.

        All pixels count that show the surface that was traced, silhouettes and crevices with them:
        atoms are a few pixels wide, and there is little else of them.
        """
        view = Traced(name, factor)
        self.addCleanup(view.window.Finalize)
        vtkindirect.enable(view.renderer, "proxies", lighting="scene")
        view.window.Render()
        self.assertEqual(vtkindirect.report(view.renderer)["settings"]["ReceiverStep"], step)
        # Edges of things that are a few pixels wide are all that differs.
        self.assertGreater(view.same().sum(), 0.95 * (view.traced > 0.0).sum())
        sky, bounce = (view.errors(buffer) for buffer in ("sky", "bounce"))
        print(
            f"{name}: nRMSE {sky.nrmse:.3f}, bias {sky.bias:+.3f}; "
            f"of the bounce {bounce.nrmse:.3f}, {bounce.bias:+.3f}"
        )
        return sky, bounce

    def check(self, name: str) -> None:
        sky, bounce = self.errors(name)
        self.assertLess(sky.nrmse, SCENES[name])
        self.assertLess(abs(sky.bias), BIAS)
        self.assertLess(abs(bounce.bias), BOUNCE)

    def test_atoms(self) -> None:
        self.check("sky_protein")

    def test_particles(self) -> None:
        self.check("sky_particles")

    def test_default_receivers(self) -> None:
        """Receivers are closer by themselves where spheres are small in the picture. Measured: nRMSE
        0.025, bias +0.011, of the bounce -0.018."""
        sky, bounce = self.errors("sky_particles", 3, 2)
        self.assertLess(sky.nrmse, SCENES["sky_particles"])
        self.assertLess(abs(sky.bias), BIAS)
        self.assertLess(abs(bounce.bias), BOUNCE)

    def test_organs(self) -> None:
        self.check("sky_frog")

    def test_cortex(self) -> None:
        self.check("sky_brain")


if __name__ == "__main__":
    unittest.main()
