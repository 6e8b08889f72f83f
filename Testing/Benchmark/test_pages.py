# SPDX-License-Identifier: BSD-3-Clause
"""The published pages of the report agree with their rows, and the rows with the sweeps.

A page whose sweep has changed since it was published fails here: run Testing/Benchmark/report again.
"""

import json
import re
import unittest
from pathlib import Path

from vtkindirect import sweep

import comparison
import papers
import publish

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SWEEPS = {
    "all": "all.json",
    "convergence": "convergence.json",
    "hints": "hints.json",
    "sky": "sky.json",
    "spheres": "spheres.json",
}


def rows_of(name: str) -> list[dict]:
    return publish.read_table(publish.DOCUMENTATION / f"{publish.PAGES[name].figures}rows.csv")


class Pages(unittest.TestCase):
    def differ(self, name: str) -> list[str]:
        """Scenes of a page whose rows are not those of its sweep, and what is there."""
        wanted = sweep.load(HERE / SWEEPS[name]).rows
        expected = [(label, {}) for label in comparison.YARDSTICKS]
        expected += [(row.label, row.settings) for row in wanted]
        rows = [row for row in rows_of(name) if row["method"] != comparison.TRACER]
        found = []
        for scene in dict.fromkeys(row["scene"] for row in rows):
            there = [
                (row["label"], json.loads(row["settings"])) for row in rows if row["scene"] == scene
            ]
            if there != expected:
                found.append(f"{scene}: {there} instead of {expected}")
        return found

    def test_rows_are_those_of_the_sweep(self) -> None:
        self.assertEqual(set(SWEEPS), set(publish.PAGES))
        for name in SWEEPS:
            with self.subTest(page=name):
                self.assertEqual(self.differ(name), [])

    def test_pages_name_the_commit_of_their_rows(self) -> None:
        for name, page in publish.PAGES.items():
            commits = {row["commit"] for row in rows_of(name)}
            self.assertEqual(len(commits), 1, name)
            text = (publish.DOCUMENTATION / page.file).read_text(encoding="utf-8")
            self.assertIn(f"(commit {commits.pop()}, ", text)

    def test_tables_are_made_of_the_rows(self) -> None:
        rows = rows_of("all")
        page = (publish.DOCUMENTATION / "speed-vs-error.md").read_text(encoding="utf-8")
        self.assertIn(publish.summary_of_all(rows), page)
        for name, table in publish.TABLES.items():
            text = (ROOT / name).read_text(encoding="utf-8")
            self.assertEqual(text.count(publish.BEGIN), 1, name)
            self.assertEqual(publish.with_table(text, table(rows)), text, name)

    def test_the_papers_page_shows_every_figure(self) -> None:
        text = (publish.DOCUMENTATION / "papers.md").read_text(encoding="utf-8")
        shown = re.findall(r"\]\(papers/(\w+)\.png\)", text)
        self.assertEqual(sorted(shown), sorted(papers.FIGURES))
        for name in shown:
            self.assertTrue((papers.DIRECTORY / f"{name}.png").is_file(), name)


if __name__ == "__main__":
    unittest.main()
