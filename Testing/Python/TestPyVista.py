# SPDX-License-Identifier: BSD-3-Clause
"""With a real PyVista: its effects and indirect light, whichever order they come in."""

import gc
import unittest
import warnings

import numpy as np

import support
import vtkindirect
from vtkindirect import chain, messages, methods, windows

WHY_NOT = support.why_no_rendering() or support.why_no_pyvista()
if not WHY_NOT:
    if not windows.has_display():
        vtkindirect.use_headless()
    import pyvista

# For speed: a depth map for each.
FEW = {"number_of_lights": 16}

# Effects that work on the picture with indirect light: how each is switched on and off, its pass.
TOGETHER = {
    "vtkSSAAPass": (
        lambda plotter: plotter.enable_anti_aliasing("ssaa"),
        lambda plotter: plotter.disable_anti_aliasing(),
    ),
    "vtkEDLShading": (
        lambda plotter: plotter.enable_eye_dome_lighting(),
        lambda plotter: plotter.disable_eye_dome_lighting(),
    ),
    "vtkDepthOfFieldPass": (
        lambda plotter: plotter.enable_depth_of_field(),
        lambda plotter: plotter.disable_depth_of_field(),
    ),
    "vtkGaussianBlurPass": (
        lambda plotter: plotter.add_blurring(),
        lambda plotter: plotter.remove_blurring(),
    ),
}

# Effects that indirect light takes the place of.
APART = {
    "vtkSSAOPass": (
        lambda plotter: plotter.enable_ssao(),
        lambda plotter: plotter.disable_ssao(),
    ),
    "vtkShadowMapPass": (
        lambda plotter: plotter.enable_shadows(),
        lambda plotter: plotter.disable_shadows(),
    ),
}


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Effects(unittest.TestCase):
    def setUp(self) -> None:
        caught = warnings.catch_warnings(record=True)
        self.said = caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("always")

    def plotter(self) -> "pyvista.Plotter":
        """Return a plotter of a red sphere on a white floor under a spot light."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(96, 80), lighting="none")
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Plane(i_size=4, j_size=4), color="white")
        plotter.add_mesh(pyvista.Sphere(center=(0, 0, 0.5)), color="red")
        light = pyvista.Light(position=(2, 2, 3), focal_point=(0, 0, 0), cone_angle=40)
        light.positional = True
        plotter.add_light(light)
        plotter.camera_position = [(3, -4, 3), (0, 0, 0), (0, 0, 1)]
        return plotter

    def test_depth_peeling(self) -> None:
        """OpenGL errors that VTK's peeling leaves are not taken for errors of the next frame."""
        plotter = self.plotter()
        plotter.add_mesh(pyvista.Sphere(center=(0, -1, 0.5)), color="green", opacity=0.4)
        plotter.enable_depth_peeling()
        vtkindirect.enable(plotter, **FEW)
        with messages.capture() as said:
            for _ in range(3):
                plotter.render_window.Render()
        self.assertEqual(said.errors, [])

    def switch_off(self, plotter: "pyvista.Plotter", off) -> None:
        """Switch an effect off; early versions of PyVista leave its graphics memory behind."""
        plotter.render_window.MakeCurrent()
        for found, _, _ in chain.links(plotter.renderer.GetPass()):
            found.ReleaseGraphicsResources(plotter.render_window)
        off(plotter)

    def picture(self, plotter: "pyvista.Plotter") -> np.ndarray:
        for _ in range(2):  # the first frame that VTK's depth of field draws is black
            plotter.render()
            plotter.render_window.Render()
        return plotter.screenshot(return_img=True).astype(int)

    def names(self, plotter: "pyvista.Plotter") -> list[str]:
        """Return the class names of all passes below the renderer."""
        return [found.GetClassName() for found, _, _ in chain.links(plotter.renderer.GetPass())]

    def warned(self) -> list[str]:
        """Return the warnings of this package since the last call."""
        found = [str(said.message) for said in self.said if "indirect light" in str(said.message)]
        self.said.clear()
        return found

    def test_effects_on_the_picture_in_any_order(self) -> None:
        plain = self.plotter()
        vtkindirect.enable(plain, **FEW)
        alone = self.picture(plain)
        for name, (on, off) in TOGETHER.items():
            vtk = self.plotter()
            on(vtk)
            without = self.picture(vtk)
            first, last = self.plotter(), self.plotter()
            on(first)
            vtkindirect.enable(first, **FEW)
            indirect = vtkindirect.enable(last, **FEW)
            on(last)
            self.assertIs(vtkindirect.pass_of(last), indirect)
            pictures = []
            for plotter in (first, last):
                with self.subTest(name=name, effect_first=plotter is first):
                    pictures.append(self.picture(plotter))
                    self.assertEqual(self.names(plotter), [name, chain.PASS])
                    self.assertEqual(vtkindirect.report(plotter)["method"], "multiresolution")
                    self.assertGreater(vtkindirect.copy_buffer(plotter, "indirect").max(), 0)
                    self.assertTrue((pictures[-1] != alone).any(), "the effect is lost")
                    self.assertTrue((pictures[-1] != without).any(), "indirect light is lost")
            self.assertTrue(np.array_equal(*pictures))
            with self.subTest(name=name, then="the effect is switched off"):
                self.switch_off(first, off)
                self.assertTrue(np.array_equal(self.picture(first), alone))
                self.assertEqual(self.names(first), [chain.PASS])
            with self.subTest(name=name, then="indirect light is switched off"):
                vtkindirect.disable(last)
                self.assertTrue(np.array_equal(self.picture(last), without))
                self.assertIsNone(vtkindirect.pass_of(last))
                self.assertIn(name, self.names(last))
                self.switch_off(last, off)
                self.assertIsNone(last.renderer.GetPass())
        self.assertEqual(self.warned(), [])

    def test_effects_that_cannot_be_combined(self) -> None:
        plain = self.plotter()
        vtkindirect.enable(plain, **FEW)
        alone = self.picture(plain)
        for name, (on, off) in APART.items():
            for effect_first in (True, False):
                with self.subTest(name=name, effect_first=effect_first):
                    plotter = self.plotter()
                    if effect_first:
                        on(plotter)
                        self.warned()
                        vtkindirect.enable(plotter, **FEW)
                    else:
                        vtkindirect.enable(plotter, **FEW)
                        on(plotter)
                    (text,) = self.warned()
                    self.assertIn(name, text)
                    self.assertIn("vtkindirect.disable", text)
                    self.assertTrue(np.array_equal(self.picture(plotter), alone))
                    vtkindirect.disable(plotter)
                    self.assertIn(name, self.names(plotter))
                    vtkindirect.enable(plotter, **FEW)
                    self.assertEqual(len(self.warned()), 1)
                    self.switch_off(plotter, off)
                    self.assertIsNotNone(vtkindirect.pass_of(plotter))
                    self.assertTrue(np.array_equal(self.picture(plotter), alone))
                    self.assertEqual(self.warned(), [])

    def test_the_warning_names_the_callers_line(self) -> None:
        plotter = self.plotter()
        vtkindirect.enable(plotter)
        plotter.enable_ssao()
        said = [said for said in self.said if "vtkSSAOPass" in str(said.message)]
        self.assertEqual([each.filename for each in said], [__file__])

    def test_an_effect_below_another(self) -> None:
        # The begin of PyVista's chain stays the same then, and only the next frame can tell.
        plotter = self.plotter()
        plotter.enable_anti_aliasing("ssaa")
        indirect = vtkindirect.enable(plotter)
        plotter.add_blurring()
        self.picture(plotter)
        self.assertEqual(self.names(plotter), ["vtkSSAAPass", "vtkGaussianBlurPass", chain.PASS])
        self.switch_off(plotter, lambda each: each.remove_blurring())
        self.assertIs(vtkindirect.pass_of(plotter), indirect)
        self.assertEqual(self.names(plotter), ["vtkSSAAPass", chain.PASS])
        self.switch_off(plotter, lambda each: each.disable_anti_aliasing())
        self.assertEqual(self.names(plotter), [chain.PASS])

    def test_somebodys_own_pass_stays(self) -> None:
        from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

        plotter = self.plotter()
        vtkindirect.enable(plotter)
        for mine in (vtkRenderStepsPass(), None):
            plotter.renderer.SetPass(mine)
            self.picture(plotter)
            self.assertIs(plotter.renderer.GetPass(), mine)
            self.assertIsNone(vtkindirect.pass_of(plotter))

    def test_subplots(self) -> None:
        plotter = pyvista.Plotter(shape=(1, 2), off_screen=True, window_size=(96, 48))
        self.addCleanup(plotter.close)
        for column in (0, 1):
            plotter.subplot(0, column)
            plotter.add_mesh(pyvista.Sphere())
        indirect = vtkindirect.enable(plotter)
        self.assertIs(plotter.renderers[1].GetPass(), indirect)
        self.assertIsNone(plotter.renderers[0].GetPass())
        plotter.render()
        self.assertIs(plotter.renderers[1].GetPass(), indirect)

    def test_closing(self) -> None:
        for _ in range(3):
            plotter = self.plotter()
            plotter.enable_anti_aliasing("ssaa")
            vtkindirect.enable(plotter)
            self.picture(plotter)
            plotter.close()
            self.assertEqual(self.warned(), [])
            del plotter
        gc.collect()
        another = self.plotter()
        vtkindirect.enable(another)
        alive = [record for record in methods._records.values() if record.renderer.Get()]
        self.assertEqual(len(methods._records), len(alive))


def _make_cloud(height: float = 0.25) -> "pyvista.PolyData":
    """Return nine points over a floor, with radii."""
    steps = (-0.6, 0.0, 0.6)
    cloud = pyvista.PolyData(np.array([(x, y, height) for x in steps for y in steps]))
    cloud["radius"] = np.full(9, 0.15)
    return cloud


def _add_sized_splats(plotter: "pyvista.Plotter") -> None:
    actor = plotter.add_mesh(
        _make_cloud(), style="points_gaussian", render_points_as_spheres=True, color="red"
    )
    actor.mapper.scale_array = "radius"


# PyVista draws these shapes at points over a floor; they take part as polygons do.
PARTAKING = {
    "spheres": lambda plotter: plotter.add_mesh(
        _make_cloud().glyph(scale=False, orient=False, geom=pyvista.Sphere(radius=0.15)),
        color="red",
    ),
    "points": lambda plotter: plotter.add_points(
        _make_cloud().points, render_points_as_spheres=True, point_size=20, color="red"
    ),
    "points of a grid": lambda plotter: plotter.add_mesh(
        _make_cloud().cast_to_unstructured_grid(),
        style="points",
        render_points_as_spheres=True,
        point_size=20,
        color="red",
    ),
    "points of a mesh": lambda plotter: plotter.add_mesh(
        pyvista.Cube(center=(0, 0, 0.35), z_length=0.3),
        style="points",
        render_points_as_spheres=True,
        point_size=20,
        color="red",
    ),
    "splats": lambda plotter: plotter.add_mesh(
        _make_cloud(),
        style="points_gaussian",
        render_points_as_spheres=True,
        point_size=150,
        color="red",
    ),
    "sized splats": _add_sized_splats,
}
# Further shapes take no part, for these reasons.
APART_FROM_LIGHT = {
    "flat points": (
        lambda plotter: plotter.add_points(_make_cloud().points, point_size=20),
        "lines and points are sized in pixels",
    ),
    "soft splats": (
        lambda plotter: plotter.add_mesh(_make_cloud(), style="points_gaussian", point_size=40),
        "translucent geometry",
    ),
    "emissive splats": (
        lambda plotter: plotter.add_mesh(_make_cloud(), style="points_gaussian", emissive=True),
        "splats have no surface",
    ),
    "lines": (
        lambda plotter: plotter.add_mesh(pyvista.Line((-1, 0, 0.2), (1, 0, 0.2)), line_width=5),
        "lines and points are sized in pixels",
    ),
}


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Points(unittest.TestCase):
    """Points that look like spheres cast shadows, send light and receive it; others are named."""

    def look(self, add) -> tuple[dict[str, np.ndarray], list[str]]:
        """Return the light over a white floor under a sky, and the warnings of two frames."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(128, 96))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Plane(i_size=3, j_size=3), color="white")
        add(plotter)
        plotter.camera_position = [(2.2, -2.8, 2.6), (0, 0, 0.1), (0, 0, 1)]
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            vtkindirect.enable(plotter, environment="uniform")
            for _ in range(2):
                plotter.render_window.Render()
        buffers = ("sky", "bounce", "albedo")
        light = {name: vtkindirect.copy_buffer(plotter, name) for name in buffers}
        return light, [str(each.message) for each in said]

    def test_points_that_look_like_spheres_take_part(self) -> None:
        bare, _ = self.look(lambda plotter: None)
        floor = bare["albedo"][..., 1] > 0.9
        for name, add in PARTAKING.items():
            with self.subTest(name):
                light, said = self.look(add)
                self.assertEqual(said, [])
                red = (light["albedo"][..., 0] > 0.5) & (light["albedo"][..., 1] < 0.5)
                around = floor & (light["albedo"][..., 1] > 0.9)
                self.assertGreater(red.sum(), 300)
                hidden = 1 - light["sky"][around].mean() / bare["sky"][around].mean()
                self.assertGreater(hidden, 0.02, "no shadow")
                sent = light["bounce"][around, 0] - light["bounce"][around, 1]
                self.assertGreater(sent.mean(), 0.5 * hidden, "no light sent")
                # The lower halves of the spheres, and the upper ones, are seen alike.
                got = light["sky"][red, 0]
                self.assertGreater(got.mean(), 0.4, "no light received")
                self.assertGreater(got.std(), 0.1, "no shading")

    def test_others_are_named_once(self) -> None:
        for name, (add, why) in APART_FROM_LIGHT.items():
            with self.subTest(name):
                _, said = self.look(add)
                self.assertEqual(len(said), 1)
                self.assertIn(why, said[0])


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Widgets(unittest.TestCase):
    def test_handles_cast_no_shadows(self) -> None:
        """Widgets that come before or after leave the lights' maps as they are."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(96, 80), lighting="none")
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Plane(i_size=6, j_size=6), color="white")
        plotter.add_mesh(pyvista.Sphere(center=(0, 0, 0.5)), color="red")
        light = pyvista.Light(position=(2, 2, 6), focal_point=(0, 0, 0), cone_angle=40)
        light.positional = True
        plotter.add_light(light)
        vtkindirect.enable(plotter)
        plotter.show(auto_close=False)
        alone = vtkindirect.copy_buffer(plotter, "rsm0.depth")
        count = plotter.renderer.GetActors().GetNumberOfItems()
        plotter.add_sphere_widget(lambda *_: None, center=(1, 1, 0.5), radius=0.3)
        plotter.add_plane_widget(lambda *_: None, bounds=(-1, 1, -1, 1, 0, 1))
        plotter.add_box_widget(lambda *_: None, bounds=(-1, 1, -1, 1, 0, 1))
        plotter.render()
        self.assertGreater(plotter.renderer.GetActors().GetNumberOfItems(), count + 10)
        # Handles are lit: they belong to the scene's space, by which lengths are scaled. Rounding.
        with_widgets = vtkindirect.copy_buffer(plotter, "rsm0.depth")
        np.testing.assert_allclose(alone, with_widgets, rtol=1e-5)

        vtkindirect.disable(plotter)
        vtkindirect.enable(plotter)
        plotter.render()
        again = vtkindirect.copy_buffer(plotter, "rsm0.depth")
        np.testing.assert_allclose(alone, again, rtol=1e-5)
