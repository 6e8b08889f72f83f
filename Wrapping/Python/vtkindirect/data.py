# SPDX-License-Identifier: BSD-3-Clause
"""Reads data files with VTK's readers. One row of `READERS` is one kind of file.

The report of a reader about a file is its error. A file is looked at before only where its reader
would end or stall the whole program instead.
"""

from __future__ import annotations

import contextlib
import os
import re
import struct
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkAbstractArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkDataSetAttributes,
    vtkImageData,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter
from vtkmodules.vtkIOChemistry import vtkPDBReader
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import (
    vtkHDRReader,
    vtkImageReader2Factory,
    vtkMetaImageReader,
    vtkNIFTIImageReader,
)
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader,
    vtkXMLMultiBlockDataReader,
    vtkXMLPolyDataReader,
    vtkXMLRectilinearGridReader,
    vtkXMLStructuredGridReader,
    vtkXMLUnstructuredGridReader,
)

from vtkindirect import messages, working, wrapped
from vtkindirect.errors import UsageError


class _Damaged(Exception):
    """The file is not as its reader needs it."""


# Faults for which readers end the program ---------------------------------------------------------


def _check_stl(path: Path) -> None:
    """A binary STL file says how many triangles of 50 bytes follow, and the reader believes it."""
    with path.open("rb") as file:
        header = file.read(84)
    if header.lstrip().startswith(b"solid") and b"\0" not in header or len(header) < 84:
        return
    (triangles,) = struct.unpack("<I", header[80:])
    room = (path.stat().st_size - 84) // 50
    if room < triangles:
        raise _Damaged(f"it has room for {room} of {triangles} triangles")


def _check_ply(path: Path) -> None:
    """A PLY header says how many elements follow; the shortest possible ones must fit.

    The reader frees memory twice when they do not.
    """
    sizes = {
        **dict.fromkeys(("char", "uchar", "int8", "uint8"), 1),
        **dict.fromkeys(("short", "ushort", "int16", "uint16"), 2),
        **dict.fromkeys(("int", "uint", "float", "int32", "uint32", "float32"), 4),
        **dict.fromkeys(("double", "float64", "int64", "uint64"), 8),
    }
    elements: list[list] = []  # name, count, [property words]
    binary = False
    with path.open("rb") as file:
        for line in iter(lambda: file.readline(4096), b""):
            words = line.decode("latin-1").split()
            if words[:1] == ["format"]:
                binary = words[1:2] != ["ascii"]
            elif words[:1] == ["element"] and len(words) == 3:
                elements.append([words[1], int(words[2]), []])
            elif words[:1] == ["property"] and elements:
                elements[-1][2].append(words[1:])
            elif words[:1] == ["end_header"]:
                break
        else:
            raise _Damaged("its header has no end")
        if any(count < 0 for _, count, _ in elements):
            raise _Damaged("its header has a negative number of elements")
        if not binary:
            wanted = sum(count for _, count, _ in elements)
            lines = sum(1 for line in file if line.strip())
            if lines < wanted:
                raise _Damaged(f"it has {lines} of {wanted} lines of elements")
            return
        there = path.stat().st_size - file.tell()
    expected = 0
    for _, count, properties in elements:
        size = 0
        for words in properties:
            if words[0] == "list":
                corners = 3 if words[-1] in ("vertex_indices", "vertex_index") else 0
                size += sizes.get(words[1], 0) + corners * sizes.get(words[2], 0)
            else:
                size += sizes.get(words[0], 0)
        expected += count * size
    if there < expected:
        raise _Damaged(f"it holds {there} of at least {expected} bytes of elements")


def _tidied_pdb(path: Path) -> bytes:
    """Return the text without what newer versions of VTK's reader end the whole program for.

    It leaves out blank lines, carriage returns, what is not ASCII or controls something, what
    stands after the 80 columns of a line, which the reader takes for another line, and residues
    without a number; an atom without a position cannot be mended.
    """
    tidied = []
    text = path.read_text("utf-8", "replace").encode("ascii", "replace")
    for number, whole_line in enumerate(_CONTROLS.sub(b"?", text).splitlines(), 1):
        line = whole_line[:80]
        record = line.upper().split()[:1]
        if record in _ATOMS and not _have_numbers(line, _POSITION, _DECIMAL):
            raise _Damaged(f"line {number} is an atom without position")
        if record in _ATOMS and not _have_numbers(line, _RESIDUE, _INTEGER):
            line = line[:22] + b"   0" + line[26:]
        whole = _have_numbers(line, _STRUCTURES.get(b"".join(record), ()), _INTEGER)
        if record and whole:
            tidied.append(line.rstrip())
    return b"\n".join(tidied) + b"\n"


# The columns of numbers in the lines of a PDB file, from 0 on.
_ATOMS = ([b"ATOM"], [b"HETATM"])
_POSITION = (slice(30, 38), slice(38, 46), slice(46, 54))
_RESIDUE = (slice(22, 26),)
_STRUCTURES = {
    b"HELIX": (slice(21, 25), slice(33, 37)),
    b"SHEET": (slice(22, 26), slice(33, 37)),
}
_CONTROLS = re.compile(rb"[^\t\n\r -~]")
_DECIMAL = re.compile(rb" *[-+]?(\d+\.?\d*|\.\d+) *")
_INTEGER = re.compile(rb" *[-+]?\d+ *")


def _have_numbers(line: bytes, columns: tuple[slice, ...], number: re.Pattern[bytes]) -> bool:
    """Return whether all these columns of a line are there and hold numbers."""
    return all(len(line) >= column.stop and number.fullmatch(line[column]) for column in columns)


def _check_memory(reader: vtkAlgorithm) -> None:
    """Readers of grids ask for as many points as a header says."""
    if not hasattr(os, "sysconf"):
        return
    information = reader.GetOutputInformation(0)
    extent_key = vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()
    if not information.Has(extent_key):
        return
    extent = information.Get(extent_key)
    size = 1
    for low, high in zip(extent[::2], extent[1::2]):
        size *= max(0, high - low + 1)
    scalars = vtkDataObject.GetActiveFieldInformation(
        information, vtkDataObject.FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes.SCALARS
    )
    if scalars is not None and scalars.Has(vtkDataObject.FIELD_ARRAY_TYPE()):
        kind = scalars.Get(vtkDataObject.FIELD_ARRAY_TYPE())
        size *= vtkAbstractArray.GetDataTypeSize(kind)
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    if size > memory:
        raise _Damaged(
            f"its header asks for {size / 2**30:.1f} GiB, and this machine has "
            f"{memory / 2**30:.1f} GiB"
        )


# The readers --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Reader:
    """A kind of file: its endings and the class that reads it.

    `check` is done before reading. A reader that must not see a file as it is gets what `tidied`
    returns.
    """

    endings: tuple[str, ...]
    make: Callable[[], vtkAlgorithm]
    check: Callable[[Path], None] | None = None
    tidied: Callable[[Path], bytes] | None = None


READERS = (
    Reader((".vtp",), vtkXMLPolyDataReader),
    Reader((".vtu",), vtkXMLUnstructuredGridReader),
    Reader((".vti",), vtkXMLImageDataReader),
    Reader((".vts",), vtkXMLStructuredGridReader),
    Reader((".vtr",), vtkXMLRectilinearGridReader),
    Reader((".vtm",), vtkXMLMultiBlockDataReader),
    Reader((".vtk",), vtkGenericDataObjectReader),
    Reader((".ply",), vtkPLYReader, _check_ply),
    Reader((".stl",), vtkSTLReader, _check_stl),
    Reader((".obj",), vtkOBJReader),
    Reader((".glb", ".gltf"), vtkGLTFReader),
    Reader((".pdb",), vtkPDBReader, tidied=_tidied_pdb),
    Reader((".nii", ".nii.gz"), vtkNIFTIImageReader),
    Reader((".mha", ".mhd"), vtkMetaImageReader),
)

_SAID_AS_WARNINGS = ("Error reading", "Invalid line")
"""First words of the warnings of VTK's legacy readers about a file that ends early."""

ENDINGS = tuple(ending for reader in READERS for ending in reader.endings)


def reader_for(path: Path) -> Reader | None:
    """Return the row for a file name, or None when its ending is not known."""
    name = path.name.lower()
    for reader in READERS:
        if name.endswith(reader.endings):
            return reader
    return None


def stem(path: Path) -> str:
    """Return the file name without its ending, be it of two parts."""
    row = reader_for(path)
    for ending in sorted(row.endings if row else (), key=len, reverse=True):
        if path.name.lower().endswith(ending):
            return path.name[: -len(ending)]
    return path.stem


def is_molecule(path: Path) -> bool:
    """Return whether the points of a file are atoms with a radius."""
    row = reader_for(path)
    return row is not None and row.make is vtkPDBReader


def up_axis(path: Path) -> str:
    """Return which axis points up in a kind of file: y by glTF's specification and OBJ's habit."""
    row = reader_for(path)
    return "y" if row is not None and row.make in (vtkGLTFReader, vtkOBJReader) else "z"


def readable(path: Path) -> None:
    """Raise `UsageError` unless `path` is a file with something in it that may be read."""
    if not path.exists():
        raise UsageError(f"{path}: no such file")
    if path.is_dir():
        raise UsageError(f"{path}: is a directory")
    if not os.access(path, os.R_OK):
        raise UsageError(f"{path}: permission denied")
    if path.is_file() and path.stat().st_size == 0:
        raise UsageError(f"{path}: the file is empty")


def _merged(data: object, path: Path) -> vtkDataSet:
    """Return a composite data set as the surface of all its blocks."""
    if isinstance(data, vtkCompositeDataSet):
        surface = vtkCompositeDataGeometryFilter()
        surface.SetInputDataObject(data)
        surface.Update()
        return surface.GetOutput()
    if not isinstance(data, vtkDataSet):
        kind = data.GetClassName() if data is not None else "nothing"
        raise UsageError(f"{path}: holds {kind}, which has no surface")
    return data


def _set_file_name(reader: vtkAlgorithm, path: Path) -> None:
    reader.SetFileName(os.fspath(path))
    if isinstance(reader, vtkGenericDataObjectReader):
        reader.ReadAllScalarsOn()
        reader.ReadAllVectorsOn()
        reader.ReadAllNormalsOn()
        reader.ReadAllColorScalarsOn()
        reader.ReadAllFieldsOn()


@contextlib.contextmanager
def _for_reader(row: Reader, path: Path) -> Iterator[Path]:
    """Give the file that a row's reader may read: the file itself, or a tidied copy."""
    if row.tidied is None:
        yield path
        return
    with tempfile.TemporaryDirectory() as directory:
        copy = Path(directory) / path.name
        copy.write_bytes(row.tidied(path))
        yield copy


def _nothing_to_show(path: Path, reason: str) -> UsageError:
    return UsageError(f"{path}: the file has nothing to show, {reason}")


def _read_with(
    reader: vtkAlgorithm, source: Path, path: Path, said: messages.Messages
) -> vtkDataSet:
    """Return what a reader finds in `source`; what it reports is the error."""
    _set_file_name(reader, source)
    reader.UpdateInformation()
    if not said.errors:
        _check_memory(reader)
        with working.watching(reader):
            reader.Update()
    said.promote(_SAID_AS_WARNINGS)
    data = None
    if not said.errors and not reader.GetErrorCode():
        data = _merged(reader.GetOutputDataObject(0), path)
    if data is None or said.errors:
        # The pipeline's words, which follow the reader's, give no reason.
        own = [text for text in said.errors if not text.startswith("Algorithm vtk")]
        said.errors = own or ["its reader gave no reason"]
        raise _Damaged(said.first_error().replace(str(source), str(path)))
    return data


def read(path: str | os.PathLike[str]) -> vtkDataSet:
    """Return what is in a data file; every way in which that fails is a `UsageError`.

    Files of several blocks become one surface.
    """
    path = Path(path)
    readable(path)
    row = reader_for(path)
    if row is None:
        raise UsageError(
            f"{path}: unknown kind of file '{path.suffix or path.name}'; "
            f"known: {' '.join(ENDINGS)} and .json scenes"
        )
    try:
        if row.check is not None:
            row.check(path)
        with messages.capture() as said, _for_reader(row, path) as source:
            data = _read_with(row.make(), source, path, said)
    except _Damaged as error:
        raise UsageError(f"{path}: cannot be read: {error}") from None
    except UsageError:
        raise
    except (ValueError, OSError) as error:
        raise UsageError(f"{path}: cannot be read: {error}") from None
    if data.GetNumberOfPoints() == 0:
        raise _nothing_to_show(path, "it holds no points")
    if not isinstance(data, (vtkImageData, vtkPolyData)) and data.GetNumberOfCells() == 0:
        raise _nothing_to_show(path, "it holds no cells")
    return data


# Images -------------------------------------------------------------------------------------------


def _image_reader(path: Path) -> vtkAlgorithm:
    """Return the reader for an image: this project's for .exr, else the one of VTK's that knows it.

    VTK's are asked by the file's beginning, and .hdr files by their name: others begin alike.
    """
    ending = path.suffix.lower()
    if ending == ".exr":
        return wrapped.get("vtkOpenEXRReader")()
    if ending == ".hdr":
        return vtkHDRReader()
    reader = vtkImageReader2Factory.CreateImageReader2(os.fspath(path))
    if reader is None:
        raise UsageError(f"{path}: is not an image that VTK reads")
    return reader


def read_image(path: str | os.PathLike[str]) -> vtkImageData:
    """Return the picture in an image file, bottom row first, with the values of the file.

    Every way in which that fails is a `UsageError`, but that of an .exr file where OpenEXR was not
    built, which is an `ImportError`.
    """
    path = Path(path)
    readable(path)
    try:
        with messages.capture() as said:
            reader = _image_reader(path)
            image = _read_with(reader, path, path, said)
    except _Damaged as error:
        raise UsageError(f"{path}: cannot be read: {error}") from None
    width, height, slices = image.GetDimensions()
    if slices != 1 or width * height == 0 or image.GetPointData().GetScalars() is None:
        raise UsageError(f"{path}: is not a picture, it has {width} x {height} x {slices} pixels")
    return image
