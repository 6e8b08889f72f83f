# SPDX-License-Identifier: BSD-3-Clause
"""The exporter takes triangles, normals and colours from VTK's actors."""

from __future__ import annotations

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from vtkindirect.actors import RADIUS, show_spheres

from description import Surface
from exporter import ExportError, ball, export_actor, export_renderer, triangles


def _polygons(*cells: list[int], points: list[tuple[float, float, float]]) -> vtkPolyData:
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for point in points:
        data.GetPoints().InsertNextPoint(point)
    data.SetPolys(vtkCellArray())
    for cell in cells:
        data.GetPolys().InsertNextCell(len(cell), cell)
    return data


def _ring(count: int) -> list[tuple[float, float, float]]:
    angles = 2.0 * np.pi * np.arange(count) / count
    return [(float(np.cos(a)), float(np.sin(a)), 0.0) for a in angles]


def _square() -> vtkPolyData:
    return _polygons([0, 1, 2, 3], points=[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])


def data_points(data: vtkPolyData) -> np.ndarray:
    """Return the points of a data set."""
    return vtk_to_numpy(data.GetPoints().GetData())


def _actor(data: vtkPolyData) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def _sphere() -> vtkPolyData:
    source = vtkSphereSource()
    source.SetRadius(1.0)
    source.Update()
    return source.GetOutput()


class Spheres(unittest.TestCase):
    """Spheres of vtkOpenGLSphereMapper are fine triangles with the spheres' normals."""

    def test_ball(self) -> None:
        places, faces = ball()
        self.assertEqual((len(places), len(faces)), (642, 1280))
        corners = places[faces]
        across = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        # The mean shadow is a quarter of the surface of what is convex (Cauchy).
        self.assertAlmostEqual(np.linalg.norm(across, axis=1).sum() / 4.0, np.pi, places=12)
        outward = np.einsum("ij,ij->i", across, corners.mean(axis=1))
        self.assertGreater(outward.min(), 0.0)
        # Middles of faces are the nearest, corners the farthest.
        self.assertGreater(np.linalg.norm(corners.mean(axis=1), axis=1).min(), 0.996)
        self.assertLess(np.linalg.norm(places, axis=1).max(), 1.004)

    def test_of_a_mapper(self) -> None:
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        for point in ((1.0, 2.0, 3.0), (9.0, 9.0, 9.0), (-4.0, 0.0, 0.0)):
            data.GetPoints().InsertNextPoint(point)
        radii = numpy_to_vtk(np.array([0.5, 0.0, 2.0]), deep=True)
        radii.SetName(RADIUS)
        data.GetPointData().AddArray(radii)
        actor = show_spheres(data)
        actor.GetProperty().SetColor(0.2, 0.4, 0.6)
        surface = export_actor(actor)
        self.assertEqual(len(surface.faces), 2 * 1280)  # one has no radius
        for part, (center, radius) in enumerate((((1, 2, 3), 0.5), ((-4, 0, 0), 2.0))):
            own = slice(642 * part, 642 * (part + 1))
            found = (surface.points[own] - center) / radius
            lengths = np.linalg.norm(found, axis=1)
            self.assertLess(np.abs(lengths - 1.0).max(), 0.004)
            self.assertTrue(np.allclose(found / lengths[:, None], surface.normals[own]))
        self.assertTrue(np.allclose(surface.albedo, [0.2, 0.4, 0.6]))
        actor.SetPosition(1.0, 0.0, 0.0)
        with self.assertRaises(ExportError):
            export_actor(actor)


class Triangles(unittest.TestCase):
    def test_polygons_of_any_size(self) -> None:
        for count in range(3, 12):
            data = _polygons(list(range(count)), points=_ring(count))
            faces, cells = triangles(data)
            self.assertEqual(len(faces), count - 2)
            self.assertTrue((cells == 0).all())
            area = export_actor(_actor(data)).area
            self.assertAlmostEqual(area, 0.5 * count * np.sin(2 * np.pi / count), places=6)

    def test_quads_are_cut_where_the_mapper_cuts_them(self) -> None:
        faces, _ = triangles(_square())
        self.assertEqual(faces.tolist(), [[0, 1, 2], [0, 2, 3]])

    def test_cells_of_all_kinds_are_counted(self) -> None:
        data = _polygons([0, 1, 2], [0, 1, 2, 3], points=_ring(5))
        data.SetVerts(vtkCellArray())
        data.GetVerts().InsertNextCell(1, [0])
        data.SetStrips(vtkCellArray())
        data.GetStrips().InsertNextCell(5, [0, 1, 2, 3, 4])
        faces, cells = triangles(data)
        self.assertEqual(sorted(cells.tolist()), [1, 2, 2, 3, 3, 3])
        self.assertEqual(faces[cells == 3].tolist(), [[0, 1, 2], [1, 3, 2], [2, 3, 4]])

    def test_triangles_without_area_are_not_drawn(self) -> None:
        data = _polygons([0, 1, 2], [0, 1, 1], points=_ring(3))
        self.assertEqual(len(export_actor(_actor(data)).faces), 1)


class Normals(unittest.TestCase):
    def test_smooth(self) -> None:
        surface = export_actor(_actor(_sphere()))
        self.assertTrue(np.allclose(surface.normals, surface.points, atol=1e-6))

    def test_flat(self) -> None:
        actor = _actor(_sphere())
        actor.GetProperty().SetInterpolationToFlat()
        surface = export_actor(actor)
        for corners in surface.normals[surface.faces].transpose(1, 0, 2):
            a, b, c = (surface.points[surface.faces[:, i]] for i in range(3))
            facet = np.cross(b - a, c - a)
            facet /= np.linalg.norm(facet, axis=1, keepdims=True)
            self.assertTrue(np.allclose(corners, facet))

    def test_transformed(self) -> None:
        """Normals of a stretched sphere are those of the ellipsoid."""
        matrix = vtkMatrix4x4()
        matrix.DeepCopy([2, 0, 0, 5, 0, 1, 0, 6, 0, 0, 0.5, 7, 0, 0, 0, 1])
        actor = _actor(_sphere())
        actor.SetUserMatrix(matrix)
        surface = export_actor(actor)
        local = surface.points - [5, 6, 7]
        expected = local / np.array([2.0, 1.0, 0.5]) ** 2
        expected /= np.linalg.norm(expected, axis=1, keepdims=True)
        self.assertTrue(np.allclose(surface.normals, expected, atol=1e-6))


class Colors(unittest.TestCase):
    def test_albedo_is_diffuse_times_color(self) -> None:
        actor = _actor(_square())
        actor.GetProperty().SetColor(0.5, 0.25, 1.0)
        actor.GetProperty().SetDiffuse(0.8)
        self.assertTrue(np.allclose(export_actor(actor).albedo, [0.4, 0.2, 0.8]))

    def test_point_bytes(self) -> None:
        data = _square()
        values = np.array([[255, 0, 0], [0, 255, 0], [0, 0, 255], [51, 51, 51]], dtype=np.uint8)
        array = numpy_to_vtk(values, deep=True)
        array.SetName("RGB")
        data.GetPointData().AddArray(array)
        actor = _actor(data)
        actor.GetProperty().SetDiffuse(0.5)
        mapper = actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SelectColorArray("RGB")
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SetColorModeToDirectScalars()
        surface = export_actor(actor)
        for point, color in zip(data_points(data), 0.5 * values / 255.0):
            at = (surface.points == point).all(axis=1)
            self.assertTrue(at.any())
            self.assertTrue(np.allclose(surface.albedo[at], color))

    def test_cell_scalars_by_a_table(self) -> None:
        data = _polygons([0, 1, 2], [0, 2, 3], points=_ring(4))
        array = numpy_to_vtk(np.array([0.0, 1.0]), deep=True)
        array.SetName("t")
        data.GetCellData().AddArray(array)
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 1.0, 0.0, 0.0, 1.0)
        table.SetTableValue(1, 0.0, 0.0, 1.0, 1.0)
        table.SetTableRange(0.0, 1.0)
        actor = _actor(data)
        mapper = actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SelectColorArray("t")
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        surface = export_actor(actor)
        self.assertEqual(len(surface.points), 6)
        self.assertTrue(np.allclose(surface.albedo[surface.faces[0]], [1.0, 0.0, 0.0]))
        self.assertTrue(np.allclose(surface.albedo[surface.faces[1]], [0.0, 0.0, 1.0]))


class WhatIsLeftOut(unittest.TestCase):
    def test_glass_and_lines(self) -> None:
        cube = vtkCubeSource()
        cube.Update()
        solid, glass, hidden = (_actor(cube.GetOutput()) for _ in range(3))
        glass.GetProperty().SetOpacity(0.4)
        hidden.VisibilityOff()
        wire = vtkPolyData()
        wire.SetPoints(_square().GetPoints())
        wire.SetLines(vtkCellArray())
        wire.GetLines().InsertNextCell(2, [0, 1])
        actors = {"solid": solid, "glass": glass, "hidden": hidden, "wire": _actor(wire)}
        renderer = vtkRenderer()
        found = export_renderer(renderer, "some", (8, 8), actors.items())
        self.assertEqual(len(found.surface.faces), 12)
        self.assertEqual(
            found.left_out,
            [
                {"what": "glass", "why": "translucent"},
                {"what": "wire", "why": "has no polygons"},
            ],
        )

    def test_specular(self) -> None:
        matt, shiny = _actor(_square()), _actor(_square())
        self.assertIsNone(export_actor(matt).specular)
        prop = shiny.GetProperty()
        prop.SetSpecular(0.5)
        prop.SetSpecularColor(1.0, 0.5, 0.25)
        prop.SetSpecularPower(30.0)
        found = export_actor(shiny)
        self.assertEqual(found.specular.shape, (len(found.points), 4))
        self.assertEqual(found.specular[0].tolist(), [0.5, 0.25, 0.125, 30.0])
        joined = Surface.join([export_actor(matt), found])
        self.assertEqual(len(joined.specular), len(joined.points))
        self.assertEqual(joined.specular[0].tolist(), [0.0] * 4)
        prop.LightingOff()
        self.assertIsNone(export_actor(shiny).specular)

    def test_what_is_refused(self) -> None:
        actor = _actor(_square())
        actor.GetProperty().SetInterpolationToPBR()
        with self.assertRaisesRegex(ExportError, "physically based"):
            export_actor(actor)
        with self.assertRaisesRegex(ExportError, "nothing opaque"):
            export_renderer(vtkRenderer(), "none", (8, 8), [])
