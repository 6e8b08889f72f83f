# SPDX-License-Identifier: BSD-3-Clause
"""Command line and output of the checks of the checkout."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path


def report(faults: Sequence[str]) -> int:
    """Print the faults and their number; return the exit code."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


def check(find_faults: Callable[[Path], Sequence[str]]) -> int:
    """Print the faults of the checkout, or of the folder that the command line names."""
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    return report(find_faults(root))
