# SPDX-License-Identifier: BSD-3-Clause
"""With another VTK or Python than it was built for the package says so, and the process goes on."""

import importlib
import os
import subprocess
import sys
import types
import unittest
import zipfile
from pathlib import Path

from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import vtkVersion

import support
import vtkindirect
from vtkindirect import compatibility

VERSION = vtkVersion.GetVTKVersion()
PACKAGES = Path(vtkindirect.__file__).parent.parent
OTHER_VTK = sorted((PACKAGES.parents[2] / "wheels").glob("vtk-*.whl"))
IMPORT = """
import sys
try:
    import vtkindirect
except ImportError as error:
    print(error)
maps = open("/proc/self/maps").read()
print("loaded" if "vtkRenderingIndirect" in maps else "not loaded")
"""


def vtk(version: str, place: str = "/somewhere") -> types.SimpleNamespace:
    """Stand for the module vtkCommonCore of a version."""
    major, minor, build = version.split(".")
    number = types.SimpleNamespace(
        GetVTKMajorVersion=lambda: int(major),
        GetVTKMinorVersion=lambda: int(minor),
        GetVTKBuildVersion=lambda: int(build),
    )
    return types.SimpleNamespace(vtkVersion=number, __file__=f"{place}/vtkmodules/core.so")


class Problem(unittest.TestCase):
    def problem(self, version: str, **changed: str) -> str | None:
        python = f"{sys.version_info[0]}.{sys.version_info[1]}"
        values = {"PYTHON": python, "VTK": "9.1.0", "VTK_LIBRARY": "", **changed}
        return compatibility.problem(types.SimpleNamespace(**values), vtk(version))

    def test_versions(self) -> None:
        self.assertIsNone(self.problem("9.1.0"))
        for other in ("9.1.1", "9.7.1", "10.1.0", "9.0.0"):
            text = self.problem(other)
            self.assertIn("built for VTK 9.1.0", text)
            self.assertIn(f"has VTK {other} (/somewhere/vtkmodules)", text)

    def test_what_to_do(self) -> None:
        """A VTK of PyPI comes first; Debian's own packages and other folders are none of it."""
        fits = types.SimpleNamespace(
            PYTHON=f"{sys.version_info[0]}.{sys.version_info[1]}", VTK="9.1.0", VTK_LIBRARY=""
        )
        for place, of_pypi in (
            ("/home/u/.local/lib/python3.11/site-packages", True),
            ("/home/u/venv/lib/python3.11/site-packages", True),
            ("/usr/local/lib/python3.11/dist-packages", True),
            ("/usr/lib/python3/dist-packages", False),
            ("/somewhere", False),
        ):
            with self.subTest(place=place):
                text = compatibility.problem(fits, vtk("9.3.0", place))
                self.assertEqual("python3 -m pip uninstall vtk;" in text, of_pypi, text)
                self.assertEqual("--system-site-packages" in text, of_pypi, text)
                self.assertEqual("start the Python that has VTK 9.1.0" in text, not of_pypi, text)
                self.assertIn("or build vtkindirect with VTK 9.3.0", text)

    def test_python(self) -> None:
        text = self.problem("9.1.0", PYTHON="3.5")
        self.assertIn("built for Python 3.5, and this is Python 3.", text)

    @unittest.skipUnless(sys.platform == "linux", "libraries are looked up on Linux only")
    def test_another_build_of_the_same_version(self) -> None:
        text = self.problem("9.1.0", VTK_LIBRARY="libvtkCommonCore-none.so.1")
        self.assertIn("another VTK 9.1.0 than this Python has", text)
        self.assertIn("or build vtkindirect with VTK 9.1.0", text)
        self.assertIn("libvtkCommonCore-none.so.1", text)

    def test_this_build_fits(self) -> None:
        configuration = importlib.import_module("vtkindirect._configuration")
        self.assertIsNone(compatibility.problem(configuration, vtkCommonCore))
        self.assertEqual(configuration.VTK, VERSION.partition("rc")[0].rstrip("."))
        if sys.platform == "linux":
            self.assertIn("libvtkCommonCore", configuration.VTK_LIBRARY)


@unittest.skipUnless(
    sys.platform == "linux", "what a process has loaded is looked up on Linux only"
)
class Import(support.DirectoryTest):
    """The package in a process of its own, with another VTK before the right one on the path."""

    def run_python(self, place: Path, code: str, *more: Path) -> subprocess.CompletedProcess[str]:
        path = os.pathsep.join(map(str, (place, PACKAGES, *more)))
        return subprocess.run(
            [sys.executable, "-B", "-c", code],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": path},
            check=False,
        )

    def stand_in(self, version: str) -> Path:
        """Make a package vtkmodules that says it is of a version and has nothing else."""
        place = self.directory / "vtkmodules"
        place.mkdir()
        (place / "__init__.py").touch()
        numbers = dict(zip(("Major", "Minor", "Build"), version.split(".")))
        methods = "".join(
            f"    @staticmethod\n    def GetVTK{name}Version(): return {number}\n"
            for name, number in numbers.items()
        )
        (place / "vtkCommonCore.py").write_text(f"class vtkVersion:\n{methods}")
        return self.directory

    def test_this_version(self) -> None:
        """The process still has the objects that VTK deletes when it ends."""
        vtks = Path(vtkCommonCore.__file__).parents[1]
        result = self.run_python(vtks, "import vtkindirect; print('imported')")
        self.assertEqual((result.returncode, result.stderr, result.stdout), (0, "", "imported\n"))

    def test_no_key_is_pythons(self) -> None:
        """VTK deletes all keys when a process ends; what Python has made it deletes before.

        A newer VTK than 9.1 then deletes them twice. Keys of C++ classes are VTK's alone.
        """
        for path in Path(vtkindirect.__file__).parent.glob("*.py"):
            self.assertNotIn("Key.MakeKey(", path.read_text(encoding="utf-8"), path.name)

    def test_another_version(self) -> None:
        result = self.run_python(self.stand_in("9.99.3"), IMPORT)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        reason, loaded = result.stdout.splitlines()
        self.assertIn("9.99.3", reason)
        self.assertIn(vtkindirect._configuration.VTK, reason)
        self.assertEqual(loaded, "not loaded")

    def test_another_build_of_the_same_version(self) -> None:
        result = self.run_python(self.stand_in(vtkindirect._configuration.VTK), IMPORT)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        reason, loaded = result.stdout.splitlines()
        self.assertIn(f"another VTK {vtkindirect._configuration.VTK}", reason)
        self.assertEqual(loaded, "not loaded")

    def test_the_command_line_says_it_in_one_line(self) -> None:
        place = self.stand_in("9.99.3")
        program = PACKAGES.parents[2] / "bin" / "vtk-indirect"
        result = subprocess.run(
            [sys.executable, "-B", program, "--version"],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": str(place)},
            check=False,
        )
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        (line,) = result.stderr.splitlines()
        self.assertTrue(line.startswith("vtk-indirect: error: "), line)
        self.assertIn("9.99.3", line)

    @unittest.skipUnless(OTHER_VTK, "no other VTK is there; ./bootstrap test fetches one")
    def test_another_vtk_from_pypi(self) -> None:
        with zipfile.ZipFile(OTHER_VTK[-1]) as wheel:
            wheel.extractall(self.directory)
        result = self.run_python(self.directory, IMPORT)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        reason, loaded = result.stdout.splitlines()
        self.assertIn(OTHER_VTK[-1].name.split("-")[1], reason)
        self.assertEqual(loaded, "not loaded")
