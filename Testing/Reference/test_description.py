# SPDX-License-Identifier: BSD-3-Clause
"""The maths of descriptions: rays, lights in the tracer's coordinates, files."""

from __future__ import annotations

import math
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkLightKit, vtkRenderer

import description
from description import Camera, Description, Light, Surface
from exporter import export_camera, export_light, matrix_of


def _camera(parallel: bool = False) -> vtkCamera:
    camera = vtkCamera()
    camera.SetPosition(1.0, 2.0, 5.0)
    camera.SetFocalPoint(0.3, 0.5, -1.0)
    camera.SetViewUp(0.1, 1.0, 0.2)
    camera.SetViewAngle(37.0)
    camera.SetClippingRange(0.5, 40.0)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(1.7)
    return camera


class Rays(unittest.TestCase):
    """Rays must hit the pixels' centres that VTK's own projection says."""

    def check(self, camera: vtkCamera, width: int, height: int) -> None:
        origins, directions = export_camera(camera).rays(width, height)
        near, far = camera.GetClippingRange()
        project = matrix_of(camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0))
        self.assertTrue(np.allclose(np.linalg.norm(directions, axis=-1), 1.0))
        forward = np.array(camera.GetDirectionOfProjection())
        for way, depth in ((0.0, -1.0), ((far - near), 1.0)):
            lengths = way / (directions @ forward)[..., None]
            points = origins + lengths * directions
            clip = np.concatenate([points, np.ones((height, width, 1))], axis=-1) @ project.T
            clip = clip[..., :3] / clip[..., 3:]
            x = (clip[..., 0] + 1.0) * 0.5 * width
            y = (clip[..., 1] + 1.0) * 0.5 * height
            self.assertTrue(np.allclose(x, np.arange(width) + 0.5, atol=1e-8))
            self.assertTrue(np.allclose(y, np.arange(height)[:, None] + 0.5, atol=1e-8))
            self.assertTrue(np.allclose(clip[..., 2], depth, atol=1e-9))

    def test_perspective(self) -> None:
        self.check(_camera(), 64, 48)

    def test_odd_aspect(self) -> None:
        self.check(_camera(), 7, 33)
        self.check(_camera(), 201, 3)

    def test_parallel(self) -> None:
        self.check(_camera(parallel=True), 40, 24)

    def test_one_pixel(self) -> None:
        self.check(_camera(), 1, 1)


class Lights(unittest.TestCase):
    """An emitter must give VTK's light at any point, whatever its kind and the scale."""

    def vtk_light(self, light: Light, point: np.ndarray) -> np.ndarray:
        strength = np.array(light.strength)
        if not light.positional:
            return strength
        away = point - np.array(light.position)
        d = float(np.linalg.norm(away))
        constant, linear, quadratic = light.attenuation
        cosine = float(away @ np.array(light.direction)) / d
        if light.cone is not None:
            if cosine < math.cos(math.radians(light.cone)):
                return np.zeros(3)
            strength = strength * cosine**light.exponent
        return strength / (constant + linear * d + quadratic * d * d)

    def check(self, light: Light, kind: str) -> None:
        center, scale = np.array([3.0, -2.0, 10.0]), 12.5
        emitted = description.emitter(light, center, scale)
        self.assertEqual(emitted["type"], kind)
        random = np.random.default_rng(5)
        for offset in random.normal(size=(40, 3)):
            point = np.array(light.position) + 3.0 * offset
            found = description.irradiance_at(emitted, (point - center) * scale)
            self.assertTrue(np.allclose(found, self.vtk_light(light, point), rtol=1e-12, atol=0))

    def light(self, **changes: object) -> Light:
        values: dict = {
            "positional": True,
            "position": [1.0, 2.0, 3.0],
            "direction": [0.6, 0.0, -0.8],
            "strength": [0.5, 1.0, 2.0],
        }
        return Light(**{**values, **changes})

    def test_table(self) -> None:
        square = [0.0, 0.0, 0.3]
        self.check(self.light(attenuation=square), "point")
        self.check(self.light(attenuation=square, cone=40.0), "spot")
        self.check(self.light(attenuation=square, cone=40.0, exponent=2.0), "vtk_light")
        self.check(self.light(), "vtk_light")
        self.check(self.light(cone=60.0, exponent=8.0), "vtk_light")
        self.check(self.light(cone=60.0, attenuation=[0.2, 0.5, 0.1]), "vtk_light")
        self.check(self.light(positional=False), "directional")

    def test_numbers(self) -> None:
        lamp = self.light(attenuation=[0.0, 0.0, 2.0], strength=[1.0, 1.0, 1.0])
        self.assertAlmostEqual(
            description.emitter(lamp, np.zeros(3), 1.0)["intensity"][0], math.pi / 2.0
        )
        sun = self.light(positional=False, strength=[1.0, 1.0, 1.0])
        self.assertAlmostEqual(description.emitter(sun, np.zeros(3), 7.0)["irradiance"][0], math.pi)

    def test_from_vtk(self) -> None:
        light = vtkLight()
        light.PositionalOn()
        light.SetPosition(0, 0, 4)
        light.SetFocalPoint(0, 0, 0)
        light.SetColor(1.0, 0.5, 0.25)
        light.SetIntensity(2.0)
        light.SetConeAngle(25.0)
        light.SetExponent(3.0)
        found = export_light(light)
        self.assertEqual(found.direction, [0.0, 0.0, -1.0])
        self.assertEqual(found.strength, [2.0, 1.0, 0.5])
        self.assertEqual((found.cone, found.exponent), (25.0, 3.0))
        light.SetConeAngle(90.0)
        found = export_light(light)
        self.assertEqual((found.cone, found.exponent), (None, 0.0))

    def test_lights_that_follow_the_camera(self) -> None:
        renderer = vtkRenderer()
        renderer.SetActiveCamera(_camera())
        head = vtkLight()
        head.SetLightTypeToHeadlight()
        renderer.AddLight(head)
        kit = vtkLightKit()
        kit.AddLightsToRenderer(renderer)
        renderer.UpdateLightsGeometryToFollowCamera()
        found = export_light(head)
        self.assertFalse(found.positional)
        forward = renderer.GetActiveCamera().GetDirectionOfProjection()
        self.assertTrue(np.allclose(found.direction, forward))


class Files(unittest.TestCase):
    def test_round_trip(self) -> None:
        surface = Surface(
            np.array([[1e6, 0, 0], [1e6 + 1, 0, 0], [1e6, 1, 0]]),
            np.tile([0.0, 0.0, 1.0], (3, 1)),
            np.tile([0.1, 0.2, 0.3], (3, 1)),
            np.array([[0, 1, 2]]),
        )
        camera = Camera([0, 0, 5], [1, 0, 0], [0, 1, 0], [0, 0, -1], 0.3, False, 1.0, 10.0)
        left_out = [{"what": "glass", "why": "translucent"}]
        light = Light(True, [0, 0, 1], [0, 0, -1], [1, 1, 1], [1, 0, 0], 30.0, 2.0)
        scene = Description("three", (4, 3), camera, [light], surface, left_out)
        with tempfile.TemporaryDirectory() as name:
            scene.save(Path(name))
            found = description.load(Path(name))
        self.assertEqual((found.name, found.size, found.camera), ("three", (4, 3), camera))
        self.assertEqual(found.lights, [light])
        self.assertEqual(found.left_out, left_out)
        self.assertTrue((found.surface.points == surface.points).all())
        self.assertAlmostEqual(found.surface.area, 0.5)
        self.assertAlmostEqual(found.scale, description.TRACER_DIAGONAL / math.sqrt(2))
        self.assertTrue(np.allclose(found.center, [1e6 + 0.5, 0.5, 0.0]))
