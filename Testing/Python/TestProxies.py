# SPDX-License-Identifier: BSD-3-Clause
"""Spheres, simplified meshes and sums over spheres: what they say of themselves, motion, the page."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
    vtkRenderer,
)

import support
import vtkindirect
from vtkindirect import settings, sweep, wrapped

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
        # With 30 spheres 0.957 was measured.
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


@unittest.skipUnless(wrapped.has("vtkProxyAccumulationPass"), "vtkProxyAccumulationPass not built")
class ProxyPass(unittest.TestCase):
    def open(self, mesh: vtkPolyData) -> tuple[vtkRenderer, vtkActor]:
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        plane = vtkPlaneSource()
        plane.SetOrigin(-6.0, -6.0, -2.5)
        plane.SetPoint1(6.0, -6.0, -2.5)
        plane.SetPoint2(-6.0, 6.0, -2.5)
        plane.Update()
        actors = []
        for data in (plane.GetOutput(), mesh):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(data)
            actors.append(vtkActor())
            actors[-1].SetMapper(mapper)
            renderer.AddActor(actors[-1])
        renderer.GetActiveCamera().SetPosition(0.0, -12.0, 14.0)
        renderer.ResetCamera()
        renderer.GetActiveCamera().Zoom(2.0)
        self.window = vtkindirect.render_window((96, 72))
        self.window.AddRenderer(renderer)
        self.addCleanup(self.window.Finalize)
        return renderer, actors[1]

    def test_properties(self) -> None:
        proxies = vtkindirect.vtkProxyAccumulationPass()
        self.assertEqual(proxies.GetMethodName(), "proxies")
        self.assertEqual(proxies.GetReceiverStep(), 0)
        self.assertTrue(proxies.GetGroups())
        self.assertAlmostEqual(proxies.GetGroupAngle(), 0.4)
        self.assertEqual(proxies.GetIndirectLight(), proxies.SHADOWED)
        for asked, given in ((0.0, 0.05), (3.0, 1.0)):
            proxies.SetGroupAngle(asked)
            self.assertEqual(proxies.GetGroupAngle(), given)
        proxies.SetReceiverStep(99)
        self.assertEqual(proxies.GetReceiverStep(), 16)
        settings.apply([proxies], {"IndirectLight": "averaged"})
        self.assertEqual(proxies.GetIndirectLight(), proxies.AVERAGED)
        settings.apply([proxies], {"IndirectLight": "exact"})
        self.assertEqual(proxies.GetIndirectLight(), proxies.EXACT)

    @unittest.skipUnless(wrapped.has("vtkSphereProxyFilter"), "vtkIndirectProxies was not built")
    def test_a_mesh_gets_spheres_by_itself(self) -> None:
        renderer, actor = self.open(ellipsoid())
        indirect = vtkindirect.enable(renderer, "proxies", environment=(1.0, 1.0, 1.0))
        self.window.Render()
        proxies = indirect.GetEstimator()
        spheres = proxies.GetNumberOfSpheres()
        self.assertGreater(spheres, 100)
        self.assertLessEqual(spheres, 256)
        self.assertEqual(proxies.GetNumberOfPolygons(), 1)
        sky = vtkindirect.copy_buffer(renderer, "sky")
        normal = vtkindirect.copy_buffer(renderer, "normal")
        # Spheres that stand for the surface itself hide little of what it sees: of its upper half
        # nothing else hides much.
        top = (normal[..., 2] > 0.5) & (normal[..., 2] < 0.9999)
        self.assertGreater(top.sum(), 40)
        self.assertGreater(sky[top].mean(), 0.85)
        # They move with the actor; nothing is fitted again, or this would take seconds.
        ground = normal[..., 2] > 0.9999
        actor.SetPosition(2.0, 0.0, 0.0)
        self.window.Render()
        moved_sky = vtkindirect.copy_buffer(renderer, "sky")
        self.assertGreater(np.abs(moved_sky - sky)[ground].max(), 0.04)
        self.assertEqual(proxies.GetNumberOfSpheres(), spheres)
        # And with its points.
        actor.SetPosition(0.0, 0.0, 0.0)
        data = actor.GetMapper().GetInput()
        data.SetPoints(moved(data, np.eye(3), np.array((2.0, 0.0, 0.0))).GetPoints())
        self.window.Render()
        np.testing.assert_allclose(
            vtkindirect.copy_buffer(renderer, "sky"), moved_sky, atol=0.02
        )
        self.assertEqual(proxies.GetNumberOfSpheres(), spheres)

    def test_given_spheres_and_the_report(self) -> None:
        renderer, actor = self.open(ellipsoid())
        indirect = vtkindirect.enable(renderer, "proxies", environment=(1.0, 1.0, 1.0))
        proxies = indirect.GetEstimator()
        given = vtkPolyData()
        points = vtkPoints()
        points.InsertNextPoint(0.0, 0.0, 0.0)
        given.SetPoints(points)
        radii = numpy_to_vtk(np.array((0.5,)), deep=True)
        radii.SetName("Radius")
        given.GetPointData().AddArray(radii)
        proxies.SetProxies(actor, given)
        self.window.Render()
        self.assertEqual(proxies.GetNumberOfSpheres(), 1)
        report = vtkindirect.report(renderer)
        self.assertEqual(report["method"], "proxies")
        said = {entry["what"]: entry["why"] for entry in report["modelled"]}
        self.assertIn("1 spheres of meshes, 1 flat polygons", said["what hides the sky"])
        self.assertIn("order 4", said["light from the sky"])
        proxies.RemoveAllProxies()
        self.assertIsNone(proxies.GetProxies(actor))

    def test_moving_glyphs_take_the_sky_from_spheres(self) -> None:
        """Spheres of vtkGlyph3DMapper, with nothing set but an environment."""
        ball = vtkSphereSource()
        ball.SetRadius(0.2)
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        mapper = vtkGlyph3DMapper()
        mapper.SetSourceConnection(ball.GetOutputPort())
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        window = vtkindirect.render_window((64, 48))
        window.AddRenderer(renderer)
        vtkindirect.enable(renderer, environment=(1.0, 1.0, 1.0))
        grid = np.stack(np.meshgrid(*[np.arange(3.0)] * 3), axis=-1).reshape(-1, 3)
        found = []
        for frame in range(5):
            if frame < 4:
                data.GetPoints().SetData(numpy_to_vtk(grid + 0.1 * np.sin(frame + grid), deep=True))
                data.Modified()
            window.Render()
            entries = vtkindirect.report(renderer)["modelled"]
            found += [e["what"] for e in entries if e["what"].startswith("sky by")]
        maps, spheres = "sky by depth maps", "sky by spheres"
        self.assertEqual(found, [maps, maps, spheres, spheres, maps])
        window.Finalize()

    def test_every_property_is_on_the_page(self) -> None:
        text = PAGE.read_text(encoding="utf-8")
        own = vars(vtkindirect.vtkProxyAccumulationPass)
        names = {what[3:] for what in own if what[:3] == "Get" and f"Set{what[3:]}" in own}
        self.assertGreater(len(names), 3)
        for what in names - {"Proxies"}:  # of a prop
            self.assertIn(f"`{what}`", text)

    def test_sweep_has_rows(self) -> None:
        path = support.SOURCE / "Testing" / "Benchmark" / "sky.json"
        rows = [row for row in sweep.load(path).rows if row.method == "proxies"]
        self.assertGreaterEqual(len(rows), 1)


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Points(unittest.TestCase):
    """Points alone, as spheres or as splats: light falls on them, or the report says why not."""

    def look(self, splats: bool, method: str, environment):
        source = vtkPointSource()
        source.SetNumberOfPoints(100)
        actor = vtkActor()
        if splats:
            mapper = vtkPointGaussianMapper()
            mapper.SetScaleFactor(0.05)
        else:
            mapper = vtkPolyDataMapper()
            actor.GetProperty().RenderPointsAsSpheresOn()
            actor.GetProperty().SetPointSize(8)
        mapper.SetInputConnection(source.GetOutputPort())
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        renderer.ResetCamera()
        window = vtkindirect.render_window((64, 48), offscreen=True)
        window.AddRenderer(renderer)
        self.addCleanup(window.Finalize)
        vtkindirect.enable(renderer, method, environment=environment)
        for _ in range(3):
            window.Render()
        left_out = [
            entry["why"]
            for entry in vtkindirect.report(renderer)["left_out"]
            if mapper.GetClassName() in entry["what"]
        ]
        return vtkindirect.copy_buffer(renderer, "irradiance"), " ".join(left_out)

    def test_points_get_light_or_are_named(self) -> None:
        # The default's own sky, a white one, and sums over spheres.
        for method, environment, least in (
            ("auto", None, 0.01),
            ("auto", (1, 1, 1), 0.9),
            ("proxies", (1, 1, 1), 0.9),
        ):
            with self.subTest(method=method, environment=environment):
                light, why = self.look(False, method, environment)
                self.assertGreater(light.max(), least)
                self.assertLess(light.max(), 1.02)
                self.assertEqual(why, "")
                light, why = self.look(True, method, environment)
                self.assertEqual(light.max(), 0)
                self.assertIn("they receive no indirect light", why)


if __name__ == "__main__":
    unittest.main()
