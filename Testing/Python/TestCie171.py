# SPDX-License-Identifier: BSD-3-Clause
"""Analytic cases of CIE 171:2006, "Test cases to assess the accuracy of lighting computer programs".

A room of 4 m x 4 m x 3 m, or a cube of 4 m. Illuminance in lux is pi times irradiance in VTK's
units. Points lie on the vertical line in the middle of a wall, z from the top, and on the line of
the floor or the ceiling from that wall's foot to the middle of the room.
"""

import math
import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer

import support
import vtkindirect
from rooms import make_actor
from vtkindirect import area_lights, frames, windows, wrapped

WIDTH, HEIGHT = 4.0, 3.0
PIXEL = 0.02
"""Metres; a point's illuminance is the mean of the four pixels around it, or of the two beside it."""
WALL = [2.75, 2.25, 1.75, 1.25, 0.75, 0.25]
FLOOR = [0.25, 0.75, 1.25, 1.75]
HOLE = (1.5, 2.5)

AREA_SOURCE = {"wall": [32.68, 75.19, 81.32, 69.06, 53.40, 40.00], "floor": [61.42, 79.26, 95.67, 105.78]}
"""5.3, lux: a source of 1 m x 1 m and 1000 cd/m2 in the middle of the ceiling."""
REFLECTION = {"wall": [12.967, 16.716, 21.639, 27.992, 35.901], "ceiling": [26.80, 30.94, 33.98, 35.57]}
"""5.6, per cent of the floor's illuminance times its reflectance; the wall from z = 2.75 to 0.75."""
OVERCAST = {"wall": [0.46, 1.64, 2.34, 2.26, 1.88, 1.47], "floor": [2.33, 3.11, 3.84, 4.29]}
"""5.9, per cent of the illuminance outside: an opening of 1 m x 1 m in the roof, overcast sky."""
UNIFORM = {"wall": [1.04, 2.39, 2.59, 2.20, 1.70, 1.27], "floor": [1.96, 2.52, 3.05, 3.37]}
"""5.9 under a uniform sky."""


def plane(origin, point1, point2, albedo: float) -> vtkActor:
    source = vtkPlaneSource()
    source.SetOrigin(origin)
    source.SetPoint1(point1)
    source.SetPoint2(point2)
    return make_actor(source, (albedo,) * 3)


def walls(height: float, albedo: float) -> list[vtkActor]:
    w, h = WIDTH, height
    return [
        plane((0, 0, 0), (w, 0, 0), (0, 0, h), albedo),
        plane((0, w, 0), (w, w, 0), (0, w, h), albedo),
        plane((0, 0, 0), (0, w, 0), (0, 0, h), albedo),
        plane((w, 0, 0), (w, w, 0), (w, 0, h), albedo),
    ]


def floor(albedo: float) -> vtkActor:
    return plane((0, 0, 0), (WIDTH, 0, 0), (0, WIDTH, 0), albedo)


def ceiling(height: float, albedo: float) -> vtkActor:
    return plane((0, 0, height), (WIDTH, 0, height), (0, WIDTH, height), albedo)


def open_roof(albedo: float) -> list[vtkActor]:
    (a, b), w, h = HOLE, WIDTH, HEIGHT
    sides = ((0, 0, w, a), (0, b, w, w), (0, a, a, b), (b, a, w, b))
    return [plane((x, y, h), (u, y, h), (x, v, h), albedo) for x, y, u, v in sides]


def make_room(actors) -> vtkRenderer:
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for actor in actors:
        renderer.AddActor(actor)
    return renderer


def look(renderer: vtkRenderer, at: str, height: float = HEIGHT) -> tuple[int, int]:
    """Set a parallel camera that shows one face of the room, a pixel for each PIXEL."""
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    middle = WIDTH / 2
    place = {
        "wall": ((middle, 0.9 * WIDTH, height / 2), (middle, 0, height / 2), (0, 0, 1)),
        "floor": ((middle, middle, 0.9 * height), (middle, middle, 0), (0, 1, 0)),
        "ceiling": ((middle, middle, 0.1 * height), (middle, middle, height), (0, 1, 0)),
    }[at]
    camera.SetPosition(place[0])
    camera.SetFocalPoint(place[1])
    camera.SetViewUp(place[2])
    tall = height if at == "wall" else WIDTH
    camera.SetParallelScale(tall / 2)
    camera.SetClippingRange(0.05, 2 * WIDTH)
    return round(WIDTH / PIXEL), round(tall / PIXEL)


def along(image: np.ndarray, places: list[float]) -> np.ndarray:
    """Values on the vertical line in the middle of an image, at places from its lower edge."""
    column = image[:, image.shape[1] // 2 - 1 : image.shape[1] // 2 + 1, 0].mean(axis=1)
    centres = (np.arange(len(column)) + 0.5) * PIXEL
    return np.interp(places, centres, column)


def sky(radiance) -> object:
    """An environment whose radiance depends on the elevation, in radians, and is 0 below the horizon."""
    rows = 256
    elevation = ((np.arange(rows) + 0.5) / rows - 0.5) * math.pi
    values = np.where(elevation > 0, radiance(np.maximum(elevation, 1e-6)), 0.0)
    picture = np.repeat(values[:, np.newaxis], 16, axis=1).astype(np.float32)
    image = vtkImageData()
    image.SetDimensions(16, rows, 1)
    scalars = numpy_to_vtk(np.repeat(picture.reshape(-1, 1), 3, axis=1), deep=True)
    image.GetPointData().SetScalars(scalars)
    light = wrapped.get("vtkEnvironmentLight")()
    light.SetImage(image)
    light.SetUp(0, 0, 1)
    return light


def outside(radiance) -> float:
    """Irradiance of a horizontal surface under such a sky, in VTK's units."""
    elevation = (np.arange(20000) + 0.5) / 20000 * math.pi / 2
    integrand = radiance(elevation) * np.sin(elevation) * np.cos(elevation)
    return float(2 * math.pi * integrand.mean() * math.pi / 2) / math.pi


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Cie171(unittest.TestCase):
    def measure(self, renderer: vtkRenderer, at: str, buffer: str, height: float = HEIGHT, **settings):
        """A buffer of one face after all work of a still picture."""
        window = windows.render_window(look(renderer, at, height), offscreen=True)
        window.AddRenderer(renderer)
        vtkindirect.enable(renderer, lighting="scene", **settings)
        window.Render()
        for _ in frames.fill([renderer.GetPass()]):
            window.Render()
        image = vtkindirect.copy_buffer(renderer, buffer).astype(float)
        vtkindirect.disable(renderer)
        window.RemoveRenderer(renderer)
        window.Finalize()
        return image

    def compare(self, what: str, found: np.ndarray, exact: list[float], most: float) -> None:
        for value, wanted in zip(found, exact):
            print(f"{what}: {value:8.3f}, exact {wanted:8.3f}, {100 * (value / wanted - 1):+.2f} %")
        self.assertLess(np.abs(np.asarray(found) / exact - 1).max(initial=0.0), most)

    def test_5_3_area_source(self) -> None:
        for at, places in (("wall", WALL), ("floor", FLOOR)):
            renderer = make_room([*walls(HEIGHT, 0.5), floor(0.5), ceiling(HEIGHT, 0.5)])
            (a, b), h = HOLE, HEIGHT
            light = wrapped.get("vtkAreaLight")()
            light.SetOrigin(a, a, h)
            light.SetPoint1(a, b, h)
            light.SetPoint2(b, a, h)
            light.SetRadiance(1000, 1000, 1000)
            area_lights.attach(renderer, light)
            image = self.measure(renderer, at, "area")
            found = math.pi * along(image, places)
            self.compare(f"5.3 {at}, lx", found, AREA_SOURCE[at], 0.02)

    def test_5_6_diffuse_reflection(self) -> None:
        albedo = 0.3
        for at, places in (("wall", WALL[:5]), ("ceiling", FLOOR)):
            actors = [*walls(HEIGHT, 0.0), floor(albedo), ceiling(HEIGHT, 0.0)]
            keys = vtkInformation()
            keys.Set(wrapped.get("vtkIndirectIlluminationPass").CASTS_SHADOWS(), 0)
            for actor in (*actors[:4], actors[5]):
                actor.SetPropertyKeys(keys)
            renderer = make_room(actors)
            sun = vtkLight()
            sun.SetLightTypeToSceneLight()
            sun.SetPosition(2, 2, 10)
            sun.SetFocalPoint(2, 2, 0)
            renderer.AddLight(sun)
            image = self.measure(renderer, at, "bounce")
            found = 100 * along(image, places) / albedo
            self.compare(f"5.6 {at}, %", found, REFLECTION[at], 0.02)

    def test_5_8_closed_room(self) -> None:
        """Chance of few paths is most of the difference: 1.6 % (one sigma) at albedo 0.95."""
        flux, side = 10000.0, WIDTH
        for albedo in (0.3, 0.5, 0.7, 0.9, 0.95):
            renderer = make_room([*walls(side, albedo), floor(albedo), ceiling(side, albedo)])
            lamp = vtkLight()
            lamp.SetLightTypeToSceneLight()
            lamp.PositionalOn()
            lamp.SetConeAngle(180)
            lamp.SetPosition(side / 2, side / 2, side / 2)
            lamp.SetFocalPoint(side / 2, side / 2, 0)
            lamp.SetAttenuationValues(0, 0, 1)
            lamp.SetIntensity(flux / (4 * math.pi**2))
            renderer.AddLight(lamp)
            image = self.measure(renderer, "floor", "bounce", side)
            found = math.pi * image[..., 0].mean()
            exact = flux * albedo / (6 * side * side * (1 - albedo))
            self.compare(f"5.8 albedo {albedo}, lx", [found], [exact], 0.02)

    def compare_sky(self, most: float, highest: float, **settings) -> None:
        """The highest point of the wall has a bound of its own: it sees the opening at 7 degrees, as high as
        three to six texels of the sky's maps."""
        skies = {
            "overcast": (lambda e: 1 + 4 * np.exp(-0.7 / np.sin(e)), OVERCAST),
            "uniform": (lambda e: np.ones_like(e), UNIFORM),
        }
        for name, (radiance, exact) in skies.items():
            for at, places in (("wall", WALL), ("floor", FLOOR)):
                renderer = make_room([*walls(HEIGHT, 0.5), floor(0.5), *open_roof(0.5)])
                image = self.measure(renderer, at, "sky", environment=sky(radiance), **settings)
                found = 100 * along(image, places) / outside(radiance)
                low = 1 if at == "wall" else 0
                self.compare(f"5.9 {name} {at}, %", found[:low], exact[at][:low], highest)
                self.compare(f"5.9 {name} {at}, %", found[low:], exact[at][low:], most)

    def test_5_9_sky_through_an_opening(self) -> None:
        self.compare_sky(0.03, 0.05)

    def test_a_batch_of_few_directions(self) -> None:
        """A tolerance of 0.5 takes 16 directions in the open, and 128 through an opening of 1.8 m."""
        with mock.patch.dict(globals(), HOLE=(1.1, 2.9)):
            means = []
            for settings in ({}, {"ErrorTolerance": 0.5}):
                renderer = make_room([*walls(HEIGHT, 0.5), floor(0.5), *open_roof(0.5)])
                light = sky(lambda e: np.ones_like(e))
                image = self.measure(renderer, "wall", "sky", environment=light, **settings)
                means.append(image.mean())
        print(f"means: {means}")
        self.assertLess(abs(means[1] / means[0] - 1), 0.1)

    def test_5_9_left_alone(self) -> None:
        self.compare_sky(0.02, 0.05, NumberOfRefinements=2)


if __name__ == "__main__":
    unittest.main()
