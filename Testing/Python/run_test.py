# SPDX-License-Identifier: BSD-3-Clause
"""Runs one test file with unittest; exits with 125 when all of its tests were skipped."""

import sys
import unittest
from pathlib import Path

SKIPPED = 125


def main() -> int:
    sys.path.insert(0, str(Path(__file__).resolve().parent))
    suite = unittest.defaultTestLoader.loadTestsFromName(sys.argv[1])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    if not result.wasSuccessful():
        return 1
    if result.testsRun == 0:
        print("no tests were found")
        return 1
    if len(result.skipped) == result.testsRun:
        print("skipped:", "; ".join(sorted({reason for _, reason in result.skipped})))
        return SKIPPED
    return 0


if __name__ == "__main__":
    sys.exit(main())
