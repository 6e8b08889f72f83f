# SPDX-License-Identifier: BSD-3-Clause
"""Gathers programs with all libraries that they need, so that they run on another Linux.

    python3 closure.py FOLDER --build BUILD [--glibc VERSION] PROGRAM...

FOLDER, which must exist, gets:

    gpu                     what starts a program (launcher.cxx)
    bin/                    the programs, which are those of BUILD/bin
    lib/                    libraries that are always taken from here
    lib/either/SONAME/      libraries that a driver of OpenGL may load, too: the launcher takes the
                            system's instead where it has all versions that are asked for
    lib/glvnd/              the dispatcher libEGL, for where the system has none
    lib/needs.txt           what the launcher has to find: "system" or "either", a library's name,
                            and the versions that are asked of it

Left out are glibc and all that belongs to drivers. Libraries of GLX are replaced by one that is
made here (libGL.c). Nothing in FOLDER needs a glibc newer than VERSION, 2.34 by default: for what
libraries of newer systems ask beyond, there is glibc.c. Needs readelf, strip, patchelf, ldd, and
the compilers with which BUILD was configured.
"""

from __future__ import annotations

import argparse
import os
import platform
import re
import shutil
import struct
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent

GLIBC = re.compile(
    r"(libc|libm|libmvec|libdl|libpthread|librt|libresolv|libutil|libanl|libnsl"
    r"|ld-linux-x86-64)\.so"
)
"""Libraries of glibc. They fit their loader and their kernel, so the system's are taken."""

GLX = re.compile(r"(libGL|libOpenGL|libGLX)\.so")
"""Libraries whose functions libGL.c has."""

EGL = "libEGL.so.1"

DRIVER = re.compile(r"lib(EGL|GLdispatch|GLES\w*|gbm|drm\w*|glapi|EGL_\w+|GLX_\w+|gallium\S*)\.so")
"""Libraries of drivers, or such as fit a driver only."""

EITHER = re.compile(
    r"lib(stdc\+\+|gcc_s|z|zstd|lz4|lzma|bz2|expat|xml2|ffi|elf|edit|tinfo|bsd|md|udev|cap|systemd"
    r"|X11|X11-xcb|Xau|Xdmcp|Xext|Xfixes|xcb(-\w+)?|xshmfence|wayland-\w+|LLVM\S*|sensors"
    r"|pciaccess)\.so"
)
"""Libraries that drivers load, too, Mesa's or others. The newer of two must be taken, as a process
has one only, and that is the system's where it is new enough."""

OPENED = {"libtbb.so.12": ("libtbbmalloc.so.2",)}
"""Libraries that others load by dlopen. TBB takes its own allocator if it finds it, and does without the
others that it looks for, as VTK places no thread. MPI and hwloc load modules only when they are
called, and nothing here calls them."""

REPLACED = {"arc4random", "arc4random_buf", "arc4random_uniform", "_dl_find_object"}
"""Functions of newer glibcs that glibc.c has."""

OLDEST = "GLIBC_2.2.5"
"""The version under which glibc.c has them: that of the first glibc for x86-64."""

PACKAGES = {"readelf": "binutils", "strip": "binutils", "patchelf": "patchelf", "ldd": "libc-bin"}


class PackError(Exception):
    """Errors that are one line."""


def run(*words: str | Path) -> str:
    """Return what a tool prints; its own words, should it fail."""
    command = [str(word) for word in words]
    if not shutil.which(command[0]):
        package = PACKAGES.get(command[0])
        raise PackError(f"{command[0]} is missing" + (f" (Debian: {package})" if package else ""))
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C"}
    done = subprocess.run(
        command, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=environment
    )
    if done.returncode != 0:
        raise PackError(f"{' '.join(command)}: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def needed(path: Path) -> list[str]:
    """Names of the libraries for which a file asks."""
    return re.findall(r"\(NEEDED\)\s+Shared library: \[(.*)\]", run("readelf", "-dW", path))


def release(version: str) -> tuple[int, ...] | None:
    """The numbers of GLIBC_2.34; nothing for versions that are not a release of glibc."""
    match = re.fullmatch(r"GLIBC_(\d+(?:\.\d+)*)", version)
    return tuple(int(number) for number in match[1].split(".")) if match else None


def versions(path: Path) -> list[tuple[str, str, int]]:
    """Versions for which a file asks: the library, the version, and its place in the file."""
    found = []
    inside, start, library = False, 0, ""
    for line in run("readelf", "-VW", path).splitlines():
        if line.startswith("Version "):
            inside = line.startswith("Version needs section")
        elif inside and (match := re.search(r"Offset: (0x[0-9a-f]+)", line)):
            start = int(match[1], 16)
        elif inside and (match := re.match(r"\s+\w+: Version: \d+\s+File: (\S+)", line)):
            library = match[1]
        elif inside and (match := re.match(r"\s+(?:0x)?([0-9a-f]+):\s+Name: (\S+)", line)):
            found.append((library, match[2], start + int(match[1], 16)))
    return found


def asked(path: Path) -> list[tuple[str, str]]:
    """Functions and variables that a file asks of others: the name, and its version or nothing."""
    found = []
    for line in run("readelf", "--dyn-syms", "-W", path).splitlines():
        match = re.match(r"\s*\d+: .* UND ([^\s@]+)(?:@(\S+))?", line)
        if match:
            found.append((match[1], match[2] or ""))
    return found


def resolve(path: Path) -> dict[str, Path]:
    """Return where the loader of this system finds what a file needs, transitively."""
    found = {}
    for line in run("ldd", path).splitlines():
        name, arrow, place = line.strip().partition(" => ")
        if arrow and place.startswith("not found"):
            raise PackError(f"{path} needs {name}, which is not there")
        if arrow and place.startswith("/"):
            found[name] = Path(place.rsplit(" (", 1)[0])
    return found


class Pack:
    """A folder, and what was put into it."""

    def __init__(self, folder: Path, build: Path, floor: str) -> None:
        self.folder = folder
        self.build = build
        self.floor = floor
        self.files: list[Path] = []
        self.glibc: set[Path] = set()
        self.oldest: set[str] | None = None
        self.cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")

    def compiler(self, language: str) -> str:
        """The compiler with which the build was configured."""
        match = re.search(rf"^CMAKE_{language}_COMPILER:\w+=(.+)$", self.cache, re.MULTILINE)
        if not match:
            raise PackError(f"{self.build}/CMakeCache.txt names no compiler for {language}")
        return match[1]

    def compile(self, language: str, target: Path, *words: str | Path) -> Path:
        """Compiles one of the sources that lie here."""
        target.parent.mkdir(parents=True, exist_ok=True)
        run(self.compiler(language), "-O2", "-s", "-Wall", "-o", target, *words)
        return target

    def copy(self, source: Path, target: Path) -> None:
        """Copies a file without symbols for debuggers, and without paths of this machine."""
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
        target.chmod(0o755)
        run("strip", "--strip-unneeded", target)
        if re.search(r"\((RPATH|RUNPATH)\)", run("readelf", "-dW", target)):
            run("patchelf", "--remove-rpath", target)
        self.files.append(target)

    def gather(self, programs: list[str]) -> None:
        """Copies the programs and their libraries."""
        sources: dict[str, Path] = {}
        waiting: list[Path] = []
        shims: set[str] = set()
        for program in programs:
            path = self.build / "bin" / program
            if not path.is_file():
                raise PackError(f"there is no program {path}")
            sources.update(resolve(path))
            self.copy(path, self.folder / "bin" / program)
            waiting.append(path)
        self.glibc = {path for name, path in sources.items() if GLIBC.match(name)}
        taken: dict[str, Path] = {}
        while waiting:
            path = waiting.pop()
            names = needed(path)
            for name in OPENED.get(path.name, ()):
                sources.setdefault(name, path.parent / name)
                names.append(name)
            for name in names:
                if GLX.match(name):
                    shims.add(name)
                elif name == EGL or GLIBC.match(name) or name in taken:
                    continue
                elif DRIVER.match(name):
                    raise PackError(f"{path} needs {name}, which belongs to a driver")
                else:
                    if not sources[name].is_file():
                        raise PackError(f"{path} loads {name}, which is not there")
                    taken[name] = sources[name]
                    waiting.append(sources[name])
        for name, source in sorted(taken.items()):
            place = f"lib/either/{name}" if EITHER.match(name) else "lib"
            self.copy(source, self.folder / place / name)
        self.make_shims(sorted(shims))
        self.copy_dispatcher(sources)

    def make_shims(self, names: list[str]) -> None:
        """Makes libGL.so.1, with all functions for which the files ask, and libraries of other
        names that are nothing but it. With it comes what an older glibc lacks."""
        functions = sorted(
            {
                name
                for path in self.files
                for name, _ in asked(path)
                if re.match(r"gl(X)?[A-Z]", name) and not name.startswith("glXGetProcAddress")
            }
        )
        header = self.folder / "gl_functions.h"
        header.write_text(
            "".join(
                f"{'GLX' if name.startswith('glX') else 'GL'}_FUNCTION({name})\n"
                for name in functions
            ),
            encoding="utf-8",
        )
        library = self.folder / "lib"
        glibc = self.compile(
            "C",
            library / "libvtkIndirectGlibc.so.1",
            "-shared",
            "-fPIC",
            "-Wl,-soname,libvtkIndirectGlibc.so.1",
            f"-Wl,--version-script={HERE / 'glibc.map'}",
            HERE / "glibc.c",
        )
        self.files.append(glibc)
        # Each program loads libGL.so.1, and so the other, too. Since VTK 9.4 no library of VTK's
        # asks for it: VTK looks functions up by itself.
        asks = {name for path in self.files for name in needed(path)}
        if not asks & {"libGL.so.1", *names}:
            for program in (self.folder / "bin").iterdir():
                run("patchelf", "--add-needed", "libGL.so.1", program)
        words = ("-shared", "-fPIC", "-Wl,--no-as-needed")
        main = self.compile(
            "C",
            library / "libGL.so.1",
            *words,
            "-Wl,-soname,libGL.so.1",
            f"-I{self.folder}",
            HERE / "libGL.c",
            glibc,
        )
        header.unlink()
        self.files.append(main)
        for name in names:
            if name != main.name:
                other = library / name
                empty = self.folder / "empty.c"
                empty.write_text("", encoding="utf-8")
                self.compile("C", other, *words, f"-Wl,-soname,{name}", empty, main)
                empty.unlink()
                self.files.append(other)

    def copy_dispatcher(self, sources: dict[str, Path]) -> None:
        """Copies libglvnd's libEGL, if this system has it: it is no driver, but finds one."""
        library = sources.get(EGL)
        if not library or "libGLdispatch.so.0" not in needed(library):
            print(f"no {EGL} of libglvnd's here: the pack will need the system's")
            return
        place = self.folder / "lib" / "glvnd"
        for name in (EGL, "libGLdispatch.so.0"):
            self.copy(sources[name], place / name)
        (place / "10_nvidia.json").write_text(
            '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}\n',
            encoding="utf-8",
        )

    def lower(self) -> None:
        """Lets the files ask for functions of newer glibcs under the oldest version."""
        for path in self.files:
            entries = versions(path)
            newer = {
                (library, version): offset
                for library, version, offset in entries
                if GLIBC.match(library) and self.is_newer(version)
            }
            if not newer:
                continue
            for name, version in asked(path):
                if any(version == other for _, other in newer) and not self.is_older(name):
                    raise PackError(
                        f"{path.name} needs {name} of {version}, and the pack may need glibc"
                        f" {self.floor} only (--glibc)"
                    )
            # Not a function's, but one that says how the file is to be loaded.
            for _, version in newer:
                if release(version) is None:
                    raise PackError(f"{path.name} needs a glibc with {version}")
            old = [offset for _, version, offset in entries if version == OLDEST]
            if not old:
                raise PackError(f"{path.name} asks for nothing of {OLDEST}")
            data = bytearray(path.read_bytes())
            # An Elf64_Vernaux: hash of the version's name, flags, index, the name, the next's.
            form = "<IHHII"
            hashed, _, _, name, _ = struct.unpack_from(form, data, old[0])
            for offset in newer.values():
                _, flags, index, _, following = struct.unpack_from(form, data, offset)
                struct.pack_into(form, data, offset, hashed, flags, index, name, following)
            path.write_bytes(data)

    def is_older(self, name: str) -> bool:
        """Return whether a function of a newer glibc has the oldest version, too: from glibc.c,
        or from glibc itself, which keeps what it makes anew, such as hypot."""
        if self.oldest is None:
            self.oldest = set(REPLACED)
            for library in self.glibc:
                text = run("readelf", "--dyn-syms", "-W", library)
                self.oldest.update(re.findall(rf" (\w+)@@?{re.escape(OLDEST)}\b", text))
        return name in self.oldest

    def is_newer(self, version: str) -> bool:
        """Return whether a version is of a glibc that is too new for the pack, or unknown."""
        numbers = release(version)
        return numbers is None or numbers > release(f"GLIBC_{self.floor}")

    def check(self) -> None:
        """Check that the libraries of a file are here or the system's, and no glibc too new."""
        here = {path.name for path in self.files}
        for path in self.files:
            for name in needed(path):
                if name not in here and name != EGL and not GLIBC.match(name):
                    raise PackError(f"{path.name} needs {name}, which is not in the pack")
            for library, version, _ in versions(path):
                if GLIBC.match(library) and self.is_newer(version):
                    raise PackError(f"{path.name} needs {version} of {library}")

    def write_needs(self) -> None:
        """Writes what the launcher reads."""
        wanted: dict[str, set[str]] = defaultdict(set)
        for path in self.files:
            for library, version, _ in versions(path):
                wanted[library].add(version)
        lines = ["# Versions needed of the system, or else of the pack; gpu reads this."]
        for name in sorted(wanted):
            if GLIBC.match(name):
                lines.append(" ".join(["system", name, *sorted(wanted[name])]))
        either = self.folder / "lib" / "either"
        for path in sorted(either.iterdir()) if either.is_dir() else ():
            lines.append(" ".join(["either", path.name, *sorted(wanted[path.name])]))
        target = self.folder / "lib" / "needs.txt"
        target.write_text("\n".join(lines) + "\n", encoding="utf-8")

    def make_launcher(self) -> None:
        """Makes what starts a program."""
        self.compile("CXX", self.folder / "gpu", "-std=c++17", "-static", HERE / "launcher.cxx")


def main() -> int:
    """Gathers what the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--glibc", default="2.34")
    options = parser.parse_args()
    try:
        if not release(f"GLIBC_{options.glibc}"):
            raise PackError(f"{options.glibc} is no version of glibc, such as 2.34")
        if platform.system() != "Linux" or platform.machine() != "x86_64":
            raise PackError("only programs for Linux on x86-64 can be packed")
        pack = Pack(options.folder.resolve(), options.build.resolve(), options.glibc)
        pack.gather(options.programs)
        pack.lower()
        pack.check()
        pack.write_needs()
        pack.make_launcher()
    except (PackError, OSError) as error:
        print(f"closure: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
