# SPDX-License-Identifier: BSD-3-Clause
"""Each source of a scene file: where it is, how large it is, which way it faces."""

import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkTriangleFilter

from vtkindirect import SceneError, schema, sources


def make(name, **values):
    part = "cylinder" if name == "ring" else name
    schema.check(values, "actors[0]", part)
    return sources.build({"source": name, **values}, "actors[0]")


def triangles(data):
    """Return the corners of all triangles."""
    split = vtkTriangleFilter()
    split.SetInputData(data)
    split.Update()
    result = split.GetOutput()
    points = vtk_to_numpy(result.GetPoints().GetData()).astype(float)
    return points[vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def areas(data):
    corners = triangles(data)
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2


def normals(data):
    return vtk_to_numpy(data.GetPointData().GetNormals())


class Sources(unittest.TestCase):
    def assert_bounds(self, data, expected, delta=1e-6):
        for got, wanted in zip(data.GetBounds(), expected):
            self.assertAlmostEqual(got, wanted, delta=delta)

    def test_plane(self):
        data = make(
            "plane", origin=[1, 2, 3], point1=[3, 2, 3], point2=[1, 5, 3], resolution=[4, 5]
        )
        self.assert_bounds(data, (1, 3, 2, 5, 3, 3))
        self.assertEqual(data.GetNumberOfCells(), 20)
        self.assertTrue(np.allclose(areas(data).sum(axis=0), (0, 0, 6)))
        self.assertTrue(np.allclose(normals(data), (0, 0, 1)))

    def test_box(self):
        data = make("box", bounds=[-1, 2, 0, 1, 5, 7])
        self.assert_bounds(data, (-1, 2, 0, 1, 5, 7))
        mass = vtkMassProperties()
        split = vtkTriangleFilter()
        split.SetInputData(data)
        mass.SetInputConnection(split.GetOutputPort())
        mass.Update()
        self.assertAlmostEqual(mass.GetVolume(), 6, places=5)
        with self.assertRaisesRegex(SceneError, r"bounds: y minimum must be less"):
            make("box", bounds=[0, 1, 1, 1, 0, 1])

    def test_sphere(self):
        data = make("sphere", center=[5, 6, 7], radius=2, resolution=64)
        distances = np.linalg.norm(triangles(data).reshape(-1, 3) - (5, 6, 7), axis=1)
        self.assertTrue(np.allclose(distances, 2, atol=1e-5))
        self.assertAlmostEqual(np.linalg.norm(areas(data), axis=1).sum(), 16 * math.pi, delta=0.3)

    def test_disk_faces_its_normal(self):
        for normal in ([0, 0, 1], [0, 0, -1], [0, 1, 0], [1, 0, 0], [1, -2, 3]):
            with self.subTest(normal=normal):
                unit = np.array(normal) / np.linalg.norm(normal)
                data = make(
                    "disk", center=[1, 2, 3], normal=normal, inner=0.5, outer=1, resolution=256
                )
                area = areas(data).sum(axis=0)
                self.assertTrue(np.allclose(area, unit * 0.75 * math.pi, atol=2e-3))
                self.assertTrue(np.allclose(normals(data), unit, atol=1e-5))
                corners = triangles(data).reshape(-1, 3) - (1, 2, 3)
                self.assertTrue(np.allclose(corners @ unit, 0, atol=1e-6))
        with self.assertRaisesRegex(SceneError, r"actors\[0\]\.inner: must be less than outer"):
            make("disk", inner=2, outer=1)

    def test_any_source_by_its_class(self):
        cone = {"vtkConeSource": {"Height": 3, "Direction": [0, 1, 0], "Resolution": 7}}
        data = sources.build({"source": cone}, "actors[0]")
        self.assert_bounds(data, (data.GetBounds()[0], data.GetBounds()[1], -1.5, 1.5))
        self.assertEqual(data.GetNumberOfCells(), 8)
        for source, expected in (
            ({"vtkConSource": {}}, "vtkConSource: VTK has no filter or source 'vtkConSource' (did"),
            ({"vtkTubeFilter": {}}, "actors[0].source.vtkTubeFilter: vtkTubeFilter is no source"),
            ({"vtkConeSource": {"Hight": 1}}, "source.vtkConeSource.Hight: vtkConeSource has no"),
        ):
            with self.subTest(source=source), self.assertRaises(SceneError) as caught:
                sources.build({"source": source}, "actors[0]")
            self.assertIn(expected, str(caught.exception))

    def test_cylinder_and_ring(self):
        for axis in ([0, 1, 0], [0, -1, 0], [1, 0, 0], [1, 1, 1]):
            with self.subTest(axis=axis):
                unit = np.array(axis) / np.linalg.norm(axis)
                shape = {"center": [3, 2, 1], "axis": axis, "radius": 0.5, "height": 4}
                closed = make("cylinder", **shape, resolution=128)
                ring = make("ring", **shape, resolution=128)
                for data, outwards in ((closed, 1), (ring, -1)):
                    from_center = triangles(data).mean(axis=1) - (3, 2, 1)
                    along = from_center @ unit
                    self.assertLessEqual(abs(along).max(), 2 + 1e-5)
                    radial = from_center - along[:, None] * unit
                    side = abs(along) < 1.99
                    facing = np.einsum("ij,ij->i", areas(data), radial)[side]
                    self.assertTrue((outwards * facing > 0).all())
                edges = vtkFeatureEdges()
                edges.SetInputData(ring)
                edges.FeatureEdgesOff()
                edges.Update()
                self.assertGreater(edges.GetOutput().GetNumberOfCells(), 0)
                wall = np.linalg.norm(areas(ring), axis=1).sum()
                self.assertAlmostEqual(wall, 2 * math.pi * 0.5 * 4, delta=0.01)
                inward = normals(ring)
                points = vtk_to_numpy(ring.GetPoints().GetData()) - (3, 2, 1)
                self.assertTrue((np.einsum("ij,ij->i", inward, points) < 0).all())
