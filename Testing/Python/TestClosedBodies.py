# SPDX-License-Identifier: BSD-3-Clause
"""No light of the sky or of surfaces outside gets into closed bodies."""

import unittest

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkCylinderSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from vtkmodules.vtkRenderingCore import vtkRenderer

import support  # noqa: F401
import vtkindirect
from rooms import make_actor

WHITE = (0.9, 0.9, 0.9)
MOST = {"ball": (0.0005, 0.003), "box": (0.002, 0.008), "cylinder": (0.001, 0.005)}
"""Mean irradiance inside from the sky and by bounces, over that of the open sky. A texel's depth
map leaves a line of light a pixel wide in creases; white walls send it on nine times."""


def bodies() -> dict[str, vtkAlgorithm]:
    ball = vtkSphereSource()
    ball.SetRadius(0.6)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    box = vtkCubeSource()
    cylinder = vtkCylinderSource()
    cylinder.SetRadius(0.5)
    cylinder.SetHeight(1.0)
    cylinder.SetResolution(32)
    found = {"ball": ball, "box": box, "cylinder": cylinder}
    for body in found.values():
        body.SetCenter(0.0, 0.65, 0.0)
    return found


class ClosedBodies(unittest.TestCase):
    def look_inside(self, body: vtkAlgorithm, method: str) -> vtkRenderer:
        """Before a camera in a body, over a floor and before a wall under a uniform sky."""
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        for point2 in ((-2, 0, -2), (-2, 3, -2)):
            plane = vtkPlaneSource()
            plane.SetOrigin(-2, 0, 2 if point2[1] == 0 else -2)
            plane.SetPoint1(2, 0, 2 if point2[1] == 0 else -2)
            plane.SetPoint2(*point2)
            renderer.AddActor(make_actor(plane, WHITE))
        renderer.AddActor(make_actor(body, WHITE))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0.65, 0.2)
        camera.SetFocalPoint(0, 0.6, -1)
        camera.SetViewAngle(80)
        camera.SetClippingRange(0.01, 10)
        window = vtkindirect.render_window((120, 90), offscreen=True)
        window.AddRenderer(renderer)
        self.addCleanup(window.Finalize)
        vtkindirect.enable(renderer, method, lighting="scene", environment=(1, 1, 1))
        for _ in range(3):
            window.Render()
        return renderer

    def test_it_is_dark_in_closed_bodies(self) -> None:
        for name, body in bodies().items():
            with self.subTest(body=name):
                renderer = self.look_inside(body, "auto")
                for buffer, most in zip(("sky", "bounce"), MOST[name]):
                    light = vtkindirect.copy_buffer(renderer, buffer).max(-1)
                    print(f"{name}, {buffer}: mean {light.mean():.5f}, at most {most}")
                    self.assertLess(light.mean(), most)


if __name__ == "__main__":
    unittest.main()
