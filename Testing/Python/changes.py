# SPDX-License-Identifier: BSD-3-Clause
"""Changes, in place, of all that VTK reads while it draws a prop.

Each function of CHANGES returns a prop and a function that changes the prop; `together` makes
several of them at once.
"""

import numpy as np
from rooms import RED, make_actor, make_ball, make_mapper
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMolecule,
    vtkMultiBlockDataSet,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkPolyData,
)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkDomainsChemistry import vtkMoleculeMapper
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkPlaneSource,
    vtkPointSource,
    vtkSphereSource,
)
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkColorTransferFunction,
    vtkCompositeDataDisplayAttributes,
    vtkCompositePolyDataMapper,
    vtkGlyph3DMapper,
    vtkLODProp3D,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
    vtkProp,
    vtkProp3D,
    vtkPropAssembly,
    vtkProperty,
    vtkTexture,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

# Until VTK 9.2 another class draws blocks by their attributes.
if hasattr(vtkCompositePolyDataMapper, "SetCompositeDataDisplayAttributes"):
    CompositeMapper = vtkCompositePolyDataMapper
else:
    CompositeMapper = vtkRenderingOpenGL2.vtkCompositePolyDataMapper2

BLUE = (0.1, 0.1, 0.9)


def make_sheet() -> vtkPlaneSource:
    sheet = vtkPlaneSource()
    sheet.SetOrigin(-0.5, 0.1, 0)
    sheet.SetPoint1(-0.5, 0.9, 0)
    sheet.SetPoint2(0.5, 0.1, 0)
    return sheet


def make_image(color) -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(4, 4, 1)
    pixels = np.full((16, 3), np.array(color) * 255, np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    return image


def paint(image: vtkImageData, color) -> None:
    scalars = image.GetPointData().GetScalars()
    vtk_to_numpy(scalars)[:] = np.array(color) * 255
    scalars.Modified()


def fill(canvas: vtkImageCanvasSource2D, color) -> None:
    canvas.SetDrawColor(*(255 * component for component in color))
    canvas.FillBox(0, 3, 0, 3)


def make_canvas() -> vtkImageCanvasSource2D:
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetNumberOfScalarComponents(3)
    canvas.SetExtent(0, 3, 0, 3, 0, 0)
    fill(canvas, RED)
    return canvas


# Each makes a prop and what changes it.
CHANGES = {}


def change(function):
    CHANGES[function.__name__] = function
    return function


@change
def plane_origin():
    prop = make_actor(make_ball())
    plane = vtkPlane()
    plane.SetOrigin(0, 0.5, 0)
    plane.SetNormal(1, 0, 0)
    prop.GetMapper().AddClippingPlane(plane)
    return prop, lambda: plane.SetOrigin(0.3, 0.5, 0)


@change
def plane_normal():
    prop, _ = plane_origin()
    return prop, lambda: prop.GetMapper().GetClippingPlanes().GetItem(0).SetNormal(-1, 0, 0)


@change
def plane_removed():
    prop, _ = plane_origin()
    return prop, lambda: prop.GetMapper().RemoveAllClippingPlanes()


@change
def texture_pixels():
    prop = make_actor(make_sheet(), (1, 1, 1))
    image = make_image(RED)
    texture = vtkTexture()
    texture.SetInputData(image)
    prop.SetTexture(texture)
    return prop, lambda: paint(image, BLUE)


@change
def texture_pipeline():
    prop = make_actor(make_sheet(), (1, 1, 1))
    canvas = make_canvas()
    texture = vtkTexture()
    texture.SetInputConnection(canvas.GetOutputPort())
    prop.SetTexture(texture)
    return prop, lambda: fill(canvas, BLUE)


def make_halves() -> vtkTexture:
    """A texture with a red and a blue half."""
    image = vtkImageData()
    image.SetDimensions(2, 1, 1)
    pixels = np.array((RED, BLUE)) * 255
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.astype(np.uint8), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    return texture


@change
def texture_transform():
    prop = make_actor(make_sheet(), (1, 1, 1))
    transform = vtkTransform()
    prop.SetTexture(make_halves())
    prop.GetTexture().SetTransform(transform)
    return prop, lambda: transform.Translate(0.5, 0, 0)


@change
def texture_matrix():
    prop = make_actor(make_sheet(), (1, 1, 1))
    prop.SetTexture(make_halves())
    prop.SetPropertyKeys(vtkInformation())

    def place(x: float) -> None:
        matrix = np.eye(4)
        matrix[0, 3] = x
        prop.GetPropertyKeys().Set(vtkProp.GeneralTextureTransform(), matrix.ravel(), 16)

    place(0)
    return prop, lambda: place(0.5)


@change
def texture_older():
    older = make_image(BLUE)
    prop, _ = texture_pixels()
    prop.GetTexture().SetInputData(make_image(RED))
    return prop, lambda: prop.GetTexture().SetInputData(older)


@change
def texture_removed():
    prop, _ = texture_pixels()

    def remove() -> None:
        prop.SetTexture(None)
        prop.GetProperty().Modified()  # else VTK keeps the shader that reads it, and draws black

    return prop, remove


@change
def texture_table():
    prop = make_actor(make_sheet(), (1, 1, 1))
    image = vtkImageData()
    image.SetDimensions(4, 4, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.zeros(16, np.float32), deep=True))
    table = vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.SetTableValue(0, *RED, 1)
    table.SetTableValue(1, *RED, 1)
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetLookupTable(table)
    prop.SetTexture(texture)
    return prop, lambda: table.SetTableValue(0, *BLUE, 1)


@change
def pbr_texture_pixels():
    prop = make_actor(make_sheet(), (1, 1, 1))
    image = make_image(RED)
    texture = vtkTexture()
    texture.UseSRGBColorSpaceOn()
    texture.SetInputData(image)
    prop.GetProperty().SetInterpolationToPBR()
    prop.GetProperty().SetBaseColorTexture(texture)
    return prop, lambda: paint(image, BLUE)


@change
def property_color():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetColor(*BLUE)


@change
def property_older():
    older = vtkProperty()
    older.SetColor(*BLUE)
    prop = make_actor(make_ball())
    return prop, lambda: prop.SetProperty(older)


@change
def backface_property():
    prop = make_actor(make_sheet())
    back = vtkProperty()
    back.SetColor(*RED)
    prop.SetBackfaceProperty(back)

    def turn() -> None:
        prop.GetProperty().SetColor(*BLUE)
        back.SetColor(*BLUE)

    return prop, turn


@change
def level_property():
    prop = vtkLODProp3D()
    look = vtkProperty()
    look.SetColor(*RED)
    prop.AddLOD(make_mapper(make_ball()), look, 0.0)
    return prop, lambda: look.SetColor(*BLUE)


@change
def level_source():
    prop = vtkLODProp3D()
    ball = make_ball()
    look = vtkProperty()
    look.SetColor(*RED)
    prop.AddLOD(make_mapper(ball), look, 0.0)
    return prop, lambda: ball.SetRadius(0.2)


@change
def level_actor_property():
    prop = vtkLODActor()
    prop.SetMapper(make_mapper(make_ball()))
    prop.GetProperty().SetColor(*RED)
    return prop, lambda: prop.GetProperty().SetColor(*BLUE)


@change
def part_property():
    prop = vtkAssembly()
    part = make_actor(make_ball())
    prop.AddPart(part)
    return prop, lambda: part.GetProperty().SetColor(*BLUE)


@change
def part_removed():
    prop = vtkAssembly()
    prop.AddPart(make_actor(make_ball(0.2)))
    part = make_actor(make_ball())
    prop.AddPart(part)
    return prop, lambda: prop.RemovePart(part)


@change
def user_transform():
    prop = make_actor(make_ball(0.2))
    transform = vtkTransform()
    prop.SetUserTransform(transform)
    return prop, lambda: transform.Translate(0.4, 0, 0)


@change
def user_matrix():
    prop = make_actor(make_ball(0.2))
    matrix = vtkMatrix4x4()
    prop.SetUserMatrix(matrix)
    return prop, lambda: matrix.SetElement(0, 3, 0.4)


def make_scalars(table):
    ball = make_ball()
    ball.Update()
    mesh = ball.GetOutput()
    count = mesh.GetNumberOfPoints()
    mesh.GetPointData().SetScalars(numpy_to_vtk(np.full(count, 0.5, np.float32), deep=True))
    prop = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(table)
    prop.SetMapper(mapper)
    return prop, mesh


@change
def lookup_table():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(1)
    table.SetTableValue(0, *RED, 1)
    return make_scalars(table)[0], lambda: table.SetTableValue(0, *BLUE, 1)


@change
def color_transfer_function():
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0, *RED)
    colors.AddRGBPoint(1, *RED)

    def turn() -> None:
        colors.RemoveAllPoints()
        colors.AddRGBPoint(0, *BLUE)

    return make_scalars(colors)[0], turn


@change
def scalars_in_place():
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0.5, *RED)
    colors.AddRGBPoint(1, *BLUE)
    prop, mesh = make_scalars(colors)

    def turn() -> None:
        scalars = mesh.GetPointData().GetScalars()
        vtk_to_numpy(scalars)[:] = 1
        scalars.Modified()

    return prop, turn


@change
def points_in_place():
    ball = make_ball()
    ball.Update()
    mesh = ball.GetOutput()
    prop = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)

    def shrink() -> None:
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points[:] = (points - (0, 0.5, 0)) * 0.5 + (0, 0.5, 0)
        mesh.GetPoints().Modified()

    return prop, shrink


@change
def custom_uniform():
    prop = make_actor(make_ball())
    shaders = prop.GetShaderProperty()
    shaders.AddFragmentShaderReplacement(
        "//VTK::Color::Impl",
        True,
        "//VTK::Color::Impl\n  diffuseColor = vec3(red, 0.1, 1.0 - red);\n",
        False,
    )
    uniforms = shaders.GetFragmentCustomUniforms()
    uniforms.SetUniformf("red", 0.9)
    return prop, lambda: uniforms.SetUniformf("red", 0.1)


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


@change
def glyph_source():
    prop, source = make_glyphs()
    return prop, lambda: source.SetXLength(0.2)


@change
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


@change
def block_color():
    prop, blocks, attributes = make_blocks()
    return prop, lambda: attributes.SetBlockColor(blocks.GetBlock(0), BLUE)


@change
def block_hidden():
    prop, blocks, attributes = make_blocks()
    ball = vtkSphereSource()
    ball.SetCenter(0.4, 0.2, 0.3)
    ball.SetRadius(0.2)
    ball.Update()
    blocks.SetBlock(1, ball.GetOutput())
    return prop, lambda: attributes.SetBlockVisibility(blocks.GetBlock(0), False)


@change
def hidden():
    prop = make_actor(make_ball())
    return prop, lambda: prop.VisibilityOff()


# The changes above are drawn one by one, those below in groups.
ALONE = tuple(CHANGES)


def make_mesh(ball=None):
    """Return a prop with data of its own, and the data."""
    ball = ball or make_ball()
    ball.Update()
    mesh = ball.GetOutput()
    prop = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)
    return prop, mesh


def write(array, values) -> None:
    vtk_to_numpy(array)[:] = values
    array.Modified()


@change
def normals_in_place():
    prop, mesh = make_mesh()
    return prop, lambda: write(mesh.GetPointData().GetNormals(), (0, 1, 0))


@change
def coordinates_in_place():
    prop, mesh = make_mesh(make_sheet())
    prop.SetTexture(make_halves())
    prop.GetProperty().SetColor(1, 1, 1)
    return prop, lambda: write(mesh.GetPointData().GetTCoords(), (1, 0))


@change
def cells_in_place():
    prop, mesh = make_mesh()

    def cut() -> None:
        cells = mesh.GetPolys()
        points = vtk_to_numpy(cells.GetConnectivityArray())
        points[: len(points) // 2] = points[0]
        cells.GetConnectivityArray().Modified()
        cells.Modified()

    return prop, cut


@change
def cells_replaced():
    prop, mesh = make_mesh()
    half = vtkCellArray()
    half.DeepCopy(mesh.GetPolys())
    half.ResizeExact(half.GetNumberOfCells() // 2, 3 * (half.GetNumberOfCells() // 2))
    return prop, lambda: mesh.SetPolys(half)


@change
def input_older():
    older = make_ball(0.2)
    older.Update()
    prop, _ = make_mesh()
    return prop, lambda: prop.GetMapper().SetInputData(older.GetOutput())


@change
def mapper_older():
    older = make_mapper(make_ball(0.2))
    prop = make_actor(make_ball())
    return prop, lambda: prop.SetMapper(older)


@change
def plane_added():
    prop = make_actor(make_ball())
    plane = vtkPlane()
    plane.SetOrigin(0, 0.5, 0)
    plane.SetNormal(1, 0, 0)
    return prop, lambda: prop.GetMapper().AddClippingPlane(plane)


def make_table(*colors) -> vtkLookupTable:
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    for number, color in enumerate(colors):
        table.SetTableValue(number, *color, 1)
    return table


@change
def scalar_visibility():
    prop, _ = make_scalars(make_table(RED))
    prop.GetProperty().SetColor(*BLUE)
    return prop, lambda: prop.GetMapper().ScalarVisibilityOff()


@change
def array_selected():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    count = mesh.GetNumberOfPoints()
    for name, value in (("first", 0.2), ("second", 0.8)):
        array = numpy_to_vtk(np.full(count, value, np.float32), deep=True)
        array.SetName(name)
        mesh.GetPointData().AddArray(array)
    prop.GetMapper().SetScalarModeToUsePointFieldData()
    prop.GetMapper().SelectColorArray("first")
    return prop, lambda: prop.GetMapper().SelectColorArray("second")


@change
def cell_scalars_in_place():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    values = numpy_to_vtk(np.full(mesh.GetNumberOfCells(), 0.2, np.float32), deep=True)
    mesh.GetCellData().SetScalars(values)
    prop.GetMapper().SetScalarModeToUseCellData()
    return prop, lambda: write(values, 0.8)


@change
def scalar_range():
    prop, _ = make_scalars(make_table(RED, BLUE))
    prop.GetMapper().SetScalarRange(0.4, 2)
    return prop, lambda: prop.GetMapper().SetScalarRange(-1, 0.6)


@change
def table_range():
    table = make_table(RED, BLUE)
    table.SetTableRange(0.4, 2)
    prop, _ = make_scalars(table)
    prop.GetMapper().UseLookupTableScalarRangeOn()
    return prop, lambda: table.SetTableRange(-1, 0.6)


@change
def table_of_missing_values():
    table = make_table(BLUE)
    table.SetNanColor(*RED, 1)
    prop, mesh = make_scalars(table)
    write(mesh.GetPointData().GetScalars(), np.nan)
    return prop, lambda: table.SetNanColor(*BLUE, 1)


@change
def array_component():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    values = np.full((mesh.GetNumberOfPoints(), 2), (0.2, 0.8), np.float32)
    array = numpy_to_vtk(values, deep=True)
    array.SetName("both")
    mesh.GetPointData().AddArray(array)
    mapper = prop.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.GetLookupTable().SetVectorModeToComponent()
    mapper.ColorByArrayComponent("both", 0)
    return prop, lambda: mapper.ColorByArrayComponent("both", 1)


@change
def attribute_of_vertices():
    """Shader text reads an array of the data by a name that the mapper gives it."""
    prop, mesh = make_mesh()
    values = numpy_to_vtk(np.full(mesh.GetNumberOfPoints(), 0.9, np.float32), deep=True)
    values.SetName("red")
    mesh.GetPointData().AddArray(values)
    prop.GetMapper().MapDataArrayToVertexAttribute("redMC", "red", 0, -1)
    shaders = prop.GetShaderProperty()
    for stage, tag, text in (
        ("Vertex", "Dec", "in float redMC;\nout float redVSOutput;\n"),
        ("Vertex", "Impl", "  redVSOutput = redMC;\n"),
        ("Fragment", "Dec", "in float redVSOutput;\n"),
        ("Fragment", "Impl", "  diffuseColor = vec3(redVSOutput, 0.1, 1.0 - redVSOutput);\n"),
    ):
        where = "//VTK::Color::" if stage == "Fragment" else "//VTK::Normal::"
        add = getattr(shaders, f"Add{stage}ShaderReplacement")
        add(where + tag, True, f"{where}{tag}\n{text}", False)
    return prop, lambda: write(values, 0.1)


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


@change
def property_diffuse():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetDiffuse(0.2)


@change
def property_diffuse_color():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetDiffuseColor(*BLUE)


@change
def property_specular():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetSpecular(0.8)


@change
def property_opacity():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetOpacity(0.5)


@change
def property_interpolation():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetInterpolationToFlat()


@change
def property_metallic():
    prop = make_actor(make_ball())
    prop.GetProperty().SetInterpolationToPBR()
    return prop, lambda: prop.GetProperty().SetMetallic(0.9)


@change
def property_lighting():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().LightingOff()


@change
def property_representation():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetRepresentationToWireframe()


@change
def property_front_faces():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().FrontfaceCullingOn()


@change
def backface_property_added():
    prop = make_actor(make_ball())
    prop.GetProperty().FrontfaceCullingOn()  # so that the back is seen
    back = vtkProperty()
    back.SetColor(*BLUE)
    return prop, lambda: prop.SetBackfaceProperty(back)


@change
def backface_property_removed():
    prop, _ = backface_property()
    prop.GetBackfaceProperty().SetColor(*BLUE)

    def remove() -> None:
        prop.SetBackfaceProperty(None)
        prop.GetProperty().Modified()  # else VTK keeps the shader that reads it, and crashes

    return prop, remove


def make_pbr_texture(name: str, older, newer, srgb: bool = False):
    """Return a metal sheet with a texture of VTK's PBR, and what paints it."""
    prop, mesh = make_mesh(make_sheet())
    tangents = np.tile(np.float32((1, 0, 0)), (mesh.GetNumberOfPoints(), 1))
    mesh.GetPointData().SetTangents(numpy_to_vtk(tangents, deep=True))
    image = make_image(older)
    texture = vtkTexture()
    texture.SetUseSRGBColorSpace(srgb)
    texture.SetInputData(image)
    look = prop.GetProperty()
    look.SetInterpolationToPBR()
    look.SetRoughness(1)
    look.SetMetallic(1)
    getattr(look, f"Set{name}Texture")(texture)
    return prop, lambda: paint(image, newer)


@change
def texture_of_emission():
    return make_pbr_texture("Emissive", (0, 0, 0), RED, True)


@change
def texture_of_metal():
    return make_pbr_texture("ORM", (1, 0.5, 0), (1, 0.5, 1))


@change
def texture_of_normals():
    return make_pbr_texture("Normal", (0.5, 0.5, 1), (0.8, 0.5, 0.8))


@change
def texture_wrap():
    prop, mesh = make_mesh(make_sheet())
    prop.SetTexture(make_halves())
    prop.GetProperty().SetColor(1, 1, 1)
    write(mesh.GetPointData().GetTCoords(), (1.3, 0))
    return prop, lambda: prop.GetTexture().SetWrap(vtkTexture.ClampToEdge)


@change
def texture_transform_input():
    prop = make_actor(make_sheet(), (1, 1, 1))
    inner = vtkTransform()
    transform = vtkTransform()
    transform.SetInput(inner)
    prop.SetTexture(make_halves())
    prop.GetTexture().SetTransform(transform)
    return prop, lambda: inner.Translate(0.5, 0, 0)


@change
def user_transform_input():
    prop = make_actor(make_ball(0.2))
    inner = vtkTransform()
    transform = vtkTransform()
    transform.SetInput(inner)
    prop.SetUserTransform(transform)
    return prop, lambda: inner.Translate(0.4, 0, 0)


@change
def user_matrix_removed():
    prop, _ = user_matrix()
    prop.GetUserMatrix().SetElement(0, 3, 0.4)
    return prop, lambda: prop.SetUserMatrix(None)


@change
def assembly_moved():
    prop = vtkAssembly()
    prop.AddPart(make_actor(make_ball(0.2)))
    return prop, lambda: prop.SetPosition(0.4, 0, 0)


@change
def part_moved():
    prop = vtkAssembly()
    part = make_actor(make_ball(0.2))
    prop.AddPart(part)
    return prop, lambda: part.SetPosition(0.4, 0, 0)


@change
def part_of_a_part_moved():
    prop = vtkAssembly()
    inner = vtkAssembly()
    part = make_actor(make_ball(0.2))
    inner.AddPart(part)
    prop.AddPart(inner)
    return prop, lambda: inner.SetPosition(0.4, 0, 0)


@change
def part_of_a_group_moved():
    prop = vtkPropAssembly()
    part = make_actor(make_ball(0.2))
    prop.AddPart(part)
    return prop, lambda: part.SetPosition(0.4, 0, 0)


@change
def level_texture():
    prop = vtkLODProp3D()
    image = make_image(RED)
    texture = vtkTexture()
    texture.SetInputData(image)
    prop.AddLOD(make_mapper(make_sheet()), vtkProperty(), texture, 0.0)
    return prop, lambda: paint(image, BLUE)


def make_levels():
    """Return a prop with two levels of which the first is drawn, and their numbers."""
    prop = vtkLODProp3D()
    prop.AutomaticLODSelectionOff()
    look = vtkProperty()
    look.SetColor(*RED)
    numbers = [prop.AddLOD(make_mapper(make_ball(size)), look, 0.0) for size in (0.4, 0.2)]
    prop.SetSelectedLODID(numbers[0])
    return prop, numbers


@change
def level_selected():
    prop, numbers = make_levels()
    return prop, lambda: prop.SetSelectedLODID(numbers[1])


@change
def level_removed():
    prop, numbers = make_levels()

    def remove() -> None:
        prop.RemoveLOD(numbers[0])
        prop.SetSelectedLODID(numbers[1])

    return prop, remove


BLUE_TEXT = "//VTK::Color::Impl\n  diffuseColor = vec3(0.1, 0.1, 0.9);\n"


@change
def shader_text_added():
    prop = make_actor(make_ball())
    shaders = prop.GetShaderProperty()
    return prop, lambda: shaders.AddFragmentShaderReplacement(
        "//VTK::Color::Impl", True, BLUE_TEXT, False
    )


@change
def shader_text_cleared():
    prop, add = shader_text_added()
    add()
    return prop, prop.GetShaderProperty().ClearAllFragmentShaderReplacements


@change
def vertex_uniform():
    prop = make_actor(make_ball())
    shaders = prop.GetShaderProperty()
    shaders.AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl",
        True,
        "//VTK::PositionVC::Impl\n"
        "  gl_Position = MCDCMatrix * (vertexMC + vec4(shift, 0.0, 0.0, 0.0));\n",
        False,
    )
    uniforms = shaders.GetVertexCustomUniforms()
    uniforms.SetUniformf("shift", 0)
    return prop, lambda: uniforms.SetUniformf("shift", 0.4)


def together(names):
    """Return the props of changes, at half their size beside each other, and what changes all."""
    props, turns = [], []
    for number, name in enumerate(names):
        prop, turn = CHANGES[name]()
        if len(names) > 1 and isinstance(prop, vtkProp3D):
            prop.SetScale(0.5)
            prop.AddPosition((-0.5, 0.5)[number % 2], (0, 0.6)[number // 2], 0)
        props.append(prop)
        turns.append(turn)

    def turn_all() -> None:
        for turn in turns:
            turn()

    return props, turn_all
