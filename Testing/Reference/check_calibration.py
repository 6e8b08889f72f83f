#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints how well direct light by VTK and by the path tracer agree; exits with 1 when it does not.

    check_calibration.py [CASE...]

A part of a case's name selects it; default: all.
"""

from __future__ import annotations

import sys

import calibration
import tools


def main(words: list[str]) -> int:
    """Run the cases and print a table."""
    try:
        tools.tracer_python()
    except tools.ToolError as error:
        print(f"skipped: {error}")
        return tools.SKIPPED
    cases = [
        case
        for case in calibration.CASES
        if not words or any(word.lower() in case.name for word in words)
    ]
    if not cases:
        print(f"no case is called {' or '.join(words)}", file=sys.stderr)
        return 1
    columns = ("pixels", "sum", "median", "99% of |e|", "dark", "albedo")
    print(f"{'case':32}" + "".join(f"{column:>11}" for column in columns))
    good = True
    for case in cases:
        try:
            result = calibration.compare(case)
        except tools.ToolError as error:
            return tools.fail(error)
        good &= result.good
        print(
            f"{result.name:32}{result.pixels:11d}{100 * result.of_sum:10.3f}%"
            f"{100 * result.median:10.3f}%{100 * result.worst_of_99:10.3f}%"
            f"{100 * result.dark:10.3f}%{result.albedo:11.5f}{'' if result.good else '  FAILED'}",
            flush=True,
        )
    print(f"limit: {100 * calibration.TOLERANCE:g} % for the sum, 99 of 100 pixels, and the dark")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
