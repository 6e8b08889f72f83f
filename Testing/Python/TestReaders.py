# SPDX-License-Identifier: BSD-3-Clause
"""Data files: each kind is read, and one that is damaged or cut off is refused with one line."""

import base64
import contextlib
import gzip
import json
import multiprocessing
import os
import resource
import struct
import sys
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkRectilinearGrid,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLRectilinearGridWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)

import support
from vtkindirect import UsageError, data, load_scene


def _sphere():
    source = vtkSphereSource()
    source.Update()
    return source.GetOutput()


def _image():
    source = vtkRTAnalyticSource()
    source.Update()
    return source.GetOutput()


def _unstructured():
    append = vtkAppendFilter()
    append.AddInputData(_sphere())
    append.Update()
    return append.GetOutput()


def _structured():
    points = vtkPoints()
    for k in (0, 1):
        for j in (0, 1):
            for i in (0, 1):
                points.InsertNextPoint(i, j, k)
    grid = vtkStructuredGrid()
    grid.SetDimensions(2, 2, 2)
    grid.SetPoints(points)
    return grid


def _rectilinear():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(2, 2, 2)
    for setter in (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates):
        axis = vtkDoubleArray()
        axis.InsertNextValue(0)
        axis.InsertNextValue(1)
        setter(axis)
    return grid


def _blocks():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, _sphere())
    return blocks


def _gltf(binary: bool) -> bytes:
    """Return two triangles as glTF."""
    points = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)
    blob = points + struct.pack("<6H", 0, 1, 2, 1, 3, 2)
    attributes = {"attributes": {"POSITION": 0}, "indices": 1}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [attributes]}],
        "buffers": [{"byteLength": len(blob)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 12},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [0, 0, 0],
                "max": [1, 1, 0],
            },
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
    }
    if not binary:
        coded = base64.b64encode(blob).decode()
        document["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{coded}"
        return json.dumps(document).encode()
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(blob)
    head = struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob


def _obj() -> str:
    sphere = _sphere()
    lines = ["v %g %g %g" % sphere.GetPoint(i) for i in range(sphere.GetNumberOfPoints())]
    for index in range(sphere.GetNumberOfCells()):
        cell = sphere.GetCell(index)
        lines.append("f " + " ".join(str(cell.GetPointId(k) + 1) for k in range(3)))
    return "\n".join(lines) + "\n"


# File name, how it is written, what is written, number of points that are read.
WRITTEN = [
    ("a.vtp", vtkXMLPolyDataWriter, _sphere, 50),
    ("ascii.vtp", vtkXMLPolyDataWriter, _sphere, 50),
    ("a.vtu", vtkXMLUnstructuredGridWriter, _unstructured, 50),
    ("a.vti", vtkXMLImageDataWriter, _image, 9261),
    ("a.vts", vtkXMLStructuredGridWriter, _structured, 8),
    ("a.vtr", vtkXMLRectilinearGridWriter, _rectilinear, 8),
    ("a.vtm", vtkXMLMultiBlockDataWriter, _blocks, 50),
    ("a.vtk", vtkPolyDataWriter, _sphere, 50),
    ("binary.vtk", vtkPolyDataWriter, _sphere, 50),
    ("a.ply", vtkPLYWriter, _sphere, 50),
    ("ascii.ply", vtkPLYWriter, _sphere, 50),
    ("a.stl", vtkSTLWriter, _sphere, 50),
    ("binary.stl", vtkSTLWriter, _sphere, 50),
    ("a.nii", vtkNIFTIImageWriter, _image, 9261),
    ("a.nii.gz", vtkNIFTIImageWriter, _image, 9261),
    ("a.mha", vtkMetaImageWriter, _image, 9261),
    ("a.mhd", vtkMetaImageWriter, _image, 9261),
]


def write_all(directory: Path) -> dict[str, int]:
    """Write a file of each kind; returns how many points each holds."""
    expected = {}
    for name, writer_class, make, points in WRITTEN:
        writer = writer_class()
        writer.SetFileName(str(directory / name))
        writer.SetInputData(make())
        if name == "ascii.vtp":
            writer.SetDataModeToAscii()
        elif name == "ascii.ply":
            writer.SetFileTypeToASCII()
        elif name.startswith("binary"):
            writer.SetFileTypeToBinary()
        writer.Write()
        expected[name] = points
    (directory / "a.obj").write_text(_obj())
    (directory / "a.glb").write_bytes(_gltf(True))
    (directory / "a.gltf").write_bytes(_gltf(False))
    (directory / "a.pdb").write_bytes((support.DATA / "protein_1tii.pdb").read_bytes())
    expected.update({"a.obj": 50, "a.glb": 4, "a.gltf": 4, "a.pdb": 5684})
    return expected



def read_alone(path: Path) -> None:
    """Read a file with VTK's reader and nothing else."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # A reader that does not return ends here. Files of some kilobytes take milliseconds of a processor, and
    # however long they wait for one does not count.
    resource.setrlimit(resource.RLIMIT_CPU, (3, 3))
    sys.stderr = sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    for number in (1, 2):
        os.dup2(sys.stdout.fileno(), number)
    reader = data.reader_for(path).make()
    data._set_file_name(reader, path)
    reader.Update()


# The readers of these files take the content that is there of a file that ends early; the first two
# may still be complete.
CONTENT = ("a.vts", "a.vtr", "a.obj", "a.mha", "a.mhd", "a.pdb")

ATOM = "ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00  0.00           N\n"


class Readers(support.DirectoryTest):
    def assert_refused(self, path: Path, expected: str = "", how=data.read) -> None:
        with self.assertRaises(UsageError) as caught:
            how(path)
        text = str(caught.exception)
        self.assertTrue(text.startswith(f"{path}: "), text)
        self.assertIn(expected, text)
        self.assertNotIn("\n", text)

    def test_every_kind_is_read(self) -> None:
        expected = write_all(self.directory)
        endings = {ending for ending in data.ENDINGS if any(n.endswith(ending) for n in expected)}
        self.assertEqual(endings, set(data.ENDINGS))
        for name, points in expected.items():
            with self.subTest(name=name):
                self.assertEqual(data.read(self.directory / name).GetNumberOfPoints(), points)

    def test_files_that_end_early(self) -> None:
        """A report of VTK's reader is one line; some readers are content with the data that are there."""
        for name in write_all(self.directory):
            whole = (self.directory / name).read_bytes()
            for part in (0.02, 0.3, 0.6, 0.9, 0.98):
                with self.subTest(name=name, part=part):
                    cut = self.write("cut_" + name, whole[: int(part * len(whole))])
                    if name in CONTENT:
                        with contextlib.suppress(UsageError):
                            self.assertGreater(data.read(cut).GetNumberOfPoints(), 0)
                    else:
                        self.assert_refused(cut, "cannot be read: ")

    def test_other_content_is_refused(self) -> None:
        for ending in data.ENDINGS:
            for content in (b"hello\n", bytes(range(256)) * 8, b"\0" * 1000):
                with self.subTest(ending=ending, content=content[:5]):
                    self.assert_refused(self.write("other" + ending, content), how=load_scene)

    def test_damaged_compression(self) -> None:
        whole = bytearray(gzip.compress(b"\0" * 5000))
        whole[20:30] = b"0123456789"
        self.assert_refused(self.write("bad.nii.gz", bytes(whole)), "Bad NIfTI header")

    def test_molecules_as_programs_write_them(self) -> None:
        for name, text in {
            "plain": ATOM * 2,
            "no end of line": ATOM + ATOM.rstrip(),
            "carriage returns": (ATOM * 2).replace("\n", "\r\n"),
            "blank lines": f"\n{ATOM}   \n{ATOM}\n\n",
            "not ASCII": f"REMARK \N{LATIN SMALL LETTER A WITH DIAERESIS}\n" + ATOM * 2,
            "no number": ATOM + ATOM.replace("A   1", "A****"),
            "zeros": "\0\0\n" + ATOM * 2,
            "long lines": 2 * (ATOM.rstrip().ljust(81) + "ATOM\n"),
            "blanks in them": 2 * (ATOM.rstrip().ljust(200) + "x\n"),
            "structures": ATOM + "HELIX    1   A SER A    4\nSHEET\n" + ATOM,
        }.items():
            with self.subTest(name=name):
                read = data.read(self.write("a.pdb", text.encode()))
                self.assertEqual(read.GetNumberOfPoints(), 2)
                self.assertAlmostEqual(read.GetPoint(1)[1], 6.134, places=5)
        lost = self.write("a.pdb", b"atom\n" + ATOM.encode())
        self.assert_refused(lost, "line 1 is an atom without position")
        latin = self.write("a.pdb", (ATOM + "REMARK \xe4\n" + ATOM).encode("latin-1"))
        self.assertEqual(data.read(latin).GetNumberOfPoints(), 2)

    def test_atoms_without_position(self) -> None:
        for damaged in (
            ATOM.replace(" 6.134", " x.134"),
            ATOM.replace("  -6.504", "        "),
            ATOM.replace(" 6.134", "1.1e99"),
            ATOM[:50] + "\n",
        ):
            with self.subTest(damaged=damaged):
                path = self.write("a.pdb", (ATOM + damaged + ATOM).encode())
                self.assert_refused(path, "line 2 is an atom without position")

    def damaged(self) -> dict[str, Path]:
        """Write files that readers end or stall the program for; gives them by what is wrong."""
        write_all(self.directory)
        binary, text = ((self.directory / name).read_bytes() for name in ("a.ply", "ascii.ply"))
        header = "ObjectType = Image\nNDims = 3\nDimSize = 90000 90000 90000\n"
        dimensions = struct.pack("<8h", 3, 30000, 30000, 30000, 1, 1, 1, 1)
        nifti = (self.directory / "a.nii").read_bytes()
        image = (self.directory / "a.vti").read_bytes()
        found = {
            "cut.ply": binary[: len(binary) // 2],
            "cut_text.ply": text[: len(text) // 2],
            "negative.ply": text.replace(b"vertex 50", b"vertex -5"),
            "many.ply": text.replace(b"vertex 50", b"vertex 500000000"),
            "many.stl": b"many".ljust(80) + struct.pack("<I", 2**31 - 1) + bytes(100),
            "large.mha": header + "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n",
            "large.nii": nifti[:40] + dimensions + nifti[56:],
            "large.vti": image.replace(b"-10 10 -10 10 -10 10", b"0 90000 0 90000 0 90000"),
        }
        return {name: self.write(name, content) for name, content in found.items()}

    def test_what_would_end_the_program_is_refused(self) -> None:
        for name, path in self.damaged().items():
            with self.subTest(name=name):
                self.assert_refused(path, "cannot be read: ")

    def test_these_do_end_the_program(self) -> None:
        """Each check before reading is there because VTK's reader alone dies or does not return."""
        for name, path in self.damaged().items():
            with self.subTest(name=name):
                # A copy of this process, which has VTK already.
                process = multiprocessing.get_context("fork").Process(
                    target=read_alone, args=(path,)
                )
                process.start()
                process.join()
                if process.exitcode >= 0:
                    self.skipTest("the reader of this version of VTK, on this system, survives")

    def test_paths(self) -> None:
        self.assert_refused(self.directory / "none.vtp", "no such file")
        self.assert_refused(self.directory, "is a directory")
        self.assert_refused(self.write("empty.vtp", b""), "the file is empty")
        self.assert_refused(self.write("a.doc", b"x"), "unknown kind of file '.doc'; known: .vtp")
        self.assert_refused(self.write("no_ending", b"x"), "unknown kind of file 'no_ending'")

    def test_names_of_two_parts(self) -> None:
        self.assertEqual(data.stem(Path("brain.nii.gz")), "brain")
        self.assertEqual(data.stem(Path("Room.1.VTP")), "Room.1")


class Empty(support.DirectoryTest):
    """A file as it should be, with nothing in it, is one line as well."""

    def assert_nothing(self, path: Path, what: str) -> None:
        with self.assertRaises(UsageError) as caught:
            load_scene(path)
        text = str(caught.exception)
        self.assertRegex(text, f"{path.name}: .*{what}")
        self.assertNotIn("\n", text)

    def written(self, writer, held, name: str) -> Path:
        path = self.directory / name
        writer.SetInputData(held)
        writer.SetFileName(str(path))
        writer.Write()
        return path

    def test_no_points(self) -> None:
        for writer, held, ending in (
            (vtkXMLPolyDataWriter(), vtkPolyData(), "vtp"),
            (vtkXMLUnstructuredGridWriter(), vtkUnstructuredGrid(), "vtu"),
            (vtkXMLImageDataWriter(), vtkImageData(), "vti"),
            (vtkXMLStructuredGridWriter(), vtkStructuredGrid(), "vts"),
            (vtkXMLRectilinearGridWriter(), vtkRectilinearGrid(), "vtr"),
            (vtkPolyDataWriter(), vtkPolyData(), "vtk"),
        ):
            with self.subTest(ending=ending):
                self.assert_nothing(self.written(writer, held, f"none.{ending}"), "[Nn]o [Pp]oints")

    def test_no_cells(self) -> None:
        points = vtkPoints()
        for corner in ((0, 0, 0), (1, 0, 0), (0, 1, 0)):
            points.InsertNextPoint(corner)
        for writer, held, ending, what in (
            (vtkXMLPolyDataWriter(), vtkPolyData(), "vtp", "points but no cells"),
            (vtkXMLUnstructuredGridWriter(), vtkUnstructuredGrid(), "vtu", "no cells"),
            (vtkPLYWriter(), vtkPolyData(), "ply", "points but no cells"),
        ):
            held.SetPoints(points)
            with self.subTest(ending=ending):
                self.assert_nothing(self.written(writer, held, f"points.{ending}"), what)

    def test_no_triangles(self) -> None:
        header = b"a solid without triangles".ljust(80) + bytes(4)
        self.assert_nothing(self.write("none.stl", header), "(cannot be read|it holds no points)")
        self.assert_nothing(self.write("some.stl", header + bytes(50)), "points but no cells")

    def test_missing_points_are_damage(self) -> None:
        path = self.written(vtkXMLPolyDataWriter(), vtkPolyData(), "lost.vtp")
        text = path.read_text().replace('NumberOfPoints="0"', 'NumberOfPoints="3"')
        with self.assertRaisesRegex(UsageError, "cannot be read: "):
            load_scene(self.write("lost.vtp", text))


class DataAsScene(support.DirectoryTest):
    """A data file alone is a scene."""

    def test_surfaces(self) -> None:
        scene = load_scene(support.DATA / "room_vis.vtp")
        self.assertEqual(scene.name, "room_vis")
        self.assertEqual(len(scene.lights), 5)
        self.assertEqual(scene.notes, [])  # the file has colours of its own
        self.assertTrue(scene.actors["room_vis"].GetMapper().GetScalarVisibility())

    def test_reports_call_it_by_its_file(self) -> None:
        from vtkindirect import wrapped

        (actor,) = load_scene(support.DATA / "room_vis.vtp").actors.values()
        key = wrapped.get("vtkIndirectIlluminationPass").NAME()
        self.assertEqual(actor.GetPropertyKeys().Get(key), "room_vis.vtp")

    def test_images_are_contoured(self) -> None:
        scene = load_scene(support.DATA / "brain_mri_colin27_ch2bet.nii.gz")
        self.assertEqual(scene.name, "brain_mri_colin27_ch2bet")
        self.assertIn("contour of 'NIFTI' at 66.5", scene.notes[0])

    def test_molecules_are_spheres(self) -> None:
        scene = load_scene(support.DATA / "protein_1tii.pdb")
        shown = scene.actors["protein_1tii"].GetMapper().GetInput()
        self.assertGreater(shown.GetNumberOfCells(), 100_000)

    def test_nothing_to_show(self) -> None:
        head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
        points = self.write("points.vtk", head + "0 0 0 1 0 0\n")
        with self.assertRaisesRegex(UsageError, r"points\.vtk: .* holds points but no cells"):
            load_scene(points)
        flat = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n"
        flat += "DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8\nSCALARS a float\n"
        same = self.write("same.vtk", flat + "LOOKUP_TABLE default\n" + "1 " * 8 + "\n")
        with self.assertRaisesRegex(UsageError, r"same\.vtk: array 'a' is constant"):
            load_scene(same)
