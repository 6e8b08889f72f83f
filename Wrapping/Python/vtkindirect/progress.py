# SPDX-License-Identifier: BSD-3-Clause
"""A progress bar on a terminal's standard error, for work that takes longer than a second."""

from __future__ import annotations

try:
    from tqdm import tqdm
except ImportError as error:
    raise ImportError(f"vtk-indirect needs tqdm (Debian: python3-tqdm): {error}") from None


class Progress(tqdm):
    """Counts steps, of which there may be more; nothing is left of it on the terminal."""

    def __init__(self, label: str, total: int) -> None:
        super().__init__(total=total, desc=label, delay=1.0, leave=False, disable=None)

    def step(self, what: str = "") -> None:
        """Say that one more step begins; `what` is shown beside the bar."""
        self.set_postfix_str(what, refresh=False)
        if self.total is not None:
            self.total = max(self.total, self.n + 1)
        self.update()
