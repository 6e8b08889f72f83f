# SPDX-License-Identifier: BSD-3-Clause
"""The camera of data files: from a side that shows them, and as near as the picture has room."""

import itertools
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkIOGeometry import vtkOBJWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkCamera

import support
from vtkindirect import load_scene, views


def projected(scene, size) -> np.ndarray:
    """Return where points are in the picture, from -1 to 1 in both directions."""
    (actor,) = scene.actors.values()
    points = vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())
    camera = scene.renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
    rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    seen = np.c_[points, np.ones(len(points))] @ rows.T
    return seen[:, :2] / seen[:, 3:]


class Views(support.DirectoryTest):
    def scene(self, source, name: str = "data.vtp", writer=None):
        source.Update()
        writer = writer or vtkXMLPolyDataWriter()
        writer.SetInputData(source.GetOutput())
        writer.SetFileName(str(self.directory / name))
        writer.Write()
        return load_scene(self.directory / name)

    def assert_fills(self, scene, size=(512, 512)) -> None:
        """The data fill the picture but for the margins, in one direction, and are all in it."""
        scene.fit(size)
        reach = np.abs(projected(scene, size)).max(axis=0)
        # Half of the picture is 1; the outline is exact to 0.0084 of its radius (views.extremes).
        self.assertLess(reach.max(), 1.0 - 2.0 * views.MARGIN + 0.01)
        self.assertGreater(reach.max(), 1.0 - 2.0 * views.MARGIN - 0.01)

    def plane(self, normal) -> vtkPlaneSource:
        plane = vtkPlaneSource()
        plane.SetResolution(8, 8)
        plane.SetNormal(normal)
        return plane

    def test_no_plane_is_seen_from_its_edge(self) -> None:
        for normal in ((0, 0, 1), (0, 1, 0), (1, 0, 0), (1, -1, 0), (1, 1, -2), (0.3, -0.8, 0.5)):
            with self.subTest(normal=normal):
                scene = self.scene(self.plane(normal))
                camera = scene.renderer.GetActiveCamera()
                cosine = abs(np.dot(camera.GetDirectionOfProjection(), normal))
                # At least half of the broadest view.
                self.assertGreater(cosine / np.linalg.norm(normal), views.LEAST_SHARE - 1e-3)
                self.assert_fills(scene)

    def test_a_rod_along_the_usual_view(self) -> None:
        line, tube = vtkLineSource(), vtkTubeFilter()
        line.SetPoint2(7.0, 7.0, 7.0)
        tube.SetInputConnection(line.GetOutputPort())
        tube.SetRadius(0.3)
        scene = self.scene(tube)
        along = np.dot(scene.renderer.GetActiveCamera().GetDirectionOfProjection(), (1, 1, 1))
        self.assertLess(abs(along) / 3**0.5, 0.1)
        self.assert_fills(scene)

    def test_whatever_place_length_and_shape_of_the_picture(self) -> None:
        for radius, center in ((1e-9, 0.0), (1.0, 1e3), (6.4e6, 5e5)):
            ball = vtkSphereSource()
            ball.SetRadius(radius)
            ball.SetCenter(center, -center, 2.0 * center)
            ball.SetOutputPointsPrecision(1)
            scene = self.scene(ball)
            for size in ((512, 512), (800, 300), (200, 640)):
                with self.subTest(radius=radius, size=size):
                    self.assert_fills(scene, size)

    def test_the_camera_is_the_users_once_it_was_moved(self) -> None:
        scene = self.scene(self.plane((0, 0, 1)))
        camera = scene.renderer.GetActiveCamera()
        camera.SetPosition(3.0, 2.0, 1.0)
        scene.fit((100, 300))
        self.assertEqual(camera.GetPosition(), (3.0, 2.0, 1.0))

    def test_what_is_up(self) -> None:
        up = self.scene(vtkSphereSource()).renderer.GetActiveCamera().GetViewUp()
        self.assertEqual(int(np.argmax(up)), 2)
        model = self.scene(vtkSphereSource(), "data.obj", vtkOBJWriter())
        self.assertEqual(int(np.argmax(model.renderer.GetActiveCamera().GetViewUp())), 1)

    def test_extremes_are_those_of_all_points(self) -> None:
        points = support.noise((50_000, 3)) - 0.5
        points /= np.linalg.norm(points, axis=1)[:, None]
        few = views.extremes(points)
        self.assertLess(len(few), 257)
        for toward in itertools.product((-1.0, 0.3, 1.0), repeat=3):
            self.assertGreater((few @ toward).max() / np.linalg.norm(toward), 1.0 - 0.0084 - 3e-3)

    def test_closed_form_of_the_distance(self) -> None:
        # A square of 2 in the plane z = 0: its corners are on the margin at 1 / tangent.
        corners = np.array([(x, y, 0.0) for x in (-1.0, 1.0) for y in (-1.0, 1.0)])
        camera = vtkCamera()
        camera.SetViewAngle(60.0)
        views.place(camera, corners, np.array((0.0, 0.0, 1.0)), "y", 1.0)
        tangent = (1.0 - 2.0 * views.MARGIN) / 3.0**0.5
        np.testing.assert_allclose(camera.GetPosition(), (0.0, 0.0, 1.0 / tangent), atol=1e-12)


if __name__ == "__main__":
    unittest.main()
