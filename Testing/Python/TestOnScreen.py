# SPDX-License-Identifier: BSD-3-Clause
"""Windows on a screen, in VTK's own event loop. Xvfb is the screen, xdotool the hand."""

import itertools
import os
import shutil
import signal
import subprocess
import sys
import threading
import unittest
from pathlib import Path

import support
from seen_window import INTERACTIVE

PROGRAM = Path(__file__).resolve().parent / "seen_window.py"
BATCHES = 32
"""Batches of a refinement of 2048 lights."""
FADE = 7
"""Frames in which a finer picture takes the place of the one before, after the first one."""
ALL = 5 * BATCHES + FADE
"""Batches of both refinements, and the last one's frames."""
BEFORE_DRAG = 3
PATIENCE = 90.0
"""Seconds until an event loop counts as hung: 20 times what it takes on two cores."""


def why_no_screen() -> str:
    missing = [name for name in ("Xvfb", "xdotool") if not shutil.which(name)]
    return support.why_no_rendering() or (f"{', '.join(missing)} not found" if missing else "")


@unittest.skipIf(why_no_screen(), why_no_screen())
class OnScreen(unittest.TestCase):
    def setUp(self) -> None:
        read, write = os.pipe()
        screen = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        self.addCleanup(screen.wait)
        self.addCleanup(screen.terminate)
        with os.fdopen(read) as numbers:
            self.environment = {**os.environ, "DISPLAY": f":{numbers.readline().strip()}"}

    def move(self, *arguments: object) -> None:
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def drag(self) -> None:
        self.move("mousemove", 40, 60, "mousedown", 1)
        for x in (45, 50, 55, 60, 65):
            self.move("mousemove", x, 60, "sleep", 0.1)
        self.move("mouseup", 1)

    def look(self, *settings: str, drags: bool = True) -> list[tuple[float, int, float]]:
        """Return update rate, frames left and mean irradiance of each frame of a window."""
        rows: list[tuple[float, int, float]] = []
        with subprocess.Popen(
            [sys.executable, str(PROGRAM), *settings],
            env=self.environment,
            stdout=subprocess.PIPE,
            text=True,
        ) as seen:
            patience = threading.Timer(PATIENCE, seen.kill)
            patience.start()
            for line in seen.stdout:
                rate, left, mean = line.split()
                rows.append((float(rate), int(left), float(mean)))
                if drags and len(rows) == BEFORE_DRAG:
                    self.drag()
                elif not drags and rows[-1][1] == 0 and len(rows) > 1:
                    seen.terminate()
            patience.cancel()
        self.assertIn(seen.returncode, (0, -signal.SIGTERM), f"after {rows}")
        return rows

    def test_a_picture_is_refined_until_somebody_drags_and_after_that(self) -> None:
        rows = self.look("NumberOfRefinements=2")
        moving = [i for i, (rate, *_) in enumerate(rows) if rate >= INTERACTIVE]
        self.assertTrue(moving, rows)
        self.assertEqual({rows[i][1] for i in moving}, {0})
        before = [left for _, left, _ in rows[: moving[0]]]
        after = [left for _, left, _ in rows[moving[-1] + 1 :]]
        self.assertEqual(before[0], ALL)
        self.assertEqual(before, sorted(set(before), reverse=True))
        self.assertGreater(before[-1], 0)
        self.assertEqual((after[0], after[-1]), (ALL, 0))
        self.assertEqual(after, sorted(set(after), reverse=True))

    def test_a_finer_picture_comes_without_a_jump(self) -> None:
        rows = self.look("NumberOfRefinements=1", drags=False)
        means = [mean for *_, mean in rows]
        # A frame has as many batches as there is time for, and a step of the fade.
        self.assertGreater(len(means), FADE)
        self.assertLess(len(means), BATCHES + FADE)
        whole = abs(means[-1] - means[0])
        self.assertGreater(whole, 1e-3 * means[0])
        greatest = max(abs(b - a) for a, b in itertools.pairwise(means))
        # A step is an eighth of the change; pixels are rounded to half floats, which have 11 bits.
        self.assertLess(greatest, 0.125 * whole + 2.0**-11 * means[0])

    def test_pictures_on_a_screen_are_refined_by_default(self) -> None:
        lefts = [left for _, left, _ in self.look(drags=False)]
        self.assertGreater(max(lefts), 4 * BATCHES)
        self.assertEqual(lefts[-1], 0)


if __name__ == "__main__":
    unittest.main()
