# SPDX-License-Identifier: BSD-3-Clause
"""The packed folder: everything that the programs need is in it, and nothing that must not be."""

from __future__ import annotations

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

import packing
import support
from packing import must, run

HERE = Path(__file__).resolve().parent
GPU = HERE.parent / "gpu"
PROGRAMS = ("IndirectShaderTests", "IndirectUnitTests")
LOADER = "/lib64/ld-linux-x86-64.so.2"

GLIBC = {"ld-linux-x86-64.so.2", "libc.so.6", "libdl.so.2", "libm.so.6", "libpthread.so.0",
         "libresolv.so.2", "librt.so.1"}  # fmt: skip


def environment(**more: str) -> dict[str, str]:
    """Environment of a machine where nobody has set anything."""
    kept = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
    return {**kept, "LC_ALL": "C", **more}


def pack(*words: object, **more: str) -> subprocess.CompletedProcess[str]:
    """Run the command; nothing here is about how small an archive gets."""
    return run(GPU, "pack", "--scene", "none", *words, env=environment(XZ_OPT="-0", **more))


def references(path: Path) -> dict[str, set[str]]:
    """Versions of which libraries a file asks for, as objdump reads it."""
    found: dict[str, set[str]] = defaultdict(set)
    library = ""
    for line in must("objdump", "-p", path).splitlines():
        if match := re.match(r"\s+required from (\S+):", line):
            library = match[1]
        elif library and (match := re.match(r"\s+0x[0-9a-f]+ 0x[0-9a-f]+ \d+ (\S+)", line)):
            found[library].add(match[1])
    return found


def needed(path: Path) -> set[str]:
    """Libraries for which a file asks, as objdump reads it."""
    return set(re.findall(r"^\s+NEEDED\s+(\S+)", must("objdump", "-p", path), re.MULTILINE))


def symbols(path: Path, which: str) -> set[str]:
    """Names that a file asks for or has."""
    lines = must("nm", "-D", which, path).splitlines()
    return {line.split()[-1].split("@")[0] for line in lines if line.strip()}


class Folder(unittest.TestCase):
    """One pack, looked at from all sides."""

    @classmethod
    def setUpClass(cls) -> None:
        packing.require("patchelf", "readelf", "objdump", "strip", "xz", "tar", "ldd")
        cls.output = packing.temporary(cls)
        words = [word for name in PROGRAMS for word in ("--program", name)]
        cls.words = ["--build", packing.BUILD, "--output", cls.output, *packing.glibc_option()]
        cls.done = pack(*cls.words, *words)
        cls.folder = cls.output / "vtk-indirect-gpu"

    def setUp(self) -> None:
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(self.done.stderr, "")
        self.binaries = [
            path
            for path in self.folder.rglob("*")
            if path.is_file() and path.read_bytes()[:4] == b"\x7fELF"
        ]
        self.libraries = {path.name: path for path in self.folder.glob("lib/**/*.so*")
                          if path.is_file()}  # fmt: skip
        self.assertGreater(len(self.libraries), 20)

    def test_nothing_of_glibc_or_a_driver(self) -> None:
        self.assertEqual(set(self.libraries) & GLIBC, set())
        foreign = re.compile(r"lib(EGL_|GLX_|GLES|gbm|drm|glapi|gallium|LLVM|nvidia)|.*_dri\.so")
        self.assertEqual([name for name in self.libraries if foreign.match(name)], [])
        # A dispatcher is no driver; it lies where only the launcher finds it.
        for name in ("libEGL.so.1", "libGLdispatch.so.0"):
            if name in self.libraries:
                self.assertEqual(self.libraries[name].parent, self.folder / "lib" / "glvnd")

    def test_everything_needed_is_there(self) -> None:
        for path in self.binaries:
            missing = needed(path) - set(self.libraries) - GLIBC - {"libEGL.so.1"}
            self.assertEqual(missing, set(), path.name)
        # Nobody's NEEDED: TBB opens it, and a stranger's would be of another version.
        self.assertEqual("libtbb.so.12" in self.libraries, "libtbbmalloc.so.2" in self.libraries)

    def test_no_glibc_too_new(self) -> None:
        for path in self.binaries:
            for library, names in references(path).items():
                for name in names if library in GLIBC else ():
                    self.assertRegex(name, r"^GLIBC_\d+(\.\d+)+$", path.name)
                    version = tuple(int(number) for number in name[6:].split("."))
                    self.assertLessEqual(version, packing.floor(), f"{path.name}: {name}")

    def test_what_the_launcher_reads(self) -> None:
        wanted: dict[str, set[str]] = defaultdict(set)
        for path in self.binaries:
            for library, names in references(path).items():
                wanted[library] |= names
        lines = (self.folder / "lib" / "needs.txt").read_text().splitlines()
        found = {line.split()[1]: line.split() for line in lines if not line.startswith("#")}
        for name, (kind, _, *versions) in found.items():
            self.assertEqual(kind, "system" if name in GLIBC else "either")
            self.assertEqual(set(versions), wanted[name], name)
            path = self.folder / "lib" / "either" / name / name
            self.assertEqual(path.is_file(), kind == "either")
        self.assertTrue({"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "libz.so.1"}
                        <= set(found))  # fmt: skip

    def test_small_and_without_paths(self) -> None:
        for path in self.binaries:
            self.assertNotRegex(must("readelf", "-SW", path), r"\.(symtab|debug_info)", path.name)
            self.assertNotRegex(must("readelf", "-dW", path), r"\((RPATH|RUNPATH)\)", path.name)
        archive = self.output / "vtk-indirect-gpu.tar.xz"
        names = must("tar", "-tJf", archive).splitlines()
        files = {f"vtk-indirect-gpu/{path.relative_to(self.folder)}"
                 for path in self.folder.rglob("*") if path.is_file()}  # fmt: skip
        self.assertEqual({name for name in names if not name.endswith("/")}, files)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.is_file()], ["gpu"])
        self.assertNotIn("dynamic", must("readelf", "-lW", self.folder / "gpu").lower())

    def test_functions_of_opengl(self) -> None:
        """The library that stands for libGL has all functions for which the others ask, no more."""
        shim = self.libraries["libGL.so.1"]
        opengl = re.compile(r"gl(X)?[A-Z]")
        asked = set()
        for path in self.binaries:
            asked |= {name for name in symbols(path, "--undefined-only") if opengl.match(name)}
        # Since VTK 9.4 VTK looks its functions up by itself.
        if not any(name.startswith("libvtkglad") for name in self.libraries):
            self.assertTrue({"glClear", "glXGetProcAddressARB"} <= asked)
        lookups = {"glXGetProcAddress", "glXGetProcAddressARB"}
        self.assertEqual(symbols(shim, "--defined-only") | lookups, asked | lookups)
        self.assertEqual(needed(shim) - {"libc.so.6"}, {"libvtkIndirectGlibc.so.1"})

    @unittest.skipIf(support.why_no_rendering() is not None, f"{support.why_no_rendering()}")
    def test_it_runs_with_what_is_packed(self) -> None:
        done = run(
            *(self.folder / "gpu", "exec", "IndirectShaderTests", "KernelParity"),
            env=environment(LD_DEBUG="files"),
        )
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertIn("KernelParity: 0 of ", done.stdout)
        # Faults before main are the programs'; a driver's come later.
        text = done.stderr
        before = text[: text.index("initialize program")]
        loaded = {Path(path) for path in re.findall(r"calling init: (/\S+)", before)}
        either = {path.name for path in (self.folder / "lib" / "either").iterdir()}
        allowed = GLIBC | {"libEGL.so.1", "libGLdispatch.so.0"} | either
        strangers = [path for path in loaded
                     if self.folder not in path.parents and path.name not in allowed]  # fmt: skip
        self.assertEqual(strangers, [])
        self.assertIn(self.folder / "lib" / "libGL.so.1", loaded)
        # MPI comes with Debian's VTK. Nothing calls it, and it loads none of its modules.
        self.assertNotRegex(text, r"calling init: \S*/(mca_|openmpi)")
        self.assertNotRegex(done.stdout, "(?i)mpi|warning")

    def path_of_pack(self) -> str:
        """All folders of the pack, so that nothing is taken from the system but glibc."""
        folders = [path.parent for path in self.libraries.values()]
        return ":".join(dict.fromkeys(map(str, folders)))

    def hide_versions(self, name: str, place: Path) -> int:
        """Copy a library of glibc, in which versions newer than the pack may need are not found."""
        program = self.folder / "bin" / "IndirectUnitTests"
        source = re.search(rf"{re.escape(name)} => (\S+)", must("ldd", program))[1]
        data = bytearray(Path(source).read_bytes())
        section = must("readelf", "-VW", source).split("Version definition section", 1)[1]
        start = int(re.search(r"Offset: (0x[0-9a-f]+)", section)[1], 16)
        hidden = 0
        entries = r"(?:0x)?([0-9a-f]+): Rev: 1 .* Name: GLIBC_2\.(\d+)\b"
        for offset, minor in re.findall(entries, section):
            if (2, int(minor)) > packing.floor():
                # The hash by which the loader finds a version, 8 bytes into its entry.
                at = start + int(offset, 16) + 8
                struct.pack_into("<I", data, at, struct.unpack_from("<I", data, at)[0] ^ 1)
                hidden += 1
        (place / name).write_bytes(data)
        return hidden

    def test_a_glibc_that_ends_there(self) -> None:
        """This system's glibc without its newer versions runs the programs, and libraries that are
        not the pack's do not run with it."""
        newest = packing.own_glibc()
        if newest <= packing.floor():
            self.skipTest("the glibc that runs here has no version that the pack may not need")
        with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
            place = Path(name)
            hidden = sum(self.hide_versions(name, place) for name in ("libc.so.6", "libm.so.6"))
            self.assertGreater(hidden, 0)
            program = self.folder / "bin" / "IndirectUnitTests"

            def start_with(path: str) -> subprocess.CompletedProcess[str]:
                words = (LOADER, "--library-path", f"{place}:{path}", program, "RandomStreams")
                return run(*words, env=environment(LD_BIND_NOW="1"))

            done = start_with(self.path_of_pack())
            self.assertEqual(done.returncode, 0, done.stderr)
            source = re.search(r"libstdc\+\+\.so\.6 => (\S+)", must("ldd", program))[1]
            asked = references(Path(source))["libc.so.6"]
            if any(re.match(r"GLIBC_2\.3[5-9]", name) for name in asked):
                (place / "libstdc++.so.6").symlink_to(source)
                done = start_with(self.path_of_pack())
                self.assertNotEqual(done.returncode, 0)
                self.assertRegex(done.stderr, r"version `GLIBC_2\.\d+' not found")

    def test_what_replaces_newer_functions(self) -> None:
        """arc4random and _dl_find_object of the pack do what they are for, as those of glibc."""
        text = r"""
            #define _GNU_SOURCE
            #include <dlfcn.h>
            #include <math.h>
            #include <stdint.h>
            #include <stdio.h>
            #include <string.h>
            struct found { long long flags; void *begin, *end, *map, *eh_frame, *rest[7]; };
            typedef int (*Find)(void*, struct found*);
            #define CHECK(what) if (!(what)) { puts(#what); ++bad; }
            int main(int count, char** words)
            {
              int bad = 0;
              void* pack = dlopen(words[1], RTLD_NOW);
              CHECK(pack)
              uint32_t (*one)(void) = dlsym(pack, "arc4random");
              uint32_t (*below)(uint32_t) = dlsym(pack, "arc4random_uniform");
              void (*fill)(void*, size_t) = dlsym(pack, "arc4random_buf");
              Find find = dlvsym(pack, "_dl_find_object", "GLIBC_2.2.5");
              Find theirs = dlvsym(RTLD_DEFAULT, "_dl_find_object", "GLIBC_2.35");
              CHECK(one && below && fill && find)
              unsigned char bytes[100003];
              int seen[256] = { 0 }, residues[3] = { 0 }, kinds = 0, all = 0;
              memset(bytes, 0, sizeof(bytes));
              fill(bytes, sizeof(bytes) - 1);
              for (int i = 0; i < 100002; ++i) ++seen[bytes[i]];
              for (int i = 0; i < 256; ++i) kinds += seen[i] > 0;
              CHECK(kinds == 256) /* one in 10^167 misses one */
              CHECK(bytes[100002] == 0)
              for (int i = 0; i < 1000; ++i)
              {
                uint32_t residue = below(3);
                if (residue < 3) ++residues[residue];
                all |= one();
              }
              CHECK(residues[0] && residues[1] && residues[2])
              CHECK(residues[0] + residues[1] + residues[2] == 1000)
              CHECK(all == -1)
              CHECK(below(0) == 0 && below(1) == 0)
              void* places[] = { (void*)main, (void*)puts, (void*)one, (void*)dlopen };
              for (int i = 0; i < 4; ++i)
              {
                struct found mine, other;
                CHECK(find(places[i], &mine) == 0)
                CHECK(mine.eh_frame && places[i] >= mine.begin && places[i] < mine.end)
                if (theirs)
                {
                  CHECK(theirs(places[i], &other) == 0)
                  CHECK(mine.eh_frame == other.eh_frame)
                  CHECK(mine.begin == other.begin && mine.end == other.end)
                }
              }
              struct found nothing;
              CHECK(find(NULL, &nothing) == -1)
              CHECK(find(&bad, &nothing) == -1)
              return bad;
            }
        """
        with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
            program = packing.compile_c(Path(name) / "program", text, "-ldl")
            done = run(program, self.libraries["libvtkIndirectGlibc.so.1"])
            self.assertEqual((done.returncode, done.stdout), (0, ""))
            # Exceptions are unwound through it, where the packed libgcc asks for it.
            thrower = Path(name) / "thrower.cxx"
            thrower.write_text(
                "#include <cstdio>\n#include <random>\n#include <stdexcept>\n"
                "int main() { std::random_device device; int caught = 0;\n"
                "for (int i = 0; i < 9; ++i) try { throw std::runtime_error(\"x\"); }\n"
                "catch (const std::exception&) { ++caught; }\n"
                "std::printf(\"%d %d\\n\", caught, device() != device() || device() != device()); }"
            )
            program = Path(name) / "thrower"
            must(packing.compiler("CXX"), "-o", program, thrower)
            library = self.libraries["libvtkIndirectGlibc.so.1"]
            words = (LOADER, "--library-path", self.path_of_pack(), "--preload", library, program)
            done = run(*words, env=environment(LD_DEBUG="bindings", LD_BIND_NOW="1"))
            self.assertEqual((done.returncode, done.stdout), (0, "9 1\n"), done.stderr[-500:])
            if packing.floor() != packing.FLOOR:
                return
            for path in self.folder.glob("lib/either/lib[gs]*/*"):
                for asked in symbols(path, "--undefined-only") & {"arc4random", "_dl_find_object"}:
                    bound = f"{path} [0] to {library} [0]: normal symbol `{asked}'"
                    self.assertTrue(bound in done.stderr, bound)

    def test_a_failure_leaves_the_last_pack(self) -> None:
        done = pack(*self.words, "--program", "NoSuchProgram")
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no program", done.stderr)
        self.assertEqual(run(self.folder / "gpu", "exec").returncode, 2)
        self.assertTrue((self.folder / "bin" / PROGRAMS[0]).is_file())
        names = {"vtk-indirect-gpu", "vtk-indirect-gpu.tar.xz"}
        self.assertEqual({path.name for path in self.output.iterdir()}, names)


class Shim(unittest.TestCase):
    """The library that stands for libGL, with a libEGL that tells what came through."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.place = packing.temporary(cls)
        (cls.place / "gl_functions.h").write_text(
            "GL_FUNCTION(glMany)\nGLX_FUNCTION(glXIsDirect)\nGL_FUNCTION(glNone)\n"
            + "".join(f"GL_FUNCTION(glOther{i})\n" for i in range(300))
        )
        cls.shim = cls.place / "libGL.so.1"
        must(
            *(packing.compiler("C"), "-O2", "-shared", "-fPIC", "-Wl,-soname,libGL.so.1"),
            *(f"-I{cls.place}", "-o", cls.shim, HERE / "libGL.c"),
        )
        cls.egl = packing.compile_c(
            cls.place / "egl" / "libEGL.so.1",
            r"""
            #include <stdio.h>
            #include <string.h>
            static double many(int a, double b, int c, float d, void* e, float f, long g, double h,
              short i, float j, double k, int l, float m, double n, int o, double p)
            {
              printf("%d %g %d %g %p %g %ld %g %d %g %g %d %g %g %d %g\n",
                a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
              return 0.5;
            }
            static int other(int value) { return value + 1; }
            void (*eglGetProcAddress(const char* name))(void)
            {
              /* As a real one may, it uses registers in which arguments are. */
              volatile double used = strlen(name) * 1.5;
              printf("asked for %s%s\n", name, used > 0.0 ? "" : "?");
              return strcmp(name, "glNone") == 0 ? 0
                : (void (*)(void))(strcmp(name, "glMany") == 0 ? (void*)many : (void*)other);
            }
            """,
            *("-shared", "-fPIC", "-Wl,-soname,libEGL.so.1"),
        )
        cls.program = packing.compile_c(
            cls.place / "program",
            r"""
            #include <stdio.h>
            #include <stdlib.h>
            double glMany(int, double, int, float, void*, float, long, double, short, float, double,
              int, float, double, int, double);
            int glOther0(int), glOther298(int), glOther299(int);
            void glNone(void);
            void* glXIsDirect(void);
            void* (*glXGetProcAddress(const char*))(void);
            void* (*glXGetProcAddressARB(const char*))(void);
            int main(int count, char** words)
            {
              setvbuf(stdout, NULL, _IONBF, 0);
              if (count > 1) { glNone(); return 0; }
              for (int i = 0; i < 2; ++i)
                printf("%g\n", glMany(1, 2.5, 3, 4.5f, (void*)5, 6.5f, 7, 8.5, 9, 10.5f, 11.5, 12,
                  13.5f, 14.5, 15, 16.5));
              printf("%d\n", glOther0(1));
              printf("%d\n", glOther298(2));
              printf("%d\n", glOther299(3));
              printf("%d\n", glOther298(4));
              printf("%p %p\n", glXIsDirect(), glXGetProcAddress("glXGetCurrentDisplay")());
              printf("%d\n", ((int (*)(int))glXGetProcAddressARB("glElse"))(6));
              return 0;
            }
            """,
            *(cls.shim, "-Wl,--allow-shlib-undefined"),
        )

    def start(self, *folders: Path, words: tuple = ()) -> subprocess.CompletedProcess[str]:
        path = ":".join(str(folder) for folder in (self.place, *folders))
        return run(self.program, *words, env={"LD_LIBRARY_PATH": path, "LC_ALL": "C"})

    def test_arguments_and_values_pass(self) -> None:
        done = self.start(self.egl.parent)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        many = "1 2.5 3 4.5 0x5 6.5 7 8.5 9 10.5 11.5 12 13.5 14.5 15 16.5\n0.5\n"
        # Functions are asked for when they are first called, and once.
        self.assertEqual(
            done.stdout,
            f"asked for glMany\n{many}{many}"
            "asked for glOther0\n2\nasked for glOther298\n3\nasked for glOther299\n4\n5\n"
            "(nil) (nil)\nasked for glElse\n7\n",
        )

    def test_what_a_driver_lacks(self) -> None:
        done = self.start(self.egl.parent, words=("none",))
        self.assertEqual((done.returncode, done.stderr), (1, "gpu: the driver has no glNone\n"))

    def test_a_library_that_is_no_egl(self) -> None:
        empty = packing.compile_c(self.place / "no" / "libEGL.so.1", "", "-shared", "-fPIC")
        done = self.start(empty.parent, words=("none",))
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "gpu: libEGL.so.1 has no eglGetProcAddress\n")


class Errors(unittest.TestCase):
    """One line for each, and nothing is lost."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)

    def refused(self, done: subprocess.CompletedProcess[str], text: str) -> None:
        """Check that a command failed and said why; lines of other programs may come first."""
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn(text, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertLessEqual(len(done.stderr.splitlines()), 2, done.stderr)

    def test_no_build(self) -> None:
        done = pack("--build", self.place / "none", "--output", self.place)
        self.refused(done, "there is no build in")
        self.assertEqual(list(self.place.iterdir()), [])

    def test_options(self) -> None:
        self.refused(pack("--what", "ever"), "pack knows no --what")
        self.refused(pack("--output"), "--output wants a value")
        packing.require("xz")
        build = ("--build", packing.BUILD, "--output", self.place, "--program", PROGRAMS[0])
        self.refused(pack(*build, "--glibc", "new"), "new is no version of glibc")
        self.assertEqual(run(GPU, "what").returncode, 2)

    def test_a_folder_that_is_no_pack(self) -> None:
        packing.require("xz")
        folder = self.place / "vtk-indirect-gpu"
        folder.mkdir()
        (folder / "precious").touch()
        done = pack(
            *("--build", packing.BUILD, "--output", self.place, "--program", PROGRAMS[0])
        )
        self.refused(done, "is there and no pack")
        self.assertTrue((folder / "precious").is_file())

    def test_a_tool_that_is_missing(self) -> None:
        tools = self.place / "bin"
        tools.mkdir()
        names = ("bash", "env", "dirname", "realpath", "sed", "xz", "rm", "mkdir", "readelf", "ldd",
                 "strip")  # fmt: skip
        packing.require(*names)
        for name in names:
            (tools / name).symlink_to(shutil.which(name))
        done = pack(
            *("--build", packing.BUILD, "--output", self.place, "--program", PROGRAMS[0]),
            PATH=str(tools),
        )
        self.refused(done, "patchelf is missing (Debian: patchelf)")

    def test_a_glibc_older_than_can_be_done(self) -> None:
        packing.require("patchelf")
        done = pack(
            *("--build", packing.BUILD, "--output", self.place, "--program", PROGRAMS[0]),
            *("--glibc", "2.14"),
        )
        self.refused(done, "may need glibc 2.14 only")

    def test_a_pack_that_is_too_large(self) -> None:
        """2 MB that cannot be compressed, in a program."""
        packing.require("patchelf", "objcopy")
        (self.place / "build" / "bin").mkdir(parents=True)
        shutil.copy(packing.BUILD / "CMakeCache.txt", self.place / "build")
        noise, program = self.place / "noise", self.place / "build" / "bin" / "Large"
        noise.write_bytes(os.urandom(2_000_000))
        packing.compile_c(self.place / "small", "int main(void) { return 0; }")
        must("objcopy", f"--add-section=.noise={noise}", self.place / "small", program)
        output = self.place / "output"
        words = ("--build", program.parents[1], "--output", output, "--program", "Large")
        self.refused(pack(*words, "--most", 2), "MB compressed, and may have 2 MB")
        self.assertEqual(list(output.iterdir()), [])
        self.refused(pack(*words, "--most", "2.5"), "--most wants a number of megabytes, not 2.5")
        self.assertEqual(pack(*words).returncode, 0)
