# SPDX-License-Identifier: BSD-3-Clause
"""Sweep files and the command that measures speed against error."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
import unittest
from typing import Any
from unittest import mock

import numpy as np
from support import DirectoryTest, command_line, small_scene, why_no_rendering
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from vtkindirect import (
    RenderError,
    UsageError,
    compare,
    compare_page,
    compare_plot,
    frames,
    load_scene,
    methods,
    metrics,
    orbit,
    reference_environment,
    references,
    sweep,
    wrapped,
)
from vtkindirect.compare import difference_image


def sweep_of(*rows: dict[str, Any]) -> dict[str, Any]:
    """A sweep document with these rows."""
    return {"schema": sweep.SCHEMA, "rows": list(rows)}


class SweepFile(DirectoryTest):
    """Lists are expanded; mistakes are named."""

    def load(self, content: Any) -> list[sweep.Row]:
        """Write a sweep file and load its rows."""
        return sweep.load(self.write("sweep.json", content)).rows

    def test_lists_make_every_combination(self) -> None:
        rows = self.load(
            sweep_of({"method": "gather", "settings": {"A": [1, 2], "B": True, "C": ["x", "y"]}})
        )
        self.assertEqual([row.settings["A"] for row in rows], [1, 1, 2, 2])
        self.assertEqual([row.settings["C"] for row in rows], ["x", "y", "x", "y"])
        self.assertTrue(all(row.settings["B"] is True for row in rows))
        self.assertEqual(rows[1].label, "gather A=1 C=y")
        self.assertEqual(len({row.key() for row in rows}), 4)

    def test_mistakes_name_the_key(self) -> None:
        cases = (
            (sweep_of({"method": "gather", "setting": {}}), "rows[0].setting"),
            (sweep_of({"settings": {}}), "rows[0].method"),
            (sweep_of({"method": "gather", "settings": {"A": []}}), "rows[0].settings.A"),
            (sweep_of({"method": "gather"}, {"method": "gather"}), "called 'gather'"),
            ({"schema": sweep.SCHEMA, "rows": []}, "rows"),
            ({"schema": "other", "rows": [1]}, "schema"),
            ({**sweep_of({"method": "gather"}), "extra": 1}, "extra"),
            ({**sweep_of({"method": "gather"}), "flicker": 1}, "flicker"),
            ({**sweep_of({"method": "gather"}), "path_tracer": [4]}, "path_tracer"),
            ({**sweep_of({"method": "gather"}), "path_tracer": {"two": [4]}}, "path_tracer.two"),
            (
                {**sweep_of({"method": "gather"}), "path_tracer": {"one_bounce": [4, 8]}},
                "path_tracer.one_bounce: must be squares",
            ),
            ([], "JSON object"),
        )
        for content, expected in cases:
            with self.assertRaises(UsageError) as caught:
                self.load(content)
            self.assertIn(expected, str(caught.exception))


    def test_what_else_a_sweep_says(self) -> None:
        path = self.write("sweep.json", sweep_of({"method": "gather"}))
        self.assertFalse(sweep.load(path).flicker)
        self.assertEqual(sweep.load(path).path_tracer, sweep.PATH_TRACER)
        content = {
            **sweep_of({"method": "gather"}),
            "flicker": True,
            "path_tracer": {"all_bounces": [16, 4]},
        }
        found = sweep.load(self.write("sweep.json", content))
        self.assertTrue(found.flicker)
        self.assertEqual(found.path_tracer, {"one_bounce": [], "all_bounces": [4, 16]})

    def test_methods_that_are_not_built_are_rows(self) -> None:
        rows = self.load(sweep_of({"method": "a method to come", "settings": {"A": [1, 2]}}))
        self.assertEqual([row.method for row in rows], ["a method to come"] * 2)


class DifferenceImage(unittest.TestCase):
    """Red where too bright, blue where too dark, white where right."""

    def test_colours(self) -> None:
        reference = np.ones((1, 3, 3))
        image = reference * np.array([1.0, 1.6, 0.4]).reshape(1, 3, 1)
        shown = difference_image(image, reference)
        self.assertTrue((shown[0, 0] == 1.0).all())
        self.assertGreater(shown[0, 1, 0], shown[0, 1, 2] + 0.5)
        self.assertGreater(shown[0, 2, 2], shown[0, 2, 0] + 0.5)


class SmallerReferences(unittest.TestCase):
    """A stored reference's pixels are the centres of blocks of the image's."""

    def test_the_same_points_are_compared(self) -> None:
        centre = np.zeros((9, 9), dtype=bool)
        centre[1::3, 1::3] = True
        image = np.where(centre, 2.0, 77.0)[..., np.newaxis].repeat(3, axis=-1)
        held = references.References(centre, {"R1": image, "R2": np.full((3, 3, 3), 2.0)})
        pairs = dict(held.pairs(image))
        self.assertTrue((pairs["R2"][0] == 2.0).all() and pairs["R2"][2].all())
        errors = held.errors(image)
        self.assertEqual((errors["R1"].nrmse, errors["R2"].nrmse), (0.0, 0.0))


class Plot(DirectoryTest):
    """Which points stand where."""

    ROWS = (
        {"label": "vtk", "method": "vtk", "frame_ms": 2.0, "relmse_r2": 1.0},
        {"label": "gather N=64", "method": "gather", "indirect_ms": 20.0, "relmse_r2": 0.1},
        {"label": "gather N=16", "method": "gather", "indirect_ms": 10.0, "relmse_r2": 0.3},
        {"label": "mitsuba one bounce 4 spp", "method": "mitsuba", "indirect_ms": 30.0,
         "relmse_r2": 0.2, "relmse_r3": 0.4},
        {"label": "gather N=1", "method": "gather", "error": "failed", "indirect_ms": None},
    )

    def test_series(self) -> None:
        found = {one.name: one for one in compare_plot.series(self.ROWS, "r2")}
        self.assertEqual(
            found["gather"].points, [(10.0, 0.3, "16"), (20.0, 0.1, "64")]
        )
        self.assertEqual(found["mitsuba one bounce"].points, [(30.0, 0.2, "4")])
        self.assertEqual(compare_plot.series(self.ROWS, "r1"), [])
        # One bounce does not converge to R3.
        self.assertEqual(compare_plot.series(self.ROWS, "r3"), [])

    def test_nothing_to_draw_is_no_file(self) -> None:
        path = self.directory / "plot.png"
        rows = [{"scene": "s", "width": 1, "height": 1, **row} for row in self.ROWS]
        self.assertFalse(compare_plot.draw(rows[:1], path))
        self.assertFalse(path.exists())
        self.assertTrue(compare_plot.draw(rows, path))
        self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))


class Page(unittest.TestCase):
    """What is left out or failed is said; what is a number is one."""

    def test_left_out_and_failed(self) -> None:
        common = {"scene": "s", "width": 3, "height": 3, "frames": 10, "vtk": "9",
                  "missing": {"HDR-FLIP": "of a reason"}}
        rows = [
            {**common, "label": "a", "method": "gather", "error": "", "relmse_r2": 0.25,
             "leak_r2": 0.125},
            {**common, "label": "b|c", "method": "gather", "error": "it broke <here>"},
        ]
        for text in (compare_page._markdown(rows, {}), compare_page._html(rows, {})):
            self.assertIn("Left out: HDR-FLIP, because of a reason.", text)
            self.assertIn("0.2500", text)
            self.assertIn("12.50 %", text)
            self.assertNotIn("FLIP R1", text)
        self.assertIn("failed: it broke <here>", compare_page._markdown(rows, {}))
        self.assertIn("b\\|c", compare_page._markdown(rows, {}))
        self.assertIn("failed: it broke &lt;here&gt;", compare_page._html(rows, {}))


class ReferenceEnvironment(DirectoryTest):
    """Which Python is taken, and what is said when there is none."""

    def test_none_is_left_out_and_a_wrong_name_is_an_error(self) -> None:
        with self.assertRaisesRegex(reference_environment.LeftOut, "asked"):
            reference_environment.find_python("none")
        with self.assertRaisesRegex(UsageError, "is no program"):
            reference_environment.find_python(str(self.directory / "python"))
        with self.assertRaisesRegex(UsageError, "is no program"):
            reference_environment.find_python(str(self.directory))

    def test_variable_and_default(self) -> None:
        python = self.write("python", "")
        python.chmod(0o755)
        variable = reference_environment.VARIABLE
        with mock.patch.dict("os.environ", {variable: str(python)}):
            self.assertEqual(reference_environment.find_python(None), python)
        scenes = self.directory / "Testing" / "Scenes"
        tools = self.directory / "Testing" / "Reference"
        for folder in (scenes, tools):
            folder.mkdir(parents=True)
        (tools / "trace_rows.py").touch()
        with mock.patch.dict("os.environ", {variable: "", "VTKINDIRECT_SCENES": str(scenes)}):
            with self.assertRaisesRegex(reference_environment.LeftOut, "make_environment"):
                reference_environment.find_python(None)
            made = self.directory / "build" / "reference-venv" / "bin"
            made.mkdir(parents=True)
            (made / "python").touch()
            self.assertEqual(reference_environment.find_python(None), made / "python")
            self.assertEqual(reference_environment.tracer_tools(), tools)
            (tools / "trace_rows.py").unlink()
            with self.assertRaisesRegex(reference_environment.LeftOut, "installation"):
                reference_environment.tracer_tools()

    def test_a_python_without_the_packages_is_left_out_with_its_reason(self) -> None:
        python = self.write("python", "#!/bin/sh\necho 'no such module' >&2\nexit 1\n")
        python.chmod(0o755)
        with self.assertRaisesRegex(reference_environment.LeftOut, "no such module"):
            reference_environment.Flip(python)


@unittest.skipIf(why_no_rendering() is not None, f"{why_no_rendering()}")
class Orbit(DirectoryTest):
    """The path of the camera that flicker is measured along."""

    def scene(self, size: tuple[int, int]) -> Any:
        scene = load_scene(self.write("small.json", small_scene()))
        frames.open_window(scene, size)
        self.addCleanup(scene.render_window.Finalize)
        return scene

    def test_how_far_images_are_thinned_out(self) -> None:
        for size, expected in (
            ((768, 768), 3), ((768, 384), 3), ((512, 512), 1), ((64, 48), 1), ((960, 960), 5),
            ((864, 864), 9),
        ):
            self.assertEqual(orbit.factor(size), expected, size)
        image = np.arange(81).reshape(9, 9)
        self.assertEqual(orbit.thin(image, 3).tolist(), [[10, 13, 16], [37, 40, 43], [64, 67, 70]])

    def test_the_camera_turns_and_comes_back(self) -> None:
        scene = self.scene((64, 48))
        camera = scene.renderer.GetActiveCamera()

        def state() -> tuple[Any, ...]:
            return camera.GetPosition(), camera.GetViewUp(), camera.GetClippingRange()

        before = state()
        places = [camera.GetPosition() for _ in orbit._frames(scene)]
        self.assertEqual(len(set(places)), orbit.FRAMES)
        steps = np.linalg.norm(np.diff(np.array(places), axis=0), axis=1)
        radius = np.linalg.norm(np.subtract(before[0], camera.GetFocalPoint()))
        self.assertAlmostEqual(steps.max() / radius, np.radians(orbit.STEP), delta=1e-3)
        self.assertEqual(state(), before)

    def test_the_reference_does_not_flicker_and_changing_lights_do(self) -> None:
        scene = self.scene((96, 96))
        truth = orbit.truth(scene, (96, 96))
        self.assertGreater(metrics.change(truth.frames, truth.masks), 0.0)
        size = orbit.MAP_TEXELS
        methods.enable(scene.renderer, "reference", ReflectiveShadowMapResolution=size)
        itself = orbit.judge(scene, truth)
        self.assertEqual((itself["flicker"], itself["flicker_error"]), (0.0, 0.0))
        # Light that blinks by a tenth changes the image by that from frame to frame.
        light = scene.lights[0]
        blinking = []
        for index, _ in enumerate(orbit._frames(scene)):
            blinking.append(references.images.copy_buffer(scene.renderer, "irradiance"))
            light.SetIntensity(1.1 if index % 2 == 0 else 1.0)
        light.SetIntensity(1.0)
        self.assertGreater(metrics.flicker(blinking, truth.frames, truth.masks), 0.05)


@unittest.skipIf(why_no_rendering() is not None, f"{why_no_rendering()}")
class Command(DirectoryTest):
    """The whole command on a small scene."""

    def compare(self, *words: Any) -> list[dict[str, str]]:
        """Run the comparison; its rows."""
        scene = self.write("small.json", small_scene())
        done = command_line(
            "compare", scene, "-o", self.directory / "report", "--frames", 2,
            "--reference-python", "none", *words,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.said = done.stdout
        table = (self.directory / "report" / "rows.csv").read_text()
        return list(csv.DictReader(io.StringIO(table)))

    def test_rows_errors_and_page(self) -> None:
        path = self.write(
            "sweep.json",
            sweep_of(
                {"method": "reference", "settings": {"ReflectiveShadowMapResolution": 256}},
                {"method": "gather", "settings": {"NumberOfLights": [16, 1024],
                                                  "Interpolation": False}},
            ),
        )
        rows = {row["label"]: row for row in self.compare("--sweep", path)}
        self.assertEqual(
            list(rows),
            ["vtk", "ssao", "reference", "gather NumberOfLights=16", "gather NumberOfLights=1024"],
        )
        # The reference against itself: nothing but the same sum twice.
        self.assertEqual(float(rows["reference"]["nrmse_r1"]), 0.0)
        few, many = (float(rows[f"gather NumberOfLights={n}"]["nrmse_r1"]) for n in (16, 1024))
        self.assertGreater(few, 2.0 * many)
        self.assertGreater(many, 0.0)
        for row in rows.values():
            self.assertEqual(row["error"], "")
            self.assertGreater(float(row["frame_ms"]), 0.0)
        # Having no indirect light is an error of one in these measures.
        self.assertAlmostEqual(float(rows["vtk"]["bias_r1"]), -1.0, places=12)
        self.assertEqual(rows["ssao"]["relmse_r1"], "")
        names = {path.name for path in (self.directory / "report").iterdir()}
        self.assertLessEqual({"index.md", "index.html", "rows.json", "small.png"}, names)
        page = (self.directory / "report" / "index.html").read_text()
        for name in ("HDR-FLIP", "mitsuba"):
            self.assertIn(f"left out: {name}, because it was asked", self.said)
            self.assertIn(f"Left out: {name}, because it was asked", page)
        self.assertIn("left out: R2, because there is no stored reference", self.said)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRWriter"), "vtkIndirectOpenEXR was not built")
    def test_reference_is_a_file_or_its_directory(self) -> None:
        image = vtkImageData()
        image.SetDimensions(32, 24, 1)
        ones = numpy_to_vtk(np.ones((32 * 24, 3), np.float32), deep=True)
        image.GetPointData().SetScalars(ones)
        errors = []
        for place in (self.directory / "small.exr", self.directory / "mine.exr"):
            writer = wrapped.get("vtkOpenEXRWriter")()
            writer.SetInputData(image)
            writer.AddLayer("R2", image)
            writer.SetFileName(str(place))
            writer.Write()
            named = place.parent if place.stem == "small" else place
            row = self.compare("--methods", "gather", "--size", "96x72", "--reference", named)[-1]
            errors.append(row["nrmse_r2"])
            self.assertGreater(float(row["nrmse_r2"]), 0.0)
            self.assertIn("left out: R3, because", self.said)
            shutil.rmtree(self.directory / "report")
        self.assertEqual(*errors)

    def test_flicker_is_measured_when_asked(self) -> None:
        self.assertNotIn("flicker", self.compare("--methods", "gather")[-1])
        row = self.compare("--methods", "gather", "--flicker")[-1]
        self.assertGreater(float(row["change"]), 0.0)
        self.assertLess(abs(float(row["flicker"])), float(row["change"]))

    def test_failing_row_is_a_row_and_the_run_goes_on(self) -> None:
        path = self.write(
            "sweep.json",
            sweep_of(
                {"method": "a method to come"},
                {"label": "wrong", "method": "gather", "settings": {"Colour": "blue"}},
                {"method": "gather", "settings": {"Pattern": "grid"}},
                {"method": "auto", "settings": {"NumberOfLights": 16, "Occupancy": True}},
            ),
        )
        rows = {row["label"]: row for row in self.compare("--sweep", path)}
        self.assertIn("unknown method", rows["a method to come"]["error"])
        self.assertIn("Colour", rows["wrong"]["error"])
        self.assertIn("failed: small, wrong: ", self.said)
        self.assertEqual(rows["gather"]["error"], "")
        self.assertEqual(rows["auto"]["error"], "")
        self.assertLessEqual(int(rows["auto"]["virtual_lights"]), 16)

    def test_an_image_that_cannot_be_judged_is_a_failed_row(self) -> None:
        path = self.write("small.json", small_scene())
        comparison = compare.Comparison(
            sweep.Sweep([sweep.Row("gather", "gather")]), self.directory, frames=1
        )
        for error in (metrics.MetricError("not finite"), RenderError("gone"), KeyError("x")):
            run = compare.Run(comparison, load_scene(path))
            with mock.patch.object(run, "_judge", side_effect=error):
                results = run.run(lambda _what: None)
            self.assertEqual([bool(row["error"]) for row in results], [True, False, True])
            self.assertIn(str(error), results[-1]["error"])
            comparison.journal.unlink()
        self.assertIn("KeyError", results[-1]["error"])

    def test_a_path_tracer_that_fails_is_failed_rows(self) -> None:
        scene = load_scene(self.write("small.json", small_scene()))
        python = self.write("python", "#!/bin/sh\necho broken >&2\nexit 3\n")
        python.chmod(0o755)
        what = sweep.Sweep([sweep.Row("gather", "gather")])
        comparison = compare.Comparison(what, self.directory, frames=1, python=python)
        results = {row["label"]: row for row in compare.Run(comparison, scene).run(lambda _: None)}
        self.assertEqual(results["gather"]["error"], "")
        traced = [row for label, row in results.items() if label.startswith("mitsuba")]
        self.assertEqual(len(traced), len(sweep.PATH_TRACER["one_bounce"]))
        for row in traced:
            self.assertIn("the path tracer failed", row["error"])
            self.assertIn("exit code 3", row["error"])
        # Without a stored R3 nobody knows how many bounces all of them are.
        self.assertIn("no record", results["gather"]["missing"]["mitsuba all bounces"])

    def test_finished_rows_are_not_run_again(self) -> None:
        self.compare("--methods", "gather")
        journal = self.directory / "report" / "rows.jsonl"
        before = journal.read_text()
        # A line cut short by a run that was stopped is ignored.
        journal.write_text(before + '{"key": "cut')
        self.compare("--methods", "gather")
        self.assertEqual(journal.read_text(), before + '{"key": "cut')
        for line in before.splitlines():
            self.assertIn("result", json.loads(line))

    def test_wrong_words_are_one_line(self) -> None:
        scene = self.write("small.json", small_scene())
        exr = self.write("bad.exr", "no picture")
        for words, expected in (
            ((scene, "--methods", "gathr"), "gather"),
            ((scene, "--sweep", self.directory / "none.json"), "none.json"),
            ((self.directory / "a.vtp",), "a.vtp"),
            ((scene, "--reference", self.directory / "none"), "none: no such file or directory"),
            ((scene, "--reference", scene), "is neither an .exr file nor a directory of them"),
            ((scene, scene, "--reference", exr), "one file is for one scene, not 2"),
            ((scene, "--reference", exr), "bad.exr: "),
            ((scene, "--reference-python", self.directory / "py"), "--reference-python"),
            ((scene, "-o", self.directory / "no" / "report"), "no"),
        ):
            done = command_line("compare", *words, "-o", self.directory / "r") if "-o" not in [
                str(w) for w in words
            ] else command_line("compare", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(expected, done.stderr)
