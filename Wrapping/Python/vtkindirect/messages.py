# SPDX-License-Identifier: BSD-3-Clause
"""Catches what VTK prints, so that a failed reader or shader becomes one line; whom warnings name."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from vtkmodules.vtkCommonCore import VTK_STRING, vtkLogger, vtkOutputWindow

_LOCATION = re.compile(r"^(ERROR|Warning|Generic Warning): In [^\n]*, line \d+\n")
_OBJECT = re.compile(r"^\w+ \((0x)?[0-9a-fA-F]+\): ")


def _first_line(text: str) -> str:
    """Strip VTK's file, line and address; keep the words, on one line."""
    text = _OBJECT.sub("", _LOCATION.sub("", text.strip()))
    return " ".join(text.split())


@dataclass
class Messages:
    """Messages that VTK reported during a capture, each on one line."""

    errors: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    def promote(self, words: tuple[str, ...]) -> None:
        """Make errors of the warnings that contain any of the given words."""
        self.errors += [text for text in self.warnings if any(word in text for word in words)]

    def first_error(self, limit: int = 200) -> str:
        """Return the first error, shortened to `limit` characters, or an empty string."""
        text = self.errors[0] if self.errors else ""
        return text if len(text) <= limit else text[: limit - 1] + "…"


@contextmanager
def capture() -> Iterator[Messages]:
    """Collect VTK's errors and warnings instead of printing them; nests."""
    found = Messages()

    def on_error(_caller: object, _event: str, text: str) -> None:
        found.errors.append(_first_line(text))

    def on_warning(_caller: object, _event: str, text: str) -> None:
        found.warnings.append(_first_line(text))

    on_error.CallDataType = VTK_STRING  # type: ignore[attr-defined]
    on_warning.CallDataType = VTK_STRING  # type: ignore[attr-defined]
    window = vtkOutputWindow.GetInstance()
    mode = window.GetDisplayMode()
    cutoff = vtkLogger.GetCurrentVerbosityCutoff()
    tags = [
        window.AddObserver("ErrorEvent", on_error),
        window.AddObserver("WarningEvent", on_warning),
    ]
    window.SetDisplayMode(vtkOutputWindow.NEVER)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield found
    finally:
        vtkLogger.SetStderrVerbosity(vtkLogger.ConvertToVerbosity(cutoff))
        window.SetDisplayMode(mode)
        for tag in tags:
            window.RemoveObserver(tag)


def users_level() -> int:
    """Return the stack level, for `warnings.warn` of the caller, of the code outside of this package
    and PyVista."""
    frame, level = sys._getframe(2), 2
    while frame.f_back is not None and frame.f_globals.get("__name__", "").split(".")[0] in (
        "vtkindirect",
        "pyvista",
    ):
        frame, level = frame.f_back, level + 1
    return level
