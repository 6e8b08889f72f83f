# SPDX-License-Identifier: BSD-3-Clause
"""A progress bar on standard error that stays silent while the work is short."""

from __future__ import annotations

import sys
import time
from typing import TextIO

WIDTH = 30


class Progress:
    """Counts steps of known number.

    On a terminal it is a bar that appears after a second, redraws itself and vanishes at the end;
    elsewhere, after five seconds, it is a line each time another quarter of the work is done.
    """

    def __init__(self, label: str, total: int, stream: TextIO | None = None) -> None:
        self._label = label
        self._total = max(1, total)
        self._stream = stream if stream is not None else sys.stderr
        self._terminal = self._stream.isatty()
        self._visible_from = time.monotonic() + (1.0 if self._terminal else 5.0)
        self._done = 0
        self._quarter = 0
        self._drawn = 0

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.clear()

    def step(self, what: str = "") -> None:
        """Say that one more step begins; `what` is shown beside the bar."""
        if time.monotonic() >= self._visible_from:
            self._draw(what)
        self._done = min(self._done + 1, self._total)

    def clear(self) -> None:
        """Remove the bar from the terminal."""
        if self._drawn:
            self._stream.write("\r" + " " * self._drawn + "\r")
            self._stream.flush()
            self._drawn = 0

    def _draw(self, what: str) -> None:
        fraction = self._done / self._total
        if self._terminal:
            filled = int(WIDTH * fraction)
            bar = "#" * filled + "." * (WIDTH - filled)
            line = f"{self._label} [{bar}] {100 * fraction:3.0f}% {what}"[:99]
            self._stream.write("\r" + line.ljust(self._drawn))
            self._drawn = len(line)
        elif int(4 * fraction) > self._quarter:
            self._quarter = int(4 * fraction)
            self._stream.write(f"{self._label}: {25 * self._quarter}%\n")
        self._stream.flush()
