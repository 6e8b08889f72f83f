# SPDX-License-Identifier: BSD-3-Clause
"""Pages name only what exists, and everything that exists is on a page."""

import re
import unittest

import support
from vtkindirect import (
    cli,
    data,
    images,
    lights,
    locations,
    methods,
    pipeline,
    schema,
    sources,
)

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
        whole = schema.schema()
        parts = whole["$defs"]
        for table in (whole, parts["camera"], parts["actor"], parts["scalars"]):
            for key in table["properties"]:
                self.assertIn(f"`{key}`", self.text)
        rows = self.rows()
        for kind, part in (("type", "light"), ("source", "actor")):
            rule = parts[part]["properties"][kind]
            for name in rule.get("else", rule)["enum"]:
                found = {kind: name}
                common = set(parts[part]["properties"])
                for key in set(schema.known_keys(parts[part], found)) - common:
                    self.assertIn(f"`{key}`", rows[name], f"{name}: {key}")
        for name, step in parts["step"]["properties"].items():
            for key in schema.known_keys(step, {}):
                self.assertIn(f"`{key}`", rows[name], f"{name}: {key}")

    def test_what_is_built_is_in_the_schema(self) -> None:
        parts = schema.schema()["$defs"]
        self.assertEqual(set(parts["step"]["properties"]), set(pipeline.STEPS))
        named = parts["actor"]["properties"]["source"]["else"]["enum"]
        self.assertEqual(named, list(sources.SOURCES))
        kinds = parts["light"]["properties"]["type"]["enum"]
        self.assertEqual(kinds, list(lights.LIGHTS))

    def test_names(self) -> None:
        for name in ("vivid", *data.ENDINGS):
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
