# SPDX-License-Identifier: BSD-3-Clause
"""What the pages say is there is there, and everything that is there is on a page."""

import re
import unittest

import support
from vtkindirect import (
    actors,
    cli,
    colormaps,
    data,
    images,
    lights,
    locations,
    methods,
    pipeline,
    sources,
)
from vtkindirect import scene as scenes

PAGES = support.SOURCE / "Documentation"


def page(name: str) -> str:
    return (PAGES / name).read_text(encoding="utf-8")


class SceneFiles(unittest.TestCase):
    def setUp(self) -> None:
        self.text = page("scene-files.md")

    def rows(self) -> dict[str, str]:
        """Return the table rows of the page: first cell to the whole row."""
        return {row.split("`")[1]: row for row in self.text.splitlines() if row.startswith("| `")}

    def test_every_key_of_every_table(self) -> None:
        for table in (scenes.SCENE, scenes.CAMERA, actors.ACTOR, actors.SCALARS):
            for key in table:
                self.assertIn(f"`{key}`", self.text)
        rows = self.rows()
        for names in (sources.SOURCES, lights.LIGHTS, pipeline.STEPS):
            for name, row in names.items():
                self.assertIn(name, rows)
                for key in row.fields:
                    self.assertIn(f"`{key}`", rows[name], f"{name}: {key}")

    def test_names(self) -> None:
        for name in (*colormaps.NAMES, *data.ENDINGS):
            self.assertIn(f"`{name}`", self.text)


class CommandLinePage(unittest.TestCase):
    def test_every_option_and_name(self) -> None:
        text = page("command-line.md")
        helps = "".join(command.format_help() for command in cli.commands().values())
        for option in set(re.findall(r"--[a-z]+", helps)):
            self.assertIn(option, text)
        for name in (*methods.METHODS, *methods.SAMPLERS, *images.BUFFERS, *locations.DEMOS):
            self.assertIn(f"`{name}`", text)


class PythonPage(unittest.TestCase):
    def test_every_function(self) -> None:
        import vtkindirect

        text = page("python.md")
        for name in vtkindirect.__all__:
            if not name.startswith("vtk"):
                self.assertIn(name, text)

    def test_examples_compile(self) -> None:
        for path in sorted((support.SOURCE / "Examples" / "Python").glob("*.py")):
            compile(path.read_text(encoding="utf-8"), str(path), "exec")
