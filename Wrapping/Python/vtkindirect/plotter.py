# SPDX-License-Identifier: BSD-3-Clause
"""``plotter.indirect`` for PyVista 0.48 and later; earlier ones use `vtkindirect.enable(plotter)`.

Importing this module registers the component. Any object with a vtkRenderer called ``renderer``
will do for it.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from vtkindirect import images, methods, screenshots

NAME = "indirect"


class IndirectComponent:
    """Indirect light of a plotter's active subplot."""

    def __init__(self, plotter: Any) -> None:
        self._plotter = plotter
        self._renderers: list[Any] = []

    def enable(self, method: str = "auto", sampler: str | None = None, **settings: Any) -> Any:
        """Switch indirect light on; see `vtkindirect.enable`. Returns the pass."""
        result = methods.enable(self._plotter, method, sampler, **settings)
        self._renderers.append(self._plotter.renderer)
        return result

    def disable(self) -> None:
        """Switch indirect light off and restore the pass that was there before."""
        methods.disable(self._plotter)

    @property
    def enabled(self) -> bool:
        """Return whether indirect light is on in the active subplot."""
        return methods.pass_of(self._plotter) is not None

    def report(self) -> dict[str, Any]:
        """Return what the last frame decided and how long it took."""
        return methods.report(self._plotter)

    def copy_buffer(self, name: str) -> np.ndarray:
        """Return a buffer of the last frame, bottom row first."""
        return images.copy_buffer(self._plotter, name)

    def screenshot(
        self,
        path: str | os.PathLike[str] | None = None,
        scale: int = 1,
        transparent: bool = False,
    ) -> np.ndarray:
        """Return a finished picture, also before `show`; see `vtkindirect.screenshot`."""
        return screenshots.screenshot(self._plotter, path, scale, transparent)

    def __plotter_close__(self) -> None:
        for renderer in self._renderers:
            methods.disable(renderer)
        self._renderers.clear()


def _explain(_plotter: Any) -> Any:
    import pyvista

    raise AttributeError(
        f"plotter.{NAME} needs PyVista 0.48 or later, and this is {pyvista.__version__}: call "
        "vtkindirect.enable(plotter), and vtkindirect.disable, report, copy_buffer and screenshot "
        "likewise"
    )


def register() -> bool:
    """Register the component with PyVista; returns whether there is a PyVista that has them.

    Plotters of an earlier one say what to call in its place.
    """
    try:
        import pyvista
    except Exception:  # one that is older or newer than VTK or Python fails in any way
        return False
    there = NAME in vars(pyvista.BasePlotter)
    if not hasattr(pyvista, "register_plotter_component"):
        if not there:
            setattr(pyvista.BasePlotter, NAME, property(_explain))
        return False
    if not there:
        pyvista.register_plotter_component(NAME)(IndirectComponent)
    return True


register()
