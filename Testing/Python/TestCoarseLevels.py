# SPDX-License-Identifier: BSD-3-Clause
"""Coarse levels in depth maps: when they are taken, what they change, and when they go."""

import re
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkShrinkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkDataSetMapper,
    vtkPolyDataMapper,
    vtkRenderer,
)

import support  # noqa: F401
import vtkindirect

ENTRY = "coarse geometry in depth maps"
FINE, COARSE = 80, 40
"""Rows and columns of a ball of radius one."""
ERROR = 1.0 - np.cos(np.pi / COARSE) ** 2
"""Bound: coarse facets lie inside by no more, rows turned by half of their angle both ways."""


def ball(rows: int, radius: float = 1.0) -> vtkSphereSource:
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetPhiResolution(rows)
    source.SetThetaResolution(rows)
    source.Update()
    return source


class CoarseLevels(unittest.TestCase):
    def setUp(self) -> None:
        self.renderer = vtkRenderer()
        # Its triangles share no points: the pass makes no levels of such a mesh by itself.
        pieces = vtkShrinkPolyData()
        pieces.SetInputData(ball(FINE).GetOutput())
        pieces.SetShrinkFactor(1.0)
        pieces.Update()
        self.mesh = pieces.GetOutput()
        ground = vtkPlaneSource()
        for corner, set_corner in (
            ((-6, -6, -1), ground.SetOrigin),
            ((6, -6, -1), ground.SetPoint1),
            ((-6, 6, -1), ground.SetPoint2),
        ):
            set_corner(*corner)
        ground.Update()
        self.actors = []
        # Two balls, so that a map holds more than one of them.
        for mesh, place in ((self.mesh, 0.0), (ball(24).GetOutput(), 4.0), (ground.GetOutput(), 0)):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(mesh)
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.SetPosition(place, 0.0, 0.0)
            self.renderer.AddActor(actor)
            self.actors.append(actor)
        self.window = vtkindirect.render_window((64, 48), offscreen=True)
        self.window.AddRenderer(self.renderer)
        self.addCleanup(self.window.Finalize)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.0, -8.0, 3.0)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCameraClippingRange()
        self.indirect = vtkindirect.enable(
            self.renderer, "auto", lighting="scene", NumberOfBounces=1
        )
        sky = vtkindirect.vtkEnvironmentLight()
        sky.SetRadiance(1.0, 1.0, 1.0)
        self.indirect.SetEnvironment(sky)
        self.window.SetDesiredUpdateRate(1e-4)

    def render(self) -> tuple[np.ndarray, np.ndarray, str]:
        """Return the sky, depths, and what the report says of levels."""
        self.window.Render()
        while vtkindirect.report(self.renderer)["counters"].get("tiles_left"):
            self.window.Render()
        modelled = vtkindirect.report(self.renderer)["modelled"]
        said = [entry for entry in modelled if ENTRY in str(entry)]
        text = str(modelled[ENTRY]) if said and isinstance(modelled, dict) else str(said or "")
        sky, depth = (vtkindirect.copy_buffer(self.renderer, name) for name in ("sky", "depth"))
        return np.array(sky), np.array(depth), text

    def test_a_dense_mesh_is_drawn_coarse(self) -> None:
        before, depth, said = self.render()
        self.assertEqual(said, "")
        self.indirect.AddCoarseLevel(self.actors[0], ball(COARSE).GetOutput(), ERROR)
        coarse, depth_coarse, said = self.render()
        self.assertIn("in place of", said)
        # The picture has the mesh itself.
        np.testing.assert_array_equal(depth, depth_coarse)
        # 256 directions are off by 0.02 of the open sky; levels change no more than half of that.
        apart = np.sqrt(np.mean((coarse - before) ** 2)) / before.mean()
        print(f"apart by {apart:.4f}, bias {coarse.mean() / before.mean() - 1.0:+.4f}")
        self.assertGreater(apart, 0.0)
        self.assertLess(apart, 0.01)
        self.indirect.RemoveCoarseLevels(self.actors[0])
        after, _, said = self.render()
        self.assertEqual(said, "")
        np.testing.assert_array_equal(before, after)

    def test_parts_of_a_dense_mesh_have_levels(self) -> None:
        # A clipping plane beside the scene clips nothing, and such a mesh is drawn by its mapper.
        self.actors[0].GetMapper().SetInputData(ball(160).GetOutput())
        plane = vtkPlane()
        plane.SetOrigin(0.0, 0.0, -50.0)
        plane.SetNormal(0.0, 0.0, 1.0)
        self.actors[0].GetMapper().AddClippingPlane(plane)
        whole, depth, said = self.render()
        self.assertEqual(said, "")
        self.actors[0].GetMapper().RemoveAllClippingPlanes()
        parts, depth_of_parts, said = self.render()
        drawn, full = (int(number) for number in re.findall(r"(\d+) triangles drawn in place of (\d+)", said)[0])
        print(f"{drawn / full:.3f} of the triangles")
        self.assertLess(drawn, 0.2 * full)
        np.testing.assert_array_equal(depth, depth_of_parts)
        apart = np.sqrt(np.mean((parts - whole) ** 2)) / whole.mean()
        print(f"apart by {apart:.4f}, bias {parts.mean() / whole.mean() - 1.0:+.4f}")
        self.assertLess(apart, 0.01)

    def test_data_sets_have_levels_that_follow_their_points(self) -> None:
        append = vtkAppendFilter()
        append.AddInputData(ball(160).GetOutput())
        append.Update()
        grid = append.GetOutput()

        def draw(points: vtkPoints | None = None) -> tuple[np.ndarray, str]:
            if points is None:
                mapper = vtkDataSetMapper()
                mapper.SetInputData(grid)
                self.actors[0].SetMapper(mapper)
            else:
                grid.SetPoints(points)
            self.render()  # maps keep their place while things move
            sky, _, said = self.render()
            return sky, said

        before, said = draw()
        self.assertIn("in place of", said)
        smaller = vtkPoints()
        for i in range(grid.GetNumberOfPoints()):
            smaller.InsertNextPoint(*(0.8 * x for x in grid.GetPoint(i)))
        live, said = draw(smaller)
        self.assertIn("in place of", said)
        fresh, _ = draw()
        self.assertGreater(np.abs(live - before).max(), 0.1)
        np.testing.assert_allclose(live, fresh, atol=1e-5)

    def test_a_level_in_front_of_its_mesh_hides_nothing_of_it(self) -> None:
        # The ball fills the maps: half a texel is 0.0079, what lookups allow for 0.0022.
        self.renderer.RemoveActor(self.actors[1])
        before = self.render()[0]
        self.indirect.AddCoarseLevel(
            self.actors[0], ball(FINE, 1.006).GetOutput(), 0.006 + 1.0 - np.cos(np.pi / FINE) ** 2
        )
        after, _, said = self.render()
        self.assertIn("in place of", said)
        lost = (before - after).max() / before.max()
        print(f"loses {lost:.3f} of the light at most")
        self.assertLess(lost, 0.02)  # 0.015; 0.054 of a level that is not behind its mesh

    def test_a_level_that_is_too_far_off_is_not_taken(self) -> None:
        before = self.render()[0]
        # A map is 12 wide at least in 128 texels: half a texel is 0.05 to 0.08.
        self.indirect.AddCoarseLevel(self.actors[0], ball(8).GetOutput(), 0.3)
        after, _, said = self.render()
        self.assertIn("used by no map", said)
        np.testing.assert_array_equal(before, after)

    def test_levels_go_when_the_mesh_changes(self) -> None:
        self.render()
        self.indirect.AddCoarseLevel(self.actors[0], ball(COARSE).GetOutput(), ERROR)
        self.assertIn("in place of", self.render()[2])
        moved = vtkPoints()
        moved.DeepCopy(self.mesh.GetPoints())
        self.mesh.SetPoints(moved)
        self.assertEqual(self.render()[2], "")

    def test_bad_levels_are_one_error(self) -> None:
        errors = []
        self.indirect.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        good = ball(COARSE).GetOutput()
        for prop, level, error in (
            (self.actors[0], good, -1.0),
            (self.actors[0], good, float("nan")),
            (self.actors[0], self.mesh, 0.0),
            (vtkActor(), good, 0.1),
            (self.actors[0], None, 0.1),
        ):
            errors.clear()
            self.indirect.AddCoarseLevel(prop, level, error)
            self.assertEqual(len(errors), 1)


if __name__ == "__main__":
    unittest.main()
