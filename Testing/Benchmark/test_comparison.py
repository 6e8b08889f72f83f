# SPDX-License-Identifier: BSD-3-Clause
"""The whole comparison: flicker, plots, the page, the reference environment, the program."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
import unittest
from typing import Any
from unittest import mock

import numpy as np
from vtkindirect import UsageError, frames, load_scene, methods, metrics, references, sweep

import comparison
import orbit
import page
import plot
import publish
import reference_environment
import support
from support import DirectoryTest, noise, small_scene, sweep_of, why_no_rendering


def program_here(*words: Any) -> subprocess.CompletedProcess[str]:
    """Run the program in this process, which need not load VTK again."""
    return support.command_line_here("compare", *words, comparison=comparison.run)


def program(*words: Any) -> subprocess.CompletedProcess[str]:
    """Run the program in a process of its own."""
    return subprocess.run(
        [sys.executable, "-B", comparison.__file__, *map(str, words)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip


class Flicker(unittest.TestCase):
    """Change from frame to frame beyond the reference's own."""

    def test_moving_reference_is_no_flicker(self) -> None:
        frames = [1.0 + noise((20, 20), seed) for seed in range(4)]
        self.assertAlmostEqual(orbit.flicker(frames, frames), 0.0, places=14)

    def test_alternating_image(self) -> None:
        references = [np.ones((20, 20))] * 4
        images = [np.full((20, 20), 1.0 + 0.1 * (i % 2)) for i in range(4)]
        self.assertAlmostEqual(orbit.flicker(images, references), 0.1, places=12)

    def test_one_frame_is_an_error(self) -> None:
        with self.assertRaises(metrics.MetricError):
            orbit.flicker([np.ones((2, 2))], [np.ones((2, 2))])


class ErrorFlicker(unittest.TestCase):
    """Change of the error from frame to frame."""

    def test_moving_reference_and_constant_error_are_none(self) -> None:
        frames = [1.0 + noise((20, 20), seed) for seed in range(4)]
        self.assertEqual(orbit.error_flicker(frames, frames), 0.0)
        brighter = [frame + 0.25 for frame in frames]
        self.assertAlmostEqual(orbit.error_flicker(brighter, frames), 0.0, places=14)

    def test_what_flicker_lets_cancel_counts(self) -> None:
        references = [np.ones((2, 20)) for _ in range(4)]
        images = [np.ones((2, 20)) for _ in range(4)]
        for i in range(4):
            references[i][0] += 0.1 * (i % 2)  # one half of the truth changes,
            images[i][1] += 0.1 * (i % 2)  # the other half of the image
        self.assertAlmostEqual(orbit.flicker(images, references), 0.0, places=14)
        expected = 3 * 0.1 / sum(float(image.mean()) for image in references[:3])
        self.assertAlmostEqual(orbit.error_flicker(images, references), expected, places=14)

    def test_one_frame_is_an_error(self) -> None:
        with self.assertRaises(metrics.MetricError):
            orbit.error_flicker([np.ones((2, 2))], [np.ones((2, 2))])


class Change(unittest.TestCase):
    """Change from frame to frame, whatever its cause."""

    def test_alternating_image(self) -> None:
        images = [np.full((20, 20), 1.0 + 0.1 * (i % 2)) for i in range(4)]
        self.assertAlmostEqual(orbit.change(images), 0.1 / 1.05, places=12)
        self.assertEqual(orbit.change(images[:1] * 3), 0.0)

    def test_mask_of_both_frames_counts(self) -> None:
        images = [np.ones((4, 4)), np.ones((4, 4))]
        images[1][:2] = 3.0
        below = np.zeros((4, 4), dtype=bool)
        below[2:] = True
        everywhere = np.ones((4, 4), dtype=bool)
        self.assertEqual(orbit.change(images, [everywhere, below]), 0.0)
        self.assertGreater(orbit.change(images, [everywhere, everywhere]), 0.4)

    def test_one_frame_is_an_error(self) -> None:
        with self.assertRaises(metrics.MetricError):
            orbit.change([np.ones((2, 2))])


class DifferenceImage(unittest.TestCase):
    """Red where too bright, blue where too dark, white where right."""

    def test_colours(self) -> None:
        reference = np.ones((1, 3, 3))
        image = reference * np.array([1.0, 1.6, 0.4]).reshape(1, 3, 1)
        shown = comparison.difference_image(image, reference)
        self.assertTrue((shown[0, 0] == 1.0).all())
        self.assertGreater(shown[0, 1, 0], shown[0, 1, 2] + 0.5)
        self.assertGreater(shown[0, 2, 2], shown[0, 2, 0] + 0.5)


class Plot(DirectoryTest):
    """Points of a plot and their places."""

    ROWS = (
        {"label": "vtk", "method": "vtk", "frame_ms": 2.0, "relmse_r2": 1.0},
        {"label": "gather N=64", "method": "gather", "indirect_ms": 20.0, "relmse_r2": 0.1},
        {"label": "gather N=16", "method": "gather", "indirect_ms": 10.0, "relmse_r2": 0.3},
        {"label": "mitsuba one bounce 4 spp", "method": "mitsuba", "indirect_ms": 30.0,
         "relmse_r2": 0.2, "relmse_r3": 0.4},
        {"label": "gather N=1", "method": "gather", "error": "failed", "indirect_ms": None},
    )

    def test_series(self) -> None:
        found = {one.name: one for one in plot.series(self.ROWS, "r2")}
        self.assertEqual(
            found["gather"].points, [(10.0, 0.3, "16"), (20.0, 0.1, "64")]
        )
        self.assertEqual(found["mitsuba one bounce"].points, [(30.0, 0.2, "4")])
        self.assertEqual(plot.series(self.ROWS, "r1"), [])
        # One bounce does not converge to R3.
        self.assertEqual(plot.series(self.ROWS, "r3"), [])

    def test_no_two_methods_look_alike(self) -> None:
        self.assertEqual(len(set(plot.looks(100))), 100)

    def test_nothing_to_draw_is_no_file(self) -> None:
        path = self.directory / "plot.png"
        rows = [{"scene": "s", "width": 1, "height": 1, **row} for row in self.ROWS]
        self.assertFalse(plot.draw(rows[:1], path))
        self.assertFalse(path.exists())
        self.assertTrue(plot.draw(rows, path))
        self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))


class Page(unittest.TestCase):
    """Pages name the rows that are left out or failed; numbers are numbers."""

    def test_left_out_and_failed(self) -> None:
        common = {"scene": "s", "width": 3, "height": 3, "frames": 10, "vtk": "9",
                  "missing": {"HDR-FLIP": "of a reason"}}
        rows = [
            {**common, "label": "a", "method": "gather", "error": "", "relmse_r2": 0.25,
             "leak_r2": 0.125},
            {**common, "label": "b|c", "method": "gather", "error": "it broke <here>"},
        ]
        for text in (page._markdown(rows, {}), page._html(rows, {})):
            self.assertIn("Left out: HDR-FLIP, because of a reason.", text)
            self.assertIn("0.2500", text)
            self.assertIn("12.50 %", text)
            self.assertNotIn("FLIP R3", text)
        self.assertNotIn("over SSAO", page._markdown(rows, {}))
        rows[0] |= {"added_over_ssao": 1.25, "added_processor_over_ssao": 0.75}
        text = page._markdown(rows, {})
        self.assertIn("of a GPU's work it says nothing", text)
        self.assertIn("| adds, over SSAO |", text)
        self.assertIn("| 0.75 |", text)
        self.assertIn("failed: it broke <here>", page._markdown(rows, {}))
        self.assertIn("b\\|c", page._markdown(rows, {}))
        self.assertIn("failed: it broke &lt;here&gt;", page._html(rows, {}))


class WhatTheTextNames(unittest.TestCase):
    """Sentences of a page about its rows."""

    def test_rows_that_are_worse_than_nothing(self) -> None:
        def row(label: str, method: str, error: float | None) -> dict[str, Any]:
            return {"label": label, "method": method, "relmse_r3": error}

        rows = [row("vtk", "vtk", 0.9), row("default", "auto", 0.5), row("bad", "gather", 1.5)]
        said = page.worse_than_nothing(rows)
        self.assertIn("bad. The default is not one of them.", said)
        rows[1]["relmse_r3"] = 1.0
        self.assertIn("default; bad. The default is one of them.", page.worse_than_nothing(rows))
        self.assertNotIn("default", page.worse_than_nothing([rows[0], rows[2]]))
        self.assertIn("No row", page.worse_than_nothing([rows[0]]))
        self.assertEqual(page.worse_than_nothing([row("vtk", "vtk", None)]), "")

    def test_masked_share_and_the_pixels_of_r1(self) -> None:
        surfaces = np.ones((4, 4), dtype=bool)
        surfaces[0] = False
        receivers = np.zeros((4, 4), dtype=bool)
        receivers[1:, :3] = True
        flat = np.ones((4, 4, 3))
        held = references.References(receivers, {"R1": flat, "R2": flat}, {}, surfaces)
        self.assertAlmostEqual(held.masked_share(), 1 / 4)
        image = flat.copy()
        image[1:, 3] = 3.0  # at a silhouette
        errors = held.errors({"irradiance": image})
        self.assertEqual(errors["R2"].nrmse, 0.0)
        self.assertAlmostEqual(errors["R1"].nrmse, (4 * 3 / 12) ** 0.5)

    def test_rows_of_several_runs_are_not_published(self) -> None:
        rows = [{"commit": "a", "gl": "x"}, {"commit": "a", "gl": ""}]
        self.assertEqual(publish.mixed(rows), "")
        self.assertIn("commit is a and b", publish.mixed([*rows, {"commit": "b"}]))

    def test_paper_against_ours(self) -> None:
        def row(label: str, error: float, **settings: Any) -> dict[str, Any]:
            return {"scene": "s", "method": "hints", "label": label, "relmse_r3": error,
                    "indirect_ms": 1.0, "settings": settings}  # fmt: skip

        text = publish.equals([
            row("paper 2", 3.0, Preset="paper", NumberOfBounces=2, NumberOfSamples=50),
            row("paper 4", 9.0, Preset="paper", NumberOfBounces=4),
            row("ours 2", 1.5, NumberOfBounces=2, Order=2),
        ])  # fmt: skip
        self.assertIn("| s | paper 2 | ours 2 | 3.0000 | 1.5000 | 2.0 | 1.0 | 1.0 |", text)
        self.assertNotIn("paper 4", text)

    def test_at_a_glance(self) -> None:
        def row(label: str, method: str, error: float, **times: float) -> dict[str, Any]:
            return {"scene": "s", "method": method, "label": label, "relmse_r3": error,
                    "bias_r3": -0.25, **times}  # fmt: skip

        rows = [
            row("vtk", "vtk", 1.0, processor_ms=10.0),
            row("default", "auto", 0.02, processor_ms=30.0, frame_ms=20.0,
                added_processor_over_ssao=1.5),
            row("mitsuba all bounces 4 spp", "mitsuba", 0.5, indirect_ms=100.0),
            row("mitsuba all bounces denoised 4 spp", "mitsuba", 0.02, indirect_ms=300.0),
            row("mitsuba all bounces 64 spp", "mitsuba", 0.01, indirect_ms=900.0),
        ]  # fmt: skip
        expected = "| s | 10 |  | 1.50 | 0.020, -25 % |  |  |  |  | 0.3 | 15.0 |"
        self.assertIn(expected, publish.at_a_glance(rows))
        # No row of the path tracer has the default's error.
        self.assertIn("| > 0.3 | > 15.0 |", publish.at_a_glance(rows[:2] + rows[2:4][:1] + [
            row("mitsuba all bounces denoised 4 spp", "mitsuba", 0.03, indirect_ms=300.0)]))
        self.assertIn("|  |  |\n\nWhere the path tracer wins", publish.at_a_glance(rows[:2]))
        # 300 ms are later than the default's frame of 20 ms, and sooner than its first of 400 ms.
        rows[1]["first_ms"] = 400.0
        text = publish.at_a_glance(rows)
        self.assertIn("frame ends in: none of these scenes; before", text)
        self.assertIn("is there in: s. Its least relMSE, whatever the time, is below the default's in: s.", text)


class LightFromTheSky(unittest.TestCase):
    """The table of frames under a sky."""

    def test_time_and_error_are_in_one_row(self) -> None:
        common = {"scene": "s", "error": ""}
        rows = [
            {**common, "label": "vtk", "method": "vtk", "frame_ms": 10.0, "nrmse_s1": 1.0},
            {**common, "label": "ssao", "method": "ssao", "frame_ms": 110.0},
            {**common, "label": "moving", "method": "auto", "pace": "moving", "frame_ms": 80.0,
             "indirect_ms": 50.0, "added_over_ssao": 0.7, "added_processor_over_ssao": 0.5,
             "sky_over_ssao": 0.25, "first_ms": 900.0, "nrmse_s1": 0.125, "bias_s1": -0.01,
             "relmse_s1": 0.02, "nrmse_s3": 0.25, "bias_s3": -0.1, "relmse_s3": 0.05},
            {**common, "label": "still", "method": "auto", "pace": "still", "error": "a | b"},
        ]
        lines = publish.light_from_the_sky(rows).splitlines()
        self.assertIn(
            "| s | moving | 80 | 50 | 0.70 | 0.50 | 0.25 | 900 | 0.125 | -0.010 | 0.0200 | 0.250 | -0.100 "
            "| 0.0500 |",
            lines,
        )
        self.assertIn("| s | vtk | 10 |  |  |  |  |  | 1.000 |  |  |  |  |  |", lines)
        self.assertTrue(lines[-1].startswith("| s | still | failed: a \\| b |"))
        self.assertFalse(any(line.startswith("| s | ssao") for line in lines))

    def test_the_page_says_what_judges(self) -> None:
        for kind, buffer in (("S", "sky"), ("A", "area")):
            row = {"scene": "s", "width": 3, "height": 3, "frames": 10, "vtk": "9", "missing": {},
                   "label": "moving", "method": "auto", "pace": "moving", "error": "",
                   f"nrmse_{kind.lower()}1": 0.5, f"nrmse_{kind.lower()}3": 0.25,
                   "masked_share": 0.5}  # fmt: skip
            text = page._markdown([row], {})
            self.assertIn(f"{kind}3 | ![{kind}3](s-{kind}3.png)", text)
            self.assertIn(f"{kind}1 and {kind}3 leave out 50.0 %", text)
            self.assertIn(f"(buffer {buffer})", text)
            self.assertIn("| moving |", text)
            self.assertNotIn("R1", text)


class ReferenceEnvironment(DirectoryTest):
    """Choice of the Python, and the error without one."""

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
        with mock.patch.dict("os.environ", {variable: ""}):
            with mock.patch.object(reference_environment, "SOURCES", self.directory / "Testing"):
                with self.assertRaisesRegex(reference_environment.LeftOut, "make_environment"):
                    reference_environment.find_python(None)
                made = self.directory / "build" / "reference-venv" / "bin"
                made.mkdir(parents=True)
                (made / "python").touch()
                self.assertEqual(reference_environment.find_python(None), made / "python")

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
        self.assertGreater(orbit.change(truth.frames, truth.masks), 0.0)
        size = orbit.MAP_TEXELS
        methods.enable(scene.renderer, "reference", ReflectiveShadowMapResolution=size)
        itself = orbit.judge(orbit.frames(scene, truth.factor), truth)
        self.assertEqual((itself["flicker"], itself["flicker_error"]), (0.0, 0.0))
        # Light that blinks by a tenth changes the image by that from frame to frame.
        light = scene.lights[0]
        blinking = []
        for index, _ in enumerate(orbit._frames(scene)):
            blinking.append(references.images.copy_buffer(scene.renderer, "irradiance"))
            light.SetIntensity(1.1 if index % 2 == 0 else 1.0)
        light.SetIntensity(1.0)
        self.assertGreater(orbit.flicker(blinking, truth.frames, truth.masks), 0.05)


@unittest.skipIf(why_no_rendering() is not None, f"{why_no_rendering()}")
class Command(DirectoryTest):
    """The whole command on a small scene."""

    def compare(self, *words: Any) -> list[dict[str, str]]:
        """Run the comparison; its rows."""
        scene = self.write("small.json", small_scene())
        with mock.patch.object(references, "REFINEMENTS", 1):
            done = program_here(
                scene, "-o", self.directory / "report", "--frames", 2, "--reference-python", "none",
                *words,
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
                {"method": "gather", "sampler": "uniform",
                 # R1 is of one bounce.
                 "settings": {"NumberOfLights": [16, 1024], "NumberOfBounces": 1,
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
        # None is stored, so that the default method has made them; nothing hides anything here.
        self.assertIn("small: references are refined pictures of the default method", self.said)
        self.assertLess(float(rows["reference"]["nrmse_r2"]), 0.02)

    def test_times_alone_beside_those_of_ssao(self) -> None:
        path = self.write(
            "sweep.json",
            {
                **sweep_of({"label": "moving", "method": "auto", "pace": "moving"}),
                "flicker": True,
                "moving": ["moving"],
            },
        )
        with mock.patch.object(frames, "WARM_UP_FRAMES", 2):
            rows = {row["label"]: row for row in self.compare("--sweep", path, "--reference", "none")}
        plain, occluded, moving = (rows[label] for label in ("vtk", "ssao", "moving"))
        for time, added in (("frame_ms", "added"), ("processor_ms", "added_processor")):
            of_ssao, of_moving = (
                float(row[time]) - float(plain[time]) for row in (occluded, moving)
            )
            self.assertAlmostEqual(float(moving[f"{added}_ms"]), of_moving, places=9)
            if of_ssao > 0.0:  # in pictures as small as this one load decides
                self.assertAlmostEqual(
                    float(moving[f"{added}_over_ssao"]), of_moving / of_ssao, places=9
                )
        self.assertFalse([name for name in moving if name.endswith("_r1")])
        self.assertGreater(float(moving["moving_ms"]), 0.0)
        self.assertEqual(plain["moving_ms"], "")
        for name in ("errors", "flicker"):
            self.assertIn(f"left out: {name}, because times alone were asked for", self.said)
        self.assertTrue((self.directory / "report" / "index.html").exists())

    def test_flicker_is_measured_when_asked(self) -> None:
        # R1 is of one bounce: flicker is over its mean, and change over the picture's own.
        path = self.write(
            "sweep.json", sweep_of({"method": "gather", "settings": {"NumberOfBounces": 1}})
        )
        row = self.compare("--sweep", path, "--flicker")[-1]
        self.assertGreater(float(row["change"]), 0.0)
        self.assertLess(abs(float(row["flicker"])), float(row["change"]))

    def test_flicker_of_other_scenes(self) -> None:
        sweep = {**sweep_of({"method": "gather"}), "flicker_scenes": ["room"]}
        row = self.compare("--sweep", self.write("sweep.json", sweep), "--flicker")[-1]
        self.assertEqual(row.get("flicker", ""), "")
        self.assertIn("left out: flicker, because the sweep has it in other scenes: room", self.said)

    def test_the_command_of_the_package_runs_it_where_it_is_needed(self) -> None:
        scene = self.write("small.json", small_scene())
        done = support.command_line(
            "compare", scene, "--flicker", "-o", self.directory / "report", "--frames", 2,
            VTKINDIRECT_SCENES=str(support.SCENES),
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((self.directory / "report" / "index.html").exists())

    def test_a_path_tracer_that_fails_is_failed_rows(self) -> None:
        scene = load_scene(self.write("small.json", small_scene()))
        python = self.write("python", "#!/bin/sh\necho broken >&2\nexit 3\n")
        python.chmod(0o755)
        what = sweep.Sweep([sweep.Row("gather", "gather")])
        wanted = comparison.Comparison(what, self.directory, frames=1, python=python)
        # The program that fails needs no LLVM; without a name one would be looked for.
        with mock.patch.dict("os.environ", {"DRJIT_LIBLLVM_PATH": str(python)}):
            rows = comparison.Run(wanted, scene).run(what.rows, lambda _: None)
        results = {row["label"]: row for row in rows}
        self.assertEqual(results["gather"]["error"], "")
        traced = [row for label, row in results.items() if label.startswith("mitsuba")]
        self.assertEqual(len(traced), len(sweep.PATH_TRACER["one_bounce"]))
        for row in traced:
            self.assertIn("the path tracer failed", row["error"])
            self.assertIn("exit code 3", row["error"])
        # A stored R3 would say how many bounces all of them are.
        self.assertIn("no record", results["gather"]["missing"]["mitsuba all bounces"])

    def test_traced_images_are_denoised(self) -> None:
        scene = load_scene(self.write("small.json", small_scene()))
        what = sweep.Sweep([], path_tracer={"one_bounce": [4], "all_bounces": []})
        denoiser = mock.Mock()
        denoiser.denoised.side_effect = lambda image, normal: (image + np.abs(normal), 0.25)
        wanted = comparison.Comparison(
            what, self.directory, frames=1, python=self.directory, denoiser=denoiser
        )
        shape = (scene.size[1], scene.size[0], 3)
        traced = [comparison.Traced("0", np.ones(shape), [0.5])]
        rows = []
        for _ in range(2):  # the second run takes all rows from the journal
            with mock.patch.object(
                comparison.reference_environment, "trace", side_effect=lambda *_: (t for t in traced)
            ):
                run = comparison.Run(wanted, scene)
                rows.append({row["label"]: row for row in run.run(what.rows, lambda _: None)})
            self.assertEqual(denoiser.denoised.call_count, 1)
        raw, clean = (
            rows[0][f"mitsuba one bounce {word}4 spp"] for word in ("", "denoised ")
        )
        self.assertEqual((raw["indirect_ms"], clean["indirect_ms"]), (500.0, 750.0))
        self.assertNotEqual(raw["bias_r1"], clean["bias_r1"])
        self.assertEqual(rows[1], rows[0])

    def test_flicker_of_traced_images(self) -> None:
        # The path of the raw row blinks, the path of the denoised row is the reference itself.
        scene = load_scene(self.write("small.json", small_scene()))
        raw = "mitsuba one bounce 4 spp"
        clean = "mitsuba one bounce denoised 4 spp"
        what = sweep.Sweep([], [raw, clean], {"one_bounce": [4], "all_bounces": []})
        shape = (scene.size[1], scene.size[0], 3)
        frames_of_path = []
        denoiser = mock.Mock()
        denoiser.denoised.side_effect = lambda image, normal, repeats=3: (truth(image), 0.25)
        asked = []

        def truth(image: np.ndarray) -> np.ndarray:
            frame = len(frames_of_path)
            if image.mean() == 0.5 or frame == orbit.FRAMES:
                return image
            frames_of_path.append(frame)
            return np.repeat(np.repeat(run.truth().frames[frame], factor, axis=0), factor, axis=1)

        def trace(_python: Any, _scene: Any, _size: Any, rows: list[dict[str, Any]]) -> Any:
            asked.extend(rows)
            for index, row in enumerate(rows):
                value = 1.0 + index % 2 if "azimuth" in row else 0.5
                yield comparison.Traced(row["name"], np.full(shape, value), [0.5])

        wanted = comparison.Comparison(
            what, self.directory, frames=1, python=self.directory, denoiser=denoiser
        )
        factor = orbit.factor(scene.size)
        with mock.patch.object(comparison.reference_environment, "trace", side_effect=trace):
            run = comparison.Run(wanted, scene)
            rows = {row["label"]: row for row in run.run(what.rows, lambda _: None)}
        self.assertEqual([row.get("azimuth") for row in asked], [*orbit.ANGLES, None])
        self.assertGreater(rows[raw]["flicker"], 0.5)
        self.assertEqual(rows[clean]["flicker_error"], 0.0)

    def test_finished_rows_are_not_run_again(self) -> None:
        self.assertNotIn("flicker", self.compare("--methods", "gather")[-1])
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
        done = program(scene, "--reference-python", self.directory / "py", "-o", self.directory)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertIn("--reference-python", done.stderr)
