# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that stand still look as if they had always stood so, whatever was there before."""

import unittest

import numpy as np
import support
from rooms import make_actor, make_area, make_ball, make_room
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkLight, vtkRenderer

import vtkindirect
from vtkindirect import windows


def away(renderer: vtkRenderer, ball: vtkActor) -> None:
    ball.SetPosition(10, 0, 0)


def out_of_the_room(renderer: vtkRenderer, ball: vtkActor) -> None:
    ball.SetPosition(0.9, 0, 0)


def another_far_away(renderer: vtkRenderer, ball: vtkActor) -> None:
    other = make_actor(make_ball())
    other.SetPosition(20, 0, 0)
    renderer.AddActor(other)


def small(renderer: vtkRenderer, ball: vtkActor) -> None:
    ball.SetScale(0.2)


def turned(renderer: vtkRenderer, ball: vtkActor) -> None:
    ball.RotateY(50)


def make_balls() -> vtkActor:
    points = vtkSphereSource()
    points.SetThetaResolution(4)
    points.SetPhiResolution(4)
    points.SetCenter(0, 0.5, 0)
    points.SetRadius(0.4)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    source = vtkSphereSource()
    mapper.SetSourceConnection(source.GetOutputPort())
    mapper.SetScaleFactor(0.25)
    balls = vtkActor()
    balls.SetMapper(mapper)
    return balls


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class History(unittest.TestCase):
    def setUp(self) -> None:
        self.window = windows.render_window((32, 24), offscreen=True)

    def add_scene(self, kind: str) -> tuple[vtkRenderer, vtkActor]:
        ball = make_balls() if kind == "spheres" else make_actor(make_ball())
        renderer = make_room(ball, kind in ("spot", "penumbra"))
        settings = {"environment": (1, 1, 1)} if kind in ("sky", "spheres") else {}
        lighting = kind if kind in ("full", "soft") else "scene"
        indirect = vtkindirect.enable(renderer, lighting=lighting, **settings)
        if kind == "sun":
            sun = vtkLight()
            sun.SetLightTypeToSceneLight()
            sun.SetPosition(1, 2, -2)
            renderer.AddLight(sun)
        if kind == "penumbra":
            indirect.SetLightRadius(renderer.GetLights().GetItemAsObject(0), 0.2)
        if kind == "area":
            indirect.AddAreaLight(make_area(0))
        self.window.AddRenderer(renderer)
        return renderer, ball

    def take_light(self, renderer: vtkRenderer) -> dict[str, np.ndarray]:
        names = ("direct", "irradiance")
        light = {name: vtkindirect.copy_buffer(renderer, name).astype(float) for name in names}
        self.window.RemoveRenderer(renderer)
        return light

    def draw(self, kind: str, before) -> dict[str, np.ndarray]:
        """Light of a scene that has stood for some frames; before them it was in other states."""
        renderer, ball = self.add_scene(kind)
        for change in before:
            self.window.Render()
            props = renderer.GetViewProps().GetNumberOfItems()
            change(renderer, ball)
            self.window.Render()
            self.window.Render()
            ball.SetPosition(0, 0, 0)
            ball.SetScale(1)
            ball.SetOrientation(0, 0, 0)
            while renderer.GetViewProps().GetNumberOfItems() > props:
                renderer.RemoveActor(renderer.GetViewProps().GetLastProp())
        # A lamp is asked at more points of it from frame to frame.
        said = None
        for frame in range(60):
            self.window.Render()
            modelled = vtkindirect.report(renderer)["modelled"]
            if frame > 5 and modelled == said:
                break
            said = modelled
        return self.take_light(renderer)

    def draw_path(self, kind: str, places) -> dict[str, np.ndarray]:
        """Light of the first frame at the last of some places, with one frame at each before."""
        renderer, ball = self.add_scene(kind)
        for place in places:
            ball.SetPosition(*place)
            self.window.Render()
        return self.take_light(renderer)

    def compare(self, light, expected) -> None:
        for name, fresh in expected.items():
            # Half floats keep eleven bits of the last sums.
            self.assertLess(np.abs(light[name] - fresh).max(), 1e-3 * fresh.max() + 1e-9, name)

    def check(self, kind: str, *befores) -> None:
        expected = self.draw(kind, ())
        for before in befores:
            with self.subTest(kind=kind, before=before.__name__):
                self.compare(self.draw(kind, (before,)), expected)

    def test_spot(self) -> None:
        self.check("spot", away, out_of_the_room, another_far_away, small)

    def test_penumbra(self) -> None:
        self.check("penumbra", away)

    def test_sky(self) -> None:
        self.check("sky", away, small)

    def test_area(self) -> None:
        self.check("area", away, small)

    def test_sun(self) -> None:
        self.check("sun", away, out_of_the_room)

    def test_preset(self) -> None:
        self.check("full", away)
        self.check("soft", away)

    def test_spheres(self) -> None:
        self.check("spheres", turned)

    def test_first_frame_after_motion(self) -> None:
        """A ball that leaves the room step by step, as scripts do that write a film."""
        path = [(0.2 * step, 0.1 * step, 0) for step in range(6)]
        for kind in ("spot", "sky", "area", "full", "soft"):
            with self.subTest(kind=kind):
                self.compare(self.draw_path(kind, path), self.draw_path(kind, path[-1:]))


if __name__ == "__main__":
    unittest.main()
