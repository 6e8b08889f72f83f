# SPDX-License-Identifier: BSD-3-Clause
"""Reads data files. One row of `READERS` is one kind of file."""

from __future__ import annotations

import contextlib
import gzip
import math
import os
import re
import struct
import tempfile
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataSet,
    vtkImageData,
    vtkPointSet,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter
from vtkmodules.vtkIOChemistry import vtkPDBReader
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader
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

from vtkindirect import messages
from vtkindirect.errors import UsageError


class _Truncated(Exception):
    """The file ends before its own header says it should."""


class _Empty(Exception):
    """The file is as it should be, with nothing in it."""


# Readers that take a file that ends early without a word get a check of their own. ----------------


def _complete_stl(path: Path) -> None:
    """A binary STL file says how many triangles of 50 bytes follow its 84 byte header."""
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(84)
        file.seek(max(0, size - 256))
        tail = file.read().strip()
    if header.lstrip().startswith(b"solid") and b"\0" not in header:
        if not tail.rsplit(b"\n", 1)[-1].lstrip().lower().startswith(b"endsolid"):
            raise _Truncated("its last line is not 'endsolid'")
        return
    if len(header) < 84:
        raise _Truncated("it is shorter than a header")
    (triangles,) = struct.unpack("<I", header[80:84])
    if triangles == 0:
        if size == 84:
            raise _Empty("it holds no triangles")
        raise _Truncated("its header says that it has no triangles, and there are more bytes")
    if size < 84 + 50 * triangles:
        raise _Truncated(f"it has room for {(size - 84) // 50} of {triangles} triangles")


def _complete_gltf(path: Path) -> None:
    """A binary glTF file says its own length."""
    with path.open("rb") as file:
        header = file.read(12)
    if header[:4] == b"glTF":
        if len(header) < 12:
            raise _Truncated("it is shorter than a header")
        (length,) = struct.unpack("<I", header[8:12])
        if path.stat().st_size < length:
            raise _Truncated(f"it has {path.stat().st_size} of {length} bytes")


def _complete_nifti(path: Path) -> None:
    """A NIfTI file says its dimensions, the bits of a voxel and where the voxels begin."""
    opener = gzip.open if path.name.lower().endswith(".gz") else open
    try:
        with opener(path, "rb") as file:
            header = file.read(352)
            order = "<" if header[:4] == struct.pack("<i", 348) else ">"
            if len(header) < 352 or struct.unpack(order + "i", header[:4])[0] != 348:
                raise _Truncated("it does not begin with a NIfTI-1 header")
            dimensions = struct.unpack(order + "8h", header[40:56])
            (bits,) = struct.unpack(order + "h", header[72:74])
            (offset,) = struct.unpack(order + "f", header[108:112])
            voxels = math.prod(dimensions[1 : 1 + max(0, min(7, dimensions[0]))])
            if header[344:347] != b"n+1":
                return
            missing = int(offset) + voxels * bits // 8 - len(header)
            while missing > 0:
                block = file.read(min(missing, 1 << 22))
                if not block:
                    raise _Truncated(f"{missing} bytes are missing at the end")
                missing -= len(block)
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise _Truncated(str(error)) from None


def _complete_meta_image(path: Path) -> None:
    """A MetaImage header says the dimensions and the element type of what follows."""
    sizes = {"CHAR": 1, "SHORT": 2, "INT": 4, "LONG": 4, "LONG_LONG": 8, "FLOAT": 4, "DOUBLE": 8}
    header: dict[str, str] = {}
    with path.open("rb") as file:
        for line in iter(lambda: file.readline(4096), b""):
            key, _, value = line.decode("latin-1").partition("=")
            header[key.strip()] = value.strip()
            if key.strip() == "ElementDataFile":
                break
        else:
            raise _Truncated("its header has no 'ElementDataFile'")
        start = file.tell()
    name = header["ElementDataFile"]
    if name.startswith("LIST") or "%" in name:
        return
    data = path if name == "LOCAL" else path.with_name(name)
    if not data.is_file():
        raise _Truncated(f"its data file '{name}' is missing")
    if header.get("CompressedData", "False").lower() == "true":
        expected = int(header.get("CompressedDataSize", "0") or 0)
    else:
        kind = header.get("ElementType", "").removeprefix("MET_").removeprefix("U")
        kind = kind.removesuffix("_ARRAY")
        channels = int(header.get("ElementNumberOfChannels", "1"))
        expected = math.prod(int(n) for n in header.get("DimSize", "0").split())
        expected *= sizes.get(kind, 0) * channels
    there = data.stat().st_size - (start if name == "LOCAL" else 0)
    if there < expected:
        raise _Truncated(f"it holds {there} of {expected} bytes of voxels")


def _complete_ply(path: Path) -> None:
    """A PLY header says how many elements follow; the shortest possible ones must fit."""
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
            raise _Truncated("its header has no end")
        if not binary:
            wanted = sum(count for _, count, _ in elements)
            lines = sum(1 for line in file if line.strip())
            if lines < wanted:
                raise _Truncated(f"it has {lines} of {wanted} lines of elements")
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
        raise _Truncated(f"it holds {there} of at least {expected} bytes of elements")


def _complete_xml(path: Path) -> None:
    """VTK's XML readers are content when the data is there; the closing tag must be there too."""
    size = path.stat().st_size
    with path.open("rb") as file:
        file.seek(max(0, size - 256))
        if b"</VTKFile>" not in file.read():
            raise _Truncated("it does not end in </VTKFile>")


def _has_xml_points(path: Path) -> bool:
    """Whether a piece of a VTK XML file says that it has points; readers fail without any."""
    numbers = re.findall(rb"<Piece\b[^>]*\bNumberOfPoints\s*=\s*[\"'](\d+)", path.read_bytes())
    return not numbers or any(int(number) for number in numbers)


def _complete_obj(path: Path) -> None:
    """Something in an OBJ file must use its vertices."""
    with path.open("rb") as file:
        if not any(line.lstrip()[:2] in (b"f ", b"l ", b"p ", b"f\t", b"l\t") for line in file):
            raise _Truncated("it has no faces, lines or points")


def _complete_pdb(path: Path) -> None:
    """An entry of the Protein Data Bank begins with HEADER and ends with END; atoms have places."""
    content = path.read_bytes()
    if b"\0" in content:
        raise _Truncated("it is not text")
    lines = content.splitlines()
    for number, line in enumerate(lines, 1):
        if line.split()[:1] in _ATOMS and not _have_numbers(line, _POSITION, _DECIMAL):
            raise _Truncated(f"line {number} is an atom without position")
    last = next((line for line in reversed(lines) if line.strip()), b"")
    if content[:6] == b"HEADER" and last.split()[:1] not in ([b"END"], [b"ENDMDL"]):
        raise _Truncated("its last line is not END")


def _tidied_pdb(path: Path) -> bytes:
    """Return the text without what VTK's reader may stop the whole program for, by its version.

    That is blank lines, carriage returns, what is not ASCII, and residues without a number.
    """
    tidied = []
    for line in path.read_text("utf-8", "replace").encode("ascii", "replace").splitlines():
        record = line.split()[:1]
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
_DECIMAL = re.compile(rb" *[-+]?(\d+\.?\d*|\.\d+) *")
_INTEGER = re.compile(rb" *[-+]?\d+ *")


def _have_numbers(line: bytes, columns: tuple[slice, ...], number: re.Pattern[bytes]) -> bool:
    """Whether all these columns of a line are there and hold numbers."""
    return all(len(line) >= column.stop and number.fullmatch(line[column]) for column in columns)


def _amount(held: vtkDataSet) -> tuple[int, int]:
    """Return how many numbers a data set holds and the bytes that they take at least."""
    arrays = [
        attributes.GetArray(index)
        for attributes in (held.GetPointData(), held.GetCellData())
        for index in range(attributes.GetNumberOfArrays())
    ]
    if isinstance(held, vtkPointSet) and held.GetPoints() is not None:
        arrays.append(held.GetPoints().GetData())
    found = [array for array in arrays if array is not None]
    numbers = sum(array.GetNumberOfValues() for array in found)
    size = sum(array.GetNumberOfValues() * array.GetDataTypeSize() for array in found)
    cells: list[vtkCellArray] = []
    if isinstance(held, vtkPolyData):
        cells = [held.GetVerts(), held.GetLines(), held.GetPolys(), held.GetStrips()]
    elif isinstance(held, vtkUnstructuredGrid) and held.GetCells() is not None:
        cells = [held.GetCells()]
    connections = sum(cell.GetNumberOfConnectivityIds() + cell.GetNumberOfCells() for cell in cells)
    return numbers + connections, size + 4 * connections


def _complete_legacy(path: Path, held: vtkDataSet) -> None:
    """VTK's legacy reader makes up what is missing; the file must hold what came out of it."""
    content = path.read_bytes()
    numbers, size = _amount(held)
    if content.split(b"\n", 3)[2:3] == [b"BINARY"]:
        there, wanted, what = len(content), size, "bytes"
    else:
        there, wanted, what = len(_NUMBER.findall(content)), numbers, "numbers"
    if there < wanted:
        raise _Truncated(f"it holds {there} of {wanted} {what}")


_NUMBER = re.compile(rb"(?<!\S)[-+.0-9n]")

# The readers --------------------------------------------------------------------------------------


def _unchecked(_path: Path, _held: vtkDataSet | None = None) -> None:
    """Readers that report a file that ends early need no check."""


@dataclass(frozen=True)
class Reader:
    """A kind of file: its endings, the class that reads it, and checks that it is complete.

    `check` is done before reading and `check_after` with what was read. A reader that only warns
    about a file that ends early has the words of that warning. One that must not see a file as it
    is gets what `tidied` returns.
    """

    endings: tuple[str, ...]
    make: Callable[[], vtkAlgorithm]
    check: Callable[[Path], None] = _unchecked
    check_after: Callable[[Path, vtkDataSet], None] = _unchecked
    fatal_warnings: tuple[str, ...] = ()
    tidied: Callable[[Path], bytes] | None = None


READERS = (
    Reader((".vtp",), vtkXMLPolyDataReader, _complete_xml),
    Reader((".vtu",), vtkXMLUnstructuredGridReader, _complete_xml),
    Reader((".vti",), vtkXMLImageDataReader, _complete_xml),
    Reader((".vts",), vtkXMLStructuredGridReader, _complete_xml),
    Reader((".vtr",), vtkXMLRectilinearGridReader, _complete_xml),
    Reader((".vtm",), vtkXMLMultiBlockDataReader, _complete_xml),
    Reader(
        (".vtk",),
        vtkGenericDataObjectReader,
        check_after=_complete_legacy,
        fatal_warnings=("Error reading", "Invalid line"),
    ),
    Reader((".ply",), vtkPLYReader, _complete_ply),
    Reader((".stl",), vtkSTLReader, _complete_stl),
    Reader((".obj",), vtkOBJReader, _complete_obj),
    Reader((".glb", ".gltf"), vtkGLTFReader, _complete_gltf),
    Reader((".pdb",), vtkPDBReader, _complete_pdb, tidied=_tidied_pdb),
    Reader((".nii", ".nii.gz"), vtkNIFTIImageReader, _complete_nifti),
    Reader((".mha", ".mhd"), vtkMetaImageReader, _complete_meta_image),
)

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
    """Whether the points of a file are atoms with a radius."""
    row = reader_for(path)
    return row is not None and row.make is vtkPDBReader


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
        row.check(path)
    except _Empty as reason:
        raise _nothing_to_show(path, str(reason)) from None
    except _Truncated as error:
        raise UsageError(f"{path}: the file is damaged or cut off: {error}") from None
    except (ValueError, OSError) as error:
        raise UsageError(f"{path}: the file is damaged: {error}") from None
    with messages.capture() as said, _for_reader(row, path) as source:
        reader = row.make()
        _set_file_name(reader, source)
        reader.Update()
        said.promote(row.fatal_warnings)
        failed = bool(said.errors) or bool(reader.GetErrorCode())
        data = None if failed else _merged(reader.GetOutputDataObject(0), path)
    if failed or said.errors:
        if row.check is _complete_xml and not _has_xml_points(path):
            raise _nothing_to_show(path, "it holds no points")
        reason = said.first_error() or "its reader gave no reason"
        raise UsageError(f"{path}: cannot be read, the file is damaged or cut off: {reason}")
    try:
        row.check_after(path, data)
    except _Truncated as error:
        raise UsageError(f"{path}: the file is damaged or cut off: {error}") from None
    if data.GetNumberOfPoints() == 0:
        raise _nothing_to_show(path, "it holds no points")
    if not isinstance(data, (vtkImageData, vtkPolyData)) and data.GetNumberOfCells() == 0:
        raise _nothing_to_show(path, "it holds no cells")
    return data
