# SPDX-License-Identifier: BSD-3-Clause
"""Whatever VTK reads while it draws can change in place, or go: light follows at once.

Each change is made in a scene that has been drawn, and in one that has not; both must look alike.
"""

import unittest

import numpy as np
import support
from rooms import RED, make_actor, make_area, make_ball, make_mapper, make_room
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPlane,
)
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
    vtkLight,
    vtkLODProp3D,
    vtkPolyDataMapper,
    vtkProperty,
    vtkTexture,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor

import vtkindirect
from vtkindirect import windows, wrapped

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


# Other caches than those of maps ask the same place when a prop has changed: a few of each suffice.
SHAPES = ("plane_origin", "level_source", "user_matrix", "glyph_source")
SPHERES = ("property_color", "user_matrix", "ball_glyph_source", "part_removed")
WAYS = {
    "maps": (dict(method="auto", lighting="scene"), CHANGES),
    "voxels": (dict(method="gather", lighting="scene", visibility="voxels"), SHAPES),
    "hints": (dict(method="hints", lighting="scene"), ("texture_pixels", "plane_origin")),
    "spheres": (dict(method="proxies", lighting="scene", environment=(1, 1, 1)), SPHERES),
    "sky": (dict(method="auto", lighting="scene", environment=(1, 1, 1)), SHAPES),
}


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Stale(unittest.TestCase):
    def setUp(self) -> None:
        self.window = windows.render_window((32, 24), offscreen=True)

    def draw(self, make, live: bool):
        """The light and the picture of a scene after its change, which `make` gives with it."""
        renderer, turn = make()
        self.window.AddRenderer(renderer)
        if live:
            for _ in range(2):
                self.window.Render()
        turn()
        for _ in range(3):
            self.window.Render()
        light = vtkindirect.copy_buffer(renderer, "irradiance").astype(float)
        picture = vtkindirect.copy_buffer(renderer, "final").astype(float)
        self.window.RemoveRenderer(renderer)
        return light, picture

    def check(self, make) -> None:
        light, picture = self.draw(make, True)
        other, expected = self.draw(make, False)
        # A table of texels that are read in another order adds up to other last digits.
        self.assertLess(np.abs(light - other).max(), 1e-3 * other.max() + 1e-6)
        self.assertLess(np.abs(picture - expected).max(), 1e-3 * expected.max())

    def check_way(self, way: str) -> None:
        settings, names = WAYS[way]
        for name in names:
            with self.subTest(way=way, change=name):

                def make(name=name):
                    prop, turn = CHANGES[name]()
                    renderer = make_room(prop)
                    vtkindirect.enable(renderer, **settings)
                    return renderer, turn

                self.check(make)

    def test_maps(self) -> None:
        self.check_way("maps")

    def test_voxels(self) -> None:
        self.check_way("voxels")

    def test_hints(self) -> None:
        self.check_way("hints")

    def test_spheres(self) -> None:
        self.check_way("spheres")

    def test_sky(self) -> None:
        self.check_way("sky")

    def test_pictures_of_light(self) -> None:
        """Images and textures that send light: of an environment, of an area light and of the
        renderer."""
        for owner in ("environment", "renderer", "area light"):
            for how in ("pixels", "pipeline"):
                with self.subTest(owner=owner, how=how):

                    def make(owner=owner, how=how):
                        renderer = make_room(make_actor(make_ball()), False)
                        texture = vtkTexture()
                        texture.MipmapOn()
                        texture.InterpolateOn()
                        image, canvas = make_image(RED), make_canvas()
                        if how == "pixels":
                            texture.SetInputData(image)
                        else:
                            texture.SetInputConnection(canvas.GetOutputPort())
                        indirect = vtkindirect.enable(renderer, lighting="scene")
                        if owner == "area light":
                            light = make_area(0)
                            light.SetTexture(texture)
                            indirect.AddAreaLight(light)
                        elif owner == "environment":
                            sky = wrapped.get("vtkEnvironmentLight")()
                            sky.SetTexture(texture)
                            indirect.SetEnvironment(sky)
                        else:
                            renderer.UseImageBasedLightingOn()
                            renderer.SetEnvironmentTexture(texture)
                        return renderer, lambda: (
                            paint(image, BLUE) if how == "pixels" else fill(canvas, BLUE)
                        )

                    self.check(make)

    def test_what_has_gone(self) -> None:
        """The older and the newer of two is removed; an order in which nothing newer is left."""

        def area_light(renderer, indirect, number):
            lights = [make_area(-0.5), make_area(0.5, (1, 4, 1))]
            for light in lights:
                indirect.AddAreaLight(light)
            lights[1 - number].Modified()
            return lambda: indirect.RemoveAreaLight(lights[number])

        def all_area_lights(renderer, indirect, number):
            indirect.AddAreaLight(make_area(0))
            return indirect.RemoveAllAreaLights

        def light(renderer, indirect, number):
            other = vtkLight()
            other.SetPosition(-1, 2, -1)
            other.SetColor(0, 1, 0)
            other.SetLightTypeToSceneLight()
            renderer.AddLight(other)
            gone = renderer.GetLights().GetItemAsObject(number)
            return lambda: renderer.RemoveLight(gone)

        def sampler(renderer, indirect, number):
            samplers = []
            for x in (-0.5, 0.5):
                sampler = wrapped.get("vtkAreaLightSampler")()
                sampler.AddLight(make_area(x))
                indirect.AddSampler(sampler)
                samplers.append(sampler)
            return lambda: indirect.RemoveSampler(samplers[number])

        def light_of_sampler(renderer, indirect, number):
            sampler = wrapped.get("vtkAreaLightSampler")()
            lights = [make_area(-0.5), make_area(0.5)]
            for light in lights:
                sampler.AddLight(light)
            indirect.AddSampler(sampler)
            return lambda: sampler.RemoveLight(lights[number])

        def prop(renderer, indirect, number):
            props = [make_actor(make_ball()), make_actor(make_sheet())]
            for one in props:
                renderer.AddActor(one)
            return lambda: renderer.RemoveActor(props[number])

        def environment(renderer, indirect, number):
            sky = wrapped.get("vtkEnvironmentLight")()
            indirect.SetEnvironment(sky)
            return lambda: indirect.SetEnvironment(None)

        def coarse_level(renderer, indirect, number):
            fine = vtkSphereSource()
            fine.SetCenter(0, 0.5, 0)
            fine.SetRadius(0.4)
            fine.SetThetaResolution(40)
            fine.SetPhiResolution(40)
            prop = make_actor(fine)
            renderer.AddActor(prop)
            coarse = make_ball(0.3)
            coarse.Update()
            indirect.AddCoarseLevel(prop, coarse.GetOutput(), 0.0)
            return lambda: indirect.RemoveCoarseLevels(prop)

        for kind in (
            area_light,
            all_area_lights,
            light,
            sampler,
            light_of_sampler,
            prop,
            environment,
            coarse_level,
        ):
            for number in (0, 1):
                with self.subTest(kind=kind.__name__, number=number):

                    def make(kind=kind, number=number):
                        renderer = make_room()
                        indirect = vtkindirect.enable(renderer, lighting="scene")
                        return renderer, kind(renderer, indirect, number)

                    self.check(make)


if __name__ == "__main__":
    unittest.main()
