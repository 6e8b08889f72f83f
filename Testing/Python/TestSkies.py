# SPDX-License-Identifier: BSD-3-Clause
"""Named surroundings and suns: their radiances, what surfaces get, and which lights are on."""

import json
import math
import unittest
from typing import Any

import numpy as np
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit, vtkRenderer

import support
import vtkindirect
from rooms import make_actor
from vtkindirect import UsageError, images, load_scene, skies, windows, wrapped
from vtkindirect.skies import Sun

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = WHY_NOT or support.why_no_pyvista()

SUNS = (None, Sun(135.0, 40.0), Sun(250.0, 5.0), Sun(0.0, 90.0), Sun(10.0, 0.0))


def kit() -> vtkRenderer:
    """Return a renderer with the light kit, whose camera has z up."""
    renderer = vtkRenderer()
    vtkLightKit().AddLightsToRenderer(renderer)
    renderer.GetActiveCamera().SetPosition(0, -5, 2)
    renderer.GetActiveCamera().SetViewUp(0, 0.3, 1)
    return renderer


def lights(renderer: vtkRenderer) -> list[vtkLight]:
    found = renderer.GetLights()
    return [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]


def state(renderer: vtkRenderer) -> list[tuple[Any, ...]]:
    """Return what a call that fails may not change."""
    indirect = vtkindirect.pass_of(renderer)
    found = [(light.GetSwitch(), light.GetFocalPoint()) for light in lights(renderer)]
    environment = indirect.GetEnvironment() if indirect is not None else None
    return [*found, renderer.GetPass(), environment, renderer.GetAutomaticLightCreation()]


def floor_roughness(renderer: vtkRenderer, step: int) -> float:
    """Return the bend of a white floor's light over two steps of some pixels, over the mean light."""
    light = vtkindirect.copy_buffer(renderer, "sky")[..., 0].astype(float)
    on_floor = vtkindirect.copy_buffer(renderer, "albedo")[..., 2] > 0.5
    assert on_floor.mean() > 0.1
    inside = on_floor.copy()
    inside[:6] = inside[-6:] = inside[:, :6] = inside[:, -6:] = False
    for axis in (0, 1):
        inside = np.logical_and.reduce([np.roll(inside, k, axis) for k in range(-6, 7)])
    bends = []
    for axis in (0, 1):
        before, after = (np.roll(light, k, axis) for k in (-step, step))
        bends.append((before + after - 2 * light)[inside])
    return float(np.sqrt(np.mean(np.concatenate(bends) ** 2)) / light[on_floor].mean())


class Images(unittest.TestCase):
    """Radiances by their formulas."""

    def test_irradiance_of_a_horizontal_surface(self) -> None:
        for name in skies.NAMES:
            for sun in SUNS:
                with self.subTest(name=name, sun=sun):
                    above, below = skies.irradiances(skies.radiances(name, sun))
                    share = skies.sky_share(name, sun) if sun else 1.0
                    self.assertAlmostEqual(above, 0.9 * share, places=6)
                    facing = skies.sun_irradiance(name, sun) if sun else 0.0
                    self.assertAlmostEqual(above + facing, 0.9, places=6)
                    if name in ("overcast", "clear"):
                        height = math.sin(math.radians(sun.elevation)) if sun else 0.0
                        self.assertAlmostEqual(below, 0.2 * (above + facing * height), places=6)

    def test_uniform(self) -> None:
        self.assertLess(np.ptp(skies.radiances("uniform")), 1e-12)

    def test_overcast(self) -> None:
        upper = skies.radiances("overcast")[32:]
        elevation = (np.arange(32) + 0.5) / 32 * math.pi / 2
        expected = (1 + 2 * np.sin(elevation)) / 3
        zenith = 0.9 * 9 / 7  # E = 7/9 of the radiance of the zenith
        np.testing.assert_allclose(upper[:, 5] / zenith, expected, rtol=1e-3)

    def test_clear(self) -> None:
        """Brightest around the sun, darkest across the sky from it."""
        radiances = skies.radiances("clear", Sun(90.0, 40.0))[32:]
        row, column = np.unravel_index(radiances.argmax(), radiances.shape)
        self.assertAlmostEqual((row + 0.5) / 32 * 90, 40, delta=4)
        self.assertAlmostEqual((column + 0.5) / 128 * 360 - 180, 90, delta=4)
        row, column = np.unravel_index(radiances.argmin(), radiances.shape)
        self.assertAlmostEqual((column + 0.5) / 128 * 360 - 180, -90, delta=4)
        # By the formula, over the zenith: at an elevation of 50, 90 degrees from the sun.

        def indicatrix(angle: float) -> float:
            return 0.91 + 10 * math.exp(-3 * angle) + 0.45 * math.cos(angle) ** 2

        expected = indicatrix(math.pi / 2) * (1 - math.exp(-0.32 / math.sin(math.radians(50))))
        expected /= indicatrix(math.radians(50)) * (1 - math.exp(-0.32))
        far = radiances[:, 31:33].mean(axis=1)  # azimuth -90
        found = np.interp(50, (np.arange(32) + 0.5) / 32 * 90, far)
        # The zenith's pixels are 1.4 degrees from it.
        self.assertAlmostEqual(found / radiances[-1].mean(), expected, delta=0.03 * expected)

    def test_shares_of_sun_and_sky(self) -> None:
        """A clear day's sky has an eighth of the light, one with clouds four ninths."""
        for elevation, clear, hazy in ((90.0, 0.136, 0.4415), (40.0, 0.1257, 0.443)):
            sun = Sun(0.0, elevation)
            self.assertAlmostEqual(skies.sky_share("clear", sun), clear, delta=0.002)
            self.assertAlmostEqual(skies.sky_share("overcast", sun), hazy, delta=0.002)


@unittest.skipUnless(
    wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
)
class Words(unittest.TestCase):
    """Words of `enable`, without a frame."""

    def seen(self, indirect: Any, direction: Any) -> float:
        found = [0.0, 0.0, 0.0]
        indirect.GetEnvironment().GetRadianceFrom(direction, found)
        return found[0]

    def test_axes(self) -> None:
        """North and east of each axis that may be up, for the sky as for the sun."""
        for up, east, north in (
            ("z", (1, 0, 0), (0, 1, 0)),
            ("y", (1, 0, 0), (0, 0, -1)),
            ("x", (0, 1, 0), (0, 0, 1)),
            ("-z", (1, 0, 0), (0, -1, 0)),
        ):
            for azimuth, towards in ((0, north), (90, east), (180, [-a for a in north])):
                renderer = kit()
                indirect = vtkindirect.enable(
                    renderer, sun=(azimuth, 10), environment="clear", up=up
                )
                (sun,) = [light for light in lights(renderer) if light.GetSwitch()]
                direction = -np.array(sun.GetFocalPoint())
                self.assertAlmostEqual(direction @ towards, math.cos(math.radians(10)), places=9)
                axis = np.zeros(3)
                axis["xyz".index(up[-1])] = -1 if up[0] == "-" else 1
                self.assertAlmostEqual(direction @ axis, math.sin(math.radians(10)), places=9)
                here, there = (self.seen(indirect, list(d)) for d in (direction, axis - direction))
                self.assertGreater(here, 3 * there)
                # The ground is below.
                ground = skies.radiances("clear", Sun(azimuth, 10))[0, 0]
                self.assertAlmostEqual(self.seen(indirect, list(-axis)), ground, 5)

    def test_up_is_the_cameras(self) -> None:
        for view_up, up in (((0, 1, 0), (0, 1, 0)), ((0, 0.3, -1), (0, 0, -1))):
            renderer = vtkRenderer()
            renderer.GetActiveCamera().SetPosition(5, 0, 0)
            renderer.GetActiveCamera().SetViewUp(view_up)
            indirect = vtkindirect.enable(renderer, environment="overcast")
            self.assertEqual(indirect.GetEnvironment().GetUp(), up)

    def test_the_key_of_the_studio_is_on_the_cameras_left(self) -> None:
        renderer = kit()
        for angle in (0, 70):
            renderer.GetActiveCamera().Azimuth(angle)
            indirect = vtkindirect.enable(renderer, environment="studio")
            back = -np.array(renderer.GetActiveCamera().GetDirectionOfProjection())
            back[2] = 0
            back /= np.linalg.norm(back)
            left = np.cross(back, [0, 0, 1])  # of a camera that looks along -back
            key = self.seen(indirect, back + left + [0, 0, 1.4])
            fill = self.seen(indirect, -left + 0.3 * back + [0, 0, 0.45])
            wall = self.seen(indirect, -back - [0, 0, 0.2])
            self.assertAlmostEqual(fill / key, 0.35, places=5)
            self.assertAlmostEqual(wall / key, 0.04, places=5)

    def test_a_sun_comes_and_goes(self) -> None:
        renderer = kit()
        before = state(renderer)
        indirect = vtkindirect.enable(renderer, sun=(135, 40))
        self.assertEqual(len(lights(renderer)), 6)
        sun = lights(renderer)[5]
        self.assertFalse(sun.GetPositional() or not sun.LightTypeIsSceneLight())
        self.assertEqual(indirect.GetLightAngle(sun), 0.27)
        share = 1 - skies.sky_share("overcast", Sun(135, 40))
        self.assertAlmostEqual(sun.GetIntensity(), 0.9 * share, places=9)
        self.assertEqual([light.GetSwitch() for light in lights(renderer)], [0, 0, 0, 0, 0, 1])
        self.assertIsNotNone(indirect.GetEnvironment())
        vtkindirect.enable(renderer, sun=np.array([-90.0, 20.0]))
        self.assertEqual(lights(renderer)[5:], [sun])
        self.assertAlmostEqual(sun.GetFocalPoint()[0], math.cos(math.radians(20)))
        vtkindirect.enable(renderer, "gather")
        self.assertEqual(lights(renderer)[5:], [sun])
        vtkindirect.enable(renderer, sun=None)
        self.assertEqual(len(lights(renderer)), 5)
        self.assertIsNone(indirect.GetEnvironment())
        self.assertEqual([light.GetSwitch() for light in lights(renderer)], [1] * 5)
        vtkindirect.enable(renderer, sun=(0, 90), environment="clear")
        vtkindirect.enable(renderer, sun=None)
        self.assertAlmostEqual(self.seen(indirect, (0, 0, -1)), 0.18, places=5)
        self.assertEqual([light.GetSwitch() for light in lights(renderer)], [0] * 5)
        vtkindirect.enable(renderer, sun=(0, 90))
        vtkindirect.disable(renderer)
        self.assertEqual(state(renderer), before)

    def test_an_environment_of_ones_own_stays_beside_a_sun(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, environment=(1, 2, 3))
        light = indirect.GetEnvironment()
        vtkindirect.enable(renderer, sun=(0, 45))
        self.assertIs(indirect.GetEnvironment(), light)
        vtkindirect.enable(renderer, sun=None)
        self.assertIs(indirect.GetEnvironment(), light)
        vtkindirect.enable(renderer, sun=(0, 45), environment=None)
        self.assertIsNone(indirect.GetEnvironment())
        scene = load_scene(support.SCENES / "sky_plane.json")
        indirect = vtkindirect.enable(scene, sun=(0, 45))
        self.assertIs(indirect.GetEnvironment(), scene.environment)

    def test_lights_that_follow_the_camera(self) -> None:
        """They are off beside an environment of a call, unless the lighting is the scene's."""
        for words, on in (
            ({"environment": "overcast"}, False),
            ({"environment": (1, 1, 1)}, False),
            ({"environment": "studio", "lighting": "scene"}, True),
            ({"sun": (0, 45), "lighting": "scene"}, True),
            ({"environment": "studio", "lighting": "soft"}, True),
            ({"environment": None}, True),
        ):
            with self.subTest(words=words):
                renderer = kit()
                vtkindirect.enable(renderer, **words)
                kits = lights(renderer)[:5]
                self.assertEqual([light.GetSwitch() for light in kits], [on] * 5)
                self.assertEqual(bool(renderer.GetAutomaticLightCreation()), on)
                vtkindirect.enable(renderer, lighting="scene")
                self.assertEqual([light.GetSwitch() for light in kits], [1] * 5)
        placed = vtkLight()
        off = vtkLight()
        off.SetLightTypeToHeadlight()
        off.SwitchOff()
        renderer = kit()
        renderer.AddLight(placed)
        renderer.AddLight(off)
        vtkindirect.enable(renderer, sun=(0, 45))
        self.assertTrue(placed.GetSwitch())
        vtkindirect.disable(renderer)
        self.assertFalse(off.GetSwitch())

    def test_mistakes(self) -> None:
        renderer = kit()
        names = "known: uniform, overcast, clear, studio"
        for started in (False, True):
            if started:
                vtkindirect.enable(renderer, sun=(30, 30), environment="clear")
            before = state(renderer)
            for words, expected in (
                (
                    {"environment": "studoi"},
                    "studoi: no such file, and no name of an environment "
                    f"(did you mean 'studio'?); {names}",
                ),
                (
                    {"environment": "sky.exr"},
                    f"sky.exr: no such file, and no name of an environment; {names}",
                ),
                ({"sun": 45}, "sun must be two finite numbers"),
                ({"sun": (1, 2, 3)}, "sun must be two finite numbers"),
                ({"sun": "12"}, "sun must be two finite numbers"),
                ({"sun": (0, float("nan"))}, "sun must be two finite numbers"),
                ({"sun": (0, -1)}, "the elevation must be from 0 to 90 degrees, not -1"),
                ({"sun": (0, 91)}, "the elevation must be from 0 to 90 degrees, not 91"),
                ({"sun": (0, 45), "up": "w"}, "unknown up 'w'; known: x, -x, y, -y, z, -z"),
                ({"sun": (0, 45), "up": 3}, "up must be text, not 3"),
                ({"environment": None, "sun": None, "up": "z"}, "up is for a sun or named"),
                ({"sun": (0, 45), "lighting": "full"}, "the lighting must be auto or scene"),
                ({"sun": (0, 45), "Lighting": "soft"}, "the lighting must be auto or scene"),
                ({"sun": (0, 45), "number_of_lihgts": 3}, "unknown property"),
                ({"environment": "studio", "number_of_lihgts": 3}, "unknown property"),
            ):
                with self.subTest(words=words), self.assertRaises(UsageError) as caught:
                    vtkindirect.enable(renderer, **words)
                self.assertIn(expected, str(caught.exception))
                self.assertEqual(len(str(caught.exception).splitlines()), 1)
                self.assertEqual(state(renderer), before)
        with self.assertRaisesRegex(UsageError, "the lighting must be auto or scene"):
            vtkindirect.enable(renderer, lighting="full")
        for words in ({"sun": None}, {"up": "z"}):
            (name,) = words
            with self.assertRaisesRegex(UsageError, f"method 'off' has no property '{name}'"):
                vtkindirect.enable(renderer, "off", **words)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Frames(support.DirectoryTest):
    def window(self, renderer: vtkRenderer) -> Any:
        window = windows.render_window((64, 64), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        return window

    def plane(self) -> vtkRenderer:
        """Return a renderer that looks down at a white plane in the light kit, with y up ahead."""
        source = vtkPlaneSource()
        actor = make_actor(source)
        actor.GetProperty().SetColor(1, 1, 1)
        renderer = kit()
        renderer.AddActor(actor)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 1)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 1, 0)
        renderer.ResetCameraClippingRange()
        return renderer

    def test_a_floor_gets_what_is_stated(self) -> None:
        """Irradiance of a horizontal plane: 0.9 of any sky, and of a sun by its elevation."""
        for words in (
            *({"environment": name} for name in skies.NAMES),
            {"sun": (135, 40)},
            {"sun": (135, 40), "environment": "clear"},
        ):
            with self.subTest(words=words):
                renderer = self.plane()
                vtkindirect.enable(renderer, up="z", **words)
                self.window(renderer).Render()
                light = images.copy_buffer(renderer, "final")[32, 32, 0]
                expected = 0.9
                if "sun" in words:
                    sun, name = Sun(*words["sun"]), words.get("environment", "overcast")
                    direct = skies.sun_irradiance(name, sun)
                    expected = 0.9 * skies.sky_share(name, sun)
                    expected += direct * math.sin(math.radians(40))
                # 256 directions stand for the sky, and a studio's boxes are smaller than that.
                self.assertAlmostEqual(light, expected, delta=0.02 * expected)

    def test_a_headlight_that_vtk_would_make(self) -> None:
        renderer = self.plane()
        renderer.RemoveAllLights()
        vtkindirect.enable(renderer, environment="uniform", up="z")
        self.window(renderer).Render()
        self.assertEqual(lights(renderer), [])
        light = images.copy_buffer(renderer, "direct")
        self.assertEqual(float(light.max()), 0.0)
        vtkindirect.disable(renderer)
        renderer.GetRenderWindow().Render()
        self.assertEqual(len(lights(renderer)), 1)

    def test_up_follows_the_camera_until_the_first_frame(self) -> None:
        renderer = self.plane()
        indirect = vtkindirect.enable(renderer, sun=(0, 30))
        window = self.window(renderer)
        renderer.GetActiveCamera().SetPosition(0, -1, 1)
        renderer.GetActiveCamera().SetViewUp(0, 0, 1)
        window.Render()
        self.assertEqual(indirect.GetEnvironment().GetUp(), (0, 0, 1))
        sun = lights(renderer)[-1]
        np.testing.assert_allclose(
            sun.GetFocalPoint(), (0, -math.cos(math.pi / 6), -0.5), atol=1e-12
        )
        environment = indirect.GetEnvironment()
        renderer.GetActiveCamera().SetPosition(0, 1, 1)
        renderer.GetActiveCamera().SetViewUp(0, 1, 0)
        window.Render()
        self.assertIs(indirect.GetEnvironment(), environment)
        report = vtkindirect.report(renderer)
        self.assertIn(
            {"what": "environment overcast", "why": "it comes with the sun"}, report["modelled"]
        )
        self.assertIn(
            {"what": "sun", "why": "it is set: azimuth 0, elevation 30 degrees"}, report["modelled"]
        )
        whats = [entry["what"] for entry in report["left_out"]]
        self.assertIn("5 lights that follow the camera", whats)

    def test_a_light_that_comes_later_and_a_sun_that_somebody_removed(self) -> None:
        renderer = self.plane()
        vtkindirect.enable(renderer, sun=(0, 30))
        window = self.window(renderer)
        window.Render()
        renderer.RemoveAllLights()
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        renderer.AddLight(light)
        window.Render()
        self.assertFalse(light.GetSwitch())
        self.assertEqual(len(lights(renderer)), 2)
        vtkindirect.disable(renderer)
        self.assertTrue(light.GetSwitch())
        self.assertEqual(lights(renderer), [light])

    @unittest.skipIf(WHY_NO_PYVISTA, WHY_NO_PYVISTA or "")
    def test_pyvista(self) -> None:
        """The plotter places its camera when it is shown, with z up; its lights stay its own."""
        if not windows.has_display():
            vtkindirect.use_headless()
        import pyvista

        plotter = pyvista.Plotter(off_screen=True, window_size=(64, 64))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Sphere())
        indirect = vtkindirect.enable(plotter, sun=(90, 45))
        plotter.show(auto_close=False)
        self.assertEqual(indirect.GetEnvironment().GetUp(), (0, 0, 1))
        self.assertEqual([light.on for light in plotter.renderer.lights], [False] * 5 + [True])
        vtkindirect.disable(plotter)
        self.assertEqual([light.on for light in plotter.renderer.lights], [True] * 5)

    def test_command_line(self) -> None:
        document = support.small_scene()
        document["lights"] = [{"type": "light_kit"}]
        path = self.write("kit.json", document)
        report = self.directory / "report.json"
        for words, expected in (
            (("--environment", "studio"), ["environment studio"]),
            (("--sun", "135,40"), ["environment overcast", "sun"]),
            (("--sun", "135,40", "--environment", "clear", "--up", "z"), ["environment clear"]),
            (("--environment", "0.5,0.5,0.5"), []),
            (("--environment", "none"), []),
        ):
            with self.subTest(words=words):
                result = support.command_line_here("render", path, *words, "--report", report)
                self.assertEqual(result.returncode, 0, result.stderr)
                whats = [entry["what"] for entry in json.loads(report.read_text())["modelled"]]
                ours = [what for what in whats if what == "sun" or what.startswith("environment ")]
                for what in expected:
                    self.assertIn(what, ours)
                none = words[-1] == "none"
                self.assertEqual("lighting auto: studio" in whats, none)
        for words, expected in (
            (("--environment", "studoi"), "no name of an environment (did you mean 'studio'?)"),
            (("--sun", "135"), "--sun 135: must be AZIMUTH,ELEVATION in degrees, such as 135,40"),
            (("--sun", "1,95"), "the elevation must be from 0 to 90 degrees, not 95"),
            (("--sun", "1,5", "--up", "q"), "unknown up 'q'"),
            (("--up", "z"), "up is for a sun or named surroundings"),
            (("--sun", "1,5", "--method", "off"), "method 'off' has no property 'sun'"),
        ):
            with self.subTest(words=words):
                result = support.command_line_here("render", path, *words, "--report", report)
                self.assertEqual(result.returncode, 2)
                self.assertIn(expected, result.stderr)


@unittest.skipIf(WHY_NOT, WHY_NOT)
class StudioShadows(unittest.TestCase):
    """Cylinders on a white floor below the studio's soft boxes."""

    def test_soft_boxes_cast_soft_shadows(self) -> None:
        """No shadow of a box's part has an edge by itself."""
        renderer = vtkRenderer()
        for i in range(5):
            pillar = vtkCylinderSource()
            pillar.SetCenter(1.2 * i - 2.4, 0.6, 0)
            pillar.SetRadius(0.25)
            pillar.SetHeight(1.2)
            pillar.SetResolution(48)
            renderer.AddActor(make_actor(pillar, (1, 0, 0)))
        floor = vtkPlaneSource()
        floor.SetOrigin(-4.5, 0, 3)
        floor.SetPoint1(4.5, 0, 3)
        floor.SetPoint2(-4.5, 0, -3)
        renderer.AddActor(make_actor(floor, (1, 1, 1)))
        renderer.GetActiveCamera().SetPosition(3, 8, 8)
        window = windows.render_window((384, 288), offscreen=True)
        window.AddRenderer(renderer)
        renderer.ResetCamera()
        vtkindirect.enable(renderer, environment="studio")
        window.Render()
        # 0.0014; with one direction for each part of a box 0.0083.
        self.assertLess(floor_roughness(renderer, 1), 0.004)


@unittest.skipIf(WHY_NOT, WHY_NOT)
class CloseUps(unittest.TestCase):
    """A camera among small things, where parts of the sky are wide in pixels."""

    def setUp(self) -> None:
        self.renderer = vtkRenderer()
        balls = vtkAppendPolyData()
        for center in np.random.default_rng(0).normal(size=(400, 3)):
            ball = vtkSphereSource()
            ball.SetRadius(0.12)
            ball.SetCenter(center)
            ball.SetThetaResolution(24)
            ball.SetPhiResolution(24)
            balls.AddInputConnection(ball.GetOutputPort())
        self.renderer.AddActor(make_actor(balls))
        floor = vtkPlaneSource()
        floor.SetOrigin(-4, -4, -2.5)
        floor.SetPoint1(4, -4, -2.5)
        floor.SetPoint2(-4, 4, -2.5)
        self.renderer.AddActor(make_actor(floor, (1, 1, 1)))
        self.renderer.GetActiveCamera().SetPosition(0, 0, 1)
        self.window = windows.render_window((384, 384), offscreen=True)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCameraClippingRange()

    def test_no_weave(self) -> None:
        """An edge of a shadow does not come back beside each neighbour of the smoothing."""
        vtkindirect.enable(self.renderer, lighting="scene", environment=(1, 1, 1))
        self.window.Render()
        still = floor_roughness(self.renderer, 4)
        self.window.SetDesiredUpdateRate(15)
        self.renderer.GetActiveCamera().Azimuth(0.1)
        self.window.Render()
        moving = floor_roughness(self.renderer, 4)
        # 0.0045 and 0.010; without the smoothing between the neighbours 0.015 and 0.041.
        self.assertLess(still, 0.007)
        self.assertLess(moving, 0.02)
