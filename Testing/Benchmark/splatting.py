#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Splatting beside its paper: time and error by threshold, by lights, and against the gather.

    Testing/Benchmark/splatting.py [PART...] [--scene NAME] [--size N] [--rounds N]
    Testing/Benchmark/splatting.py --figure 3|5|7|8|9|10 FILE.png [--scene NAME] [--size N]

Parts, all by default:

- threshold: 256 even lights with I_low of 1, 5 and 7 % (Dachsbacher and Stamminger 2006, colour plate
  3: 14, 54 and 74 frames a second), as the paper cuts off and with the far field.
- lights: 256, 768, 1020 and 4096 lights.
- gather: 768 lights at 5 and 10 % and 108 at 5 % (48, 83 and 254 frames a second) against the gather
  in a map's neighbourhood with 1020, 308 and 156 samples, summed at 64 x 64 pixels and interpolated
  (14, 44 and 82).
- equal: figure 12 at equal time and at equal error: from 27 to 3072 lights at 5 %, by interpolation.
- ways: ellipsoids and tiles.
- overdraw: splats a pixel, and pixels a light in an image of 512 x 512 (768 lights at 5 %: 125 and
  42,600), and what a light takes of memory traffic.
- ring: table 1, 4096 lights of three levels of method B on the ring (10.4, 10.8, 9.3 and 6.9 ms where
  light and camera move, the light, the camera, or nothing).
- occlusion: table 3, 256 even lights as they are and times their ambient occlusion, with the same
  I_low, in the image's size and in half of it (27, 37, 63 and 85 frames a second).
- lobes: the ring's lobes with bounds and without, and without lobes.
- bits: what lights in the paper's formats, and in two texels of four floats, change of the sums.

Times are processor time of a frame beyond that of one without virtual lights, medians of frames that
take turns; those of the ring are whole frames'. Only their ratios mean
something; those of the paper stand beside them. Each has its error to R1, the sum over all texels of the
maps, as RMSE over the mean, and its bias. Figures: splatting_figures.py.
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

import splatting_figures
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
    sampler: str = "vtkUniformLightSampler"


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
        Way(name, "splatting", splats(768, 0.05, False), paths=paths)
        for name, paths in (("tiles", "compute=on"), ("ellipsoids", "compute=off"))
    ]


class Bench:
    """A scene in a window, and R1 of it where it is asked for."""

    def __init__(self, name: str, size: int, caching: bool = False) -> None:
        self.name = name
        self.scene: Scene = vtkindirect.load_scene(SCENES / f"{name}.json")
        frames.open_window(self.scene, (size, size))
        self.renderer = self.scene.renderer
        self.indirect = methods.enable(self.renderer, "gather", "uniform", Caching=caching,
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
            made = (ESTIMATORS[way.method](), getattr(vtkindirect, way.sampler)())
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


LADDER = (27, 54, 108, 256, 768, 1536, 3072)


def at(value: float, xs: Sequence[float], ys: Sequence[float]) -> str:
    """Return the y at which x has a value, by lines through logarithms, or which side of them it is."""
    order = np.argsort(xs)
    x, y = np.log(np.asarray(xs))[order], np.log(np.asarray(ys))[order]
    wanted = np.log(value)
    end = -1 if wanted > x[-1] else 0
    side = "" if x[0] <= wanted <= x[-1] else ("above " if (y[end] > y[-1 - end]) else "below ")
    found = float(np.exp(np.interp(wanted, x, y)))
    return f"{side}{found:.0f}" if found > 9.99 else f"{side}{found:.2f}"


def print_equal(bench: Bench, size: int, rounds: int) -> None:
    """Print figure 12 at equal time and at equal error."""
    gathers = [way for way in ways_of("gather", size) if way.method == "gather"]
    kinds = {
        "cut off": [Way(f"c{n}", "splatting", splats(n, 0.05, False)) for n in LADDER],
        "far field": [Way(f"f{n}", "splatting", splats(n, 0.05, True)) for n in LADDER],
    }
    rows = bench.measure([*gathers, *kinds["cut off"], *kinds["far field"]], rounds)
    print("\n### equal\n")
    print("| | ms | RMSE to R1 | splats | lights at equal time | their RMSE | "
          "lights at equal error | their time over the gather's |")  # fmt: skip
    print("|---|---|---|---|---|---|---|---|")
    for i, gather in enumerate(gathers):
        row = rows[i]
        for place, kind in enumerate(kinds):
            begin = len(gathers) + place * len(LADDER)
            own = rows[begin : begin + len(LADDER)]
            times, errors = [r["ms"] for r in own], [r["rmse"] for r in own]
            share = at(row["rmse"], errors, [t / row["ms"] for t in times])
            print(f"| {gather.name} | {row['ms']:.1f} | {100 * row['rmse']:.1f} % | {kind} "
                  f"| {at(row['ms'], times, LADDER)} "
                  f"| {at(row['ms'], times, [100 * e for e in errors])} % "
                  f"| {at(row['rmse'], errors, LADDER)} | {share} |")  # fmt: skip


def print_ring(_bench: Bench, size: int, rounds: int) -> None:
    """Print table 1: the ring with what moves from frame to frame."""
    bench = Bench("ring_caustic", size, caching=True)
    way = Way("ring", "splatting", splats(4096, 0.05, True), sampler="vtkImportanceLightSampler")
    bench.use(way)
    sampler = bench.parts[repr(way)][1]
    sampler.SetWarpingToTogether()
    sampler.SetLevels(3)
    camera = bench.renderer.GetActiveCamera()
    light = bench.renderer.GetLights().GetItemAsObject(0)
    place = light.GetPosition()
    cases = (
        ("dynamic light and camera", True, True, 10.4),
        ("dynamic light, static camera", True, False, 10.8),
        ("static light, dynamic camera", False, True, 9.3),
        ("static scene", False, False, 6.9),
    )
    times: list[list[float]] = [[] for _ in cases]
    bench.frame()
    for turn in range(rounds):
        for case, (_name, lit, moved, _published) in enumerate(cases):
            for step in range(2):
                if lit:
                    light.SetPosition(place[0], place[1], place[2] + 0.01 * (turn + 0.5 * step))
                if moved:
                    camera.Azimuth(1.0)
                spent = bench.frame()
            times[case].append(spent)
    medians = [statistics.median(t) for t in times]
    print(f"\n### ring, {size} x {size}\n")
    print("| 4096 lights | ms | of the first | the paper's |")
    print("|---|---|---|---|")
    for case, (name, _lit, _moved, published) in enumerate(cases):
        print(f"| {name} | {medians[case]:.0f} | {medians[case] / medians[0]:.2f} "
              f"| {published / cases[0][3]:.2f} |")  # fmt: skip
    bench.scene.render_window.Finalize()


def mean_intensity(bench: Bench) -> float:
    """Return the mean of what the last frame's lights send, of their brightest colours."""
    sent = images.copy_buffer(bench.renderer, "lights")[:, 2, :3].max(axis=1)
    return float(sent[sent > 0.0].mean())


def print_occlusion(bench: Bench, size: int, rounds: int) -> None:
    """Print table 3: lights as they are and times ambient occlusion, with the same I_low."""
    print("\n### occlusion\n")
    print("| indirect light at | lights | ms | speed over the first | the paper's | splats a pixel |")
    print("|---|---|---|---|---|---|")
    published = {size: (27.0, 37.0), size // 2: (63.0, 85.0)}
    first = 0.0
    for edge in (size, size // 2):
        own = Bench(bench.name, edge)
        plain = Way("plain", "splatting", splats(256, 0.05, False))
        own.show(plain)
        mean = mean_intensity(own)
        own.show(Way("", "splatting", splats(256, 0.05, False, AmbientOcclusion=True)))
        threshold = min(0.05 * mean / max(mean_intensity(own), 1e-30), 1.0)
        occluded = splats(256, threshold, False, AmbientOcclusion=True)
        empty = Way("", "gather", {"NumberOfLights": 1, "InterpolationStep": 32})
        ways = [plain, Way("times ambient occlusion", "splatting", occluded), empty]
        times: list[list[float]] = [[], [], []]
        counts = [0.0, 0.0]
        for _ in range(rounds):
            for i, way in enumerate(ways):
                times[i].append(own.show(way))
                if way is not empty:
                    counts[i] = 256.0 * float(
                        images.copy_buffer(own.renderer, "splat.overdraw")[..., 0].mean()
                    )
        for i, way in enumerate(ways[:2]):
            spent = max(statistics.median(times[i]) - statistics.median(times[2]), 0.01)
            first = first or spent
            print(f"| {edge} x {edge} | {way.name} | {spent:.1f} | {first / spent:.2f} "
                  f"| {published[edge][i] / 27.0:.2f} | {counts[i]:.1f} |")  # fmt: skip
        own.scene.render_window.Finalize()


def print_lobes(_bench: Bench, size: int, rounds: int) -> None:
    """Print what bounds of lobes are worth on the ring, against all of them counting everywhere."""
    bench = Bench("ring_caustic", size)
    ways = [
        Way("all count everywhere", "splatting", splats(4096, 0.0, False)),
        Way("2 %, far field", "splatting", splats(4096, 0.02, True)),
        Way("2 %, cut off", "splatting", splats(4096, 0.02, False)),
        Way("5 %, far field", "splatting", splats(4096, 0.05, True)),
        Way("2 %, far field, no lobes", "splatting",
            splats(4096, 0.02, True, SpecularTransport=False)),
    ]  # fmt: skip
    for way in ways:
        way.sampler = "vtkLightTreeSampler"
    times: list[list[float]] = [[] for _ in ways]
    found = []
    for turn in range(rounds):
        for i, way in enumerate(ways):
            times[i].append(bench.show(way))
            if turn == 0:
                counts = 256.0 * images.copy_buffer(bench.renderer, "splat.overdraw")[..., 0]
                found.append((images.copy_buffer(bench.renderer, "irradiance"), counts.mean()))
    truth = found[0][0]
    print(f"\n### lobes, ring_caustic, {size} x {size}, 4096 lights of the tree\n")
    print("| | ms | RMSE to the first | bias | splats a pixel |")
    print("|---|---|---|---|---|")
    for i, way in enumerate(ways):
        image, counts = found[i]
        rmse = np.sqrt(((image - truth) ** 2).mean()) / truth.mean()
        print(f"| {way.name} | {statistics.median(times[i]):.0f} | {100 * rmse:.1f} % "
              f"| {100 * (image.mean() / truth.mean() - 1.0):+.1f} % | {counts:.0f} |")  # fmt: skip
    bench.scene.render_window.Finalize()


def packed(lights: np.ndarray, paper: bool) -> np.ndarray:
    """Return rows of lights as formats hold them: the paper's 48 + 24 + 24 bits, or 256 bits."""
    result = lights.astype(np.float64)
    normal, density = result[:, 1, :3], result[:, 2, :3]
    if paper:
        result[:, 0, :3] = result[:, 0, :3].astype(np.float16)
        normal = np.round(normal * 127.0) / 127.0
        unit = max(float(density.max()), 1e-30)
        density = np.round(density / unit * 255.0) / 255.0 * unit
    else:
        # An octahedron's two coordinates of 16 bits; three mantissas of 9 bits with one exponent.
        flat = normal / np.abs(normal).sum(axis=1, keepdims=True)
        over = np.where(flat[:, 2:] < 0.0,
                        (1.0 - np.abs(flat[:, 1::-1])) * np.where(flat[:, :2] < 0.0, -1.0, 1.0),
                        flat[:, :2])  # fmt: skip
        over = np.round(over * 32767.0) / 32767.0
        height = 1.0 - np.abs(over).sum(axis=1, keepdims=True)
        fold = np.maximum(-height, 0.0)
        normal = np.concatenate([over - np.where(over < 0.0, -fold, fold), height], axis=1)
        step = 2.0 ** (np.ceil(np.log2(np.maximum(density.max(axis=1, keepdims=True), 1e-30))) - 9)
        density = np.round(density / step) * step
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    result[:, 1, :3] = normal / np.maximum(length, 1e-30)
    result[:, 2, :3] = density
    return result


def gathered(lights: np.ndarray, receivers: np.ndarray) -> np.ndarray:
    """Return the irradiance at receivers, rows as of lights, in double precision."""
    lights, receivers = lights.astype(np.float64), receivers.astype(np.float64)
    to_sender = lights[None, :, 0, :3] - receivers[:, None, 0, :3]
    squared = (to_sender**2).sum(axis=2)
    sender = np.maximum(-(to_sender * lights[None, :, 1, :3]).sum(axis=2), 0.0)
    receiver = np.maximum((to_sender * receivers[:, None, 1, :3]).sum(axis=2), 0.0)
    weight = sender * receiver / np.maximum(squared * (np.pi * squared + lights[None, :, 0, 3]), 1e-30)
    return weight @ lights[:, 2, :3]


def print_bits(bench: Bench, _size: int, _rounds: int) -> None:
    """Print what formats of fewer bits change of the irradiance at places on the surfaces."""
    tables = []
    for count in (768, 1500):
        way = Way("", "gather", {"NumberOfLights": count, "InterpolationStep": 32})
        bench.show(way)
        tables.append(images.copy_buffer(bench.renderer, "lights"))
    lights, receivers = tables
    exact = gathered(lights, receivers)
    print("\n### bits\n")
    print("| a light | bits | RMSE to 32-bit floats, of the mean |")
    print("|---|---|---|")
    print(f"| three texels of four floats, as it is | {BITS_OF_LIGHT} | 0 |")
    for name, bits, paper in (
        ("two texels: octahedral normal of 32, colour of 9 + 9 + 9 and an exponent of 5", 256, False),
        ("the paper's: place 48, direction 24, flux 24 (its gather reads 16 more)", 96, True),
    ):
        error = np.sqrt(((gathered(packed(lights, paper), receivers) - exact) ** 2).mean())
        print(f"| {name} | {bits} | {100 * error / exact.mean():.3f} % |")


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


PARTS: dict[str, Callable[[Bench, int, int], None]] = {
    "threshold": lambda bench, size, rounds: print_part(bench, "threshold", size, rounds),
    "lights": lambda bench, size, rounds: print_part(bench, "lights", size, rounds),
    "gather": lambda bench, size, rounds: print_part(bench, "gather", size, rounds),
    "equal": print_equal,
    "ways": lambda bench, size, rounds: print_part(bench, "ways", size, rounds),
    "overdraw": print_overdraw,
    "ring": print_ring,
    "occlusion": print_occlusion,
    "lobes": print_lobes,
    "bits": print_bits,
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
        if number not in splatting_figures.FIGURES:
            parser.error(
                f"unknown figure '{number}'; known: {', '.join(splatting_figures.FIGURES)}"
            )
        scene = SCENES / f"{given.scene}.json"
        splatting_figures.FIGURES[number](scene, given.size, Path(file))
        return 0
    bench = Bench(given.scene, given.size)
    print(f"{given.scene}, {given.size} x {given.size}")
    for part in given.parts or PARTS:
        PARTS[part](bench, given.size, given.rounds)
    return 0


if __name__ == "__main__":
    sys.exit(main())
