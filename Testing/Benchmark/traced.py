# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with references by path tracing: what all share that hold the sky to them."""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import frames, metrics, references
from vtkindirect.metrics import Errors
from vtkindirect.scene import Scene

FOLDER = Path(__file__).resolve().parents[1]
SAME = 2e-3
"""Relative difference of depths under which a pixel shows the surface that was traced: half floats
keep 5e-4, spheres are traced as triangles within 4e-3 of their radius."""
LAYERS = {"sky": "S1", "bounce": "S2"}
"""What buffers are compared with: light of the sky, and its first bounce."""
MOST_FRAMES = 300


def parser(description: str, scenes: Sequence[str]) -> argparse.ArgumentParser:
    """Return a parser of names of scenes, these by default."""
    made = argparse.ArgumentParser(description=description.splitlines()[0])
    made.add_argument("scenes", nargs="*", default=list(scenes), metavar="SCENE")
    return made


class Traced:
    """A scene in a window of its own, an odd number of times the size of its reference."""

    def __init__(self, name: str, factor: int = references.FACTOR) -> None:
        self.stored = FOLDER / "Reference" / "data" / f"{name}.exr"
        self.factor = factor
        self.traced = references.read_layer(self.stored, "depth")[..., 0]
        height, width = self.traced.shape
        self.scene: Scene = vtkindirect.load_scene(FOLDER / "Scenes" / f"{name}.json")
        frames.open_window(self.scene, (factor * width, factor * height))
        self.window = self.scene.render_window
        self.renderer = self.scene.renderer

    def counters(self) -> dict[str, int]:
        """Return the counters of the last frame; none without a pass."""
        if vtkindirect.pass_of(self.renderer) is None:
            return {}
        return vtkindirect.report(self.renderer)["counters"]

    def spend(self) -> float:
        """Render, and return the processor's milliseconds."""
        begin = time.process_time()
        self.window.Render()
        return 1e3 * (time.process_time() - begin)

    def complete(self) -> float:
        """Render until no map is left to be drawn, and return the milliseconds of all frames."""
        spent = self.spend()
        for _ in range(MOST_FRAMES):
            if not self.counters().get("tiles_left"):
                break
            spent += self.spend()
        return spent

    def length(self) -> float:
        """Return the longest side of the scene's bounds."""
        return float(np.ptp(np.array(self.scene.bounds).reshape(3, 2), axis=1).max())

    def buffer(self, name: str) -> np.ndarray:
        """Return a buffer of the last frame at the reference's pixels."""
        middle = slice(self.factor // 2, None, self.factor)
        return vtkindirect.copy_buffer(self.renderer, name)[middle, middle]

    def same(self) -> np.ndarray:
        """Return which of these show the surface that was traced."""
        depth = self.buffer("depth")[..., 0]
        return (depth > 0.0) & (np.abs(depth - self.traced) < SAME * self.traced)

    def errors(self, name: str) -> Errors:
        """Return the errors of a buffer there."""
        layer = references.read_layer(self.stored, LAYERS[name])
        return metrics.compare(self.buffer(name), layer, self.same())
