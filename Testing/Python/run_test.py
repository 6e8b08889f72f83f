# SPDX-License-Identifier: BSD-3-Clause
"""Runs one test file with unittest; exits with 125 when nothing in it could run.

The argument is the file's path without its ending; a bare name is a file beside this one.
"""

from __future__ import annotations

import sys
import unittest
from pathlib import Path

SKIPPED = 125


def main() -> int:
    """Run the tests of the file that the command line names."""
    place = Path(__file__).resolve().parent / sys.argv[1]
    sys.path.insert(0, str(place.parent))
    suite = unittest.defaultTestLoader.loadTestsFromName(place.name)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    if not result.wasSuccessful():
        return 1
    # A class that is skipped as a whole counts as skipped without having counted as run.
    ran = result.testsRun - sum(1 for test, _ in result.skipped if hasattr(test, "_testMethodName"))
    if ran <= 0:
        reasons = "; ".join(sorted({reason for _, reason in result.skipped}))
        print("skipped:", reasons or "no tests were found")
        return SKIPPED if reasons else 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
