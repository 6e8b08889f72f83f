# SPDX-License-Identifier: BSD-3-Clause
"""The reference environment: another Python, with a path tracer and HDR-FLIP.

Testing/Reference/make_environment makes it; nothing in it is imported here. Both are programs that
are run beside this one, and a comparison without them says that they are left out, and why.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from vtkindirect import metrics
from vtkindirect.errors import IndirectError, RenderError, UsageError

VARIABLE = "VTKINDIRECT_REFERENCE_PYTHON"
NONE = "none"
SOURCES = Path(__file__).resolve().parents[1]


class LeftOut(IndirectError):
    """Something that a comparison goes without; the text says why."""


def find_python(given: str | None) -> Path:
    """The Python of the reference environment; raises `LeftOut` when there is none.

    `given` comes first, then the environment variable, then where make_environment puts it. A
    Python that was named and is not there is a `UsageError`; "none" says that none is wanted.
    """
    named = given or os.environ.get(VARIABLE)
    if named == NONE:
        raise LeftOut("it was asked to be left out (--reference-python none)")
    if named:
        if not os.access(named, os.X_OK) or Path(named).is_dir():
            where = "--reference-python" if given else VARIABLE
            raise UsageError(f"{where}: {named}: is no program")
        return Path(named)
    python = SOURCES.parent / "build" / "reference-venv" / "bin" / "python"
    if python.exists():
        return python
    raise LeftOut(
        "there is no reference environment; Testing/Reference/make_environment makes it, "
        "--reference-python names another"
    )


class Worker:
    """A program that the reference environment's Python runs once and that answers line by line."""

    program: str
    """File name of the program, beside this module."""
    package: str
    """Name of the package that does the work; the program's first line is that and its version."""
    task: str
    """Name of the work, for errors."""

    def __init__(self, python: Path) -> None:
        worker = SOURCES / "Benchmark" / self.program
        self._folder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
        self._process = subprocess.Popen(
            [str(python), "-I", "-B", str(worker), metrics.__file__],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert self._process.stdout is not None
        self.version = self._process.stdout.readline().strip()
        if not self.version.startswith(self.package):
            raise LeftOut(f"{python}: {self.close()}")

    def ask(self, **arrays: np.ndarray) -> tuple[float, Path]:
        """The number that the program answers for arrays, and the file that holds the arrays."""
        path = Path(self._folder.name) / "images.npz"
        np.savez(path, **arrays)
        assert self._process.stdin is not None and self._process.stdout is not None
        try:
            self._process.stdin.write(f"{path}\n")
            self._process.stdin.flush()
            answer = self._process.stdout.readline().strip()
        except OSError:
            answer = ""
        try:
            return float(answer), path
        except ValueError:
            raise RenderError(f"{self.task} failed: {answer or self.close()}") from None

    def close(self) -> str:
        """End the process; returns the last line of its complaints."""
        if self._process.poll() is None and self._process.stdin is not None:
            self._process.stdin.close()
        assert self._process.stdout is not None and self._process.stderr is not None
        self._process.stdout.close()
        lines = self._process.stderr.read().strip().splitlines()
        self._process.stderr.close()
        self._process.wait()
        self._folder.cleanup()
        return lines[-1] if lines else "it ended without a word"


class Flip(Worker):
    """HDR-FLIP."""

    program = "flip_worker.py"
    package = "flip-evaluator"
    task = "HDR-FLIP"

    def error(self, image: np.ndarray, reference: np.ndarray, mask: np.ndarray) -> float:
        """HDR-FLIP of an image; see `flip_worker.flip`."""
        return self.ask(image=image, reference=reference, mask=mask)[0]


class Denoiser(Worker):
    """Intel's Open Image Denoise."""

    program = "denoise_worker.py"
    package = "pyoidn"
    task = "denoising"

    def denoised(
        self, image: np.ndarray, normal: np.ndarray, repeats: int = 3
    ) -> tuple[np.ndarray, float]:
        """An image of irradiance without noise, and the median seconds of so many times."""
        seconds, path = self.ask(image=image, normal=normal, repeats=np.array(repeats))
        return np.load(f"{path}.denoised.npy").astype(np.float64), seconds


@dataclass(frozen=True)
class Traced:
    """A traced image of irradiance, and the seconds of each repetition."""

    name: str
    image: np.ndarray
    seconds: list[float]


def trace(
    python: Path, scene: Path, size: tuple[int, int], rows: list[dict[str, Any]]
) -> Iterator[Traced]:
    """Trace a scene file for each row ({"name", "samples", "depth", maybe "azimuth"}), in order.

    Raises `RenderError` when tracing fails; rows that were yielded before that are good.
    """
    with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
        places = [str(Path(metrics.__file__).resolve().parents[1]), os.environ.get("PYTHONPATH", "")]
        with subprocess.Popen(
            [sys.executable, "-B", str(SOURCES / "Reference" / "trace_rows.py"), str(scene.resolve()), name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={
                **os.environ,
                "PYTHONPATH": os.pathsep.join(filter(None, places)),
                VARIABLE: str(python),
            },
        ) as process:
            assert process.stdin and process.stdout and process.stderr
            try:
                process.stdin.write(json.dumps({"size": list(size), "rows": rows}))
                process.stdin.close()
            except BrokenPipeError:
                pass  # what it complained about is read below
            for line in process.stdout:
                word, _, rest = line.strip().partition(" ")
                if word == "row":
                    with np.load(Path(name) / f"{rest}.npz") as arrays:
                        seconds = np.atleast_1d(arrays["seconds"]).tolist()
                        image = arrays["image"].astype(np.float64)
                    yield Traced(rest, image, seconds)
            said = process.stderr.read().strip().splitlines()
        if process.returncode:
            raise RenderError(f"the path tracer failed: {said[-1] if said else 'no reason given'}")
