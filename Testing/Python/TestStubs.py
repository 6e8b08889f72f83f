# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs: there for every wrapped class, whole, and signatures that say what they are."""

import ast
import inspect
import unittest
from pathlib import Path

import vtkindirect
from vtkindirect import wrapped

PACKAGE = Path(vtkindirect.__file__).parent


def names_in(body: list[ast.stmt]) -> set[str]:
    """Return what the statements of a stub define or import."""
    found: set[str] = set()
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            found.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found.add(node.target.id)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            found.update(alias.asname or alias.name for alias in node.names)
    return found


def parsed(name: str) -> ast.Module:
    return ast.parse((PACKAGE / f"{name}.pyi").read_text(encoding="utf-8"))


class Stubs(unittest.TestCase):
    def test_the_package_says_that_it_is_typed(self) -> None:
        self.assertTrue((PACKAGE / "py.typed").is_file())

    def test_every_public_name_is_in_the_stub(self) -> None:
        known = names_in(parsed("__init__").body)
        self.assertEqual(set(vtkindirect.__all__) - known, set())
        self.assertIn("__version__", known)

    def test_every_class_is_in_its_modules_stub_with_all_its_members(self) -> None:
        stubs = {name: parsed(name) for name in wrapped.MODULES if not wrapped.missing(name)}
        self.assertIn("vtkRenderingIndirect", stubs)
        for name, kind in wrapped.CLASSES.items():
            body = stubs[kind.__module__.rpartition(".")[2]].body
            (node,) = [one for one in body if isinstance(one, ast.ClassDef) and one.name == name]
            public = {key for key in vars(kind) if not key.startswith("__")}
            self.assertEqual(public - names_in(node.body), set(), name)

    def test_names_in_types_are_known(self) -> None:
        for name in wrapped.MODULES:
            if wrapped.missing(name):
                continue
            body = parsed(name).body
            known = names_in(body) | {"int", "float", "str", "bool", "bytes", "None", "tuple"}
            for node in body:
                if not isinstance(node, ast.ClassDef):
                    continue
                inner = known | names_in(node.body)
                for function in node.body:
                    if isinstance(function, ast.FunctionDef):
                        types = [one.annotation for one in function.args.args if one.annotation]
                        for found in [*types, function.returns]:
                            used = {one.id for one in ast.walk(found) if isinstance(one, ast.Name)}
                            self.assertEqual(used - inner, set(), f"{node.name}.{function.name}")

    def test_an_overload_a_static_method_and_an_object_that_may_be_none(self) -> None:
        text = (PACKAGE / "vtkRenderingIndirect.pyi").read_text(encoding="utf-8")
        for line in (
            "    @overload\n"
            "    def SetRadiance(self, red: float, green: float, blue: float) -> None:",
            "    @staticmethod\n    def GetLightRadius(light: vtkLight | None) -> float:",
            "    def SetNumberOfLights(self, number: int) -> None:",
            "    def GetRadiance(self) -> tuple[float, float, float]:",
            "class vtkAreaLight(vtkIndirectEmitterBase):",
        ):
            self.assertIn(line, text)


class Signatures(unittest.TestCase):
    def test_no_default_is_an_address(self) -> None:
        for name in vtkindirect.__all__:
            thing = getattr(vtkindirect, name)
            if inspect.isfunction(thing) or thing is vtkindirect.Scene:
                members = [thing, *vars(thing).values()] if inspect.isclass(thing) else [thing]
                for member in filter(inspect.isfunction, members):
                    self.assertNotRegex(str(inspect.signature(member)), r"object object|0x", name)

    def test_help_of_enable(self) -> None:
        self.assertIn("environment: 'Any' = KEEP", str(inspect.signature(vtkindirect.enable)))
