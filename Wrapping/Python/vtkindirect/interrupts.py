# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C in the command line: one line and exit code 130, from the first import to the last file.

Python's own handler raises KeyboardInterrupt wherever it is: in the middle of an import that is a
traceback, and in a function that VTK calls, VTK prints words of its own and exits with 1.
"""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Callable
from typing import Any, NoReturn

CODE = 130
"""128 and the number of SIGINT, as shells report it."""

_cleanups: list[Callable[[], None]] = []


def before_end(cleanup: Callable[[], None]) -> None:
    """Let a function be called before an interrupt ends the program."""
    _cleanups.append(cleanup)


def _end(*_: Any) -> NoReturn:
    for cleanup in _cleanups:
        with contextlib.suppress(Exception):
            cleanup()
    with contextlib.suppress(OSError):
        os.write(2, b"vtk-indirect: error: interrupted\n")
    os._exit(CODE)


def end_program() -> None:
    """Let SIGINT end this program, unless it is ignored, as in a script's background."""
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        signal.signal(signal.SIGINT, _end)
