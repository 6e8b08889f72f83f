# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the launcher of packed programs on systems that are folders and become the root."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

import packing
import support
from packing import must, run

HERE = Path(__file__).resolve().parent
LIBRARIES = "usr/lib/x86_64-linux-gnu"
VENDORS = "usr/share/glvnd/egl_vendor.d"
NVIDIA = "usr/local/nvidia"
TOOLS = f"{os.environ['PATH']}:/usr/sbin:/sbin"
UNSHARE = () if os.geteuid() == 0 else (shutil.which("unshare"), "--map-root-user")
CHANGE_ROOT = (*UNSHARE, shutil.which("chroot", path=TOOLS))

NEEDS = """\
# A comment.
system libc.so.6 GLIBC_2.2.5 GLIBC_2.34
system libm.so.6 GLIBC_2.2.5
either libstdc++.so.6 GLIBCXX_3.4 GLIBCXX_3.4.30
either libX11.so.6
"""

SHOW = r"""
#include <stdio.h>
#include <stdlib.h>
int main(int count, char** words)
{
  const char* names[] = { "LD_LIBRARY_PATH", "VTK_INDIRECT_PACK",
    "__EGL_VENDOR_LIBRARY_FILENAMES" };
  for (int i = 0; i < 3; ++i)
    printf("%s=%s\n", names[i], getenv(names[i]) ? getenv(names[i]) : "");
  for (int i = 0; i < count; ++i)
    printf("[%s]", words[i]);
  printf("\n");
  return 7;
}
"""


def why_no_roots() -> str | None:
    """Return why no folder can become the root here, or None."""
    if None in CHANGE_ROOT:
        return "chroot or unshare is missing"
    done = run(*CHANGE_ROOT, "/", "true")
    return None if done.returncode == 0 else f"no other root can be entered: {done.stderr.strip()}"


def library(path: Path, versions: tuple[str, ...] = (), needed: tuple[str, ...] = ()) -> Path:
    """A shared library that has versions and nothing else."""
    path.parent.mkdir(parents=True, exist_ok=True)
    script = path.with_name("versions")
    script.write_text("".join(f"{version} {{}};\n" for version in versions))
    words = [f"-Wl,--version-script={script}"] if versions else []
    for name in needed:
        stand_in = path.with_name(f"{name}.stand-in")
        packing.compile_c(stand_in, "", *("-shared", "-nostdlib", f"-Wl,-soname,{name}"))
        words += ["-Wl,--no-as-needed", stand_in]
    packing.compile_c(path, "", "-shared", "-nostdlib", f"-Wl,-soname,{path.name}", *words)
    for rest in (script, *path.parent.glob("*.stand-in")):
        rest.unlink()
    return path


@unittest.skipIf(why_no_roots() is not None, f"{why_no_roots()}")
class Systems(unittest.TestCase):
    """A system of empty libraries, from which each test takes something away."""

    @classmethod
    def setUpClass(cls) -> None:
        place = packing.temporary(cls)
        cls.usual = place / "usual"
        pack = cls.usual / "pack"
        (pack / "bin").mkdir(parents=True)
        must(
            *(packing.compiler("CXX"), "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror"),
            *("-static", "-o", pack / "gpu", HERE / "launcher.cxx"),
        )
        packing.compile_c(pack / "bin" / "IndirectCardBenchmark", SHOW, "-static")
        shutil.copy(pack / "bin" / "IndirectCardBenchmark", pack / "bin" / "Other")
        (pack / "lib" / "glvnd").mkdir(parents=True)
        (pack / "lib" / "needs.txt").write_text(NEEDS)
        (pack / "lib" / "glvnd" / "10_nvidia.json").write_text("{}")
        library(pack / "lib" / "glvnd" / "libEGL.so.1")
        libraries = cls.usual / LIBRARIES
        old = ("GLIBC_2.2.5", "GLIBC_2.34", "GLIBC_PRIVATE")
        library(libraries / "libc.so.6", old)
        library(libraries / "libm.so.6", old)
        library(libraries / "libstdc++.so.6", ("GLIBCXX_3.4", "GLIBCXX_3.4.30", "GLIBCXX_3.4.33"))
        library(libraries / "libX11.so.6")
        library(libraries / "libEGL.so.1", needed=("libGLdispatch.so.0",))
        (cls.usual / "lib64").mkdir()
        library(cls.usual / "lib64" / "ld-linux-x86-64.so.2", old)
        (cls.usual / VENDORS).mkdir(parents=True)
        (cls.usual / VENDORS / "50_mesa.json").write_text("{}")

    def setUp(self) -> None:
        self.root = self.usual.with_name(self.id().rpartition(".")[2])
        shutil.copytree(self.usual, self.root)
        self.addCleanup(shutil.rmtree, self.root)
        self.libraries = self.root / LIBRARIES

    def start(self, *words: object, **variables: str) -> subprocess.CompletedProcess[str]:
        """Run in the system; its environment has what is given only."""
        return run(*CHANGE_ROOT, self.root, *(words or ("/pack/gpu", "run")), env=variables)

    def started(self, done: subprocess.CompletedProcess[str], said: str = "") -> dict[str, str]:
        """The variables that the program got, and its words."""
        self.assertEqual((done.returncode, done.stderr), (7, said), done.stdout)
        *variables, words = done.stdout.splitlines()
        return {**dict(line.split("=", 1) for line in variables), "words": words}

    def refused(self, text: str, *words: object, **variables: str) -> None:
        """Check that the launcher says one line and starts nothing."""
        done = self.start(*words, **variables)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (1, "", f"gpu: {text}\n"))

    def test_usual(self) -> None:
        found = self.started(self.start("/pack/gpu", "run", "--size", "9 x"))
        self.assertEqual(found["words"], "[/pack/bin/IndirectCardBenchmark][run][--size][9 x]")
        self.assertEqual(found["VTK_INDIRECT_PACK"], "/pack")
        # The system's libstdc++ is newer, and so no folder of the pack comes before it.
        self.assertEqual(found["LD_LIBRARY_PATH"], "/pack/lib")
        self.assertEqual(found["__EGL_VENDOR_LIBRARY_FILENAMES"], "")
        self.assertEqual(self.started(self.start("/pack/gpu"))["words"],
                         "[/pack/bin/IndirectCardBenchmark]")  # fmt: skip
        found = self.started(self.start("/pack/gpu", "exec", "Other", "run"))
        self.assertEqual(found["words"], "[/pack/bin/Other][run]")
        done = self.start("/pack/gpu", "libraries")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("libstdc++.so.6 /lib", f"{done.stdout}".replace("/usr/lib", "/lib"))

    def test_words(self) -> None:
        self.refused("no program /pack/bin/None", "/pack/gpu", "exec", "None")
        self.assertEqual(self.start("/pack/gpu", "exec").returncode, 2)
        (self.root / "pack" / "lib" / "needs.txt").unlink()
        self.refused("cannot read /pack/lib/needs.txt")

    def test_where_the_pack_is(self) -> None:
        (self.root / "bin").mkdir()
        (self.root / "bin" / "gpu").symlink_to("../pack/gpu")
        (self.root / "gpu").symlink_to("pack/gpu")
        for words in (("/bin/gpu",), ("./pack/gpu",), ("pack/gpu",), ("./gpu",), ("gpu",)):
            found = self.started(self.start(*words, PATH="/bin"))
            self.assertEqual(found["VTK_INDIRECT_PACK"], "/pack", words)
        (self.root / "a b").mkdir()
        (self.root / "pack").rename(self.root / "a b" / "c;d")
        self.refused("the name of its folder has a colon or semicolon, of which the loader makes "
                     "two: /a b/c;d", "/a b/c;d/gpu")  # fmt: skip
        (self.root / "a b" / "c;d").rename(self.root / "a b" / "c d")
        found = self.started(self.start("/a b/c d/gpu"))
        self.assertEqual(found["LD_LIBRARY_PATH"], "/a b/c d/lib")

    def test_no_glibc(self) -> None:
        (self.root / "lib64" / "ld-linux-x86-64.so.2").unlink()
        self.refused("no /lib64/ld-linux-x86-64.so.2: the programs need a Linux for x86-64 with "
                     "glibc (not musl, not 32 bits)")  # fmt: skip

    def test_glibc_too_old(self) -> None:
        library(self.libraries / "libc.so.6", ("GLIBC_2.2.5", "GLIBC_2.4", "GLIBC_2.30"))
        self.refused(f"glibc 2.34 or later is needed; the newest version in /{LIBRARIES}/libc.so.6 "
                     "is 2.30")  # fmt: skip
        (self.libraries / "libm.so.6").unlink()
        library(self.libraries / "libc.so.6", ("GLIBC_2.2.5", "GLIBC_2.34"))
        self.refused("no libm.so.6: it is a part of glibc (Debian: libc6)")

    def test_no_egl(self) -> None:
        (self.libraries / "libEGL.so.1").unlink()
        shutil.rmtree(self.root / VENDORS)
        self.refused("no libEGL.so.1: install the driver's EGL (Debian: libegl1)")
        # A driver without what finds it: the pack has that.
        said = "gpu: no libEGL.so.1 here; taking libglvnd's of the pack, which asks the driver\n"
        (self.root / "etc/glvnd/egl_vendor.d").mkdir(parents=True)
        (self.root / "etc/glvnd/egl_vendor.d" / "10_nvidia.json").write_text("{}")
        found = self.started(self.start(), said)
        self.assertEqual(found["LD_LIBRARY_PATH"], "/pack/lib:/pack/lib/glvnd")
        (self.root / "pack" / "lib" / "glvnd" / "libEGL.so.1").unlink()
        self.refused("no libEGL.so.1: install the driver's EGL (Debian: libegl1)")

    def test_egl_without_a_driver(self) -> None:
        (self.root / VENDORS / "50_mesa.json").rename(self.root / VENDORS / "50_mesa.json.old")
        said = ("gpu: no driver is named in /usr/share/glvnd/egl_vendor.d; if none is found, "
                "install its EGL (Debian: libegl-mesa0 or libegl-nvidia0)\n")  # fmt: skip
        self.started(self.start(), said)
        # Somebody says where it is.
        self.started(self.start("/pack/gpu", __EGL_VENDOR_LIBRARY_DIRS="/there"))
        found = self.started(self.start("/pack/gpu", __EGL_VENDOR_LIBRARY_FILENAMES="/that"))
        self.assertEqual(found["__EGL_VENDOR_LIBRARY_FILENAMES"], "/that")
        # A libEGL that is a driver's own asks for no such file.
        library(self.libraries / "libEGL.so.1")
        self.started(self.start())

    def test_driver_of_nvidia_in_its_folder(self) -> None:
        (self.libraries / "libEGL.so.1").unlink()
        shutil.rmtree(self.root / VENDORS)
        library(self.root / NVIDIA / "lib64" / "libEGL_nvidia.so.0")
        egl = "gpu: no libEGL.so.1 here; taking libglvnd's of the pack, which asks the driver\n"
        none = "gpu: no file in /usr/share/glvnd/egl_vendor.d; taking "
        own = "/pack/lib/glvnd/10_nvidia.json"
        found = self.started(self.start(), f"{none}{own}\n{egl}")
        self.assertEqual(found["__EGL_VENDOR_LIBRARY_FILENAMES"], own)
        path = "/pack/lib:/pack/lib/glvnd:/usr/local/nvidia/lib64"
        self.assertEqual(found["LD_LIBRARY_PATH"], path)
        theirs = f"/{NVIDIA}/share/glvnd/egl_vendor.d/10_nvidia.json"
        (self.root / theirs[1:]).parent.mkdir(parents=True)
        (self.root / theirs[1:]).write_text("{}")
        found = self.started(
            self.start("/pack/gpu", LD_LIBRARY_PATH=f"/mine:/{NVIDIA}/lib64"),
            f"{none}{theirs}\n{egl}",
        )
        self.assertEqual(found["__EGL_VENDOR_LIBRARY_FILENAMES"], theirs)
        path = "/pack/lib:/pack/lib/glvnd:/mine:/usr/local/nvidia/lib64"
        self.assertEqual(found["LD_LIBRARY_PATH"], path)

    def test_libraries_that_a_driver_loads_too(self) -> None:
        both = "/pack/lib:/pack/lib/either/libstdc++.so.6"
        library(self.libraries / "libstdc++.so.6", ("GLIBCXX_3.4", "GLIBCXX_3.4.29"))
        self.assertEqual(self.started(self.start())["LD_LIBRARY_PATH"], both)
        (self.libraries / "libstdc++.so.6").unlink()
        (self.libraries / "libX11.so.6").unlink()
        found = self.started(self.start("/pack/gpu", LD_LIBRARY_PATH="/mine"))
        self.assertEqual(found["LD_LIBRARY_PATH"], f"{both}:/pack/lib/either/libX11.so.6:/mine")
        # In a folder that the user names, the last of which comes first in no path.
        versions = ("GLIBCXX_3.4", "GLIBCXX_3.4.30")
        library(self.root / "mine" / "libstdc++.so.6", versions)
        found = self.started(self.start("/pack/gpu", LD_LIBRARY_PATH="/none:/mine"))
        path = "/pack/lib:/pack/lib/either/libX11.so.6:/none:/mine"
        self.assertEqual(found["LD_LIBRARY_PATH"], path)

    def test_files_of_ldconfig(self) -> None:
        tool = shutil.which("ldconfig", path=TOOLS)
        if not tool:
            self.skipTest("ldconfig is missing")
        far = self.root / "opt" / "far"
        far.mkdir(parents=True)
        (self.root / "etc").mkdir(exist_ok=True)
        (self.root / "etc" / "ld.so.conf").write_text("/opt/far\n")
        shutil.move(self.libraries / "libstdc++.so.6", far)
        path = "/pack/lib:/pack/lib/either/libstdc++.so.6"
        self.assertEqual(self.started(self.start())["LD_LIBRARY_PATH"], path)
        for form in ("new", "compat"):
            must(tool, "-X", "-c", form, "-r", self.root)
            found = self.started(self.start())
            self.assertEqual(found["LD_LIBRARY_PATH"], "/pack/lib", form)
        # A cache that is cut off holds less, and is no reason to fall.
        cache = self.root / "etc" / "ld.so.cache"
        data = cache.read_bytes()
        for length in (0, 1, 20, 47, 48, 60, len(data) // 2, len(data) - 1):
            cache.write_bytes(data[:length])
            self.assertEqual(self.started(self.start())["words"],
                             "[/pack/bin/IndirectCardBenchmark][run]")  # fmt: skip

    def test_damaged_libraries(self) -> None:
        """Whatever a file holds, it has its versions or it has not."""
        path = "/pack/lib:/pack/lib/either/libstdc++.so.6"
        target = self.libraries / "libstdc++.so.6"
        data = target.read_bytes()
        for length in (0, 3, 16, 63, 64, 100, 500, 1000):
            target.write_bytes(data[:length])
            self.assertEqual(self.started(self.start())["LD_LIBRARY_PATH"], path, length)
        for position in range(16, min(len(data), 1200), 7):
            changed = bytearray(data)
            changed[position : position + 8] = b"\xff" * len(changed[position : position + 8])
            target.write_bytes(changed)
            self.assertEqual(self.start().returncode, 7, position)
        # A library of another machine is passed over, as the loader does.
        for position, value in ((4, 1), (18, 40)):
            changed = bytearray(data)
            changed[position] = value
            target.write_bytes(changed)
            self.assertEqual(self.started(self.start())["LD_LIBRARY_PATH"], path)


def mesa_files() -> set[Path]:
    """Mesa's EGL of this system and all that it needs."""
    found: set[Path] = set()
    vendor = Path("/", VENDORS, "50_mesa.json")
    if not vendor.is_file():
        raise unittest.SkipTest(f"no {vendor}")
    name = json.loads(vendor.read_text())["ICD"]["library_path"]
    start = [Path("/", LIBRARIES, name), Path("/", LIBRARIES, "libEGL.so.1")]
    start += sorted(Path("/", LIBRARIES, "dri").glob("*swrast_dri.so"))
    start += sorted(Path("/", LIBRARIES).glob("libgallium-*.so"))
    for path in start:
        if not path.is_file():
            raise unittest.SkipTest(f"no {path}")
        found.add(path)
        found.update(map(Path, re.findall(r"(/\S+) \(0x", must("ldd", path))))
    return found


@unittest.skipIf(why_no_roots() is not None, f"{why_no_roots()}")
@unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
class Alone(unittest.TestCase):
    """A system of nothing but glibc, Mesa's EGL, and the pack."""

    def test_it_draws(self) -> None:
        packing.require("patchelf", "readelf", "strip", "ldd")
        root = packing.temporary(type(self))
        for path in mesa_files():
            target = root / path.relative_to("/")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, target)
            target.chmod(0o755)
        (root / VENDORS).mkdir(parents=True)
        shutil.copy(Path("/", VENDORS, "50_mesa.json"), root / VENDORS)
        for name in ("libGL.so*", "libGLX.so*", "libOpenGL.so*", "libvtk*", "libtbb*"):
            self.assertEqual(list(root.rglob(name)), [])
        packing.closure(root / "pack", "IndirectShaderTests", "TestPassContract")
        start = [*CHANGE_ROOT, root, "/pack/gpu", "exec"]
        done = run(*start, "IndirectShaderTests", "KernelParity", env={})
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout[-2000:])
        self.assertIn("KernelParity: 0 of ", done.stdout)
        done = run(*start, "TestPassContract", "NothingToDo", env={})
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        # Without the file that names Mesa there is no driver, and the program says so.
        (root / VENDORS / "50_mesa.json").unlink()
        done = run(*start, "IndirectShaderTests", "KernelParity", env={})
        self.assertEqual(done.returncode, 125, done.stdout)
        self.assertIn("gpu: no driver is named in ", done.stderr)
