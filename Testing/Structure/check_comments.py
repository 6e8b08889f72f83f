#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that comments are sentences of their own, and that what they name is there.

    Testing/Structure/check_comments.py [ROOT]

A sentence in a comment or a docstring does not begin with one of `WORDS`: "Whether it is drawn" has
no subject but the name below it. A class, function or file of this project that a comment names
(`NAME`) is in the code.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from faults import check

FOLDERS = ("Module", "Testing", "Wrapping")
WORDS = "How|Of|That|Those|What|Whether|Whose|Why"
FAULT = re.compile(rf"(?:^|[.!?]['\"`)]* +)({WORDS})\b")
"""A word at the beginning of a line, or after the end of a sentence."""

NAME = re.compile(r"\b(?:vtki[A-Z]|vtkIndirect)\w*[a-z0-9]\b")

SLASHES = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
HASHES = re.compile(r"#[^\n]*|^[ \t]*r?\"{3}.*?\"{3}", re.DOTALL | re.MULTILINE)
COMMENTS = {suffix: SLASHES for suffix in (".c", ".cxx", ".glsl", ".h")} | {
    suffix: HASHES for suffix in ("", ".cmake", ".py", ".txt")
}
"""Comments and docstrings, by the ending of a file."""

MARK = re.compile(r"^\s*(?://+[/<!]*|/?\*+|#+|r?\"{3})?\s*")


def find_faults(root: Path) -> list[str]:
    """Return a line for each sentence that begins with one of `WORDS`, and each name of nothing."""
    paths = [path for name in FOLDERS for path in sorted((root / name).rglob("*"))
             if path.suffix in COMMENTS and path.is_file()]  # fmt: skip
    faults = [] if len(paths) > 900 else [f"{root} has {len(paths)} sources only"]
    texts = {path: path.read_text(encoding="utf-8") for path in paths}
    known = {path.name.partition(".")[0] for path in (*paths, *(root / "CMake").iterdir())}
    for path, text in texts.items():
        known.update(NAME.findall(COMMENTS[path.suffix].sub("", text)))
    for path, text in texts.items():
        for comment in COMMENTS[path.suffix].finditer(text):
            first = text.count("\n", 0, comment.start()) + 1
            for number, line in enumerate(comment[0].splitlines(), first):
                faults += [f"{path.relative_to(root)}:{number}: a sentence begins with {word!r}"
                           for word in FAULT.findall(MARK.sub("", line))]  # fmt: skip
                faults += [f"{path.relative_to(root)}:{number}: there is no {name}"
                           for name in NAME.findall(line) if name not in known]  # fmt: skip
    return faults


if __name__ == "__main__":
    sys.exit(check(find_faults))
