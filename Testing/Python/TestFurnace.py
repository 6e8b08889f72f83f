# SPDX-License-Identifier: BSD-3-Clause
"""The white furnace: an irradiance of 1 under a sky of 1, and the command that measures it."""

import unittest

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import support
from vtkindirect import frames, furnace, load_scene
from vtkindirect.frames import Job

LEAST = {"contact_corner": 0.98, "cornell_box": 0.94, "sky_particles": 0.93}
"""Mean irradiance of scenes at 192 x 192 pixels; 0.98 is the goal. Measured: 0.992, 0.957, 0.949."""
MOST = 1.02
"""Largest irradiance of a pixel: surfaces invent no light."""


@unittest.skipIf(support.why_no_rendering(), support.why_no_rendering())
class Furnace(support.DirectoryTest):
    def measured(self, path) -> furnace.Furnace:
        scene = load_scene(path)
        window = frames.open_window(scene, (192, 192))
        found = furnace.measure(scene, window, Job("auto", lighting="scene"))
        window.Finalize()
        return found

    def test_scenes_lose_little_light_and_invent_none(self) -> None:
        for name, least in LEAST.items():
            with self.subTest(scene=name):
                found = self.measured(support.SCENES / f"{name}.json")
                print(found.line(name))
                self.assertGreater(found.values.mean(), least)
                self.assertLess(found.values.max(), MOST)

    def dark_ball(self) -> str:
        """A file of a ball whose colours reflect nothing."""
        ball = vtkSphereSource()
        ball.SetThetaResolution(48)
        ball.SetPhiResolution(48)
        ball.Update()
        data = ball.GetOutput()
        colors = vtkUnsignedCharArray()
        colors.SetName("RGB")
        colors.SetNumberOfComponents(3)
        colors.SetNumberOfTuples(data.GetNumberOfPoints())
        colors.Fill(0)
        data.GetPointData().SetScalars(colors)
        writer = vtkXMLPolyDataWriter()
        path = str(self.directory / "ball.vtp")
        writer.SetFileName(path)
        writer.SetInputData(data)
        writer.Write()
        return path

    def test_a_convex_body_sees_the_sky_alone(self) -> None:
        # 256 directions integrate a cosine to 0.5 %.
        values = self.measured(self.dark_ball()).values
        self.assertLess(abs(values.mean() - 1.0), 0.005)

    def test_command(self) -> None:
        output = self.directory / "white.exr"
        done = support.command_line(
            "furnace", self.dark_ball(), "--size", "64x48", "-o", output
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^ball: mean (0\.99|1\.00)\d+, least .* of 1 at \d+ pixels\n")
        self.assertTrue(done.stdout.endswith(f"{output}\n"))
        self.assertTrue(output.is_file())

    def test_wrong_words_are_one_line(self) -> None:
        for words, said in ((("--method", "off"), "irradiance"), (("--lighting", "full"), "--lighting")):
            done = support.command_line("furnace", self.dark_ball(), *words)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
