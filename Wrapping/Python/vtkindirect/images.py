# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and buffers as NumPy arrays, and writing them to files.

All arrays have the bottom row first, as VTK's images do.
"""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from vtkindirect import messages, methods, wrapped
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
    "lights",
    "branches",
    "lobes",
)
MAP_BUFFERS = ("depth", "normal", "density")
# Of multiresolution splatting; <n> is a level, 0 for pixels.
SUBSPLAT_BUFFERS = (
    "subsplat.level",
    "subsplat.outline",
    "subsplat.evaluated<n>",
    "subsplat.upsampled<n>",
)
# Of splatting: the number of splats at each pixel over 256.
SPLAT_BUFFERS = ("splat.overdraw",)
FORMATS = (".png", ".exr")

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
    scalars = image.GetPointData().GetScalars()
    if not copied or scalars is None:
        reason = said.first_error() or "this scene and method do not make it"
        raise RenderError(f"there is no buffer '{name}': {reason}")
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(scalars).astype(np.float32, copy=True)
    return values.reshape(height, width, scalars.GetNumberOfComponents())


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


def check_output(path: str | os.PathLike[str], formats: tuple[str, ...]) -> Path:
    """Return the path of a file that can be written; raises `UsageError` when it cannot."""
    path = Path(path)
    if path.suffix.lower() not in formats:
        raise UsageError(f"{path}: the file name must end in {' or '.join(formats)}")
    if path.suffix.lower() == ".exr" and not wrapped.has("vtkOpenEXRWriter"):
        raise UsageError(f"{path}: {wrapped.explain('vtkOpenEXRWriter')}")
    check_directory(path.parent)
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


@contextmanager
def complete_file(path: Path) -> Iterator[Path]:
    """Give the name of a temporary file beside `path` that becomes `path` when all went well."""
    handle, name = tempfile.mkstemp(prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent)
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        temporary.replace(path)
    except OSError as error:
        raise RenderError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        temporary.unlink(missing_ok=True)


def _as_image(values: np.ndarray) -> vtkImageData:
    height, width, components = values.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(values).reshape(-1, components)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def write_png(path: Path, values: np.ndarray) -> None:
    """Write 8-bit values, or floats that are clamped to 0 to 1, as a PNG file."""
    if values.dtype != np.uint8:
        finite = np.nan_to_num(values, nan=0.0, posinf=1.0, neginf=0.0)
        values = np.rint(np.clip(finite, 0.0, 1.0) * 255.0).astype(np.uint8)
    writer = vtkPNGWriter()
    writer.SetInputData(_as_image(values))
    writer.WriteToMemoryOn()
    writer.Write()
    with complete_file(path) as temporary:
        temporary.write_bytes(vtk_to_numpy(writer.GetResult()).tobytes())


def write_exr(path: Path, values: np.ndarray, full: bool = False) -> None:
    """Write floats as an OpenEXR file, in 16 bits, or in 32 when `full` or out of their range."""
    writer = wrapped.get("vtkOpenEXRWriter")()
    full = full or bool(np.abs(values).max(initial=0.0) > np.finfo(np.float16).max)
    writer.SetPixelType(writer.FloatPixels if full else writer.HalfPixels)
    writer.SetInputData(_as_image(values.astype(np.float32, copy=False)))
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
    """Write an image in the format that the file name says."""
    if path.suffix.lower() == ".exr":
        write_exr(path, values, full)
    else:
        write_png(path, values)
