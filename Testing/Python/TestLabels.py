# SPDX-License-Identifier: BSD-3-Clause
"""Images of labels: which ones are, and surfaces with the volume and place of what is labelled."""

import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import support
from vtkindirect import arrays, labels, load_scene, pipeline
from vtkindirect.errors import UsageError

SHAPE = (40, 44, 48)  # z, y, x
RADIUS = 12.0
CENTER = np.array([20.0, 21.0, 18.0])  # x, y, z


def distance() -> np.ndarray:
    """Return the distance of each voxel to the centre of the ball."""
    z, y, x = np.indices(SHAPE)
    return np.sqrt((x - CENTER[0]) ** 2 + (y - CENTER[1]) ** 2 + (z - CENTER[2]) ** 2)


def ball(value: int = 1, radius: float = RADIUS) -> np.ndarray:
    return np.where(distance() <= radius, value, 0).astype(np.int16)


def organs() -> np.ndarray:
    """Return twelve labels that do not follow each other: slabs of a ball, in a mixed order."""
    slabs = (np.indices(SHAPE)[2] // 3) % 12
    order = np.array([70, 3, 55, 12, 90, 7, 41, 22, 63, 5, 38, 17])
    return np.where(distance() <= 16, order[slabs], 0).astype(np.int16)


def image_of(values: np.ndarray) -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    scalars = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    scalars.SetName("tissue")
    image.GetPointData().SetScalars(scalars)
    return image


def find(image: vtkImageData) -> labels.Labels | None:
    return labels.find(image, arrays.find(image, None, "", on_cells=False))


class Find(unittest.TestCase):
    def test_labels(self) -> None:
        nested = ball(1, 16) + ball(1, 12) + ball(1, 8)  # as brain tissues around each other
        cases = {
            "mask": (ball(), 0, [1]),
            "mask of 255": (ball(255).astype(np.uint8), 0, [255]),
            "whole floats": (ball(3).astype(np.float32), 0, [3]),
            "nested": (nested, 0, [1, 2, 3]),
            "many": (organs(), 0, [3, 5, 7, 12, 17, 22, 38, 41, 55, 63, 70, 90]),
            "negative": (np.where(ball() > 0, -2, 0).astype(np.int8), 0, [-2]),
            "no zero": (ball() + 1, 1, [2]),
        }
        for name, (values, background, expected) in cases.items():
            with self.subTest(name=name):
                found = find(image_of(values))
                self.assertEqual(found, labels.Labels(background, expected))

    def test_no_labels(self) -> None:
        noise = np.random.RandomState(1).randint(0, 200, SHAPE)
        nothing_to_sort = np.arange(math.prod(SHAPE)).reshape(SHAPE)
        one_nan = ball().astype(np.float32)
        one_nan[3, 4, 5] = np.nan
        cases = {
            "noise": noise.astype(np.uint8),
            "noise in a ball": (noise * ball()).astype(np.uint8),
            "distance in whole voxels": np.rint(distance()).astype(np.int16),
            "ramp": (np.indices(SHAPE)[0] // 2).astype(np.int32),
            "distance": distance(),
            "all different": nothing_to_sort.astype(np.int32),
            "constant": np.ones(SHAPE, np.uint8),
            "a value that is not finite": one_nan,
            "one slice": ball()[:1],
        }
        for name, values in cases.items():
            with self.subTest(name=name):
                self.assertIsNone(find(image_of(values)))

    def test_vectors(self) -> None:
        image = image_of(ball())
        values = numpy_to_vtk(np.ones((image.GetNumberOfPoints(), 3), np.uint8), deep=True)
        image.GetPointData().SetScalars(values)
        self.assertIsNone(find(image))


class Surface(unittest.TestCase):
    def surface(self, image: vtkImageData):
        found = arrays.find(image, None, "", on_cells=False)
        return labels.surface(image, found, labels.find(image, found))

    def edges(self, surface) -> int:
        """Return the number of edges that only one triangle has."""
        edges = vtkFeatureEdges()
        edges.SetInputData(surface)
        edges.FeatureEdgesOff()
        edges.ManifoldEdgesOff()
        edges.NonManifoldEdgesOff()
        edges.Update()
        return edges.GetOutput().GetNumberOfCells()

    def volume(self, surface) -> float:
        mass = vtkMassProperties()
        mass.SetInputData(surface)
        return mass.GetVolume()

    def test_a_ball(self) -> None:
        image = image_of(ball(5))
        spacing, turn = np.array([0.5, 0.5, 1.5]), np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        image.SetExtent(10, 57, -3, 40, 2, 41)
        image.SetOrigin(100, 200, 300)
        image.SetSpacing(*spacing)
        image.SetDirectionMatrix(*turn.ravel().tolist())
        surface = self.surface(image)
        self.assertEqual(self.edges(surface), 0)
        # The ball has as many voxels as its volume says, to 0.1 percent. Smoothing cuts the steps
        # of voxels, of which a shell of a twelfth of a voxel's edge may get lost or come to it.
        expected = (ball() > 0).sum() * spacing.prod()
        self.assertAlmostEqual(self.volume(surface) / expected, 1.0, delta=3 / RADIUS / 12)
        center = image.GetOrigin() + turn @ (spacing * (CENTER + (10, -3, 2)))
        points = vtk_to_numpy(surface.GetPoints().GetData())
        outward = points - center
        normals = vtk_to_numpy(surface.GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
        voxels = (turn.T @ outward.T).T / spacing
        np.testing.assert_allclose(np.linalg.norm(voxels, axis=1), RADIUS, atol=1.0)
        np.testing.assert_allclose(voxels.mean(axis=0), 0.0, atol=0.1)
        gradient = (turn @ (voxels / spacing).T).T
        gradient /= np.linalg.norm(gradient, axis=1)[:, None]
        # Versions of VTK smooth differently: the least cosine is 0.93 or 0.63, the mean 0.998 or
        # 0.994. Without smoothing they are 0.42 and 0.965.
        cosines = (normals * gradient).sum(axis=1)
        self.assertGreater(cosines.min(), 0.55)
        self.assertGreater(cosines.mean(), 0.985)
        values = vtk_to_numpy(surface.GetPointData().GetArray(labels.NAME))
        self.assertEqual(set(values.tolist()), {5.0})

    def test_closed_where_the_image_ends(self) -> None:
        values = np.zeros((12, 12, 12), np.uint8)
        values[:, 3:9, 3:9] = 2
        surface = self.surface(image_of(values))
        self.assertEqual(self.edges(surface), 0)
        low, high = surface.GetBounds()[4:]
        # Half a voxel beyond the centres of the first and the last; smoothing stays below that.
        self.assertAlmostEqual(low, -0.5, delta=0.5)
        self.assertAlmostEqual(high, 11.5, delta=0.5)

    def test_each_label_for_itself(self) -> None:
        values = organs()
        surface = self.surface(image_of(values))
        self.assertEqual(self.edges(surface), 0)
        for value in (3, 55, 90):
            part = vtkThreshold()
            part.SetInputData(surface)
            points = vtkDataObject.FIELD_ASSOCIATION_POINTS
            part.SetInputArrayToProcess(0, 0, 0, points, labels.NAME)
            part.SetLowerThreshold(value)
            part.SetUpperThreshold(value)
            outside = vtkDataSetSurfaceFilter()
            outside.SetInputConnection(part.GetOutputPort())
            outside.Update()
            low, high = outside.GetOutput().GetBounds()[:2]
            where = np.nonzero(values == value)[2]
            # Smoothing rounds the rims of slabs three voxels thick by less than one.
            self.assertAlmostEqual(low, where.min() - 0.5, delta=1.0)
            self.assertAlmostEqual(high, where.max() + 0.5, delta=1.0)

    def test_a_single_voxel(self) -> None:
        values = ball()
        values[2, 2, 2] = 2
        surface = self.surface(image_of(values))
        present = vtk_to_numpy(surface.GetPointData().GetArray(labels.NAME))
        self.assertIn(2.0, present.tolist())
        self.assertTrue(np.isfinite(vtk_to_numpy(surface.GetPoints().GetData())).all())


class Contour(unittest.TestCase):
    def test_normals_where_the_image_has_no_gradient(self) -> None:
        # Voxels at random: central differences are zero between many neighbours.
        values = np.random.RandomState(2).randint(0, 2, (14, 15, 16)).astype(np.float32)
        surface = pipeline.done(image_of(values), [{"contour": {"value": 0.5}}])
        normals = vtk_to_numpy(surface.GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)

    def test_they_point_away_from_greater_values(self) -> None:
        # Sheets one voxel thin: central differences are zero at each voxel but the outermost.
        sheets = np.zeros((8, 8, 21), np.float32)
        sheets[:, :, 1::2] = 1.0
        image = image_of(sheets)
        image.SetSpacing(1.0, 1.0, 1.5)  # with spacings of one VTK makes zeros, with others NaN
        surface = pipeline.done(image, [{"contour": {"value": 0.5}}])
        normals = vtk_to_numpy(surface.GetPointData().GetNormals())
        x = vtk_to_numpy(surface.GetPoints().GetData())[:, 0]
        np.testing.assert_allclose(x % 1.0, 0.5)
        outward = np.where(np.floor(x) % 2 == 1, 1.0, -1.0)  # on the far side of a sheet, or near
        np.testing.assert_allclose(normals[:, 0], outward, atol=1e-5)


class DataFile(support.DirectoryTest):
    def test_the_frog(self) -> None:
        scene = load_scene(support.DATA / "frog_tissues.vti")
        (note,) = scene.notes
        self.assertIn("'MetaImage' holds labels: 25 surfaces, none of 0", note)
        (actor,) = scene.actors.values()
        mapper = actor.GetMapper()
        self.assertTrue(mapper.GetScalarVisibility())
        self.assertEqual(mapper.GetLookupTable().GetNumberOfAnnotatedValues(), 25)

    def test_an_image_of_intensities_is_shown_as_before(self) -> None:
        scene = load_scene(support.DATA / "brain_mri_colin27_ch2bet.nii.gz")
        self.assertIn("half of its range", scene.notes[0])

    def test_a_constant_image(self) -> None:
        from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

        path = self.directory / "flat.vti"
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image_of(np.ones((4, 4, 4), np.uint8)))
        writer.SetFileName(str(path))
        writer.Write()
        with self.assertRaisesRegex(UsageError, "'tissue' is constant"):
            load_scene(path)
