# SPDX-License-Identifier: BSD-3-Clause
"""The C++ classes of this project, from whichever of its modules were built."""

from __future__ import annotations

import functools
import importlib
from types import ModuleType
from typing import Any

# The wrapped modules need the classes that theirs derive from, and rendering needs its factories.
for _name in (
    "vtkCommonExecutionModel",
    "vtkIOImage",
    "vtkRenderingCore",
    "vtkRenderingUI",
    "vtkRenderingOpenGL2",
    "vtkRenderingFreeType",
    "vtkRenderingVolumeOpenGL2",
    "vtkInteractionStyle",
):
    try:
        importlib.import_module(f"vtkmodules.{_name}")
    except ImportError as _error:
        if _name in ("vtkRenderingCore", "vtkRenderingOpenGL2"):
            raise ImportError(
                f"vtkindirect needs VTK's Python package with {_name} "
                f"(Debian: python3-vtk9): {_error}"
            ) from None

# Extension module -> what it is for and the classes by which it is missed.
MODULES = {
    "vtkRenderingIndirect": ("the render passes", ("vtkIndirectIlluminationPass",)),
    "vtkIndirectHeadless": (
        "rendering without a display (build option VTK_INDIRECT_ENABLE_HEADLESS, needs EGL)",
        ("vtkEGLHeadlessRenderWindow", "vtkIndirectHeadlessFactory"),
    ),
    "vtkIndirectOpenEXR": (
        "OpenEXR files (build option VTK_INDIRECT_ENABLE_OPENEXR, needs OpenEXR)",
        ("vtkOpenEXRReader", "vtkOpenEXRWriter"),
    ),
    "vtkIndirectProxies": (
        "spheres and simplified meshes in place of meshes "
        "(build option VTK_INDIRECT_ENABLE_PROXIES, needs OpenMesh)",
        ("vtkMeshSimplificationFilter", "vtkSphereProxyFilter"),
    ),
}


ORACLE = "vtkRSMReferencePass"
"""The class by which tests and comparisons judge the others. A build with tests has it."""


def _classes(module: ModuleType) -> dict[str, Any]:
    return {
        name: value
        for name, value in vars(module).items()
        if name.startswith("vtk") and isinstance(value, type)
    }


def _import() -> tuple[dict[str, Any], dict[str, ImportError]]:
    found: dict[str, Any] = {}
    missing: dict[str, ImportError] = {}
    for module_name in MODULES:
        try:
            module: ModuleType = importlib.import_module(f"vtkindirect.{module_name}")
        except ImportError as error:
            missing[module_name] = error
            continue
        found.update(_classes(module))
    return found, missing


CLASSES, _missing = _import()


@functools.lru_cache(maxsize=None)
def _oracle() -> dict[str, Any]:
    try:
        return _classes(importlib.import_module("vtkindirect.vtkIndirectOracle"))
    except ImportError:
        return {}


def _find(name: str) -> Any:
    return CLASSES.get(name) or (_oracle().get(name) if name == ORACLE else None)


def has(name: str) -> bool:
    """Return whether a C++ class of this project is there."""
    return _find(name) is not None


def missing(module_name: str) -> bool:
    """Return whether one of `MODULES` could not be imported."""
    return module_name in _missing


def explain(name: str) -> str | None:
    """Return why a class of this project is not there, or None for a name that is not one."""
    if name == ORACLE:
        return f"{ORACLE} is the oracle of the tests, which is built with them and not installed"
    for module_name, (purpose, names) in MODULES.items():
        if name in names and module_name in _missing:
            return (
                f"vtkindirect.{name} is not available: the module {module_name}, for {purpose}, "
                f"could not be imported ({_missing[module_name]})"
            )
    return None


def get(name: str) -> Any:
    """Return a C++ class of this project; an ImportError says why it is not there."""
    found = _find(name)
    if found is not None:
        return found
    raise ImportError(explain(name) or f"vtkindirect has no class {name}")
