# SPDX-License-Identifier: BSD-3-Clause
"""Check that this package fits the Python and the VTK that it is imported with.

Its libraries use VTK's classes as they were laid out when it was built. With another VTK, be it
another patch release or another build of the same one, the process ends at some call into them, so
that they must not even be loaded then. The check is done before.
"""

from __future__ import annotations

import ctypes
import importlib
import os
import sys
from types import ModuleType
from typing import Any


def _is_loaded(library: str) -> bool:
    """Return whether the process has a shared library, by its SONAME, already."""
    try:
        ctypes.CDLL(library, mode=os.RTLD_NOLOAD | os.RTLD_LAZY)
    except OSError:
        return False
    return True


def _remedy(configuration: Any, version: str, place: str) -> str:
    """Return what to do about another VTK that comes first."""
    packaged = {"site-packages", "dist-packages"} & set(place.split(os.sep))
    own = f"VTK {configuration.VTK} (Debian: python3-vtk9)"
    if packaged and not place.startswith("/usr/lib/"):
        first = (
            "take PyPI's out of the way (python3 -m pip uninstall vtk; a virtual environment needs "
            f"--system-site-packages) and use {own}"
        )
    else:
        first = f"start the Python that has {own}"
    return f"{first}, or build vtkindirect with VTK {version}"


def problem(configuration: Any, vtk: ModuleType) -> str | None:
    """Return why libraries that were built with a configuration cannot be loaded, or None.

    `configuration` is the module of what the build knows, `vtk` the module vtkCommonCore.
    """
    python = f"{sys.version_info[0]}.{sys.version_info[1]}"
    if configuration.PYTHON != python:
        return f"it was built for Python {configuration.PYTHON}, and this is Python {python}"
    number = vtk.vtkVersion
    version = ".".join(
        str(part)
        for part in (
            number.GetVTKMajorVersion(),
            number.GetVTKMinorVersion(),
            number.GetVTKBuildVersion(),
        )
    )
    place = os.path.dirname(vtk.__file__ or "")
    if configuration.VTK != version:
        return (
            f"it was built for VTK {configuration.VTK}, and this Python has VTK {version} "
            f"({place}); it needs exactly its own version: {_remedy(configuration, version, place)}"
        )
    library = configuration.VTK_LIBRARY
    if library and not _is_loaded(library):
        return (
            f"it was built for another VTK {configuration.VTK} than this Python has ({place}), "
            f"which does not use {library}: {_remedy(configuration, version, place)}"
        )
    return None


def check() -> None:
    """Raise an ImportError that says what does not fit, before it can end the process."""
    try:
        configuration = importlib.import_module("vtkindirect._configuration")
        vtk = importlib.import_module("vtkmodules.vtkCommonCore")
    except ImportError:  # no build, or no VTK: nothing to load, or an error when it is needed
        return
    reason = problem(configuration, vtk)
    if reason is not None:
        raise ImportError(f"vtkindirect cannot be used here: {reason}")
