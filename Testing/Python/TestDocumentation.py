# SPDX-License-Identifier: BSD-3-Clause
"""Pages name only what exists, and everything that exists is on a page."""

import math
import re
import unittest
from collections.abc import Iterator
from typing import Any, NamedTuple

from vtkmodules.vtkRenderingCore import vtkLight

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
    wrapped,
)
from vtkindirect import settings as properties

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


class Row(NamedTuple):
    """A property in a table: the table's place, the property's name and its default as written."""

    table: tuple[str, int]
    name: str
    default: str


def split(line: str) -> list[str]:
    """Return the cells of a row."""
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def property_rows() -> Iterator[Row]:
    """Yield the properties of all tables of defaults, in the guide and on the methods' pages."""
    for path in (PAGES / "guide.md", *sorted((PAGES / "methods").glob("*.md"))):
        name = str(path.relative_to(PAGES))
        number = -1
        inside = False
        for line in path.read_text(encoding="utf-8").splitlines():
            if not line.startswith("|"):
                inside = False
                continue
            cells = split(line)
            if not inside and len(cells) > 1 and cells[1] == "default":
                inside = True
                number += 1
            elif inside and not cells[0].startswith("---"):
                names = re.findall(r"`(\w+)`", cells[0])
                defaults = cells[1].split(", ") if len(names) > 1 else [cells[1]]
                # One default for several properties: the same for all of them.
                defaults = defaults if len(defaults) == len(names) else [cells[1]] * len(names)
                yield from (Row((name, number), *pair) for pair in zip(names, defaults))


class UnreadableError(Exception):
    """A default that is written in words."""


def read(text: str, target: Any, name: str) -> Any:
    """Return a default as the property would hold it."""
    text = text.strip("`")
    # After a colon: what the value stands for.
    text = text.split(": ")[0]
    named = properties.choices(target, name)
    found = [value for value in named if value == text.lower()] or [
        value for value in named if value.startswith(f"{text.lower()}_")
    ]
    if len(found) == 1:
        other = target.NewInstance()
        getattr(other, named[found[0]])()
        return getattr(other, f"Get{name}")()
    words = {"on": True, "off": False, "none": None, '""': ""}
    if text in words:
        return words[text]
    numbers = re.fullmatch(r"\(?(-?[\d.,e]+(?:,? -?[\d.e]+)*)\)?", text)
    if not numbers:
        raise UnreadableError
    parts = [float(part.replace(",", "")) for part in re.split(r",? ", numbers.group(1))]
    return parts[0] if len(parts) == 1 else tuple(parts)


def same(wanted: Any, got: Any) -> bool:
    if isinstance(wanted, tuple):
        return len(wanted) == len(got) and all(same(*pair) for pair in zip(wanted, got))
    if isinstance(wanted, bool):
        return got in (0, 1) and bool(got) is wanted
    if isinstance(wanted, float):
        return not isinstance(got, bool) and math.isclose(wanted, got, rel_tol=1e-6)
    return bool(wanted == got)


ILLUMINATION = "vtkIndirectIlluminationPass"


class Defaults(unittest.TestCase):
    """The defaults of the pages' tables are those of fresh objects."""

    TABLES = {
        ("guide.md", 0): ILLUMINATION,
        ("methods/area-lights.md", 0): "vtkAreaLight",
        ("methods/gather.md", 0): "vtkRSMGatherPass",
        ("methods/importance-sampling.md", 0): "vtkUniformLightSampler",
        ("methods/importance-sampling.md", 1): "vtkImportanceLightSampler",
        ("methods/light-tree.md", 0): "vtkLightTreeSampler",
        ("methods/multiresolution-splatting.md", 0): "vtkMultiresolutionSplattingPass",
        ("methods/occupancy.md", 0): "vtkRSMGatherPass",
        ("methods/penumbra.md", 0): ILLUMINATION,
        ("methods/radiance-hints.md", 0): "vtkRadianceHintsPass",
        ("methods/random-walk.md", 0): "vtkRandomWalkLightSampler",
        ("methods/sphere-proxies.md", 0): "vtkProxyAccumulationPass",
        ("methods/sphere-proxies.md", 1): "vtkSphereProxyFilter",
        ("methods/sphere-proxies.md", 2): "vtkMeshSimplificationFilter",
        ("methods/splatting.md", 0): "vtkIndirectSplattingPass",
    }
    IN_WORDS = {
        "guide.md Estimator": "the pass has none, and chooses one when it draws",
        "guide.md Sampler": "as above",
        "guide.md DelegatePass": "the pass has none, and makes a sequence when it draws",
        "methods/area-lights.md Origin": "a square, see test_square",
        "methods/area-lights.md Point1": "as above",
        "methods/area-lights.md Point2": "as above",
    }

    def test_tables(self) -> None:
        in_words = set()
        seen = set()
        compared = 0
        for row in property_rows():
            self.assertIn(row.table, self.TABLES, "a table of properties of which class?")
            seen.add(row.table)
            if not wrapped.has(self.TABLES[row.table]):
                continue
            target = wrapped.get(self.TABLES[row.table])()
            where = f"{row.table[0]} {row.name}"
            with self.subTest(where):
                try:
                    wanted = read(row.default, target, row.name)
                except UnreadableError:
                    in_words.add(where)
                    continue
                get = getattr(target, f"Get{row.name}")
                # The size of a light belongs to the light.
                got = get(vtkLight()) if row.table[0].endswith("penumbra.md") else get()
                self.assertTrue(same(wanted, got), f"'{row.default}' is {got!r}")
                compared += 1
        self.assertEqual(seen, set(self.TABLES))
        self.assertEqual(in_words, set(self.IN_WORDS))
        self.assertGreater(compared, 70)

    def test_square(self) -> None:
        lamp = wrapped.get("vtkAreaLight")()
        origin, *points = lamp.GetOrigin(), lamp.GetPoint1(), lamp.GetPoint2()
        for point, edge in zip(points, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))):
            self.assertEqual(tuple(b - a for a, b in zip(origin, point)), edge)
        self.assertEqual(origin[2], 0.0)
