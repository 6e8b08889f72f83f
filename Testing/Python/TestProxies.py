# SPDX-License-Identifier: BSD-3-Clause
"""Spheres and simplified meshes from Python: what they say of themselves, motion, errors, the page."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

import support
import vtkindirect
from vtkindirect import wrapped

PAGE = support.SOURCE / "Documentation" / "methods" / "sphere-proxies.md"
MEASURES = (
    "Error",
    "CoveredArea",
    "MaximumGap",
    "RootMeanSquareError",
    "MaximumProtrusion",
    "SolidVolume",
    "CoveredVolume",
    "ProtrudingVolume",
)


def ellipsoid() -> vtkPolyData:
    source = vtkSphereSource()
    source.SetThetaResolution(32)
    source.SetPhiResolution(24)
    source.Update()
    return moved(source.GetOutput(), np.diag((1.0, 2.0, 4.0)), np.zeros(3))


def moved(mesh: vtkPolyData, matrix: np.ndarray, shift: np.ndarray) -> vtkPolyData:
    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) @ matrix.T + shift
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    copy.SetPoints(points)
    return copy


def spheres_of(mesh: vtkPolyData) -> tuple[np.ndarray, np.ndarray]:
    return (
        vtk_to_numpy(mesh.GetPoints().GetData()).copy(),
        vtk_to_numpy(mesh.GetPointData().GetArray("Radius")).copy(),
    )


@unittest.skipUnless(wrapped.has("vtkSphereProxyFilter"), "vtkIndirectProxies was not built")
class Proxies(unittest.TestCase):
    def fit(self, number: int = 30) -> vtkindirect.vtkSphereProxyFilter:
        spheres = vtkindirect.vtkSphereProxyFilter()
        spheres.SetInputData(ellipsoid())
        spheres.SetNumberOfSpheres(number)
        spheres.Update()
        return spheres

    def test_measures_are_field_data_and_methods(self) -> None:
        spheres = self.fit()
        fields = spheres.GetOutput().GetFieldData()
        for name in MEASURES:
            said = getattr(spheres, f"Get{name}")()
            self.assertEqual(fields.GetArray(name).GetTuple1(0), said, name)
        # Facets of 32 by 24 take 2 % of the ellipsoid's volume of 4/3 pi 0.5 1 2.
        self.assertAlmostEqual(spheres.GetSolidVolume() / (4.0 / 3.0 * np.pi), 0.98, delta=0.02)
        # Of 30 spheres: 0.957 measured.
        self.assertGreater(spheres.GetCoveredVolume(), 0.94)
        self.assertLessEqual(spheres.GetOutput().GetNumberOfPoints(), 30)

    def test_turning_carries_them_along(self) -> None:
        spheres = self.fit()
        centers, radii = spheres_of(spheres.GetOutput())
        turn = np.array(((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
        shift = np.array((5.0, 6.0, 7.0))
        spheres.SetMovedData(moved(ellipsoid(), turn, shift))
        spheres.Update()
        places, sizes = spheres_of(spheres.GetOutput())
        # Rounding of points in single precision, over weights of order one.
        np.testing.assert_allclose(places, centers @ turn.T + shift, atol=1e-5)
        np.testing.assert_allclose(sizes, radii, rtol=1e-5)
        self.assertEqual(spheres.GetNumberOfFits(), 1)

    def test_simplified_mesh(self) -> None:
        simple = vtkindirect.vtkMeshSimplificationFilter()
        mesh = ellipsoid()
        simple.SetInputData(mesh)
        simple.SetMaximumError(0.02)
        simple.Update()
        made = simple.GetOutput()
        self.assertLess(made.GetNumberOfPolys(), mesh.GetNumberOfPolys() // 2)
        self.assertLessEqual(simple.GetMaximumDistance(), 0.02 * mesh.GetLength())
        self.assertIsNotNone(made.GetPointData().GetArray("Normals"))

    def test_every_property_is_on_the_page(self) -> None:
        text = PAGE.read_text(encoding="utf-8")
        for name in ("vtkSphereProxyFilter", "vtkMeshSimplificationFilter"):
            self.assertIn(name, text)
            own = vars(getattr(vtkindirect, name))
            names = {what[3:] for what in own if what[:3] == "Get" and f"Set{what[3:]}" in own}
            self.assertGreater(len(names), 3)
            for what in names:
                self.assertIn(f"`{what}`", text)
        for name in MEASURES:
            self.assertIn(f"`{name}`", text)


if __name__ == "__main__":
    unittest.main()
