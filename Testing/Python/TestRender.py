# SPDX-License-Identifier: BSD-3-Clause
"""Rendered pictures: indirect light is where it must be, reports say what they must say."""

import json
import tempfile
import unittest
from pathlib import Path

import numpy as np
import pytest

import support
import vtkindirect
from vtkindirect import (
    METHODS,
    RenderError,
    UsageError,
    frames,
    images,
    load_scene,
    windows,
    wrapped,
)
from vtkindirect.frames import Job

WHY_NOT = support.why_no_rendering()

STAGES = {"delegate", "visibility", "geometry", "rsm", "lights", "estimate", "upsample", "composite"}


class Times(unittest.TestCase):
    def test_percentile_is_the_one_of_the_passes(self) -> None:
        """By its definition, as Unit.Percentile tests that of the passes' own report."""
        generator = np.random.Generator(np.random.PCG64(7))
        for count in range(1, 201):
            times = [float(time) for time in generator.integers(0, 300, count)]
            enough = [t for t in times if 100 * sum(u <= t for u in times) >= 95 * count]
            self.assertEqual(frames.percentile_95(times), min(enough), times)
        self.assertEqual(frames.percentile_95([1.0] * 19 + [9.0]), 1.0)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Render(unittest.TestCase):
    def render(self, name: str, **job) -> tuple:
        scene = load_scene(support.SCENES / f"{name}.json")
        window = frames.open_window(scene, job.pop("size", None))
        self.addCleanup(window.Finalize)
        report = frames.render(scene, window, Job(**job))
        return scene, report

    def test_colour_bleeds(self) -> None:
        scene, report = self.render("two_planes", method="gather")
        indirect = vtkindirect.copy_buffer(scene.renderer, "indirect")
        self.assertEqual(indirect.dtype, np.float32)
        self.assertEqual(indirect.shape[:2], (128, 128))
        self.assertTrue(np.isfinite(indirect).all())
        normal = vtkindirect.copy_buffer(scene.renderer, "normal")
        wall = normal[..., 2] > 0.9
        self.assertGreater(wall.sum(), 500)
        red, green = indirect[wall, 0].mean(), indirect[wall, 1].mean()
        self.assertGreater(red, 0.01)
        self.assertAlmostEqual(red / green, 8.0, delta=0.5)
        rows = np.nonzero(wall.any(axis=1))[0]
        lower, upper = rows[len(rows) // 4], rows[3 * len(rows) // 4]
        column = indirect.shape[1] // 2
        self.assertGreater(indirect[lower, column, 0], 1.5 * indirect[upper, column, 0])
        direct = vtkindirect.copy_buffer(scene.renderer, "direct")
        self.assertLess(direct[wall].max(), 0.02)
        final = vtkindirect.copy_buffer(scene.renderer, "final")
        both = (direct + indirect)[wall][:, :3]
        self.assertTrue(np.allclose(final[wall][:, :3], both, atol=2e-3))
        self.assertEqual(report["method"], "gather")

    def test_closed_sphere_has_the_exact_answer(self) -> None:
        settings = {"Mode": "all_texels", "ReflectiveShadowMapResolution": 32}
        scene, _ = self.render("closed_sphere", method="gather", settings=settings, size=(32, 32))
        irradiance = vtkindirect.copy_buffer(scene.renderer, "irradiance")
        self.assertAlmostEqual(float(np.median(irradiance[..., :3])), 0.5, delta=0.02)

    def test_report(self) -> None:
        settings = {"NumberOfLights": "64"}
        scene, report = self.render("cornell_box", method="gather", settings=settings, frames=3)
        self.assertEqual(report["schema"], "vtkindirect.report/1")
        self.assertEqual(report["scene"], "cornell_box")
        self.assertEqual(report["size"], [256, 256])
        self.assertEqual(report["frames"], 3)
        self.assertEqual(report["settings"]["NumberOfLights"], 64)
        self.assertLessEqual(report["virtual_lights"], 64)
        self.assertGreater(report["frame_ms"], 0)
        self.assertLessEqual(set(report["stages"]), STAGES)
        for times in report["stages"].values():
            self.assertLessEqual(0, times["median_ms"])
            self.assertLessEqual(times["median_ms"], times["p95_ms"])
        for key in ("modelled", "left_out", "gl", "vtk", "version", "shader_hash"):
            self.assertIn(key, report)
        self.assertEqual(vtkindirect.report(scene.renderer)["schema"], report["schema"])

    def test_multiresolution_is_near_the_gather(self) -> None:
        lights = {"NumberOfLights": 64}
        scene, _ = self.render("cornell_box", method="gather",
                               settings={**lights, "Interpolation": False})  # fmt: skip
        expected = vtkindirect.copy_buffer(scene.renderer, "irradiance")
        errors = {}
        for name, settings in {
            "default": {},
            "half": {"FinestLevel": "half_resolution"},
            "finest": {"PlaneThreshold": 0},
        }.items():
            scene, report = self.render(
                "cornell_box", method="multiresolution", settings={**lights, **settings}, frames=2
            )
            self.assertEqual(report["method"], "multiresolution")
            for stage in ("estimate", "upsample"):
                self.assertGreater(report["stages"][stage]["median_ms"], 0.0)
            found = vtkindirect.copy_buffer(scene.renderer, "irradiance")
            errors[name] = float(np.sqrt(((found - expected) ** 2).mean()) / expected.mean())
        self.assertLess(errors["finest"], 1e-3)  # sums are stored in half floats
        self.assertLess(errors["default"], 0.05)
        self.assertLess(errors["default"], errors["half"])
        self.assertLess(errors["half"], 0.13)  # what is below lights is narrower than 2 x 2 pixels

    def test_a_picture_has_all_its_maps_and_one_sum(self) -> None:
        """A ball has so many triangles that a frame has time for 64 depth maps of 100."""
        document = support.small_scene()
        document["actors"].append(
            {"source": "sphere", "center": [0.5, 0.3, 0.5], "radius": 0.3, "resolution": 700}
        )
        document["lights"][0]["attenuation"] = [1, 0, 0]
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "ball.json"
            path.write_text(json.dumps(document))
            scene = load_scene(path)
        window = frames.open_window(scene, (32, 24))
        self.addCleanup(window.Finalize)
        window.SetDesiredUpdateRate(0.9)  # still, with little time
        heard: list[tuple[str, int]] = []
        settings = {"NumberOfLights": 100, "NumberOfBounces": 1}
        job = Job("gather", "uniform", settings)
        report = frames.render(scene, window, job, lambda what, left=0: heard.append((what, left)))
        counters = report["counters"]
        self.assertEqual((counters["tiles_left"], counters["estimates"]), (0, 1))
        self.assertEqual(heard[0], ("frame 1 of 1", 0))
        self.assertEqual(heard[1:], [("36 depth maps to draw", 0)])
        self.assertNotIn("indirect light", [entry["what"] for entry in report["left_out"]])
        self.assertFalse(vtkindirect.pass_of(scene.renderer).GetMapsFirst())

    def test_off(self) -> None:
        scene, report = self.render("cornell_box", method="off", frames=2, size=(100, 60))
        self.assertEqual(set(report["stages"]), {"delegate"})
        self.assertEqual((report["method"], report["frames"]), ("off", 2))
        self.assertEqual(report["size"], [100, 60])
        shown = images.window_bytes(scene.render_window)
        self.assertEqual(shown.shape, (60, 100, 3))
        self.assertGreater(shown.max(), 100)
        floats = images.window_floats(scene.render_window)
        self.assertTrue(np.allclose(floats, shown / 255.0, atol=0.003))

    def test_window_shows_the_final_buffer(self) -> None:
        scene, _ = self.render("cornell_box", method="auto")
        shown = images.window_bytes(scene.render_window) / 255.0
        final = np.clip(vtkindirect.copy_buffer(scene.renderer, "final")[..., :3], 0, 1)
        self.assertLess(np.abs(shown - final).mean(), 0.01)

    def test_disable_brings_vtk_back(self) -> None:
        scene, _ = self.render("cornell_box", method="off")
        before = images.window_bytes(scene.render_window)
        vtkindirect.enable(scene.renderer)
        scene.render_window.Render()
        self.assertFalse(np.array_equal(images.window_bytes(scene.render_window), before))
        vtkindirect.disable(scene.renderer)
        scene.render_window.Render()
        self.assertTrue(np.array_equal(images.window_bytes(scene.render_window), before))

    def test_every_buffer_is_finite(self) -> None:
        scene, _ = self.render("cornell_box", method="gather")
        for name in (*images.BUFFERS, "rsm0.depth", "rsm0.normal", "rsm0.density"):
            with self.subTest(name=name):
                try:
                    values = vtkindirect.copy_buffer(scene.renderer, name)
                except RenderError as error:
                    # Nothing in the scene reflects specularly, so these two are not made.
                    self.assertIn(name, ("glossy", "lobes"), error)
                    continue
                self.assertTrue(np.isfinite(values).all())
        with self.assertRaisesRegex(RenderError, "there is no buffer 'rsm7.depth'"):
            vtkindirect.copy_buffer(scene.renderer, "rsm7.depth")

    def test_larger_than_the_driver(self) -> None:
        scene = load_scene(support.SCENES / "two_planes.json")
        window = vtkindirect.render_window((8, 8), offscreen=True)
        self.addCleanup(window.Finalize)
        windows.start(window)
        with self.assertRaisesRegex(UsageError, "this OpenGL driver goes up to"):
            windows.check_size(window, (10**6, 8))
        self.assertIsNone(scene.render_window)


@pytest.mark.parametrize("method", ["gather", "multiresolution", "hints", "reference"])
def test_an_estimator_alone_draws_the_whole_frame(method: str) -> None:
    """As a renderer's pass it is the illumination pass with that estimator."""
    if WHY_NOT:
        pytest.skip(WHY_NOT)
    pictures = []
    for how in ("off", "estimator", "illumination"):
        scene = load_scene(support.SCENES / "cornell_box.json")
        window = frames.open_window(scene, (64, 48))
        estimator = wrapped.get(METHODS[method].estimator)()
        if method == "hints":
            estimator.SetGridResolution(6, 6, 6)  # what is compared needs no more
        if how == "estimator":
            scene.renderer.SetPass(estimator)
        elif how == "illumination":
            illumination = vtkindirect.vtkIndirectIlluminationPass()
            illumination.SetEstimator(estimator)
            scene.renderer.SetPass(illumination)
        window.Render()
        pictures.append(images.window_bytes(window).astype(int))
        scene.renderer.SetPass(None)
        window.Finalize()
    off, alone, whole = pictures
    np.testing.assert_array_equal(alone, whole)
    # Half of what was measured: light that bounces changes this picture by a fifth and more.
    assert np.abs(alone - off).mean() > 0.1 * off.mean()
