# SPDX-License-Identifier: BSD-3-Clause
"""Light from the sky in scene files and in `enable`: what is read, and which pass gets it."""

import unittest
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from vtkindirect import UsageError, environments, images, load_scene, wrapped

ABOVE, BELOW, AHEAD = (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.05, 0.05, -1.0)


def sky() -> np.ndarray:
    """Blue above, red below, and green a little right of the middle and above it."""
    values = np.zeros((8, 16, 3), dtype=np.float32)
    values[7], values[0], values[4, 8] = (0, 0, 5), (1, 0, 0), (0, 8, 0)
    return values


def radiance_hdr(values: np.ndarray) -> bytes:
    """Return a file of the format of Radiance, not compressed: upper row first."""
    mantissa, exponent = np.frexp(values.max(axis=2))
    scale = np.where(mantissa > 0, 256.0 / np.exp2(exponent), 0.0)
    pixels = np.dstack([values * scale[..., None], np.where(mantissa > 0, exponent + 128, 0)])
    size = f"-Y {values.shape[0]} +X {values.shape[1]}"
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}\n"
    return head.encode() + pixels[::-1].astype(np.uint8).tobytes()


def seen(light: Any, direction: tuple[float, ...]) -> list[float]:
    found = [0.0, 0.0, 0.0]
    light.GetRadianceFrom(direction, found)
    return found


@unittest.skipUnless(
    wrapped.has("vtkEnvironmentLight"), "the module vtkRenderingIndirect was not built"
)
class Files(support.DirectoryTest):
    def check(self, path: Any, largest: float) -> None:
        """The sky's rows and columns are where they belong; `largest` is what 8 has become."""
        light = environments.from_value(path)
        for way, expected in ((ABOVE, (0, 0, 5)), (BELOW, (1, 0, 0)), (AHEAD, (0, 8, 0))):
            wanted = np.array(expected) * largest / 8.0
            # Bytes are rounded to 1 / 255.
            atol = 0.5 / 255.0 + 1e-6 if largest == 1.0 else 1e-6
            self.assertTrue(np.allclose(seen(light, way), wanted, atol=atol), (path, way))

    @unittest.skipUnless(wrapped.has("vtkOpenEXRReader"), "built without OpenEXR")
    def test_openexr(self) -> None:
        path = self.directory / "sky.exr"
        images.write_exr(path, sky())
        self.check(path, 8.0)
        self.check(str(path), 8.0)

    def test_radiance(self) -> None:
        self.check(self.write("sky.hdr", radiance_hdr(sky())), 8.0)

    def test_bytes(self) -> None:
        path = self.directory / "sky.png"
        images.write_png(path, sky() / 8.0)
        self.check(path, 1.0)

    def test_in_a_scene(self) -> None:
        self.write("sky.hdr", radiance_hdr(sky()))
        document = support.small_scene()
        document["lights"] = [
            {"type": "environment", "file": "sky.hdr", "scale": 2, "up": [0, 0, 1]}
        ]
        scene = load_scene(self.write("scene.json", document))
        self.assertEqual(scene.lights, [])
        self.assertEqual(seen(scene.environment, (0.0, 0.0, 1.0)), [0.0, 0.0, 10.0])
        document["lights"] = support.small_scene()["lights"]
        document["lights"].append({"type": "environment", "radiance": [1, 2, 3], "scale": 2})
        scene = load_scene(self.write("scene.json", document))
        self.assertEqual(len(scene.lights), 1)
        self.assertEqual(seen(scene.environment, ABOVE), [2.0, 4.0, 6.0])
        document["lights"].pop()
        self.assertIsNone(load_scene(self.write("scene.json", document)).environment)

    def test_wrong_files(self) -> None:
        self.write("text.txt", "no image")
        self.write("cut.hdr", radiance_hdr(sky())[:80])
        self.write("empty.exr", "")
        for name, expected in (
            ("none.exr", "no such file"),
            ("text.txt", "is not an image that VTK reads"),
            ("empty.exr", "the file is empty"),
            ("cut.hdr", "cannot be read: "),
        ):
            with self.subTest(name=name), self.assertRaises(UsageError) as caught:
                environments.from_value(self.directory / name)
            self.assertIn(expected, str(caught.exception))
            self.assertEqual(len(str(caught.exception).splitlines()), 1)


@unittest.skipUnless(
    wrapped.has("vtkEnvironmentLight"), "the module vtkRenderingIndirect was not built"
)
class Values(unittest.TestCase):
    def test_colours(self) -> None:
        for value in ([1, 2, 3], (1.0, 2.0, 3.0), np.array([1.0, 2.0, 3.0])):
            self.assertEqual(environments.from_value(value).GetRadiance(), (1.0, 2.0, 3.0))
        self.assertIsNone(environments.from_value(None))
        light = wrapped.get("vtkEnvironmentLight")()
        self.assertIs(environments.from_value(light), light)

    def test_mistakes(self) -> None:
        for value, expected in (
            ([1, -1, 1], "none of them negative"),
            ([1, 2], "three finite numbers"),
            ([1, 2, float("nan")], "three finite numbers"),
            (5, "environment must be a vtkEnvironmentLight, a name (uniform, overcast, clear, "),
            (b"sky", "environment must be a vtkEnvironmentLight"),
        ):
            with self.subTest(value=value), self.assertRaises(UsageError) as caught:
                vtkindirect.enable(vtkRenderer(), environment=value)
            self.assertIn(expected, str(caught.exception))
        with self.assertRaisesRegex(UsageError, "method 'off' has no property 'environment'"):
            vtkindirect.enable(vtkRenderer(), "off", environment=None)


@unittest.skipUnless(
    hasattr(getattr(vtkindirect, "vtkIndirectIlluminationPass", None), "SetEnvironment"),
    "vtkIndirectIlluminationPass has no environment",
)
class Pass(unittest.TestCase):
    """The environment that is asked for reaches the pass."""

    def test_enable(self) -> None:
        renderer = vtkRenderer()
        indirect = vtkindirect.enable(renderer)
        self.assertIsNone(indirect.GetEnvironment())
        vtkindirect.enable(renderer, environment=(1, 2, 3))
        light = indirect.GetEnvironment()
        self.assertEqual(light.GetRadiance(), (1.0, 2.0, 3.0))
        vtkindirect.enable(renderer, "gather")
        self.assertIs(indirect.GetEnvironment(), light)
        vtkindirect.enable(renderer, environment=None)
        self.assertIsNone(indirect.GetEnvironment())

    def test_scene(self) -> None:
        scene = load_scene(support.SCENES / "sky_plane.json")
        for target in (scene, scene.renderer):
            indirect = vtkindirect.enable(target)
            self.assertIs(indirect.GetEnvironment(), scene.environment)
            vtkindirect.disable(target)
        indirect = vtkindirect.enable(scene, environment=None)
        self.assertIsNone(indirect.GetEnvironment())
        vtkindirect.enable(scene)
        self.assertIsNone(indirect.GetEnvironment())
