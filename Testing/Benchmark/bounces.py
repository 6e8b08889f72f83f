#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One bounce beside all of them, at the defaults: errors to a path tracer's image, and time.

    Testing/Benchmark/bounces.py [--frames N] SCENE...

Pictures have the size of the stored reference of all bounces (R3), and are complete: all depth maps
have been drawn. Times are processor time of frames in which only the camera turns, as interactors
ask for them, with one bounce and with all of them in turn. Prints a page.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import vtkindirect
from vtkindirect import frames, metrics, references
from vtkindirect.errors import UsageError
from vtkindirect.scene import Scene

DATA = Path(__file__).resolve().parents[1] / "Reference" / "data"
BOUNCES = {"one": 1, "all": 0}
"""`NumberOfBounces` by name; 0 chooses by itself."""
MOST_FRAMES = 100
UPDATE_RATE = 10.0
TURN = 0.2


@dataclass
class Row:
    """A scene with a number of bounces."""

    errors: metrics.Errors
    lights: int
    seconds: list[float]


def open_scene(path: str, bounces: int) -> tuple[Scene, np.ndarray]:
    """Return a scene with the pass on, and its reference."""
    stored = DATA / f"{Path(path).stem}.exr"
    expected = references.read_layer(stored, "R3") if stored.exists() else None
    if expected is None:
        raise UsageError(f"{path}: there is no reference of all bounces")
    scene = vtkindirect.load_scene(path)
    frames.open_window(scene, (expected.shape[1], expected.shape[0]))
    vtkindirect.enable(scene.renderer, lighting="scene", NumberOfBounces=bounces)
    return scene, expected


def complete(scene: Scene, expected: np.ndarray) -> Row:
    """Return the errors of a still picture."""
    for _ in range(MOST_FRAMES):
        scene.render_window.Render()
        if not vtkindirect.report(scene.renderer)["counters"]["tiles_left"]:
            break
    light = vtkindirect.copy_buffer(scene.renderer, "irradiance")
    errors = metrics.compare(light, expected, references.mask(scene))
    return Row(errors, int(vtkindirect.report(scene.renderer)["virtual_lights"]), [])


def turn(scene: Scene, step: int) -> float:
    """Return the processor time of a frame of another direction."""
    scene.render_window.SetDesiredUpdateRate(UPDATE_RATE)
    scene.renderer.GetActiveCamera().Azimuth(TURN if step % 2 else -TURN)
    begin = time.process_time()
    scene.render_window.Render()
    return time.process_time() - begin


def measure(path: str, count: int) -> dict[str, Row]:
    """Return the rows of a scene."""
    scenes = {name: open_scene(path, bounces) for name, bounces in BOUNCES.items()}
    rows = {name: complete(*scene) for name, scene in scenes.items()}
    for step in range(count):
        for name, (scene, _) in scenes.items():
            rows[name].seconds.append(turn(scene, step))
    for scene, _ in scenes.values():
        scene.render_window.Finalize()
    return rows


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=15)
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    given = parser.parse_args(arguments)
    print("| scene | relMSE, one | bias, one | relMSE, all | bias, all | lights | time, all / one |")
    print("|---" * 7 + "|")
    for path in given.scenes:
        rows = measure(path, max(given.frames, 2))
        cells = [Path(path).stem]
        for row in rows.values():
            cells += [f"{row.errors.relmse:.4f}", f"{100 * row.errors.bias:+.1f} %"]
        ratio = np.median(rows["all"].seconds[1:]) / np.median(rows["one"].seconds[1:])
        print("| " + " | ".join([*cells, str(rows["all"].lights), f"{ratio:.2f}"]) + " |", flush=True)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as error:
        sys.exit(f"bounces.py: {error}")
