# SPDX-License-Identifier: BSD-3-Clause
"""Changes of properties, textures and shader text."""

import numpy as np
from rooms import RED, make_actor, make_ball
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkInformation, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import vtkProp, vtkProperty, vtkTexture

from .parts import (
    BLUE,
    change,
    change_alone,
    make_halves,
    make_image,
    make_mesh,
    make_sheet,
    paint,
    write,
)


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


@change_alone
def texture_pixels():
    prop = make_actor(make_sheet(), (1, 1, 1))
    image = make_image(RED)
    texture = vtkTexture()
    texture.SetInputData(image)
    prop.SetTexture(texture)
    return prop, lambda: paint(image, BLUE)


@change_alone
def texture_pipeline():
    prop = make_actor(make_sheet(), (1, 1, 1))
    canvas = make_canvas()
    texture = vtkTexture()
    texture.SetInputConnection(canvas.GetOutputPort())
    prop.SetTexture(texture)
    return prop, lambda: fill(canvas, BLUE)


@change_alone
def texture_transform():
    prop = make_actor(make_sheet(), (1, 1, 1))
    transform = vtkTransform()
    prop.SetTexture(make_halves())
    prop.GetTexture().SetTransform(transform)
    return prop, lambda: transform.Translate(0.5, 0, 0)


@change_alone
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


@change_alone
def texture_older():
    older = make_image(BLUE)
    prop, _ = texture_pixels()
    prop.GetTexture().SetInputData(make_image(RED))
    return prop, lambda: prop.GetTexture().SetInputData(older)


@change_alone
def texture_removed():
    prop, _ = texture_pixels()

    def remove() -> None:
        prop.SetTexture(None)
        prop.GetProperty().Modified()  # else VTK keeps the shader that reads it, and draws black

    return prop, remove


@change_alone
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


@change_alone
def pbr_texture_pixels():
    prop = make_actor(make_sheet(), (1, 1, 1))
    image = make_image(RED)
    texture = vtkTexture()
    texture.UseSRGBColorSpaceOn()
    texture.SetInputData(image)
    prop.GetProperty().SetInterpolationToPBR()
    prop.GetProperty().SetBaseColorTexture(texture)
    return prop, lambda: paint(image, BLUE)


@change_alone
def property_color():
    prop = make_actor(make_ball())
    return prop, lambda: prop.GetProperty().SetColor(*BLUE)


@change_alone
def property_older():
    older = vtkProperty()
    older.SetColor(*BLUE)
    prop = make_actor(make_ball())
    return prop, lambda: prop.SetProperty(older)


@change_alone
def backface_property():
    prop = make_actor(make_sheet())
    back = vtkProperty()
    back.SetColor(*RED)
    prop.SetBackfaceProperty(back)

    def turn() -> None:
        prop.GetProperty().SetColor(*BLUE)
        back.SetColor(*BLUE)

    return prop, turn


@change_alone
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
