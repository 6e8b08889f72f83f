# SPDX-License-Identifier: BSD-3-Clause
"""The preset "paper" of each method: the same picture as by its properties one by one."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from vtkindirect import UsageError, cli, frames, images, methods
from vtkindirect.frames import Job

METHODS = ("gather", "splatting", "multiresolution", "hints", "proxies", "reference")
PLAIN = {"NumberOfBounces": 1, "Visibility": "none"}
SINGLE = {
    # 64 sums along the longer edge of 192 x 144 pixels
    "gather": (None, {"Mode": "neighborhood", "NumberOfSamples": 308, "InterpolationStep": 3}),
    "splatting": (
        "importance",
        {"IntensityThreshold": 0.05, "FarField": False, "NumberOfLights": 768, "Levels": 4,
         "Evenness": 0.0, "Occlusion": 1.0},
    ),
    "proxies": (
        None,
        {"Groups": False, "InfluenceScale": 15.0, "IndirectInfluenceScale": 4.0,
         "IndirectLight": "averaged", "ReceiverStep": 4, "Upsampling": "bilateral"},
    ),
}  # fmt: skip


class Presets(unittest.TestCase):
    def setUp(self) -> None:
        self.renderer = vtkRenderer()

    def render(
        self, method, sampler=None, name="two_planes", buffer="irradiance", size=(192, 144), **values
    ):
        scene = vtkindirect.load_scene(support.SCENES / f"{name}.json")
        window = frames.open_window(scene, size)
        self.addCleanup(window.Finalize)
        frames.render(scene, window, Job(method, sampler, values))
        report = vtkindirect.report(scene.renderer)
        return images.copy_buffer(scene.renderer, buffer), report

    def test_the_same_picture_as_by_single_properties(self) -> None:
        for method, (sampler, values) in SINGLE.items():
            sky = method == "proxies"  # whose spheres hide the sky in both
            where = {"name": "sky_particles", "buffer": "sky"} if sky else {}
            with self.subTest(method=method):
                paper, report = self.render(method, Preset="paper", **where)
                single, _ = self.render(method, sampler, **values, **({} if sky else PLAIN), **where)
                self.assertGreater(float(single.mean()), 1e-3)
                np.testing.assert_array_equal(paper, single)
                usual, _ = self.render(method, **where)
                self.assertFalse(np.array_equal(paper, usual))
                self.assertEqual(report["settings"]["Preset"], "paper")
                for name in ("InterpolationStep", "ReceiverStep"):  # chosen ones are said
                    self.assertEqual(report["settings"].get(name), values.get(name))

    def test_nothing_hides_and_one_bounce_unless_asked(self) -> None:
        for method in METHODS:
            with self.subTest(method=method):
                _, report = self.render(method, size=(32, 24), preset="paper",
                                        ReflectiveShadowMapResolution=64)  # fmt: skip
                self.assertEqual(report["settings"]["Visibility"], "none")
                self.assertEqual(report["settings"]["NumberOfBounces"], 1)
        _, report = self.render("multiresolution", preset="paper", number_of_bounces=4,
                                visibility="maps")  # fmt: skip
        self.assertEqual(report["settings"]["Visibility"], "maps")
        self.assertEqual(report["settings"]["NumberOfBounces"], 4)

    def test_samplers(self) -> None:
        for method, expected in (
            ("splatting", "vtkImportanceLightSampler"),
            ("multiresolution", "vtkUniformLightSampler"),
        ):
            with self.subTest(method=method):
                indirect = vtkindirect.enable(self.renderer, method)
                self.assertEqual(indirect.GetSampler().GetClassName(), "vtkLightTreeSampler")
                vtkindirect.enable(self.renderer, method, preset="paper")
                self.assertEqual(indirect.GetSampler().GetClassName(), expected)
                vtkindirect.enable(self.renderer, method, preset="robust")
                self.assertEqual(indirect.GetSampler().GetClassName(), "vtkLightTreeSampler")
                vtkindirect.enable(self.renderer, method, "random_walk", preset="paper")
                self.assertEqual(indirect.GetSampler().GetClassName(), "vtkRandomWalkLightSampler")
        # In C++ the pass takes the paper's sampler where it has none.
        indirect = vtkindirect.vtkIndirectIlluminationPass()
        splatting = vtkindirect.vtkIndirectSplattingPass()
        indirect.SetEstimator(splatting)
        self.assertEqual(indirect.GetActiveSampler().GetClassName(), "vtkLightTreeSampler")
        splatting.SetPresetToPaper()
        self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 768)
        splatting.SetPresetToRobust()
        self.assertEqual(indirect.GetActiveSampler().GetClassName(), "vtkLightTreeSampler")

    def test_setting_it_overwrites_and_properties_may_follow(self) -> None:
        gather = vtkindirect.vtkRSMGatherPass()
        gather.SetNumberOfSamples(7)
        gather.SetPresetToPaper()
        self.assertEqual(gather.GetNumberOfSamples(), 308)
        gather.SetNumberOfSamples(1020)
        gather.SetPresetToPaper()  # is set already
        self.assertEqual(gather.GetNumberOfSamples(), 1020)
        gather.SetPreset(99)
        self.assertEqual(gather.GetPreset(), gather.ROBUST)
        self.assertEqual(gather.GetNumberOfSamples(), 256)
        # Settings of the same call hold beside the preset, wherever they stand.
        indirect = vtkindirect.enable(self.renderer, "gather", number_of_samples=156, preset="paper")
        self.assertEqual(indirect.GetEstimator().GetNumberOfSamples(), 156)
        self.assertEqual(indirect.GetEstimator().GetInterpolationStep(), 0)

    def test_errors_change_nothing(self) -> None:
        indirect = vtkindirect.enable(self.renderer, "splatting", far_field_step=4)
        for values, expected in (
            ({"preset": "papers"}, "unknown value 'papers'"),
            ({"preset": "paper", "far_field_step": 1000}, "FarFieldStep: 1000 is out of range"),
        ):
            with self.subTest(values=values):
                with self.assertRaisesRegex(UsageError, expected):
                    vtkindirect.enable(self.renderer, "splatting", **values)
                estimator = indirect.GetEstimator()
                self.assertEqual(estimator.GetPreset(), estimator.ROBUST)
                self.assertEqual(estimator.GetFarFieldStep(), 4)
                self.assertTrue(estimator.GetFarField())
                self.assertEqual(indirect.GetSampler().GetClassName(), "vtkLightTreeSampler")

    def test_command_line(self) -> None:
        scene = str(support.SCENES / "two_planes.json")
        with tempfile.TemporaryDirectory() as directory:
            report = Path(directory) / "report.json"
            command = ["render", scene, "--size", "64x48", "--report", str(report)]
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(cli.main([*command, "--method", "gather", "--preset", "paper"]), 0)
            settings = json.loads(report.read_text(encoding="utf-8"))["settings"]
            self.assertEqual(settings["Preset"], "paper")
            self.assertEqual(settings["NumberOfSamples"], 308)
            for arguments, expected in (
                (["--preset", "thesis"], "Preset: unknown value 'thesis'"),
                (["--preset", "paper", "--set", "preset=robust"], "preset is given twice"),
            ):
                error = io.StringIO()
                with self.subTest(arguments=arguments), contextlib.redirect_stderr(error):
                    self.assertEqual(cli.main([*command, *arguments]), 2)
                self.assertIn(expected, error.getvalue())

    def test_scene_file(self) -> None:
        document = support.small_scene()
        document["rendering"] = {"method": "splatting", "settings": {"Preset": "paper"}}
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "scene.json"
            path.write_text(json.dumps(document), encoding="utf-8")
            report = Path(directory) / "report.json"
            for arguments, method, preset in (
                ([], "splatting", "paper"),
                (["--set", "FarField=on"], "splatting", "paper"),
                (["--preset", "robust"], "splatting", "robust"),
                (["--method", "gather"], "gather", "robust"),
            ):
                with self.subTest(arguments=arguments), contextlib.redirect_stdout(io.StringIO()):
                    command = ["render", str(path), "--report", str(report), *arguments]
                    self.assertEqual(cli.main(command), 0)
                    found = json.loads(report.read_text(encoding="utf-8"))
                    self.assertEqual(found["method"], method)
                    self.assertEqual(found["settings"]["Preset"], preset)
            scene = vtkindirect.load_scene(path)
            indirect = vtkindirect.enable(scene)
            self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 768)
            document["rendering"] = {"method": "thesis"}
            path.write_text(json.dumps(document), encoding="utf-8")
            with self.assertRaisesRegex(vtkindirect.SceneError, r"rendering\.method"):
                vtkindirect.load_scene(path)

    def test_methods_are_all_here(self) -> None:
        self.assertEqual({*METHODS, "auto", "off"}, set(methods.METHODS))


if __name__ == "__main__":
    unittest.main()
