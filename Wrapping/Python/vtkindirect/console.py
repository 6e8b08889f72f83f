# SPDX-License-Identifier: BSD-3-Clause
"""Text of the command line on standard output, written to the end each time."""

from __future__ import annotations

import os
import sys

from vtkindirect.errors import RenderError


def say(text: str) -> None:
    """Print a text; a pipe that was closed or a disk that is full is a `RenderError`."""
    try:
        print(text, flush=True)
    except OSError as error:
        # Text that is left in Python's buffer would fail again when Python ends.
        with open(os.devnull, "wb") as nothing:
            os.dup2(nothing.fileno(), 1)
        closed = isinstance(error, BrokenPipeError)
        reason = "nobody reads it any more" if closed else error.strerror
        raise RenderError(f"standard output: cannot be written: {reason}") from None
