# SPDX-License-Identifier: BSD-3-Clause
"""Properties by name: looked up in order, enumerations by name, what does not take is an error."""

import unittest

import numpy as np
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkProperty

import support
import vtkindirect
from vtkindirect import METHODS, UsageError, frames, methods, settings, wrapped
from vtkindirect.frames import Job

WHY_NOT = support.why_no_rendering()

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


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class ReportedSettings(unittest.TestCase):
    """The report of a frame has every setting, with the value in force."""

    def render(self, method, sampler=None, **values):
        scene = vtkindirect.load_scene(support.SCENES / "two_planes.json")
        window = frames.open_window(scene, (40, 30))
        self.addCleanup(window.Finalize)
        frames.render(scene, window, Job(method, sampler, values))
        return methods.pass_of(scene.renderer), vtkindirect.report(scene.renderer)["settings"]

    def assert_complete(self, indirect, reported):
        for part in methods.parts(indirect):
            for name in settings.properties(part):
                value = getattr(part, f"Get{name}")()
                if isinstance(value, (bool, int, float, str, tuple)):
                    with self.subTest(part=part.GetClassName(), name=name):
                        self.assertIn(name, reported)
                        choices = settings.choices(part, name)
                        kind = str if choices else list if isinstance(value, tuple) else type(value)
                        self.assertIsInstance(reported[name], kind)
                        if choices:
                            self.assertIn(reported[name], choices)

    def test_every_setting_is_reported(self):
        for method in METHODS:
            if method != "off":
                # All texels are not those of a sampler, whose settings are not in force then.
                values = {"Mode": "virtual_lights"} if method == "reference" else {}
                with self.subTest(method=method):
                    self.assert_complete(*self.render(method, **values))
        for sampler in methods.SAMPLERS:
            with self.subTest(sampler=sampler):
                self.assert_complete(*self.render("gather", sampler))

    def test_settings_that_are_set_are_in_force(self):
        values = {
            "Visibility": "voxels",
            "NumberOfBounces": 2,
            "NumberOfLights": 32,
            "Pattern": "grid",
            "LitTexels": False,
            "InterpolationStep": 6,
            "OccupancyResolution": 32,
            "SpecularTransport": False,
            "ReflectiveShadowMapResolution": 64,
            "IndirectScale": 0.5,
            "Shadows": False,
            "Antialiasing": False,
            "SpheresInMotion": False,
            "RemainingGeometry": False,
            "DebugView": "normal",
        }
        _, reported = self.render("gather", "uniform", **values)
        for name, value in values.items():
            with self.subTest(name=name):
                self.assertEqual(reported[name], value)

    def test_automatic_settings_are_resolved(self):
        indirect, reported = self.render("multiresolution", ErrorTolerance=0.04)
        self.assertEqual(indirect.GetVisibility(), indirect.AUTO)
        self.assertEqual(reported["Visibility"], "maps")
        self.assertEqual(indirect.GetNumberOfBounces(), 0)
        self.assertEqual(reported["NumberOfBounces"], 128)  # of a random walk
        self.assertTrue(reported["AutomaticNumberOfLights"])
        # A walk would add its own lights.
        first, _ = self.render("multiresolution", ErrorTolerance=0.04, NumberOfBounces=1)
        self.assertEqual(reported["NumberOfLights"], methods.report(first)["virtual_lights"])
        # Thresholds are proportional to the tolerance; the defaults are those of 0.02.
        estimator = indirect.GetEstimator()
        for name in ("PlaneThreshold", "NormalThreshold", "DepthThreshold"):
            self.assertEqual(reported[name], 2.0 * getattr(estimator, f"Get{name}")())
        indirect, reported = self.render("hints", ErrorTolerance=0.1)
        self.assertEqual(indirect.GetEstimator().GetGridResolution(), (0, 0, 0))
        self.assertEqual(max(reported["GridResolution"]), 11)  # sqrt(12 / 0.1)
        self.assertEqual(reported["NumberOfBounces"], 8)
        self.assertNotIn("NumberOfLights", reported)  # no sampler is in force
        _, reported = self.render("gather", Mode="all_texels")
        self.assertFalse(reported["Interpolation"])
        self.assertEqual(reported["Visibility"], "none")

    def test_automatic_visibility_is_the_estimators(self):
        neighborhood = {"Mode": "neighborhood"}
        paper = {"Preset": "paper"}
        for method, values, expected in (
            ("multiresolution", {}, "maps"),
            ("multiresolution", paper, "none"),
            ("multiresolution", {**paper, "Visibility": "voxels"}, "voxels"),
            ("multiresolution", {"Visibility": "none"}, "none"),
            ("splatting", {}, "maps"),
            ("gather", {}, "maps"),
            ("gather", {"Visibility": "voxels"}, "voxels"),
            ("gather", neighborhood, "none"),
            ("gather", {**neighborhood, "Visibility": "maps"}, "voxels"),
            ("hints", {}, "voxels"),
            ("hints", {"Visibility": "none"}, "none"),
            ("hints", paper, "none"),
            ("hints", {**paper, "Visibility": "voxels"}, "voxels"),
        ):
            with self.subTest(method=method, values=values):
                _, reported = self.render(method, **values)
                self.assertEqual(reported["Visibility"], expected)

    def test_estimators_own_visibility_is_in_force(self):
        _, reported = self.render("reference")
        self.assertEqual(reported["Visibility"], "none")
