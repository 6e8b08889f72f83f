# SPDX-License-Identifier: BSD-3-Clause
"""Output of the checks of the checkout."""

from __future__ import annotations

from collections.abc import Sequence


def report(faults: Sequence[str]) -> int:
    """Print the faults and their number; return the exit code."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0
