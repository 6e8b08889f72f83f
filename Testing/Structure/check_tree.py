#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that the checkout holds sources alone: tests and programs write into the build tree.

    Testing/Structure/check_tree.py [CHECKOUT]

The root has the entries below and nothing else but build folders and hidden files. Where git knows
the checkout, no file that git holds is one that a build or a program makes.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from faults import check

ROOT = {
    "CHANGELOG.md",
    "CMake",
    "CMakeLists.txt",
    "CMakePresets.json",
    "CONTRIBUTING.md",
    "Documentation",
    "Examples",
    "LICENSE",
    "Module",
    "README.md",
    "Testing",
    "Wrapping",
    "bootstrap",
}
SCRATCH = re.compile(r"build|\.")
"""First letters of entries that a user or a build may put into the root; git ignores them."""

MADE = re.compile(
    r"(^|/)(__pycache__|\.pytest_cache|Temporary|CMakeFiles|LC_[A-Z]+)(/|$)"
    r"|\.(pyc|o|so|orig|rej|swp|log|tmp)$|~$"
)
"""Paths that compilers, editors, CTest and localedef make."""


def find_faults(root: Path) -> list[str]:
    """Return a line for each entry that does not belong into a checkout."""
    there = {path.name for path in root.iterdir() if not SCRATCH.match(path.name)}
    faults = [f"{name} is in the root of the checkout" for name in sorted(there - ROOT)]
    faults += [f"{name} is missing from the root" for name in sorted(ROOT - there)]
    try:
        listed = subprocess.run(
            ["git", "-C", str(root), "ls-files", "-z"], capture_output=True, check=False
        )
    except FileNotFoundError:  # no git: a copy of the sources
        return faults
    held = listed.stdout.decode().split("\0") if listed.returncode == 0 else []
    made = filter(MADE.search, held)
    return faults + [f"git holds {path}, which a program made" for path in made]


if __name__ == "__main__":
    sys.exit(check(find_faults))
