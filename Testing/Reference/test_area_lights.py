# SPDX-License-Identifier: BSD-3-Clause
"""Area lights: what is exported of them, and the tracer's A1 and A3 against known answers.

The classes that trace are skipped, with the reason, where there is no environment with Mitsuba.
"""

from __future__ import annotations

import json
import tempfile
import unittest
import unittest.mock
from pathlib import Path
from typing import Any

import numpy as np
import vtkindirect
from vtkindirect import RenderError, images, wrapped
from vtkmodules.vtkRenderingCore import vtkTexture

import description
import estimates
import make_references
import provenance
import tools
from exporter import export_area_light
from traced import Traced, image_of, polygon_factor

CORNERS = {"origin": [-0.5, 1.0, 0.6], "point1": [0.5, 1.0, 0.6], "point2": [-0.5, 1.0, -0.6]}
"""Over the floor; (point1 - origin) x (point2 - origin) points upwards."""
TURNED = {**CORNERS, "point1": CORNERS["point2"], "point2": CORNERS["point1"]}
"""The same, sending light downwards; the image's rows run away from the eye."""
RADIANCE = [2.0, 1.5, 0.5]


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "vtkRenderingIndirect was not built")
class Exported(unittest.TestCase):
    """A description's area light is what vtkAreaLight says of itself."""

    def light(self) -> Any:
        light = wrapped.get("vtkAreaLight")()
        light.SetOrigin(1.0, 2.0, 3.0)
        light.SetPoint1(1.5, 2.5, 3.0)
        light.SetPoint2(1.0, 2.0, 5.0)
        light.SetRadiance(RADIANCE)
        light.SetScale(1.5)
        return light

    def check(self, light: Any) -> description.AreaLight:
        found = export_area_light(light)
        normal, mean = [0.0] * 3, [0.0] * 3
        light.GetNormal(normal)
        light.GetMeanRadiance(mean)
        self.assertTrue(np.allclose(found.normal, normal))
        self.assertAlmostEqual(found.area, light.GetArea(), places=12)
        # The class keeps single precision.
        self.assertTrue(np.allclose(found.image.mean(axis=(0, 1)), mean, rtol=1e-6))
        self.assertTrue(np.allclose(found.places(0.0, 0.0), light.GetOrigin()))
        rows, columns = found.image.shape[:2]
        self.assertTrue(np.allclose(found.places(0.0, columns), light.GetPoint1()))
        self.assertTrue(np.allclose(found.places(rows, 0.0), light.GetPoint2()))
        return found

    def test_one_radiance(self) -> None:
        found = self.check(self.light())
        self.assertEqual(found.image.tolist(), [[[3.0, 2.25, 0.75]]])
        self.assertFalse(found.two_sided)

    def test_images(self) -> None:
        values = np.random.default_rng(7).integers(1, 256, (5, 8, 4)).astype(np.uint8)
        for components in (1, 2, 3, 4):
            for encoded in (False, True):
                light = self.light()
                light.SetImage(image_of(values[..., :components]))
                light.SetEncoded(encoded)
                light.SetTwoSided(True)
                found = self.check(light)
                self.assertTrue(found.two_sided)
                texture = vtkTexture()
                texture.SetInputData(image_of(values[..., :components]))
                texture.SetUseSRGBColorSpace(encoded)
                light = self.light()
                light.SetTexture(texture)
                self.assertEqual(self.check(light).image.tolist(), found.image.tolist())
        light = self.light()
        light.SetImage(image_of(values[..., :3].astype(np.float32)))
        expected = 1.5 * np.array(RADIANCE) * values[3, 2, :3]
        self.assertTrue(np.allclose(self.check(light).image[3, 2], expected))

    def test_those_that_send_nothing_are_left_out(self) -> None:
        for change in ("SetSwitch", "SetScale"):
            light = self.light()
            getattr(light, change)(0)
            self.assertIsNone(export_area_light(light))
        light = self.light()
        light.SetPoint2(2.0, 3.0, 3.0)  # along the other edge
        self.assertIsNone(export_area_light(light))

    def test_files(self) -> None:
        """A description with area lights is read as it was written, and one without stays so."""
        scene = vtkindirect.load_scene(tools.SCENES / "area_cornell.json")
        second = self.light()
        second.SetImage(image_of(np.random.default_rng(3).uniform(0.0, 2.0, (3, 4, 3))))
        second.SetTwoSided(True)
        with tempfile.TemporaryDirectory() as name:
            for lights in ([*scene.area_lights, second], []):
                made = tools.exporter.export_renderer(
                    scene.renderer, "s", (4, 4), scene.actors.items(), None, lights
                )
                made.save(Path(name))
                found = description.load(Path(name)).area_lights
                self.assertEqual(len(found), len(lights))
                for one, other in zip(found, made.area_lights):
                    self.assertEqual(one.two_sided, other.two_sided)
                    for key in ("corner", "edge1", "edge2", "image"):
                        self.assertEqual(getattr(one, key).tolist(), getattr(other, key).tolist())

    def test_provenance_knows_the_file(self) -> None:
        hashes = provenance.data_hashes(tools.SCENES / "area_apartment.json")
        self.assertIn("../Data/window_evening.exr", hashes)


class References(unittest.TestCase):
    """Names of a scene's references."""

    def test_pairs(self) -> None:
        pairs = make_references.pairs_of
        lights, sky, area = [object()], object(), [object()]
        for given, names in (
            (([], None, []), ["R2"]),
            ((lights, None, []), ["R2"]),
            (([], sky, []), ["S1"]),
            (([], None, area), ["A1"]),
            ((lights, sky, area), ["R2", "S1", "A1"]),
        ):
            scene = unittest.mock.Mock(lights=given[0], environment=given[1], area_lights=given[2])
            self.assertEqual([pair.names[0] for pair in pairs(scene)], names)


class Lit(Traced):
    """A floor under area lights, seen from above."""

    BATCHES = 8

    def scene(self, *lamps: dict[str, Any], more: tuple[dict[str, Any], ...] = ()) -> Path:
        floor = {"source": "plane", "origin": [-2, 0, 2], "point1": [2, 0, 2]}
        document = {
            "schema": "vtkindirect.scene/1",
            "size": [48, 48],
            "camera": {"position": [0.4, 5, 2.5], "focal_point": [0.1, 0, 0.1]},
            "lights": [{"type": "area", "radiance": RADIANCE, **lamp} for lamp in lamps],
            "actors": [{**floor, "point2": [-2, 0, -2], "color": [0.7, 0.6, 0.5]}, *more],
        }
        path = self.folder / "floor.json"
        path.write_text(json.dumps(document))
        return path

    def estimate(self, path: Path, samples: int = 64) -> tuple[estimates.Estimate, np.ndarray]:
        """Return A1 of independent batches at the floor's pixels, and those pixels' points."""
        batches = [
            self.batch("area", samples, file=f"{i}.npz", seed=[i]) for i in range(self.BATCHES)
        ]
        self.trace(path, batches=batches)
        seen = self.receivers()
        found = [self.load(f"{i}.npz")["image"] for i in range(self.BATCHES)]
        floor = np.abs(seen["points"][:, 1]) < 1e-3
        where = seen["where"].copy()
        where[seen["where"]] = floor
        return estimates.combine(found, where), where, seen["points"][floor]

    def check(self, path: Path, expect: Any, systematic: float = 5e-4) -> np.ndarray:
        """Compare A1 with `expect(points)` (count, 3); both are within the batches' own error.

        The error of a pixel is estimated of 8 batches, so that differences over it have Student's
        distribution of 7 degrees of freedom, whose variance is 7/5; that of 1000 pixels and 3
        colours stays below 2. The mean may be off by four of its errors, and by `systematic`: the
        tracer's rays start 5e-5 of the diagonal above the surface.
        """
        found, where, points = self.estimate(path)
        self.assertGreater(len(points), 800)
        expected = expect(points)
        difference = found.image[where] - expected
        error = found.error[where] + systematic * expected.mean()
        self.assertLess(float((difference**2 / error**2).mean()), 2.0)
        mean = np.abs(difference.mean(axis=0))
        limit = 4.0 * found.error_of_mean() + systematic * expected.mean(axis=0)
        self.assertTrue((mean <= limit).all(), (mean, limit))
        self.assertLess(found.rmse_over_mean(where), 0.03)
        return expected


def rectangle(low: np.ndarray, high: np.ndarray, height: float = 1.0) -> np.ndarray:
    """Return the corners of a level rectangle from (x, z) to (x, z), clockwise from below."""
    (x0, z0), (x1, z1) = low, high
    return np.array([[x0, height, z0], [x1, height, z0], [x1, height, z1], [x0, height, z1]])


UP = np.array([0.0, 1.0, 0.0])


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "vtkRenderingIndirect was not built")
class KnownAnswers(Lit):
    """A1 is radiance times form factor."""

    def test_one_radiance(self) -> None:
        lamp = rectangle((-0.5, -0.6), (0.5, 0.6))

        def expect(points: np.ndarray) -> np.ndarray:
            return polygon_factor(lamp, points, UP)[:, None] * RADIANCE

        expected = self.check(self.scene(TURNED), expect)
        self.assertGreater(np.ptp(expected), 0.3)

    def test_near_the_floor(self) -> None:
        """A thousandth of the edge above it, where few places of the lamp count."""
        low = {key: [x, 1e-3, z] for key, (x, _, z) in TURNED.items()}
        lamp = rectangle((-0.5, -0.6), (0.5, 0.6), 1e-3)

        def expect(points: np.ndarray) -> np.ndarray:
            return polygon_factor(lamp, points, UP)[:, None] * RADIANCE

        # The ray's start is a third of the way to the lamp: what lies beside its edge sees it
        # under another angle.
        self.check(self.scene(low), expect, systematic=0.02)

    def test_one_side_is_dark(self) -> None:
        """The tracer gives nothing at all behind it, unless it has two sides."""
        found, where, _ = self.estimate(self.scene(CORNERS), 16)
        self.assertEqual(found.image[where].max(), 0.0)
        both, _, _ = self.estimate(self.scene({**CORNERS, "two_sided": True}), 16)
        one, _, _ = self.estimate(self.scene(TURNED), 16)
        limit = 4.0 * np.hypot(both.error_of_mean(), one.error_of_mean())
        self.assertTrue((np.abs(both.mean() - one.mean()) <= limit).all())
        self.assertGreater(one.mean().min(), 0.01)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_asymmetric_image(self) -> None:
        """Each pixel is a rectangle of its own; the first one lies at the origin."""
        values = np.zeros((3, 4, 3), dtype=np.float32)
        values[0, 0] = [1.0, 0.0, 0.0]
        values[0, 3] = [0.0, 2.0, 0.0]
        values[2, 1] = [0.0, 0.0, 4.0]
        images.write_exr(self.folder / "image.exr", values, full=True)
        path = self.scene({**TURNED, "texture": "image.exr"})

        def expect(points: np.ndarray) -> np.ndarray:
            total = np.zeros((len(points), 3))
            for row, column in np.argwhere(values.max(axis=-1) > 0.0):
                # Rows along point1 - origin, from z = 0.6 to -0.6; row by row from x = -0.5 on.
                x, z = -0.5 + row / 3.0, 0.6 - 1.2 * (column + 1) / 4.0
                piece = rectangle((x, z), (x + 1.0 / 3.0, z + 0.3))
                total += polygon_factor(piece, points, UP)[:, None] * values[row, column] * RADIANCE
            return total

        self.check(path, expect)
        self.check_the_pass(path, expect)

    def check_the_pass(self, path: Path, expect: Any) -> None:
        """The buffer `area` of the same scene is the same, within the tolerance of its images."""
        scene = vtkindirect.load_scene(path)
        try:
            window = scene.make_window()
        except RenderError as error:
            self.skipTest(str(error))
        vtkindirect.enable(scene)
        window.Render()
        found = images.copy_buffer(scene.renderer, "area")
        self.trace(path)
        seen = self.receivers()
        expected = expect(seen["points"])
        self.assertTrue(np.allclose(found[seen["where"]], expected, rtol=0.01, atol=0.0025))
        window.Finalize()

    def test_penumbra(self) -> None:
        """A screen half way up hides a part of the lamp; the rest is a rectangle too."""
        screen = {"source": "plane", "origin": [-2, 0.5, 2], "point1": [0, 0.5, 2]}
        path = self.scene(TURNED, more=({**screen, "point2": [-2, 0.5, -2]},))

        def expect(points: np.ndarray) -> np.ndarray:
            left = np.clip(-points[:, 0], -0.5, 0.5)
            factors = [
                polygon_factor(rectangle((x, -0.6), (0.5, 0.6)), point[None], UP)[0]
                if x < 0.5
                else 0.0
                for x, point in zip(left, points)
            ]
            return np.array(factors)[:, None] * RADIANCE

        self.check(path, expect)


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "vtkRenderingIndirect was not built")
class Paths(Lit):
    """Paths under Mitsuba's own rectangles, which its renderer finds by itself."""

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_against_mitsubas_path_integrator(self) -> None:
        """Mean radiance directly and after a bounce; noise of 96 x 96 pixels is below 0.5 %."""
        values = np.random.default_rng(5).uniform(0.0, 1.0, (3, 5, 3)).astype(np.float32)
        values[2, 4] = [9.0, 1.0, 3.0]
        images.write_exr(self.folder / "image.exr", values, full=True)
        # Upright at two sides of the floor that is seen: little lies behind their back, which
        # Mitsuba's rectangles hide. The eye looks past them.
        lamps = (
            {
                "origin": [-1.2, 0.1, -1.9], "point1": [1.2, 0.1, -1.9], "point2": [-1.2, 1.1, -1.9],
                "texture": "image.exr",
            },
            {"origin": [1.9, 0.2, -0.4], "point1": [1.9, 0.2, 1.0], "point2": [1.9, 0.9, -0.4]},
        )  # fmt: skip
        box = {"source": "box", "bounds": [-0.6, 0.1, 0, 0.8, -0.5, 0.3], "color": [0.8, 0.2, 0.3]}
        path = self.scene(*lamps, more=(box,))
        document = json.loads(path.read_text())
        document["camera"] = {"position": [0.3, 3.5, 1.6], "focal_point": [0.1, 0, 0.1]}
        path.write_text(json.dumps(document))
        size = (96, 96)
        batches = [self.batch("area", 256), self.batch("all", 256, 1)]
        self.trace(path, size, batches=batches, path=256)
        expected = json.loads((self.folder / "path.json").read_text())
        albedo = self.load("seen.npz")["albedo"]
        for name, kind in (("bounce0", "area"), ("bounce1", "all")):
            found = (albedo * self.load(f"{kind}.npz")["image"]).mean(axis=(0, 1))
            self.assertTrue(np.allclose(found, expected[name], rtol=0.01),
                            (name, found, expected[name]))  # fmt: skip


@unittest.skipUnless(wrapped.has("vtkAreaLight"), "vtkRenderingIndirect was not built")
class Sums(Lit):
    """ "all" is the light of area lights, sky and lamps: each is there, and none twice."""

    def test_sum(self) -> None:
        sky = {"type": "environment", "radiance": [0.2, 0.3, 0.4]}
        lamp = {"type": "point", "position": [1, 1, 1], "intensity": 0.5}
        box = {"source": "box", "bounds": [-0.6, 0.1, 0, 0.8, -0.5, 0.3]}
        path = self.scene(TURNED, more=(box,))
        document = json.loads(path.read_text())
        (area,) = document["lights"]
        means = {}
        for name, lights in (
            ("together", [sky, lamp, area]), ("sky", [sky]), ("lamp", [lamp]), ("area", [area]),
        ):  # fmt: skip
            path.write_text(json.dumps({**document, "lights": lights}))
            self.trace(path, batches=[self.batch("all", 256, 2)])
            means[name] = self.load("all.npz")["means"]
        apart = means["sky"] + means["lamp"] + means["area"]
        # Noise of means of some 1000 pixels of 256 samples; a part that was missing would be 10 %.
        self.assertTrue(np.allclose(means["together"], apart, rtol=0.02), means)
        for name in ("sky", "lamp", "area"):
            self.assertTrue((means[name][0] > 0.1 * means["together"][0]).any(), name)
