# SPDX-License-Identifier: BSD-3-Clause
"""The path tracer against VTK, against Mitsuba's own integrator and against a known answer.

Skipped, with the reason, where there is no environment with Mitsuba.
"""

from __future__ import annotations

import json
import tempfile
import unittest
from pathlib import Path
from typing import Any

import numpy as np
from vtkindirect import RenderError, windows, wrapped

import calibration
import check_mean
import tools


def setUpModule() -> None:
    try:
        tools.tracer_python()
    except tools.ToolError as error:
        raise unittest.SkipTest(str(error)) from None
    if not wrapped.has("vtkIndirectIlluminationPass"):
        raise unittest.SkipTest(wrapped.explain("vtkIndirectIlluminationPass"))
    try:
        windows.start(windows.render_window((8, 8), offscreen=True))
    except RenderError as error:
        raise unittest.SkipTest(str(error)) from None


class Traced(unittest.TestCase):
    """A test with a folder for descriptions."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory(prefix="vtkindirect-")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def trace(self, scene: Path, **job: Any) -> dict[str, str]:
        tools.describe(scene).save(self.folder)
        return tools.trace(self.folder, {"size": [64, 64], "surfaces": "seen.npz", **job})

    def load(self, name: str) -> dict[str, np.ndarray]:
        with np.load(self.folder / name) as arrays:
            return dict(arrays)


class Calibration(unittest.TestCase):
    """Direct light agrees with VTK's; check_calibration.py prints the same as a table."""

    def test_direct_light(self) -> None:
        for case in calibration.CASES:
            with self.subTest(case.name):
                result = calibration.compare(case)
                self.assertTrue(result.good, result)


class Integrator(Traced):
    """One and all bounces."""

    def test_closed_sphere(self) -> None:
        """In a sphere of albedo a that is lit from its centre bounce n has the irradiance a^n."""
        batch = {"file": "all.npz", "kind": "bounces", "samples": 256, "depth": 6, "seed": [1]}
        self.trace(tools.SCENES / "closed_sphere.json", batches=[batch])
        means = self.load("all.npz")["means"]
        self.assertTrue(np.allclose(means, 0.5 ** np.arange(1, 7)[:, None], rtol=2e-3), means)

    def test_same_seed_same_image(self) -> None:
        batches = [
            {"file": f"{i}.npz", "kind": "bounces", "samples": 16, "depth": 2, "seed": [seed]}
            for i, seed in enumerate((7, 7, 8))
        ]
        self.trace(tools.SCENES / "cornell_box.json", batches=batches)
        images = [self.load(batch["file"])["image"] for batch in batches]
        self.assertTrue(np.array_equal(images[0], images[1]))
        self.assertFalse(np.array_equal(images[0], images[2]))

    def test_against_mitsubas_path_integrator(self) -> None:
        """The mean radiance of bounces 1 and 2 is that of paths of one more vertex each."""
        batch = {"file": "all.npz", "kind": "bounces", "samples": 256, "depth": 2, "seed": [1]}
        first, second = ({**batch, "file": f"{i}.npz", "first": i, "depth": i} for i in (1, 2))
        size = [192, 192]
        self.trace(
            tools.SCENES / "cornell_box.json", batches=[first, second], size=size, path=256
        )
        path = json.loads((self.folder / "path.json").read_text())
        albedo = self.load("seen.npz")["albedo"]
        for bounce in (1, 2):
            found = (albedo * self.load(f"{bounce}.npz")["image"]).mean(axis=(0, 1))
            expected = np.array(path[f"bounce{bounce}"])
            self.assertTrue(np.allclose(found, expected, rtol=0.01), (bounce, found, expected))


class SumOverTexels(unittest.TestCase):
    """R1 agrees in the mean with the tracer when nothing stands in the way."""

    def test_means(self) -> None:
        for name, limit in (("closed_sphere", 2e-3), ("two_planes", 0.01), ("cornell_box", 0.01)):
            with self.subTest(name):
                means = check_mean.compare(tools.SCENES / f"{name}.json", 64, 256)
                self.assertAlmostEqual(means.r1 / means.open, 1.0, delta=limit)
