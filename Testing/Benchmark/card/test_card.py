# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark for cards, in small, on the OpenGL that is here.

The tests compare its buffers with those of the Python package, and put faults in its way that it
must find: buffers that differ, programs that crash, time that runs out.
"""

from __future__ import annotations

import csv
import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from typing import Any

import support
import vtkindirect
from vtkindirect import images, metrics, references, wrapped

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PROGRAM = os.environ.get("VTK_INDIRECT_CARD_BENCHMARK", "")
SIZE = (256, 256)
"""Size of the scene's reference, so that pixels coincide."""
PART = "cornell_box-256x256"
MORE_AND_MORE = (9, 36, 90)
"""Seconds given to a run that must begin before they are over. One of them is enough on a machine
that is ever so busy; none decides what a test finds."""


def why_not() -> str | None:
    """Return why the benchmark cannot be tried here, or None."""
    if not PROGRAM:
        return "IndirectCardBenchmark was not built"
    if not wrapped.has("vtkOpenEXRReader"):
        return "VTK::IndirectOpenEXR was not built, which reads the references"
    return support.why_no_rendering()


@unittest.skipIf(why_not() is not None, f"{why_not()}")
class Card(unittest.TestCase):
    """A pack of one scene and of programs that are stand-ins."""

    folder: tempfile.TemporaryDirectory
    pack: Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.pack = Path(cls.folder.name) / "pack"
        cls.pack.mkdir()
        subprocess.run(
            [sys.executable, "-B", HERE / "bake.py", cls.pack, "--scene", "cornell_box"],
            check=True, stdout=subprocess.DEVNULL,
        )
        said = cls.gpu("record", "--size", f"{SIZE[0]}x{SIZE[1]}")
        assert said.returncode == 0, said.stderr
        (cls.pack / "bin").mkdir()

    @classmethod
    def tearDownClass(cls) -> None:
        cls.folder.cleanup()

    @classmethod
    def gpu(cls, *words: str, **environment: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            [PROGRAM, *words, "--pack", cls.pack],
            capture_output=True, text=True, check=False,
            env={**os.environ, **environment},
        )

    def results(self) -> Path:
        """Return a new folder for results."""
        folder = tempfile.mkdtemp(dir=self.folder.name)
        self.addCleanup(shutil.rmtree, folder)
        return Path(folder)

    def unit(self, results: Path, part: str, unit: str) -> dict[str, Any]:
        text = (results / "parts" / f"{part}.json").read_text(encoding="utf-8")
        return json.loads(text)["units"][unit]

    def stand_in(self, name: str, body: str) -> None:
        """Put a script in the place of a program of tests; it has the tests One and Two."""
        path = self.pack / "bin" / name
        path.write_text(
            f'#!/bin/sh\n[ "$1" = --list ] && {{ echo One; echo Two; exit 0; }}\n{body}\n'
        )
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        self.addCleanup(path.unlink)

    # Findings ---------------------------------------------------------------------------

    def test_errors_are_those_of_the_package(self) -> None:
        results = self.results()
        said = self.gpu("run", f"{PART}:gather-every-pixel", "--output", str(results))
        self.assertIn("gather-every-pixel: passed", said.stdout, said.stderr)
        found = self.unit(results, PART, "gather-every-pixel")["errors"]

        scene = vtkindirect.load_scene(ROOT / "Testing/Scenes/cornell_box.json")
        window = scene.make_window(SIZE)
        truth = {"R1": references.r1(scene)}
        stored, _ = references.stored_images(
            ROOT / "Testing/Reference/data/cornell_box.exr", SIZE
        )
        truth.update(stored)
        window.SetSize(3 * SIZE[0], 3 * SIZE[1])
        vtkindirect.enable(scene.renderer, "gather", NumberOfLights=1)
        window.Render()
        mask = references.mask(scene)[1::3, 1::3]
        vtkindirect.disable(scene.renderer)
        window.SetSize(SIZE)
        vtkindirect.enable(scene.renderer, "gather", Interpolation=False)
        window.Render()
        irradiance = images.copy_buffer(scene.renderer, "irradiance")
        self.assertEqual(sorted(found), sorted(truth))
        for name, reference in truth.items():
            expected = metrics.compare(irradiance, reference, mask)
            self.assertEqual(found[name]["receivers"], mask.sum())
            for key in ("nrmse", "relmse", "bias"):
                # The references are baked as 32-bit floats.
                self.assertAlmostEqual(found[name][key], getattr(expected, key), delta=1e-5)

    def test_rows(self) -> None:
        results = self.results()
        said = self.gpu("run", f"{PART}:vtk", f"{PART}:automatic", "--output", str(results))
        self.assertEqual(said.returncode, 3, said.stdout + said.stderr)
        with open(results / "rows.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        stages = {(row["method"], row["stage"]) for row in rows}
        for stage in ("frame", "frames in flight", "camera turns", "first frame"):
            self.assertIn(("vtk", stage), stages)
            self.assertIn(("automatic", stage), stages)
        for stage in ("rsm", "geometry", "estimate", "composite"):
            self.assertIn(("automatic", stage), stages)
        for row in rows:
            self.assertGreater(float(row["wall_ms"]), 0.0)
            self.assertGreaterEqual(float(row["wall_p95_ms"]), float(row["wall_ms"]))
            self.assertTrue(row["gl_renderer"] and row["gl_version"])
            if row["method"] == "automatic":
                self.assertGreater(int(row["bytes"]), 256 * 256 * 8)
                self.assertGreater(float(row["nrmse_R3"]), 0.0)
            if row["method"] == "automatic" and row["stage"] in ("frame", "estimate"):
                self.assertGreater(float(row["gpu_ms"]), 0.0)
        page = (results / "page.md").read_text(encoding="utf-8")
        self.assertIn("| automatic |", page)
        self.assertIn(rows[0]["gl_renderer"], page)

    def test_a_buffer_that_differs(self) -> None:
        # Walls of half the albedo: what was recorded is of other ones.
        scene = self.pack / "scenes/cornell_box/scene.json"
        before = scene.read_text(encoding="utf-8")
        self.addCleanup(scene.write_text, before, encoding="utf-8")
        values = json.loads(before)
        for actor in values["Actors"]:
            actor["DiffuseColor"] = [0.5 * c for c in actor["DiffuseColor"]]
        scene.write_text(json.dumps(values), encoding="utf-8")
        results = self.results()
        said = self.gpu("run", f"{PART}:automatic", "--output", str(results))
        self.assertEqual(said.returncode, 1, said.stdout + said.stderr)
        checks = {
            check["buffer"]: check for check in self.unit(results, PART, "automatic")["checks"]
        }
        for name in ("albedo", "direct", "irradiance", "final", "window", "rsm0.density", "lights"):
            self.assertFalse(checks[name]["passed"], name)
            self.assertGreater((results / checks[name]["picture"]).stat().st_size, 100, name)
        for name in ("depth", "normal", "rsm0.depth"):
            self.assertTrue(checks[name]["passed"], checks[name])
        self.assertIn("pictures/", (results / "page.md").read_text(encoding="utf-8"))

    # Failures -------------------------------------------------------------------------

    def test_a_program_that_crashes(self) -> None:
        self.stand_in("TestPassContract", '[ "$1" = One ] && kill -SEGV $$\nexit 0')
        results = self.results()
        said = self.gpu("run", "contract", "--output", str(results))
        self.assertEqual(said.returncode, 1, said.stdout + said.stderr)
        self.assertEqual(self.unit(results, "contract", "One")["why"], "signal 11")
        self.assertEqual(self.unit(results, "contract", "Two")["status"], "passed")

    def test_a_program_that_skips_and_one_that_complains(self) -> None:
        self.stand_in("TestPassContract", '[ "$1" = One ] && { echo no such card; exit 125; }\n'
                      'echo "ERROR: In file"; exit 0')
        results = self.results()
        self.assertEqual(self.gpu("run", "contract", "--output", str(results)).returncode, 1)
        one, two = (self.unit(results, "contract", name) for name in ("One", "Two"))
        self.assertEqual((one["status"], one["why"]), ("skipped", "no such card"))
        self.assertEqual((two["status"], two["why"]), ("failed", "it printed 'ERROR: '"))

    def test_time_runs_out_and_it_goes_on(self) -> None:
        marks = self.results()
        # Two ends when it may: no duration decides what the second run finds.
        self.stand_in("TestPassContract", f'echo >>"{marks}/$1"\n'
                      f'while [ "$1" = Two ] && ! [ -e "{marks}/go" ]; do sleep 0.1; done\nexit 0')
        # One must have had its time, however busy the machine is.
        for seconds in MORE_AND_MORE:
            results = self.results()
            (marks / "One").unlink(missing_ok=True)
            said = self.gpu("run", "contract", "--output", str(results), "--seconds", str(seconds))
            self.assertEqual(said.returncode, 3, said.stdout + said.stderr)
            if self.unit(results, "contract", "One")["status"] == "passed":
                break
        self.assertIn("run it again", said.stdout)
        self.assertEqual(self.unit(results, "contract", "Two")["status"], "not run")
        (marks / "go").touch()
        said = self.gpu("run", "contract", "--output", str(results), "--seconds", "100000")
        self.assertEqual(self.unit(results, "contract", "Two")["status"], "passed")
        # Finished units are not done again.
        self.assertEqual((marks / "One").read_text().count("\n"), 1)

    def test_nothing_stays_behind(self) -> None:
        marks = self.results()
        self.stand_in("TestPassContract", f'echo $$ >"{marks}/$1"\nexec sleep 100000')
        results = self.results()

        def has_begun() -> bool:
            return (marks / "One").exists() and bool((marks / "One").read_text().strip())

        def is_there(process: int) -> bool:
            # Where nobody asks how it ended, a process that has ended is still listed.
            try:
                status = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
            except OSError:
                return False
            return status.rpartition(")")[2].split()[0] not in ("X", "Z")

        for stop in ("time", "signal"):
            # It must have begun when time runs out, however busy the machine is.
            for seconds in MORE_AND_MORE if stop == "time" else (100000,):
                words = ["run", "contract:One", "--output", str(results), "--pack", str(self.pack)]
                with subprocess.Popen(
                    [PROGRAM, *words, "--seconds", str(seconds)],
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                ) as program:
                    while stop == "signal" and not has_begun():
                        time.sleep(0.05)
                        self.assertIsNone(program.poll())
                    if stop == "signal":
                        program.terminate()
                    program.wait()
                if has_begun():
                    break
            process = int((marks / "One").read_text())
            (marks / "One").unlink()
            while is_there(process):  # the kernel ends it in its own time; ctest ends this
                time.sleep(0.05)

    def test_no_opengl(self) -> None:
        results = self.results()
        said = self.gpu(
            "run", "--output", str(results), __EGL_VENDOR_LIBRARY_FILENAMES=os.devnull
        )
        self.assertEqual(said.returncode, 1)
        self.assertEqual(said.stderr, "gpu: there is no OpenGL to measure\n")
        why = self.unit(results, "opengl", "context")["why"]
        self.assertIn("No OpenGL 3.2 core context can be made", why)
        self.assertNotIn("\n", why)

    def test_results_of_another_pack(self) -> None:
        results = self.results()
        self.gpu("run", "opengl", "--output", str(results))
        name = self.pack / "scenes/pack.txt"
        before = name.read_text(encoding="utf-8")
        self.addCleanup(name.write_text, before, encoding="utf-8")
        name.write_text("another\n", encoding="utf-8")
        said = self.gpu("run", "opengl", "--output", str(results))
        self.assertEqual(said.returncode, 1)
        self.assertIn("--fresh", said.stderr)
        self.assertEqual(self.unit(results, "opengl", "context")["pack"], before.strip())
        said = self.gpu("run", "opengl", "--output", str(results), "--fresh")
        self.assertEqual(self.unit(results, "opengl", "context")["pack"], "another")

    def test_wrong_words(self) -> None:
        for words, expected in (
            (("run", "nothing"), "there is no part 'nothing'"),
            (("run", f"{PART}:nothing"), f"there is no part '{PART}:nothing'"),
            (("run", "--device", "x"), "--device needs a number"),
            (("run", "--seconds"), "needs a number"),
            (("run", "--wrong", "1"), "there is no option --wrong"),
            (("record", "--size", "12"), "--size needs WIDTHxHEIGHT"),
            (("record",), "record needs at least one --size"),
            (("walk",), "there is no command 'walk'"),
        ):
            with self.subTest(words=words):
                said = self.gpu(*words)
                self.assertNotEqual(said.returncode, 0)
                self.assertEqual(said.stderr.count("\n"), 1, said.stderr)
                self.assertIn(expected, said.stderr)
