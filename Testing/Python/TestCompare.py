# SPDX-License-Identifier: BSD-3-Clause
"""Sweep files and the command that measures speed against error."""

from __future__ import annotations

import csv
import io
import json
import unittest
from typing import Any

from support import DirectoryTest, command_line, small_scene, why_no_rendering

from vtkindirect import UsageError, sweep
from vtkindirect.compare import difference_image


def sweep_of(*rows: dict[str, Any]) -> dict[str, Any]:
    """A sweep document with these rows."""
    return {"schema": sweep.SCHEMA, "rows": list(rows)}


class SweepFile(DirectoryTest):
    """Lists are expanded; mistakes are named."""

    def load(self, content: Any) -> list[sweep.Row]:
        """Write a sweep file and load it."""
        return sweep.load(self.write("sweep.json", content))

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
            ([], "JSON object"),
        )
        for content, expected in cases:
            with self.assertRaises(UsageError) as caught:
                self.load(content)
            self.assertIn(expected, str(caught.exception))


class DifferenceImage(unittest.TestCase):
    """Red where too bright, blue where too dark, white where right."""

    def test_colours(self) -> None:
        import numpy as np

        reference = np.ones((1, 3, 3))
        image = reference * np.array([1.0, 1.6, 0.4]).reshape(1, 3, 1)
        shown = difference_image(image, reference)
        self.assertTrue((shown[0, 0] == 1.0).all())
        self.assertGreater(shown[0, 1, 0], shown[0, 1, 2] + 0.5)
        self.assertGreater(shown[0, 2, 2], shown[0, 2, 0] + 0.5)


@unittest.skipIf(why_no_rendering() is not None, f"{why_no_rendering()}")
class Command(DirectoryTest):
    """The whole command on a small scene."""

    def compare(self, *words: Any) -> list[dict[str, str]]:
        """Run the comparison; its rows."""
        scene = self.write("small.json", small_scene())
        done = command_line(
            "compare", scene, "-o", self.directory / "report", "--frames", 2, *words
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
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
        names = {path.name for path in (self.directory / "report").iterdir()}
        self.assertLessEqual({"index.md", "index.html", "rows.json", "small.png"}, names)

    def test_failing_row_is_a_row_and_the_run_goes_on(self) -> None:
        path = self.write(
            "sweep.json",
            sweep_of({"method": "splatting"}, {"method": "gather", "settings": {"Pattern": "grid"}}),
        )
        rows = {row["label"]: row for row in self.compare("--sweep", path)}
        self.assertIn("not built", rows["splatting"]["error"])
        self.assertEqual(rows["gather"]["error"], "")

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
        for words, expected in (
            ((scene, "--methods", "gathr"), "gather"),
            ((scene, "--sweep", self.directory / "none.json"), "none.json"),
            ((self.directory / "a.vtp",), "a.vtp"),
            ((scene, "--reference", self.directory / "none"), "none"),
            ((scene, "-o", self.directory / "no" / "report"), "no"),
        ):
            done = command_line("compare", *words, "-o", self.directory / "r") if "-o" not in [
                str(w) for w in words
            ] else command_line("compare", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(expected, done.stderr)


if __name__ == "__main__":
    unittest.main()
