# SPDX-License-Identifier: BSD-3-Clause
"""Every shader that tests make OpenGL compile is also compiled by Khronos' reference compiler.

Drivers differ in what they let pass; the reference compiler goes by the letter of the language.
"""

from __future__ import annotations

import os
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
        found = {stage: 0 for stage in STAGES}
        for shader in shaders:
            stage = shader.name[:2]
            found[stage] += 1
            with self.subTest(shader=shader.name):
                said = subprocess.run(
                    [COMPILER, "-S", STAGES[stage], shader],
                    capture_output=True, text=True, check=False,
                )
                lines = shader.read_text(errors="replace").splitlines()
                own = [line for line in lines if "vtki" in line][:1]
                self.assertEqual(said.returncode, 0, f"{said.stdout}\n{own}")
        print(found)
        # The current number; fewer means that a test's stages are no longer compiled.
        self.assertGreater(found["FS"], 60)
        self.assertGreater(found["CS"], 15)
