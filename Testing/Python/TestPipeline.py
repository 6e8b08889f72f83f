# SPDX-License-Identifier: BSD-3-Clause
"""Each step of a pipeline: what it makes of data whose answer is known, and what it refuses."""

import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkContourFilter, vtkMassProperties
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource

import support
from vtkindirect import SceneError, data, pipeline


def run(held, *steps):
    return pipeline.done(held, list(steps), "p")


def image(function, name="f", count=41, dtype=np.float32, origin=-2.0):
    """Return an image over -2..2 in three directions with f(x, y, z)."""
    axis = np.linspace(-2, 2, count)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    made = vtkImageData()
    made.SetDimensions(count, count, count)
    made.SetOrigin(origin, origin, origin)
    made.SetSpacing(4 / (count - 1), 4 / (count - 1), 4 / (count - 1))
    values = numpy_to_vtk(np.broadcast_to(function(x, y, z), x.shape).astype(dtype).ravel(), True)
    values.SetName(name)
    made.GetPointData().SetScalars(values)
    return made


def sphere(radius=1.0, center=(0, 0, 0), resolution=32):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(center)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


def contour_distances(held, values):
    """Return the distances of the points of VTK's contour."""
    contour = vtkContourFilter()
    contour.SetInputData(held)
    for index, value in enumerate(values):
        contour.SetValue(index, value)
    contour.Update()
    return distances(contour.GetOutput()).tolist()


def distances(held, center=(0, 0, 0)):
    return np.linalg.norm(vtk_to_numpy(held.GetPoints().GetData()) - center, axis=1)


def volume(held):
    mass = vtkMassProperties()
    mass.SetInputData(held)
    mass.Update()
    return mass.GetVolume()


BALL = image(lambda x, y, z: np.sqrt(x * x + y * y + z * z))
LABELS = image(lambda x, y, z: 3 * (x > 0.5) + 7 * (x < -0.5), "label", dtype=np.uint8)


class Steps(unittest.TestCase):
    def assert_refused(self, held, step, expected):
        with self.assertRaises(SceneError) as caught:
            run(held, step)
        self.assertIn(expected, str(caught.exception))

    def test_contour(self):
        one = run(BALL, {"contour": {"array": "f", "value": 1}})
        self.assertTrue(np.allclose(distances(one), 1, atol=0.01))
        self.assertIsNotNone(one.GetPointData().GetNormals())
        two = run(BALL, {"contour": {"value": [0.5, 1.5]}})
        found = distances(two)
        self.assertTrue(((abs(found - 0.5) < 0.02) | (abs(found - 1.5) < 0.02)).all())
        self.assertEqual(found.round().min(), 0)
        self.assert_refused(BALL, {"contour": {"value": 9}}, "p[0].contour.value: 9 is outside")
        wrong = {"contour": {"array": "g", "value": 1}}
        self.assert_refused(BALL, wrong, "p[0].contour.array: no array 'g'")

    def test_contour_of_cells(self):
        room = data.read(support.DATA / "room_fire_cfd.vtu")
        hot = run(room, {"contour": {"array": "t", "value": 480}})
        self.assertGreater(hot.GetNumberOfCells(), 1000)
        values = vtk_to_numpy(hot.GetPointData().GetArray("t"))
        self.assertTrue(np.allclose(values, 480, atol=0.01))
        self.assertIsNotNone(hot.GetPointData().GetArray("uvw"))

    def test_discrete_marching_cubes(self):
        part = run(LABELS, {"discrete_marching_cubes": {"value": 3}})
        self.assertAlmostEqual(part.GetBounds()[0], 0.55, delta=0.06)
        both = run(LABELS, {"discrete_marching_cubes": {"array": "label", "value": [3, 7]}})
        self.assertEqual(set(vtk_to_numpy(both.GetPointData().GetScalars())), {3, 7})
        self.assert_refused(
            sphere(), {"discrete_marching_cubes": {"value": 3}}, "needs image data, not vtkPolyData"
        )

    def test_label_mask(self):
        mask = run(LABELS, {"label_mask": {"value": 7, "margin": 2}})
        values = vtk_to_numpy(mask.GetPointData().GetScalars())
        self.assertEqual(set(values), {0.0, 1.0})
        low, high = mask.GetBounds()[:2]
        self.assertAlmostEqual(low, -2)
        self.assertAlmostEqual(high, -0.4, delta=0.01)
        surface = run(mask, {"contour": {"value": 0.5}})
        self.assertAlmostEqual(surface.GetBounds()[1], -0.55, delta=0.06)
        self.assert_refused(LABELS, {"label_mask": {"value": 5}}, "has no voxel of 5")

    def test_label_mask_keeps_the_place(self):
        moved = vtkImageData()
        moved.DeepCopy(LABELS)
        moved.SetExtent(10, 50, 20, 60, 30, 70)
        moved.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        whole = run(moved, {"discrete_marching_cubes": {"value": 3}}).GetBounds()
        part = run(moved, {"label_mask": {"value": 3}}, {"contour": {"value": 0.5}}).GetBounds()
        self.assertTrue(np.allclose(whole, part, atol=1e-4), (whole, part))

    def test_gaussian_smooth(self):
        edge = image(lambda x, y, z: x > 0)
        blurred = run(edge, {"gaussian_smooth": {"standard_deviation": [2, 0, 0]}})
        row = vtk_to_numpy(blurred.GetPointData().GetScalars())[:41]
        self.assertTrue((np.diff(row) >= -1e-6).all())
        self.assertGreater(((row > 0.05) & (row < 0.95)).sum(), 3)

    def test_extract(self):
        part = run(BALL, {"extract": {"extent": [0, 20, 0, 40, 10, 30], "step": 2}})
        self.assertEqual(part.GetDimensions(), (11, 21, 11))
        self.assert_refused(
            BALL, {"extract": {"extent": [0, 41, 0, 1, 0, 1]}}, "extract.extent: must lie in 0, 40"
        )

    def test_threshold(self):
        room = data.read(support.DATA / "room_vis.vtp")
        floor = run(room, {"threshold": {"array": "RGB", "lower": 160, "upper": 160}})
        self.assertEqual(floor.GetNumberOfCells(), 12)
        self.assertEqual(floor.GetClassName(), "vtkPolyData")
        others = {"array": "RGB", "lower": 160, "upper": 160, "invert": True}
        rest = run(room, {"threshold": others})
        self.assertEqual(rest.GetNumberOfCells(), 96)
        cells = run(BALL, {"threshold": {"upper": 1}}, {"surface": {}})
        self.assertLess(distances(cells).max(), 1.01)
        self.assert_refused(room, {"threshold": {"array": "RGB"}}, "needs lower, upper or both")
        wrong = {"threshold": {"array": "RGB", "lower": 2, "upper": 1}}
        self.assert_refused(room, wrong, "p[0].threshold.upper: must not be less than lower")
        nothing = {"threshold": {"array": "RGB", "lower": 1, "upper": 2}}
        self.assert_refused(room, nothing, "p[0].threshold: leaves nothing")

    def test_surface_and_normals(self):
        room = data.read(support.DATA / "room_fire_cfd.vtu")
        surface = run(room, {"surface": {}})
        self.assertEqual(surface.GetClassName(), "vtkPolyData")
        out = run(surface, {"normals": {"orient": True, "feature_angle": 20}})
        flipped = run(surface, {"normals": {"orient": True, "flip": True, "feature_angle": 20}})
        first = vtk_to_numpy(out.GetPointData().GetNormals())
        second = vtk_to_numpy(flipped.GetPointData().GetNormals())
        self.assertTrue(np.allclose(np.linalg.norm(first, axis=1), 1, atol=1e-5))
        self.assertTrue(np.allclose(first, -second, atol=1e-5))
        self.assert_refused(BALL, {"normals": {}}, "needs a surface, not image data")

    def test_normals_are_computed_anew(self):
        """Wrong normals of points and cells are not kept, whatever VTK's filter would keep."""
        source = vtkSphereSource()
        source.Update()
        ball = source.GetOutput()
        for attributes, count in (
            (ball.GetPointData(), ball.GetNumberOfPoints()),
            (ball.GetCellData(), ball.GetNumberOfCells()),
        ):
            wrong = numpy_to_vtk(np.tile(np.float32([0, 0, 1]), (count, 1)), deep=True)
            wrong.SetName("Normals")
            attributes.SetNormals(wrong)
        for step in ({"normals": {"splitting": False}}, {"smooth": {"iterations": 1}}):
            with self.subTest(step=step):
                out = run(ball, step)
                normals = vtk_to_numpy(out.GetPointData().GetNormals())
                outward = vtk_to_numpy(out.GetPoints().GetData())
                outward = outward / np.linalg.norm(outward, axis=1)[:, None]
                self.assertGreater((normals * outward).sum(axis=1).min(), 0.9)
        kept = vtk_to_numpy(ball.GetPointData().GetNormals())
        np.testing.assert_array_equal(kept[:, 2], 1.0)  # the data itself stays as it was

    def test_glyph_spheres(self):
        points = vtkPolyData()
        points.SetPoints(vtkPoints())
        for x in (0, 10):
            points.GetPoints().InsertNextPoint(x, 0, 0)
        sizes = numpy_to_vtk(np.array([1.0, 2.0]), True)
        sizes.SetName("size")
        points.GetPointData().AddArray(sizes)
        same = run(points, {"glyph_spheres": {"radius": 0.5, "resolution": 24}})
        expected = (-0.5, 10.5, -0.5, 0.5, -0.5, 0.5)
        self.assertTrue(np.allclose(same.GetBounds(), expected, atol=0.01))
        scaled = run(points, {"glyph_spheres": {"radius": 1, "scale_by": "size", "resolution": 24}})
        self.assertTrue(np.allclose(scaled.GetBounds()[:2], (-1, 12), atol=0.01))
        self.assertIsNotNone(scaled.GetPointData().GetArray("size"))
        wrong = {"glyph_spheres": {"scale_by": "sise"}}
        self.assert_refused(points, wrong, "no array 'sise' on points (did you mean 'size'?)")

    def test_atoms(self):
        protein = data.read(support.DATA / "protein_1tii.pdb")
        self.assertEqual(protein.GetNumberOfPoints(), 5684)
        dry = run(protein, {"threshold": {"array": "ishetatm", "upper": 0}})
        self.assertEqual(dry.GetNumberOfPoints(), 5469)
        spheres = run(dry, {"glyph_spheres": {"scale_by": "radius", "resolution": 6}})
        self.assertIsNotNone(spheres.GetPointData().GetArray("chain"))

    def test_tube(self):
        line = vtkLineSource()
        line.SetPoint1(0, 0, 0)
        line.SetPoint2(3, 0, 0)
        line.Update()
        tube = run(line.GetOutput(), {"tube": {"radius": 0.25, "sides": 32}})
        self.assertTrue(np.allclose(tube.GetBounds(), (0, 3, -0.25, 0.25, -0.25, 0.25), atol=0.01))
        self.assert_refused(sphere(), {"tube": {"radius": 1}}, "p[0].tube: leaves nothing")

    def test_stream_tracer(self):
        swirl = image(lambda x, y, z: x)
        axis = np.linspace(-2, 2, 41)
        z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
        vectors = np.stack([-y, x, 0 * z], axis=-1).reshape(-1, 3)
        held = numpy_to_vtk(vectors, True)
        held.SetName("v")
        swirl.GetPointData().AddArray(held)
        seeds = {"point1": [1, 0, 0], "point2": [1, 0, 1], "count": 3}
        paths = run(swirl, {"stream_tracer": {"vectors": "v", "seeds": seeds, "max_length": 4}})
        points = vtk_to_numpy(paths.GetPoints().GetData())
        self.assertTrue(np.allclose(np.hypot(points[:, 0], points[:, 1]), 1, atol=0.02))
        self.assertEqual(paths.GetNumberOfLines(), 6)
        seeds = {"center": [0, 0, 0], "radius": 1, "count": 50}
        step = {"stream_tracer": {"vectors": "v", "seeds": seeds, "direction": "forward"}}
        paths = run(swirl, step)
        self.assertLess(distances(paths).max(), 1.1)
        self.assertTrue(np.array_equal(distances(paths), distances(run(swirl, step))))
        for wrong, expected in (
            ({"vectors": "f", "seeds": seeds}, "array 'f' has no three components"),
            ({"vectors": "v"}, "stream_tracer.seeds: is missing"),
            ({"vectors": "v", "seeds": {"point1": [0, 0, 0]}}, "seeds.point2: is missing"),
            ({"vectors": "v", "seeds": {"center": [0, 0, 0]}}, "seeds.radius: is missing"),
            ({"vectors": "v", "seeds": {"count": 0}}, "seeds.center: is missing"),
        ):
            self.assert_refused(swirl, {"stream_tracer": wrong}, expected)

    def test_warp_scalar(self):
        surface = sphere()
        heights = numpy_to_vtk(np.full(surface.GetNumberOfPoints(), 0.5), True)
        heights.SetName("h")
        surface.GetPointData().AddArray(heights)
        self.assertTrue(
            np.allclose(distances(run(surface, {"warp_scalar": {"array": "h", "scale": 2}})), 2)
        )
        up = run(surface, {"warp_scalar": {"array": "h", "normal": [0, 0, 1]}})
        self.assertTrue(np.allclose(distances(up, (0, 0, 0.5)), 1, atol=1e-5))

    def test_smooth_keeps_the_size(self):
        rough = run(BALL, {"contour": {"value": 1.5}})
        smooth = run(rough, {"smooth": {"iterations": 30}})
        self.assertAlmostEqual(distances(smooth).mean(), 1.5, delta=0.01)
        self.assertIsNotNone(smooth.GetPointData().GetNormals())

    def test_decimate(self):
        many = sphere(resolution=64)
        few = run(many, {"decimate": {"reduction": 0.75}})
        self.assertLess(few.GetNumberOfCells(), 0.3 * many.GetNumberOfCells())
        self.assertAlmostEqual(volume(few), 4 / 3 * math.pi, delta=0.08)
        self.assertIsNotNone(few.GetPointData().GetNormals())

    def test_connectivity(self):
        both = vtkAppendPolyData()
        both.AddInputData(sphere(1))
        both.AddInputData(sphere(0.5, (10, 0, 0), 8))
        both.Update()
        largest = run(both.GetOutput(), {"connectivity": {}})
        self.assertLess(largest.GetBounds()[1], 2)
        near = run(both.GetOutput(), {"connectivity": {"closest_to": [9, 0, 0]}})
        self.assertGreater(near.GetBounds()[0], 9)

    def test_clip_and_slice(self):
        plane = {"origin": [0, 0, 0.5], "normal": [0, 0, 1]}
        top = run(sphere(), {"clip": plane})
        self.assertAlmostEqual(top.GetBounds()[4], 0.5, places=5)
        cells = run(BALL, {"clip": plane}, {"surface": {}})
        self.assertAlmostEqual(cells.GetBounds()[4], 0.5, places=5)
        cut = run(sphere(), {"slice": plane})
        self.assertTrue(np.allclose(distances(cut, (0, 0, 0.5)), math.sqrt(0.75), atol=0.01))
        self.assert_refused(sphere(), {"clip": {"origin": [0, 0, 0]}}, "clip.normal: is missing")
        away = {"origin": [0, 0, 5], "normal": [0, 0, 1]}
        self.assert_refused(sphere(), {"clip": away}, "p[0].clip: leaves nothing")

    def test_transform(self):
        moved = run(sphere(), {"transform": {"translate": [5, 0, 0], "scale": 2}})
        self.assertTrue(np.allclose(distances(moved, (5, 0, 0)), 2, atol=1e-5))
        tall = run(sphere(), {"transform": {"scale": [1, 1, 3], "rotate": [90, 0, 1, 0]}})
        self.assertTrue(np.allclose(tall.GetBounds()[:2], (-3, 3), atol=0.02))
        rows = [1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1, 0, 0, 0, 0, 1]
        up = run(sphere(), {"transform": {"matrix": rows}})
        self.assertTrue(np.allclose(distances(up, (0, 7, 0)), 1, atol=1e-5))
        both = {"transform": {"matrix": rows, "scale": 2}}
        self.assert_refused(sphere(), both, "transform.scale: cannot be given together with matrix")
        still = {"transform": {"rotate": [10, 0, 0, 0]}}
        self.assert_refused(sphere(), still, "transform.rotate: the axis must not be the zero")
        self.assert_refused(BALL, {"transform": {"scale": 2}}, "needs points or cells")

    def test_any_filter_by_its_class(self):
        plane = {"vtkPlane": {"Origin": [0, 0, 0.5], "Normal": [0, 0, 1]}}
        top = run(sphere(), {"vtkClipPolyData": {"ClipFunction": plane}})
        same = run(sphere(), {"clip": {"origin": [0, 0, 0.5], "normal": [0, 0, 1]}})
        self.assertEqual(top.GetBounds(), same.GetBounds())
        low = run(sphere(), {"vtkClipPolyData": {"ClipFunction": plane, "InsideOut": True}})
        self.assertAlmostEqual(low.GetBounds()[5], 0.5, places=5)
        shells = {"InputArrayToProcess": "f", "Value": [0.5, 1.5]}
        found = distances(run(BALL, {"vtkContourFilter": shells}))
        self.assertEqual(found.tolist(), contour_distances(BALL, [0.5, 1.5]))
        cones = {"vtkConeSource": {"Height": 0.1, "Resolution": 5}}
        glyphs = run(sphere(resolution=8), {"vtkGlyph3D": {"SourceConnection": cones}})
        self.assertGreater(glyphs.GetNumberOfCells(), 200)
        # The surface of cells is taken for a filter of surfaces, as for the short names.
        cells = run(BALL, {"threshold": {"upper": 1}}, {"vtkTriangleFilter": {}})
        self.assertEqual(cells.GetClassName(), "vtkPolyData")

    def test_mistakes_in_classes_and_properties(self):
        for step, expected in (
            ({"vtkClipPolydata": {}}, "p[0].vtkClipPolydata: VTK has no filter or source"),
            ({"vtkClipPolydata": {}}, "(did you mean 'vtkClipPolyData'?)"),
            ({"vtkXMLPolyDataWriter": {}}, "VTK has no filter or source 'vtkXMLPolyDataWriter'"),
            ({"vtkImplicitFunction": {}}, "vtkImplicitFunction is abstract"),
            ({"vtkPlane": {}}, "p[0].vtkPlane: vtkPlane is no filter"),
            ({"vtkConeSource": {}}, "vtkConeSource is no filter"),
            ({"vtkTubeFilter": {"Radios": 1}}, "vtkTubeFilter.Radios: vtkTubeFilter has no such"),
            ({"vtkTubeFilter": {"Radios": 1}}, "property (did you mean 'Radius'?)"),
            ({"vtkSliceCubes": {"FileName": "a"}}, "vtkSliceCubes is no filter"),
            ({"vtkParticleTracer": {"ParticleFileName": "a"}}, "vtkParticleTracer has no such"),
            ({"vtkTubeFilter": {"InputData": 1}}, "vtkTubeFilter has no such property"),
            ({"vtkTubeFilter": {"Radius": "big"}}, "Radius: must be a number, not 'big'"),
            ({"vtkTubeFilter": {"Radius": "1"}}, "Radius: must be a number, not '1'"),
            ({"vtkTubeFilter": {"Radius": [1, 2]}}, "p[0].vtkTubeFilter.Radius: must be a number"),
            ({"vtkTubeFilter": {"Radius": None}}, "p[0].vtkTubeFilter.Radius: must be a number"),
            ({"vtkTubeFilter": {"Radius": -1}}, "Radius: -1 is out of range"),
            ({"vtkTubeFilter": {"NumberOfSides": 3.5}}, "NumberOfSides: must be a whole number"),
            ({"vtkTubeFilter": {"Capping": "maybe"}}, "Capping: must be true, false"),
            ({"vtkWarpVector": {"InputArrayToProcess": "w"}}, "InputArrayToProcess: no array 'w'"),
            ({"vtkWarpVector": 3}, "p[0].vtkWarpVector: must be an object, not 3"),
            ({"vtkCutter": {"CutFunction": {}}}, "CutFunction: must hold exactly one class"),
            ({"vtkCutter": {"CutFunction": {"vtkPlane": 1}}}, "vtkPlane: must be an object"),
            ({"vtkCutter": {"CutFunction": {"vtkCone": {"Angle": "a"}}}}, "vtkCone.Angle: must be"),
            ({"vtkCutter": {"CutFunction": {"vtkConeSource": {}}}}, "cannot be a vtkConeSource"),
            ({"vtkCutter": {"CutFunction": 7}}, "p[0].vtkCutter.CutFunction: holds an object"),
            ({"vtkContourFilter": {"Value": "a"}}, "p[0].vtkContourFilter.Value: cannot be set"),
            ({"vtkProbeFilter": {}}, "p[0].vtkProbeFilter: vtkProbeFilter: Input port 1"),
            ({"vtkImageThreshold": {}}, "p[0].vtkImageThreshold: needs image data, not vtkPolyD"),
            ({"surface": {}, "vtkCutter": {}}, "p[0]: must hold exactly one step, not 2"),
        ):
            with self.subTest(step=step):
                self.assert_refused(sphere(), step, expected)
                with self.assertRaises(SceneError) as caught:
                    run(sphere(), step)
                self.assertNotIn("\n", str(caught.exception))

    def test_every_step_is_tested_here(self):
        tested = {name.removeprefix("test_") for name in dir(self)}
        together = "_".join(tested)
        for name in pipeline.STEPS:
            self.assertIn(name, together)
