# SPDX-License-Identifier: BSD-3-Clause
"""Worth of the pass with nothing set: pictures of everyday scenes beside plain VTK's.

    PYTHONPATH=build/lib/python3.11/site-packages:build/pyvista
        python3 Testing/Benchmark/worth.py [--size WIDTH] [--scene NAME]... [--out DIRECTORY]

Prints a Markdown table of the scenes of everyday.py in plain VTK, with its UseSSAO and with
`vtkindirect.enable` alone. A cell is

* clipped: share of the object's pixels with a channel at 255 in which plain VTK has none,
* brightness: mean of the object's pixels over plain VTK's,
* specks: pixels of smooth faces whose ratio to plain VTK leaves the median of 5 x 5 by more than
  4 %, per 10,000; the ratio of smooth light has none, an edge of a shadow has a line of them,
* dots: the same that stand alone, at most four in 7 x 7 pixels, per 10,000, and away from edges of
  shadows, whose pixels they may be,
* creases: dots within four pixels of a crease, by more than 12 %, per 10,000; without antialiasing,
* bar: median error, in percent of the range, of values that are read off a colour map. The entry
  that makes the smallest angle with the pixel's colour is read, which is its chromaticity; the true
  one is that of the same picture without lighting,
* pits: as in readability.py.

Without lighting and antialiasing the object's pixels must be those of plain VTK, bit by bit; unlit
counts the others.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import vtkindirect
from multiresolution import table
from numpy.lib.stride_tricks import sliding_window_view
from vtkindirect import images

import everyday
import readability
import ssao

SPECK = 0.04
CREASE_DOT = 0.12
NEAR = 4
"""Pixels between a smooth face and the next crease or silhouette."""
ALONE = 4
"""At most so many specks in 7 x 7 pixels are dots."""
FOLD = 0.9
"""The cosine between normals of neighbours below which there is a crease."""
PLAIN, SSAO, DEFAULT = "VTK", "UseSSAO", "default"
WAYS = (PLAIN, SSAO, DEFAULT)


class Worth(NamedTuple):
    """Measures of a picture beside plain VTK's."""

    clipped: float
    brightness: float
    specks: float
    dots: float
    creases: float | None
    bar: float | None
    pits: float | None


class Surface(NamedTuple):
    """Where the pixels of an object are."""

    object: np.ndarray
    smooth: np.ndarray
    openness: np.ndarray | None
    entries: np.ndarray | None
    """Entry of the colour map at pixels, -1 where there is none."""
    shadowed: np.ndarray
    """Pixels near an edge of a shadow of the pass."""


def around(values: np.ndarray, size: int) -> np.ndarray:
    """Return the pixels of a square around each: height x width x size squared."""
    padded = np.pad(values, size // 2, mode="edge")
    return sliding_window_view(padded, (size, size)).reshape(*values.shape, size * size)


def grey(picture: np.ndarray) -> np.ndarray:
    """Return the mean of red, green and blue."""
    return picture.astype(float).mean(axis=-1)


def leaves_median(ratio: np.ndarray, by: float) -> np.ndarray:
    """Return where a ratio leaves its median in 5 x 5 pixels by more than a share of it."""
    median = np.median(around(ratio, 5), axis=-1)
    return np.abs(ratio - median) > by * np.maximum(median, 1e-6)


def alone(found: np.ndarray) -> np.ndarray:
    """Return the pixels with few others in 7 x 7."""
    return found & (around(found.astype(np.uint8), 7).sum(axis=-1) <= ALONE)


def find_smooth(mask: np.ndarray, normals: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """Return the object's pixels that no crease, step or silhouette is near."""
    broken = ~mask
    for axis in (0, 1):
        cosine = (normals * np.roll(normals, 1, axis)).sum(axis=-1)
        # On a plane depth's reciprocal is linear in pixels.
        inverse = 1.0 / np.maximum(depth, 1e-30)
        bend = np.abs(np.roll(inverse, 1, axis) + np.roll(inverse, -1, axis) - 2.0 * inverse)
        broken |= (cosine < FOLD) | (bend > 0.002 * inverse)
    return ~around(broken, 2 * NEAR + 1).any(axis=-1)


def read_bar(picture: np.ndarray, bar: np.ndarray) -> np.ndarray:
    """Return the entry of a colour map, n x 3, that a pixel's chromaticity is nearest to."""
    colors = picture.reshape(-1, 3).astype(np.float32)
    unit = colors / np.maximum(np.linalg.norm(colors, axis=-1, keepdims=True), 1.0)
    entries = bar.astype(np.float32)
    entries /= np.maximum(np.linalg.norm(entries, axis=-1, keepdims=True), 1.0)
    return (unit @ entries.T).argmax(axis=-1).reshape(picture.shape[:2])


def find_entries(unlit: np.ndarray, bar: np.ndarray) -> np.ndarray:
    """Return the entry whose colour an unlit pixel has, -1 where none has it."""
    colors = unlit.reshape(-1, 3).astype(np.float32)
    entries = bar.astype(np.float32)
    squared = (colors**2).sum(-1)[:, None] - 2.0 * colors @ entries.T + (entries**2).sum(-1)
    found = squared.argmin(axis=-1)
    off = np.abs(colors - entries[found]).max(axis=-1)
    return np.where(off <= 1.5, found, -1).reshape(unlit.shape[:2])


def measure(
    picture: np.ndarray,
    plain: np.ndarray,
    surface: Surface,
    bar: np.ndarray | None = None,
    stepped: np.ndarray | None = None,
) -> Worth:
    """Measure a picture beside plain VTK's; `stepped`: without antialiasing, for creases."""
    mask = surface.object
    full = (picture == 255).any(axis=-1) & ~(plain == 255).any(axis=-1)
    base = np.maximum(grey(plain), 1.0)
    off = surface.smooth & leaves_median(grey(picture) / base, SPECK)
    creases, error, pits = None, None, None
    if stepped is not None:
        rough = mask & ~surface.smooth
        near = rough & alone(mask & leaves_median(grey(stepped) / base, CREASE_DOT))
        creases = 1e4 * float(near.sum()) / max(int(rough.sum()), 1)
    if bar is not None and surface.entries is not None:
        known = mask & (surface.entries >= 0)
        steps = np.abs(read_bar(picture, bar) - surface.entries)[known]
        error = 100.0 * float(np.median(steps)) / (len(bar) - 1)
    if surface.openness is not None:
        pits = readability.measure(picture, mask, surface.openness).pits
    tens = 1e4 / max(int(surface.smooth.sum()), 1)
    return Worth(
        clipped=float(full[mask].mean()),
        brightness=float(grey(picture)[mask].mean() / grey(plain)[mask].mean()),
        specks=tens * float(off.sum()),
        dots=tens * float((alone(off) & ~surface.shadowed).sum()),
        creases=creases,
        bar=error,
        pits=pits,
    )


def render(drawing: everyday.Drawing) -> np.ndarray:
    """Return the window's picture, rendered anew."""
    drawing.render_window.Render()
    return images.window_bytes(drawing.render_window)


@contextmanager
def unlit(drawing: everyday.Drawing) -> Iterator[None]:
    """Switch the lighting of a drawing's actors off for a while."""
    found = drawing.renderer.GetActors()
    properties = [
        found.GetItemAsObject(i).GetProperty() for i in range(found.GetNumberOfItems())
    ]
    before = [one.GetLighting() for one in properties]
    try:
        for one in properties:
            one.LightingOff()
        yield
    finally:
        for one, value in zip(properties, before):
            one.SetLighting(value)


class Seen(NamedTuple):
    """A scene's pictures and what was measured of them."""

    pictures: dict[str, np.ndarray]
    worth: dict[str, Worth]
    unlit_changed: int | None
    """Pixels inside surfaces that the pass changes although they are unlit."""


def see(drawing: everyday.Drawing, whole: bool = True) -> Seen:
    """Render and measure a scene; `whole`: with UseSSAO, dots at creases and pits, too."""
    renderer = drawing.renderer
    stepped: dict[str, np.ndarray] = {}
    openness, entries, changed = None, None, None
    try:
        mask = readability.object_mask(drawing)
        pictures = {PLAIN: render(drawing)}
        if whole:
            with ssao.used(renderer):
                pictures[SSAO] = render(drawing)
            stepped.update(pictures)
        vtkindirect.enable(renderer)
        pictures[DEFAULT] = render(drawing)
        normals = images.copy_buffer(renderer, "normal")[..., :3]
        depth = images.copy_buffer(renderer, "depth")[..., 0]
        direct = grey(images.copy_buffer(renderer, "direct")[..., :3])
        edges = leaves_median(direct / np.maximum(grey(pictures[PLAIN]), 1.0), SPECK)
        shadowed = around(edges, 5).any(axis=-1)
        vtkindirect.enable(renderer, antialiasing=False)
        if whole:
            stepped[DEFAULT] = render(drawing)
        if drawing.bar is not None:
            with unlit(drawing):
                flat = render(drawing)
                vtkindirect.disable(renderer)
                plain = render(drawing)
            entries = find_entries(plain, drawing.bar)
            changed = int((flat != plain).any(axis=-1)[mask].sum())
        if whole:
            openness = readability.find_openness(drawing)
        smooth = find_smooth(mask, normals, depth)
        surface = Surface(mask, smooth, openness, entries, shadowed)
        worth = {
            name: measure(picture, pictures[PLAIN], surface, drawing.bar, stepped.get(name))
            for name, picture in pictures.items()
        }
        return Seen(pictures, worth, changed)
    finally:
        vtkindirect.disable(renderer)


def see_scene(name: str, width: int, whole: bool = True) -> Seen:
    """Draw a scene of a name and measure it."""
    drawing = everyday.SCENES[name](width)
    try:
        return see(drawing, whole)
    finally:
        drawing.close()


def cells(values: Iterable[float | None], digits: int) -> str:
    """Numbers with so many digits; nothing where there are none."""
    return ", ".join(f"{value:.{digits}f}" for value in values if value is not None)


def row(name: str, seen: Seen) -> tuple[Any, ...]:
    """The cells of a row."""
    ways = [seen.worth[way] for way in WAYS]
    others = ways[1:]
    return (
        name,
        cells((100 * way.clipped for way in others), 1),
        cells((way.brightness for way in others), 2),
        cells((way.specks for way in others), 0),
        cells((way.dots for way in others), 1),
        cells((way.creases for way in others), 1),
        cells((way.bar for way in ways), 1),
        "" if seen.unlit_changed is None else seen.unlit_changed,
        cells((way.pits for way in ways), 2),
    )


HEAD = (
    "scene", "clipped, %", "brightness", "specks", "dots", "creases", "bar, %", "unlit", "pits",
)  # fmt: skip


def write(directory: Path, name: str, pictures: dict[str, np.ndarray]) -> None:
    """Write pictures of a scene as PNG files, and all of them side by side."""
    directory.mkdir(parents=True, exist_ok=True)
    stem = name.replace(" ", "_")
    for way, picture in pictures.items():
        images.write_png(directory / f"{stem}_{way}.png", picture)
    images.write_png(directory / f"{stem}.png", np.hstack(list(pictures.values())))


def main() -> int:
    """Measure and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=512, help="edge of a picture (default: 512)")
    names = tuple(everyday.SCENES)
    parser.add_argument("--scene", action="append", choices=names, help="default: all of them")
    parser.add_argument("--out", type=Path, metavar="DIRECTORY", help="write pictures there")
    words = parser.parse_args()
    if words.size < 64:
        parser.error("--size must be 64 or more")
    rows = []
    for name in words.scene or names:
        seen = see_scene(name, words.size)
        rows.append(row(name, seen))
        print("   ".join(str(cell) for cell in rows[-1]), file=sys.stderr, flush=True)
        if words.out is not None:
            write(words.out, name, seen.pictures)
    print(f"Pictures with nothing set, {words.size} x {words.size}: UseSSAO, then the default; of bar")
    print("and pits plain VTK before them.\n")
    table(HEAD, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
