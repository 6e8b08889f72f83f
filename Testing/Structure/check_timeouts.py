#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that a busy machine cannot fail a test: all have VTK_INDIRECT_TEST_TIMEOUT.

    Testing/Structure/check_timeouts.py CTEST BUILD SECONDS

The limit is one number, large enough to end only what hangs. A test that gives up on its own before,
such as by subprocess.run(timeout=...), would be judged by the clock.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

from faults import report


def find_faults(ctest: str, build: str, seconds: float) -> list[str]:
    """Return a line for each test with another limit, and for each limit in a Python test."""
    listed = subprocess.run(
        [ctest, "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True
    ).stdout
    tests = json.loads(listed)["tests"]
    faults = [] if len(tests) > 300 else [f"{build} has {len(tests)} tests only"]
    for test in tests:
        values = {entry["name"]: entry["value"] for entry in test["properties"]}
        limit = values.get("TIMEOUT")
        if limit != seconds:
            faults.append(f"{test['name']} has a limit of {limit} s, not {seconds}")
    root = Path(__file__).resolve().parents[1]
    patterns = ("test_*.py", "Test*.py", "support.py")
    for path in sorted(path for pattern in patterns for path in root.rglob(pattern)):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if re.search(r"\btimeout\s*=", line):
                faults.append(f"{path.relative_to(root)}:{number} gives up by the clock")
    return faults


def main() -> int:
    """Print the faults; returns the exit code."""
    return report(find_faults(sys.argv[1], sys.argv[2], float(sys.argv[3])))


if __name__ == "__main__":
    sys.exit(main())
