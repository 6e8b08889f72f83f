# SPDX-License-Identifier: BSD-3-Clause
"""Light and shadow where surfaces meet, and on few triangles with interpolated normals."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
)

import support  # noqa: F401
import vtkindirect

TEXELS = 512
"""Along an edge of a light's map, by default."""


def mesh(points, faces, smooth=False) -> vtkActor:
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.asarray(points, np.float32), deep=1))
    cells = vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    data.SetPoints(places)
    data.SetPolys(cells)
    if smooth:
        normals = vtkPolyDataNormals()
        normals.SetInputData(data)
        normals.SplittingOff()
        normals.Update()
        data = normals.GetOutput()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def cube(smooth: bool, center=(0.0, 0.0, 0.0)) -> vtkActor:
    corners = [[(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5] for i in range(8)]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return mesh(np.add(corners, center), faces, smooth)


def ball(center, facets=32) -> vtkActor:
    source = vtkSphereSource()
    source.SetRadius(0.6)
    source.SetCenter(center)
    source.SetThetaResolution(facets)
    source.SetPhiResolution(facets)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


class Scene:
    """Picture of actors under a sun."""

    def __init__(self, case, actors, sun, position, focal, size, up=(0, 0, 1)):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        for actor in actors:
            self.renderer.AddActor(actor)
        if sun is not None:
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            light.SetPosition(*sun)
            self.renderer.AddLight(light)
        self.window = vtkindirect.render_window(size, offscreen=True)
        self.window.AddRenderer(self.renderer)
        self.window.SetDesiredUpdateRate(1e-4)
        case.addCleanup(self.window.Finalize)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*position)
        camera.SetFocalPoint(*focal)
        camera.SetViewUp(*up)
        self.renderer.ResetCameraClippingRange()
        self.indirect = vtkindirect.enable(self.renderer, lighting="scene", antialiasing=False)

    def add_spot(self, position, focal, cone: float, exponent: float) -> None:
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetPosition(*position)
        lamp.SetFocalPoint(*focal)
        lamp.SetConeAngle(cone)
        lamp.SetExponent(exponent)
        self.renderer.AddLight(lamp)

    def read(self, name: str) -> np.ndarray:
        return np.array(vtkindirect.copy_buffer(self.renderer, name))

    def places(self) -> np.ndarray:
        """Return where each pixel's surface is; rows from below."""
        depth = self.read("depth")[:, :, :1]
        camera = self.renderer.GetActiveCamera()
        height, width = depth.shape[:2]
        tangent = np.tan(np.radians(camera.GetViewAngle() / 2.0))
        y, x = np.mgrid[:height, :width]
        ahead = np.array(camera.GetDirectionOfProjection())
        right = np.cross(ahead, camera.GetViewUp())
        right /= np.linalg.norm(right)
        across = ((x + 0.5) / width * 2.0 - 1.0)[..., None] * tangent * width / height
        above = ((y + 0.5) / height * 2.0 - 1.0)[..., None] * tangent
        way = ahead + across * right + above * np.cross(right, ahead)
        return np.where(depth > 0.0, np.array(camera.GetPosition()) + depth * way, np.nan)


def wrinkle(smooth: np.ndarray, reach: int = 2) -> np.ndarray:
    """Return how far each pixel is from the median around it, over that or a tenth of the most."""
    padded = np.pad(smooth, reach, mode="edge")
    width = 2 * reach + 1
    around = np.lib.stride_tricks.sliding_window_view(padded, (width, width))
    middle = np.median(around.reshape(*smooth.shape, -1), -1)
    return np.abs(smooth - middle) / np.maximum(middle, 0.1 * np.nanmax(smooth))


class Contact(unittest.TestCase):
    def test_no_light_gets_under_a_thin_wall(self) -> None:
        # A wall at x = 1 on a floor at y = 0, the sun behind it, seen from before it.
        floor_ends = {"at the wall": 1.0, "beyond it": 2.0}
        for name, end in floor_ends.items():
            with self.subTest(floor=name):
                floor = mesh([[-1, 0, 1], [end, 0, 1], [end, 0, -1], [-1, 0, -1]], [[0, 1, 2, 3]])
                wall = mesh([[1, 0, -1], [1, 0, 1], [1, 2, 1], [1, 2, -1]], [[0, 1, 2, 3]])
                sun = np.array([1.4, 5.0, 1.0])
                position, focal = (-0.2, 1.5, 3.0), (0.7, 0.0, 0.0)
                scene = Scene(self, [floor, wall], sun, position, focal, (400, 300), (0, 1, 0))
                scene.window.Render()
                place = scene.places()
                steps = (1.0 - place[..., 0]) / sun[0]
                meets = place + steps[..., None] * sun
                # The map sees the scene's sphere at most: width of a texel across the light.
                texel = 2.0 * np.linalg.norm([0.5 * (end + 1.0), 1.0, 1.0]) / TEXELS
                # Look-ups reach one of them, on the wall over the cosine of the light.
                margin = 1.05 * texel / (sun[0] / np.linalg.norm(sun))
                hidden = (
                    (np.abs(place[..., 1]) < 1e-3)
                    & (steps > 0.0)
                    & (meets[..., 1] < 2.0 - margin)
                    & (np.abs(meets[..., 2]) < 1.0 - margin)
                    & (place[..., 0] < 1.0 - 0.1 * texel)
                )
                foot = hidden & (place[..., 0] > 0.97)
                lit = scene.read("direct").max(-1) > 0.05
                print(
                    f"floor {name}: hidden {hidden.sum()}, lit {(lit & hidden).sum()}; "
                    f"at the foot {foot.sum()}, lit {(lit & foot).sum()}"
                )
                self.assertGreater(foot.sum(), 200)
                self.assertEqual((lit & hidden).sum(), 0)

    def test_a_shadow_ends_within_a_texel_of_its_edge(self) -> None:
        # A square above a floor, turned so that its edges cross the map's rows at a slant.
        floor = mesh([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], [[0, 1, 2, 3]])
        turn = np.radians(20.0)
        along = np.array([np.cos(turn), 0.0, np.sin(turn)])
        across = np.array([-np.sin(turn), 0.0, np.cos(turn)])
        middle = np.array([0.1, 0.5, 0.0])
        corners = [
            middle + 0.4 * (x * along + y * across) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
        roof = mesh(corners, [[0, 1, 2, 3]])
        for sun in ([0.2, 1.0, 0.1], [1.0, 2.0, -0.5], [1.0, 0.7, 0.2]):
            with self.subTest(sun=sun):
                position, focal = (0.0, 1.2, 2.4), (-0.2, 0.0, 0.0)
                scene = Scene(self, [floor, roof], sun, position, focal, (500, 500), (0, 1, 0))
                scene.window.Render()
                place = scene.places()
                on_floor = np.abs(place[..., 1]) < 1e-3
                meets = place + 0.5 / sun[1] * np.array(sun) - middle
                beyond = np.maximum(np.abs(meets @ along), np.abs(meets @ across)) - 0.4
                # The map sees the scene's sphere at most; the roof sees its texels at a slant.
                slant = sun[1] / np.linalg.norm(sun)
                texel = 2.0 * np.linalg.norm([1.0, 0.25, 1.0]) / TEXELS / slant
                share = scene.read("direct").max(-1) / slant
                outside = share[on_floor & (beyond > 1.05 * texel)]
                inside = share[on_floor & (beyond < -1.05 * texel)]
                print(f"sun {sun}: outside {outside.min():.3f}, inside {inside.max():.3f}")
                self.assertGreater(min(outside.size, inside.size), 1000)
                self.assertGreater(outside.min(), 0.999)
                self.assertEqual(inside.max(), 0.0)

    def test_maps_are_as_fine_as_the_frame(self) -> None:
        floor = mesh([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], [[0, 1, 2, 3]])
        sun, position, focal = (0.2, 1.0, 0.1), (0.0, 1.2, 2.4), (0.0, 0.0, 0.0)
        for asked, size, texels in ((0, 384, 512), (0, 400, 1024), (0, 600, 2048), (256, 600, 256)):
            with self.subTest(asked=asked, size=size):
                scene = Scene(self, [floor], sun, position, focal, (size, 60), (0, 1, 0))
                scene.indirect.SetReflectiveShadowMapResolution(asked)
                scene.window.Render()
                settings = vtkindirect.report(scene.renderer)["settings"]
                self.assertEqual(settings["ReflectiveShadowMapResolution"], texels)

    def test_a_wall_is_lit_down_to_its_foot(self) -> None:
        floor = mesh([[-1, 0, 2], [1, 0, 2], [1, 0, 0], [-1, 0, 0]], [[0, 1, 2, 3]])
        wall = mesh([[-1, 0, 0], [1, 0, 0], [1, 2, 0], [-1, 2, 0]], [[0, 1, 2, 3]])
        for sun in ([0.6, 2.0, 1.0], [-0.3, 1.0, 3.0], [1.0, 5.0, 0.4]):
            with self.subTest(sun=sun):
                position, focal = (0.3, 0.6, 1.4), (0.1, 0.05, 0.0)
                scene = Scene(self, [floor, wall], sun, position, focal, (400, 300), (0, 1, 0))
                scene.window.Render()
                place = scene.places()
                way = np.array(sun) / np.linalg.norm(sun)
                direct = scene.read("direct").max(-1)
                worst = 1.0
                for axis in (1, 2):
                    on = (
                        (np.abs(place[..., axis]) < 1e-3)
                        & (place[..., 3 - axis] > 2e-3)
                        & (np.abs(place[..., 0]) < 0.9)
                    )
                    worst = min(worst, (direct[on] / way[axis]).min())
                print(f"sun {sun}: least share of the light {worst:.3f}")
                # Nothing hides either. Slopes in maps have eleven bits.
                self.assertGreater(worst, 0.99)

    def test_nothing_inside_closed_bodies_is_lit_from_outside(self) -> None:
        # Receivers lie between the rim of a body, as a light sees it, and a texel beyond it,
        # which the light reaches.
        sun = (2.0, 3.0, 3.0)
        floor = mesh([[-2, 0, 2], [2, 0, 2], [2, 0, -2], [-2, 0, -2]], [[0, 1, 2, 3]])
        for name, body in {"box": cube(False, (0, 0.65, 0)), "ball": ball((0, 0.65, 0))}.items():
            with self.subTest(body=name):
                position, focal = (0.0, 0.65, 0.2), (0.0, 0.6, -1.0)
                scene = Scene(self, [floor, body], sun, position, focal, (160, 120), (0, 1, 0))
                scene.renderer.GetActiveCamera().SetViewAngle(80.0)
                scene.renderer.GetActiveCamera().SetClippingRange(0.01, 10.0)
                scene.window.Render()
                direct = scene.read("direct").max(-1)
                print(f"{name}: lit pixels {(direct > 1e-3).sum()}, at most {direct.max():.4f}")
                self.assertEqual(np.count_nonzero(scene.read("depth")[..., 0] == 0.0), 0)
                # Facets that all but turn their edges to the sun leave single pixels in doubt.
                self.assertLessEqual((direct > 1e-3).sum(), 5)
                self.assertLess(direct.mean(), 1e-5)

    def test_folds_of_few_triangles_do_not_hide_themselves(self) -> None:
        # Waves with facets of up to 35 degrees, from above: the sun reaches all of them.
        count = 24
        x, y = np.meshgrid(np.linspace(-1, 1, count), np.linspace(-1, 1, count), indexing="ij")
        z = 0.11 * np.sin(7.0 * x + 2.0 * y) * np.cos(6.0 * y - 1.5 * x)
        points = np.stack([x, y, z], -1).reshape(-1, 3)
        faces = []
        for i in range(count - 1):
            for j in range(count - 1):
                a = i * count + j
                faces += [[a, a + count, a + count + 1], [a, a + count + 1, a + 1]]
        fold = mesh(points, faces, smooth=True)
        scene = Scene(self, [fold], (0.1, 0.05, 1.0), (0.4, -1.2, 1.6), (0.0, 0.0, 0.0), (320, 240))
        scene.window.Render()
        hidden = scene.read("direct").max(-1)
        scene.indirect.SetShadows(False)
        scene.window.Render()
        free = scene.read("direct").max(-1)
        scene.indirect.SetShadows(True)
        seen = free > 0.05
        share = hidden[seen] / free[seen]
        print(f"least share {share.min():.3f}, pixels below 0.99: {(share < 0.99).sum()}")
        self.assertGreater(seen.sum(), 20000)
        # One of three facets that meet in a texel may hide a part of another: 2 pixels, 0.984.
        self.assertLess((share < 0.99).sum(), 1e-4 * seen.sum())
        self.assertGreater(share.min(), 0.95)

    def test_facets_of_a_smooth_surface_do_not_hide_themselves(self) -> None:
        """Light of the sun ends where VTK's cosine does, and the shadow of a plate stays."""
        plate = mesh([[-9, -9, 4], [9, -9, 4], [9, 9, 4], [-9, 9, 4]], [[0, 1, 2, 3]])
        for sun in ((-0.35, -2.0, 2.0), (-0.7, -2.0, 2.0), (2.0, 0.5, 2.0)):
            body = cube(True)
            scene = Scene(self, [body, plate], sun, (1.0, -3.2, 1.4), (0, 0, 0), (200, 200))
            scene.indirect.SetIndirectScale(1e-6)
            light = {}
            for name, shadows, hides in (
                ("plain", False, False), ("shadows", True, False), ("plate", True, True)
            ):
                scene.indirect.SetShadows(shadows)
                plate.SetVisibility(hides)
                scene.window.Render()
                light[name] = scene.read("final")[:, :, :3].mean(-1)
            seen = (scene.places() ** 2).sum(-1) < 0.8
            lit = seen & (light["plain"] > 0.02)
            share = light["shadows"][lit] / light["plain"][lit]
            print(f"sun {sun}: pixels {lit.sum()}, dark {(share < 0.95).sum()}")
            self.assertGreater(lit.sum(), 5000)
            # 61, 11 and 239 pixels at dim corners stay dark, 0.4 % of the light. Facets that hide
            # themselves take 824, 693 and 4,853 pixels.
            self.assertLess((share < 0.95).sum(), 0.03 * lit.sum())
            self.assertGreater(light["shadows"][lit].sum(), 0.99 * light["plain"][lit].sum())
            self.assertLess(light["plate"][lit].max(), 0.01)

    def test_no_specks_where_a_ball_touches_the_floor(self) -> None:
        floor = mesh([[0, 0, 2], [2, 0, 2], [2, 0, 0], [0, 0, 0]], [[0, 1, 2, 3]])
        left = mesh([[0, 0, 0], [0, 2, 0], [0, 2, 2], [0, 0, 2]], [[0, 1, 2, 3]])
        back = mesh([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2, 3]])
        touching = ball((0, 0, 0), 64)
        touching.SetScale(0.4 / 0.6)
        touching.SetPosition(0.6, 0.4, 0.6)
        left.GetProperty().SetColor(0.9, 0.1, 0.1)
        back.GetProperty().SetColor(0.1, 0.7, 0.1)
        eye, focal = (4.2, 2.6, 4.6), (0.8, 0.7, 0.8)
        actors = [floor, left, back, touching]
        scene = Scene(self, actors, None, eye, focal, (640, 480), (0, 1, 0))
        scene.add_spot((1.9, 1.9, 1.3), (0.5, 0.4, 0.5), 40.0, 0.0)
        # The shadows of single lights are narrow lines beside the ball.
        scene.renderer.GetActiveCamera().SetFocalPoint(0.6, 0.0, 0.75)
        scene.renderer.GetActiveCamera().SetViewAngle(5.0)
        near, voxels = (self.gather(scene, kind) for kind in ("maps", "voxels"))
        least = 0.1 * voxels.max()
        dark = (voxels > least) & (near < 0.85 * np.maximum(voxels, least))
        # Hidden by a strip's lowest row: 171.
        print(f"maps: darker by 15 % at {dark.sum()} pixels")
        self.assertLess(dark.sum(), 10)

    def gather(self, scene: Scene, visibility: str) -> np.ndarray:
        """Irradiance by sums over all lights at every pixel."""
        vtkindirect.enable(
            scene.renderer,
            "gather",
            lighting="scene",
            antialiasing=False,
            interpolation=False,
            visibility=visibility,
        )
        self.finish(scene)
        return scene.read("irradiance").mean(-1)

    def test_no_specks_beside_outlines_in_front_of_a_floor(self) -> None:
        """A pixel of the floor takes no light from a sample on the ball in front."""
        floor = mesh([[-3, -3, 0], [3, -3, 0], [3, 3, 0], [-3, 3, 0]], [[0, 1, 2, 3]])
        floor.GetProperty().SetColor(1, 1, 1)
        balls = [ball((x, 0, 0.6), 60) for x in (-1.5, 0, 1.5)]
        wall = cube(False, (0, 1.2, 0.5))
        wall.SetScale(5, 0.1, 1)
        wall.SetOrigin(0, 1.2, 0.5)
        for actor in (*balls, wall):
            actor.GetProperty().SetColor(0.8, 0.5, 0)
        scene = Scene(self, [floor, *balls, wall], None, (5, 5, 5), (0, 0, 0.5), (384, 384))
        vtkLightKit().AddLightsToRenderer(scene.renderer)
        camera = scene.renderer.GetActiveCamera()
        vtkindirect.enable(scene.renderer, antialiasing=False)
        scene.window.Render()
        # 0.0005 and 0.0002; 0.0019 and 0.0054 with samples of the five nearest texels alone.
        for rate in (1e-4, 15.0):
            scene.window.SetDesiredUpdateRate(rate)
            for _ in range(3):
                camera.Azimuth(4)
                scene.window.Render()
                on_floor = scene.read("albedo")[..., 2] > 0.5
                light = np.where(on_floor, scene.read("bounce").sum(-1), np.nan)
                padded = np.pad(light, 6, constant_values=np.nan)
                around = np.lib.stride_tricks.sliding_window_view(padded, (13, 13))
                middle = np.nanmedian(around[on_floor].reshape(on_floor.sum(), -1), -1)
                specks = float((light[on_floor] > 1.5 * middle).mean())
                self.assertLess(specks, 0.0007)

    def test_the_sky_is_smooth_on_a_cube_of_eight_points(self) -> None:
        scene = Scene(self, [cube(True)], (0.3, -2.0, 1.0), (1.0, -3.2, 1.4), (0, 0, 0), (200, 200))
        sky = vtkindirect.vtkEnvironmentLight()
        sky.SetRadiance(1.0, 1.0, 1.0)
        scene.indirect.SetEnvironment(sky)
        self.finish(scene)
        place = scene.places()
        self.check_smooth(scene.read("sky").mean(-1), place, "sky", 1e-3)

    def test_bounces_are_smooth_on_a_cube_of_eight_points(self) -> None:
        floor = mesh([[-2, -2, -0.6], [2, -2, -0.6], [2, 2, -0.6], [-2, 2, -0.6]], [[0, 1, 2, 3]])
        scene = Scene(
            self, [cube(True), floor], (0.6, -2.0, 2.0), (1.0, -3.2, 1.0), (0, 0, 0), (200, 200)
        )
        self.finish(scene)
        # Samples of groups of pixels stand before surfaces that are as bent as their interpolated normals say, so
        # that none is lit from behind: 0.044 with 128 lights, 0.078 with the 353 that the narrow gap takes, at most
        # 0.088 with 512 to 2048. Without that it was 0.008, by normals for planes 0.28.
        self.check_smooth(scene.read("irradiance").mean(-1), scene.places(), "bounces", 0.09)

    def test_light_is_even_where_normals_lie_along_the_facet(self) -> None:
        # Meshes with broken normals have such quadrangles. Rounding must not decide at each pixel on
        # which side of the quadrangle the light is.
        along, up = np.array([0.8, 0.36, 0.48]), np.array([-0.6, 0.48, 0.64])
        corners = [a * along + b * up for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        actor = mesh(corners, [[0, 1, 2, 3]])
        normals = numpy_to_vtk(np.tile(along, (4, 1)).astype(np.float32), deep=1)
        actor.GetMapper().GetInput().GetPointData().SetNormals(normals)
        normal = np.cross(along, up)
        for angle in (0.2, 0.5, 0.8, 1.1):
            with self.subTest(angle=angle):
                eye = 6.0 * (np.cos(angle) * normal + np.sin(angle) * (0.6 * along + 0.8 * up))
                sun = 3.0 * along + 2.0 * normal
                scene = Scene(self, [actor], sun, eye, (0, 0, 0), (200, 200), up)
                scene.window.Render()
                lit = scene.read("depth")[..., 0] > 0.0
                light = scene.read("direct").mean(-1)[lit]
                off = np.abs(light - np.median(light)) > 0.02
                print(f"angle {angle}: {off.sum()} of {lit.sum()} pixels are off")
                self.assertGreater(lit.sum(), 1000)
                self.assertLess(off.sum(), 0.01 * lit.sum())

    def test_bounces_are_smooth_along_creases_and_edges_of_a_room(self) -> None:
        # A board in a closed room, where light varies slowly: a point on a wall of even light sees half
        # of the hemisphere filled by the next wall at its foot, and less by the sine of the next wall's
        # elevation. Over the two pixels that the median reaches this is below 2 %.
        room, board = cube(False), cube(False, (-0.05, -0.03, -0.14))
        room.SetScale(2.0)
        board.SetScale(0.8, 0.9, 0.04)
        eye, focal = (0.9, 0.8, 0.6), (-0.5, -0.6, -0.5)
        scene = Scene(self, [room, board], None, eye, focal, (320, 240))
        scene.renderer.GetActiveCamera().SetViewAngle(60.0)
        scene.add_spot((0.2, -0.1, 0.5), (0.4, 0.6, 1.5), 50.0, 1.0)
        self.finish(scene)
        # At corners of the board a texel's neighbours lie beyond another edge: 183. Without texels'
        # neighbours 987 pixels are off. Moving frames read one neighbour: 252, without it 942.
        for rate, most in ((1e-4, 300), (15.0, 400)):
            scene.window.SetDesiredUpdateRate(rate)
            scene.renderer.GetActiveCamera().Azimuth(0.01)
            scene.window.Render()
            rough = wrinkle(scene.read("irradiance").mean(-1)) > 0.04
            print(f"room: rate {rate}, off by 4 % {rough.sum()} of {rough.size} pixels")
            self.assertLess(rough.sum(), most)

    def test_light_is_even_along_the_creases_and_rims_of_a_tray(self) -> None:
        # An open tray under the sky: 128 maps of 128 x 128 texels, of which one is as wide as four pixels.
        walls = [
            mesh([(s, -t, 0), (s, t, 0), (s, t, 0.8), (s, -t, 0.8)], [[0, 1, 2, 3]])
            for s, t in ((-1, -1), (1, 1))
        ] + [
            mesh([(-t, s, 0), (t, s, 0), (t, s, 0.8), (-t, s, 0.8)], [[0, 1, 2, 3]])
            for s, t in ((-1, 1), (1, -1))
        ]
        floor = mesh([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [[0, 1, 2, 3]])
        eye, focal = (0, -2, 5), (0, 0, 0.2)
        scene = Scene(self, [floor, *walls], None, eye, focal, (400, 400), (0, 1, 0))
        vtkindirect.enable(scene.renderer, lighting="studio", antialiasing=False)
        self.finish(scene)
        place = np.nan_to_num(scene.places(), nan=9.0)
        light = {name: scene.read(name).mean(-1) for name in ("sky", "bounce")}
        normal = scene.read("normal")
        faces = [np.abs(normal[..., 2]) > 0.9] + [
            (np.abs(normal[..., axis]) > 0.9) & (np.abs(place[..., axis] - side) < 0.05)
            for axis in (0, 1)
            for side in (-1, 1)
        ]
        for name, values in light.items():
            dark = 0
            seen = 0
            for face in faces:
                # Not in the corners, where light bends within pixels.
                inner = face & (np.sort(np.abs(place[..., :2]), -1)[..., 0] < 0.9)
                padded = np.pad(np.where(face, values, np.nan), 3, constant_values=np.nan)
                around = np.lib.stride_tricks.sliding_window_view(padded, (7, 7))[inner]
                middle = np.nanmedian(around.reshape(len(around), -1), -1)
                dark += int((values[inner] < 0.85 * middle).sum())
                seen += int(inner.sum())
            print(f"tray, {name}: {dark} of {seen} pixels are darker by 15 % than those around")
            self.assertGreater(seen, 40000)
            self.assertLessEqual(dark, 20)

    def test_the_sky_is_smooth_in_a_trough_of_few_facets(self) -> None:
        # Facets that meet at 18 degrees: a neighbour rises over a facet by more than a map's bias.
        turn = np.radians(np.linspace(-72, 72, 9))
        rows = [(np.sin(a), y, 1.0 - np.cos(a)) for a in turn for y in (-1.5, 1.5)]
        faces = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(8)]
        trough, eye, focal = mesh(rows, faces, True), (0.2, -0.5, 5), (0, 0, 0.4)
        scene = Scene(self, [trough], None, eye, focal, (400, 400), (0, 1, 0))
        vtkindirect.enable(scene.renderer, lighting="studio", antialiasing=False)
        self.finish(scene)
        place = np.nan_to_num(scene.places(), nan=9.0)
        inner = (np.abs(place[..., 0]) < 0.85) & (np.abs(place[..., 1]) < 1.4)
        rough = wrinkle(scene.read("sky").mean(-1), 3)[inner]
        print(f"trough: {(rough > 0.05).sum()} of {inner.sum()} pixels off by 5 %")
        self.assertGreater(inner.sum(), 10000)
        self.assertLess((rough > 0.05).sum(), 0.002 * inner.sum())

    def finish(self, scene: Scene) -> None:
        scene.window.Render()
        for _ in range(40):
            counters = vtkindirect.report(scene.renderer)["counters"]
            if not counters.get("tiles_left"):
                break
            scene.window.Render()

    def check_smooth(
        self, light: np.ndarray, place: np.ndarray, name: str, most: float
    ) -> None:
        """Light on faces, away from edges, strays from that around it by 4 % in few pixels."""
        face = np.zeros(light.shape, bool)
        for axis in range(3):
            others = np.delete(place, axis, -1)
            face |= (np.abs(np.abs(place[..., axis]) - 0.5) < 1e-3) & (
                np.abs(others).max(-1) < 0.42
            )
        rough = wrinkle(light)[face]
        print(f"{name}: pixels {face.sum()}, off by 4 % {(rough > 0.04).sum()}")
        self.assertGreater(face.sum(), 4000)
        self.assertLess((rough > 0.04).sum(), most * face.sum())


if __name__ == "__main__":
    unittest.main()
