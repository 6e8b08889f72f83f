# SPDX-License-Identifier: BSD-3-Clause
"""Light from the sky: what is exported of it, and the tracer's S1 and S3 against known answers.

The classes that trace are skipped, with the reason, where there is no environment with Mitsuba.
"""

from __future__ import annotations

import json
import math
import tempfile
import unittest
from pathlib import Path
from typing import Any

import numpy as np
import vtkindirect
from vtkindirect import images, wrapped
from vtkmodules.vtkRenderingCore import vtkTexture

import description
import provenance
import tools
from exporter import ExportError, export_environment
from traced import Traced, image_of, polygon_factor

UP, RIGHT = (0.3, 1.0, -0.2), (0.1, 0.4, -1.0)
"""Some directions that are neither of length 1 nor at right angles."""


@unittest.skipUnless(wrapped.has("vtkEnvironmentLight"), "vtkRenderingIndirect was not built")
class Exported(unittest.TestCase):
    """A description's environment is what vtkEnvironmentLight says of itself."""

    def check(self, light: Any) -> None:
        """Compare at places inside of each pixel, where rounding cannot choose another one."""
        found = export_environment(light)
        rows, columns = found.image.shape[:2]
        random = np.random.default_rng(3)
        row, column = (a.ravel() for a in np.mgrid[:rows, :columns])
        ways = found.directions(
            row + random.uniform(0.01, 0.99, row.shape),
            column + random.uniform(0.01, 0.99, row.shape),
        )
        for way, i, j in zip(ways, row, column):
            expected = [0.0, 0.0, 0.0]
            light.GetRadianceFrom(way.tolist(), expected)
            self.assertTrue(np.allclose(found.image[i, j], expected, rtol=1e-12), (i, j))

    def light(self) -> Any:
        light = wrapped.get("vtkEnvironmentLight")()
        light.SetUp(UP)
        light.SetRight(RIGHT)
        light.SetScale(1.5)
        return light

    def test_uniform(self) -> None:
        light = self.light()
        light.SetRadiance(0.25, 0.5, 2.0)
        self.check(light)
        self.assertEqual(export_environment(light).image.tolist(), [[[0.375, 0.75, 3.0]]])

    def test_floats(self) -> None:
        light = self.light()
        light.SetImage(image_of(np.random.default_rng(5).uniform(0.0, 5.0, (6, 11, 3))))
        self.check(light)

    def test_what_is_no_radiance_is_black(self) -> None:
        light = self.light()
        values = np.ones((2, 4, 3), dtype=np.float32)
        values[1, 2] = [-1.0, np.nan, np.inf]
        light.SetImage(image_of(values))
        self.assertEqual(export_environment(light).image[1, 2].tolist(), [0.0, 0.0, 0.0])

    def test_bytes_and_textures(self) -> None:
        values = np.random.default_rng(7).integers(0, 256, (5, 8, 4)).astype(np.uint8)
        for components in (1, 2, 3, 4):
            light = self.light()
            light.SetImage(image_of(values[..., :components]))
            self.check(light)
        for encoded in (False, True):
            texture = vtkTexture()
            texture.SetInputData(image_of(values))
            texture.SetUseSRGBColorSpace(encoded)
            light = self.light()
            light.SetTexture(texture)
            self.check(light)

    def test_axes(self) -> None:
        light = self.light()
        found = export_environment(light)
        axes = np.stack([found.right, found.up, found.back])
        self.assertTrue(np.allclose(axes @ axes.T, np.eye(3)))
        self.assertGreater(np.linalg.det(axes), 0.0)
        light.SetRight(*(2.0 * value for value in UP))
        with self.assertRaisesRegex(ExportError, "Right is along its Up"):
            export_environment(light)

    def test_solid_angles(self) -> None:
        light = self.light()
        light.SetImage(image_of(np.ones((7, 5, 3))))
        whole = 5 * export_environment(light).solid_angles().sum()
        self.assertAlmostEqual(whole, 4.0 * math.pi, places=12)

    def test_files(self) -> None:
        """A description with an environment is read as it was written, and one without stays so."""
        scene = vtkindirect.load_scene(tools.SCENES / "sky_plane.json")
        with tempfile.TemporaryDirectory() as name:
            for sky in (scene.environment, None):
                made = tools.exporter.export_renderer(
                    scene.renderer, "s", (4, 4), scene.actors.items(), sky
                )
                made.save(Path(name))
                found = description.load(Path(name)).environment
                self.assertEqual(found is None, sky is None)
                if sky is not None:
                    self.assertEqual(found.image.tolist(), made.environment.image.tolist())

    def test_provenance_knows_the_file(self) -> None:
        hashes = provenance.data_hashes(tools.SCENES / "sky_terrain.json")
        self.assertEqual(list(hashes), ["../Data/sky_sun.exr"])


class Skies(unittest.TestCase):
    """The skies of Testing/Data are what make_skies.py makes."""

    def setUp(self) -> None:
        import importlib.util

        path = tools.SOURCE / "Testing" / "Data" / "make_skies.py"
        found = importlib.util.spec_from_file_location("make_skies", path)
        self.skies = importlib.util.module_from_spec(found)
        found.loader.exec_module(self.skies)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_files(self) -> None:
        for name, make in self.skies.SKIES.items():
            path = tools.SOURCE / "Testing" / "Data" / name
            light = vtkindirect.environments.from_value(path)
            found = export_environment(light).image
            # Half floats: 11 significant bits.
            self.assertTrue(np.allclose(found, make(), rtol=2.0**-11, atol=1e-7), name)
            self.assertLess(path.stat().st_size, 20000)

    def test_sun(self) -> None:
        """Its disk covers the solid angle of 2 degrees; pieces of a pixel are 1.4 / 16 degrees."""
        covered = (self.skies.sun_cover() * self.skies.solid_angles()[:, None]).sum()
        disk = 2.0 * math.pi * (1.0 - math.cos(math.radians(1.0)))
        self.assertAlmostEqual(covered / disk, 1.0, delta=0.01)


# Known answers ------------------------------------------------------------------------------------


def disk_factor(distance: np.ndarray, height: float, radius: float) -> np.ndarray:
    """Return the form factors from a plane to a parallel disk, `distance` from below its centre.

    Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-13.
    """
    whole = height**2 + distance**2 + radius**2
    root = np.sqrt(whole**2 - (2.0 * distance * radius) ** 2)
    return 0.5 * (1.0 - (height**2 + distance**2 - radius**2) / root)


class Formulas(unittest.TestCase):
    """The formulas agree with each other where more than one is known."""

    def test_long_wall(self) -> None:
        """Beside a wall of height h that never ends E = L (1 + d / sqrt(d^2 + h^2)) / 2."""
        wall = np.array([[0, 0, 1e5], [0, 0, -1e5], [0, 1, -1e5], [0, 1, 1e5]], dtype=float)
        distance = np.array([1e-3, 0.3, 1.0, 4.0])
        points = np.stack([distance, 0 * distance, 0 * distance], axis=1)
        found = 1.0 - polygon_factor(wall, points, np.array([0.0, 1.0, 0.0]))
        expected = 0.5 * (1.0 + distance / np.sqrt(distance**2 + 1.0))
        self.assertTrue(np.allclose(found, expected, atol=1e-8), found - expected)
        self.assertAlmostEqual(found[0], 0.5, delta=1e-3)

    def test_disk(self) -> None:
        angle = 2.0 * np.pi * np.arange(4096) / 4096
        disk = np.stack([np.cos(angle), 0 * angle + 0.7, np.sin(angle)], axis=1)
        distance = np.array([0.0, 0.5, 1.0, 3.0])
        points = np.stack([distance, 0 * distance, 0 * distance], axis=1)
        found = polygon_factor(disk, points, np.array([0.0, 1.0, 0.0]))
        # The polygon is smaller than the disk by (2 pi / 4096)^2 / 6 of it.
        self.assertTrue(np.allclose(found, disk_factor(distance, 0.7, 1.0), atol=1e-6))
        self.assertAlmostEqual(disk_factor(np.zeros(1), 0.7, 1.0).item(), 1.0 / 1.49)


class Orientation(Traced):
    """One bright pixel in a known direction lights the sides of a box that face it."""

    def scene(self, camera: list[float], pixel: tuple[int, int]) -> Path:
        values = np.zeros((16, 32, 3), dtype=np.float32)
        values[pixel] = [30.0, 60.0, 90.0]
        images.write_exr(self.folder / "sky.exr", values, full=True)
        document = {
            "schema": "vtkindirect.scene/1",
            "size": [48, 48],
            "camera": {"position": camera, "focal_point": [0, 0, 0]},
            "lights": [
                {"type": "environment", "file": "sky.exr", "scale": 2, "up": UP, "right": RIGHT}
            ],
            "actors": [{"source": "box", "bounds": [-0.5, 0.5, -0.5, 0.5, -0.5, 0.5]}],
        }
        path = self.folder / "box.json"
        path.write_text(json.dumps(document))
        return path

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_sides_of_a_box(self) -> None:
        """E = L times the integral of max(0, n . d) over the pixel, by pi.

        The integral is a sum over 32 x 32 places of the pixel, its error below 0.1 %. Most samples
        are drawn by the radiance and differ by the cosine only, which changes by 20 % across the
        pixel: the mean of 64 samples of 100 pixels or more is better than 0.3 %.
        """
        for pixel in ((12, 20), (3, 5), (8, 0), (7, 31)):
            lit = 0
            for camera in ([2.5, 2.0, 3.0], [-2.5, -2.0, -3.0]):
                path = self.scene(camera, pixel)
                light = vtkindirect.load_scene(path).environment
                found = export_environment(light)
                way = found.directions(pixel[0] + 0.5, pixel[1] + 0.5)
                radiance = [0.0, 0.0, 0.0]
                light.GetRadianceFrom(way.tolist(), radiance)
                self.assertEqual(radiance, [60.0, 120.0, 180.0])
                row, column = ((a + 0.5) / 32.0 for a in np.mgrid[:32, :32])
                places = found.directions(pixel[0] + row, pixel[1] + column)
                weights = np.sqrt(1.0 - (places @ found.up) ** 2)
                weights /= weights.sum()
                self.trace(path, batches=[self.batch("sky", 64)])
                seen = self.receivers()
                light_at = self.load("sky.npz")["image"][seen["where"]]
                for normal in np.concatenate([np.eye(3), -np.eye(3)]):
                    side = seen["normals"] @ normal > 0.99
                    if not side.any():
                        continue
                    whole = np.array(radiance) * found.solid_angles()[pixel[0]] / math.pi
                    expected = whole * (weights * np.maximum(places @ normal, 0.0)).sum()
                    mean = light_at[side].mean(axis=0)
                    self.assertTrue(np.allclose(mean, expected, rtol=0.004, atol=1e-4 * whole[0]),
                                    (pixel, normal, mean, expected))  # fmt: skip
                    lit += bool(expected.max() > 0.02 * whole[0])
            self.assertGreaterEqual(lit, 2)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_against_mitsubas_path_integrator(self) -> None:
        """The mean radiance agrees with paths under Mitsuba's own environment emitter.

        Mitsuba's image is 8 times finer and interpolated, so that edges are blurred by an eighth of
        a pixel; light of single pixels moves by less than a percent.
        """
        random = np.random.default_rng(11)
        values = random.uniform(0.0, 1.0, (16, 32, 3)).astype(np.float32)
        values[12, 20] = 40.0
        for image in (values, None):
            path = self.scene([2.5, 2.0, 3.0], (12, 20))
            document = json.loads(path.read_text())
            if image is None:
                document["lights"] = [{"type": "environment", "radiance": [1.0, 2.0, 0.5]}]
            else:
                images.write_exr(self.folder / "sky.exr", image, full=True)
            floor = {"source": "plane", "origin": [-2, -0.5, 2], "point1": [2, -0.5, 2]}
            document["actors"].append({**floor, "point2": [-2, -0.5, -2], "color": [0.8, 0.6, 0.4]})
            document["camera"]["position"] = [2.0, 4.0, 3.0]
            path.write_text(json.dumps(document))
            size = (96, 96)
            batches = [self.batch("sky", 256), self.batch("all", 256, 1)]
            self.trace(path, size, batches=batches, path=256)
            expected = json.loads((self.folder / "path.json").read_text())
            albedo = self.load("seen.npz")["albedo"]
            for name, kind in (("bounce0", "sky"), ("bounce1", "all")):
                found = (albedo * self.load(f"{kind}.npz")["image"]).mean(axis=(0, 1))
                self.assertTrue(np.allclose(found, expected[name], rtol=0.01),
                                (name, found, expected[name]))  # fmt: skip


class KnownAnswers(Traced):
    """S1 of the scenes sky_plane, sky_wall, sky_disk and sky_groove."""

    RADIANCE = np.array([1.0, 0.8, 0.6])
    SAMPLES = 1024

    def check(self, name: str, color: tuple[float, ...], factor: Any) -> None:
        """Compare S1 of the actor of a colour with L (1 - factor(points, normal)).

        An estimate is a fraction p of N stratified directions that are free, whose error is at most
        that of independent ones, sqrt(p (1 - p) / N) <= 0.5 / sqrt(N). The worst of some 1000
        pixels may be four times that; the mean of M pixels has 1 / sqrt(M) of it. The tracer's rays
        start 5e-5 of the diagonal above the surface, which adds to that 5e-4.
        """
        self.trace(tools.SCENES / f"{name}.json", batches=[self.batch("sky", self.SAMPLES)])
        seen = self.receivers()
        part = np.abs(seen["albedo"] - np.array(color)).max(axis=1) < 1e-3
        self.assertGreater(part.sum(), 150)
        points, normals = seen["points"][part], seen["normals"][part]
        expected = 1.0 - factor(points, normals[0])
        found = self.load("sky.npz")["image"][seen["where"]][part] / self.RADIANCE
        difference = found - expected[:, None]
        one = 0.5 / math.sqrt(self.SAMPLES)
        self.assertLess(np.abs(difference).max(), 4.0 * one)
        limit = 4.0 * one / math.sqrt(part.sum()) + 5e-4
        self.assertLess(np.abs(difference.mean(axis=0)).max(), limit)
        self.assertGreater(np.ptp(expected), 0.1)

    def test_plane(self) -> None:
        """Nothing is in the way: E = L, of every sample."""
        self.trace(tools.SCENES / "sky_plane.json", batches=[self.batch("sky", 16)])
        seen = self.receivers()
        found = self.load("sky.npz")["image"][seen["where"]]
        self.assertGreater(len(found), 150)
        self.assertTrue(np.allclose(found, self.RADIANCE, rtol=1e-6))

    def test_wall(self) -> None:
        wall = np.array([[0, 0, 20], [0, 0, -20], [0, 1, -20], [0, 1, 20]], dtype=float)
        self.check("sky_wall", (0.7, 0.7, 0.7), lambda p, n: polygon_factor(wall, p, n))

    def test_disk(self) -> None:
        def factor(points: np.ndarray, _normal: np.ndarray) -> np.ndarray:
            return disk_factor(np.hypot(points[:, 0], points[:, 2]), 0.6, 0.5)

        self.check("sky_disk", (0.7, 0.7, 0.7), factor)

    def test_groove(self) -> None:
        right = np.array([[0, 0, 8], [0, 0, -8], [1, 1, -8], [1, 1, 8]], dtype=float)
        self.check("sky_groove", (0.7, 0.3, 0.2), lambda p, n: polygon_factor(right, p, n))


class Furnace(Traced):
    """If every surface reflects all light, a sky of L makes E = L everywhere in the end."""

    def test_groove(self) -> None:
        """S1 and 40 bounces; in the groove a bounce keeps less than 0.75 of the light."""
        document = json.loads((tools.SCENES / "sky_groove.json").read_text())
        for actor in document["actors"]:
            actor["color"] = [1, 1, 1]
        path = self.folder / "white.json"
        path.write_text(json.dumps(document))
        self.trace(path, (24, 24), batches=[self.batch("sky", 1024), self.batch("all", 1024, 40)])
        where = self.receivers((24, 24))["where"]
        found = sum(self.load(f"{kind}.npz")["image"][where] for kind in ("sky", "all"))
        # Each sample of a path that leaves the scene brings all of L, in S1 or in a bounce.
        error = np.abs(found.mean(axis=0) / KnownAnswers.RADIANCE - 1.0).max()
        self.assertLess(error, 0.005)
        self.assertGreater(self.load("all.npz")["means"][0].min(), 0.05)


class Lamps(Traced):
    """"all" is the light of lamps and of the sky: both are there, and neither twice."""

    def test_sum(self) -> None:
        """Bounces of lamps and sky together are those of each alone."""
        document = json.loads((tools.SCENES / "sky_courtyard.json").read_text())
        sky, lamp = document["lights"]
        means = {}
        data = str(tools.SOURCE / "Testing" / "Data")
        for name, lights in (("both", [sky, lamp]), ("sky", [sky]), ("lamp", [lamp])):
            path = self.folder / f"{name}.json"
            text = json.dumps({**document, "lights": lights}).replace("../Data", data)
            path.write_text(text)
            batches = [self.batch("all", 64, 3), self.batch("bounces", 64, 3)]
            self.trace(path, (48, 36), batches=batches)
            means[name] = self.load("all.npz")["means"]
            if name == "both":
                of_lamps = self.load("bounces.npz")["means"]
        # Noise of the means of some 1000 pixels of 64 samples each; a part that was missing or
        # counted twice would be 20 % at least.
        self.assertTrue(np.allclose(means["both"], means["sky"] + means["lamp"], rtol=0.02))
        self.assertTrue(np.allclose(of_lamps, means["lamp"], rtol=0.02))
        self.assertTrue((means["lamp"][0] > 0.05 * means["both"][0]).any())
