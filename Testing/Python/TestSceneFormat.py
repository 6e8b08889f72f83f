# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: every kind of mistake is one error that names the key; what is right is built."""

import json
import math
import struct
import unittest
from typing import Any
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_COLOR_MODE_DIRECT_SCALARS

import support
from vtkindirect import SceneError, UsageError, colormaps, load_scene, schema, wrapped


def _set(document: Any, path: list, value: Any) -> None:
    """Set, or with the value `_set` remove, an entry of a document."""
    for step in path[:-1]:
        document = document[step]
    if value is _set:
        del document[path[-1]]
    else:
        document[path[-1]] = value


# Changes of the small scene, and the words that the message must have.
MISTAKES = [
    (["schema"], _set, "schema: is missing"),
    (["schema"], "vtkindirect.scene/2", "schema: must be one of vtkindirect.scene/1"),
    (["sise"], [1, 1], "sise: unknown key (did you mean 'size'?)"),
    (["size"], [0, 48], "size[0]: must be from 1 to 16384, not 0"),
    (["size"], [64], "size: must have 2 items, not 1"),
    (["size"], [64.5, 48], "size[0]: must be a whole number"),
    (["size"], "big", "size: must be a list, not 'big'"),
    (["background"], [0, 0, 2], "background[2]: must be at most 1, not 2"),
    (["name"], "", "name: must not be empty"),
    (["camera"], _set, "camera: is missing"),
    (["camera", "position"], _set, "camera.position: is missing"),
    (["camera", "position"], [0, 0, "z"], "camera.position[2]: must be a number, not 'z'"),
    (["camera", "position"], [0.5, 0.4, 0], "camera.focal_point: must differ from position"),
    (["camera", "view_up"], [0, 0, 0], "camera.view_up: must not be the zero vector"),
    (["camera", "view_up"], [0, 0.4, 3], "camera.view_up: must not be parallel"),
    (["camera", "view_angle"], 180, "camera.view_angle: must be less than 180"),
    (["camera", "clipping_range"], [0, 1], "camera.clipping_range[0]: must be greater than 0"),
    (["camera", "clipping_range"], [2, 1], "camera.clipping_range: the second number must be"),
    (["camera", "zoom"], 1, "camera.zoom: unknown key"),
    (["lights"], _set, "lights: is missing"),
    (["lights"], [], "lights: must have at least 1 item"),
    (["lights", 0], "sun", "lights[0]: must be an object, not 'sun'"),
    (["lights", 0, "type"], _set, "lights[0].type: is missing"),
    (["lights", 0, "type"], "sppot", "lights[0].type: must be one of spot, point"),
    (
        ["lights", 0],
        {"type": "area", "origin": [0, 0, 0], "point1": [1, 0, 0]},
        "lights[0].point2: is missing",
    ),
    (
        ["lights", 0],
        {"type": "area", "origin": [0, 0, 0], "point1": [1, 0, 0], "point2": [2, 0, 0]},
        "lights[0].point2: origin, point1 and point2 must span an area",
    ),
    (["lights", 0], {"type": "environment"}, "lights[0]: must have either file or radiance"),
    (
        ["lights", 0],
        {"type": "environment", "radiance": [1, 1, 1], "file": "a.exr"},
        "lights[0]: must have either file or radiance",
    ),
    (
        ["lights", 0],
        {"type": "environment", "radiance": [1, -1, 1]},
        "lights[0].radiance[1]: must be at least 0, not -1",
    ),
    (
        ["lights", 0],
        {"type": "environment", "radiance": [1, 1, 1], "up": [0, 0, 1]},
        "lights[0].up: cannot be given together with radiance",
    ),
    (
        ["lights", 0],
        {"type": "environment", "file": "a.exr", "right": [0, 2, 0]},
        "lights[0].right: must not be parallel to up",
    ),
    (
        ["lights"],
        [{"type": "environment", "radiance": [1, 1, 1]}] * 2,
        "lights[1]: is a second environment beside lights[0]",
    ),
    (["lights", 0], {"type": "environment", "file": "no.exr"}, "no.exr: no such file"),
    (
        ["lights", 0],
        {"type": "environment", "file": "scene.json"},
        "lights[0].file: ",
    ),
    (["lights", 0, "cone_angle"], 90, "lights[0].cone_angle: must be less than 90, not 90"),
    (["lights", 0, "cone_angle"], 0, "lights[0].cone_angle: must be greater than 0"),
    (["lights", 0, "intensity"], -1, "lights[0].intensity: must be at least 0, not -1"),
    (["lights", 0, "color"], [1, 1], "lights[0].color: must have 3 items, not 2"),
    (["lights", 0, "attenuation"], [0, 0, 0], "lights[0].attenuation: must not be all zero"),
    (["lights", 0, "attenuation"], [1, -1, 0], "lights[0].attenuation[1]: must be at least 0"),
    (["lights", 0, "focal_point"], [1.5, 1.5, 1.5], "lights[0].focal_point: must differ"),
    (["lights", 0, "direction"], [0, 0, 1], "lights[0].direction: unknown key"),
    (["lights", 0, "radius"], -0.1, "lights[0].radius: must be at least 0, not -0.1"),
    (["lights", 0, "radius"], "big", "lights[0].radius: must be a number, not 'big'"),
    (["lights", 0, "angle"], 0.27, "lights[0].angle: unknown key"),
    (
        ["lights", 0],
        {"type": "directional", "direction": [0, -1, 0], "angle": 91},
        "lights[0].angle: must be at most 90, not 91",
    ),
    (["actors"], _set, "actors: is missing"),
    (["actors"], [], "actors: must have at least 1 item"),
    (["actors", 0], 3, "actors[0]: must be an object, not 3"),
    (["actors", 0, "source"], _set, "actors[0].origin: unknown key"),
    (["actors", 0, "source"], "plain", "actors[0].source: must be one of plane"),
    (["actors", 0, "source"], 7, "actors[0].source: must be one of plane"),
    (["actors", 1, "source"], {}, "actors[1].source: must hold exactly one class of VTK, not 0"),
    (["actors", 1, "source"], {"Cone": {}}, "actors[1].source.Cone: unknown key"),
    (["actors", 1, "source"], {"vtkConeSource": 1}, "vtkConeSource: must be an object, not 1"),
    (["actors", 0, "file"], "a.vtp", "actors[0]: must have either file or source"),
    (["actors", 0, "point1"], _set, "actors[0].point1: is missing"),
    (["actors", 0, "point1"], [0, 0, 1], "actors[0].point2: origin, point1 and point2 must span"),
    (["actors", 0, "resolution"], [0, 1], "actors[0].resolution[0]: must be from 1 to 2048"),
    (["actors", 0, "colour"], [1, 1, 1], "actors[0].colour: unknown key (did you mean 'color'?)"),
    (["actors", 0, "color"], [1, 1, 1.5], "actors[0].color[2]: must be at most 1"),
    (["actors", 0, "opacity"], 2, "actors[0].opacity: must be at most 1"),
    (["actors", 0, "opacity"], True, "actors[0].opacity: must be a number, not true"),
    (["actors", 0, "visible"], 1, "actors[0].visible: must be true or false, not 1"),
    (["actors", 0, "interpolation"], "blinn", "actors[0].interpolation: must be one of phong"),
    (["actors", 0, "refraction_index"], 0.5, "actors[0].refraction_index: must be at least 1"),
    (["actors", 0, "transform"], [1] * 15, "actors[0].transform: must have 16 items, not 15"),
    (["actors", 0, "transform"], [0] * 15 + [1], "actors[0].transform: must be invertible"),
    (["actors", 0, "transform"], [1] * 16, "actors[0].transform: the last row must be 0, 0, 0, 1"),
    (["actors", 0, "pipeline"], {}, "actors[0].pipeline: must be a list, not an object"),
    (["actors", 0, "pipeline"], [{}], "actors[0].pipeline[0]: must hold exactly one step, not 0"),
    (["actors", 0, "pipeline"], [{"smoth": {}}], "pipeline[0].smoth: unknown key (did you mean"),
    (
        ["actors", 0, "pipeline"],
        [{"surface": {}}, {"contour": {"array": "t"}}],
        "actors[0].pipeline[1].contour.value: is missing",
    ),
    (
        ["actors", 0, "pipeline"],
        [{"contour": {"value": "hot"}}],
        "actors[0].pipeline[0].contour.value: must be a number, not 'hot'",
    ),
    (
        ["actors", 0, "pipeline"],
        [{"contour": {"array": "t", "value": 1}}],
        "actors[0].pipeline[0].contour.array: no array 't'; known: ",
    ),
    (
        ["actors", 0, "scalars"],
        {"array": "t"},
        "actors[0].color: cannot be given together with scalars",
    ),
]

SLOW_SCENES = (
    "frog", "brain", "protein", "room_fire", "apartment_living", "sky_statue", "sky_frog"
)  # fmt: skip


class Mistakes(support.DirectoryTest):
    """Each mistake gives one line that names the place in the document."""

    def error_of(self, content: Any) -> str:
        path = self.write("scene.json", content)
        with self.assertRaises(SceneError) as caught:
            load_scene(path)
        text = str(caught.exception)
        self.assertTrue(text.startswith(f"{path}: "), text)
        self.assertNotIn("\n", text)
        return text

    def test_mistakes_are_named(self) -> None:
        for path, value, expected in MISTAKES:
            with self.subTest(path=path, value=value):
                document = support.small_scene()
                _set(document, path, value)
                self.assertIn(expected, self.error_of(document))

    def test_numbers_that_are_not_finite(self) -> None:
        text = json.dumps(support.small_scene())
        for number in ("NaN", "Infinity", "-Infinity"):
            wrong = text.replace('"cone_angle": 40', f'"cone_angle": {number}')
            self.assertIn(f"{number} is not a JSON number", self.error_of(wrong))
        for number in ("1e999", "1" + "0" * 400):
            wrong = text.replace('"cone_angle": 40', f'"cone_angle": {number}')
            self.assertIn("lights[0].cone_angle: must be a finite number", self.error_of(wrong))

    def test_duplicate_keys(self) -> None:
        text = json.dumps(support.small_scene())
        twice = text.replace('"source": "plane",', '"source": "plane", "source": "box",', 1)
        self.assertIn("actors[0].source: is given twice", self.error_of(twice))
        twice = text.replace('"name": "small",', '"name": "a", "name": "b",', 1)
        self.assertIn("name: is given twice", self.error_of(twice))

    def test_text_that_is_not_a_scene(self) -> None:
        self.assertIn("not JSON: ", self.error_of('{"schema": '))
        self.assertIn("line 2, column", self.error_of('{"schema":\n oops}'))
        self.assertIn("must hold one JSON object", self.error_of("[1, 2]"))
        self.assertIn("not UTF-8", self.error_of(b'{"name": "\xff\xfe"}'))
        self.assertIn("nested too deeply", self.error_of("[" * 100000))
        self.assertIn("schema: is missing", self.error_of("{}"))

    def test_data_files(self) -> None:
        document = support.small_scene()
        document["actors"][0] = {"file": "missing.vtp"}
        self.assertIn("actors[0].file: ", self.error_of(document))
        self.assertIn("missing.vtp: no such file", self.error_of(document))
        self.write("cut.vtp", (support.DATA / "room_vis.vtp").read_bytes()[:1500])
        document["actors"][0] = {"file": "cut.vtp"}
        self.assertIn("cut.vtp: cannot be read: ", self.error_of(document))

    def test_points_that_are_not_finite(self) -> None:
        header = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n"
        points = struct.pack(">9f", 0, 0, 0, math.nan, 1, 0, 0, 1, 0)
        triangle = b"\nPOLYGONS 1 4\n" + struct.pack(">4i", 3, 0, 1, 2)
        self.write("nan.vtk", header.encode() + points + triangle + b"\n")
        document = support.small_scene()
        document["actors"].append({"file": "nan.vtk"})
        self.assertIn("actors[2]: point 1 is not finite", self.error_of(document))

    def test_nothing_to_see(self) -> None:
        document = support.small_scene()
        for actor in document["actors"]:
            actor["visible"] = False
        self.assertIn("actors: none of them is visible", self.error_of(document))
        header = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
        self.write("line.vtk", header + "0 0 0 1 0 0\nLINES 1 3\n2 0 1\n")
        document = support.small_scene()
        document["actors"] = [{"file": "line.vtk"}]
        self.assertIn("actors: they have no area to show", self.error_of(document))

    def test_paths_that_are_not_scenes(self) -> None:
        for name, expected in (
            ("none.json", "no such file"),
            ("", "is a directory"),
            ("empty.json", "the file is empty"),
            ("text.xyz", "unknown kind of file '.xyz'"),
        ):
            self.write("empty.json", "")
            self.write("text.xyz", "x")
            with self.subTest(name=name), self.assertRaises(UsageError) as caught:
                load_scene(self.directory / name)
            self.assertIn(expected, str(caught.exception))


class Package(unittest.TestCase):
    def test_without_jsonschema_one_line_says_so(self) -> None:
        schema._validators.cache_clear()
        with mock.patch.dict("sys.modules", {"jsonschema": None}):
            with self.assertRaisesRegex(ImportError, "^scene files need jsonschema.*python3-json"):
                schema.check({})


class Built(support.DirectoryTest):
    """The renderer has the content of a correct scene."""

    def load(self, document: Any) -> Any:
        return load_scene(self.write("scene.json", document))

    def test_defaults(self) -> None:
        document = support.small_scene()
        for key in ("name", "size"):
            del document[key]
        scene = self.load(document)
        self.assertEqual(scene.name, "scene")
        self.assertEqual(scene.size, (512, 512))
        self.assertEqual(scene.renderer.GetBackground(), (0.0, 0.0, 0.0))
        camera = scene.renderer.GetActiveCamera()
        self.assertEqual(camera.GetViewAngle(), 30.0)
        self.assertEqual(camera.GetViewUp(), (0.0, 1.0, 0.0))
        near, far = camera.GetClippingRange()
        self.assertLess(near, 2.1)
        self.assertGreater(far, 3.0)

    def test_camera(self) -> None:
        document = support.small_scene()
        document["camera"].update(parallel_scale=0.7, clipping_range=[0.5, 9])
        camera = self.load(document).renderer.GetActiveCamera()
        self.assertTrue(camera.GetParallelProjection())
        self.assertEqual(camera.GetParallelScale(), 0.7)
        self.assertEqual(camera.GetClippingRange(), (0.5, 9.0))

    def test_lights(self) -> None:
        document = support.small_scene()
        document["lights"] += [
            {
                "type": "point",
                "position": [0, 1, 0],
                "color": [1, 0.5, 0],
                "attenuation": [0, 0, 2],
            },
            {"type": "directional", "direction": [0, -2, 0], "intensity": 3},
            {"type": "headlight", "intensity": 0.25},
        ]
        spot, point, sun, head = self.load(document).lights
        self.assertEqual(spot.GetConeAngle(), 40.0)
        self.assertEqual(spot.GetExponent(), 0.0)
        self.assertTrue(spot.GetPositional() and spot.LightTypeIsSceneLight())
        self.assertEqual(spot.GetAttenuationValues(), (1.0, 0.0, 0.0))
        self.assertTrue(point.GetPositional())
        self.assertGreaterEqual(point.GetConeAngle(), 90.0)
        self.assertEqual(point.GetDiffuseColor(), (1.0, 0.5, 0.0))
        self.assertEqual(point.GetAttenuationValues(), (0.0, 0.0, 2.0))
        self.assertFalse(sun.GetPositional())
        travel = [b - a for a, b in zip(sun.GetPosition(), sun.GetFocalPoint())]
        self.assertEqual(travel, [0.0, -2.0, 0.0])
        self.assertEqual(sun.GetIntensity(), 3.0)
        self.assertTrue(head.LightTypeIsHeadlight())
        document["lights"] = [{"type": "light_kit"}]
        self.assertEqual(len(self.load(document).lights), 5)

    @unittest.skipUnless(
        wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
    )
    def test_light_sizes(self) -> None:
        document = support.small_scene()
        document["lights"][0]["radius"] = 0.25
        document["lights"] += [
            {"type": "point", "position": [0, 1, 0]},
            {"type": "directional", "direction": [0, -1, 0], "angle": 0.27},
        ]
        size = wrapped.get("vtkIndirectIlluminationPass")
        spot, point, sun = self.load(document).lights
        self.assertEqual(size.GetLightRadius(spot), 0.25)
        self.assertEqual(size.GetLightRadius(point), 0.0)
        self.assertEqual((size.GetLightAngle(sun), size.GetLightRadius(sun)), (0.27, 0.0))

    def test_material(self) -> None:
        document = support.small_scene()
        document["actors"][0].update(
            ambient=0.1,
            diffuse=0.7,
            specular=0.3,
            specular_power=20,
            opacity=0.5,
            interpolation="pbr",
            metallic=0.9,
            roughness=0.2,
            refraction_index=2,
            transform=[2, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        )
        scene = self.load(document)
        actor = scene.actors["floor"]
        prop = actor.GetProperty()
        self.assertEqual(prop.GetInterpolationAsString(), "Physically based rendering")
        self.assertEqual((prop.GetAmbient(), prop.GetDiffuse()), (0.1, 0.7))
        self.assertEqual((prop.GetSpecular(), prop.GetSpecularPower()), (0.3, 20.0))
        self.assertEqual((prop.GetMetallic(), prop.GetRoughness()), (0.9, 0.2))
        self.assertEqual((prop.GetOpacity(), prop.GetBaseIOR()), (0.5, 2.0))
        for got, wanted in zip(prop.GetColor(), (0.8, 0.1, 0.1)):
            self.assertAlmostEqual(got, wanted)
        self.assertEqual(actor.GetBounds()[:2], (5.0, 7.0))

    def test_colors_of_the_data(self) -> None:
        document = support.small_scene()
        room = str(support.DATA / "room_vis.vtp")
        document["actors"] = [
            {"name": "own", "file": room},
            {"name": "given", "file": room, "color": [1, 0, 0]},
            {"name": "mapped", "file": room, "scalars": {"array": "RGB"}},
        ]
        actors = self.load(document).actors
        self.assertTrue(actors["own"].GetMapper().GetScalarVisibility())
        self.assertFalse(actors["given"].GetMapper().GetScalarVisibility())
        self.assertEqual(actors["mapped"].GetMapper().GetColorMode(), VTK_COLOR_MODE_DIRECT_SCALARS)

    def test_scalars(self) -> None:
        document = support.small_scene()
        fire = {"file": str(support.DATA / "room_fire_cfd.vtu")}
        document["actors"] = [
            {**fire, "name": "a", "scalars": {"array": "t", "range": [300, 600], "map": "inferno"}},
            {**fire, "name": "b", "scalars": {"array": "t", "map": [[0, 0, 0], [1, 0, 0]]}},
        ]
        actors = self.load(document).actors
        table = actors["a"].GetMapper().GetLookupTable()
        self.assertEqual(table.GetTableRange(), (300.0, 600.0))
        red = [0.0, 0.0, 0.0]
        actors["b"].GetMapper().GetLookupTable().GetColor(692.2396850585938, red)
        self.assertAlmostEqual(red[0], 1.0, places=2)
        for wrong, expected in (
            ({"array": "T"}, "actors[0].scalars.array: no array 'T' (did you mean 't'?)"),
            (
                {"array": "t", "map": "viridos"},
                "actors[0].scalars.map: unknown map 'viridos' (did you mean 'viridis'?)",
            ),
            ({"array": "t", "map": "set1"}, "actors[0].scalars.map: is for categories"),
            ({"array": "t", "range": [5, 5]}, "actors[0].scalars.range: the second number"),
        ):
            document["actors"] = [{**fire, "scalars": wrong}]
            with self.subTest(wrong=wrong), self.assertRaises(SceneError) as caught:
                self.load(document)
            self.assertIn(expected, str(caught.exception))

    def test_spheres(self) -> None:
        document = support.small_scene()
        atoms = {"file": str(support.DATA / "protein_1tii.pdb")}
        document["actors"] = [
            {**atoms, "name": "a", "spheres": {"radius": 2, "scale_by": "radius"}},
            {**atoms, "name": "b", "spheres": {}, "scalars": {"array": "chain", "map": "vivid"}},
        ]
        actors = self.load(document).actors
        for name, least, most in (("a", 2.0, 4.0), ("b", 0.5, 0.5)):
            mapper = actors[name].GetMapper()
            self.assertTrue(mapper.IsA("vtkOpenGLSphereMapper"))
            data = mapper.GetInput()
            radii = vtk_to_numpy(data.GetPointData().GetArray("Radius"))
            self.assertEqual(data.GetNumberOfVerts(), data.GetNumberOfPoints())
            self.assertEqual(len(radii), 5684)
            # Radii of atoms are 1 to 2 Angstroms.
            self.assertTrue(((radii >= least) & (radii <= most)).all(), name)
        self.assertTrue(actors["b"].GetMapper().GetScalarVisibility())
        for wrong, expected in (
            ({"radius": 0}, "actors[0].spheres.radius: must be greater than 0"),
            ({"resolution": 3}, "actors[0].spheres.resolution: unknown key"),
            ({"scale_by": "radios"}, "spheres.scale_by: no array 'radios' on points (did you mean"),
        ):
            document["actors"] = [{**atoms, "spheres": wrong}]
            with self.subTest(wrong=wrong), self.assertRaises(SceneError) as caught:
                self.load(document)
            self.assertIn(expected, str(caught.exception))
        turned = np.eye(4).ravel().tolist()
        document["actors"] = [{**atoms, "spheres": {}, "transform": turned}]
        with self.assertRaises(SceneError) as caught:
            self.load(document)
        self.assertIn("actors[0].transform: cannot be given", str(caught.exception))

    def test_maps_by_name(self) -> None:
        """The first and the last colour of maps, as their authors publish them."""
        for name, first, last in (
            ("inferno", "000004", "fcffa4"),
            ("magma", "000004", "fcfdbf"),
            ("plasma", "0d0887", "f0f921"),
            ("viridis", "440154", "fde725"),
            ("turbo", "30123b", "7a0403"),
            ("coolwarm", "3b4cc0", "b40426"),
            ("gray", "000000", "ffffff"),
            ("set1", "e41a1c", "999999"),
            ("tab10", "1f77b4", "17becf"),
            ("vivid", "1a6bff", "96dc14"),
            ("Set1", "e41a1c", "999999"),
            ("cividis", "00224e", "fee838"),
        ):
            with self.subTest(name=name):
                table = colormaps.lookup_table(name, (0.0, 1.0), [])
                for index, color in ((0, first), (table.GetNumberOfTableValues() - 1, last)):
                    rgb = [round(255 * part) for part in table.GetTableValue(index)[:3]]
                    self.assertEqual(bytes(rgb).hex(), color)
                categorical = name.lower() in ("set1", "tab10", "vivid")
                self.assertEqual(bool(table.GetIndexedLookup()), categorical)

    def test_very_small_and_very_far_scenes(self) -> None:
        for scale, offset in ((1e-9, 0.0), (1.0, 1e6)):
            document = support.small_scene()
            for actor in document["actors"]:
                for key in ("origin", "point1", "point2"):
                    actor[key] = [scale * x + offset for x in actor[key]]
            scene = self.load(document)
            self.assertAlmostEqual((scene.bounds[1] - scene.bounds[0]) / scale, 1.0, delta=0.1)

    def test_one_window_after_another(self) -> None:
        scene = self.load(support.small_scene())
        first = scene.make_window((24, 16))
        first.Render()
        second = scene.make_window((32, 16))
        self.assertFalse(first.HasRenderer(scene.renderer))
        second.Render()
        self.assertEqual(scene.renderer.GetSize(), (32, 16))

    def test_all_scenes_of_the_project(self) -> None:
        for path in sorted(support.SCENES.glob("*.json")):
            if path.stem not in SLOW_SCENES:
                with self.subTest(scene=path.stem):
                    self.assertEqual(load_scene(path).name, path.stem)
