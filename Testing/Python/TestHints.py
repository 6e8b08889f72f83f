# SPDX-License-Identifier: BSD-3-Clause
"""Radiance hints from Python: properties by name, the report, the sweep file, the method's page."""

import json
import unittest

from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkArcSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

import support
import vtkindirect
from rooms import make_actor, make_ball, make_room
from vtkindirect import (
    frames,
    images,
    methods,
    metrics,
    references,
    settings,
    sweep,
    windows,
    wrapped,
)

PAGE = support.SOURCE / "Documentation" / "methods" / "radiance-hints.md"
SWEEP = support.SOURCE / "Testing" / "Benchmark" / "hints.json"


@unittest.skipUnless(wrapped.has("vtkRadianceHintsPass"), "vtkRadianceHintsPass was not built")
class Hints(unittest.TestCase):
    def test_every_property_is_on_its_page(self) -> None:
        text = PAGE.read_text(encoding="utf-8")
        estimator = vtkindirect.vtkRadianceHintsPass()
        names = settings.properties(estimator)
        self.assertGreater(len(names), 12)
        for name in names:
            self.assertIn(f"`{name}`", text)
            for choice in settings.choices(estimator, name):
                self.assertIn(f"`{choice}`", text)

    def test_sweep_names_properties(self) -> None:
        estimator = vtkindirect.vtkRadianceHintsPass()
        indirect = vtkindirect.vtkIndirectIlluminationPass()
        for row in sweep.load(SWEEP).rows:
            with self.subTest(row=row.label):
                settings.apply([estimator, indirect], row.settings)

    def test_frame_and_report(self) -> None:
        loaded = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(loaded, (64, 64))
        window = loaded.render_window
        indirect = vtkindirect.enable(
            loaded.renderer, "hints", number_of_bounces=3, grid_resolution=(8, 8, 8), order=3
        )
        window.Render()
        report = json.loads(indirect.GetReport())
        self.assertEqual(report["method"], "hints")
        modelled = {entry["what"]: entry["why"] for entry in report["modelled"]}
        self.assertIn("3 diffuse bounces", modelled)
        self.assertIn("of 512 hints of order 3", modelled["3 diffuse bounces"])
        self.assertIn("visibility between sender and receiver", modelled)
        three = vtkindirect.images.copy_buffer(loaded.renderer, "irradiance").mean()
        vtkindirect.enable(loaded.renderer, "hints", number_of_bounces=1, visibility="none")
        window.Render()
        left_out = [entry["what"] for entry in json.loads(indirect.GetReport())["left_out"]]
        self.assertIn("visibility between sender and receiver", left_out)
        one = vtkindirect.images.copy_buffer(loaded.renderer, "irradiance").mean()
        self.assertGreater(three, 1.1 * one)
        vtkindirect.disable(loaded.renderer)
        window.Finalize()

    def test_report_counts_props_smaller_than_a_cell(self) -> None:
        # Cells have an edge of 2 / 16; the ball's bounds are 0.8 and 0.04 along an edge.
        for radius, count in ((0.4, 0), (0.02, 1)):
            with self.subTest(radius=radius):
                renderer = make_room(make_actor(make_ball(radius)))
                window = windows.render_window((32, 24), offscreen=True)
                window.AddRenderer(renderer)
                vtkindirect.enable(renderer, "hints", lighting="scene")
                window.Render()
                left_out = {e["what"]: e["why"] for e in vtkindirect.report(renderer)["left_out"]}
                why = left_out.get("light of props smaller than a cell of the grid", "0 props")
                self.assertEqual(int(why.split()[0]), count, left_out)
                window.Finalize()

    def test_no_light_comes_through_the_outermost_surface(self) -> None:
        # Half a cylinder with a lamp on its axis, from outside: no other surface reflects light.
        arc = vtkArcSource()
        arc.UseNormalAndAngleOn()
        arc.SetNormal(0, 0, 1)
        arc.SetPolarVector(-1, 0, 0)
        arc.SetAngle(180)
        arc.SetCenter(0, 1, -1)
        arc.SetResolution(48)
        sheet = vtkLinearExtrusionFilter()
        sheet.SetInputConnection(arc.GetOutputPort())
        sheet.SetExtrusionTypeToVectorExtrusion()
        sheet.SetVector(0, 0, 2)
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        renderer.AddActor(make_actor(sheet, (0.8, 0.8, 0.8)))
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetConeAngle(180)
        lamp.SetPosition(0, 1, 0)
        renderer.AddLight(lamp)
        window = vtkindirect.render_window((120, 90), offscreen=True)
        window.AddRenderer(renderer)
        self.addCleanup(window.Finalize)
        vtkindirect.enable(renderer, "hints", lighting="scene")
        mean = {}
        for side, eye in {"inside": (0.8, 5, 3), "outside": (3, -4, 4)}.items():
            renderer.GetActiveCamera().SetPosition(*eye)
            renderer.GetActiveCamera().SetFocalPoint(0, 0.4, 0)
            renderer.ResetCameraClippingRange()
            window.Render()
            direct = images.copy_buffer(renderer, "direct").max(-1)
            shown = images.copy_buffer(renderer, "depth")[..., 0] > 0
            chosen = shown & ((direct > 0) == (side == "inside"))
            mean[side] = images.copy_buffer(renderer, "irradiance").max(-1)[chosen].mean()
            print(f"{side}: {chosen.sum()} pixels, mean {mean[side]:.4f}")
        # Hints behind the sheet would count beyond the border of the voxels: 0.259 of 0.162.
        self.assertGreater(mean["inside"], 0.05)
        self.assertLess(mean["outside"], 0.03 * mean["inside"])

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "references are OpenEXR files")
    def test_half_of_the_papers_error(self) -> None:
        # Four bounces against the paper's two, for exact ones with two alone have more than half of
        # its error; and with a finer grid against as many. No more than a tenth of their light is
        # lost: the grid's corners and what a ray's share of the sphere hides.
        for name in ("room_fire", "apartment_living"):
            stored = support.SOURCE / "Testing" / "Reference" / "data" / f"{name}.exr"
            expected = references.read_layer(stored, "R3")
            loaded = vtkindirect.load_scene(support.SCENES / f"{name}.json")
            frames.open_window(loaded, (expected.shape[1], expected.shape[0]))
            indirect = vtkindirect.enable(loaded.renderer, "hints", number_of_bounces=4)
            found = {}
            estimator = indirect.GetEstimator()
            for version, bounces in (("all", 4), ("finer", 4), ("paper", 2), ("paper, equal", 4)):
                indirect.SetErrorTolerance(0.02 if version == "finer" else 0.05)
                estimator.SetPreset(1 if version.startswith("paper") else 0)
                indirect.SetNumberOfBounces(bounces)
                loaded.render_window.Render()
                irradiance = images.copy_buffer(loaded.renderer, "irradiance")
                found[version] = metrics.compare(irradiance, expected, references.mask(loaded))
            for ours, theirs in (("all", "paper"), ("finer", "paper, equal")):
                self.assertLess(found[ours].relmse, 0.5 * found[theirs].relmse, (name, ours))
            record = json.loads(stored.with_suffix(".json").read_text(encoding="utf-8"))
            exact = sum(record["R3"]["fraction_of_bounce"][:4]) - 1.0
            self.assertGreater(found["all"].bias, exact - 0.1, name)
            self.assertLess(found["all"].bias, exact + 0.1, name)
            loaded.render_window.Finalize()

    def test_sampler_is_not_read(self) -> None:
        self.assertIsNone(methods.METHODS["hints"].sampler)
