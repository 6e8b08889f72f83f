# SPDX-License-Identifier: BSD-3-Clause
"""Changes of what glyphs, impostors, molecules and blocks are drawn from."""

import numpy as np
from rooms import RED, make_ball
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkMolecule,
    vtkMultiBlockDataSet,
    vtkPiecewiseFunction,
    vtkPolyData,
)
from vtkmodules.vtkDomainsChemistry import vtkMoleculeMapper
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCompositeDataDisplayAttributes,
    vtkCompositePolyDataMapper,
    vtkGlyph3DMapper,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

from .parts import BLUE, change, change_alone, make_table, write

# Until VTK 9.2 another class draws blocks by their attributes.
if hasattr(vtkCompositePolyDataMapper, "SetCompositeDataDisplayAttributes"):
    CompositeMapper = vtkCompositePolyDataMapper
else:
    CompositeMapper = vtkRenderingOpenGL2.vtkCompositePolyDataMapper2


def make_glyphs():
    points = vtkPointSource()
    points.SetNumberOfPoints(1)
    points.SetCenter(0, 0.5, 0)
    points.SetRadius(0)
    source = vtkCubeSource()
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    mapper.SetSourceConnection(source.GetOutputPort())
    mapper.SetScaleFactor(0.5)
    prop = vtkActor()
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)
    return prop, source


@change_alone
def glyph_source():
    prop, source = make_glyphs()
    return prop, lambda: source.SetXLength(0.2)


@change_alone
def ball_glyph_source():
    prop, _ = make_glyphs()
    ball = vtkSphereSource()
    ball.SetRadius(0.7)
    prop.GetMapper().SetSourceConnection(ball.GetOutputPort())
    return prop, lambda: ball.SetRadius(0.3)


def make_blocks():
    ball = make_ball()
    ball.Update()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, ball.GetOutput())
    mapper = CompositeMapper()
    mapper.SetInputDataObject(blocks)
    attributes = vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(attributes)
    prop = vtkActor()
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)
    return prop, blocks, attributes


@change_alone
def block_color():
    prop, blocks, attributes = make_blocks()
    return prop, lambda: attributes.SetBlockColor(blocks.GetBlock(0), BLUE)


@change_alone
def block_hidden():
    prop, blocks, attributes = make_blocks()
    ball = vtkSphereSource()
    ball.SetCenter(0.4, 0.2, 0.3)
    ball.SetRadius(0.2)
    ball.Update()
    blocks.SetBlock(1, ball.GetOutput())
    return prop, lambda: attributes.SetBlockVisibility(blocks.GetBlock(0), False)


def make_glyph_points(prop, name: str, value: float):
    """Give glyphs one point with an array of one component; return the array."""
    data = vtkPolyData()
    points = vtkPoints()
    points.InsertNextPoint(0, 0.5, 0)
    data.SetPoints(points)
    array = numpy_to_vtk(np.full(1, value, np.float32), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    prop.GetMapper().SetInputData(data)
    return array


@change
def glyph_sizes_in_place():
    prop, _ = make_glyphs()
    sizes = make_glyph_points(prop, "size", 1)
    prop.GetMapper().SetScaleArray("size")
    prop.GetMapper().SetScaleModeToScaleByMagnitude()
    return prop, lambda: write(sizes, 0.4)


@change
def glyph_scale_factor():
    prop, _ = make_glyphs()
    return prop, lambda: prop.GetMapper().SetScaleFactor(0.2)


def make_glyphs_of_two():
    """Return glyphs of two sources by an index, and the index."""
    prop, _ = make_glyphs()
    index = make_glyph_points(prop, "which", 0)
    mapper = prop.GetMapper()
    cube = vtkCubeSource()
    cube.SetXLength(0.3)
    mapper.SetSourceConnection(1, cube.GetOutputPort())
    mapper.SourceIndexingOn()
    mapper.SetSourceIndexArray("which")
    mapper.SetRange(0, 2)
    return prop, index, cube


@change
def glyph_indices_in_place():
    prop, index, _ = make_glyphs_of_two()
    return prop, lambda: write(index, 1)


@change
def glyph_second_source():
    prop, index, cube = make_glyphs_of_two()
    write(index, 1)
    return prop, lambda: cube.SetXLength(0.8)


@change
def glyph_table_of_sources():
    prop, _, _ = make_glyphs_of_two()
    tree = vtkMultiBlockDataSet()
    for number in range(2):
        cube = vtkCubeSource()
        cube.Update()
        tree.SetBlock(number, cube.GetOutput())
    prop.GetMapper().SetSourceTableTree(tree)
    prop.GetMapper().UseSourceTableTreeOn()

    def shrink() -> None:
        points = tree.GetBlock(0).GetPoints()
        write(points.GetData(), 0.4 * vtk_to_numpy(points.GetData()))
        points.Modified()

    return prop, shrink


@change
def glyph_block_color():
    prop, _ = make_glyphs()
    points = vtkPolyData()
    place = vtkPoints()
    place.InsertNextPoint(0, 0.5, 0)
    points.SetPoints(place)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, points)
    prop.GetMapper().SetInputDataObject(blocks)
    attributes = vtkCompositeDataDisplayAttributes()
    attributes.SetBlockColor(points, RED)
    prop.GetMapper().SetBlockAttributes(attributes)
    return prop, lambda: attributes.SetBlockColor(points, BLUE)


def make_balls(mapper):
    """Return a prop that draws one point with a size by an impostor, and its sizes."""
    prop = vtkActor()
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)
    sizes = make_glyph_points(prop, "size", 0.4)
    vertex = vtkCellArray()
    vertex.InsertNextCell(1, (0,))
    mapper.GetInput().SetVerts(vertex)
    mapper.SetScaleArray("size")
    return prop, sizes


@change
def ball_sizes_in_place():
    prop, sizes = make_balls(vtkOpenGLSphereMapper())
    return prop, lambda: write(sizes, 0.2)


@change
def ball_radius():
    prop, _ = make_balls(vtkOpenGLSphereMapper())
    prop.GetMapper().SetScaleArray(None)
    prop.GetMapper().SetRadius(0.4)
    return prop, lambda: prop.GetMapper().SetRadius(0.2)


@change
def ball_scalars_in_place():
    prop, _ = make_balls(vtkOpenGLSphereMapper())
    scalars = numpy_to_vtk(np.zeros(1, np.float32), deep=True)
    prop.GetMapper().GetInput().GetPointData().SetScalars(scalars)
    prop.GetMapper().SetLookupTable(make_table(RED, BLUE))
    return prop, lambda: write(scalars, 1)


@change
def splat_scale_function():
    sizes = vtkPiecewiseFunction()
    sizes.AddPoint(0, 0.4)
    sizes.AddPoint(1, 0.4)
    prop, _ = make_balls(vtkPointGaussianMapper())
    prop.GetMapper().SetScaleFunction(sizes)

    def shrink() -> None:
        sizes.RemoveAllPoints()
        sizes.AddPoint(0, 0.2)
        sizes.AddPoint(1, 0.2)

    return prop, shrink


def make_cut_splats():
    """Return splats that shader code cuts off, and their sizes."""
    mapper = vtkPointGaussianMapper()
    mapper.EmissiveOff()
    mapper.SetSplatShaderCode(
        "//VTK::Color::Impl\n"
        "if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) { discard; }\n"
    )
    return make_balls(mapper)


@change
def cut_splat_sizes_in_place():
    prop, sizes = make_cut_splats()
    return prop, lambda: write(sizes, 0.2)


@change
def cut_splat_scale_factor():
    prop, _ = make_cut_splats()
    return prop, lambda: prop.GetMapper().SetScaleFactor(0.5)


def make_point_sphere():
    """Return a prop that draws one point as a sphere of a size in pixels."""
    prop, _ = make_balls(vtkOpenGLSphereMapper())
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(prop.GetMapper().GetInput())
    prop.SetMapper(mapper)
    prop.GetProperty().RenderPointsAsSpheresOn()
    prop.GetProperty().SetPointSize(30)
    return prop


@change
def point_sphere_size():
    prop = make_point_sphere()
    return prop, lambda: prop.GetProperty().SetPointSize(15)


@change
def point_sphere_moved():
    prop = make_point_sphere()
    points = prop.GetMapper().GetInput().GetPoints()

    def move() -> None:
        write(points.GetData(), np.array((0.4, 0.3, 0.2), np.float32))
        points.Modified()

    return prop, move


@change
def point_sphere_flat():
    prop = make_point_sphere()
    return prop, lambda: prop.GetProperty().RenderPointsAsSpheresOff()


def make_molecule():
    molecule = vtkMolecule()
    molecule.AppendAtom(8, 0, 0.5, 0)
    mapper = vtkMoleculeMapper()
    mapper.SetInputData(molecule)
    mapper.SetAtomicRadiusTypeToUnitRadius()
    mapper.SetAtomicRadiusScaleFactor(0.4)
    prop = vtkActor()
    prop.SetMapper(mapper)
    return prop, molecule


@change
def atom_moved():
    prop, molecule = make_molecule()

    def move() -> None:
        molecule.SetAtomPosition(0, 0.4, 0.3, 0.2)
        molecule.GetPoints().Modified()  # else VTK keeps the molecule's bounds

    return prop, move


@change
def atom_radius():
    prop, _ = make_molecule()
    return prop, lambda: prop.GetMapper().SetAtomicRadiusScaleFactor(0.2)


@change
def atom_element():
    prop, molecule = make_molecule()

    def turn() -> None:
        molecule.SetAtomAtomicNumber(0, 7)
        molecule.Modified()

    return prop, turn


@change
def block_points_in_place():
    prop, blocks, _ = make_blocks()

    def shrink() -> None:
        points = blocks.GetBlock(0).GetPoints()
        place = np.array((0, 0.5, 0))
        write(points.GetData(), (vtk_to_numpy(points.GetData()) - place) * 0.5 + place)
        points.Modified()

    return prop, shrink


@change
def block_replaced():
    prop, blocks, _ = make_blocks()
    older = make_ball(0.2)
    older.Update()
    return prop, lambda: blocks.SetBlock(0, older.GetOutput())


@change
def block_colors_removed():
    prop, blocks, attributes = make_blocks()
    attributes.SetBlockColor(blocks.GetBlock(0), BLUE)
    return prop, attributes.RemoveBlockColors
