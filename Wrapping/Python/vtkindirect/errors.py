# SPDX-License-Identifier: BSD-3-Clause
"""Two kinds of errors: of the user's input, and of the machine that the program runs on."""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Iterable


class IndirectError(Exception):
    """Base of all errors of this package. The text is one line that a user can act on."""


class UsageError(IndirectError, ValueError):
    """The input is wrong: an argument, a scene file, a data file. Exit code 2."""


class SceneError(UsageError):
    """A scene file breaks the format, or what it describes cannot be shown."""


class RenderError(IndirectError, RuntimeError):
    """The input is right but rendering or writing failed. Exit code 1."""


def suggestion(name: str, known: Iterable[str]) -> str:
    """Return `` (did you mean 'x'?)`` for the closest known name, else an empty string."""
    folded = {candidate.lower(): candidate for candidate in known}
    close = difflib.get_close_matches(name.lower(), folded, n=1, cutoff=0.6)
    return f" (did you mean '{folded[close[0]]}'?)" if close else ""


def unknown(kind: str, name: str, known: Iterable[str]) -> str:
    """Return the message for a name that is not among the known ones; lists them all."""
    known = list(known)
    return f"unknown {kind} '{name}'{suggestion(name, known)}; known: {', '.join(known)}"


def check_text(kind: str, value: object) -> None:
    """Raise unless a name is text; the message is one line whatever the value is."""
    if not isinstance(value, str):
        raise UsageError(f"{kind} must be text, not {reprlib.repr(value)}")
