#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of many actors while somebody drags: before, while and after depth maps are drawn.

    Testing/Benchmark/many.py [--size WxH] [--frames N] [--actors N,N] [--json FILE]

Spheres of 1,000 triangles, an actor each, over a ground, under a point light and a sky. The camera
turns at the rate that VTK's interactors ask for. A line for each scene:

* plain VTK: its frames, which have neither shadows nor a sky;
* filling: the pass while frames draw depth maps, which starts with nothing;
* full: the pass when all of them are there;
* picture: what the first picture of a camera that stands takes, shaders included, and how long it
  is until no map is missing.

Times are milliseconds by wall clock; of several, the median and the largest.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from vtkmodules.vtkCommonCore import vtkMinimalStandardRandomSequence
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

from vtkindirect import environments, frames, methods, windows
from vtkindirect.scene import Scene

ACTORS = (100, 1000)
FRAMES = 20
SIZE = (1024, 768)
MOST_FRAMES = 2000
"""While maps are drawn, before it is given up."""


def make_scene(count: int, size: tuple[int, int]) -> Scene:
    """Make a scene of so many spheres."""
    scene = Scene(f"{count} actors", Path(), size)
    random = vtkMinimalStandardRandomSequence()
    random.SetSeed(7)

    def number() -> float:
        random.Next()
        return float(random.GetValue())

    def add(source: Any) -> None:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.4 + 0.5 * number(), 0.4 + 0.5 * number(), 0.7)
        scene.add_actor(None, actor)

    edge = math.ceil(math.sqrt(count))
    ground = vtkPlaneSource()
    ground.SetOrigin(-1.0, -1.0, 0.0)
    ground.SetPoint1(edge, -1.0, 0.0)
    ground.SetPoint2(-1.0, edge, 0.0)
    add(ground)
    for i in range(count):
        ball = vtkSphereSource()
        ball.SetThetaResolution(25)
        ball.SetPhiResolution(22)  # 2 * 25 * 20 triangles
        ball.SetRadius(0.3 + 0.15 * number())
        ball.SetCenter(i % edge, i // edge, 0.45 + 2.0 * number())
        add(ball)
    light = vtkLight()
    light.PositionalOn()
    light.SetConeAngle(90.0)
    light.SetPosition(0.3 * edge, 0.4 * edge, 0.7 * edge)
    scene.renderer.AddLight(light)
    environments.attach(scene.renderer, environments.from_value((0.4, 0.4, 0.4)))
    camera = scene.renderer.GetActiveCamera()
    camera.SetFocalPoint(0.5 * edge, 0.5 * edge, 0.5)
    camera.SetPosition(0.5 * edge, -0.8 * edge, 0.9 * edge)
    camera.SetViewUp(0.0, 0.0, 1.0)
    scene.renderer.ResetCamera()
    return scene


def turned(scene: Scene, window: Any) -> float:
    """Turn the camera a little and render; returns milliseconds."""
    scene.renderer.GetActiveCamera().Azimuth(frames.TURN)
    return frames.timed_render(window)


def summary(times: list[float]) -> dict[str, float]:
    """Return the median, the greatest and the number of several times."""
    return {"median_ms": statistics.median(times), "max_ms": max(times), "frames": len(times)}


def measure(scene: Scene, window: Any, count: int) -> dict[str, Any]:
    """Measure a scene."""
    renderer = scene.renderer
    window.SetDesiredUpdateRate(frames.INTERACTIVE_RATE)
    turned(scene, window)
    result: dict[str, Any] = {"plain": summary([turned(scene, window) for _ in range(count)])}

    window.SetDesiredUpdateRate(frames.STILL_RATE)
    indirect = methods.enable(renderer, lighting="scene")
    begin = time.perf_counter()
    result["picture_ms"], before, pictures = frames.timed_render(window), 0, 1
    while (drawn := frames.tiles_drawn(indirect)) > before and pictures < MOST_FRAMES:
        result["complete_ms"] = 1000.0 * (time.perf_counter() - begin)
        result["complete_frames"], before = pictures, drawn
        frames.timed_render(window)
        pictures += 1
    methods.disable(renderer)

    window.SetDesiredUpdateRate(frames.INTERACTIVE_RATE)
    indirect = methods.enable(renderer, lighting="scene")
    result["first_ms"] = turned(scene, window)
    filling: list[float] = []
    before, drawn = 0, frames.tiles_drawn(indirect)
    while drawn > before and len(filling) < MOST_FRAMES:
        elapsed = turned(scene, window)
        before, drawn = drawn, frames.tiles_drawn(indirect)
        if drawn > before:
            filling.append(elapsed)
    result["filling"] = summary(filling) if filling else None
    result["tiles"] = drawn
    result["full"] = summary([turned(scene, window) for _ in range(count)])
    # Apart, because each stage waits for OpenGL.
    indirect.SetTiming(True)
    for _ in range(min(count, 5)):
        turned(scene, window)
    stages = methods.report(indirect)["stages"]
    result["stages"] = {name: times["median_ms"] for name, times in stages.items()}
    methods.disable(renderer)
    return result


def line(name: str, found: dict[str, Any]) -> str:
    """Return what was measured as a line of text."""

    def times(of: str) -> str:
        one = found[of]
        return f"{of} {one['median_ms']:.0f} (max {one['max_ms']:.0f})" if one else f"no {of}"

    filled = f" in {found['filling']['frames']} frames" if found["filling"] else ""
    return (
        f"{name}: {times('plain')}, {times('filling')}{filled}, {times('full')}, "
        f"first moving {found['first_ms']:.0f}; picture {found['picture_ms']:.0f}, all "
        f"{found['tiles']} maps {found['complete_ms']:.0f} in {found['complete_frames']} frames"
    )


def main(words: Sequence[str] | None = None) -> int:
    """Measure and print; `words` are those of the command line where nobody gives others."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", default="x".join(map(str, SIZE)), metavar="WxH")
    parser.add_argument("--frames", type=int, default=FRAMES, metavar="N")
    parser.add_argument("--actors", default=",".join(map(str, ACTORS)), metavar="N,N")
    parser.add_argument("--json", metavar="FILE")
    arguments = parser.parse_args(words)
    width, height = map(int, arguments.size.split("x"))
    windows.use_headless()
    found = {}
    for count in map(int, arguments.actors.split(",")):
        scene = make_scene(count, (width, height))
        window = frames.open_window(scene, None)
        found[scene.name] = measure(scene, window, arguments.frames)
        print(line(scene.name, found[scene.name]), flush=True)
        stages = found[scene.name]["stages"].items()
        parts = ", ".join(f"{name} {ms:.1f}" for name, ms in stages)
        print(f"    stages when full, ms: {parts}", flush=True)
        window.Finalize()
    if arguments.json:
        Path(arguments.json).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
