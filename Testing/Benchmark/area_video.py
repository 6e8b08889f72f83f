#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A room that a video lights, after figure 1 of "Direct Illumination from Dynamic Area Lights"
(Nichols and Wyman 2009): pictures of three of its frames in a strip, and frames a second.

    Testing/Benchmark/area_video.py [--size WxH] [--rounds N] [--strip WxH] FILE.png

The video, slices through data sets (slices.py), runs on a display on a wall of area_apartment and
is its only light; its pixels are encoded (sRGB) as those of any video. The strip has still
pictures, of four samples a pixel, linear radiance encoded likewise. It measures frames while
the camera turns at the rate that VTK's interactors ask for, each with the video's next picture, and
in turn with them frames of plain VTK, which has a vtkLight in the place of the display: medians, by
wall clock.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight

import slices
from vtkindirect import area_lights, frames, images, load_scene, methods, wrapped
from vtkindirect.scene import Scene

SCENE = Path(__file__).resolve().parents[1] / "Scenes" / "area_apartment.json"
SIZE = (1024, 1024)
STRIP = (480, 360)
TEXELS = 512
ROUNDS = 24
# On the wall between the corner and the window.
CORNERS = ((11.37, 0.8, 0.35), (11.37, 0.8, 2.75), (11.37, 2.4, 0.35))
RADIANCE = 2.0
# Places in the film, one in each data set.
SHOWN = (0.15, 0.45, 0.85)
PAPER = "25 to 30 on a card of 2009, without shadows"
GAP = 8
FILLING_FRAMES = 24


def make_display() -> Any:
    """Return the display."""
    lamp = wrapped.get(area_lights.CLASS)()
    for name, corner in zip(("Origin", "Point1", "Point2"), CORNERS):
        getattr(lamp, f"Set{name}")(*corner)
    lamp.SetRadiance(RADIANCE, RADIANCE, RADIANCE)
    lamp.EncodedOn()
    lamp.VisibleOn()
    return lamp


class Room:
    """The flat at night: with the display, or as plain VTK has it."""

    def __init__(self, size: tuple[int, int], lit: bool) -> None:
        self.scene: Scene = load_scene(SCENE)
        self.scene.size = size
        area_lights.detach_all(self.scene.renderer)
        self.scene.actors["evening"].VisibilityOff()
        self.display = make_display() if lit else None
        self.times: list[float] = []
        self.frame = 0
        if not lit:
            light = vtkLight()
            light.PositionalOn()
            light.SetPosition(*(np.array(CORNERS[1]) + CORNERS[2]) / 2.0)
            light.SetFocalPoint(0.0, 1.5, 1.5)
            light.SetConeAngle(89.0)
            self.scene.renderer.AddLight(light)
        self.window = self.scene.make_window()
        if lit:
            self.indirect = methods.enable(self.scene.renderer, lighting="scene")
            self.indirect.AddAreaLight(self.display)

    def fill(self, render: Callable[[], None]) -> None:
        """Render until no depth map is missing; some of what surfaces reflect change with videos."""
        before = -1
        for _ in range(FILLING_FRAMES):
            render()
            drawn = frames.tiles_drawn(self.indirect)
            if drawn == before:
                break
            before = drawn

    def step(self, pictures: Sequence[Any]) -> None:
        """Turn the camera by a little, go on with the video, and render."""
        camera = self.scene.renderer.GetActiveCamera()
        camera.Yaw(0.2 if self.frame // 30 % 2 == 0 else -0.2)
        begin = time.perf_counter()
        if self.display is not None:
            self.display.SetImage(pictures[self.frame % len(pictures)])
        self.window.Render()
        self.window.WaitForCompletion()
        self.times.append(time.perf_counter() - begin)
        self.frame += 1


def encoded(radiance: np.ndarray) -> np.ndarray:
    """Return a picture's bytes: means of 2 x 2 pixels, encoded by the transfer function of sRGB."""
    height, width, _ = radiance.shape
    mean = np.clip(radiance.reshape(height // 2, 2, width // 2, 2, 3), 0.0, 1.0).mean(axis=(1, 3))
    curve = np.where(mean < 0.0031308, 12.92 * mean, 1.055 * mean ** (1.0 / 2.4) - 0.055)
    return np.round(255.0 * curve).astype(np.uint8)


def strip(size: tuple[int, int]) -> np.ndarray:
    """Return three still pictures side by side."""
    room = Room((2 * size[0], 2 * size[1]), True)
    parts = []
    for share in SHOWN:
        room.display.SetImage(slices.as_image(slices.frame(share, TEXELS)))
        room.fill(room.window.Render)
        picture = encoded(images.copy_buffer(room.scene.renderer, "final"))
        parts += [picture, np.full((size[1], GAP, 3), 255, np.uint8)]
    room.window.Finalize()
    return np.concatenate(parts[:-1], axis=1)


def measure(size: tuple[int, int], rounds: int) -> tuple[float, float]:
    """Return the seconds of a frame with the video, and of plain VTK's."""
    rooms = [Room(size, True), Room(size, False)]
    # As many as arrive in two seconds of a video; made before, as a decoder would hand them over.
    shares = np.linspace(0.0, 1.0, 12, endpoint=False)
    pictures = [slices.as_image(slices.frame(float(share), TEXELS)) for share in shares]
    for room in rooms:
        room.window.SetDesiredUpdateRate(frames.INTERACTIVE_RATE)
    # Until depth maps are there, and not the first frames with their shaders.
    rooms[0].fill(lambda: rooms[0].step(pictures))
    for _ in range(3):
        rooms[1].step(pictures)
    for room in rooms:
        room.times.clear()
    for _ in range(rounds):
        for room in rooms:
            room.step(pictures)
    medians = [statistics.median(room.times) for room in rooms]
    for room in rooms:
        room.window.Finalize()
    return medians[0], medians[1]


def size_of(text: str) -> tuple[int, int]:
    """Read WxH."""
    width, height = map(int, text.split("x"))
    return width, height


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n\n", maxsplit=1)[0])
    parser.add_argument("file", type=Path, metavar="FILE.png")
    parser.add_argument("--size", type=size_of, default=SIZE, metavar="WxH")
    parser.add_argument("--strip", type=size_of, default=STRIP, metavar="WxH")
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    options = parser.parse_args(arguments)
    images.write_png(options.file, strip(options.strip))
    lit, plain = measure(options.size, options.rounds)
    width, height = options.size
    print(
        f"{width} x {height}, video of {TEXELS} x {TEXELS}: {1.0 / lit:.2f} frames a second "
        f"({1000.0 * lit:.0f} ms), {lit / plain:.1f} of what plain VTK's frame takes "
        f"({1.0 / plain:.2f} a second). The paper: {PAPER}."
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
