#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the type stubs of the package: what editors complete, and type checkers read.

    stubs.py PACKAGE

PACKAGE is the folder `vtkindirect` of a build tree. For each module of wrapped C++ classes there is
a stub beside it, made of the signatures in the docstrings that VTK's wrapping writes, and
``__init__.pyi`` says where the package's names come from. Modules in Python have their types in the
source. The build runs it; VTK's own generator, which does the same for VTK, came later than 9.1.
"""

from __future__ import annotations

import ast
import builtins
import importlib
import keyword
import re
import sys
import textwrap
import types
from pathlib import Path
from typing import Any

HEAD = (
    "# SPDX-License-Identifier: BSD-3-Clause\n"
    "# Made by stubs.py from the docstrings; not to be edited.\n"
)
INDENT = " " * 4

_PLAIN = {"int", "float", "str", "bool", "bytes", "None", "object", "type"}


def load(package: Path) -> Any:
    """Return the package's module of wrapped classes, without what the rest of it imports."""
    stand_in = types.ModuleType("vtkindirect")
    stand_in.__path__ = [str(package)]
    sys.modules["vtkindirect"] = stand_in
    return importlib.import_module("vtkindirect.wrapped")


def _parts(text: str) -> list[str]:
    """Split at the commas that no bracket holds."""
    parts, depth, part = [], 0, ""
    for character in text:
        depth += (character in "([") - (character in ")]")
        if character == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += character
    return [*parts, part.strip()] if part.strip() else parts


class Module:
    """The stub of one module, and what it has to import."""

    def __init__(self, classes: dict[str, type]) -> None:
        self.classes = classes
        self.typing: set[str] = set()
        self.imports: dict[str, set[str]] = {}

    def _class(self, name: str) -> str:
        """Return the name of a class, which is then imported; one that nobody knows is Any."""
        if name in self.classes:
            return name
        for module in sorted(name for name in sys.modules if name.startswith("vtkmodules.vtk")):
            found = vars(sys.modules[module]).get(name)
            if isinstance(found, type):
                self.imports.setdefault(found.__module__, set()).add(name)
                return name
        self.typing.add("Any")
        return "Any"

    def type_of(self, text: str, argument: bool) -> str:
        """Return a type of VTK's docstrings as Python writes it.

        VTK writes into what is a list, takes any sequence for what is a tuple, and None for what is
        an object.
        """
        text = text.strip()
        if text in _PLAIN:
            return text
        if text[:1] in "([" and text[-1:] in ")]":
            inner = [self.type_of(part, argument) for part in _parts(text[1:-1])]
            if text[0] == "[" or argument:
                kind = "MutableSequence" if text[0] == "[" else "Sequence"
                self.typing.add(kind)
                return f"{kind}[{inner[0]}]"
            return f"tuple[{', '.join(inner)}]"
        if re.fullmatch(r"vtk\w+", text):
            found = self._class(text)
            return f"{found} | None" if argument and found != "Any" else found
        self.typing.add("Any")  # pointers, callbacks
        return "Any"

    def _argument(self, text: str) -> str:
        name, _, kind = text.partition(":")
        kind, equals, _ = kind.partition("=")
        name = f"{name}_" if keyword.iskeyword(name) else name
        if name in ("self", "...") or not kind:
            return "*args: Any" if name == "..." else name
        return f"{name}: {self.type_of(kind, True)}" + (" = ..." if equals else "")

    def signatures(self, name: str, doc: str) -> tuple[list[tuple[str, str]], str]:
        """Return the arguments and the result of each overload in a docstring, and its words."""
        found = []
        pattern = rf"^{name}\((?P<arguments>.*?)\)(?: -> (?P<result>.*?))?\nC\+\+:.*?(?:;|$)\n?"
        matches = list(re.finditer(pattern, doc, re.MULTILINE | re.DOTALL))
        for match in matches:
            arguments = [self._argument(part) for part in _parts(" ".join(match[1].split()))]
            result = self.type_of(" ".join((match[2] or "None").split()), False)
            found.append((", ".join(arguments), result))
        words = doc[matches[-1].end() :] if matches else doc
        return list(dict.fromkeys(found)), words.strip()

    def _method(self, name: str, doc: str) -> list[str]:
        found, words = self.signatures(name, doc)
        if not found:
            self.typing.add("Any")
            found = [("*args: Any, **kwargs: Any", "Any")]
            return ["@staticmethod", f"def {name}({found[0][0]}) -> Any: ..."]
        lines = []
        for arguments, result in found:
            if len(found) > 1:
                self.typing.add("overload")
                lines.append("@overload")
            if arguments.split(",")[0] != "self":
                lines.append("@staticmethod")
            lines.append(f"def {name}({arguments}) -> {result}:" + ("" if words else " ..."))
            if words:
                lines += _docstring(words)
                words = ""
        return lines

    def _of_class(self, name: str, kind: type) -> list[str]:
        bases = [base.__name__ for base in kind.__bases__ if base is not object]
        known = [base if base in vars(builtins) else self._class(base) for base in bases]
        lines = [f"class {name}{'(' + ', '.join(known) + ')' if known else ''}:"]
        doc = (kind.__doc__ or "").strip()
        body = _docstring(doc) if doc else []
        members = {key: value for key, value in vars(kind).items() if not key.startswith("__")}
        for key, value in members.items():
            if isinstance(value, type):
                body.append(f"{INDENT}class {key}({value.__bases__[0].__name__}): ...")
        for key, value in members.items():
            if isinstance(value, int):
                body.append(f"{INDENT}{key}: {type(value).__name__}")
            elif not callable(value):  # properties, which newer versions of VTK have
                self.typing.add("Any")
                body.append(f"{INDENT}{key}: Any")
        for key, value in members.items():
            if callable(value) and not isinstance(value, type):
                body += [INDENT + line for line in self._method(key, value.__doc__ or "")]
        return [*lines, *(body or [f"{INDENT}..."])]

    def text(self) -> str:
        """Return the stub."""
        body: list[str] = []
        for name, kind in self.classes.items():
            body += ["", *self._of_class(name, kind)]
        lines = ["from __future__ import annotations", ""]
        lines += [f"from typing import {', '.join(sorted(self.typing))}"] if self.typing else []
        for module, names in sorted(self.imports.items()):
            lines.append(f"from {module} import {', '.join(sorted(names))}")
        return HEAD + "\n".join([*lines, *body]) + "\n"


def _docstring(text: str) -> list[str]:
    """Return the lines of a docstring, indented by one level."""
    safe = text.replace("\\", "\\\\").replace('"""', "'''")
    safe = f"{safe} " if safe.endswith('"') else safe
    return textwrap.indent(f'"""{safe}"""', INDENT).splitlines()


def of_package(source: str, classes: dict[str, type]) -> str:
    """Return the stub of the package: its imports of its own names, and all wrapped classes."""
    lines = []
    public = []
    for node in ast.parse(source).body:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("vtkindirect."):
            for alias in node.names:
                if alias.asname is None:
                    lines.append(f"from {node.module} import {alias.name} as {alias.name}")
                    public.append(alias.name)
    for name, kind in sorted(classes.items()):
        lines.append(f"from {kind.__module__} import {name} as {name}")
        public.append(name)
    names = "".join(f'{INDENT}"{name}",\n' for name in public)
    return f"{HEAD}" + "\n".join(lines) + f"\n\n__version__: str\n__all__ = [\n{names}]\n"


def main() -> int:
    """Write all stubs; returns the exit code."""
    package = Path(sys.argv[1])
    classes = load(package).CLASSES
    by_module: dict[str, dict[str, type]] = {}
    for name, kind in classes.items():
        by_module.setdefault(kind.__module__, {})[name] = kind
    for module, found in by_module.items():
        path = package / f"{module.rpartition('.')[2]}.pyi"
        path.write_text(Module(found).text(), encoding="utf-8")
    source = (package / "__init__.py").read_text(encoding="utf-8")
    (package / "__init__.pyi").write_text(of_package(source, classes), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
