#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of area lights while somebody drags, beside VTK's own ambient occlusion.

    Testing/Benchmark/area.py [--size WxH] [--rounds N] [--bounces N] [--json FILE] [MIX ...]

A mix names lamps: `c` of one radiance, `t` an image of 256 x 256, `v` a video of 512 x 512 whose
picture changes in every frame; "-" after it leaves shadows out. The camera turns at the rate that
VTK's interactors ask for, around a box with two blocks in it. Each round renders a frame of plain
VTK, one with UseSSAO and one of each mix, in turn; what is printed are medians of milliseconds
over plain VTK's frame, and over what UseSSAO adds: by wall clock, and of all processors together,
which other programs disturb less.
"""

from __future__ import annotations

import argparse
import functools
import json
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight

import ssao
from vtkindirect import area_lights, frames, load_scene, methods, wrapped
from vtkindirect.scene import Scene

SCENE = Path(__file__).resolve().parents[1] / "Scenes" / "area_cornell.json"
SIZE = (1024, 1024)
ROUNDS = 8
MIXES = ("c", "t", "v", "ctv", "ctv-")
VIDEO_FRAMES = 8
TEXELS = {"t": 256, "v": 512}


@functools.cache
def picture(edge: int, phase: float) -> vtkImageData:
    """Return a picture as videos have them: soft shapes that move, hard edges, fine detail, bytes."""
    y, x = np.mgrid[0:edge, 0:edge] / edge
    values = np.empty((edge, edge, 3))
    for c in range(3):
        wave = np.sin(6.0 * x + 2.0 * c + phase) * np.cos(5.0 * y - c - 0.7 * phase)
        values[..., c] = 0.35 + 0.25 * wave + 0.05 * np.sin(80.0 * x + 60.0 * y * (c + 1) + phase)
    disk = (x - 0.5 - 0.3 * np.cos(phase)) ** 2 + (y - 0.5 - 0.3 * np.sin(phase)) ** 2 < 0.02
    values[disk] = (1.0, 0.9, 0.6)
    image = vtkImageData()
    image.SetDimensions(edge, edge, 1)
    pixels = np.clip(255.0 * values, 0.0, 255.0).astype(np.uint8).reshape(-1, 3)
    scalars = numpy_to_vtk(pixels, deep=1)
    image.GetPointData().SetScalars(scalars)
    return image


def make_lamp(kind: str, number: int) -> Any:
    """Make a lamp: the first lies under the ceiling, others stand before the walls."""
    lamp = wrapped.get(area_lights.CLASS)()
    places = (
        ((0.37, 0.995, 0.37), (0.63, 0.995, 0.37), (0.37, 0.995, 0.63)),
        ((0.01, 0.2, 0.8), (0.01, 0.2, 0.3), (0.01, 0.6, 0.8)),
        ((0.2, 0.3, 0.01), (0.8, 0.3, 0.01), (0.2, 0.7, 0.01)),
        ((0.99, 0.2, 0.3), (0.99, 0.2, 0.8), (0.99, 0.6, 0.3)),
    )
    origin, point1, point2 = (np.array(place) for place in places[number % len(places)])
    shift = 0.03 * (number // len(places)) * np.array((0.0, 1.0, 1.0))
    lamp.SetOrigin(*(origin + shift))
    lamp.SetPoint1(*(point1 + shift))
    lamp.SetPoint2(*(point2 + shift))
    lamp.SetRadiance(8.0, 8.0, 8.0)
    if kind in TEXELS:
        lamp.SetImage(picture(TEXELS[kind], 0.0))
    return lamp


class Measured:
    """A scene that is rendered a frame at a time."""

    def __init__(
        self,
        size: tuple[int, int],
        mix: str | None,
        make: Callable[[str, int], Any] = make_lamp,
        bounces: int = 0,
    ) -> None:
        self.scene: Scene = load_scene(SCENE)
        self.scene.size = size
        area_lights.detach_all(self.scene.renderer)
        self.videos: list[Any] = []
        self.frame = 0
        self.times: list[float] = []
        self.processor: list[float] = []
        self.indirect = None
        self.pictures = [picture(TEXELS["v"], 0.8 * k) for k in range(VIDEO_FRAMES)]
        if mix is None:
            light = vtkLight()
            light.PositionalOn()
            light.SetPosition(0.5, 0.9, 0.5)
            light.SetConeAngle(90.0)
            self.scene.renderer.AddLight(light)
        self.window = self.scene.make_window()
        self.window.SetDesiredUpdateRate(frames.INTERACTIVE_RATE)
        if mix is not None:
            self.indirect = methods.enable(
                self.scene.renderer, lighting="scene", NumberOfBounces=bounces
            )
            if "-" in mix:
                self.indirect.SetVisibilityToNone()
            for number, kind in enumerate(mix.replace("-", "")):
                lamp = make(kind, number)
                self.indirect.AddAreaLight(lamp)
                if kind == "v":
                    self.videos.append(lamp)

    def render(self) -> float:
        """Turn the camera by a little, go on with videos, and render; returns milliseconds."""
        self.scene.renderer.GetActiveCamera().Azimuth(0.3 if self.frame // 20 % 2 == 0 else -0.3)
        self.frame += 1
        for number, lamp in enumerate(self.videos):
            lamp.SetImage(self.pictures[(self.frame + number) % VIDEO_FRAMES])
        begin = time.process_time()
        taken = frames.timed_render(self.window)
        self.processor.append(1000.0 * (time.process_time() - begin))
        return taken

    def fill(self) -> None:
        """Render until no depth map is missing; some of what surfaces reflect change with videos."""
        before = -1
        for _ in range(frames.MOST_FILLING_FRAMES):
            self.render()
            drawn = frames.tiles_drawn(self.indirect)
            if drawn == before:
                break
            before = drawn

    def stages(self, count: int) -> dict[str, float]:
        """Return the medians of the stages; apart, because each waits for OpenGL."""
        self.indirect.SetTiming(True)
        for _ in range(count):
            self.render()
        found = methods.report(self.indirect)["stages"]
        self.indirect.SetTiming(False)
        return {name: times["median_ms"] for name, times in found.items()}


def measure(
    size: tuple[int, int], mixes: Sequence[str], rounds: int, bounces: int = 0
) -> dict[str, Any]:
    """Measure all, a frame of each in turn."""
    plain, occluded = Measured(size, None), Measured(size, None)
    ssao.set_up(occluded.scene.renderer)
    occluded.scene.renderer.UseSSAOOn()
    all_of_them = {"plain": plain, "ssao": occluded}
    all_of_them.update({mix: Measured(size, mix, bounces=bounces) for mix in mixes})
    for one in all_of_them.values():
        one.fill()
        one.processor.clear()
    for _ in range(rounds):
        for one in all_of_them.values():
            one.times.append(one.render())
    medians = {name: statistics.median(one.times) for name, one in all_of_them.items()}
    added = medians["ssao"] - medians["plain"]
    work = {name: statistics.median(one.processor) for name, one in all_of_them.items()}
    worked = work["ssao"] - work["plain"]
    result: dict[str, Any] = {"size": list(size), "plain_ms": medians["plain"], "ssao_ms": added}
    result["ssao_processor_ms"] = worked
    result["mixes"] = {}
    for mix in mixes:
        more = medians[mix] - medians["plain"]
        result["mixes"][mix] = {
            "added_ms": more,
            "over_ssao": more / added,
            "processor_ms": work[mix] - work["plain"],
            "processor_over_ssao": (work[mix] - work["plain"]) / worked,
            "stages": all_of_them[mix].stages(max(rounds // 2, 3)),
        }
    for one in all_of_them.values():
        one.window.Finalize()
    return result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("mixes", nargs="*", metavar="MIX", default=MIXES)
    parser.add_argument("--size", default="x".join(map(str, SIZE)))
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--bounces", type=int, default=0, help="0: all (default)")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args(arguments)
    width, height = map(int, options.size.split("x"))
    result = measure((width, height), options.mixes or MIXES, options.rounds, options.bounces)
    print(
        f"plain {result['plain_ms']:.0f} ms, UseSSAO adds {result['ssao_ms']:.0f} ms, "
        f"{result['ssao_processor_ms']:.0f} of processors"
    )
    for mix, found in result["mixes"].items():
        stages = ", ".join(f"{name} {ms:.0f}" for name, ms in found["stages"].items() if ms >= 0.5)
        wall = f"{found['added_ms']:.0f} ms, {found['over_ssao']:.2f} of that"
        work = f"{found['processor_ms']:.0f} of processors, {found['processor_over_ssao']:.2f}"
        print(f"{mix}: adds {wall}; {work}; {stages}")
    if options.json:
        options.json.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
