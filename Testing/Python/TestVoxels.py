# SPDX-License-Identifier: BSD-3-Clause
"""Values at cells of images, and missing values: shown where they are, as VTK shows them."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataWriter,
)

import support
from vtkindirect import arrays, load_scene, pipeline, voxels
from vtkindirect.errors import UsageError

SIDE = 20


def distance(center: float = (SIDE - 1) / 2) -> np.ndarray:
    z, y, x = np.indices((SIDE, SIDE, SIDE))
    return np.sqrt((x - center) ** 2 + (y - center) ** 2 + (z - center) ** 2).astype(np.float32)


def image_of(values: np.ndarray, at_cells: bool = False, name: str = "dose") -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(*(n + at_cells for n in values.shape[::-1]))
    scalars = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    scalars.SetName(name)
    (image.GetCellData() if at_cells else image.GetPointData()).AddArray(scalars)
    return image


def points_of(data) -> np.ndarray:
    return vtk_to_numpy(data.GetPoints().GetData())


class Cells(support.DirectoryTest):
    def load(self, data, writer, name: str):
        writer.SetInputData(data)
        writer.SetFileName(str(self.directory / name))
        writer.Write()
        return load_scene(self.directory / name)

    def image(self, data, name: str = "data.vti"):
        return self.load(data, vtkXMLImageDataWriter(), name)

    def shown(self, scene):
        (actor,) = scene.actors.values()
        return actor.GetMapper().GetInput()

    def test_centres_of_cells_are_where_they_were(self) -> None:
        image = image_of(distance(), at_cells=True)
        image.SetExtent(3, 3 + SIDE, -2, SIDE - 2, 5, 5 + SIDE)
        image.SetSpacing(0.5, 2.0, 1.0)
        image.SetOrigin(10, 20, 30)
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        found = arrays.find(image, "dose", "")
        made, array = voxels.at_points(image, found)
        self.assertTrue(array.on_points)
        self.assertEqual(made.GetNumberOfPoints(), image.GetNumberOfCells())
        for cell in (0, 7, SIDE**3 - 1):
            bounds = np.array(image.GetCell(cell).GetBounds())
            np.testing.assert_allclose(made.GetPoint(cell), (bounds[::2] + bounds[1::2]) / 2)
        np.testing.assert_array_equal(array.numbers(), found.numbers())

    def test_a_contour_of_cells_is_that_of_their_centres(self) -> None:
        of_cells = pipeline.done(image_of(distance(), True), [{"contour": {"value": 6.0}}])
        of_points = pipeline.done(image_of(distance()), [{"contour": {"value": 6.0}}])
        np.testing.assert_allclose(points_of(of_cells), points_of(of_points) + 0.5, atol=1e-5)

    def test_other_cells_take_means(self) -> None:
        grid = vtkRectilinearGrid()
        ticks = numpy_to_vtk(np.arange(SIDE + 1.0), deep=True)
        grid.SetDimensions(SIDE + 1, SIDE + 1, SIDE + 1)
        for set_ in (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates):
            set_(ticks)
        array = numpy_to_vtk(distance().ravel(), deep=True)
        array.SetName("dose")
        grid.GetCellData().AddArray(array)
        surface = pipeline.done(grid, [{"contour": {"array": "dose", "value": 6.0}}])
        radius = np.linalg.norm(points_of(surface) - SIDE / 2, axis=1)
        # A mean over eight cells a unit apart is off by a tenth of a unit at this curvature.
        np.testing.assert_allclose(radius, 6.0, atol=0.12)

    def test_files(self) -> None:
        scene = self.image(image_of(distance(), at_cells=True))
        self.assertIn("contour of 'dose'", scene.notes[0])
        whole = (distance() < 6).astype(np.uint8) * 3
        scene = self.image(image_of(whole, at_cells=True, name="tissue"))
        self.assertIn("'tissue' holds labels: 1 surfaces", scene.notes[0])
        low, high = np.array(scene.bounds)[::2], np.array(scene.bounds)[1::2]
        np.testing.assert_allclose((low + high) / 2, SIDE / 2, atol=0.05)
        empty = vtkImageData()
        empty.SetDimensions(4, 4, 4)
        with self.assertRaisesRegex(UsageError, "data.vti: the image has no values to show"):
            self.image(empty)

    def test_one_layer_is_shown_in_colours(self) -> None:
        for at_cells in (False, True):
            scene = self.image(image_of(distance()[:1], at_cells))
            self.assertIn("coloured by 'dose'", scene.notes[0])
            (actor,) = scene.actors.values()
            self.assertTrue(actor.GetMapper().GetScalarVisibility())


class Missing(Cells):
    def holed(self) -> np.ndarray:
        values = distance()
        values[:6] = np.nan
        return values

    def test_a_contour_leaves_them_out(self) -> None:
        scene = self.image(image_of(self.holed()))
        self.assertIn(f"without {6 * SIDE**2} missing values (NaN)", scene.notes[0])
        surface = self.shown(scene)
        whole = self.shown(self.image(image_of(distance())))
        self.assertTrue(np.isfinite(points_of(surface)).all())
        normals = vtk_to_numpy(surface.GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
        # All of the whole contour that has a value on both sides is there, and nothing else.
        self.assertGreaterEqual(points_of(surface)[:, 2].min(), 6.0)
        self.assertGreater(surface.GetNumberOfCells(), 0.55 * whole.GetNumberOfCells())
        self.assertLess(surface.GetNumberOfCells(), whole.GetNumberOfCells())

    def test_of_other_cells_too(self) -> None:
        image = image_of(self.holed())
        cells = vtkAppendFilter()
        cells.AddInputData(image)
        cells.Update()
        surface = pipeline.done(cells.GetOutput(), [{"contour": {"array": "dose", "value": 6.0}}])
        self.assertTrue(np.isfinite(points_of(surface)).all())

    def test_nothing_but_missing_values(self) -> None:
        with self.assertRaisesRegex(UsageError, "'dose' has no values, all of them are missing"):
            self.image(image_of(np.full((4, 4, 4), np.nan, np.float32)))

    def test_surfaces_show_them_in_grey(self) -> None:
        ball = vtkSphereSource()
        ball.Update()
        data = ball.GetOutput()
        values = np.arange(data.GetNumberOfPoints(), dtype=np.float32)
        values[3] = np.nan
        array = numpy_to_vtk(values, deep=True)
        array.SetName("age")
        data.GetPointData().AddArray(array)
        scene = self.load(data, vtkXMLPolyDataWriter(), "data.vtp")
        (actor,) = scene.actors.values()
        table = actor.GetMapper().GetLookupTable()
        self.assertEqual(table.GetTableRange(), (0.0, float(values[-1])))
        self.assertEqual(tuple(table.GetNanColor()), (0.66, 0.66, 0.66, 1.0))


class Colours(Cells):
    """Colours of data, if no array is named."""

    def ball(self, **by_name):
        source = vtkSphereSource()
        source.Update()
        data = source.GetOutput()
        for name, (attributes, values) in by_name.items():
            array = numpy_to_vtk(np.asarray(values), deep=True)
            array.SetName(name)
            getattr(data, f"Get{attributes}Data")().AddArray(array)
        return data

    def colored_by(self, data):
        scene = self.load(data, vtkXMLPolyDataWriter(), "data.vtp")
        (actor,) = scene.actors.values()
        mapper = actor.GetMapper()
        return mapper.GetArrayName() if mapper.GetScalarVisibility() else None

    def test_which(self) -> None:
        points = self.ball().GetNumberOfPoints()
        cells = self.ball().GetNumberOfCells()
        ramp = np.arange(points, dtype=float)
        wind = np.outer(ramp, (1.0, 2.0, 3.0))
        cases = (
            ({}, None),  # normals alone
            ({"same": ("Point", np.ones(points))}, None),
            ({"wind": ("Point", wind), "p": ("Point", ramp)}, "p"),
            ({"wind": ("Point", wind)}, "wind"),
            ({"area": ("Cell", np.arange(cells, dtype=float))}, "area"),
            ({"vtkOriginalPointIds": ("Point", ramp)}, None),
        )
        for given, expected in cases:
            with self.subTest(given=list(given)):
                self.assertEqual(self.colored_by(self.ball(**given)), expected)
        active = self.ball(p=("Point", ramp), q=("Point", ramp))
        active.GetPointData().SetActiveScalars("q")
        self.assertEqual(self.colored_by(active), "q")

    def test_vectors_by_their_length(self) -> None:
        points = self.ball().GetNumberOfPoints()
        wind = np.outer(np.arange(points, dtype=float), (1.0, 2.0, 2.0))
        scene = self.load(self.ball(wind=("Point", wind)), vtkXMLPolyDataWriter(), "data.vtp")
        (actor,) = scene.actors.values()
        table = actor.GetMapper().GetLookupTable()
        np.testing.assert_allclose(table.GetTableRange(), (0.0, 3.0 * (points - 1)))
        mapper = actor.GetMapper()
        mapper.MapScalars(1.0)
        colors = vtk_to_numpy(mapper.GetColorMapColors() or mapper.MapScalars(1.0))
        np.testing.assert_allclose(colors[-1, :3], (253, 231, 36), atol=1)  # viridis' last


if __name__ == "__main__":
    unittest.main()
