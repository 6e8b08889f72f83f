# SPDX-License-Identifier: BSD-3-Clause
"""Whatever VTK reads while it draws can change in place, or go: light follows at once.

Each change is made in a scene that has been drawn, and in one that has not; both must look alike.
"""

import unittest

import numpy as np
import support
from changes import (
    ALONE,
    BLUE,
    CHANGES,
    fill,
    make_canvas,
    make_image,
    make_sheet,
    paint,
    together,
)
from rooms import RED, make_actor, make_area, make_ball, make_mapper, make_room
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkPointSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkDataSetMapper,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkTexture,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor

import vtkindirect
from vtkindirect import windows, wrapped

# Other caches than those of maps ask the same place when a prop has changed: a few of each suffice,
# of shapes, and of colours where a cache holds them.
SHAPES = ("plane_origin", "level_source", "user_matrix", "glyph_source")
COLORS = (
    ("property_color", "texture_pixels", "lookup_table", "block_color"),
    ("custom_uniform", "scalars_in_place", "level_property", "property_diffuse"),
    ("array_selected", "cell_scalars_in_place", "texture_transform_input", "block_colors_removed"),
)
HINTS = (
    ("points_in_place", "glyph_source", "user_matrix", "block_points_in_place"),
    ("cells_replaced", "part_moved", "level_selected", "glyph_sizes_in_place"),
)
SPHERES = ("property_color", "user_matrix", "ball_glyph_source", "part_removed")
BALLS = (
    ("ball_sizes_in_place", "ball_radius", "ball_scalars_in_place", "glyph_scale_factor"),
    ("atom_moved", "atom_radius", "atom_element", "property_diffuse"),
)
# Changes that maps of a prop alone hold, in groups of four.
GROUPED = [name for name in CHANGES if name not in ALONE]
GROUPS = [GROUPED[first : first + 4] for first in range(0, len(GROUPED), 4)]
# Few lights: caches follow what has changed, not how many lights are drawn again.
FEW = dict(number_of_lights=32)
GATHER = dict(method="gather", lighting="scene", NumberOfBounces=1, number_of_lights=8)


def each(names):
    return [(name,) for name in names]


WAYS = {
    "maps": (dict(method="auto", lighting="scene", **FEW), each(ALONE)),
    "maps of one bounce": (GATHER, GROUPS),
    "voxels": (
        dict(method="gather", lighting="scene", visibility="voxels", **FEW),
        [*each(SHAPES), *COLORS],
    ),
    "hints": (
        dict(method="hints", lighting="scene"),
        [*each(("texture_pixels", "plane_origin")), *COLORS, *HINTS],
    ),
    "spheres": (
        dict(method="proxies", lighting="scene", environment=(1, 1, 1)),
        [*each(SPHERES), *BALLS],
    ),
    "sky": (
        dict(method="auto", lighting="scene", environment=(1, 1, 1)),
        [*each(SHAPES), *COLORS[:2]],
    ),
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

    def check(self, make, fresh=None) -> None:
        light, picture = self.draw(make, True)
        other, expected = self.draw(fresh or make, False)
        # A table of texels that are read in another order adds up to other last digits.
        self.assertLess(np.abs(light - other).max(), 1e-3 * other.max() + 1e-6)
        self.assertLess(np.abs(picture - expected).max(), 1e-3 * expected.max())

    def check_changes(self, settings: dict, names) -> None:
        def make():
            props, turn = together(names)
            renderer = make_room()
            for prop in props:
                renderer.AddViewProp(prop)
            vtkindirect.enable(renderer, **settings)
            return renderer, turn

        self.check(make)

    def check_way(self, way: str) -> None:
        settings, groups = WAYS[way]
        for names in groups:
            with self.subTest(way=way, changes=names):
                try:
                    self.check_changes(settings, names)
                except AssertionError:
                    for name in names:  # which of them?
                        with self.subTest(way=way, change=name):
                            self.check_changes(settings, (name,))
                    raise

    def test_maps(self) -> None:
        self.check_way("maps")

    def test_maps_of_one_bounce(self) -> None:
        self.check_way("maps of one bounce")

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

    def count_faces(self, renderer) -> int:
        """Return the number of maps' faces drawn until now, after another frame."""
        self.window.Render()
        return vtkindirect.report(renderer)["counters"]["faces_drawn"]

    def test_levels_of_level_actors(self) -> None:
        """The time of drawing decides which level VTK draws, so maps follow all of them."""
        level = make_ball(0.3)
        prop = vtkLODActor()
        prop.SetMapper(make_mapper(make_ball()))
        prop.AddLODMapper(make_mapper(level))
        renderer = make_room(prop)
        vtkindirect.enable(renderer, lighting="scene")
        self.window.AddRenderer(renderer)
        drawn = [self.count_faces(renderer) for _ in range(2)]
        self.assertEqual(drawn[0], drawn[1])
        level.SetRadius(0.2)
        self.assertGreater(self.count_faces(renderer), drawn[1])

    def test_static_mappers(self) -> None:
        """VTK draws what a static mapper's data are, and runs the pipeline of polygons alone that a
        vtkDataSetMapper draws."""
        for kind, runs in (
            (vtkPolyDataMapper, False),
            (vtkGlyph3DMapper, False),
            (vtkDataSetMapper, True),
        ):
            for pipeline in ("polygons", "grid"):
                if pipeline == "grid" and kind is not vtkDataSetMapper:
                    continue
                with self.subTest(kind=kind.__name__, pipeline=pipeline):
                    ball = make_ball()
                    grid = vtkAppendFilter()
                    grid.SetInputConnection(ball.GetOutputPort())
                    source = grid if pipeline == "grid" else ball
                    mapper = kind()
                    if kind is vtkGlyph3DMapper:
                        place = vtkPointSource()
                        place.SetNumberOfPoints(1)
                        place.SetRadius(0)
                        mapper.SetInputConnection(place.GetOutputPort())
                        mapper.SetSourceConnection(ball.GetOutputPort())
                    else:
                        mapper.SetInputConnection(source.GetOutputPort())
                    mapper.Update()
                    mapper.StaticOn()
                    prop = vtkActor()
                    prop.SetMapper(mapper)
                    renderer = make_room(prop)
                    vtkindirect.enable(renderer, lighting="scene")
                    self.window.AddRenderer(renderer)
                    drawn = self.count_faces(renderer)
                    before = vtkindirect.copy_buffer(renderer, "final").astype(float)
                    ball.SetRadius(0.2)
                    again = self.count_faces(renderer)
                    after = vtkindirect.copy_buffer(renderer, "final").astype(float)
                    self.window.RemoveRenderer(renderer)
                    if runs and pipeline == "polygons":
                        self.assertGreater(again, drawn)
                        self.assertGreater(np.abs(after - before).max(), 0.1)
                    else:
                        self.assertEqual(again, drawn)
                        self.assertEqual(np.abs(after - before).max(), 0)

    def test_an_area_light_that_is_off_counts_as_removed(self) -> None:
        """The other light keeps its bounce: 6 % less where the light that is off took places."""

        def make(removes):
            renderer = make_room()
            indirect = vtkindirect.enable(renderer, lighting="scene")
            lights = [make_area(-0.5), make_area(0.5, (1, 4, 1))]
            for light in lights:
                indirect.AddAreaLight(light)
            gone = lights[0]
            return renderer, lambda: (
                indirect.RemoveAreaLight(gone) if removes else gone.SwitchOff()
            )

        self.check(lambda: make(False), lambda: make(True))

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
