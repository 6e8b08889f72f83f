# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of many actors, with few of them."""

from __future__ import annotations

import io
import json
import unittest
from contextlib import redirect_stdout

import many
import support


@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Few(support.DirectoryTest):
    """One run of three balls."""

    def test_every_part_is_measured(self) -> None:
        path = self.directory / "found.json"
        said = io.StringIO()
        with redirect_stdout(said):
            code = many.main(
                ["--size", "32x24", "--frames", "2", "--actors", "3", "--json", str(path)]
            )
        self.assertEqual(code, 0)
        (found,) = json.loads(path.read_text(encoding="utf-8")).values()
        for part in ("plain", "full"):
            self.assertEqual(found[part]["frames"], 2)
            self.assertGreater(found[part]["median_ms"], 0.0)
            self.assertGreaterEqual(found[part]["max_ms"], found[part]["median_ms"])
        # Maps of 256 lights, and those of the sky beside them.
        self.assertGreater(found["tiles"], 256)
        self.assertGreater(found["filling"]["frames"], 0)
        for name in ("first_ms", "picture_ms", "complete_ms", "complete_frames"):
            self.assertGreater(found[name], 0.0, name)
        self.assertLessEqual(found["picture_ms"], found["complete_ms"])
        self.assertGreater(found["stages"]["sky"], 0.0)
        first, stages = said.getvalue().splitlines()
        self.assertRegex(first, f"^3 actors: plain .*, full .*, all {found['tiles']} maps ")
        self.assertIn("sky ", stages)
