# SPDX-License-Identifier: BSD-3-Clause
"""How much of an object can be seen: pixels that are nearly black, and how bright it is.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/readability.py
        [--size WIDTH] [--shot NAME]...

Prints Markdown tables of objects on a white background, under a single sun and under VTK's light
kit: plain VTK, with its UseSSAO, and the pass with the lights as they are (scene) and with its
presets. Only pixels of the object count, those that do not change with the background. A pixel is
nearly black when the mean of its red, green and blue is below 12 of 255; brightness is the mean of
these over the object, over plain VTK's.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import vtkindirect
from multiresolution import table
from vtkindirect import frames, images

import shots
import ssao

NAMES = ("molecule", "isosurfaces", "machine", "terrain", "brain")
BLACK = 12
"""A pixel is nearly black below this, of 255."""
PRESETS = ("scene", "soft", "full")


class Seen(NamedTuple):
    """What there is to see of an object in a picture."""

    black: float
    """Share of its pixels that are nearly black."""
    brightness: float
    """Mean of its pixels, 0 to 255."""


def measure(picture: np.ndarray, mask: np.ndarray) -> Seen:
    """Measure a picture of bytes, height x width x 3, where `mask` is."""
    values = picture[mask].astype(float).mean(axis=-1)
    return Seen(float((values < BLACK).mean()), float(values.mean()))


def object_mask(scene: vtkindirect.Scene) -> np.ndarray:
    """Pixels of the object: those that are the same on black and on white."""
    renderer, window = scene.renderer, scene.render_window
    pictures = []
    before = renderer.GetBackground()
    for level in (0.0, 1.0):
        renderer.SetBackground(level, level, level)
        window.Render()
        pictures.append(images.window_bytes(window))
    renderer.SetBackground(before)
    return (pictures[0] == pictures[1]).all(axis=-1)


def _plain(scene: vtkindirect.Scene) -> np.ndarray:
    scene.render_window.Render()
    return images.window_bytes(scene.render_window)


def _with_ssao(scene: vtkindirect.Scene) -> np.ndarray:
    with ssao.used(scene.renderer):
        return _plain(scene)


def _with_pass(lighting: str) -> Callable[[vtkindirect.Scene], np.ndarray]:
    def render(scene: vtkindirect.Scene) -> np.ndarray:
        with shots.lights_kept(scene.renderer):
            try:
                shots.enable(scene, lighting)
                return _plain(scene)
            finally:
                vtkindirect.disable(scene)

    return render


WAYS = {"VTK": _plain, "UseSSAO": _with_ssao, **{name: _with_pass(name) for name in PRESETS}}


def see(shot: shots.Shot, lights: tuple[Any, ...], width: int) -> dict[str, Seen | None]:
    """Measure a shot in each way; None: that way is not in this version."""
    height = width * shots.SIZE[1] // shots.SIZE[0]
    scene = shot.load(lights, size=(width, height))
    window = frames.open_window(scene, None)
    try:
        mask = object_mask(scene)
        found: dict[str, Seen | None] = {}
        for name, render in WAYS.items():
            try:
                found[name] = measure(render(scene), mask)
            except shots.Skipped:
                found[name] = None
        return found
    finally:
        window.Finalize()


def rows(found: dict[tuple[str, str], dict[str, Seen | None]]) -> tuple[list[Any], list[Any]]:
    """The cells of both tables: shares of nearly black pixels, brightness over plain VTK's."""
    black, bright = [], []
    for name, ways in found.items():
        plain = ways["VTK"]
        assert plain is not None
        black.append(
            (*name, *("skipped" if way is None else f"{way.black:.1%}" for way in ways.values()))
        )
        # Plain VTK's own is in levels, and what the others are compared with.
        others = [
            "skipped" if way is None else f"{way.brightness / plain.brightness:.2f}"
            for key, way in ways.items() if key != "VTK"
        ]  # fmt: skip
        bright.append((*name, f"{plain.brightness:.0f}", *others))
    return black, bright


def main() -> int:
    """Measure and print the tables; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=640, help="width of a picture (default: 640)")
    parser.add_argument("--shot", action="append", choices=NAMES, help="default: all of them")
    words = parser.parse_args()
    if words.size < 64:
        parser.error("--size must be 64 or more")
    found = {}
    for name in words.shot or NAMES:
        shot = shots.SHOTS[name].alone()
        for light, lights in (("one sun", shot.one_sun()), ("light kit", (shots.LIGHT_KIT,))):
            found[name, light] = see(shot, lights, words.size)
    black, bright = rows(found)
    height = words.size * shots.SIZE[1] // shots.SIZE[0]
    print(f"Readability, {words.size} x {height}: what can be seen of an object on white.")
    print("`scene`, `soft` and `full` are the pass with that `lighting`.\n")
    if not shots.HAS_LIGHTING:
        print(f"Skipped: `soft` and `full`, because {shots.NO_LIGHTING}.\n")
    print(f"Share of the object's pixels that are nearly black, below {BLACK} of 255:\n")
    table(("object", "light", *WAYS), black)
    print("\nBrightness of the object: plain VTK's mean of 255, the others' over it:\n")
    table(("object", "light", *WAYS), bright)
    return 0


if __name__ == "__main__":
    sys.exit(main())
