# SPDX-License-Identifier: BSD-3-Clause
"""Properties by name: looked up in order, enumerations by name, what does not take is an error."""

import unittest

import numpy as np
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkProperty

from vtkindirect import UsageError, settings, wrapped

CLASSES = (
    "vtkIndirectIlluminationPass",
    "vtkMultiresolutionSplattingPass",
    "vtkRadianceHintsPass",
    "vtkReflectiveShadowMapPass",
    "vtkRSMGatherPass",
    "vtkRSMReferencePass",
    "vtkUniformLightSampler",
    "vtkImportanceLightSampler",
)


class Settings(unittest.TestCase):
    def setUp(self):
        self.material = vtkProperty()
        self.sphere = vtkSphereSource()
        self.targets = [self.sphere, self.material]

    def apply(self, **values):
        settings.apply(self.targets, values)

    def assert_refused(self, expected, **values):
        with self.assertRaises(UsageError) as caught:
            self.apply(**values)
        self.assertIn(expected, str(caught.exception))

    def test_text_and_python_values(self):
        self.apply(ThetaResolution="12", Radius="2.5e0", LatLongTessellation="on", Center="1, 2,3")
        self.assertEqual(self.sphere.GetThetaResolution(), 12)
        self.assertEqual(self.sphere.GetRadius(), 2.5)
        self.assertTrue(self.sphere.GetLatLongTessellation())
        self.assertEqual(self.sphere.GetCenter(), (1.0, 2.0, 3.0))
        self.apply(theta_resolution=13, radius=3, lat_long_tessellation=False, center=(4, 5, 6))
        self.assertEqual(self.sphere.GetThetaResolution(), 13)
        self.assertEqual(self.sphere.GetRadius(), 3.0)
        self.assertFalse(self.sphere.GetLatLongTessellation())
        self.assertEqual(self.sphere.GetCenter(), (4.0, 5.0, 6.0))

    def test_numbers_of_numpy(self):
        self.apply(
            ThetaResolution=np.int64(14),
            Radius=np.float32(0.5),
            LatLongTessellation=np.bool_(True),
            Center=np.array([1, 2, 3]),
        )
        self.assertEqual(self.sphere.GetThetaResolution(), 14)
        self.assertEqual(self.sphere.GetRadius(), 0.5)
        self.assertTrue(self.sphere.GetLatLongTessellation())
        self.assertEqual(self.sphere.GetCenter(), (1.0, 2.0, 3.0))

    def test_first_object_wins(self):
        other = vtkSphereSource()
        settings.apply([self.sphere, other], {"Radius": 9})
        self.assertEqual((self.sphere.GetRadius(), other.GetRadius()), (9.0, 0.5))

    def test_enumerations(self):
        self.apply(Interpolation="flat")
        self.assertEqual(self.material.GetInterpolationAsString(), "Flat")
        self.apply(Interpolation="PBR")
        self.assertEqual(self.material.GetInterpolation(), 3)
        self.assert_refused("unknown value 'flet' (did you mean 'flat'?)", Interpolation="flet")
        known = {"headlight", "camera_light", "scene_light"}
        self.assertEqual(set(settings.choices(vtkLight(), "LightType")), known)

    def test_out_of_range_is_an_error_and_changes_nothing(self):
        before = self.sphere.GetThetaResolution()
        self.assert_refused(
            "ThetaResolution: 1 is out of range, the nearest value allowed is 3",
            ThetaResolution="1",
        )
        self.assertEqual(self.sphere.GetThetaResolution(), before)
        self.assert_refused("Roughness: 7 is out of range", Roughness="7")

    def test_wrong_values(self):
        self.assert_refused("Radius: 'big' is not a number", Radius="big")
        self.assert_refused("Radius: must be a finite number", Radius="nan")
        self.assert_refused("Radius: must be a finite number", Radius=float("inf"))
        self.assert_refused("ThetaResolution: must be a whole number", ThetaResolution="8.5")
        self.assert_refused("Center: must be 3 numbers", Center="1,2")
        self.assert_refused("FrontfaceCulling: ", FrontfaceCulling="maybe")
        self.assert_refused("ThetaResolution: cannot be set", ThetaResolution="99999999999")

    def test_unknown_property(self):
        self.assert_refused("unknown property 'Radios' (did you mean 'Radius'?)", Radios=1)
        self.assert_refused("known: ", Debug=1)
        self.assertNotIn("Debug", settings.properties(self.sphere))
        self.assertNotIn("ReferenceCount", settings.properties(self.sphere))

    def test_describe(self):
        found = settings.describe(self.targets)
        self.assertEqual(found["Radius"], 0.5)
        self.assertEqual(found["Interpolation"], "gouraud")

    def test_names(self):
        for name, snake in (
            ("AllTexels", "all_texels"),
            ("ZIP", "zip"),
            ("PBRMaterial", "pbr_material"),
        ):
            self.assertEqual(settings.snake(name), snake)
        self.assertEqual(settings.camel("number_of_lights"), "NumberOfLights")
        self.assertEqual(settings.camel("NumberOfLights"), "NumberOfLights")

    def test_every_property_of_the_passes_is_printed(self):
        for name in CLASSES:
            target = wrapped.get(name)()
            words = {line.split(":")[0].strip() for line in str(target).splitlines()}
            self.assertGreaterEqual(len(settings.properties(target)), 1, name)
            for known in settings.properties(target):
                self.assertIn(known, words, name)

    def test_vector_out_of_range(self):
        hints = wrapped.get("vtkRadianceHintsPass")()
        for wrong in ("5000,5000,5000", "-3,1,1"):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(UsageError, "GridResolution"):
                settings.apply([hints], {"GridResolution": wrong})
        settings.apply([hints], {"GridResolution": "64,0,3"})
        self.assertEqual(tuple(hints.GetGridResolution()), (64, 0, 3))

    def test_parse(self):
        self.assertEqual(settings.parse(["A=1", "B = x,y", "A=2"]), {"A": "2", "B": "x,y"})
        for wrong in ("A", "=1", "A=", ""):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(UsageError, "Property=value"):
                settings.parse([wrong])
