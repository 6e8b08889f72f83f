# SPDX-License-Identifier: BSD-3-Clause
"""Writing pictures: values, orientation, and files that are either complete or not there."""

import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import support
from vtkindirect import RenderError, UsageError, images, wrapped

HAVE_EXR = wrapped.has("vtkOpenEXRWriter")


def read(path: Path, reader_class: type) -> np.ndarray:
    """Return a picture with its bottom row first."""
    reader = reader_class()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


class Files(support.DirectoryTest):
    def test_png_bytes(self) -> None:
        values = np.random.default_rng(1).integers(0, 256, (5, 7, 3), dtype=np.uint8)
        images.write_image(self.directory / "a.png", values)
        self.assertTrue(np.array_equal(read(self.directory / "a.png", vtkPNGReader), values))

    def test_png_of_floats_is_clamped(self) -> None:
        values = np.array([[[-1.0], [0.0]], [[0.5], [7.0]], [[np.nan], [np.inf]]], np.float32)
        images.write_image(self.directory / "a.png", values)
        found = read(self.directory / "a.png", vtkPNGReader)[..., 0]
        self.assertEqual(found.tolist(), [[0, 0], [128, 255], [0, 255]])

    @unittest.skipUnless(HAVE_EXR, "the module vtkIndirectOpenEXR was not built")
    def test_exr(self) -> None:
        values = np.linspace(-3, 30, 5 * 7 * 3, dtype=np.float32).reshape(5, 7, 3)
        reader = wrapped.get("vtkOpenEXRReader")
        images.write_image(self.directory / "half.exr", values)
        found = read(self.directory / "half.exr", reader)
        self.assertTrue(np.allclose(found, values, rtol=1e-3))
        self.assertFalse(np.array_equal(found, values))
        images.write_image(self.directory / "float.exr", values, full=True)
        self.assertTrue(np.array_equal(read(self.directory / "float.exr", reader), values))
        images.write_image(self.directory / "large.exr", 1e6 * values)
        self.assertTrue(np.array_equal(read(self.directory / "large.exr", reader), 1e6 * values))

    def test_a_failure_leaves_nothing(self) -> None:
        path = self.write("a.txt", "before")
        with self.assertRaises(ValueError), images.complete_file(path) as temporary:
            temporary.write_text("half")
            raise ValueError
        self.assertEqual(self.names(), ["a.txt"])
        self.assertEqual(path.read_text(), "before")
        with self.assertRaisesRegex(RenderError, "cannot be written"):
            (self.directory / "sub.png").mkdir()
            images.write_png(self.directory / "sub.png", np.zeros((2, 2, 3), np.uint8))
        self.assertEqual(self.names(), ["a.txt", "sub.png"])

    def test_outputs_are_checked_before(self) -> None:
        for name, expected in (
            ("a.jpg", "must end in .png or .exr"),
            ("none/a.png", "no such directory"),
            ("file/a.png", "is not a directory"),
            ("directory.png", "is a directory"),
        ):
            self.write("file", "x")
            (self.directory / "directory.png").mkdir(exist_ok=True)
            with self.subTest(name=name), self.assertRaisesRegex(UsageError, expected):
                images.check_output(self.directory / name, images.FORMATS)
        with self.assertRaisesRegex(UsageError, "cannot be written"):
            images.check_output("/proc/a.png", images.FORMATS)

    def test_buffer_names(self) -> None:
        for name in (*images.BUFFERS, "rsm0.depth", "rsm12.normal", "rsm3.density",
                     "subsplat.level", "subsplat.upsampled0"):
            self.assertEqual(images.check_buffer(name), name)
        for name in ("", "Final", "rsm.depth", "rsm0.flux", "rsm0.depth ", "subsplat",
                     "subsplat.levels", "subsplatxlevel", "subsplat.evaluated"):
            with self.subTest(name=name), self.assertRaisesRegex(UsageError, "unknown buffer"):
                images.check_buffer(name)
