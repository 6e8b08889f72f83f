# SPDX-License-Identifier: BSD-3-Clause
"""Readability of an object: its brightness, its contrast, and the share that is nearly black.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/readability.py
        [--size WIDTH] [--shot NAME]... [--light NAME]...

Prints a Markdown table of objects in the headlight that VTK gives a renderer without lights, in its
light kit, which is PyVista's too, and under a single sun: plain VTK, with its UseSSAO, and the pass
with the lights as they are (scene) and with its presets. A cell is the object's mean brightness
over plain VTK's; the share of its pixels that are nearly black: the mean of their red, green and
blue is below 12 of 255; and how bright its pits are: the mean of the tenth of its pixels that
receive least of a uniform sky, over the mean of all. Pixels count that lie within the object, their
neighbours too.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import vtkindirect
from multiresolution import table
from vtkindirect import environments, frames, images, lighting, lights
from vtkmodules.vtkRenderingCore import vtkRenderer

import shots
import ssao

STANDING = "machine on a table"
NAMES = (
    "molecule", "isosurfaces", "tissues", "machine", STANDING, "terrain", "brain", "superquadric",
    "quadric",
)  # fmt: skip
LIGHTS = ("headlight", "light kit", "one sun")
BLACK = 12
"""A pixel is nearly black below this, of 255."""
PITS = 10
"""Percent of the object's pixels, those that receive least of a uniform sky."""


class Seen(NamedTuple):
    """Readability of an object in a picture."""

    black: float
    """Share of its pixels that are nearly black."""
    brightness: float
    """Mean of its pixels, 0 to 255."""
    pits: float
    """Mean of the least open of its pixels over that of all: the less, the more shape is seen."""


def measure(picture: np.ndarray, mask: np.ndarray, openness: np.ndarray) -> Seen:
    """Measure a picture of bytes, height x width x 3, where `mask` is; `openness`: its pixels'."""
    values = picture[mask].astype(float).mean(axis=-1)
    open_ = openness[mask]
    pits = values[open_ <= np.percentile(open_, PITS)]
    brightness = float(values.mean())
    return Seen(float((values < BLACK).mean()), brightness, float(pits.mean()) / brightness)


def object_mask(scene: vtkindirect.Scene) -> np.ndarray:
    """Pixels within the object: they and their neighbours are the same on black and on white."""
    renderer, window = scene.renderer, scene.render_window
    pictures = []
    before = renderer.GetBackground()
    for level in (0.0, 1.0):
        renderer.SetBackground(level, level, level)
        window.Render()
        pictures.append(images.window_bytes(window))
    renderer.SetBackground(before)
    hit = np.pad((pictures[0] == pictures[1]).all(axis=-1), 1)
    height, width = pictures[0].shape[:2]
    moves = [hit[y : y + height, x : x + width] for y in range(3) for x in range(3)]
    return np.logical_and.reduce(moves)


def find_openness(scene: vtkindirect.Scene) -> np.ndarray:
    """Return the light of a uniform sky at pixels, over that of the whole sky."""
    vtkindirect.enable(scene, environment=(1.0, 1.0, 1.0), lighting="scene")
    scene.render_window.Render()
    found = images.copy_buffer(scene, "sky").mean(axis=-1)
    vtkindirect.enable(scene, environment=None)
    return found


def _plain(scene: vtkindirect.Scene) -> np.ndarray:
    scene.render_window.Render()
    return images.window_bytes(scene.render_window)


def _with_ssao(scene: vtkindirect.Scene) -> np.ndarray:
    with ssao.used(scene.renderer):
        return _plain(scene)


def _with_pass(preset: str) -> Callable[[vtkindirect.Scene], np.ndarray]:
    def render(scene: vtkindirect.Scene) -> np.ndarray:
        # It stays on for the next one, which then has the sky's maps already.
        vtkindirect.enable(scene, lighting=preset)
        return _plain(scene)

    return render


WAYS = {
    "VTK": _plain,
    "UseSSAO": _with_ssao,
    **{name: _with_pass(name) for name in lighting.PRESETS},
}


def set_lights(renderer: vtkRenderer, kind: str) -> None:
    """Give a renderer what VTK or PyVista would light it with."""
    environments.attach(renderer, None)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOn()
    if kind == "light kit":
        lights.add_light_kit(renderer)


def find(name: str) -> shots.Shot:
    """The object of a name: a shot without what it stands on, unless that is asked for."""
    return shots.SHOTS["machine"] if name == STANDING else shots.SHOTS[name].alone()


def see(scene: vtkindirect.Scene) -> dict[str, Seen]:
    """Measure a scene, in the window that it has, in each way."""
    try:
        mask = object_mask(scene)
        pictures = {name: render(scene) for name, render in WAYS.items()}
        openness = find_openness(scene)
        return {name: measure(picture, mask, openness) for name, picture in pictures.items()}
    finally:
        vtkindirect.disable(scene)


def see_all(name: str, kinds: tuple[str, ...], width: int) -> dict[str, dict[str, Seen]]:
    """Measure an object in each way and light."""
    shot = find(name)
    found = {}
    for kind in kinds:
        size = (width, width * shots.SIZE[1] // shots.SIZE[0])
        scene = shot.load(shot.one_sun(), size=size)
        if kind != "one sun":
            set_lights(scene.renderer, kind)
        window = frames.open_window(scene, None)
        window.SetMultiSamples(0)
        try:
            found[kind] = see(scene)
        finally:
            window.Finalize()
    return found


def row(name: str, kind: str, ways: dict[str, Seen]) -> tuple[Any, ...]:
    """The cells of a row."""
    plain = ways["VTK"]
    first = f"{plain.brightness:.0f}, {plain.black:.2%}, {plain.pits:.2f}"
    return (name, kind, first, *(
        f"{way.brightness / plain.brightness:.2f}, {way.black:.2%}, {way.pits:.2f}"
        for key, way in ways.items() if key != "VTK"
    ))  # fmt: skip


def main() -> int:
    """Measure and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=640, help="width of a picture (default: 640)")
    parser.add_argument("--shot", action="append", choices=NAMES, help="default: all of them")
    parser.add_argument("--light", action="append", choices=LIGHTS, help="default: all of them")
    words = parser.parse_args()
    if words.size < 64:
        parser.error("--size must be 64 or more")
    rows = [
        row(name, kind, ways)
        for name in words.shot or NAMES
        for kind, ways in see_all(name, tuple(words.light or LIGHTS), words.size).items()
    ]
    height = words.size * shots.SIZE[1] // shots.SIZE[0]
    print(f"Readability, {words.size} x {height}: what can be seen of an object.")
    print("`scene`, `soft`, `full`, `gentle` and `studio` are the pass with that `lighting`. Mean")
    print("brightness, of plain VTK of 255, of others over plain VTK's; the share of pixels that")
    print(f"are nearly black, below {BLACK} of 255; and the mean of the {PITS} % of the pixels that")
    print("receive least of a uniform sky over that of all. These are the objects that the presets'")
    print("strengths were chosen on.\n")
    table(("object", "light", *WAYS), rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
