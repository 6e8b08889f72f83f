# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and buffers as NumPy arrays, and writing them to files.

All arrays have the bottom row first, as VTK's images do.
"""

from __future__ import annotations

import os
import re
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from vtkindirect import interrupts, messages, methods, wrapped
from vtkindirect.arrays import as_array, as_image
from vtkindirect.errors import RenderError, UsageError, check_text, unknown

FINAL = "final"
BUFFERS = (
    FINAL,
    "direct",
    "indirect",
    "irradiance",
    "sky",
    "area",
    "bounce",
    "glossy",
    "albedo",
    "normal",
    "depth",
    "specular",
    "caught",
    "lights",
    "branches",
    "lobes",
)
MAP_BUFFERS = ("depth", "normal", "density")
# Buffers of multiresolution splatting; <n> is a level, 0 for pixels.
SUBSPLAT_BUFFERS = (
    "subsplat.level",
    "subsplat.outline",
    "subsplat.evaluated<n>",
    "subsplat.upsampled<n>",
)
# A buffer of splatting: the number of splats at each pixel over 256.
SPLAT_BUFFERS = ("splat.overdraw",)
FORMATS = (".png", ".exr")
JPEG_QUALITY = 95

_MAP = re.compile(rf"rsm\d{{1,3}}\.({'|'.join(MAP_BUFFERS)})")
_SUBSPLAT = re.compile(
    "|".join(re.escape(name).replace("<n>", r"\d{1,2}") for name in SUBSPLAT_BUFFERS)
)


def check_buffer(name: str) -> str:
    """Return the name of a buffer that a pass may have."""
    check_text("buffer", name)
    if name in (*BUFFERS, *SPLAT_BUFFERS) or _MAP.fullmatch(name) or _SUBSPLAT.fullmatch(name):
        return name
    maps = (f"rsm0.{kind}" for kind in MAP_BUFFERS)
    known = (*BUFFERS, *maps, *SUBSPLAT_BUFFERS, *SPLAT_BUFFERS)
    raise UsageError(unknown("buffer", name, known))


def copy_buffer(target: Any, name: str) -> np.ndarray:
    """Return a buffer of the last frame as an array of height x width x components, float32.

    `target` is a pass, or what `vtkindirect.enable` was called with. Linear values, not clamped;
    vectors in world coordinates, depth in scene units along the view axis, 0 where nothing is.
    """
    check_buffer(name)
    indirect = methods.pass_of(target)
    if indirect is None:
        raise UsageError(f"indirect light is off, there is no buffer '{name}'")
    image = vtkImageData()
    with messages.capture() as said:
        copied = indirect.CopyBuffer(name, image)
    if not copied or image.GetPointData().GetScalars() is None:
        reason = said.first_error() or "this scene and method do not make it"
        raise RenderError(f"there is no buffer '{name}': {reason}")
    return as_array(image).astype(np.float32, copy=False)


def window_bytes(window: vtkRenderWindow) -> np.ndarray:
    """Return what a window shows: height x width x 3, 8 bits."""
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(height, width, 3).copy()


def window_floats(window: vtkRenderWindow) -> np.ndarray:
    """Return what a window shows: height x width x 3, floats from 0 to 1."""
    width, height = window.GetSize()
    pixels = vtkFloatArray()
    window.GetRGBAPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(height, width, 4)[:, :, :3].astype(np.float32, copy=True)


# Files --------------------------------------------------------------------------------------------


def is_stream(path: Path) -> bool:
    """Return whether a path is a stream: a pipe, a device such as /dev/null, a terminal."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return is_stdout(path) or not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def is_stdout(path: Path) -> bool:
    """Return whether a path is what standard output goes to, such as /dev/stdout."""
    try:
        return os.path.samestat(path.stat(), os.fstat(1))
    except OSError:
        return False


def ending(path: Path, formats: tuple[str, ...]) -> str:
    """Return which of the formats a file is written in: by its name, of a stream else the first."""
    found = path.suffix.lower()
    return formats[0] if is_stream(path) and found not in formats else found


def target_of(path: Path) -> Path:
    """Return the file that a path stands for: of a link what it points to, there or not."""
    return Path(os.path.realpath(path))


def check_output(path: str | os.PathLike[str], formats: tuple[str, ...]) -> Path:
    """Return the path of a file that can be written; raises `UsageError` when it cannot.

    Where it is a link its target is written. A pipe or a device may have any name.
    """
    path = Path(path)
    if ending(path, formats) not in formats:
        raise UsageError(f"{path}: the file name must end in {' or '.join(formats)}")
    if ending(path, formats) == ".exr" and not wrapped.has("vtkOpenEXRWriter"):
        raise UsageError(f"{path}: {wrapped.explain('vtkOpenEXRWriter')}")
    target = target_of(path)
    if target.is_symlink():
        raise UsageError(f"{path}: is a link that leads back to itself")
    if not is_stream(path):
        check_directory(target.parent if path.is_symlink() else path.parent)
    if path.is_dir():
        raise UsageError(f"{path}: is a directory")
    if path.exists() and not os.access(path, os.W_OK):
        raise UsageError(f"{path}: cannot be written: permission denied")
    return path


def check_directory(path: Path) -> None:
    """Raise unless files can be made in a directory, by making one."""
    if not path.exists():
        raise UsageError(f"{path}: no such directory")
    if not path.is_dir():
        raise UsageError(f"{path}: is not a directory")
    try:
        with tempfile.TemporaryFile(dir=path):
            pass
    except OSError as error:
        raise UsageError(f"{path}: cannot be written: {error.strerror}") from None


_unfinished: set[Path] = set()


def _remove_unfinished() -> None:
    for path in list(_unfinished):
        path.unlink(missing_ok=True)


interrupts.before_end(_remove_unfinished)


@contextmanager
def complete_file(path: Path) -> Iterator[Path]:
    """Give the name of a temporary file that becomes `path` when all went well.

    It is beside the file that `path` stands for, which keeps its permissions. Its content goes
    into a stream as a whole.
    """
    try:
        stream = is_stream(path)
        target = target_of(path)
        handle, name = tempfile.mkstemp(
            prefix=f".{path.stem}-",
            suffix=path.suffix,
            dir=None if stream else target.parent,
        )
        os.close(handle)
    except OSError as error:
        raise RenderError(f"{path}: cannot be written: {error.strerror or error}") from None
    temporary = Path(name)
    _unfinished.add(temporary)
    try:
        yield temporary
        if stream:
            with _open_stream(path) as file:
                file.write(temporary.read_bytes())
            return
        mask = os.umask(0)
        os.umask(mask)
        mode = stat.S_IMODE(target.stat().st_mode) if target.exists() else 0o666 & ~mask
        temporary.chmod(mode)
        temporary.replace(target)
    except OSError as error:
        raise RenderError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        temporary.unlink(missing_ok=True)
        _unfinished.discard(temporary)


def _open_stream(path: Path) -> BinaryIO:
    """Open a stream for writing; standard output may be what no path opens, such as a socket."""
    if is_stdout(path):
        return os.fdopen(os.dup(1), "wb")
    return path.open("wb")


def write_png(path: Path, values: np.ndarray) -> None:
    """Write 8-bit values, or floats that are clamped to 0 to 1, as a PNG file."""
    if values.dtype != np.uint8:
        finite = np.nan_to_num(values, nan=0.0, posinf=1.0, neginf=0.0)
        values = np.rint(np.clip(finite, 0.0, 1.0) * 255.0).astype(np.uint8)
    _write_with(vtkPNGWriter(), path, values)


def _write_with(writer: Any, path: Path, values: np.ndarray) -> None:
    """Write 8-bit values with a writer of VTK's."""
    writer.SetInputData(as_image(values))
    writer.WriteToMemoryOn()
    writer.Write()
    with complete_file(path) as temporary:
        temporary.write_bytes(vtk_to_numpy(writer.GetResult()).tobytes())


def write_bytes(path: Path, values: np.ndarray) -> None:
    """Write 8-bit values as a JPEG or a PNG file, as its name says."""
    if path.suffix.lower() in (".jpg", ".jpeg"):
        writer = vtkJPEGWriter()
        writer.SetQuality(JPEG_QUALITY)
        _write_with(writer, path, values)
    else:
        _write_with(vtkPNGWriter(), path, values)


def write_exr(path: Path, values: np.ndarray, full: bool = False) -> None:
    """Write floats as an OpenEXR file, in 16 bits, or in 32 when `full` or out of their range."""
    writer = wrapped.get("vtkOpenEXRWriter")()
    full = full or bool(np.abs(values).max(initial=0.0) > np.finfo(np.float16).max)
    writer.SetPixelType(writer.FloatPixels if full else writer.HalfPixels)
    writer.SetInputData(as_image(values.astype(np.float32, copy=False)))
    with complete_file(path) as temporary, messages.capture() as said:
        writer.SetFileName(os.fspath(temporary))
        writer.Write()
        if said.errors or writer.GetErrorCode():
            reason = (said.first_error() or "writing failed").replace(str(temporary), str(path))
            raise RenderError(f"{path}: cannot be written: {reason}")


def write_text(path: Path, text: str) -> None:
    """Write a text file."""
    with complete_file(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def write_image(path: Path, values: np.ndarray, full: bool = False) -> None:
    """Write an image in the format that the file name says; into a stream without one as PNG."""
    if ending(path, FORMATS) == ".exr":
        write_exr(path, values, full)
    else:
        write_png(path, values)
