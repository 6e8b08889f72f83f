# SPDX-License-Identifier: BSD-3-Clause
"""The default of words of `enable` that say nothing."""

from __future__ import annotations

from typing import Any


class _Keep:
    """A default that says what it is, to readers of signatures too."""

    def __repr__(self) -> str:
        return "KEEP"


KEEP: Any = _Keep()
"""It keeps what a pass that is on has, or for a new pass the renderer's environment and the lighting
"auto"."""
