# SPDX-License-Identifier: BSD-3-Clause
"""Makes the rows of Documentation/gallery.md: plain VTK, its UseSSAO and the pass side by side.

    gallery.py [NAME...] [-o DIRECTORY] [--size WIDTH HEIGHT]

Each picture is 1600 x 1000, and that of the pass names the words of `vtkindirect.enable` that made it.
Plain VTK has the multisampling that it has by default; UseSSAO and the pass draw into textures without.
Prints a line of a table for each row: seconds until the picture is there, in a window of its own.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import vtkindirect
from vtkindirect import demo, images

import caustics
import shots
import ssao

RING = "ring"
"""The caustic of a metal ring, which is no shot: see caustics.py."""
NAMES = (
    "molecule", "terrain", "fire", "brain", "machine", "streamlines", "particles", "apartment", RING
)  # fmt: skip
SIZE = (1600, 1000)
DIRECTORY = Path(__file__).resolve().parents[2] / "Documentation" / "gallery"
GAP = 4


class Picture(NamedTuple):
    """A picture of bytes, height x width x 3, and the seconds that it took."""

    values: np.ndarray
    seconds: float


def picture(scene: vtkindirect.Scene, text: str, multisamples: int = 0) -> Picture:
    """Render a scene as it is now, in a window of its own."""
    window = scene.make_window()
    window.SetMultiSamples(multisamples)
    scene.renderer.AddViewProp(demo.caption(scene, text))
    begin = time.perf_counter()
    window.Render()  # at the rate of a still picture, which is a window's own
    window.WaitForCompletion()
    seconds = time.perf_counter() - begin
    found = Picture(images.window_bytes(window), seconds)
    window.Finalize()
    return found


def plain(shot: shots.Shot, size: tuple[int, int]) -> Picture:
    """Plain VTK."""
    return picture(shot.load(size=size), "VTK", demo.MULTISAMPLES)


def occluded(shot: shots.Shot, size: tuple[int, int]) -> Picture:
    """Plain VTK with screen-space ambient occlusion."""
    scene = shot.load(size=size)
    with ssao.used(scene.renderer):
        return picture(scene, "VTK, UseSSAO")


def lit(shot: shots.Shot, size: tuple[int, int]) -> Picture:
    """The pass, with the shot's words."""
    scene = shot.load(size=size)
    vtkindirect.enable(scene, **shot.words)
    words = ", ".join(f"{name}={value!r}" for name, value in shot.words.items())
    return picture(scene, f"vtk-indirect, {words}".rstrip(", "))


WAYS: tuple[Callable[[shots.Shot, tuple[int, int]], Picture], ...] = (plain, occluded, lit)


def row(shot: shots.Shot, size: tuple[int, int] = SIZE) -> tuple[np.ndarray, list[float]]:
    """All ways side by side, and their seconds. A ground takes the place of the shot's own."""
    shot = shot.alone() if shot.words.get("ground") else shot
    found = [way(shot, size) for way in WAYS]
    gap = np.full((found[0].values.shape[0], GAP, 3), 255, dtype=np.uint8)
    parts = [part for one in found for part in (gap, one.values)][1:]
    return np.hstack(parts), [one.seconds for one in found]


def main() -> int:
    """Render the rows that the command line names; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(NAMES))
    parser.add_argument("-o", "--output", type=Path, default=DIRECTORY, metavar="DIRECTORY")
    parser.add_argument(
        "--size", nargs=2, type=int, default=SIZE, metavar=("WIDTH", "HEIGHT"), help="of a picture"
    )
    words = parser.parse_args()
    for name in words.names:
        if name != RING and name not in shots.SHOTS:
            known = ", ".join((RING, *shots.SHOTS))
            parser.error(f"there is no shot '{name}'; known: {known}")
    words.output.mkdir(parents=True, exist_ok=True)
    for name in words.names or NAMES:
        if name == RING:
            images.write_png(words.output / f"row_{name}.png", caustics.picture())
            continue
        shot = shots.SHOTS[name]
        values, seconds = row(shot, tuple(words.size))
        images.write_bytes(words.output / f"row_{name}.jpg", values)
        cells = [shot.title, *(f"{value:.2f}" for value in seconds)]
        print(f"| {' | '.join(cells)} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
