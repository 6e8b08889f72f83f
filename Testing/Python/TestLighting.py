# SPDX-License-Identifier: BSD-3-Clause
"""Presets of lights: which one "auto" takes, what is said of it, and how readable pictures are."""

import json
import sys
import unittest
from typing import Any

import numpy as np
from vtkmodules.vtkFiltersSources import vtkOutlineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

import support
import vtkindirect
from rooms import make_actor, make_ball, make_room
from vtkindirect import UsageError, frames, images, lighting, lights, load_scene, windows, wrapped
from vtkindirect.frames import Job

sys.path.insert(0, str(support.TESTING / "Benchmark"))
import readability  # noqa: E402

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = WHY_NOT or support.why_no_pyvista()


def headlight(**properties: Any) -> vtkLight:
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    for name, value in properties.items():
        getattr(light, f"Set{name}")(value)
    return light


def camera_light() -> vtkLight:
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(0.5, 0.5, 1.0)
    light.SetIntensity(0.6)
    return light


def lit_by(*found: vtkLight, automatic: bool = True) -> vtkRenderer:
    renderer = vtkRenderer()
    renderer.SetAutomaticLightCreation(automatic)
    for light in found:
        renderer.AddLight(light)
    return renderer


def lit_by_kit(switched_off: int = 0) -> vtkRenderer:
    renderer = vtkRenderer()
    lights.add_light_kit(renderer, 0.6)
    for _ in range(switched_off):
        off = vtkLight()
        off.SwitchOff()
        renderer.AddLight(off)
    return renderer


class Choice(unittest.TestCase):
    """Choices of "auto"."""

    def check(self, renderer: vtkRenderer, preset: str, why: str, environment: Any = None) -> None:
        chosen = lighting.choose(renderer, environment)
        self.assertEqual(chosen[0], preset, chosen)
        self.assertIn(why, chosen[1])

    def test_nobody_has_placed_lights(self) -> None:
        self.check(lit_by(), "studio", "the headlight that VTK gives it")
        self.check(lit_by(headlight(Switch=False)), "studio", "the headlight that VTK gives it")
        follow = "follow its camera"
        self.check(lit_by(headlight()), "studio", follow)
        self.check(lit_by(headlight(), automatic=False), "studio", follow)
        self.check(lit_by(headlight(Intensity=0.5)), "studio", follow)
        self.check(lit_by(headlight(DiffuseColor=(1, 0.5, 0.5))), "studio", follow)
        self.check(lit_by(headlight(), headlight()), "studio", follow)
        self.check(lit_by_kit(), "studio", follow)
        self.check(lit_by_kit(switched_off=2), "studio", follow)
        fewer = lit_by_kit()
        fewer.RemoveLight(fewer.GetLights().GetItemAsObject(4))
        self.check(fewer, "studio", follow)
        more = lit_by_kit()
        more.AddLight(headlight())
        self.check(more, "studio", follow)
        self.check(lit_by(*(camera_light() for _ in range(3))), "studio", follow)

    def test_somebody_has(self) -> None:
        placed = "somebody has placed"
        self.check(lit_by(headlight(Positional=True)), "scene", placed)
        self.check(lit_by(vtkLight()), "scene", placed)
        self.check(lit_by(headlight(), vtkLight()), "scene", placed)
        self.check(lit_by(headlight(Intensity=0.0)), "scene", "adds no light")
        self.check(lit_by(headlight(), headlight(Intensity=-0.5)), "scene", "adds no light")
        self.check(lit_by(automatic=False), "scene", "is to have none")
        more = lit_by_kit()
        more.AddLight(vtkLight())
        self.check(more, "scene", placed)

    def test_environment(self) -> None:
        self.check(lit_by(), "scene", "an environment is set", environment=object())


@unittest.skipUnless(
    wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
)
class Enable(unittest.TestCase):
    def test_auto(self) -> None:
        for renderer, preset in ((lit_by(), "Studio"), (lit_by(vtkLight()), "Scene")):
            indirect = vtkindirect.enable(renderer)
            self.assertEqual(indirect.GetLighting(), getattr(indirect, preset.upper()))
        indirect = vtkindirect.enable(vtkRenderer(), environment=(1, 1, 1))
        self.assertEqual(indirect.GetLighting(), indirect.SCENE)

    def test_names(self) -> None:
        renderer = vtkRenderer()
        for name in lighting.PRESETS:
            indirect = vtkindirect.enable(renderer, lighting=name)
            self.assertEqual(indirect.GetLighting(), getattr(indirect, name.upper()))
        # Settings that a call does not mention stay.
        vtkindirect.enable(renderer, "gather")
        self.assertEqual(indirect.GetLighting(), indirect.STUDIO)
        vtkindirect.enable(renderer, lighting="auto")
        self.assertEqual(indirect.GetLighting(), indirect.STUDIO)
        # By the property's own name, too.
        vtkindirect.enable(renderer, Lighting="soft")
        self.assertEqual(indirect.GetLighting(), indirect.SOFT)
        vtkindirect.enable(renderer)
        self.assertEqual(indirect.GetLighting(), indirect.SOFT)

    def test_a_pass_that_is_there_keeps_its_own(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.vtkIndirectIlluminationPass()
        indirect.SetLightingToGentle()
        renderer.SetPass(indirect)
        self.assertIs(vtkindirect.enable(renderer), indirect)
        self.assertEqual(indirect.GetLighting(), indirect.GENTLE)

    def test_mistakes(self) -> None:
        renderer = vtkRenderer()
        for settings, expected in (
            ({"lighting": "sof"}, "unknown lighting 'sof' (did you mean 'soft'?)"),
            ({"lighting": 2}, "lighting must be text, not 2"),
            ({"lighting": None}, "lighting must be text, not None"),
            ({"lighting": "soft", "Lighting": "full"}, "lighting is given twice"),
            ({"Lighting": "auto"}, "unknown value 'auto'"),
        ):
            with self.subTest(settings=settings), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(renderer, **settings)
            self.assertIn(expected, str(caught.exception))
            self.assertIsNone(renderer.GetPass())
        with self.assertRaisesRegex(UsageError, "method 'off' has no property 'lighting'"):
            vtkindirect.enable(renderer, "off", lighting="auto")


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Follows(support.DirectoryTest):
    """In frames."""

    def scene(self, *lights_of_scene: dict[str, Any]) -> Any:
        document = support.small_scene()
        document["lights"] = list(lights_of_scene)
        scene = load_scene(self.write("small.json", document))
        window = frames.open_window(scene, (48, 36))
        self.addCleanup(window.Finalize)
        return scene

    def test_lights_that_come_later(self) -> None:
        scene = self.scene({"type": "light_kit"})
        vtkindirect.enable(scene.renderer)
        scene.render_window.Render()
        report = vtkindirect.report(scene.renderer)
        self.assertEqual(report["lighting"]["used"], "studio")
        why = report["lighting"]["why"]
        self.assertEqual(why, "auto: all lights of the renderer follow its camera")
        whats = [entry["what"] for entry in report["modelled"]]
        self.assertIn("lighting auto: studio", whats)
        self.assertIn("lighting studio", whats)
        light = vtkLight()
        light.SetPosition(1, 2, 3)
        scene.renderer.AddLight(light)
        scene.render_window.Render()
        report = vtkindirect.report(scene.renderer)
        self.assertEqual(report["lighting"]["used"], "scene")
        self.assertNotIn("lighting studio", [entry["what"] for entry in report["modelled"]])
        scene.renderer.RemoveLight(light)
        scene.render_window.Render()
        self.assertEqual(vtkindirect.report(scene.renderer)["lighting"]["used"], "studio")
        # Values that are set by hand stay.
        indirect = vtkindirect.pass_of(scene.renderer)
        indirect.SetLightingToSoft()
        scene.render_window.Render()
        self.assertEqual(indirect.GetLighting(), indirect.SOFT)
        self.assertEqual(
            vtkindirect.report(scene.renderer)["lighting"], {"used": "soft", "why": "it is set"}
        )

    def test_placed_lights(self) -> None:
        spot = support.small_scene()["lights"][0]
        scene = self.scene(spot)
        report = frames.render(scene, scene.render_window, Job())
        self.assertEqual(report["lighting"]["used"], "scene")
        self.assertEqual(report["settings"]["Lighting"], "scene")
        report = frames.render(scene, scene.render_window, Job(lighting="studio"))
        self.assertEqual(report["settings"]["Lighting"], "studio")

    def turned(self, preset: str, angles: tuple[int, ...], **values: Any) -> list[Any]:
        """Return the irradiance and the counters of a room in views one after the other."""
        renderer = make_room(make_actor(make_ball()), lit=False)
        lights.add_light_kit(renderer, 0.6)
        vtkindirect.enable(renderer, lighting=preset, **values)
        window = windows.render_window((160, 120), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        window.SetDesiredUpdateRate(1e-4)
        views = []
        for angle in angles:
            renderer.GetActiveCamera().Azimuth(angle)
            window.Render()
            counters = vtkindirect.report(renderer)["counters"]
            views.append((images.copy_buffer(renderer, "irradiance"), counters))
        return views

    def test_turning(self) -> None:
        """A turn draws the maps of shadows alone, and the picture does not depend on it."""
        # Bounds of the error of the bounces alone: measured 0.21 and 0.083, of which the walk's
        # noise is a part. Three directions, up to 40 degrees away, stand for a sharp light.
        for preset, maps, most in (("scene", 5, 0.25), ("full", 1, 0.1), ("studio", 0, 0.1)):
            with self.subTest(preset=preset):
                (_, before), (turned, after) = self.turned(preset, (0, 40))
                for name in ("tiles_drawn", "walks", "sky_tiles_drawn"):
                    self.assertEqual(after[name], before[name], name)
                self.assertEqual(after["faces_drawn"], before["faces_drawn"] + maps)
                ((fresh, _),) = self.turned(preset, (40,))
                np.testing.assert_array_equal(turned, fresh)
                ((walked, _),) = self.turned(
                    preset, (40,), sampler="random_walk", number_of_lights=8192, NumberOfBounces=16
                )
                mean = float(walked.mean())
                self.assertAlmostEqual(float(turned.mean()), mean, delta=0.05 * mean)
                error = float(np.sqrt(np.square(turned - walked).mean()))
                self.assertLess(error, most * mean)

    def test_tiles(self) -> None:
        """A picture in tiles has one balance: that of the whole picture before it."""
        renderer = make_room(make_actor(make_ball()), lit=False)
        lights.add_light_kit(renderer, 0.6)
        window = windows.render_window((120, 90), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        vtkindirect.enable(renderer, lighting="studio")
        window.Render()

        def balance() -> str:
            entries = vtkindirect.report(renderer)["modelled"]
            (why,) = (entry["why"] for entry in entries if entry["what"].startswith("balance of"))
            return why

        whole = balance()
        tiled = vtkWindowToImageFilter()
        tiled.SetInput(window)
        tiled.SetScale(3)
        tiled.Update()
        self.assertEqual(balance(), whole)
        renderer.GetActiveCamera().Azimuth(90)
        window.Render()
        self.assertNotEqual(balance(), whole)

    def test_command_line(self) -> None:
        document = support.small_scene()
        document["lights"] = [{"type": "light_kit"}]
        path = self.write("kit.json", document)
        report = self.directory / "report.json"
        for words, used in (
            ((), "studio"),
            (("--lighting", "soft"), "soft"),
            (("--set", "Lighting=gentle"), "gentle"),
            (("--set", "lighting=auto"), "studio"),
        ):
            with self.subTest(words=words):
                result = support.command_line_here("render", path, *words, "--report", report)
                self.assertEqual(result.returncode, 0, result.stderr)
                found = json.loads(report.read_text())
                self.assertEqual(found["lighting"]["used"], used)
                self.assertEqual(found["settings"]["Lighting"], used)
        for words, expected in (
            (("--lighting", "sof"), "unknown lighting 'sof' (did you mean 'soft'?)"),
            (("--lighting", "soft", "--set", "Lighting=full"), "lighting is given twice"),
            (("--lighting", "soft", "--method", "off"), "method 'off' has no property 'lighting'"),
        ):
            with self.subTest(words=words):
                result = support.command_line_here("render", path, *words)
                self.assertEqual(result.returncode, 2)
                self.assertIn(expected, result.stderr)


@unittest.skipIf(WHY_NO_PYVISTA, WHY_NO_PYVISTA or "")
class PyVista(unittest.TestCase):
    def test_auto(self) -> None:
        import pyvista

        if not vtkindirect.has_display():
            vtkindirect.use_headless()
        for kind, preset in (("light kit", "STUDIO"), ("three lights", "STUDIO"), ("none", "SCENE")):
            with self.subTest(kind=kind):
                plotter = pyvista.Plotter(off_screen=True, window_size=(32, 32), lighting=kind)
                self.addCleanup(plotter.close)
                plotter.add_mesh(pyvista.Sphere())
                indirect = vtkindirect.enable(plotter)
                plotter.render()
                self.assertEqual(indirect.GetLighting(), getattr(indirect, preset))

    def test_its_light_kit_is_that_of_vtk(self) -> None:
        import pyvista

        own = pyvista.Plotter(off_screen=True, lighting="light kit")
        self.addCleanup(own.close)
        kit = vtkRenderer()
        lights.add_light_kit(kit)
        for theirs, ours in zip(own.renderer.lights, kit.GetLights(), strict=True):
            self.assertEqual(theirs.GetLightType(), ours.GetLightType())
            for name in ("Intensity", "Position", "FocalPoint", "DiffuseColor"):
                found, expected = getattr(theirs, f"Get{name}")(), getattr(ours, f"Get{name}")()
                np.testing.assert_allclose(found, expected, atol=1 / 255, err_msg=name)


def white(*sources: Any) -> vtkRenderer:
    """Return a renderer with what these make, white, before black."""
    renderer = vtkRenderer()
    for source in sources:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    return renderer


def sheet(origin: Any, point1: Any, point2: Any) -> vtkPlaneSource:
    source = vtkPlaneSource()
    source.SetOrigin(origin)
    source.SetPoint1(point1)
    source.SetPoint2(point2)
    return source


def open_box(height: float) -> list[vtkPlaneSource]:
    """Return a floor of 2 x 2 with walls around it."""
    return [
        sheet((-1, -1, 0), (1, -1, 0), (-1, 1, 0)),
        sheet((-1, -1, 0), (-1, 1, 0), (-1, -1, height)),
        sheet((1, -1, 0), (1, -1, height), (1, 1, 0)),
        sheet((-1, -1, 0), (-1, -1, height), (1, -1, 0)),
        sheet((-1, 1, 0), (1, 1, 0), (-1, 1, height)),
    ]


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class White(unittest.TestCase):
    """White things that light one another do not burn out, and others stay as bright."""

    def see(self, renderer: vtkRenderer, camera: Any, preset: str | None) -> np.ndarray:
        window = windows.render_window((80, 60), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        if preset is not None:
            vtkindirect.enable(renderer, lighting=preset, antialiasing=False)
        view = renderer.GetActiveCamera()
        view.SetPosition(camera)
        view.SetFocalPoint(0, 0, 0.3)
        renderer.ResetCameraClippingRange()
        for _ in range(4):  # maps that are left for later frames
            window.Render()
        return images.window_bytes(window)

    def test_corners(self) -> None:
        """Samples of several surfaces lie before all of them: behind a wall they would be dark."""
        found = []
        for method in ("multiresolution", "gather"):
            renderer = white(*open_box(0.8))
            lights.add_light_kit(renderer)
            vtkindirect.enable(renderer, method, lighting="full")
            window = windows.render_window((320, 240), offscreen=True)
            self.addCleanup(window.Finalize)
            window.AddRenderer(renderer)
            view = renderer.GetActiveCamera()
            view.SetPosition(0, -1.6, 4)
            view.SetFocalPoint(0, 0, 0.3)
            renderer.ResetCameraClippingRange()
            window.Render()
            found.append(images.copy_buffer(renderer, "bounce").mean(axis=-1))
        blocks, pixels = found
        # Not beside the background, where a sample of few pixels lies beyond the surface.
        lit = np.pad(pixels > 0.2 * pixels.max(), 4)
        moves = [lit[y : y + 240, x : x + 320] for y in range(9) for x in range(9)]
        seen = np.logical_and.reduce(moves)
        self.assertGreater(int(seen.sum()), 10000)
        dark = int((seen & (blocks < 0.75 * pixels)).sum())
        print(f"{dark} of {int(seen.sum())} pixels are darker than three quarters")
        self.assertLessEqual(dark, 2)

    def test_white(self) -> None:
        ball = vtkSphereSource()
        ball.SetThetaResolution(40)
        ball.SetPhiResolution(40)
        shapes = (
            ("tray", lambda: white(*open_box(0.8)), (0, -1.6, 4)),
            ("room", lambda: white(*open_box(2.0)), (0.3, -0.3, 5.5)),
            ("ball", lambda: white(ball), (0, 0, 3)),
        )
        for name, make, camera in shapes:
            for kit in (False, True):
                for preset in ("full", "soft", "studio"):
                    with self.subTest(name=name, kit=kit, preset=preset):
                        seen = []
                        for lighting_name in (None, preset):
                            renderer = make()
                            if kit:
                                lights.add_light_kit(renderer)
                            seen.append(self.see(renderer, camera, lighting_name))
                        plain, ours = (each[..., :3].astype(float) for each in seen)
                        drawn = plain.max(-1) > 0
                        ratio = ours[drawn].mean() / plain[drawn].mean()
                        clipped = ((ours.max(-1) == 255) & (plain.max(-1) < 255)).sum()
                        print(f"{name}, kit {kit}, {preset}: {ratio:.3f} of VTK's brightness, "
                              f"{clipped} pixels clipped")  # fmt: skip
                        self.assertEqual(clipped, 0)
                        # The 10 % of Documentation/guide.md.
                        self.assertGreater(ratio, 0.9)
                        self.assertLess(ratio, 1.1)

    def test_unlit(self) -> None:
        """Unlit surfaces and lines stay as VTK draws them beside a lit ball."""

        def make() -> vtkRenderer:
            renderer = vtkRenderer()
            box = vtkOutlineSource()
            box.SetBounds(-0.4, 0.4, 0.1, 0.9, -0.4, 0.4)
            for x, source in ((-1.7, make_ball(0.5)), (0.0, make_ball(0.5)), (1.7, box)):
                actor = make_actor(source, (0.9, 0.5, 0.2))
                actor.SetPosition(x, -0.5, 0.3)
                actor.GetProperty().SetLighting(x >= 0)
                renderer.AddActor(actor)
            return renderer

        for kit in (False, True):
            for preset in ("full", "soft", "gentle", "studio"):
                with self.subTest(kit=kit, preset=preset):
                    seen = []
                    for lighting_name in (None, preset):
                        renderer = make()
                        if kit:
                            lights.add_light_kit(renderer)
                        seen.append(self.see(renderer, (0, 0, 8), lighting_name))
                    plain, ours = seen
                    changed = (plain != ours).any(axis=-1)
                    beside = np.ones(80, bool)
                    beside[28:52] = False
                    self.assertGreater(int(plain[:, :28, :3].any(axis=-1).sum()), 100)
                    self.assertGreater(int(plain[:, 52:, :3].any(axis=-1).sum()), 30)
                    self.assertGreater(int(changed[:, ~beside].sum()), 100)
                    self.assertEqual(int(changed[:, beside].sum()), 0)

    def test_pbr_beside_phong(self) -> None:
        """VTK's PBR divides lamps' light by pi: the light in place of the lamps is divided, too."""

        def make() -> vtkRenderer:
            renderer = vtkRenderer()
            for x in (-0.8, 0.8):
                actor = make_actor(make_ball(0.5), (0.9, 0.9, 0.9))
                actor.SetPosition(x, -0.5, 0.3)
                if x < 0:
                    actor.GetProperty().SetInterpolationToPBR()
                    actor.GetProperty().SetMetallic(0)
                    actor.GetProperty().SetRoughness(1)
                renderer.AddActor(actor)
            return renderer

        # The 10 % of Documentation/guide.md. `full` replaces no lamps and adds its sky, which
        # brightens rims: measured 1.20.
        for preset, most in (("full", 0.25), ("soft", 0.1), ("studio", 0.1)):
            with self.subTest(preset=preset):
                plain = self.see(make(), (0, 0, 6), None)[..., :3].astype(float)
                ours = self.see(make(), (0, 0, 6), preset)[..., :3].astype(float)
                drawn = plain.max(-1) > 0
                for side in (slice(0, 40), slice(40, 80)):
                    there = drawn[:, side]
                    ratio = ours[:, side][there].mean() / plain[:, side][there].mean()
                    print(f"{preset}, {side}: {ratio:.3f} of VTK's brightness")
                    self.assertLess(abs(ratio - 1), most)


# Forty balls that touch, and a block with grooves: what hides the sky in molecules and machines. No
# strength of a preset was chosen for them.
BALLS = [
    [i % 4 + 0.5 * (i // 16 % 2), i // 4 % 4 + 0.5 * (i // 16 % 2), 0.75 * (i // 16)]
    for i in range(40)
]


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Readability(support.DirectoryTest):
    def check(
        self,
        actors: list[dict[str, Any]],
        camera: dict[str, Any],
        kind: str,
        lighter: dict[str, float] | None = None,
    ) -> None:
        """As bright as VTK's to 10 %, no more of it nearly black, and its pits darker.

        `lighter`: presets whose pits later bounces make lighter than VTK's, and at most how much;
        with one bounce these are darker, too.
        """
        lighter = lighter or {}
        document = support.small_scene()
        document.update(actors=actors, camera=camera, lights=[{"type": "headlight"}])
        scene = load_scene(self.write("scene.json", document))
        window = frames.open_window(scene, (96, 72))
        self.addCleanup(window.Finalize)
        window.SetMultiSamples(0)
        readability.set_lights(scene.renderer, kind)
        seen = readability.see(scene)
        plain = seen["VTK"]
        # Not an object for which any light would do: of shadows or occlusion alone, which nothing
        # makes up for, one is too dark.
        self.assertGreater(plain.brightness, 40)
        others = (seen["UseSSAO"], seen["scene"])
        darkest = min(other.brightness for other in others) / plain.brightness
        blackest = max(other.black for other in others)
        self.assertTrue(darkest < 0.9 or blackest > plain.black, others)
        looks = set()
        for name in ("soft", "full", "gentle", "studio"):
            ratio = seen[name].brightness / plain.brightness
            print(f"{kind}, {name}: brightness {ratio:.3f} of VTK's, {seen[name].black:.4f} nearly "
                  f"black, of VTK's {plain.black:.4f}, pits {seen[name].pits:.3f}, of VTK's "
                  f"{plain.pits:.3f}")  # fmt: skip
            # The most of the objects in Documentation/guide.md.
            self.assertLess(abs(ratio - 1), 0.1, name)
            self.assertLessEqual(seen[name].black, plain.black, name)
            self.assertLess(seen[name].pits, lighter.get(name, 1.0) * plain.pits, name)
            looks.add(seen[name])
        self.assertEqual(len(looks | {plain}), 5, "presets look alike")
        mask = readability.object_mask(scene)
        openness = readability.find_openness(scene)
        for name in lighter:
            vtkindirect.enable(scene, lighting=name, number_of_bounces=1)
            window.Render()
            first = readability.measure(images.window_bytes(window), mask, openness)
            print(f"{kind}, {name}, one bounce: pits {first.pits:.3f}")
            self.assertLess(first.pits, plain.pits, name)

    def test_balls(self) -> None:
        actors = [
            {"source": "sphere", "center": place, "radius": 0.55, "resolution": 24,
             "color": [0.8, 0.3, 0.2]}
            for place in BALLS
        ]
        camera = {"position": [5, 5, 9], "focal_point": [1.6, 1.6, 0.6], "view_angle": 30}
        self.check(actors, camera, "headlight")

    def test_grooves(self) -> None:
        actors = [
            {"source": "box", "bounds": [-2, 2, -0.3, 0, -2, 2], "color": [0.6, 0.6, 0.6]},
            *(
                {"source": "box", "bounds": [x, x + 0.1, 0, 0.6, -1, 1], "color": [0.3, 0.4, 0.7]}
                for x in (-1, -0.6, -0.2, 0.2, 0.6)
            ),
        ]
        camera = {"position": [3, 4, 5], "focal_point": [0, 0, 0], "view_angle": 30}
        # Walls that face each other fill what lies between them bounce by bounce. With 1, 2, 3 and
        # all of them pits are 0.479, 0.512, 0.523 and 0.535 of the whole, with eight times as many
        # virtual lights 0.540 in the end; VTK's are 0.509.
        self.check(actors, camera, "light kit", lighter={"full": 1.07})
