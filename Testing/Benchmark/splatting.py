#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Splatting beside its paper: time and error by threshold, by lights, and against the gather.

    Testing/Benchmark/splatting.py [PART...] [--scene NAME] [--size N] [--rounds N]
    Testing/Benchmark/splatting.py --figure 3|8|9 FILE.png [--scene NAME] [--size N]

Parts, all by default:

- threshold: 256 even lights with I_low of 1, 5 and 7 % (Dachsbacher and Stamminger 2006, colour plate
  3: 14, 54 and 74 frames a second), as the paper cuts off and with the far field.
- lights: 256, 768, 1020 and 4096 lights.
- gather: 768 lights at 5 and 10 % and 108 at 5 % (48, 83 and 254 frames a second) against the gather
  in a map's neighbourhood with 1020, 308 and 156 samples, summed at 64 x 64 pixels and interpolated
  (14, 44 and 82).
- ways: rectangles, ellipsoids and tiles.
- overdraw: splats a pixel, and pixels a light in an image of 512 x 512 (768 lights at 5 %: 125 and
  42,600), and what a light takes of memory traffic.

Times are processor time of a frame beyond that of one without virtual lights, medians of frames that
take turns. Only their ratios mean something; those of the paper stand beside them. Each has its error
to R1, the sum over all texels of the maps, as RMSE over the mean, and its bias. Figures: 3, the cut-off
values of the paper's colour plate; 8, the overdraw; 9, iso-surfaces and their ellipses, which is 10, too.
"""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import plot
import vtkindirect
from vtkindirect import frames, images, methods, settings
from vtkindirect.scene import Scene

SCENES = Path(__file__).resolve().parents[1] / "Scenes"
FULL = 512
"""Edge of the paper's images."""
TEXELS = 256
BITS_OF_SURFACE = 64
BITS_OF_LIGHT = 3 * 128
BITS_OF_BOUNDS = 2 * 128
BITS_OF_BLENDING = 2 * 128


ESTIMATORS = {
    "gather": vtkindirect.vtkRSMGatherPass,
    "splatting": vtkindirect.vtkIndirectSplattingPass,
}


@dataclass
class Way:
    """A choice to be measured, and what the paper says of it: frames a second."""

    name: str
    method: str
    settings: dict[str, Any]
    published: float | None = None
    paths: str = ""


def splats(lights: int, threshold: float, far: bool, **more: Any) -> dict[str, Any]:
    """Return the settings of splats."""
    return {"NumberOfLights": lights, "IntensityThreshold": threshold, "FarField": far, **more}


def ways_of(part: str, size: int) -> list[Way]:
    """Return what a part compares; ratios are to its first."""
    if part == "threshold":
        return [
            Way(f"{100 * f:g} %, {'far field' if far else 'cut off'}", "splatting",
                splats(256, f, far), published=None if far else fps)
            for far in (False, True)
            for f, fps in ((0.01, 14.0), (0.05, 54.0), (0.07, 74.0))
        ]  # fmt: skip
    if part == "lights":
        return [Way(f"{n} lights", "splatting", splats(n, 0.02, True))
                for n in (256, 768, 1020, 4096)]  # fmt: skip
    if part == "gather":
        step = max(2, min(32, size // 64))
        rows = [
            Way(f"gather, {n} samples", "gather",
                {"Mode": "neighborhood", "NumberOfSamples": n, "InterpolationStep": step},
                published=fps)
            for n, fps in ((1020, 14.0), (308, 44.0), (156, 82.0))
        ]  # fmt: skip
        for far in (False, True):
            kind = "far field" if far else "cut off"
            rows += [
                Way(f"splats, {n} lights, {100 * f:g} %, {kind}", "splatting", splats(n, f, far),
                    published=None if far else fps)
                for n, f, fps in ((768, 0.05, 48.0), (768, 0.1, 83.0), (108, 0.05, 254.0))
            ]  # fmt: skip
        return rows
    return [
        Way(name, "splatting", splats(768, 0.05, False, SplatShape=shape), paths=paths)
        for name, shape, paths in (
            ("tiles", "ellipsoids", "splats=tiles"),
            ("ellipsoids", "ellipsoids", "splats=blend"),
            ("rectangles", "screen_quads", "splats=blend"),
        )
    ]


class Bench:
    """A scene in a window, and R1 of it where it is asked for."""

    def __init__(self, name: str, size: int) -> None:
        self.scene: Scene = vtkindirect.load_scene(SCENES / f"{name}.json")
        frames.open_window(self.scene, (size, size))
        self.renderer = self.scene.renderer
        self.indirect = methods.enable(self.renderer, "gather", "uniform", Caching=False,
                                       Visibility="none", NumberOfBounces=1)  # fmt: skip
        self.truth = np.zeros(0)
        self.parts: dict[str, tuple[Any, Any]] = {}

    def sum_truth(self) -> None:
        """Sum over all texels of maps of TEXELS squared, once: it takes long."""
        if self.truth.size == 0:
            texels = self.indirect.GetReflectiveShadowMapResolution()
            self.indirect.SetReflectiveShadowMapResolution(TEXELS)
            self.use(Way("R1", "gather", {"Mode": "all_texels"}))
            self.scene.render_window.Render()
            self.truth = images.copy_buffer(self.renderer, "irradiance")
            self.indirect.SetReflectiveShadowMapResolution(texels)

    def use(self, way: Way) -> None:
        """Give the pass the estimator and the sampler of a way, which keep their resources."""
        os.environ["VTK_INDIRECT_PATHS"] = way.paths
        key = repr(way)
        if key not in self.parts:
            made = (ESTIMATORS[way.method](), vtkindirect.vtkUniformLightSampler())
            settings.apply([*made], way.settings)
            self.parts[key] = made
        estimator, sampler = self.parts[key]
        self.indirect.SetEstimator(estimator)
        self.indirect.SetSampler(sampler)

    def show(self, way: Way) -> float:
        """Render two frames; processor time of the second in milliseconds."""
        self.use(way)
        self.frame()
        return self.frame()

    def frame(self) -> float:
        begin = time.process_time()
        self.scene.render_window.Render()
        self.scene.render_window.WaitForCompletion()
        return 1000.0 * (time.process_time() - begin)

    def measure(self, ways: list[Way], rounds: int) -> list[dict[str, float]]:
        """Times beyond a frame without lights, and errors."""
        self.sum_truth()
        empty = Way("", "gather", {"NumberOfLights": 1, "InterpolationStep": 32})
        times: dict[str, list[float]] = {way.name: [] for way in (empty, *ways)}
        found: dict[str, dict[str, float]] = {}
        for turn in range(rounds):
            for way in (empty, *ways):
                times[way.name].append(self.show(way))
                if turn == 0 and way is not empty:
                    found[way.name] = self.judge(way)
        base = statistics.median(times[""])
        for way in ways:
            found[way.name]["ms"] = max(statistics.median(times[way.name]) - base, 0.01)
        return [found[way.name] for way in ways]

    def judge(self, way: Way) -> dict[str, float]:
        image = images.copy_buffer(self.renderer, "irradiance")
        mean = self.truth.mean()
        result = {
            "rmse": float(np.sqrt(((image - self.truth) ** 2).mean()) / mean),
            "bias": float(image.mean() / mean - 1.0),
        }
        if way.method == "splatting":
            counts = 256.0 * images.copy_buffer(self.renderer, "splat.overdraw")[..., 0]
            result["overdraw"] = float(counts.mean())
            result["largest"] = float(counts.max())
        return result


def print_part(bench: Bench, part: str, size: int, rounds: int) -> None:
    """Measure a part and print its table."""
    ways = ways_of(part, size)
    rows = bench.measure(ways, rounds)
    print(f"\n### {part}\n")
    print("| | ms | speed over the first | the paper's | RMSE to R1 | bias | splats a pixel |")
    print("|---|---|---|---|---|---|---|")
    for way, row in zip(ways, rows):
        published = (
            f"{way.published / ways[0].published:.1f}"
            if way.published and ways[0].published
            else ""
        )
        overdraw = f"{row['overdraw']:.1f}" if "overdraw" in row else ""
        print(f"| {way.name} | {row['ms']:.1f} | {rows[0]['ms'] / row['ms']:.2f} | {published} "
              f"| {100 * row['rmse']:.1f} % | {100 * row['bias']:+.1f} % | {overdraw} |")  # fmt: skip


def print_overdraw(bench: Bench, _size: int, rounds: int) -> None:
    """Print the table of overdraw and what a light takes to read."""
    lights = 768
    ways = ways_of("ways", FULL)
    rows = bench.measure(ways, rounds)
    print("\n### overdraw\n")
    print("| 768 lights at 5 % | splats a pixel | largest | pixels a light at 512 x 512 "
          "| bits a pixel and light |")  # fmt: skip
    print("|---|---|---|---|---|")
    print("| the paper | 125 | | 42600 | 72; its gather 112 |")
    for way, row in zip(ways, rows):
        a_light = FULL * FULL * row["overdraw"] / lights
        bits = (
            f"{BITS_OF_LIGHT} of the light, read by a tile's pixels alike, and "
            f"{BITS_OF_BOUNDS} once a tile"
            if way.name == "tiles"
            else f"{BITS_OF_SURFACE} of the surface, {BITS_OF_BLENDING} to blend"
        )
        print(f"| {way.name} | {row['overdraw']:.1f} | {row['largest']:.0f} | {a_light:.0f} "
              f"| {bits} |")  # fmt: skip
    print(f"\nThe gather at every pixel reads {BITS_OF_LIGHT} bits a light.")


def draw_thresholds(bench: Bench, path: Path) -> None:
    """Colour plate 3: the picture with three thresholds, cut off as in the paper, and whole."""
    pictures = []
    for f, far in ((0.01, False), (0.05, False), (0.07, False), (0.05, True)):
        bench.show(Way("", "splatting", splats(768, f, far)))
        pictures.append(images.copy_buffer(bench.renderer, "final")[..., :3])
    joined = np.concatenate(pictures, axis=1)[::-1]
    write_png(path, joined)


def draw_overdraw(bench: Bench, path: Path) -> None:
    """Figure 8: the number of splats at each pixel, white for 256: ellipsoids and tiles."""
    pictures = []
    for paths in ("splats=blend", "splats=tiles"):
        bench.show(Way("", "splatting", splats(768, 0.05, False), paths=paths))
        pictures.append(images.copy_buffer(bench.renderer, "splat.overdraw")[..., :3])
    write_png(path, np.concatenate(pictures, axis=1)[::-1])


def draw_bounds(path: Path) -> None:
    """Figures 9 and 10: iso-surfaces, and the ellipses about them, for exponents 1, 10 and 100."""
    pyplot = plot.require_plots()
    figure, axes = pyplot.subplots(1, 3, figsize=(9.0, 3.2), sharex=True, sharey=True)
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 2001)
    turn = np.linspace(0.0, 2.0 * np.pi, 400)
    for axis, n in zip(axes, (1, 10, 100)):
        radius = np.cos(angle) ** (0.5 * n)
        axis.plot(radius * np.cos(angle), radius * np.sin(angle), "k", label="iso-surface")
        center = (n / (n + 2)) ** (0.25 * (n + 2))
        height = center ** (n / (n + 2)) * np.sqrt(1.0 - center ** (4 / (n + 2)))
        axis.plot(center + max(center, 1.0 - center) * np.cos(turn), height * np.sin(turn),
                  "0.6", label="ellipse")  # fmt: skip
        axis.set_title(f"n = {n}")
        axis.set_aspect("equal")
        axis.grid(True, alpha=0.3)
    axes[0].legend(fontsize=8, loc="lower right")
    figure.tight_layout()
    figure.savefig(path, dpi=72)


def write_png(path: Path, image: np.ndarray) -> None:
    """Write an image, top row first, of values from 0 to 1."""
    pyplot = plot.require_plots()
    pyplot.imsave(path, np.clip(image, 0.0, 1.0))


PARTS: dict[str, Callable[[Bench, int, int], None]] = {
    "threshold": lambda bench, size, rounds: print_part(bench, "threshold", size, rounds),
    "lights": lambda bench, size, rounds: print_part(bench, "lights", size, rounds),
    "gather": lambda bench, size, rounds: print_part(bench, "gather", size, rounds),
    "ways": lambda bench, size, rounds: print_part(bench, "ways", size, rounds),
    "overdraw": print_overdraw,
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print, or draw a figure."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", default=[], metavar="PART")
    parser.add_argument("--figure", nargs=2, metavar=("NUMBER", "FILE"))
    parser.add_argument("--scene", default="cornell_box")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args(arguments)
    unknown = [part for part in given.parts if part not in PARTS]
    if unknown:
        parser.error(f"unknown part '{unknown[0]}'; known: {', '.join(PARTS)}")
    if given.figure:
        number, file = given.figure
        images.check_output(Path(file), (".png",))
        if number == "9":
            draw_bounds(Path(file))
            return 0
        draw = {"3": draw_thresholds, "8": draw_overdraw}.get(number)
        if draw is None:
            parser.error(f"unknown figure '{number}'; known: 3, 8, 9")
        draw(Bench(given.scene, given.size), Path(file))
        return 0
    bench = Bench(given.scene, given.size)
    print(f"{given.scene}, {given.size} x {given.size}")
    for part in given.parts or PARTS:
        PARTS[part](bench, given.size, given.rounds)
    return 0


if __name__ == "__main__":
    sys.exit(main())
