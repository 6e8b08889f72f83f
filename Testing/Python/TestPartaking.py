# SPDX-License-Identifier: BSD-3-Clause
"""One warning says which props take no part in indirect light."""

import unittest
import unittest.mock
import warnings

from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTextActor

import support
import vtkindirect
from vtkindirect import partaking

WHY_NOT = support.why_no_rendering()


def actor(source) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    made = vtkActor()
    made.SetMapper(mapper)
    return made


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Partaking(unittest.TestCase):
    def setUp(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor(vtkSphereSource()))
        text = vtkTextActor()
        text.SetInput("annotation")
        self.renderer.AddViewProp(text)
        self.window = vtkindirect.render_window((64, 48), offscreen=True)
        self.window.AddRenderer(self.renderer)
        vtkindirect.enable(self.renderer)
        self.addCleanup(self.window.Finalize)

    def warned(self) -> list[warnings.WarningMessage]:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            self.window.Render()
        return list(caught)

    def test_surfaces_and_annotation_warn_of_nothing(self) -> None:
        self.assertEqual(self.warned(), [])

    def test_one_warning_when_a_line_comes(self) -> None:
        self.assertEqual(self.warned(), [])
        self.renderer.AddActor(actor(vtkLineSource()))
        (warning,) = self.warned()
        self.assertRegex(
            str(warning.message),
            "^without a part in indirect light: vtkOpenGLActor.*: lines and points are sized",
        )
        self.assertEqual(warning.filename, __file__)
        self.renderer.AddActor(actor(vtkLineSource()))
        self.assertEqual(self.warned(), [])

    def test_still_frames_on_a_ground_read_no_report(self) -> None:
        vtkindirect.enable(self.renderer, ground=True)
        self.window.Render()
        with unittest.mock.patch.object(
            partaking, "props_left_out", wraps=partaking.props_left_out
        ) as read:
            for _ in range(3):
                self.window.Render()
            self.assertEqual(read.call_count, 0)
            self.renderer.AddActor(actor(vtkSphereSource()))
            self.window.Render()
            self.assertEqual(read.call_count, 1)


if __name__ == "__main__":
    unittest.main()
