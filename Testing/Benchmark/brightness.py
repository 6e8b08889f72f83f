#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How bright and how dark pictures with each lighting are, beside those of plain VTK.

    Testing/Benchmark/brightness.py [--size WxH] [--json FILE] [SCENE...]

Five kinds of pictures that people make, of the committed data: each in VTK's headlight and in its
light kit, on a black background and without the walls of the committed scenes, whose lights are
left out. Only pixels that lie within the objects count, not those of outlines.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import vtkindirect
from vtkindirect import environments, images, lighting, lights, windows
from vtkindirect.scene import Scene, load_scene

SCENES = Path(__file__).resolve().parent.parent / "Scenes"

# The scene file, and those of its actors that are a stage for the others.
PICTURES = {
    "molecule": ("protein", ("ground", "wall", "back")),
    "isosurfaces": ("frog", ("ground", "wall")),
    "brain": ("brain", ("ground", "wall")),
    "machine part": ("sky_machine", ()),
    "terrain": ("sky_terrain", ()),
}

LIGHTS = ("headlight", "light kit")

DARK = 12 / 255
"""Brightness below which nothing can be told apart on an ordinary screen."""

WEIGHTS = np.array([0.2126, 0.7152, 0.0722])  # ITU-R BT.709


@dataclass(frozen=True)
class Look:
    """Of an object's pixels: mean brightness, and the share of those that are dark."""

    mean: float
    dark: float


def load(name: str) -> Scene:
    """Load a picture's scene, without its stage and its lights."""
    file, stage = PICTURES[name]
    scene = load_scene(SCENES / f"{file}.json")
    for actor in stage:
        scene.actors[actor].VisibilityOff()
    environments.attach(scene.renderer, None)
    scene.renderer.SetBackground(0.0, 0.0, 0.0)
    if stage:
        scene.renderer.ResetCamera()
    else:
        scene.renderer.ResetCameraClippingRange()
    return scene


def set_lights(scene: Scene, kind: str) -> None:
    """Give a scene the lights that VTK or PyVista would give it."""
    scene.renderer.RemoveAllLights()
    scene.renderer.AutomaticLightCreationOn()
    if kind == "light kit":
        lights.add_light_kit(scene.renderer)


def inside(normal: np.ndarray) -> np.ndarray:
    """Which pixels lie within objects: their neighbours do, too."""
    hit = np.abs(normal).sum(axis=-1) > 0.5
    result = hit.copy()
    for axis in (0, 1):
        for step in (-1, 1):
            moved = np.roll(hit, step, axis)
            border = [slice(None), slice(None)]
            border[axis] = 0 if step > 0 else -1
            moved[tuple(border)] = False
            result &= moved
    return result


def look(picture: np.ndarray, where: np.ndarray) -> Look:
    """Measure a picture of values from 0 to 1."""
    brightness = picture[where] @ WEIGHTS
    return Look(float(brightness.mean()), float((brightness < DARK).mean()))


def shown(scene: Scene) -> np.ndarray:
    """What the window shows, from 0 to 1."""
    return images.window_bytes(scene.render_window) / 255.0


def measure(scene: Scene) -> dict[str, Look]:
    """Measure a scene with its lights in each lighting; that of plain VTK is called "plain"."""
    window = scene.render_window
    vtkindirect.disable(scene.renderer)
    window.Render()
    plain = shown(scene)
    vtkindirect.enable(scene.renderer, lighting="scene")
    window.Render()
    where = inside(images.copy_buffer(scene.renderer, "normal"))
    found = {"plain": look(plain, where), "scene": look(shown(scene), where)}
    for name in lighting.PRESETS[1:]:
        vtkindirect.enable(scene.renderer, lighting=name)
        window.Render()
        found[name] = look(shown(scene), where)
    vtkindirect.disable(scene.renderer)
    return found


def rows(names: list[str], size: tuple[int, int]) -> Iterator[dict[str, Any]]:
    """Yield a row for each picture, light and lighting."""
    for name in names:
        scene = load(name)
        scene.make_window(size)
        windows.start(scene.render_window)
        for kind in LIGHTS:
            set_lights(scene, kind)
            found = measure(scene)
            for light, result in found.items():
                yield {
                    "picture": name,
                    "lights": kind,
                    "lighting": light,
                    "mean": result.mean,
                    "mean over plain": result.mean / found["plain"].mean,
                    "dark": result.dark,
                }
        scene.render_window.Finalize()


def main() -> int:
    """Print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("pictures", nargs="*", metavar="SCENE", help=", ".join(PICTURES))
    parser.add_argument("--size", default="320x240", metavar="WxH")
    parser.add_argument("--json", metavar="FILE", help="write the rows here, too")
    arguments = parser.parse_args()
    size = tuple(map(int, arguments.size.split("x")))
    every = []
    head = ("picture", "lights", "lighting", "mean", "mean over plain", "dark")
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for row in rows(arguments.pictures or list(PICTURES), size):
        every.append(row)
        cells = [f"{row[key]:.3f}" if isinstance(row[key], float) else row[key] for key in head]
        print("| " + " | ".join(cells) + " |", flush=True)
    if arguments.json:
        Path(arguments.json).write_text(json.dumps(every, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
