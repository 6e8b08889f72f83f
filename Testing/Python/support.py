# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of several tests: places, a small scene, and a directory that is removed."""

from __future__ import annotations

import contextlib
import copy
import importlib
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

import numpy as np

TESTING = Path(__file__).resolve().parent.parent
SOURCE = TESTING.parent
DATA = TESTING / "Data"
SCENES = TESTING / "Scenes"

SMALL: dict[str, Any] = {
    "schema": "vtkindirect.scene/1",
    "name": "small",
    "size": [64, 48],
    "camera": {"position": [0.5, 0.8, 3], "focal_point": [0.5, 0.4, 0]},
    "lights": [
        {
            "type": "spot",
            "position": [1.5, 1.5, 1.5],
            "focal_point": [0.5, 0, 0.3],
            "cone_angle": 40,
        }
    ],
    "actors": [
        {
            "name": "floor",
            "source": "plane",
            "origin": [0, 0, 1],
            "point1": [1, 0, 1],
            "point2": [0, 0, 0],
            "color": [0.8, 0.1, 0.1],
        },
        {
            "name": "wall",
            "source": "plane",
            "origin": [0, 0, 0],
            "point1": [1, 0, 0],
            "point2": [0, 1, 0],
            "color": [0.8, 0.8, 0.8],
        },
    ],
}


def small_scene() -> dict[str, Any]:
    """Return a scene document that a test may change."""
    return copy.deepcopy(SMALL)


class DirectoryTest(unittest.TestCase):
    """A test with a directory of its own."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
        self.addCleanup(holder.cleanup)
        self.directory = Path(holder.name)

    def write(self, name: str, content: Any) -> Path:
        """Write a file of text, bytes or JSON."""
        path = self.directory / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def names(self) -> list[str]:
        """Return the names of all files in the directory, hidden ones too."""
        return sorted(os.listdir(self.directory))


def command_line(*words: Any, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run the command line in a process of its own."""
    return subprocess.run(
        [sys.executable, "-B", "-m", "vtkindirect", *map(str, words)],
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
        check=False,
    )


def command_line_here(*words: Any, **how: Any) -> subprocess.CompletedProcess[str]:
    """Run the command line in this process, which need not load VTK again.

    Its words are those in the descriptors 1 and 2, so that words of VTK's C++ are seen as they are
    of a process of its own. `how` goes to `cli.main`.
    """
    from vtkindirect import cli

    with contextlib.ExitStack() as stack:
        files = []
        for number, name in ((1, "stdout"), (2, "stderr")):
            getattr(sys, name).flush()
            file = stack.enter_context(tempfile.TemporaryFile("w+", encoding="utf-8"))
            kept = os.dup(number)
            stack.callback(os.close, kept)
            stack.callback(os.dup2, kept, number)
            os.dup2(file.fileno(), number)
            stream = stack.enter_context(open(number, "w", encoding="utf-8", closefd=False))
            redirect = contextlib.redirect_stdout if number == 1 else contextlib.redirect_stderr
            stack.enter_context(redirect(stream))
            files.append(file)
        try:
            code = cli.main(list(map(str, words)), **how)
        except SystemExit as end:  # of --help
            code = end.code or 0
        sys.stdout.flush()
        sys.stderr.flush()
        said = []
        for file in files:
            file.seek(0)
            said.append(file.read())
    return subprocess.CompletedProcess(words, code, *said)


def why_no_rendering() -> str | None:
    """Return why nothing can be rendered here, or None."""
    from vtkindirect import RenderError, render_window, windows, wrapped

    if not wrapped.has("vtkIndirectIlluminationPass"):
        return wrapped.explain("vtkIndirectIlluminationPass")
    try:
        window = render_window((8, 8), offscreen=True)
        windows.start(window)
        window.Finalize()
    except RenderError as error:
        return str(error)
    return None


def why_no_pyvista() -> str | None:
    """Return why there is no PyVista to test with, or None."""
    try:
        importlib.import_module("pyvista")
    except Exception as error:  # one that is older or newer than VTK fails in any way
        return f"PyVista cannot be imported ({error}); ./bootstrap test fetches it for the tests"
    return None


@contextlib.contextmanager
def quiet():
    """VTK's errors are kept in the window that this gives, and not printed."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    before = vtkOutputWindow.GetInstance()
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window
    finally:
        vtkOutputWindow.SetInstance(before)


def noise(shape: tuple[int, ...], seed: int = 1) -> np.ndarray:
    """Uniform values in [0, 1), the same on every machine."""
    count = int(np.prod(shape))
    state = (np.arange(count, dtype=np.uint64) + np.uint64(seed * 7919)) * np.uint64(
        0x9E3779B97F4A7C15
    )
    state ^= state >> np.uint64(31)
    state *= np.uint64(0xBF58476D1CE4E5B9)
    state ^= state >> np.uint64(29)
    return ((state >> np.uint64(11)).astype(np.float64) / 2.0**53).reshape(shape)


def sweep_of(*rows: dict[str, Any]) -> dict[str, Any]:
    """A sweep document with these rows."""
    from vtkindirect import sweep

    return {"schema": sweep.SCHEMA, "rows": list(rows)}
