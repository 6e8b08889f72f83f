# SPDX-License-Identifier: BSD-3-Clause
"""Switching indirect light on and off: what was there comes back, nothing is left behind."""

import gc
import types
import unittest
from unittest import mock

from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

import vtkindirect
from vtkindirect import UsageError, methods, names, wrapped


class Methods(unittest.TestCase):
    """Names of methods and samplers."""

    def test_known_but_not_built(self) -> None:
        for name, row in methods.METHODS.items():
            if row.estimator is None or wrapped.has(row.estimator):
                continue
            with self.subTest(name=name), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(vtkRenderer(), name)
            self.assertEqual(str(caught.exception), f"method '{name}' is not built in this version")

    def test_the_oracle_where_it_is_not_built(self) -> None:
        with mock.patch.object(wrapped, "_oracle", return_value={}):
            with self.assertRaises(UsageError) as caught:
                vtkindirect.enable(vtkRenderer(), "reference")
            self.assertEqual(
                str(caught.exception),
                "method 'reference' is not built in this version: vtkRSMReferencePass is the "
                "oracle of the tests, which is built with them and not installed",
            )
            with self.assertRaisesRegex(ImportError, "is the oracle of the tests"):
                getattr(vtkindirect, wrapped.ORACLE)
        self.assertIs(getattr(vtkindirect, wrapped.ORACLE), wrapped.get(wrapped.ORACLE))
        self.assertNotIn(wrapped.ORACLE, vtkindirect.__all__)

    def test_unknown(self) -> None:
        with self.assertRaisesRegex(UsageError, r"unknown method 'gahter' \(did you mean 'gather'"):
            vtkindirect.enable(vtkRenderer(), "gahter")
        with self.assertRaisesRegex(UsageError, "unknown sampler 'unform'"):
            vtkindirect.enable(vtkRenderer(), "gather", sampler="unform")

    def test_classes_and_names(self) -> None:
        for name in wrapped.CLASSES:
            self.assertIs(getattr(vtkindirect, name), wrapped.CLASSES[name])
            self.assertIn(name, vtkindirect.__all__)
        with self.assertRaises(AttributeError):
            getattr(vtkindirect, "vtkNoSuchClass")  # noqa: B009


@unittest.skipUnless(
    wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
)
class Enable(unittest.TestCase):
    def setUp(self) -> None:
        self.renderer = vtkRenderer()

    def test_enable_and_disable(self) -> None:
        indirect = vtkindirect.enable(self.renderer)
        self.assertIsInstance(indirect, vtkindirect.vtkIndirectIlluminationPass)
        self.assertIs(self.renderer.GetPass(), indirect)
        self.assertIs(vtkindirect.pass_of(self.renderer), indirect)
        self.assertIsNone(indirect.GetEstimator())
        vtkindirect.disable(self.renderer)
        self.assertIsNone(self.renderer.GetPass())
        self.assertIsNone(vtkindirect.pass_of(self.renderer))
        vtkindirect.disable(self.renderer)

    def test_previous_pass_comes_back(self) -> None:
        mine = vtkRenderStepsPass()
        self.renderer.SetPass(mine)
        for _ in range(3):
            vtkindirect.enable(self.renderer)
            vtkindirect.enable(self.renderer, "gather")
            vtkindirect.disable(self.renderer)
            self.assertIs(self.renderer.GetPass(), mine)

    def test_pass_that_was_set_since_is_left_alone(self) -> None:
        vtkindirect.enable(self.renderer)
        mine = vtkRenderStepsPass()
        self.renderer.SetPass(mine)
        vtkindirect.disable(self.renderer)
        self.assertIs(self.renderer.GetPass(), mine)
        vtkindirect.enable(self.renderer)
        vtkindirect.disable(self.renderer)
        self.assertIs(self.renderer.GetPass(), mine)

    def test_twice_reconfigures(self) -> None:
        first = vtkindirect.enable(self.renderer, "gather", NumberOfLights=100, IndirectScale=0.5)
        second = vtkindirect.enable(self.renderer, "gather", Mode="all_texels")
        self.assertIs(first, second)
        self.assertEqual(second.GetSampler().GetNumberOfLights(), 100)
        self.assertEqual(second.GetIndirectScale(), 0.5)
        self.assertEqual(second.GetEstimator().GetClassName(), "vtkRSMGatherPass")
        vtkindirect.enable(self.renderer, "auto")
        self.assertIsNone(second.GetEstimator())
        self.assertIsNone(vtkindirect.enable(self.renderer, "off"))
        self.assertIsNone(self.renderer.GetPass())

    def test_multiresolution(self) -> None:
        indirect = vtkindirect.enable(
            self.renderer,
            "multiresolution",
            NumberOfLights=300,
            normal_threshold=0.1,
            FinestLevel="half_resolution",
            Preset="paper",
        )
        estimator = indirect.GetEstimator()
        self.assertEqual(estimator.GetClassName(), "vtkMultiresolutionSplattingPass")
        self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 300)
        self.assertEqual(estimator.GetNormalThreshold(), 0.1)
        self.assertEqual(estimator.GetFinestLevel(), estimator.HALF_RESOLUTION)
        self.assertEqual(estimator.GetPreset(), estimator.PAPER)
        for settings, expected in (
            ({"NormalThreshold": 2.5}, "NormalThreshold: 2.5 is out of range"),
            ({"FinestLevel": "quarter"}, "unknown value 'quarter'"),
            ({"PlaneThreshold": -2}, "PlaneThreshold: -2 is out of range"),
        ):
            with self.subTest(settings=settings), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(self.renderer, "multiresolution", **settings)
            self.assertIn(expected, str(caught.exception))

    def test_names_in_lower_case(self) -> None:
        indirect = vtkindirect.enable(
            self.renderer,
            "gather",
            sampler="uniform",
            number_of_lights=77,
            pattern="jittered",
            shadows=False,
            reflective_shadow_map_resolution=256,
        )
        self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 77)
        self.assertFalse(indirect.GetShadows())
        self.assertEqual(indirect.GetReflectiveShadowMapResolution(), 256)

    def test_wrong_settings_leave_the_renderer_alone(self) -> None:
        for settings, expected in (
            ({"NumberOfLihgts": 5}, "did you mean 'NumberOfLights'"),
            ({"Occupancy": True}, "unknown property 'Occupancy'"),
            ({"NumberOfLights": 0}, "NumberOfLights: 0 is out of range"),
            ({"Mode": "texels"}, "unknown value 'texels'"),
            ({"IndirectScale": -1}, "IndirectScale: -1 is out of range"),
        ):
            with self.subTest(settings=settings), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(self.renderer, "gather", **settings)
            self.assertIn(expected, str(caught.exception))
            self.assertIsNone(self.renderer.GetPass())
        with self.assertRaisesRegex(UsageError, "property 'Mode' belongs to method 'gather', not"):
            vtkindirect.enable(self.renderer, "auto", Mode="all_texels")

    def test_settings_of_the_automatic_method(self) -> None:
        indirect = vtkindirect.enable(
            self.renderer, number_of_lights=512, Visibility="voxels", SpecularTransport=False
        )
        self.assertIsNone(indirect.GetEstimator())
        self.assertIsNone(indirect.GetSampler())
        self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 512)
        self.assertFalse(indirect.GetActiveEstimator().GetSpecularTransport())
        vtkindirect.enable(self.renderer, OccupancyResolution=64)
        self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 512)
        self.assertFalse(indirect.GetActiveEstimator().GetSpecularTransport())
        self.assertEqual(indirect.GetActiveEstimator().GetOccupancyResolution(), 64)
        reported = vtkindirect.report(self.renderer)["settings"]
        self.assertEqual(reported["NumberOfLights"], 512)
        self.assertEqual(reported["Visibility"], "voxels")
        self.assertEqual(reported["OccupancyResolution"], 64)

    def test_settings_are_kept_where_they_apply(self) -> None:
        indirect = vtkindirect.enable(
            self.renderer, number_of_lights=512, Visibility="voxels", SpecularTransport="off"
        )
        vtkindirect.enable(self.renderer, "gather", Mode="virtual_lights", Shadows=False)
        self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 512)
        self.assertEqual(indirect.GetVisibility(), indirect.VOXELS)
        self.assertFalse(indirect.GetEstimator().GetSpecularTransport())
        vtkindirect.enable(self.renderer, "hints", Visibility="none", SpecularTransport=True)
        self.assertTrue(indirect.GetEstimator().GetSpecularTransport())
        vtkindirect.enable(self.renderer, "gather", sampler="uniform")
        self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 512)
        self.assertEqual(indirect.GetVisibility(), indirect.NONE)
        self.assertTrue(indirect.GetEstimator().GetSpecularTransport())
        vtkindirect.enable(self.renderer)
        self.assertEqual(indirect.GetActiveSampler().GetNumberOfLights(), 512)
        self.assertEqual(indirect.GetVisibility(), indirect.NONE)
        self.assertTrue(indirect.GetActiveEstimator().GetSpecularTransport())
        self.assertFalse(indirect.GetShadows())

    def test_what_was_set_by_hand_since_stays(self) -> None:
        indirect = vtkindirect.enable(self.renderer, "gather", Shadows=False)
        indirect.ShadowsOn()
        vtkindirect.enable(self.renderer, "multiresolution")
        self.assertTrue(indirect.GetShadows())

    def test_an_error_changes_nothing(self) -> None:
        # A bounce that was asked for: a wrong number that were clamped would be the default, 0.
        indirect = vtkindirect.enable(
            self.renderer, "gather", NumberOfLights=100, NumberOfBounces=1
        )
        before = indirect.GetEstimator(), indirect.GetSampler()
        for method, wrong in (
            ("gather", {"NumberOfLights": 50, "Mode": "texels"}),
            ("gather", {"NumberOfLights": 50, "NumberOfLihgts": 60}),
            ("hints", {"SpecularTransport": False, "NumberOfBounces": -5}),
            ("multiresolution", {"NumberOfLights": 50, "Mode": "all_texels"}),
        ):
            with self.subTest(wrong=wrong), self.assertRaises(UsageError):
                vtkindirect.enable(self.renderer, method, **wrong)
            self.assertIs(indirect.GetEstimator(), before[0])
            self.assertIs(indirect.GetSampler(), before[1])
            self.assertEqual(indirect.GetSampler().GetNumberOfLights(), 100)
            self.assertEqual(indirect.GetNumberOfBounces(), 1)

    def test_windows_plotters_and_others(self) -> None:
        window = vtkRenderWindow() if vtkindirect.has_display() else None
        if window is None and wrapped.has("vtkEGLHeadlessRenderWindow"):
            window = vtkindirect.vtkEGLHeadlessRenderWindow()
        if window is not None:
            with self.assertRaisesRegex(UsageError, "the window has no renderer"):
                vtkindirect.enable(window)
            window.AddRenderer(self.renderer)
            self.assertIs(vtkindirect.enable(window), self.renderer.GetPass())
            other = vtkRenderer()
            window.AddRenderer(other)
            self.assertEqual(vtkindirect.enable(window), [self.renderer.GetPass(), other.GetPass()])
            vtkindirect.disable(window)
            self.assertIsNone(other.GetPass())

        class Plotter:
            renderer = self.renderer

        indirect = vtkindirect.enable(Plotter())
        self.assertIs(self.renderer.GetPass(), indirect)
        vtkindirect.disable(Plotter())
        with self.assertRaisesRegex(UsageError, "a renderer, a render window or a plotter"):
            vtkindirect.enable(42)

    def test_nothing_is_left_behind(self) -> None:
        before = len(methods._records)
        for _ in range(20):
            renderer = vtkRenderer()
            vtkindirect.enable(renderer)
            del renderer
        gc.collect()
        self.assertEqual(len(methods._records), before)

    def test_garbage_in_a_cycle(self) -> None:
        """Python's collection clears functions before it lets a renderer call them."""
        for _ in range(5):
            renderer, window = vtkRenderer(), vtkRenderWindow()
            window.AddRenderer(renderer)
            vtkindirect.enable(renderer)
            cycle = [window, renderer]
            cycle.append(cycle)
            del renderer, window, cycle
            gc.collect()
        self.assertEqual(
            [kept for kept in methods._records.values() if kept.renderer.Get() is None], []
        )

    def test_wrong_types_are_one_line(self) -> None:
        on = vtkRenderer()
        vtkindirect.enable(on)
        for value in (None, 5, 2.5, True, b"gather", ["gather"], {}, object(), vtkRenderer):
            for call, expected in (
                (lambda: vtkindirect.enable(self.renderer, value), "method must be text, not "),
                (lambda: vtkindirect.copy_buffer(on, value), "buffer must be text, not "),
                (lambda: vtkindirect.copy_buffer(value, "final"), "a renderer, a render window"),
                (lambda: vtkindirect.enable(value), "a renderer, a render window or a plotter"),
                (lambda: vtkindirect.disable(value), "a renderer, a render window or a plotter"),
                (lambda: vtkindirect.pass_of(value), "a renderer, a render window or a plotter"),
                (lambda: vtkindirect.report(value), "a renderer, a render window or a plotter"),
                (lambda: vtkindirect.load_scene(value), "path must be text, not "),
                (lambda: vtkindirect.render_window(value), "size must be a width and a height"),
            ):
                with self.subTest(value=value, expected=expected):
                    with self.assertRaises(UsageError) as caught:
                        call()
                    self.assertIn(expected, str(caught.exception))
                    self.assertEqual(len(str(caught.exception).splitlines()), 1)
            if value is not None:
                with self.assertRaisesRegex(UsageError, "sampler must be text, not "):
                    vtkindirect.enable(self.renderer, "gather", sampler=value)
        self.assertIsNone(self.renderer.GetPass())

    def test_report_and_buffers_need_a_pass(self) -> None:
        with self.assertRaisesRegex(UsageError, "indirect light is off"):
            vtkindirect.report(self.renderer)
        with self.assertRaisesRegex(UsageError, "indirect light is off"):
            vtkindirect.copy_buffer(self.renderer, "final")


class Names(unittest.TestCase):
    def test_those_that_users_gave_pyvistas_meshes(self) -> None:
        skull, other = vtkActor(), vtkActor()
        renderer = types.SimpleNamespace(actors={"skull": skull, "PolyData(Addr=00A0)": other})
        known = names.take_pyvistas(renderer, ())
        self.assertEqual(known, ("skull", "PolyData(Addr=00A0)"))
        key = wrapped.get("vtkIndirectIlluminationPass").NAME()
        self.assertEqual(skull.GetPropertyKeys().Get(key), "skull")
        self.assertIsNone(other.GetPropertyKeys())
        # Nothing is looked at while the names are the same, and others than PyVista's have none.
        skull.SetPropertyKeys(None)
        self.assertEqual(names.take_pyvistas(renderer, known), known)
        self.assertIsNone(skull.GetPropertyKeys())
        self.assertEqual(names.take_pyvistas(vtkRenderer(), ()), ())

