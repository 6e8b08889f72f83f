# SPDX-License-Identifier: BSD-3-Clause
"""The examples in Python: run from any folder, and one line says what they lack."""

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import support
import vtkindirect

EXAMPLES = support.SOURCE / "Examples" / "Python"
WHY_NOT = support.why_no_rendering()


class Examples(support.DirectoryTest):
    def run_example(self, name: str, *words: str) -> subprocess.CompletedProcess[str]:
        """Run a copy of an example outside of the checkout."""
        shutil.copy(EXAMPLES / name, self.directory)
        return subprocess.run(
            [sys.executable, "-B", name, *words],
            capture_output=True,
            text=True,
            cwd=self.directory,
            env={**os.environ, "PYTHONPATH": str(Path(vtkindirect.__file__).parents[1])},
            check=False,
        )

    def test_what_is_missing_is_one_line(self) -> None:
        for expected, name, *words in (
            ("usage: ", "render_scene.py"),
            ("none.vtp: no such file", "render_scene.py", "none.vtp"),
            ("usage: ", "moving_molecule.py", "one.pdb"),
            ("none.npz", "moving_molecule.py", "none.pdb", "none.npz"),
        ):
            result = self.run_example(name, *words)
            with self.subTest(name=name, words=words):
                self.assertEqual((result.returncode, result.stdout), (1, ""), result.stderr)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertIn(expected, result.stderr)

    def test_without_pyvista(self) -> None:
        (self.directory / "pyvista.py").write_text("raise ImportError('none here')")
        result = self.run_example("pyvista_plotter.py")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^pyvista_plotter.py: needs PyVista .*none here\n$")

    @unittest.skipIf(WHY_NOT, WHY_NOT or "")
    def test_the_molecule_moves(self) -> None:
        result = self.run_example("moving_molecule.py")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertGreater((self.directory / "moving_molecule.png").stat().st_size, 10_000)


if __name__ == "__main__":
    unittest.main()
