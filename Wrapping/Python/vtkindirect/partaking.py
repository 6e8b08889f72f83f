# SPDX-License-Identifier: BSD-3-Clause
"""Says once what a scene draws that takes no part in indirect light."""

from __future__ import annotations

import json
import warnings
from typing import Any

from vtkmodules.vtkRenderingCore import vtkRenderer

from vtkindirect import messages

_ANNOTATION = "drawn as colour"
"""Annotation, widgets and skies: nobody expects light from these."""


class Warner:
    """The one warning of a renderer.

    It comes after the first frame that leaves a prop out, and names all props that this frame
    leaves out.
    """

    def __init__(self) -> None:
        self._seen = -1
        self._changed = True
        self._done = False

    def start(self, renderer: vtkRenderer) -> None:
        """Before a frame, and before its ground comes: see whether props have changed."""
        self._changed = renderer.GetViewProps().GetMTime() != self._seen

    def look(self, renderer: vtkRenderer, indirect: Any) -> None:
        """After a frame: warn, if the frame is the first to leave out a prop of the renderer."""
        self._seen = renderer.GetViewProps().GetMTime()
        if self._done or not self._changed:
            return
        left_out = props_left_out(json.loads(indirect.GetReport(False)))
        if left_out:
            self._done = True
            warnings.warn(
                "without a part in indirect light: "
                + "; ".join(f"{what}: {why}" for what, why in left_out),
                stacklevel=messages.users_level(),
            )


def props_left_out(report: dict[str, Any]) -> list[tuple[str, str]]:
    """Return the props that a frame left out of indirect light, but for annotation, and why."""
    return [
        (entry["what"], entry["why"])
        for entry in report["left_out"]
        if entry["what"].startswith("vtk") and not entry["why"].startswith(_ANNOTATION)
    ]
