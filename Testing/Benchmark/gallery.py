# SPDX-License-Identifier: BSD-3-Clause
"""Makes the rows of Documentation/gallery.md: plain VTK, its UseSSAO and the pass side by side.

    gallery.py [NAME...] [-o DIRECTORY]

Each picture is 400 x 300. Plain VTK has the multisampling that it has by default; UseSSAO and the
pass draw into textures without it.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import images
from vtkmodules.vtkRenderingCore import vtkTextActor

import caustics
import shots
import ssao

RING = "ring"
"""The caustic of a metal ring, which is no shot: see caustics.py."""
NAMES = (RING, "molecule", "terrain", "machine", "brain", "apartment")
DIRECTORY = Path(__file__).resolve().parents[2] / "Documentation" / "gallery"
MULTISAMPLES = 8
"""Samples that a vtkRenderWindow asks for by default."""
GAP = 4


def caption(scene: vtkindirect.Scene, text: str) -> None:
    """Write what a picture shows into its lower left corner."""
    actor = vtkTextActor()
    actor.SetInput(text)
    look = actor.GetTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(15)
    look.SetColor(1.0, 1.0, 1.0)
    look.SetBackgroundColor(0.0, 0.0, 0.0)
    look.SetBackgroundOpacity(0.6)
    actor.SetPosition(8, 8)
    scene.renderer.AddViewProp(actor)


def picture(scene: vtkindirect.Scene, text: str, multisamples: int = 0) -> np.ndarray:
    """Render a scene as it is now, in a window of its own."""
    window = scene.make_window()
    window.SetMultiSamples(multisamples)
    caption(scene, text)
    window.Render()  # at the rate of a still picture, which is a window's own
    found = images.window_bytes(window)
    window.Finalize()
    return found


def plain(shot: shots.Shot) -> np.ndarray:
    """Plain VTK."""
    return picture(shot.load(), "VTK", MULTISAMPLES)


def occluded(shot: shots.Shot) -> np.ndarray:
    """Plain VTK with screen-space ambient occlusion."""
    scene = shot.load()
    with ssao.used(scene.renderer):
        return picture(scene, "VTK, UseSSAO")


def lit(shot: shots.Shot) -> np.ndarray:
    """The pass."""
    scene = shot.load()
    vtkindirect.enable(scene, lighting=shot.lighting)
    return picture(scene, f"vtk-indirect, lighting {shot.lighting}")


WAYS: tuple[Callable[[shots.Shot], np.ndarray], ...] = (plain, occluded, lit)


def row(shot: shots.Shot) -> np.ndarray:
    """All ways side by side."""
    found = [way(shot) for way in WAYS]
    gap = np.full((found[0].shape[0], GAP, 3), 255, dtype=np.uint8)
    return np.hstack([part for one in found for part in (gap, one)][1:])


def main() -> int:
    """Render the rows that the command line names; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(NAMES))
    parser.add_argument("-o", "--output", type=Path, default=DIRECTORY, metavar="DIRECTORY")
    words = parser.parse_args()
    for name in words.names:
        if name != RING and name not in shots.SHOTS:
            known = ", ".join((RING, *shots.SHOTS))
            parser.error(f"there is no shot '{name}'; known: {known}")
    words.output.mkdir(parents=True, exist_ok=True)
    for name in words.names or NAMES:
        path = words.output / f"row_{name}.png"
        images.write_png(path, caustics.picture() if name == RING else row(shots.SHOTS[name]))
        print(path, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
