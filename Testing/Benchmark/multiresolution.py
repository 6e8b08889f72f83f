# SPDX-License-Identifier: BSD-3-Clause
"""Multiresolution splatting against the gather at every pixel, SSAO, and what its paper reports.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/multiresolution.py
        [--part NAME]... [--rounds N] [--size N]

Prints Markdown tables. In each part frames alternate between what is compared, in one run on one
window, so that other load falls on all alike: only ratios are printed as results, and times beside
them tell how long it took here. Nothing is reused between frames; times are medians over rounds.

- speed: at SIZE x SIZE with 256 lights, indirect stages of the gather at every pixel over those of
  multiresolution splatting, its RMSE to that gather, and what VTK's SSAO (32 samples, blurred)
  adds to a plain frame. "Sums alone" compares the stages `estimate` and `upsample`, without those
  that both have: making lights, and the composite; "their share" is that of these two.
- pixels: growth of subsplats, of evaluation (time with 1024 lights less time with one) and of all
  indirect stages for four times the pixels, SIZE / 2 to SIZE.
- lights: a whole frame from 100 to 3600 lights.
- paper: Table 1 and Figures 6, 7 and 8 of Nichols and Wyman 2009 on scenes with about as many triangles. Their
  resolution of indirect light is `FinestLevel` in a window of SIZE x SIZE: 1024, 512, 256 and 128 in a picture of
  1024 x 1024 are full, half, quarter and eighth resolution.
- flicker: change of the error from frame to frame along a path of the camera and of the light, over
  that of the gather with the same lights.
"""

from __future__ import annotations

import argparse
import math
import statistics
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
)

import vtkindirect
from vtkindirect import frames, images, load_scene, methods, references, windows

import orbit
import ssao as yardstick

SCENES = Path(__file__).resolve().parent.parent / "Scenes"
LIGHTS = 256
STEPS = {8: "Eighth", 4: "Quarter", 2: "Half", 1: "Full"}
"""Edges of the finest subsplats in pixels, and the words for them in the setter of FinestLevel."""
PUBLISHED = {
    (4, 28): {8: 68, 4: 50, 2: 33, 1: 22},
    (16, 88): {8: 60, 4: 42, 2: 30, 1: 24},
    (25, 89): {8: 59, 4: 42, 2: 28, 1: 21},
    (36, 76): {8: 52, 4: 41, 2: 31, 1: 25},
}
"""Table 1 of the paper, frames a second on a GeForce GTX 280, by STEPS in a picture of 1024 x 1024; and
balls and their resolution for a room about as large as its scene: 6.3K, 250K, 405K, 417K triangles."""

Apply = Callable[[], None]
Times = dict[str, dict[str, float]]


class Bench:
    """A renderer in a window, its pass, and the two estimators with one sampler.

    The lights are even ones, as in the paper, with one bounce and nothing that hides them. Edges are
    not antialiased: that work is the picture's and the same for all methods.
    """

    def __init__(self, renderer: vtkRenderer, window: Any) -> None:
        self.renderer = renderer
        self.window = window
        self.indirect = methods.enable(
            renderer, "gather", Caching=False, Visibility="none", NumberOfBounces=1,
            Antialiasing=False,
        )  # fmt: skip
        self.sampler = vtkindirect.vtkUniformLightSampler()
        self.indirect.SetSampler(self.sampler)
        self.gather = vtkindirect.vtkRSMGatherPass()
        self.gather.InterpolationOff()
        self.splatting = vtkindirect.vtkMultiresolutionSplattingPass()
        self.set_lights(LIGHTS)

    def set_lights(self, number: int) -> None:
        self.sampler.SetNumberOfLights(number)

    def use(self, estimator: Any) -> Apply:
        """Return what puts an estimator into the pass."""
        return lambda: self.indirect.SetEstimator(estimator)

    def irradiance(self) -> np.ndarray:
        return images.copy_buffer(self.renderer, "irradiance")

    def frame(self) -> dict[str, float]:
        """Render; milliseconds of the frame, its indirect stages, and levels and pixels alone."""
        self.indirect.SetTiming(False)  # forgets
        self.indirect.SetTiming(True)
        self.window.WaitForCompletion()
        begin = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        wall = 1000.0 * (time.perf_counter() - begin)
        report = methods.report(self.indirect)
        stages = report["stages"]
        evaluate = sum(stages.get(name, {"median_ms": 0.0})["median_ms"]
                       for name in ("estimate", "upsample"))  # fmt: skip
        return {"frame": wall, "indirect": report["indirect_ms"], "evaluate": evaluate}

    def alternate(self, ways: dict[str, Apply], rounds: int) -> Times:
        """Median times of each way; the first frame of each, which builds shaders, is left out.

        A second frame is rendered before one that counts, because a change of size or estimator
        allocates.
        """
        found: dict[str, list[dict[str, float]]] = {name: [] for name in ways}
        for turn in range(rounds + 1):
            for name, apply in ways.items():
                apply()
                self.window.Render()
                times = self.frame()
                if turn > 0:
                    found[name].append(times)
        return {
            name: {key: statistics.median(t[key] for t in times) for key in times[0]}
            for name, times in found.items()
        }


def open_scene(name: str, size: int) -> Bench:
    scene = load_scene(SCENES / f"{name}.json")
    window = frames.open_window(scene, (size, size))
    bench = Bench(scene.renderer, window)
    bench.scene = scene
    return bench


def rmse(image: np.ndarray, expected: np.ndarray) -> float:
    """Root mean square difference over the mean of where there is light, in per cent."""
    return 100.0 * float(np.sqrt(((image - expected) ** 2).mean()) / expected.mean())


def ssao(bench: Bench, rounds: int) -> float:
    """Milliseconds that VTK's SSAO adds to a plain frame, in blocks of frames that alternate."""
    renderer, window = bench.renderer, bench.window
    kept = renderer.GetPass()
    renderer.SetPass(None)
    yardstick.set_up(renderer)
    times: dict[bool, list[float]] = {False: [], True: []}
    for _ in range(rounds):
        for on in (False, True):
            renderer.SetUseSSAO(on)
            window.Render()  # shaders are built anew
            for _ in range(2):
                window.WaitForCompletion()
                begin = time.perf_counter()
                window.Render()
                window.WaitForCompletion()
                times[on].append(1000.0 * (time.perf_counter() - begin))
    renderer.UseSSAOOff()
    renderer.SetPass(kept)
    return statistics.median(times[True]) - statistics.median(times[False])


def table(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> None:
    names = list(head)
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print(flush=True)


def part_speed(rounds: int, size: int) -> None:
    rows = []
    for name in ("apartment_living", "frog"):
        bench = open_scene(name, size)
        half = vtkindirect.vtkMultiresolutionSplattingPass()
        half.SetFinestLevelToHalfResolution()
        ways = {
            "gather at every pixel": bench.use(bench.gather),
            "multiresolution": bench.use(bench.splatting),
            "half resolution": bench.use(half),
        }
        times = bench.alternate(ways, rounds)
        found, counts = {}, {}
        for way, apply in ways.items():
            apply()
            bench.window.Render()
            found[way] = bench.irradiance()
            if way != "gather at every pixel":
                counts[way] = f"{100 * count_subsplats(bench) / size**2:.1f} %"
        added = ssao(bench, rounds)
        first = times["gather at every pixel"]
        base = first["indirect"]
        for way, t in times.items():
            rows.append((name, way, f"{t['indirect']:.0f}", f"{base / t['indirect']:.1f}",
                         f"{first['evaluate'] / t['evaluate']:.1f}",
                         f"{100 * t['evaluate'] / t['indirect']:.0f} %", counts.get(way, ""),
                         f"{rmse(found[way], found['gather at every pixel']):.2f} %",
                         f"{t['indirect'] / added:.2f}"))  # fmt: skip
        rows.append((name, "SSAO adds", f"{added:.0f}", f"{base / added:.1f}", "", "", "", "", "1"))
        bench.window.Finalize()
    print(f"Speed at {size} x {size}, {LIGHTS} lights\n")
    table(("scene", "method", "indirect, ms", "times as fast as the gather", "sums alone",
           "their share", "subsplats, of the pixels",
           "RMSE over the mean to it", "over SSAO's"), rows)  # fmt: skip


def count_subsplats(bench: Bench) -> float:
    """Subsplats of the last frame: a subsplat of level n covers 4 ** n pixels."""
    level = images.copy_buffer(bench.renderer, "subsplat.level")[..., 0]
    lit = np.linalg.norm(images.copy_buffer(bench.renderer, "normal"), axis=-1) > 0.5
    return float((0.25 ** level[lit]).sum())


def part_pixels(rounds: int, size: int) -> None:
    rows = []
    for name in ("apartment_living", "frog"):
        bench = open_scene(name, size)
        bench.use(bench.splatting)()

        def choose(edge: int, number: int, bench: Bench = bench) -> Apply:
            def apply() -> None:
                bench.window.SetSize(edge, edge)
                bench.set_lights(number)

            return apply

        # More lights for the sums: with the usual number they are a few milliseconds of a small
        # picture, and differences of times come out as noise. One light shows the rest alone.
        ways = {
            f"{e} {n}": choose(e, n) for e in (size // 2, size) for n in (1, LIGHTS, 4 * LIGHTS)
        }
        few_small, small, many_small, few_large, large, many_large = bench.alternate(
            ways, rounds
        ).values()
        sums = [many["evaluate"] - few["evaluate"]
                for many, few in ((many_small, few_small), (many_large, few_large))]  # fmt: skip
        counts = []
        for edge in (size // 2, size):
            choose(edge, LIGHTS)()
            bench.window.Render()
            counts.append(count_subsplats(bench))
        rows.append((name, f"{counts[1] / counts[0]:.2f}", f"{sums[1] / sums[0]:.2f}",
                     f"{large['evaluate'] / small['evaluate']:.2f}",
                     f"{large['indirect'] / small['indirect']:.2f}"))  # fmt: skip
        bench.window.Finalize()
    print(f"Growth for four times the pixels, {size // 2} to {size}, {LIGHTS} lights\n")
    table(("scene", "subsplats", "evaluation of the lights", "levels and pixels",
           "all indirect stages"), rows)  # fmt: skip


def part_lights(rounds: int, size: int) -> None:
    bench = open_scene("apartment_living", size)
    bench.use(bench.splatting)()
    numbers = (100, 400, 900, 1600, 2500, 3600)
    times = bench.alternate(
        {str(n): lambda n=n: bench.set_lights(n) for n in numbers}, rounds
    )
    first = times["100"]
    print(f"Growth with the number of lights, apartment_living, {size} x {size}\n")
    table(
        ("lights", "over 100", "frame", "indirect stages"),
        (
            (n, f"{int(n) / 100:g}", f"{t['frame'] / first['frame']:.2f}",
             f"{t['indirect'] / first['indirect']:.2f}")
            for n, t in times.items()
        ),
    )  # fmt: skip
    bench.window.Finalize()


def add(renderer: vtkRenderer, source: Any, color: tuple[float, float, float]) -> int:
    """Add an actor; returns its number of triangles."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    source.Update()
    polygons = source.GetOutput().GetPolys()
    return polygons.GetNumberOfConnectivityIds() - 2 * polygons.GetNumberOfCells()


def procedural(balls: int, resolution: int) -> tuple[vtkRenderer, int]:
    """A room of three planes with balls in rows, lit by a spot; and its number of triangles."""
    renderer = vtkRenderer()
    triangles = 0
    for point1, point2, color in (
        ((0, 0, 1), (1, 0, 0), (0.75, 0.75, 0.7)),
        ((1, 0, 0), (0, 1, 0), (0.3, 0.4, 0.8)),
        ((0, 1, 0), (0, 0, 1), (0.8, 0.3, 0.2)),
    ):
        plane = vtkPlaneSource()
        plane.SetOrigin(0, 0, 0)
        plane.SetPoint1(point1)
        plane.SetPoint2(point2)
        triangles += add(renderer, plane, color)
    across = math.ceil(math.sqrt(balls))
    for index in range(balls):
        ball = vtkSphereSource()
        ball.SetRadius(0.35 / across)
        ball.SetCenter(
            (index % across + 0.7) / (across + 0.4),
            0.36 / across,
            (index // across + 0.7) / (across + 0.4),
        )
        ball.SetThetaResolution(resolution)
        ball.SetPhiResolution(resolution)
        triangles += add(renderer, ball, (0.8, 0.8, 0.8))
    spot = vtkLight()
    spot.SetLightTypeToSceneLight()
    spot.PositionalOn()
    spot.SetPosition(0.8, 1.2, 0.8)
    spot.SetFocalPoint(0.3, 0.1, 0.3)
    spot.SetConeAngle(35)
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(spot)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.2, 1.5, 2.2)
    camera.SetFocalPoint(0.45, 0.3, 0.45)
    camera.SetViewAngle(28)
    return renderer, triangles


def open_room(balls: int, resolution: int, size: int) -> tuple[Bench, int]:
    renderer, triangles = procedural(balls, resolution)
    window = windows.render_window((size, size), offscreen=True)
    windows.start(window)
    window.AddRenderer(renderer)
    return Bench(renderer, window), triangles


def finest(splatting: Any, step: int) -> None:
    """Make the finest subsplats squares of `step` pixels along an edge."""
    getattr(splatting, f"SetFinestLevelTo{STEPS[step]}Resolution")()


def part_paper(rounds: int, size: int) -> None:
    table_1(rounds, size)
    figure_6(rounds, size)
    figure_7(rounds, size)
    figure_8(rounds, size)


def table_1(rounds: int, size: int) -> None:
    """Frames a second by the finest subsplats' size, in rooms with few triangles and with many."""
    rows = []
    for (balls, resolution), paper in PUBLISHED.items():
        bench, triangles = open_room(balls, resolution, size)
        bench.use(bench.splatting)()
        bench.splatting.SetPresetToPaper()
        ways = {str(step): lambda step=step, s=bench.splatting: finest(s, step) for step in STEPS}
        times = bench.alternate(ways, rounds)
        coarsest = times[str(max(STEPS))]
        for step in STEPS:
            ways[str(step)]()
            bench.window.Render()
            t = times[str(step)]
            rows.append((triangles, size // step, f"{count_subsplats(bench):.0f}",
                         f"{coarsest['frame'] / t['frame']:.2f}", f"{paper[step] / paper[8]:.2f}",
                         f"{t['indirect'] / coarsest['indirect']:.2f}",
                         f"{100 * t['indirect'] / t['frame']:.0f} %"))  # fmt: skip
        bench.window.Finalize()
    print(f"Table 1: frames a second over those of the first row of the same scene, {size} x {size}\n")
    table(("triangles", "resolution of indirect light", "subsplats", "here", "paper",
           "indirect stages over the first row's", "their share of the frame"), rows)  # fmt: skip


def figure_8(rounds: int, size: int) -> None:
    """Frames a second by the number of lights and the finest subsplats' size."""
    bench, triangles = open_room(25, 89, size)
    bench.use(bench.splatting)()
    bench.splatting.SetPresetToPaper()
    numbers = (100, 400, 900, 1600, 2500, 3600)

    def choose(step: int, number: int) -> Apply:
        def apply() -> None:
            finest(bench.splatting, step)
            bench.set_lights(number)

        return apply

    ways = {f"{step} {n}": choose(step, n) for step in STEPS for n in numbers}
    times = bench.alternate(ways, max(1, rounds // 2))
    first = times["8 100"]["frame"]
    print(f"Figure 8: frames a second over those of {size // 8} x {size // 8} with 100 lights, "
          f"{triangles} triangles, {size} x {size}")  # fmt: skip
    print("(the paper prints this as a plot without numbers)\n")
    table(
        ("resolution of indirect light", *map(str, numbers)),
        (
            (size // step, *(f"{first / times[f'{step} {n}']['frame']:.3f}" for n in numbers))
            for step in STEPS
        ),
    )
    bench.window.Finalize()


def figure_6(rounds: int, size: int) -> None:
    """An object with Phong's model, subsplats refined for each light: a Buddha there, a frog here."""
    bench = open_scene("frog", size)
    materials = [actor.GetProperty() for actor in bench.renderer.GetActors()]
    usual = [(m.GetSpecular(), m.GetSpecularPower()) for m in materials]

    def choose(estimator: Any, specular: float) -> Apply:
        def apply() -> None:
            bench.use(estimator)()
            for material, (old, power) in zip(materials, usual):
                material.SetSpecular(specular or old)
                material.SetSpecularPower(25.0 if specular else power)

        return apply

    ways = {
        "diffuse": choose(bench.splatting, 0.0),
        "Phong, lists of subsplats": choose(bench.splatting, 0.5),
        "Phong, every light at every pixel": choose(bench.gather, 0.5),
    }
    times = bench.alternate(ways, rounds)
    found = {}
    for name, apply in ways.items():
        apply()
        bench.window.Render()
        found[name] = images.copy_buffer(bench.renderer, "glossy") if name != "diffuse" else None
    expected = found["Phong, every light at every pixel"]
    rows = []
    for name, t in times.items():
        error = found[name]
        if error is not None:
            error = math.sqrt(float(((error - expected) ** 2).mean())) / float(expected.mean())
        rows.append((name, f"{times['diffuse']['frame'] / t['frame']:.2f}",
                     f"{t['indirect'] / times['diffuse']['indirect']:.1f}",
                     "" if error is None else f"{100 * error:.1f} %"))  # fmt: skip
    print("Figure 6: specular coefficient 0.5, power 25. The paper: 23 frames a second, and by its "
          "Figure 7 a\nBuddha without specular light 8 to 32.\n")  # fmt: skip
    table(("material", "frames a second over the first", "indirect stages", "RMSE of the glossy "
           "light over its mean"), rows)  # fmt: skip
    bench.window.Finalize()


def figure_7(rounds: int, size: int) -> None:
    """A rough object with thresholds of the normal of 0.25 and 1.4: a Buddha there, a frog here."""
    bench = open_scene("frog", size)
    splatting = bench.splatting

    def choose(preset: str, threshold: float, detail: float) -> Apply:
        def apply() -> None:
            bench.use(splatting)()
            getattr(splatting, f"SetPresetTo{preset}")()
            splatting.SetNormalThreshold(threshold)
            splatting.SetSurfaceDetail(detail)

        return apply

    kinds = (("Paper", "the paper's test"), ("Robust", "from the plane"))
    steps = ((0.25, 0.0), (1.4, 0.0), (1.4, 0.5))
    ways = {f"{k} {n} {d}": choose(k, n, d) for k, _ in kinds for n, d in steps}
    times = bench.alternate(ways, rounds)
    bench.use(bench.gather)()
    bench.window.Render()
    expected = bench.irradiance()
    rows = []
    for kind, words in kinds:
        for threshold, detail in steps:
            way = f"{kind} {threshold} {detail}"
            ways[way]()
            bench.window.Render()
            first = times[f"{kind} 0.25 0.0"]
            t = times[way]
            rows.append((words, threshold, detail, f"{count_subsplats(bench):.0f}",
                         f"{first['frame'] / t['frame']:.2f}",
                         f"{(8 if threshold == 0.25 else 32) / 8:.0f}",
                         f"{first['indirect'] / t['indirect']:.2f}",
                         f"{100 * t['evaluate'] / t['indirect']:.0f} %",
                         f"{100 * t['evaluate'] / t['frame']:.0f} %",
                         f"{rmse(bench.irradiance(), expected):.1f} %"))  # fmt: skip
    bench.window.Finalize()
    print(f"Figure 7: frames a second over those of a threshold of 0.25, frog, {size} x {size}\n")
    table(("refinement", "threshold of the normal", "surface detail", "subsplats", "here", "paper",
           "indirect stages", "estimate and upsample, of the indirect stages", "of the frame",
           "RMSE over the mean to the gather"), rows)  # fmt: skip


def path(bench: Bench, moves: str, count: int = 8, step: float = 0.5) -> Iterable[None]:
    """Render frames while the camera, or every light, turns half a degree a frame."""
    camera = bench.renderer.GetActiveCamera()
    before = vtkCamera()
    before.DeepCopy(camera)
    lights = [bench.renderer.GetLights().GetItemAsObject(i)
              for i in range(bench.renderer.GetLights().GetNumberOfItems())]  # fmt: skip
    places = [(np.array(l.GetPosition()), np.array(l.GetFocalPoint())) for l in lights]
    center = np.array(camera.GetFocalPoint())
    up = np.array(camera.GetViewUp())
    try:
        for index in range(count):
            angle = step * (index - 0.5 * (count - 1))
            if moves == "camera":
                camera.DeepCopy(before)
                camera.Azimuth(angle)
                camera.OrthogonalizeViewUp()
            else:
                for light, ends in zip(lights, places):
                    light.SetPosition(turned(ends[0], center, up, angle))
                    light.SetFocalPoint(turned(ends[1], center, up, angle))
            bench.window.Render()
            yield
    finally:
        camera.DeepCopy(before)
        for light, (position, focal) in zip(lights, places):
            light.SetPosition(position)
            light.SetFocalPoint(focal)


def turned(
    point: np.ndarray, center: np.ndarray, axis: np.ndarray, degrees: float
) -> np.ndarray:
    """A point turned about an axis through a centre (Rodrigues)."""
    k = axis / np.linalg.norm(axis)
    v = point - center
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return center + c * v + s * np.cross(k, v) + (1.0 - c) * np.dot(k, v) * k


def part_flicker(rounds: int, size: int) -> None:
    del rounds  # nothing is timed
    edge = max(64, size // 4)
    rows = []
    for name in ("apartment_living", "frog", "room_fire", "two_rooms"):
        bench = open_scene(name, edge)
        for moves in ("camera", "lights"):
            bench.use(bench.gather)()
            bench.gather.SetModeToAllTexels()
            bench.indirect.SetReflectiveShadowMapResolution(128)
            truth, masks = [], []
            for _ in path(bench, moves):
                truth.append(bench.irradiance())
                masks.append(references.mask(bench.scene))
            bench.gather.SetModeToVirtualLights()
            bench.indirect.SetReflectiveShadowMapResolution(512)
            found = {}
            for way, estimator in (("gather", bench.gather), ("splatting", bench.splatting)):
                bench.use(estimator)()
                shown = [bench.irradiance() for _ in path(bench, moves)]
                found[way] = orbit.error_flicker(shown, truth, masks)
            rows.append((name, moves, f"{found['gather']:.4f}", f"{found['splatting']:.4f}",
                         f"{found['splatting'] / found['gather']:.2f}"))  # fmt: skip
        bench.window.Finalize()
    print(f"Flicker of the error over the mean, {edge} x {edge}, {LIGHTS} lights\n")
    table(("scene", "what turns", "gather", "multiresolution", "over the gather's"), rows)


PARTS = {
    "speed": part_speed,
    "pixels": part_pixels,
    "lights": part_lights,
    "paper": part_paper,
    "flicker": part_flicker,
}


def main() -> int:
    """Run the parts that are named, or all; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--part", action="append", choices=PARTS, help="default: all")
    parser.add_argument("--rounds", type=int, default=7, help="frames a median is of (default: 7)")
    parser.add_argument("--size", type=int, default=1024, help="edge of the window (default: 1024)")
    words = parser.parse_args()
    if words.rounds < 1 or words.size < 128:
        parser.error("--rounds must be 1 or more, --size 128 or more")
    for name in words.part or PARTS:
        PARTS[name](words.rounds, words.size)
    return 0


if __name__ == "__main__":
    sys.exit(main())
