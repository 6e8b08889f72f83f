# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of the tests of the pack. VTK_INDIRECT_BUILD in the environment is the build."""

from __future__ import annotations

import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD = Path(os.environ.get("VTK_INDIRECT_BUILD", HERE.parents[2] / "build"))
FLOOR = (2, 34)
"""The glibc that the pack needs, when it is made where Debian 12 or what is older runs."""


def run(*words: object, **options: object) -> subprocess.CompletedProcess[str]:
    """Run a command with nothing to read; what it prints is text."""
    return subprocess.run(
        [str(word) for word in words],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
        **options,
    )


def must(*words: object, **options: object) -> str:
    """Return what a command prints that has to succeed."""
    done = run(*words, **options)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.stdout}{done.stderr}")
    return done.stdout


def own_glibc() -> tuple[int, ...]:
    """The version of glibc that runs here."""
    return tuple(int(number) for number in platform.libc_ver()[1].split(".")[:2])


def floor() -> tuple[int, ...]:
    """Return the needs of a pack: newer systems ask for more than can be replaced."""
    return FLOOR if own_glibc() <= (2, 36) else own_glibc()


def glibc_option() -> list[str]:
    """The option that says so."""
    return ["--glibc", ".".join(map(str, floor()))]


def compiler(language: str) -> str:
    """The compiler of the build."""
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    return re.search(rf"^CMAKE_{language}_COMPILER:\w+=(.+)$", cache, re.MULTILINE)[1]


def compile_c(target: Path, text: str, *words: object) -> Path:
    """Compile text as C."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", suffix=".c") as source:
        source.write(text)
        source.flush()
        must(compiler("C"), "-O2", "-Wall", "-o", target, source.name, *words)
    return target


def require(*tools: str) -> None:
    """Skip what needs a tool that is missing."""
    for tool in tools:
        if not shutil.which(tool):
            raise unittest.SkipTest(f"{tool} is missing")


def temporary(case: type[unittest.TestCase]) -> Path:
    """A folder for a class of tests."""
    holder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
    case.addClassCleanup(holder.cleanup)
    return Path(holder.name)


def closure(folder: Path, *programs: str) -> None:
    """Pack programs without an archive."""
    folder.mkdir(parents=True)
    must(
        *(sys.executable, "-B", HERE / "closure.py", folder, "--build", BUILD),
        *(*glibc_option(), *programs),
    )
