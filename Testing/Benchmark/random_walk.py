#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6 of Dachsbacher and Stamminger 2006, with this project: lights of a quasi-random walk.

    Testing/Benchmark/random_walk.py [--lights N] [--bounces N] [--scene FILE] FILE.png

On the left what the paper's method shows, lights that nothing hides, on the right instant radiosity:
each light with a depth map of its own. Both by the gather at every pixel with the same lights. Prints
the time of the walk, of light alone, while a light moves, and errors to all bounces where the scene
has a reference.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import vtkindirect
from vtkindirect import frames, images, metrics, references

HERE = Path(__file__).resolve().parents[1]
GAP = 4
MOST_FRAMES = 100


def render(scene: vtkindirect.Scene, visibility: str, lights: int, bounces: int) -> np.ndarray:
    """Return the picture when all depth maps are there."""
    vtkindirect.enable(
        scene.renderer, "gather", "random_walk", lighting="scene", Interpolation=False,
        NumberOfLights=lights, NumberOfBounces=bounces, Visibility=visibility,
    )  # fmt: skip
    for _ in range(MOST_FRAMES):
        scene.render_window.Render()
        if not vtkindirect.report(scene.renderer)["counters"]["tiles_left"]:
            break
    return images.window_bytes(scene.render_window)


def time_walk(scene: vtkindirect.Scene, count: int = 9) -> float:
    """Return the milliseconds in which a walk is made again, by wall clock, for a light that moves."""
    light = scene.renderer.GetLights().GetItemAsObject(0)
    indirect = vtkindirect.pass_of(scene.renderer)
    indirect.SetTiming(True)
    start = np.array(light.GetPosition())
    size = np.ptp(np.reshape(scene.renderer.ComputeVisiblePropBounds(), (3, 2)), axis=1).max()
    for step in range(count):
        light.SetPosition(start + 1e-3 * size * (step % 2))
        scene.render_window.Render()
    found = vtkindirect.report(scene.renderer)["stages"]["lights"]["median_ms"]
    light.SetPosition(start)
    indirect.SetTiming(False)
    return float(found)


def main(arguments: Sequence[str] | None = None) -> int:
    """Render both pictures, print what was measured."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=Path)
    parser.add_argument("--lights", type=int, default=1000)
    parser.add_argument("--bounces", type=int, default=16)
    parser.add_argument("--scene", default=str(HERE / "Scenes" / "cornell_box.json"))
    given = parser.parse_args(arguments)
    images.check_output(given.file, (".png",))
    scene = vtkindirect.load_scene(given.scene)
    stored = HERE / "Reference" / "data" / f"{Path(given.scene).stem}.exr"
    size = references.natural_size(stored) or (256, 256)
    frames.open_window(scene, size)
    expected = references.read_layer(stored, "R3") if stored.exists() else None
    pictures = []
    for visibility in ("none", "maps"):
        begin = time.process_time()
        pictures.append(render(scene, visibility, given.lights, given.bounces))
        seconds = time.process_time() - begin
        line = f"visibility {visibility}: {seconds:.2f} s of processor time"
        if expected is not None:
            step = size[0] // expected.shape[1]
            light = vtkindirect.copy_buffer(scene.renderer, "irradiance")
            where = references.mask(scene)
            middle = slice(step // 2, None, step)
            errors = metrics.compare(light[middle, middle], expected, where[middle, middle])
            line += f", relMSE to all bounces {errors.relmse:.4f}, bias {100 * errors.bias:+.1f} %"
        print(line)
    print(f"walk: {time_walk(scene):.1f} ms for {given.lights} lights, median")
    report = vtkindirect.report(scene.renderer)
    print(next(entry["why"] for entry in report["modelled"] if entry["what"] == "random walk"))
    gap = np.full((pictures[0].shape[0], GAP, pictures[0].shape[2]), 255, dtype=np.uint8)
    images.write_png(given.file, np.concatenate([pictures[0], gap, pictures[1]], axis=1))
    scene.render_window.Finalize()
    return 0


if __name__ == "__main__":
    sys.exit(main())
