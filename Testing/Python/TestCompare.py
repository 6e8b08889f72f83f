# SPDX-License-Identifier: BSD-3-Clause
"""Sweep files and the command that measures speed against error."""

from __future__ import annotations

import csv
import io
import shutil
import unittest
from typing import Any
from unittest import mock

import numpy as np
from support import (
    SCENES,
    DirectoryTest,
    command_line,
    command_line_here,
    small_scene,
    sweep_of,
    why_no_rendering,
)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from vtkindirect import (
    RenderError,
    UsageError,
    compare,
    frames,
    images,
    load_scene,
    metrics,
    references,
    sweep,
    wrapped,
)


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
                "path_tracer.one_bounce[1]: must be a square, not 8",
            ),
            (sweep_of({"method": "gather", "pace": "slow"}), "rows[0].pace"),
            ([], "must be an object"),
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
        self.assertIsNone(found.path_traced_scenes)
        self.assertIsNone(found.flicker_scenes)
        content |= {"path_traced_scenes": ["box"], "flicker_scenes": ["room"]}
        found = sweep.load(self.write("sweep.json", content))
        self.assertEqual((found.path_traced_scenes, found.flicker_scenes), (["box"], ["room"]))

    def test_a_pace_is_of_the_row_and_its_key(self) -> None:
        rows = self.load(
            sweep_of(*({"label": pace, "method": "auto", "pace": pace} for pace in frames.PACES))
        )
        self.assertEqual([row.pace for row in rows], list(frames.PACES))
        self.assertEqual(len({row.key() for row in rows}), len(rows))
        (row,) = self.load(sweep_of({"method": "auto"}))
        self.assertIsNone(row.pace)

    def test_methods_that_are_not_built_are_rows(self) -> None:
        rows = self.load(sweep_of({"method": "a method to come", "settings": {"A": [1, 2]}}))
        self.assertEqual([row.method for row in rows], ["a method to come"] * 2)


class SmallerReferences(unittest.TestCase):
    """A stored reference's pixels are the centres of blocks of the image's."""

    def test_the_same_points_are_compared(self) -> None:
        centre = np.zeros((9, 9), dtype=bool)
        centre[1::3, 1::3] = True
        image = np.where(centre, 2.0, 77.0)[..., np.newaxis].repeat(3, axis=-1)
        held = references.References(centre, {"R1": image, "R2": np.full((3, 3, 3), 2.0)})
        seen = {"irradiance": image}
        pairs = dict(held.pairs(seen))
        self.assertTrue((pairs["R2"][0] == 2.0).all() and pairs["R2"][2].all())
        errors = held.errors(seen)
        self.assertEqual((errors["R1"].nrmse, errors["R2"].nrmse), (0.0, 0.0))

    def test_some_judge_the_buffer_of_an_emitter_and_some_everything(self) -> None:
        flat = np.ones((3, 3, 3))
        everywhere = np.ones((3, 3), dtype=bool)
        for one, every, buffer in (("S1", "S3", "sky"), ("A1", "A3", "area")):
            held = references.References(everywhere, {one: flat, every: 2.0 * flat})
            self.assertEqual(held.main, every)
            self.assertEqual(held.buffers(), ("irradiance", buffer))
            errors = held.errors({"irradiance": 2.0 * flat, buffer: flat})
            self.assertEqual((errors[one].nrmse, errors[every].nrmse), (0.0, 0.0))
            errors = held.errors({"irradiance": flat})
            self.assertEqual(list(errors), [every])
            self.assertEqual(errors[every].bias, -0.5)
        self.assertIsNone(references.References(everywhere).main)

    def test_what_judges_a_scene(self) -> None:
        lamp, sky = [object()], object()
        for areas, environment, names in (
            ([], None, ("R2", "R3")),
            ([], sky, ("S1", "S3")),
            (lamp, None, ("A1", "A3")),
            (lamp, sky, ("S1", "A1", "A3")),
        ):
            scene = mock.Mock(area_lights=areas, environment=environment)
            self.assertEqual(references.names_of(scene), names)
            self.assertEqual(references.has_r1(scene), names == ("R2", "R3"))


class Differences(unittest.TestCase):
    """Times that rows add to plain VTK, over the time that SSAO adds."""

    @staticmethod
    def row(method: str, frame: float | None, processor: float | None, error: str = "") -> Any:
        return {"method": method, "error": error, "frame_ms": frame, "processor_ms": processor}

    def test_by_wall_clock_and_by_processor_time(self) -> None:
        rows = [self.row("vtk", 10.0, 20.0), self.row("ssao", 30.0, 60.0),
                {**self.row("auto", 40.0, 50.0), "sky_ms": 5.0}]  # fmt: skip
        compare.add_differences(rows)
        self.assertEqual(rows[2]["sky_over_ssao"], 0.25)
        self.assertEqual((rows[2]["added_ms"], rows[2]["added_processor_ms"]), (30.0, 30.0))
        self.assertEqual(rows[2]["added_over_ssao"], 1.5)
        self.assertEqual(rows[2]["added_processor_over_ssao"], 0.75)
        self.assertEqual((rows[1]["added_ms"], rows[1]["added_processor_ms"]), (20.0, 40.0))
        for row in rows[:2]:
            self.assertNotIn("added_over_ssao", row)
        self.assertNotIn("added_ms", rows[0])

    def test_what_is_not_there_has_no_ratio(self) -> None:
        traced = {"method": "mitsuba", "error": "", "indirect_ms": 1.0}
        for others in (
            [self.row("vtk", 10.0, 20.0)],
            [self.row("vtk", 10.0, 20.0), self.row("ssao", 9.0, 20.0)],
            [self.row("vtk", 10.0, 20.0), self.row("ssao", 90.0, 90.0, "failed")],
        ):
            rows = [*others, self.row("auto", 40.0, 50.0), dict(traced)]
            compare.add_differences(rows)
            self.assertEqual(rows[-2]["added_ms"], 30.0)
            self.assertNotIn("added_over_ssao", rows[-2])
            self.assertNotIn("added_processor_over_ssao", rows[-2])
            self.assertEqual(rows[-1], traced)
        rows = [self.row("ssao", 30.0, 60.0), self.row("auto", 40.0, 50.0)]
        compare.add_differences(rows)
        self.assertNotIn("added_ms", rows[1])


@unittest.skipIf(why_no_rendering() is not None, f"{why_no_rendering()}")
class Command(DirectoryTest):
    """The whole command on a small scene."""

    def compare(self, *words: Any, run: Any = command_line_here) -> list[dict[str, str]]:
        """Run the comparison; its rows."""
        scene = self.write("small.json", small_scene())
        with mock.patch.object(references, "REFINEMENTS", 1):
            done = run("compare", scene, "-o", self.directory / "report", "--frames", 2, *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.said = done.stdout
        table = (self.directory / "report" / "rows.csv").read_text()
        return list(csv.DictReader(io.StringIO(table)))

    def test_rows_and_errors(self) -> None:
        path = self.write(
            "sweep.json",
            sweep_of(
                {"method": "reference", "settings": {"ReflectiveShadowMapResolution": 256}},
                {"method": "gather", "sampler": "uniform",
                 # R1 is of one bounce.
                 "settings": {"NumberOfLights": [16, 1024], "NumberOfBounces": 1,
                              "Interpolation": False, "Visibility": "none"}},
            ),
        )
        rows = {row["label"]: row for row in self.compare("--sweep", path, run=command_line)}
        self.assertEqual(
            list(rows),
            ["vtk", "reference", "gather NumberOfLights=16", "gather NumberOfLights=1024"],
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
        names = {path.name for path in (self.directory / "report").iterdir()}
        self.assertEqual(names, {"rows.csv", "rows.json"})
        # Nothing hides anything here, so that R2 is R1; R3 has more light.
        self.assertIn("small: references are refined pictures of the default method", self.said)
        self.assertLess(float(rows["reference"]["nrmse_r2"]), 0.02)
        self.assertLess(float(rows["reference"]["bias_r3"]), -0.1)
        self.assertEqual(len({row["estimated_error_r3"] for row in rows.values()}), 1)
        lines = [line.split() for line in self.said.splitlines()]
        self.assertEqual(
            lines[0],
            ["scene", "label", "frame_ms", "indirect_ms"]
            + [f"{metric}_{name}" for name in ("r1", "r2", "r3") for metric in ("nrmse", "bias")],
        )
        self.assertEqual([line[1] for line in lines[1:5]], ["vtk", "reference", "gather", "gather"])
        self.assertEqual(float(lines[2][-6]), 0.0)
        self.assertAlmostEqual(
            float(lines[4][-6]), float(rows["gather NumberOfLights=1024"]["nrmse_r1"]), places=3
        )

    def test_without_the_oracle_r1_is_left_out(self) -> None:
        path = self.write("sweep.json", sweep_of({"method": "gather"}, {"method": "reference"}))
        with mock.patch.object(wrapped, "_oracle", return_value={}):
            rows = self.compare("--sweep", path, "--size", "96x72")
        why = "vtkRSMReferencePass is the oracle of the tests, which is built with them"
        self.assertEqual([why in row["error"] for row in rows], [False, False, True])
        self.assertGreater(float(rows[1]["frame_ms"]), 0.0)
        self.assertNotIn("nrmse_r1", rows[1])
        self.assertIn("left out: R1, because vtkRSMReferencePass is the oracle", self.said)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "vtkIndirectOpenEXR was not built")
    def test_refined_references_are_the_path_tracers(self) -> None:
        """Within the noise of both: that of path tracing is an RMS error of 0.02 to 0.03 of the mean."""
        for name in ("contact_corner", "folded_sheet"):
            scene = load_scene(SCENES / f"{name}.json")
            stored = SCENES.parent / "Reference" / "data" / f"{name}.exr"
            window = frames.open_window(scene, references.natural_size(stored))
            self.addCleanup(window.Finalize)
            with mock.patch.object(references, "REFINEMENTS", 2):
                found, estimated = references.refined(scene)
            self.assertEqual(list(found), ["R2", "R3"])
            self.assertEqual(window.GetSize(), references.natural_size(stored))
            receivers, _normal = references.eye(scene)
            for layer, image in found.items():
                truth = references.read_layer(stored, layer)
                self.assertEqual(image.shape, truth.shape)
                errors = metrics.compare(image, truth, receivers[1::3, 1::3])
                print(f"{name} {layer}: RMS error {errors.nrmse:.4f}, estimated {estimated[layer]:.4f}")
                self.assertLess(errors.nrmse, np.hypot(1.5 * estimated[layer], 0.03))
                self.assertLess(abs(errors.bias), 0.01)

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

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "vtkIndirectOpenEXR was not built")
    def test_under_a_sky(self) -> None:
        """S1 and S3 under a disk at every pace, the same from each; and plain VTK's."""
        scene = load_scene(SCENES / "sky_disk.json")
        camera = scene.renderer.GetActiveCamera()
        position = camera.GetPosition()
        stored = SCENES.parent / "Reference" / "data"
        self.assertEqual(compare.Run(scene, 2, stored).size, (384, 384))
        run = compare.Run(scene, 2, stored, (128, 128))
        rows = [sweep.Row(pace, "auto", pace=pace) for pace in frames.PACES]
        with mock.patch.multiple(frames, STANDING_FRAMES=2, WARM_UP_FRAMES=2):
            found = {row["label"]: row for row in run.run(rows, lambda _what: None)}
        self.assertEqual(list(found), ["vtk", *frames.PACES])
        self.assertEqual({row["error"] for row in found.values()}, {""})
        self.assertEqual(camera.GetPosition(), position)
        self.assertEqual(run.missing.keys(), {"R1, R2 and R3"})
        for name in ("s1", "s3"):
            self.assertAlmostEqual(found["vtk"][f"bias_{name}"], -1.0, places=12)
        for pace in frames.PACES:
            row = found[pace]
            self.assertEqual(row["pace"], pace)
            self.assertGreater(row["first_ms"], 0.0)
            self.assertGreater(row["warm_up_frames"], 2)
            self.assertGreater(row["frame_ms"], 0.0)
            # Directions that are each hard; the bounce between floor and disk holds 4 % of S3.
            self.assertLess(row["nrmse_s1"], 0.04)
            self.assertLess(abs(row["bias_s3"]), 0.06)
            self.assertNotIn("nrmse_r1", row)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "vtkIndirectOpenEXR was not built")
    def test_under_area_lights(self) -> None:
        """A1 and A3 of moving and still frames; and plain VTK's."""
        scene = load_scene(SCENES / "area_cornell.json")
        stored = SCENES.parent / "Reference" / "data"
        self.assertEqual(compare.Run(scene, 2, stored).size, (768, 768))
        run = compare.Run(scene, 2, stored, (256, 256))
        rows = [sweep.Row(pace, "auto", pace=pace) for pace in ("moving", "still")]
        found = {row["label"]: row for row in run.run(rows, lambda _what: None)}
        self.assertEqual({row["error"] for row in found.values()}, {""})
        self.assertEqual(run.missing.keys(), {"R1, R2 and R3"})
        for name in ("a1", "a3"):
            self.assertAlmostEqual(found["vtk"][f"bias_{name}"], -1.0, places=12)
        for pace, limit in (("moving", 0.04), ("still", 0.01)):
            row = found[pace]
            # Steps of 16 and 64 points in the penumbrae; all else is in closed form.
            self.assertLess(row["nrmse_a1"], limit)
            self.assertLess(abs(row["bias_a1"]), 0.01)
            # All bounces, of which those after the first hold 0.216 of A3; clusters stand for what
            # sends them, 256 for the first.
            self.assertAlmostEqual(row["bias_a3"], 0.0, delta=0.03)
            self.assertGreater(row["frame_ms"], 0.0)
            self.assertNotIn("nrmse_r1", row)

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "vtkIndirectOpenEXR was not built")
    def test_shadows_of_area_lights(self) -> None:
        """A1 when all maps are there: a lamp over boxes, two over a machine, a window's picture.

        1024 points with exact visibility leave 0.002, 0.002 and 0.020 of these, and A1's own noise
        0.001, 0.001 and 0.008. The rest are texels. Bars before the window hide nearly
        the same share of the 16 places that light the room as of the window.
        """
        stored = SCENES.parent / "Reference" / "data"
        for name, size, limit, bias in (
            ("area_cornell", (256, 256), 0.003, 0.01),
            ("area_machine", (256, 192), 0.012, 0.01),
            ("area_apartment", (256, 192), 0.03, 0.03),
        ):
            with self.subTest(name):
                run = compare.Run(load_scene(SCENES / f"{name}.json"), 1, stored, size)
                (_, row) = run.run([sweep.Row("all", "auto")], lambda _what: None)
                self.assertEqual(row["error"], "")
                self.assertLess(row["nrmse_a1"], limit)
                self.assertLess(abs(row["bias_a1"]), 0.005)
                self.assertLess(abs(row["bias_a3"]), bias)

    def test_each_time_is_by_its_own_clock(self) -> None:
        """Both clocks stand but for what a frame adds, so that no machine decides this."""
        scene = load_scene(self.write("small.json", small_scene()))
        window = frames.open_window(scene, (32, 24))
        self.addCleanup(window.Finalize)
        clocks = {"wall": 7.0, "processor": 3.0}

        def spend(*_event: Any) -> None:
            clocks["wall"] += 0.25
            clocks["processor"] += 0.5  # of several threads

        scene.renderer.AddObserver("StartEvent", spend)
        with mock.patch.multiple(
            frames.time,
            perf_counter=lambda: clocks["wall"],
            process_time=lambda: clocks["processor"],
        ):
            found = frames.render(scene, window, frames.Job("off", frames=3))
        for name, expected in (("wall_ms", 250.0), ("processor_ms", 500.0)):
            self.assertEqual(found[name], {"median_ms": expected, "p95_ms": expected})

    def test_the_image_of_a_camera_that_stands_is_the_same_on_a_busy_machine(self) -> None:
        """The number of frames is the same however long a frame takes."""
        scene = load_scene(SCENES / "sky_disk.json")
        window = frames.open_window(scene, (48, 48))
        self.addCleanup(window.Finalize)
        steps: list[str] = []

        def show(second: float) -> np.ndarray:
            now = iter(float(i) * second for i in range(10**6))
            steps.clear()
            job = frames.Job("auto", settings={"NumberOfLights": 16}, pace="standing")
            with mock.patch.object(frames.time, "perf_counter", lambda: next(now)):
                frames.render(scene, window, job, steps.append)
            return images.copy_buffer(scene.renderer, "indirect")

        with mock.patch.object(frames, "STANDING_FRAMES", 4):
            idle, count = show(1e-3), len(steps)
            busy = show(1e3)
        self.assertEqual(len(steps), count)
        self.assertTrue((idle == busy).all())

    def test_times_alone(self) -> None:
        rows = self.compare("--methods", "gather", "--reference", "none")
        self.assertEqual([row["error"] for row in rows], ["", ""])
        self.assertFalse([name for name in rows[0] if name.endswith(("_r1", "_r2"))])
        for row in rows:
            self.assertGreater(float(row["processor_ms"]), 0.0)
        added = float(rows[1]["processor_ms"]) - float(rows[0]["processor_ms"])
        self.assertAlmostEqual(float(rows[1]["added_processor_ms"]), added, places=9)
        self.assertIn("left out: errors, because times alone were asked for", self.said)

    def test_a_pace_ends_where_the_scene_has_the_camera(self) -> None:
        scene = load_scene(self.write("small.json", small_scene()))
        window = frames.open_window(scene, None)
        self.addCleanup(window.Finalize)
        rates: list[float] = []

        def depth(pace: str | None) -> np.ndarray:
            job = frames.Job("gather", settings={"NumberOfLights": 1}, frames=2, pace=pace)
            frames.render(scene, window, job, lambda _: rates.append(window.GetDesiredUpdateRate()))
            return images.copy_buffer(scene.renderer, "depth")

        expected = depth(None)
        before = window.GetDesiredUpdateRate()
        for pace in frames.PACES:
            rates.clear()
            with mock.patch.multiple(frames, STANDING_FRAMES=2, WARM_UP_FRAMES=2):
                self.assertTrue((depth(pace) == expected).all(), pace)
            still, moving = frames.STILL_RATE, frames.INTERACTIVE_RATE
            turned = still if pace == "still" else moving
            last = moving if pace == "moving" else still
            self.assertEqual(rates, [still, still, turned, last, last])
            self.assertEqual(window.GetDesiredUpdateRate(), before)

    def test_frames_are_measured_when_all_depth_maps_are_there(self) -> None:
        """This holds if a frame has time for a few maps only; without caching no maps are waited for."""
        scene = load_scene(self.write("small.json", small_scene()))
        window = frames.open_window(scene, None)
        self.addCleanup(window.Finalize)
        window.SetDesiredUpdateRate(100.0)
        drawn: list[int] = []

        def render(**settings: object) -> dict[str, object]:
            drawn.clear()
            job = frames.Job("gather", settings={"NumberOfLights": 256, **settings}, frames=2)
            return frames.render(
                scene, window, job, lambda _: drawn.append(frames.tiles_drawn(scene.renderer))
            )

        warm = render()["warm_up_frames"]
        self.assertGreater(warm, 2)
        new = np.diff([*drawn, frames.tiles_drawn(scene.renderer)])
        self.assertTrue((new[: warm - 1] > 0).all(), new)
        self.assertEqual(new[warm - 1 :].tolist(), [0, 0, 0])
        self.assertEqual(render(Caching=False)["warm_up_frames"], 1)

    def test_failing_row_is_a_row_and_the_run_goes_on(self) -> None:
        path = self.write(
            "sweep.json",
            sweep_of(
                {"method": "a method to come"},
                {"label": "wrong", "method": "gather", "settings": {"Colour": "blue"}},
                {"method": "gather", "sampler": "uniform", "settings": {"Pattern": "grid"}},
                {"method": "auto", "settings": {"NumberOfLights": 16, "Visibility": "voxels"}},
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
        for error in (metrics.MetricError("not finite"), RenderError("gone"), KeyError("x")):
            run = compare.Run(load_scene(path), 1, None)
            with mock.patch.object(run, "judge", side_effect=error):
                results = run.run([sweep.Row("gather", "gather")], lambda _what: None)
            self.assertEqual([bool(row["error"]) for row in results], [True, True])
            self.assertIn(str(error), results[-1]["error"])
        self.assertIn("KeyError", results[-1]["error"])

    def test_what_the_sources_do_is_one_line_without_them(self) -> None:
        scene = self.write("small.json", small_scene())
        for words in (("--flicker",), ("--reference-python", "python")):
            with mock.patch.dict("os.environ", {"VTKINDIRECT_SCENES": str(self.directory)}):
                done = command_line_here("compare", scene, *words, "-o", self.directory / "r")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(f"{words[0]}: is done by Testing/Benchmark/comparison.py", done.stderr)
        path = self.write("sweep.json", {**sweep_of({"method": "gather"}), "flicker": True})
        self.compare("--sweep", path)
        self.assertIn("left out: flicker, because Testing/Benchmark/comparison.py", self.said)

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
            ((scene, "-o", self.directory / "no" / "report"), "no"),
        ):
            given = "-o" in words
            output = () if given else ("-o", self.directory / "r")
            done = command_line_here("compare", *words, *output)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(expected, done.stderr)
