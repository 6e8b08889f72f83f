# SPDX-License-Identifier: BSD-3-Clause
"""Names of props, by which reports and errors call them."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer

from vtkindirect import wrapped


def give(prop: vtkProp, name: str) -> None:
    """Give a prop a name, unless the passes, which read it, were not built."""
    if not wrapped.has("vtkIndirectIlluminationPass"):
        return
    keys = prop.GetPropertyKeys()
    if keys is None:
        keys = vtkInformation()
        prop.SetPropertyKeys(keys)
    key = wrapped.get("vtkIndirectIlluminationPass").NAME()
    if keys.Get(key) != name:
        keys.Set(key, name)


def take_pyvistas(renderer: vtkRenderer, known: tuple[str, ...]) -> tuple[str, ...]:
    """Give the actors of PyVista's renderer the names that users gave them; returns all names.

    Nothing is done where these are `known`. Names that PyVista makes of addresses say nothing.
    """
    actors: Any = getattr(renderer, "actors", None)
    if not hasattr(actors, "items"):
        return ()
    there = tuple(actors)
    if there != known:
        for name, actor in actors.items():
            if isinstance(actor, vtkProp) and "Addr=" not in name:
                give(actor, name)
    return there
