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

import statistics
import sys
from dataclasses import dataclass, field

import vtkindirect
from traced import Traced, parser

SCENES = ("sky_protein", "sky_particles", "sky_frog", "sky_brain")
MOVING, STILL = 15.0, 1e-4
"""Frames a second that the window is asked for."""
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

    traced: Traced
    turned: list[float] = field(default_factory=list)
    moved: list[float] = field(default_factory=list)

    def step(self, number: int) -> None:
        """Turn the camera, then move all actors but the ground."""
        self.traced.renderer.GetActiveCamera().Azimuth(TURN if number % 2 else -TURN)
        self.turned.append(self.traced.spend())
        size = self.traced.length()
        for name, actor in self.traced.scene.actors.items():
            if name not in ("ground", "wall"):
                actor.AddPosition(1e-3 * size * (1 if number % 2 else -1), 0.0, 0.0)
        self.moved.append(self.traced.complete())


def errors(traced: Traced) -> str:
    """Return the cells of a way's errors, and of its bounce."""
    sky, bounce = traced.errors("sky"), traced.errors("bounce")
    return f"{sky.nrmse:.3f} | {sky.bias:+.1%} | {bounce.bias:+.1%}"


def measure(name: str, count: int) -> None:
    """Print the rows of a scene."""
    ways: dict[str, Way] = {}
    cells: dict[str, str] = {}
    for label, (rate, method, settings) in {"vtk": (STILL, None, {}), **BESIDE}.items():
        traced = Traced(name)
        ways[label] = Way(traced)
        if method is not None:
            vtkindirect.enable(traced.renderer, method, lighting="scene", **settings)
        traced.window.SetDesiredUpdateRate(rate)
        traced.complete()
        if method is not None:
            cells[label] = errors(traced)
    for number in range(count):
        for way in ways.values():
            way.step(number)
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
        way.traced.window.Finalize()


def main() -> int:
    """Measure, print."""
    options = parser(__doc__, SCENES)
    options.add_argument("--frames", type=int, default=7)
    given = options.parse_args()
    print(
        "| scene | by | nRMSE, sky | bias | bias, bounce | camera turns, ms | things move, ms |\n"
        "|---|---|---:|---:|---:|---:|---:|"
    )
    for name in given.scenes:
        measure(name, max(given.frames, 2))
    return 0


if __name__ == "__main__":
    sys.exit(main())
