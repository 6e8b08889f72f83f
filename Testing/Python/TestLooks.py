# SPDX-License-Identifier: BSD-3-Clause
"""Looks of a data file: the side that is seen, colours, the background and the ground."""

import argparse
import json
import re
import unittest
from typing import Any
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTubeFilter
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkCylinderSource,
    vtkLineSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter

import support
from vtkindirect import (
    UsageError,
    arrays,
    bodies,
    cli,
    data,
    load_scene,
    looks,
    methods,
    options,
    viewer,
    windows,
)

WHY_NOT = support.why_no_rendering()


def made(source: Any) -> vtkPolyData:
    source.Update()
    return source.GetOutput()


def ball(radius: float = 0.5, resolution: int = 24, end: float = 180.0) -> vtkPolyData:
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetEndPhi(end)
    return made(source)


def add(data: Any, name: str, values: np.ndarray) -> None:
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


class DataFile(support.DirectoryTest):
    def save(self, held: Any, name: str = "data.vtp") -> Any:
        writer = vtkXMLDataSetWriter()
        writer.SetInputData(held)
        writer.SetFileName(str(self.directory / name))
        writer.Write()
        return self.directory / name

    def two_arrays(self) -> Any:
        """Return the path of a ball with "height" as its active scalars and "east", and colours."""
        body = ball()
        points = vtk_to_numpy(body.GetPoints().GetData())
        add(body, "height", points[:, 2])
        add(body, "east", points[:, 0])
        add(body, "same", np.ones(len(points)))
        add(body, "speed", 2.0 * points * (1.0 + points[:, 2:]))
        add(body, "paint", np.full((len(points), 3), (10, 200, 30), np.uint8))
        body.GetPointData().SetActiveScalars("height")
        return self.save(body)


class Colors(DataFile):
    def mapper(self, **words: Any) -> Any:
        self.scene = load_scene(self.two_arrays(), **words)
        (actor,) = self.scene.actors.values()
        return actor.GetMapper()

    def test_active_scalars_over_their_range(self) -> None:
        mapper = self.mapper()
        self.assertEqual(mapper.GetArrayName(), "height")
        np.testing.assert_allclose(mapper.GetLookupTable().GetTableRange(), (-0.5, 0.5), atol=0.01)
        self.assertRegex(self.scene.notes[0], "coloured by 'height', -0.5 to 0.5; color_by names")

    def test_an_array_that_is_named(self) -> None:
        mapper = self.mapper(color_by="east")
        self.assertEqual((mapper.GetArrayName(), self.scene.notes), ("east", []))
        self.assertEqual(self.mapper(color_by="paint").GetArrayName(), "paint")
        self.assertEqual(self.mapper(color_by="paint").GetColorMode(), 2)  # the bytes themselves
        lengths = self.mapper(color_by="speed").GetLookupTable().GetTableRange()
        np.testing.assert_allclose(lengths, (0.5, 1.5), atol=0.02)

    def test_none_and_constant_arrays(self) -> None:
        self.assertFalse(self.mapper(color_by="none").GetScalarVisibility())
        self.assertFalse(self.mapper(color_by="same").GetScalarVisibility())
        self.assertEqual(self.scene.notes, ["not coloured by 'same', which is constant here"])

    def test_an_unknown_array(self) -> None:
        with self.assertRaisesRegex(UsageError, r"vtp: color_by: no array 'hight' \(did you mean"):
            self.mapper(color_by="hight")

    def test_an_iso_surface_by_another_array(self) -> None:
        image = vtkImageData()
        image.DeepCopy(made(vtkRTAnalyticSource()))
        add(image, "east", np.arange(image.GetNumberOfPoints(), dtype=float) % 21)
        path = self.save(image, "data.vti")
        (actor,) = load_scene(path).actors.values()
        self.assertFalse(actor.GetMapper().GetScalarVisibility())
        (actor,) = load_scene(path, color_by="east").actors.values()
        self.assertEqual(actor.GetMapper().GetArrayName(), "east")
        low, high = actor.GetMapper().GetLookupTable().GetTableRange()
        self.assertTrue(0.0 <= low < 8.0 < 12.0 < high <= 20.0)

    def test_backgrounds(self) -> None:
        path = self.two_arrays()
        for value, expected in (
            (None, looks.BACKGROUND),
            ("black", (0.0, 0.0, 0.0)),
            ("#0080ff", (0.0, 128 / 255, 1.0)),
            ((0.25, 0.5, 0.75), (0.25, 0.5, 0.75)),
        ):
            found = load_scene(path, background=value).renderer.GetBackground()
            np.testing.assert_allclose(found, expected)
        for value in ("wite", "#12", (1.0, 2.0, 0.0), (1.0, 0.0), 3):
            with self.subTest(value=value), self.assertRaisesRegex(UsageError, "^background"):
                load_scene(path, background=value)


class Sides(DataFile):
    def toward(self, surface: vtkPolyData, **words: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return the directions from the data to the camera and up."""
        camera = load_scene(self.save(surface), **words).renderer.GetActiveCamera()
        return -np.array(camera.GetDirectionOfProjection()), np.array(camera.GetViewUp())

    def test_sides_and_directions(self) -> None:
        body = made(vtkCubeSource())
        x, y, z = np.eye(3)
        for view, toward, up in (
            ("x", x, z), ("-x", -x, z), ("y", y, z), ("-y", -y, z), ("z", z, y), ("-z", -z, y),
            ("iso", (x + y + z) / 3**0.5, None), ((0.0, -3.0, 4.0), (-0.6 * y + 0.8 * z), None),
        ):  # fmt: skip
            with self.subTest(view=view):
                found, above = self.toward(body, view=view)
                np.testing.assert_allclose(found, toward, atol=1e-12)
                if up is not None:
                    np.testing.assert_allclose(above, up, atol=1e-12)
                self.assertGreater(above @ (y if up is y else z), 0.5)

    def test_what_is_up(self) -> None:
        for name in ("x", "-x", "y", "-y", "z", "-z"):
            axis = (-1.0 if name[0] == "-" else 1.0) * np.eye(3)["xyz".index(name[-1])]
            found, above = self.toward(made(vtkCubeSource()), up=name)
            self.assertGreater(found @ axis, 0.3)  # it is seen obliquely from above
            self.assertGreater(above @ axis, 0.8)

    def test_a_named_side_is_seen_however_thin(self) -> None:
        plane = vtkPlaneSource()
        plane.SetNormal(1.0, -1.0, 0.0)
        usual, _ = self.toward(made(plane))
        self.assertGreater(abs(usual @ (1.0, -1.0, 0.0)), 1.4)
        edge, _ = self.toward(made(plane), view="iso")
        self.assertLess(abs(edge @ (1.0, -1.0, 0.0)), 1e-6)

    def test_flat_terrain_is_seen_from_above_at_an_angle(self) -> None:
        found, _ = self.toward(made(vtkPlaneSource()))
        self.assertTrue(0.4 < found[2] < 0.8)

    def test_mistakes(self) -> None:
        path = self.save(ball())
        for view in ("top", (0.0, 0.0, 0.0), (1.0, 2.0), (1.0, float("nan"), 0.0), 7):
            with self.subTest(view=view), self.assertRaisesRegex(UsageError, "view"):
                load_scene(path, view=view)
        with self.assertRaisesRegex(UsageError, "unknown up 'w'"):
            load_scene(path, up="w")

    def test_a_scene_file_says_it_itself(self) -> None:
        path = self.write("scene.json", support.small_scene())
        for word, value in (("view", "x"), ("color_by", "t"), ("up", "y")):
            with self.assertRaisesRegex(UsageError, f"{word} is for data files"):
                load_scene(path, **{word: value})
        scene = load_scene(path, background="white")
        self.assertEqual(scene.renderer.GetBackground(), (1.0, 1.0, 1.0))
        self.assertEqual((scene.up, scene.can_stand), (None, False))


class Bodies(unittest.TestCase):
    def tubes(self, count: int) -> vtkPolyData:
        """Return tubes 100 times as long as thick, side by side."""
        both = vtkAppendPolyData()
        for index in range(count):
            line, tube = vtkLineSource(), vtkTubeFilter()
            line.SetPoint1(index, 0.0, 0.0)
            line.SetPoint2(index, 0.0, 20.0)
            tube.SetInputConnection(line.GetOutputPort())
            tube.SetRadius(0.1)
            tube.SetNumberOfSides(12)
            tube.CappingOn()
            both.AddInputData(made(tube))
        return made(both)

    def test_what_can_stand(self) -> None:
        flat = vtkPlaneSource()
        flat.SetResolution(4, 4)
        nothing = vtkPolyData()
        nothing.SetPoints(ball().GetPoints())
        for what, surface, expected in (
            ("a cube", made(vtkCubeSource()), True),
            ("a ball far away", ball(1e6), True),
            ("a ball with a hole", ball(end=150.0), True),
            ("a pot of half a ball", ball(end=90.0), False),
            ("a cylinder", made(vtkCylinderSource()), True),
            ("a sheet", made(flat), False),
            ("many tubes", self.tubes(20), False),
            ("points", nothing, False),
        ):
            with self.subTest(what=what):
                self.assertEqual(bodies.can_stand(surface), expected)

    def test_shares_of_a_ball_are_closed_forms(self) -> None:
        # A box of 1 x 1 x h holds 6 sqrt(pi) h / (2 + 4 h)^1.5 of a ball with the same area: a
        # tenth as a plate of h = 0.029 and as a rod of h = 175.2.
        for height in (0.0285, 0.0295, 1.0, 175.0, 176.0):
            box = vtkCubeSource()
            box.SetZLength(height)
            share = 6.0 * np.pi**0.5 * height / (2.0 + 4.0 * height) ** 1.5
            self.assertEqual(bodies.can_stand(made(box)), share >= bodies.COMPACT, height)
            self.assertEqual(share >= bodies.COMPACT, 0.029 < height < 175.2)


class Words(DataFile):
    """Options of the command line as words for a data file."""

    def parsed(self, *words: str, surface: vtkPolyData | None = None) -> dict[str, Any]:
        path = self.save(surface or ball())
        arguments = cli.commands()[cli.PROGRAM].parse_args(["render", str(path), *words])
        self.scene = load_scene(path, **options.parse_look(arguments))
        return options.suited(options.parse(arguments), self.scene)

    def test_a_ground_where_one_helps(self) -> None:
        sheet = made(vtkPlaneSource())
        for words, surface, expected in (
            ([], None, "z"),
            (["--up", "-y"], None, "-y"),
            (["--view", "z"], None, "z"),  # the camera's view-up is y then
            (["--no-ground"], None, None),
            (["--background", "black"], None, None),
            (["--background", "0,0,0", "--ground"], None, "z"),
            ([], sheet, None),
            (["--ground"], sheet, "z"),
        ):
            with self.subTest(words=words):
                self.assertEqual(self.parsed(*words, surface=surface).get("ground"), expected)

    def test_a_picture_has_room_for_the_ground(self) -> None:
        heights = []
        for words in (["--no-ground"], []):
            self.parsed(*words)
            camera = self.scene.renderer.GetActiveCamera()
            heights.append(0.5 / np.linalg.norm(camera.GetPosition()))
        self.assertTrue(0.6 < heights[1] / heights[0] < 0.95, heights)

    def test_the_axis_of_the_data_is_up_for_a_sun(self) -> None:
        self.assertEqual(self.parsed("--view", "z", "--sun", "10,40")["up"], "z")
        self.assertEqual(self.parsed("--up", "y", "--environment", "clear")["up"], "y")
        self.assertNotIn("up", self.parsed("--up", "y"))
        self.assertNotIn("up", self.parsed("--environment", "1,1,1"))

    def test_values_with_a_minus_sign(self) -> None:
        self.parsed("--view", "-x")
        np.testing.assert_allclose(
            self.scene.renderer.GetActiveCamera().GetDirectionOfProjection(), (1, 0, 0), atol=1e-12
        )
        self.parsed("--view", "-1,0,0")
        self.assertEqual(self.parsed("--sun", "-10,40")["sun"], [-10.0, 40.0])
        result = support.command_line_here("render", "x.vtp", "--view", "-o", "a.png")
        self.assertIn("argument --view: expected one argument", result.stderr)

    def test_a_scene_file_keeps_its_settings(self) -> None:
        path = self.write("scene.json", support.small_scene())
        arguments = argparse.Namespace(scene=str(path), up="y", sun="10,40")
        scene = load_scene(path, **options.parse_look(arguments))
        words = options.suited(options.parse(arguments), scene)
        self.assertEqual(words, {"up": "y", "sun": [10.0, 40.0]})


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Pictures(DataFile):
    def render(self, *words: str) -> np.ndarray:
        path = self.two_arrays()
        output = self.directory / "a.png"
        draft = () if "off" in words else ("--quality", "draft")
        result = support.command_line_here(
            "render", path, "-o", output, "--size", "48x40", *draft, *words
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        return arrays.as_array(data.read_image(output)).astype(int)

    def test_what_surrounds_the_data(self) -> None:
        plain = self.render("--no-ground")
        np.testing.assert_array_equal(plain[[0, 0, -1, -1], [0, -1, 0, -1], :3], 255)
        ground = self.render()
        # There is a soft shadow below the ball, in the lower half of the picture.
        lower = ground[:20, :, :3].min(axis=2)
        self.assertGreater(((lower > 200) & (lower < 253)).sum(), 50)
        self.assertEqual(tuple(self.render("--background", "#102030")[-1, 0, :3]), (16, 32, 48))

    def test_without_indirect_light_the_data_are_at_the_same_place(self) -> None:
        words = ("--up", "-x", "--view", "y")
        shown = [
            self.render(*words, *more)[..., :3].min(axis=2) < 190
            for more in ([], ["--method", "off"], ["--method", "off", "--no-ground"])
        ]
        columns = [np.flatnonzero(one.any(axis=0)) for one in shown]
        self.assertLessEqual(abs(int(columns[0][0]) - int(columns[1][0])), 1)
        self.assertLess(columns[2][0], columns[1][0] - 1)

    def test_colours_and_sides(self) -> None:
        """Viridis ends in yellow, which has little blue, where the array is greatest."""
        words = ("--no-ground", "--view", "-y", "--lighting", "scene")
        for name, where in (("height", (30, 24)), ("east", (20, 32))):
            picture = self.render(*words, "--color-by", name)
            other = picture[39 - where[0], 47 - where[1]]
            self.assertLess(picture[where][2], 0.6 * picture[where][1], name)
            self.assertGreater(other[2], other[1], name)

    def test_the_window_shows_the_same(self) -> None:
        """Without a display the window is one off screen, and nobody presses a key but the test."""

        class Interactor(mock.MagicMock):
            def AddObserver(self, _event: str, called: Any) -> None:
                self.GetKeySym.return_value = "i"
                seen.append(self)
                self.press = lambda: called(self, "KeyPressEvent")

        seen: list[Any] = []
        make = windows.render_window
        for words, lit in (((), True), (("--method", "off"), False)):
            with (
                mock.patch.object(viewer, "vtkRenderWindowInteractor", Interactor),
                mock.patch.object(windows, "has_display", return_value=True),
                mock.patch.object(windows, "render_window", lambda size, **_: make(size, True)),
                mock.patch.object(viewer.methods, "enable", wraps=methods.enable) as enabled,
            ):
                result = support.command_line_here(
                    "view", self.two_arrays(), "--view", "-y", "--size", "48x40", *words
                )
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(enabled.call_count, int(lit))
                seen[-1].press()  # off, or on
                seen[-1].press()
                self.assertEqual(enabled.call_args.kwargs, {"ground": "z"})
            renderer = enabled.call_args.args[0]
            self.assertEqual(renderer.GetBackground(), looks.BACKGROUND)
            toward = renderer.GetActiveCamera().GetDirectionOfProjection()
            np.testing.assert_allclose(toward, (0.0, 1.0, 0.0), atol=1e-12)

    def test_defaults_that_the_help_and_the_page_name(self) -> None:
        """Each is what a picture has of which nothing else is said."""
        report = self.directory / "r.json"
        self.scene = load_scene(self.two_arrays())
        self.render("--size", "16x12", "--report", str(report), "--quality", "interactive")
        found = json.loads(report.read_text())
        parser = cli.commands()["render"]
        defaults = {
            "--method": parser.get_default("method"),
            "--lighting": f"auto, which is {found['lighting']['used']}",
            "--preset": found["settings"]["Preset"],
            "--quality": options.qualities.DEFAULT,
            "--tone-mapping": found["tone_mapping"]["curve"],
            "--exposure": f"{found['tone_mapping']['exposure']:g}",
            "--up": self.scene.up,
            "--view": "iso",
            "--background": "white",
            "--buffer": parser.get_default("buffer"),
            "--frames": str(parser.get_default("frames")),
        }
        # Words that name what is not the same in all pictures.
        others = ("--sampler", "--color-by", "--environment", "--ground", "--output", "--size")
        page = (support.SOURCE / "Documentation" / "command-line.md").read_text(encoding="utf-8")
        for action in parser._actions:
            option = next((name for name in action.option_strings if name.startswith("--")), None)
            if option is None or "default" not in (action.help or ""):
                continue
            if option in others:
                continue
            value = defaults.pop(option)
            said = re.search(r"(\w+) \(default\)|default: (.+)\)", action.help)
            text = said[1] or said[2]
            self.assertRegex(text, rf"^{re.escape(value)}\b", option)
            row = re.findall(rf"^\| `{option}[ `].*", page, re.MULTILINE)[0]
            word = value.split()[-1]
            pattern = rf"`{word}` \(default\)|default: `?{word}\b|`auto` \(default\): `{word}`"
            self.assertRegex(row, pattern, option)
        self.assertEqual(defaults, {})


if __name__ == "__main__":
    unittest.main()
