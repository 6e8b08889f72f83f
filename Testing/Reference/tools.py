# SPDX-License-Identifier: BSD-3-Clause
"""Tools of this folder's scripts: describing a scene file, and running the tracer."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from ctypes.util import find_library
from pathlib import Path
from typing import Any

import exporter
from description import Description

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
SCENES = HERE.parent / "Scenes"

# The exit code that CTest takes for a test that could not run.
SKIPPED = 125

# Older versions of LLVM load, and then compile one kernel for many minutes, or abort.
LLVM = ("LLVM-19", "LLVM-20", "LLVM-21")


class ToolError(Exception):
    """Something that the user can mend; the text is one line that says what."""


def tracer_python() -> Path:
    """Return the Python that has Mitsuba; VTKINDIRECT_REFERENCE_PYTHON overrides the default."""
    given = os.environ.get("VTKINDIRECT_REFERENCE_PYTHON")
    path = Path(given) if given else SOURCE / "build" / "reference-venv" / "bin" / "python"
    if not path.exists():
        raise ToolError(
            f"{path}: there is no path tracer; run Testing/Reference/make_environment, "
            "or set VTKINDIRECT_REFERENCE_PYTHON"
        )
    if not os.environ.get("DRJIT_LIBLLVM_PATH") and not any(map(find_library, LLVM)):
        raise ToolError(
            "the path tracer needs LLVM 19 and there is none; on Debian: apt-get install libllvm19, "
            "elsewhere DRJIT_LIBLLVM_PATH names a libLLVM.so"
        )
    return path


def describe(path: Path, azimuth: float = 0.0) -> Description:
    """Return what VTK draws of a scene file, with the camera turned by `azimuth` degrees."""
    import vtkindirect

    scene = vtkindirect.load_scene(path)
    if azimuth:
        camera = scene.renderer.GetActiveCamera()
        camera.Azimuth(azimuth)
        camera.OrthogonalizeViewUp()
    return exporter.export_renderer(
        scene.renderer,
        scene.name,
        scene.size,
        scene.actors.items(),
        scene.environment,
        scene.area_lights,
    )


def trace(
    folder: Path,
    job: dict[str, Any],
    on_progress: Callable[[float], None] | None = None,
    on_batch: Callable[[str], None] | None = None,
    niceness: int = 0,
) -> dict[str, str]:
    """Do a job of `tracer.py` in a description's folder; returns the tracer's versions.

    `on_progress` is called with the fraction of a batch that was done since the last call,
    `on_batch` with the file of a batch when it is there. A niceness of 10 makes the tracer a quiet
    neighbour for minutes of work that nobody waits for; tests and times need an equal share of the
    processor.
    """
    (folder / "job.json").write_text(json.dumps(job))
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    command = [tracer_python(), "-B", HERE / "tracer.py", folder, folder / "job.json"]
    versions: dict[str, str] = {}
    with subprocess.Popen(
        ["nice", "-n", str(niceness), *map(str, command)],
        stdout=subprocess.PIPE,
        text=True,
        env=environment,
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            word, _, rest = line.partition(" ")
            if word == "progress" and on_progress is not None:
                on_progress(float(rest))
            elif word == "batch" and on_batch is not None:
                on_batch(rest.rpartition(" ")[0])
            elif word == "versions":
                versions = json.loads(rest)
    if process.returncode:
        raise ToolError(f"the path tracer failed with exit code {process.returncode}")
    return versions


def fail(error: Exception) -> int:
    """Print one line about an error and return an exit code."""
    print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
    return 1
