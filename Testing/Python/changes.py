# SPDX-License-Identifier: BSD-3-Clause
"""Changes, in place, of all that VTK reads while it draws a prop.

Each function of CHANGES returns a prop and a function that changes the prop.
"""

import numpy as np
from rooms import RED, make_actor, make_ball, make_mapper
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
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
    vtkPolyDataMapper,
    vtkProp,
    vtkProperty,
    vtkTexture,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor

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
