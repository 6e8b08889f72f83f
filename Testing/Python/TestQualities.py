# SPDX-License-Identifier: BSD-3-Clause
"""Words for how long a picture may take: the settings that they stand for, and their errors."""

import json
import unittest
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from rooms import make_actor, make_ball, make_room
from vtkindirect import UsageError, images, methods, qualities, screenshot, windows, wrapped

WHY_NOT = support.why_no_rendering()
LIGHTS, TOLERANCE = 64, 0.2  # of a draft


def values(indirect: Any) -> tuple[int, float, int]:
    """Return what the words set."""
    lights = indirect.GetActiveSampler().GetNumberOfLights()
    return lights, indirect.GetErrorTolerance(), int(indirect.GetMapsFirst())


@unittest.skipUnless(
    wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
)
class Settings(unittest.TestCase):
    def test_words(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer)
        before = values(indirect)
        for name, expected in (
            ("draft", (LIGHTS, TOLERANCE, 0)),
            ("interactive", before),
            ("final", (1024, 0.01, 1)),
            ("draft", (LIGHTS, TOLERANCE, 0)),
        ):
            vtkindirect.enable(renderer, quality=name)
            self.assertEqual(values(indirect), expected)
        vtkindirect.enable(renderer)  # a call that does not name it keeps it
        self.assertEqual(values(indirect), (LIGHTS, TOLERANCE, 0))
        vtkindirect.enable(renderer, quality="interactive")
        self.assertEqual(values(indirect), before)

    def test_settings_of_a_call_hold(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, quality="draft", number_of_lights=100)
        self.assertEqual(values(indirect), (100, TOLERANCE, 0))
        vtkindirect.enable(renderer, quality="final", ErrorTolerance=0.05)
        self.assertEqual(values(indirect), (100, 0.05, 1))
        vtkindirect.enable(renderer, quality="interactive")
        self.assertEqual(values(indirect), (100, 0.05, 0))

    def test_values_that_somebody_has_set_hold(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, quality="draft")
        indirect.SetErrorTolerance(0.07)
        vtkindirect.enable(renderer, quality="final")
        self.assertEqual(values(indirect), (1024, 0.07, 1))

    def test_other_methods_and_samplers(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, quality="draft")
        for method in ("gather", "splatting", "multiresolution"):
            vtkindirect.enable(renderer, method)
            self.assertEqual(values(indirect), (LIGHTS, TOLERANCE, 0))
        vtkindirect.enable(renderer, "gather", "uniform")
        self.assertEqual(values(indirect), (LIGHTS, TOLERANCE, 0))
        vtkindirect.enable(renderer, "gather", "uniform", quality="interactive")
        fresh = wrapped.get("vtkUniformLightSampler")().GetNumberOfLights()
        self.assertEqual(values(indirect), (fresh, 0.0, 0))
        vtkindirect.enable(renderer, "hints", quality="draft")
        self.assertEqual(indirect.GetErrorTolerance(), TOLERANCE)
        # The lights of a method as published are its own.
        vtkindirect.enable(renderer, "splatting", preset="paper")
        self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 768)

    def test_mistakes(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer, quality="draft")
        for words, expected in (
            ({"quality": "finale"}, "unknown quality 'finale' (did you mean 'final'?); known: "),
            ({"quality": 3}, "quality must be text, not 3"),
            ({"quality": None}, "quality must be text, not None"),
            ({"quality": "final", "number_of_lihgts": 3}, "unknown property"),
            ({"quality": "final", "number_of_lights": -3}, "out of range"),
        ):
            with self.subTest(words=words), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(renderer, **words)
            self.assertIn(expected, str(caught.exception))
            self.assertEqual(values(indirect), (LIGHTS, TOLERANCE, 0))
        with self.assertRaisesRegex(UsageError, "method 'off' has no property 'quality'"):
            vtkindirect.enable(renderer, "off", quality="draft")

    def test_the_benchmark_measures_these(self) -> None:
        path = support.TESTING / "Benchmark" / "quality.json"
        rows = json.loads(path.read_text(encoding="utf-8"))["rows"]
        found = {row["label"]: row.get("settings", {}) for row in rows}
        for name, expected in qualities.QUALITIES.items():
            self.assertEqual(found[name], expected)
            self.assertEqual(found[f"{name}-moving"], expected)


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Pictures(support.DirectoryTest):
    def light(self, method: str = "auto", **words: Any) -> np.ndarray:
        renderer = make_room(make_actor(make_ball()))
        vtkindirect.enable(renderer, method, **words)
        window = windows.render_window((160, 120), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        screenshot(window)
        if words.get("quality"):
            self.assertEqual(vtkindirect.report(renderer)["quality"], words["quality"])
        return images.copy_buffer(renderer, "irradiance")

    def test_errors_are_in_order(self) -> None:
        best = self.light(NumberOfLights=2048, ErrorTolerance=0.002, NumberOfRefinements=0)
        errors = []
        for name in qualities.NAMES:
            error = np.sqrt(np.square(self.light(quality=name) - best).mean()) / best.mean()
            errors.append(float(error))
        print("RMS error over the mean:", dict(zip(qualities.NAMES, errors)))
        self.assertGreater(errors[0], 1.3 * errors[1])
        self.assertGreater(errors[1], 1.3 * errors[2])

    def test_no_word_changes_nothing(self) -> None:
        for method in ("gather", "splatting", "multiresolution", "hints"):
            found = [self.light(method, quality=name) for name in qualities.NAMES]
            for one, other in ((0, 1), (1, 2)):
                self.assertFalse(np.array_equal(found[one], found[other]), (method, one))

    def test_command_line(self) -> None:
        path = self.write("small.json", support.small_scene())
        report = self.directory / "report.json"
        for name in qualities.NAMES:
            result = support.command_line_here(
                "render", path, "--quality", name, "--report", report
            )
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(json.loads(report.read_text())["quality"], name)
        for words, expected in (
            (("--quality", "fina"), "unknown quality 'fina' (did you mean 'final'?)"),
            (("--quality", "final", "--method", "off"), "method 'off' has no property 'quality'"),
        ):
            result = support.command_line_here("render", path, *words, "--report", report)
            self.assertEqual(result.returncode, 2)
            self.assertIn(expected, result.stderr)

    def test_reports_without_enable(self) -> None:
        """A pass that somebody else has put there has no word."""
        renderer = make_room(make_actor(make_ball()))
        renderer.SetPass(vtkindirect.vtkIndirectIlluminationPass())
        window = windows.render_window((40, 30), offscreen=True)
        self.addCleanup(window.Finalize)
        window.AddRenderer(renderer)
        window.Render()
        self.assertNotIn("quality", vtkindirect.report(methods.pass_of(renderer)))
