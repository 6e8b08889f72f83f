# SPDX-License-Identifier: BSD-3-Clause
"""Light from rectangles in scene files and in `enable`."""

import json
import unittest
from typing import Any

import numpy as np

from vtkmodules.vtkCommonCore import (
    VTK_FLOAT,
    vtkFloatArray,
    vtkOutputWindow,
    vtkStringOutputWindow,
)
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import support
import vtkindirect
from vtkindirect import images, lighting, load_scene, wrapped
from vtkindirect.errors import SceneError

LAMP = {
    "type": "area",
    "origin": [-0.5, -0.5, 1],
    "point1": [-0.5, 0.5, 1],
    "point2": [0.5, -0.5, 1],
    "radiance": [4, 2, 1],
}


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "the module vtkRenderingIndirect was not built")
class Scenes(support.DirectoryTest):
    def load(self, *lamps: dict[str, Any]) -> Any:
        """Load a scene of a floor under these lights."""
        floor = {"source": "plane", "origin": [-2, -2, 0], "point1": [2, -2, 0], "point2": [-2, 2, 0]}
        values = {
            "schema": "vtkindirect.scene/1",
            "size": [64, 48],
            "camera": {"position": [0, -3, 4], "focal_point": [0, 0, 0], "view_up": [0, 0, 1]},
            "lights": lamps,
            "actors": [floor],
        }
        path = self.directory / "lamp.json"
        path.write_text(json.dumps(values), encoding="utf-8")
        return load_scene(path)

    def test_read(self) -> None:
        scene = self.load(LAMP, {**LAMP, "two_sided": True})
        first, second = scene.area_lights
        self.assertEqual(first.GetRadiance(), (4.0, 2.0, 1.0))
        self.assertEqual(first.GetPoint2(), (0.5, -0.5, 1.0))
        self.assertFalse(first.GetTwoSided())
        self.assertTrue(second.GetTwoSided())
        self.assertFalse(first.GetVisible())
        self.assertEqual(scene.lights, [])

    def test_as_virtual_lights(self) -> None:
        # Each method gives the same light; the report says which one was in force.
        closed = self.irradiance_of({**LAMP, "method": "closed_form"}, "auto")[0]
        # Bounds: disks for squares, and of subsplats the tolerance 0.02 of their interpolation.
        for method, settings, lights, error in (
            ("gather", {"InterpolationStep": 0}, 256, 0.002),
            ("splatting", {"IntensityThreshold": 0}, 256, 0.002),
            ("multiresolution", {}, 256, 0.02),
            ("multiresolution", {"preset": "paper"}, 64, 0.03),
        ):
            with self.subTest(method=method, settings=settings):
                paper = "preset" in settings
                lamp = LAMP if paper else {**LAMP, "method": "virtual_lights"}
                found, report = self.irradiance_of(lamp, method, **settings)
                self.assertEqual(report["virtual_lights"], lights)
                self.assertIn(
                    "area lights as virtual lights", [e["what"] for e in report["modelled"]]
                )
                self.assertNotIn(
                    "light of area lights", [e["what"] for e in report["modelled"]]
                )
                rms = np.sqrt(np.mean((found - closed) ** 2)) / closed.mean()
                self.assertLess(rms, error)
        # Spheres take no virtual lights; only a light that asks for them is worth a word.
        for method, preset in (("proxies", "robust"), ("proxies", "paper")):
            with self.subTest(method=method, preset=preset):
                asked = {**LAMP, "method": "virtual_lights"} if preset == "robust" else LAMP
                found, report = self.irradiance_of(asked, method, preset=preset)
                self.assertTrue(np.allclose(found, closed, rtol=0.02, atol=1e-4))
                left_out = [e["what"] for e in report["left_out"]]
                self.assertEqual("area lights as virtual lights" in left_out, preset == "robust")

    def irradiance_of(self, lamp: dict[str, Any], method: str, **settings: Any) -> Any:
        """Return the irradiance of the floor under a lamp, without walls, and the report."""
        scene = self.load(lamp)
        window = scene.make_window()
        vtkindirect.enable(scene, method, **settings)
        window.Render()
        found = images.copy_buffer(scene.renderer, "irradiance").astype(float)
        report = vtkindirect.report(scene.renderer)
        window.Finalize()
        return found, report

    def test_visible(self) -> None:
        # Seen from below, the side that it sends light to.
        eye = {"position": [0, -1.5, 0.1], "focal_point": [0, 0, 1], "view_up": [0, 0, 1]}
        scene = self.load({**LAMP, "radiance": [0.2, 0.4, 0.6], "visible": True})
        (lamp,) = scene.area_lights
        self.assertTrue(lamp.GetVisible())
        camera = scene.renderer.GetActiveCamera()
        camera.SetPosition(eye["position"])
        camera.SetFocalPoint(eye["focal_point"])
        window = scene.make_window()
        vtkindirect.enable(scene)
        window.Render()
        pixel = images.copy_buffer(scene.renderer, "final")[24, 32]
        self.assertTrue(np.allclose(pixel, (0.2, 0.4, 0.6)), pixel)
        lamp.VisibleOff()
        window.Render()
        pixel = images.copy_buffer(scene.renderer, "final")[24, 32]
        self.assertFalse(np.allclose(pixel, (0.2, 0.4, 0.6)), pixel)
        window.Finalize()

    @unittest.skipUnless(wrapped.has("vtkOpenEXRWriter"), "built without OpenEXR")
    def test_texture(self) -> None:
        values = np.zeros((4, 8, 3), dtype=np.float32)
        values[3, 0] = (1, 2, 4)  # upper left
        images.write_exr(self.directory / "glow.exr", values)
        (light,) = self.load({**LAMP, "texture": "glow.exr"}).area_lights
        mean = [0.0, 0.0, 0.0]
        light.GetMeanRadiance(mean)
        self.assertTrue(np.allclose(mean, np.array([4, 4, 4]) / 32.0))

    def test_texture_that_is_not_there(self) -> None:
        with self.assertRaisesRegex(SceneError, r"lights\[0\].texture: .*none.exr"):
            self.load({**LAMP, "texture": "none.exr"})

    def test_enable(self) -> None:
        scene = self.load(LAMP)
        window = scene.make_window()
        indirect = vtkindirect.enable(scene)
        self.assertEqual(indirect.GetNumberOfAreaLights(), 1)
        window.Render()
        found = vtkindirect.report(indirect)
        self.assertGreater(vtkindirect.images.copy_buffer(scene.renderer, "area").mean(), 0.0)
        self.assertIn("light of area lights", [entry["what"] for entry in found["modelled"]])
        self.assertEqual(
            lighting.choose(scene.renderer, None, 1), ("scene", "there are area lights")
        )
        # Set up anew it is not added twice.
        self.assertIs(vtkindirect.enable(scene, "gather"), indirect)
        self.assertEqual(indirect.GetNumberOfAreaLights(), 1)
        window.Finalize()

    def errors_of(self, action: Any, kind: str = "vtkAreaLight") -> list[str]:
        """Return the errors of a class that VTK prints meanwhile, a line each."""
        window = vtkStringOutputWindow()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(window)
        try:
            action()
        finally:
            vtkOutputWindow.SetInstance(before)
        return [line for line in window.GetOutput().splitlines() if f"{kind} (" in line]

    def test_short_images(self) -> None:
        # Five scalars for 64 x 64 points: more are not read, and the light is off.
        image = vtkImageData()
        image.SetDimensions(64, 64, 1)
        scalars = vtkFloatArray()
        scalars.SetNumberOfComponents(3)
        scalars.SetNumberOfTuples(5)
        scalars.Fill(1.0)
        image.GetPointData().SetScalars(scalars)
        for light in (wrapped.get("vtkAreaLight")(), wrapped.get("vtkEnvironmentLight")()):
            light.AddObserver("ErrorEvent", lambda *_: None)
            light.SetImage(image)
            found = [-1.0, -1.0, -1.0]
            if light.IsA("vtkAreaLight"):
                light.GetMeanRadiance(found)
            else:
                light.GetRadianceFrom((0.0, 1.0, 0.0), found)
            self.assertEqual(found, [0.0, 0.0, 0.0])

    def test_what_floats_do_not_hold(self) -> None:
        # One light cannot be computed with: an error names it, and the other shines as if alone.
        far = {**LAMP, "origin": [-1e20, -1e20, 1], "point1": [-1e20, 1e20, 1]}
        small = {**LAMP, "origin": [0, 0, 1], "point1": [0, 1e-20, 1], "point2": [1e-20, 0, 1]}
        scene = self.load(LAMP)
        window = scene.make_window()
        vtkindirect.enable(scene)
        window.Render()
        alone = images.copy_buffer(scene.renderer, "area").copy()
        window.Finalize()
        nan = {**LAMP, "z": float("nan")}
        for other in (far, small, {**LAMP, "radiance": [1e300, 1, 1]}, nan):
            z = other.pop("z", None)
            scene = self.load(LAMP, other)
            if z is not None:
                scene.area_lights[1].SetOrigin(-0.5, -0.5, z)
            window = scene.make_window()
            vtkindirect.enable(scene)
            errors = self.errors_of(window.Render)
            self.assertEqual(len(errors), 1, (other, errors))
            self.assertEqual(self.errors_of(window.Render), [], other)
            area = images.copy_buffer(scene.renderer, "area")
            self.assertTrue(np.array_equal(area, alone), other)
            window.Finalize()

    def test_what_floats_do_not_hold_in_a_sky(self) -> None:
        # No light comes from it: an error says so once, and the lamp shines as if alone.
        def light(sky) -> tuple[list, np.ndarray]:
            scene = self.load(LAMP)
            window = scene.make_window()
            vtkindirect.enable(scene, environment=sky)
            errors = self.errors_of(window.Render, "vtkEnvironmentLight")
            self.assertEqual(self.errors_of(window.Render, "vtkEnvironmentLight"), [])
            irradiance = images.copy_buffer(scene.renderer, "irradiance").copy()
            final = images.copy_buffer(scene.renderer, "final")
            self.assertTrue(np.isfinite(final).all() and np.isfinite(irradiance).all())
            window.Finalize()
            return errors, irradiance

        pixels = vtkImageData()
        pixels.SetDimensions(8, 4, 1)
        pixels.AllocateScalars(VTK_FLOAT, 3)
        pixels.GetPointData().GetScalars().Fill(1)
        pixels.SetScalarComponentFromDouble(3, 2, 0, 0, 1e38)
        _, alone = light(None)
        for how, calls in {
            "radiance": {"SetRadiance": (1e300, 1, 1)},
            "scale": {"SetRadiance": (1e8, 1, 1), "SetScale": (1e300,)},  # 1e12 is the greatest
            "image": {"SetImage": (pixels,)},
        }.items():
            with self.subTest(how=how):
                sky = wrapped.get("vtkEnvironmentLight")()
                for name, values in calls.items():
                    getattr(sky, name)(*values)
                errors, irradiance = light(sky)
                self.assertEqual(len(errors), 1, errors)
                self.assertTrue(np.array_equal(irradiance, alone))

    def test_many(self) -> None:
        # As bright, directly and reflected, as one light of the same size and place.
        edge = 15
        panels = [
            {
                **LAMP,
                "origin": [-0.5 + x / edge, -0.5 + y / edge, 1],
                "point1": [-0.5 + x / edge, -0.5 + (y + 1) / edge, 1],
                "point2": [-0.5 + (x + 1) / edge, -0.5 + y / edge, 1],
            }
            for x in range(edge)
            for y in range(edge)
        ]
        means = []
        for lamps in ([LAMP], panels):
            scene = self.load(*lamps)
            wall = vtkPlaneSource()
            wall.SetOrigin(-2, 2, 0)
            wall.SetPoint1(2, 2, 0)
            wall.SetPoint2(-2, 2, 2)
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(wall.GetOutputPort())
            actor = vtkActor()
            actor.SetMapper(mapper)
            scene.renderer.AddActor(actor)
            window = scene.make_window()
            vtkindirect.enable(scene)
            window.Render()
            means.append(
                [images.copy_buffer(scene.renderer, name).mean() for name in ("area", "bounce")]
            )
            left_out = [entry["what"] for entry in vtkindirect.report(scene.renderer)["left_out"]]
            shared = "maps of senders of each of 225 area lights"
            self.assertEqual(shared in left_out, len(lamps) > 1, left_out)
            window.Finalize()
        self.assertTrue(np.allclose(means[1][0], means[0][0], rtol=0.01), means)
        # Virtual lights are other clusters: 128 of them leave a few hundredths.
        self.assertTrue(np.allclose(means[1][1], means[0][1], rtol=0.1), means)

    def test_added_twice(self) -> None:
        scene = self.load(LAMP)
        window = scene.make_window()
        indirect = vtkindirect.enable(scene)
        sampler = wrapped.get("vtkAreaLightSampler")()
        sampler.AddLight(scene.area_lights[0])
        indirect.AddSampler(sampler)
        window.Render()
        once = images.copy_buffer(scene.renderer, "irradiance").copy()
        indirect.AddSampler(sampler)
        indirect.AddAreaLight(scene.area_lights[0])
        window.Render()
        self.assertTrue(np.array_equal(images.copy_buffer(scene.renderer, "irradiance"), once))
        self.assertGreater(once.mean(), 0.0)
        window.Finalize()


if __name__ == "__main__":
    unittest.main()
