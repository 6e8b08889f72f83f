#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Light of the sky by spheres beside depth maps of 64, 256 and 512 directions: error and time.

    Testing/Benchmark/sky_spheres.py [SCENE...] [--frames N]

Scenes are those whose references were made for spheres (Testing/Reference, S1 and S2). Errors are
those of the buffer `sky` at pixels that show the surface that was traced, and the bias of the first
bounce. Times are the processor's, of all threads, beside plain VTK's frame of the same scene: of
frames in which only the camera turns, and, of the actors having moved, of all frames until the
picture is complete. Frames of all ways in turn: compare within one run. Prints a table for
Documentation/methods/sphere-proxies.md.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import frames, metrics, references
from vtkindirect.scene import Scene

FOLDER = Path(__file__).resolve().parents[1]
SCENES = ("sky_protein", "sky_particles", "sky_frog", "sky_brain")
MOVING, STILL = 15.0, 1e-4
"""Frames a second that the window is asked for."""
SAME = 2e-3
"""Relative difference of depths under which a pixel shows the surface that was traced."""
MOST_FRAMES = 300
TURN = 0.2
BESIDE = {"spheres": (MOVING, "proxies", {})} | {
    f"{count} maps, {pace}": (
        rate,
        "auto",
        {"ErrorTolerance": tolerance, "NumberOfBounces": 1, "SpheresInMotion": False},
    )
    for count, pace, rate, tolerance in (
        (64, "moving", MOVING, 0.0),
        (256, "still", STILL, 0.0),
        # The least number whose error is expected below 0.021.
        (512, "still", STILL, 0.021),
    )
}
"""By name: the window's rate, the method and its settings."""


@dataclass
class Way:
    """A scene in a window of its own, and what it has taken."""

    scene: Scene
    turned: list[float] = field(default_factory=list)
    moved: list[float] = field(default_factory=list)

    def spend(self) -> float:
        """Render, and return the processor's milliseconds."""
        begin = time.process_time()
        self.scene.render_window.Render()
        return 1e3 * (time.process_time() - begin)

    def complete(self, plain: bool) -> float:
        """Render until nothing is left to be drawn, and return the milliseconds of all frames."""
        spent = self.spend()
        for _ in range(MOST_FRAMES):
            if plain or not vtkindirect.report(self.scene.renderer)["counters"].get("tiles_left"):
                break
            spent += self.spend()
        return spent

    def step(self, number: int, plain: bool) -> None:
        """Turn the camera, then move all actors but the ground."""
        self.scene.renderer.GetActiveCamera().Azimuth(TURN if number % 2 else -TURN)
        self.turned.append(self.spend())
        size = np.ptp(np.array(self.scene.bounds).reshape(3, 2), axis=1).max()
        for name, actor in self.scene.actors.items():
            if name not in ("ground", "wall"):
                actor.AddPosition(1e-3 * size * (1 if number % 2 else -1), 0.0, 0.0)
        self.moved.append(self.complete(plain))


def errors(way: Way, stored: Path) -> str:
    """Return the cells of a way's errors, and of its bounce."""
    centre = slice(references.FACTOR // 2, None, references.FACTOR)
    buffers = {
        name: vtkindirect.copy_buffer(way.scene.renderer, name)[centre, centre]
        for name in ("depth", "sky", "bounce")
    }
    traced = references.read_layer(stored, "depth")[..., 0]
    depth = buffers["depth"][..., 0]
    same = (depth > 0.0) & (np.abs(depth - traced) < SAME * traced)
    sky = metrics.compare(buffers["sky"], references.read_layer(stored, "S1"), same)
    bounce = metrics.compare(buffers["bounce"], references.read_layer(stored, "S2"), same)
    return f"{sky.nrmse:.3f} | {sky.bias:+.1%} | {bounce.bias:+.1%}"


def measure(name: str, count: int) -> None:
    """Print the rows of a scene."""
    stored = FOLDER / "Reference" / "data" / f"{name}.exr"
    ways: dict[str, Way] = {}
    cells: dict[str, str] = {}
    for label, (rate, method, settings) in {"vtk": (STILL, None, {}), **BESIDE}.items():
        scene = vtkindirect.load_scene(FOLDER / "Scenes" / f"{name}.json")
        frames.open_window(scene, references.natural_size(stored))
        way = ways[label] = Way(scene)
        if method is not None:
            vtkindirect.enable(scene.renderer, method, lighting="scene", **settings)
        scene.render_window.SetDesiredUpdateRate(rate)
        way.complete(method is None)
        if method is not None:
            cells[label] = errors(way, stored)
    for number in range(count):
        for label, way in ways.items():
            way.step(number, label == "vtk")
    turned, moved = (
        {label: statistics.median(getattr(way, what)) for label, way in ways.items()}
        for what in ("turned", "moved")
    )
    for label, cell in cells.items():
        print(
            f"| {name} | {label} | {cell} | {turned[label] - turned['vtk']:.0f} |"
            f" {moved[label] - moved['vtk']:.0f} |",
            flush=True,
        )
    for way in ways.values():
        way.scene.render_window.Finalize()


def main() -> int:
    """Measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=list(SCENES), metavar="SCENE")
    parser.add_argument("--frames", type=int, default=7)
    given = parser.parse_args()
    print(
        "| scene | by | nRMSE, sky | bias | bias, bounce | camera turns, ms | things move, ms |\n"
        "|---|---|---:|---:|---:|---:|---:|"
    )
    for name in given.scenes:
        measure(name, max(given.frames, 2))
    return 0


if __name__ == "__main__":
    sys.exit(main())
