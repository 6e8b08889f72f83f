# SPDX-License-Identifier: BSD-3-Clause
"""Real-time indirect illumination for VTK.

All C++ classes of the project are here by their VTK names, such as `vtkIndirectIlluminationPass`,
together with helpers::

    import vtkindirect
    vtkindirect.enable(renderer)             # or a render window, or a PyVista plotter
    vtkindirect.disable(renderer)

    scene = vtkindirect.load_scene("room.json")
    window = scene.make_window()
    vtkindirect.enable(scene.renderer, "gather", number_of_lights=256)
    window.Render()
    light = vtkindirect.copy_buffer(scene.renderer, "indirect")
"""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.util
import sys
from typing import Any

if sys.argv[:1] == ["-m"]:  # `python3 -m vtkindirect` imports the package before its __main__
    from vtkindirect import interrupts as _interrupts

    _interrupts.end_program()

from vtkindirect import compatibility as _compatibility  # noqa: E402

_compatibility.check()  # before anything below loads the libraries

from vtkindirect import wrapped as _wrapped  # noqa: E402
from vtkindirect.errors import IndirectError, RenderError, SceneError, UsageError  # noqa: E402
from vtkindirect.images import copy_buffer  # noqa: E402
from vtkindirect.methods import METHODS, SAMPLERS, disable, enable, pass_of, report  # noqa: E402
from vtkindirect.scene import Scene, load_scene  # noqa: E402
from vtkindirect.screenshots import screenshot  # noqa: E402
from vtkindirect.windows import has_display, render_window, use_headless  # noqa: E402

try:
    from vtkindirect._configuration import VERSION as __version__
except ImportError:  # used from the source tree, without a build
    __version__ = "0"

globals().update(_wrapped.CLASSES)

__all__ = [
    "METHODS",
    "SAMPLERS",
    "IndirectError",
    "RenderError",
    "Scene",
    "SceneError",
    "UsageError",
    "copy_buffer",
    "disable",
    "enable",
    "has_display",
    "load_scene",
    "pass_of",
    "render_window",
    "report",
    "screenshot",
    "use_headless",
    *sorted(_wrapped.CLASSES),
]


def __getattr__(name: str) -> Any:
    """Return the tests' oracle; say why a class is missing when its module was not built."""
    if name == _wrapped.ORACLE:
        return _wrapped.get(name)
    reason = _wrapped.explain(name)
    if reason is not None:
        raise ImportError(reason)
    raise AttributeError(f"module 'vtkindirect' has no attribute '{name}'")


class _RegisterAfterPyVista(importlib.abc.MetaPathFinder):
    """Import `vtkindirect.plotter` at the end of the first import of PyVista.

    PyVista 0.48 finds the component by its entry point as well; earlier ones look for none.
    """

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Any:
        """Return PyVista's own spec, whose loader registers the component afterwards."""
        if fullname != "pyvista":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(fullname)
        if spec is not None and spec.loader is not None:
            execute = spec.loader.exec_module

            def exec_module(module: Any) -> None:
                execute(module)
                importlib.import_module("vtkindirect.plotter")

            spec.loader.exec_module = exec_module
        return spec


if "pyvista" in sys.modules:
    importlib.import_module("vtkindirect.plotter")
else:
    sys.meta_path.insert(0, _RegisterAfterPyVista())
