# SPDX-License-Identifier: BSD-3-Clause
"""Voxels by name: the methods that sum over virtual lights, the report, the command line."""

import json
import unittest

import support
import vtkindirect
from vtkindirect import frames, metrics, references, wrapped
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper

METHODS = ("gather", "multiresolution", "reference")
PAGES = ("gather", "multiresolution-splatting", "radiance-hints")


@unittest.skipUnless(wrapped.has("vtkRSMGatherPass"), "vtkRSMGatherPass was not built")
class Occupancy(unittest.TestCase):
    def test_is_on_the_pages(self) -> None:
        for name in PAGES:
            path = support.SOURCE / "Documentation" / "methods" / f"{name}.md"
            text = path.read_text(encoding="utf-8")
            self.assertIn("`OccupancyResolution`", text)

    def test_hides_light(self) -> None:
        loaded = vtkindirect.load_scene(support.SCENES / "cornell_box.json")
        frames.open_window(loaded, (48, 48))
        for method in METHODS:
            with self.subTest(method=method):
                means = {}
                for voxels in (False, True):
                    # The lights of a map of this size are few enough for the processor.
                    indirect = vtkindirect.enable(
                        loaded.renderer,
                        method,
                        occupancy_resolution=64,
                        reflective_shadow_map_resolution=32,
                    )
                    # The reference has a visibility of its own beside that of the pass.
                    indirect.SetVisibility(indirect.VOXELS if voxels else indirect.NONE)
                    loaded.render_window.Render()
                    image = vtkindirect.images.copy_buffer(loaded.renderer, "irradiance")
                    means[voxels] = image.mean()
                    report = json.loads(indirect.GetReport())
                    what = "visibility between sender and receiver"
                    modelled = {entry["what"]: entry["why"] for entry in report["modelled"]}
                    left_out = [entry["what"] for entry in report["left_out"]]
                    self.assertEqual(what in modelled, voxels)
                    self.assertEqual(what in left_out, not voxels)
                self.assertIn("of 64 along the longest edge", modelled[what])
                # Its blocks hide a fifth of the light; the pictures of both are lit.
                self.assertLess(means[True], 0.95 * means[False])
                self.assertGreater(means[True], 0.5 * means[False])
        vtkindirect.disable(loaded.renderer)
        loaded.render_window.Finalize()


@unittest.skipUnless(wrapped.has("vtkRSMReferencePass"), "vtkRSMReferencePass was not built")
@unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "vtkOpenEXRReader was not built")
class ExactVisibility(unittest.TestCase):
    """Virtual lights with exact visibility come to what was path traced, R2; without it they do not."""

    MOST = {"two_rooms": 0.0025, "cornell_box": 0.06}
    """relMSE to R2: twice and more what 1024 uniform lights leave (0.0010 and 0.024), most of it near
    walls, where a light's disk is wider than its distance; without visibility 11.4 and 0.31."""

    def test_comes_to_path_tracing(self) -> None:
        for name, most in self.MOST.items():
            with self.subTest(scene=name):
                loaded = vtkindirect.load_scene(support.SCENES / f"{name}.json")
                stored = support.TESTING / "Reference" / "data" / f"{name}.exr"
                truth = references.read_layer(stored, "R2")
                assert truth is not None
                frames.open_window(loaded, (truth.shape[1], truth.shape[0]))
                errors = {}
                for visibility in ("none", "exact"):
                    indirect = vtkindirect.enable(
                        loaded.renderer,
                        "reference",
                        mode="virtual_lights",
                        number_of_lights=1024,
                        number_of_bounces=1,  # R2 has no more
                        visibility=visibility,
                    )
                    loaded.render_window.Render()
                    image = vtkindirect.images.copy_buffer(loaded.renderer, "irradiance")
                    found = metrics.compare(image, truth, references.mask(loaded))
                    errors[visibility] = found.relmse
                    print(f"{name}, {visibility}: relMSE to R2 {found.relmse:.4g}")
                report = json.loads(indirect.GetReport())
                why = {entry["what"]: entry["why"] for entry in report["modelled"]}
                self.assertIn("triangles", why["visibility between sender and receiver"])
                self.assertLess(errors["exact"], most)
                self.assertLess(errors["exact"], 0.2 * errors["none"])
                vtkindirect.disable(loaded.renderer)
                loaded.render_window.Finalize()

    def test_says_what_it_cannot_see(self) -> None:
        loaded = vtkindirect.load_scene(support.SCENES / "two_planes.json")
        frames.open_window(loaded, (32, 32))
        points = vtkPoints()
        points.InsertNextPoint(loaded.bounds[0], loaded.bounds[2], loaded.bounds[4])
        data = vtkPolyData()
        data.SetPoints(points)
        cube = vtkCubeSource()
        mapper = vtkGlyph3DMapper()
        mapper.SetInputData(data)
        mapper.SetSourceConnection(cube.GetOutputPort())
        mapper.SetScaleFactor(0.01)
        actor = vtkActor()
        actor.SetMapper(mapper)
        loaded.renderer.AddActor(actor)
        for visibility, sees in (("voxels", False), ("exact", True)):
            indirect = vtkindirect.enable(
                loaded.renderer, "reference", mode="virtual_lights", visibility=visibility
            )
            loaded.render_window.Render()
            report = json.loads(indirect.GetReport())
            left_out = " ".join(entry["why"] for entry in report["left_out"])
            with self.subTest(visibility):
                self.assertEqual(
                    not sees, "has no polygons that the processor can read" in left_out
                )
                self.assertEqual(not sees, "no indirect light" in left_out)
        vtkindirect.disable(loaded.renderer)
        loaded.render_window.Finalize()
