# SPDX-License-Identifier: BSD-3-Clause
"""Folder of the demonstration scenes: beside the sources, or installed."""

from __future__ import annotations

import os
from pathlib import Path

from vtkindirect.errors import UsageError

DEMOS = ("room_fire", "apartment_living", "frog", "protein", "brain")


def scene_directory() -> Path:
    """Return the directory of the scenes; VTKINDIRECT_SCENES in the environment overrides it."""
    given = os.environ.get("VTKINDIRECT_SCENES")
    if given:
        return Path(given)
    try:
        from vtkindirect import _configuration
    except ImportError:
        raise UsageError(
            "the demonstration scenes are not known here: set VTKINDIRECT_SCENES to their directory"
        ) from None
    return (Path(__file__).resolve().parent / _configuration.SCENES).resolve()


def data_file(name: str) -> Path:
    """Return a data file of the demonstrations and examples; raises where it is not there."""
    path = scene_directory().parent / "Data" / name
    if not path.is_file():
        raise UsageError(f"{path}: no such file")
    return path


def demo_scene(name: str) -> Path:
    """Return the scene file of a demonstration."""
    return scene_directory() / f"{name}.json"
