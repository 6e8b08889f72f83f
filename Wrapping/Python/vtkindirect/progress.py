# SPDX-License-Identifier: BSD-3-Clause
"""A progress bar on a terminal's standard error, for work that takes longer than a second.

Nobody knows beforehand whether a call into VTK will, and no bar can be drawn while it runs. So the
bar is there from the beginning, and nothing is left of it.
"""

from __future__ import annotations

import time
import weakref

from vtkindirect import interrupts

try:
    from tqdm import tqdm
except ImportError as error:
    raise ImportError(f"vtk-indirect needs tqdm (Debian: python3-tqdm): {error}") from None

_MOST_A_SECOND = 10.0


class Progress(tqdm):
    """Counts steps, of which there may be more; nothing is left of it on the terminal."""

    def __init__(self, label: str, total: int) -> None:
        super().__init__(
            total=total, desc=label, leave=False, disable=None, mininterval=0, dynamic_ncols=True
        )
        self._shown = 0.0
        self._begun = 0
        _open.add(self)

    def step(self, what: str = "", left: int = 0) -> None:
        """Say that one more step begins, before `left` others at least; `what` is shown, too.

        The bar counts those that are done.
        """
        self._begun += 1
        self.set_postfix_str(what, refresh=False)
        if self.total is not None:
            self.total = max(self.total, self._begun + left)
        self.update(self._begun - 1 - self.n)
        self.refresh()

    def show(self, what: str) -> None:
        """Show what is being done in this step; not more often than eyes can follow."""
        now = time.monotonic()
        if not self.disable and now - self._shown > 1.0 / _MOST_A_SECOND:
            self._shown = now
            self.set_postfix_str(what)


_open: weakref.WeakSet[Progress] = weakref.WeakSet()


def _close_all() -> None:
    for bar in list(_open):
        bar.close()


interrupts.before_end(_close_all)
