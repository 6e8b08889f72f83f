# SPDX-License-Identifier: BSD-3-Clause
"""Every shader that tests make OpenGL compile is also compiled by Khronos' reference compiler.

Drivers differ in what they let pass; the reference compiler goes by the letter of the language.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

FOLDER = Path(os.environ["VTK_INDIRECT_SHADERS"])
"""Folder into which Mesa wrote what other tests compile."""
COMPILER = shutil.which("glslangValidator")
STAGES = {"VS": "vert", "FS": "frag", "GS": "geom", "CS": "comp"}


@unittest.skipIf(COMPILER is None, "glslangValidator is missing (Debian: glslang-tools)")
class Shaders(unittest.TestCase):
    """One run, all shaders."""

    def test_the_reference_compiler_takes_them(self) -> None:
        shaders = sorted(FOLDER.glob("*.glsl"))
        if not shaders:
            self.skipTest("OpenGL does not heed MESA_SHADER_DUMP_PATH: no Mesa, or no context")
        found = {}
        for stage, kind in STAGES.items():
            of_stage = [shader for shader in shaders if shader.name.startswith(stage)]
            found[stage] = len(of_stage)
            if of_stage:
                # One process for all: the compiler's start takes ten times a shader's compilation.
                said = subprocess.run(
                    [COMPILER, "-S", kind, *of_stage], capture_output=True, text=True, check=False
                )
                # A shader's name stands above what is wrong with it.
                wrong = re.findall(r"\S+\.glsl\n(?:(?:ERROR|WARNING): .*\n)+", said.stdout)
                with self.subTest(stage=stage):
                    self.assertEqual(said.returncode, 0, "\n".join(wrong) or said.stdout[-2000:])
        print(found)
        self.assertEqual(sum(found.values()), len(shaders), "a stage that is not in the table")
        # The current number; fewer means that a test's stages are no longer compiled.
        self.assertGreater(found["FS"], 60)
        self.assertGreater(found["CS"], 15)
