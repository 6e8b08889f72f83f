# SPDX-License-Identifier: BSD-3-Clause
"""The command line: one line for each mistake, exit codes, files that are complete or not there."""

import json
import os
import subprocess
import sys
import unittest

import support
from vtkindirect import wrapped

WHY_NOT = support.why_no_rendering()
HAVE_EXR = wrapped.has("vtkOpenEXRWriter")


class CommandLine(support.DirectoryTest):
    def setUp(self) -> None:
        super().setUp()
        self.scene = self.write("scene.json", support.small_scene())
        self.before = self.names()

    def assert_error(
        self, expected: str, *words, code: int = 2, run=support.command_line_here, **environment
    ) -> None:
        result = run(*words, **environment)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("vtk-indirect: error: "), lines[0])
        self.assertIn(expected, lines[0])
        self.assertEqual(self.names(), self.before)

    def test_mistakes_in_the_words(self) -> None:
        out = self.directory / "a.png"
        for expected, words in (
            ("a command is needed", []),
            ("invalid choice: 'rendr'", ["rendr"]),
            ("arguments are required: SCENE_OR_DATA", ["render"]),
            ("unrecognized arguments: --bounces", ["render", self.scene, "--bounces"]),
            ("unknown method 'gahter' (did you mean 'gather'?)", ["--method", "gahter"]),
            ("method 'proxies' is not built in this version", ["--method", "proxies"]),
            ("unknown sampler 'uniformly' (did you mean 'uniform'?)", ["--sampler", "uniformly"]),
            ("unknown buffer 'derect' (did you mean 'direct'?)", ["--buffer", "derect"]),
            ("argument --size: '0x5' must be from 1x1 to 16384x16384", ["--size", "0x5"]),
            ("argument --size: '99999x5' must be from 1x1", ["--size", "99999x5"]),
            ("argument --size: '5' must be WIDTHxHEIGHT", ["--size", "5"]),
            ("argument --size: '-5x5' must be WIDTHxHEIGHT", ["--size=-5x5"]),
            ("argument --frames: '0' must be a whole number", ["--frames", "0"]),
            ("argument --frames: 'many' must be a whole number", ["--frames", "many"]),
            ("--set Shadows: must be Property=value", ["--set", "Shadows"]),
            ("method 'off' has only the buffer 'final'", ["--method", "off", "--buffer", "depth"]),
            ("method 'off' has no property 'Shadows'", ["--method", "off", "--set", "Shadows=1"]),
            ("must end in .png or .exr", ["-o", self.directory / "a.gif"]),
            ("no such directory", ["-o", self.directory / "none" / "a.png"]),
            ("must end in .json", ["-o", out, "--report", self.directory / "r.txt"]),
            ("is named twice", ["-o", out, "-o", out]),
            ("it cannot be the output too", ["-o", out, "--report", self.scene]),
        ):
            if words and words[0] in ("rendr", "render") or not words:
                full = words
            else:
                full = ["render", self.scene, *words]
                if "-o" not in words:
                    full += ["-o", out]
            with self.subTest(expected=expected):
                if wrapped.has("vtkProxyAccumulationPass") and "proxies" in words:
                    continue
                self.assert_error(expected, *full)
        # A program of its own exits with the code, and says no more than that.
        self.assert_error("a command is needed", run=support.command_line)

    def test_mistakes_in_the_files(self) -> None:
        out = ("-o", self.directory / "a.png")
        self.assert_error("none.json: no such file", "render", self.directory / "none.json", *out)
        self.assert_error("is a directory", "render", self.directory, *out)
        wrong = support.small_scene()
        wrong["actors"][1]["pipeline"] = [{"contour": {"array": "t", "value": "x"}}]
        path = self.write("wrong.json", wrong)
        cut = self.write("cut.vtu", (support.DATA / "room_fire_cfd.vtu").read_bytes()[:300000])
        self.before = self.names()
        self.assert_error("actors[1].pipeline[0].contour.value: must be", "render", path, *out)
        for run in (support.command_line_here, support.command_line):
            self.assert_error("cut.vtu: cannot be read: ", "render", cut, *out, run=run)

    def test_unwritable_directory(self) -> None:
        self.assert_error("cannot be written", "render", self.scene, "-o", "/proc/a.png")
        if os.geteuid() != 0:
            locked = self.directory / "locked"
            locked.mkdir(mode=0o500)
            self.before = self.names()
            self.assert_error("cannot be written", "render", self.scene, "-o", locked / "a.png")

    def test_view_without_a_display(self) -> None:
        for display in ("", ":987"):
            self.assert_error(
                "there is no display to show a window on",
                "view",
                self.scene,
                code=1,
                run=support.command_line,
                DISPLAY=display,
            )

    def test_demo_mistakes(self) -> None:
        out = ("-o", self.directory)
        self.assert_error(
            "unknown demonstration 'frogs' (did you mean 'frog'?)", "demo", "frogs", *out
        )
        self.assert_error("no such directory", "demo", "-o", self.directory / "none" / "deeper")

    def test_a_missing_package_is_named(self) -> None:
        code = (
            "import sys, runpy; sys.modules['tqdm'] = None; "
            "runpy.run_module('vtkindirect', run_name='__main__')"
        )
        result = subprocess.run(
            [sys.executable, "-B", "-c", code], capture_output=True, text=True, check=False
        )
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, "^vtk-indirect: error: .* tqdm .*python3-tqdm.*\n$")

    def test_help_and_version(self) -> None:
        for run, *words in (
            (support.command_line, "--help"),
            *((support.command_line_here, name, "--help") for name in ("render", "view", "demo")),
        ):
            result = run(*words)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("usage: vtk-indirect", result.stdout)
        self.assertRegex(support.command_line("--version").stdout, r"^vtk-indirect \d.* with VTK 9")


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Rendering(support.DirectoryTest):
    def setUp(self) -> None:
        super().setUp()
        self.scene = self.write("scene.json", support.small_scene())

    def run_line(self, *words, code: int = 0, run=support.command_line_here):
        result = run("render", self.scene, *words)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def test_pictures_and_report(self) -> None:
        outputs = [self.directory / "a.png"]
        if HAVE_EXR:
            outputs.append(self.directory / "a.exr")
        report = self.directory / "r.json"
        words = [word for path in outputs for word in ("-o", path)]
        result = self.run_line(
            *words,
            *("--report", report, "--frames", 2, "--size", "50x40", "--method", "gather"),
            *("--set", "NumberOfLights=50", "--set", "Pattern=grid", "--sampler", "uniform"),
            run=support.command_line,
        )
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.stdout.split(), [str(path) for path in (*outputs, report)])
        for path in outputs:
            self.assertGreater(path.stat().st_size, 100)
        content = json.loads(report.read_text())
        self.assertEqual(content["size"], [50, 40])
        self.assertEqual(content["settings"]["NumberOfLights"], 50)
        self.assertEqual(self.names(), sorted(["scene.json", "r.json", *(p.name for p in outputs)]))

    def test_multiresolution(self) -> None:
        report = self.directory / "r.json"
        self.run_line(
            *("--method", "multiresolution", "--set", "NormalThreshold=0.1"),
            *("--set", "FinestLevel=half_resolution", "--set", "NumberOfLights=50"),
            *("-o", self.directory / "a.png", "--report", report),
        )
        content = json.loads(report.read_text())
        self.assertEqual(content["method"], "multiresolution")
        self.assertEqual(content["settings"]["NormalThreshold"], 0.1)
        self.assertEqual(content["settings"]["FinestLevel"], "half_resolution")
        self.assertEqual(content["settings"]["NumberOfLights"], 50)

    def test_settings_of_the_automatic_method(self) -> None:
        report = self.directory / "r.json"
        self.run_line(
            *("--set", "NumberOfLights=50", "--set", "Visibility=voxels", "--report", report),
        )
        content = json.loads(report.read_text())
        self.assertEqual(content["settings"]["NumberOfLights"], 50)
        self.assertEqual(content["settings"]["Visibility"], "voxels")
        self.assertLessEqual(content["virtual_lights"], 50)
        self.assertGreater(content["virtual_lights"], 0)

    def test_a_note_says_why_there_is_no_indirect_light(self) -> None:
        out = self.directory / "a.png"
        for words, reason in (
            (("--set", "IndirectScale=0", "--set", "Shadows=off"), "IndirectScale is 0"),
            (("--method", "off"), None),
            ((), None),
        ):
            said = self.run_line(*words, "-o", out).stderr.splitlines()
            self.assertEqual(len(said), 0 if reason is None else 1, said)
            if reason is not None:
                self.assertTrue(said[0].startswith("vtk-indirect: note: no indirect light, "), said)
                self.assertIn(reason, said[0])
        dark = support.small_scene()
        for light in dark["lights"]:
            light["intensity"] = 0
        self.write("scene.json", dark)
        (line,) = self.run_line("-o", out).stderr.splitlines()
        self.assertEqual(line, "vtk-indirect: note: no indirect light: no light emits anything")
        glass = support.small_scene()
        for actor in glass["actors"]:
            actor["opacity"] = 0.5
        self.write("scene.json", glass)
        props, line = self.run_line("-o", out).stderr.splitlines()
        self.assertIn("note: without a part in indirect light: vtkOpenGLActor", props)
        self.assertIn("the delegate alone drew the picture: nothing opaque", line)

    def test_report_alone(self) -> None:
        self.run_line("--method", "off", "--report", self.directory / "r.json")
        self.assertEqual(self.names(), ["r.json", "scene.json"])

    def test_buffers(self) -> None:
        for buffer in ("indirect", "depth", "rsm0.density"):
            self.run_line("--buffer", buffer, "-o", self.directory / f"{buffer}.png")
        self.assertEqual(len(self.names()), 4)

    @unittest.skipUnless(HAVE_EXR, "the module vtkIndirectOpenEXR was not built")
    def test_off_as_floats(self) -> None:
        self.run_line("--method", "off", "--float", "-o", self.directory / "a.exr")
        self.assertGreater((self.directory / "a.exr").stat().st_size, 100)

    def test_mistakes_that_only_rendering_finds(self) -> None:
        out = self.directory / "a.png"
        for expected, code, words in (
            ("NumberOfLights: 0 is out of range", 2, ["--set", "NumberOfLights=0"]),
            ("unknown property 'Shadow' (did you mean 'Shadows'?)", 2, ["--set", "Shadow=1"]),
            ("unknown value 'some'", 2, ["--set", "Mode=some"]),
            ("there is no buffer 'rsm5.depth'", 1, ["--buffer", "rsm5.depth"]),
        ):
            with self.subTest(expected=expected):
                result = self.run_line("--method", "gather", *words, "-o", out, code=code)
                self.assertIn(expected, result.stderr)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertEqual(self.names(), ["scene.json"])
        result = self.run_line(
            *("--buffer", "rsm5.depth", "-o", out), code=1, run=support.command_line
        )
        self.assertIn("there is no buffer 'rsm5.depth'", result.stderr)

    def test_data_file(self) -> None:
        out = self.directory / "room.png"
        result = support.command_line_here("render", support.DATA / "room_vis.vtp", "-o", out)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(out.exists())
