#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Area lights by their number: time of a moving frame beside VTK's own ambient occlusion, and error.

    Testing/Benchmark/area_sweep.py [--size WxH] [--rounds N] [--lamps N ...] [--receivers N]

Prints the page Documentation/speed-vs-error/area.md. Lamps of edge 0.16 lie under the ceiling of
area_cornell: of one radiance, images of 256 x 256, or videos of 512 x 512; with shadows and without.
Errors are those of the buffer `area` of a moving frame, against A1 at some of its pixels, computed
here in double precision: sums over points of each lamp, with the two blocks as what is in the way.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import area
import ssao
from vtkindirect import area_lights, frames, images, methods, wrapped

KINDS = {"c": "one radiance", "t": "image 256 x 256", "v": "video 512 x 512"}
LAMPS = (1, 2, 4, 8, 16)
ROUNDS = 5
RECEIVERS = 1500
POINTS = 32
"""Along an edge of a lamp, of the reference."""
FILLING_FRAMES = 8
EDGE, DISTANCE, HEIGHT = 0.16, 0.21, 0.995
RADIANCE = 8.0
# Each number of lamps is spread over the ceiling.
PLACES = ((1, 1), (2, 2), (1, 2), (2, 1), (0, 0), (3, 3), (0, 3), (3, 0),
          (0, 1), (3, 2), (1, 3), (2, 0), (0, 2), (3, 1), (1, 0), (2, 3))  # fmt: skip


def corner(number: int) -> np.ndarray:
    """Return a lamp's corner of least coordinates."""
    x, z = PLACES[number]
    return np.array((0.1 + DISTANCE * x, HEIGHT, 0.1 + DISTANCE * z))


def make_lamp(kind: str, number: int) -> Any:
    """Make a lamp that shines downwards."""
    lamp = wrapped.get(area_lights.CLASS)()
    origin = corner(number)
    lamp.SetOrigin(*origin)
    lamp.SetPoint1(*(origin + (EDGE, 0.0, 0.0)))
    lamp.SetPoint2(*(origin + (0.0, 0.0, EDGE)))
    lamp.SetRadiance(RADIANCE, RADIANCE, RADIANCE)
    if kind in area.TEXELS:
        lamp.SetImage(area.picture(area.TEXELS[kind], 0.0))
    return lamp


HEAD = """\
area_cornell with lamps under its ceiling, {width} x {height}, {gl}; medians of {rounds} moving frames of
each, in turn within a kind of lamps. Plain VTK's frame takes {plain} ms, UseSSAO adds {occlusion} (by kinds; other
programs ran beside).

Adds: the time that the pass adds to plain VTK's frame, bounces with their shadows included, over the time that UseSSAO
adds, by wall clock; processor: the same by the time of all processors. Direct alone: the stage that sums the buffer
`area`, in frames of their own, which wait for OpenGL after each stage.

Errors: RMS and mean of the buffer `area` of a moving frame over the mean of A1 at {receivers} pixels: sums over {points} x
{points} points of each lamp in double precision, hidden by the blocks. Moving frames look depth maps of 16 points of each
lamp up. `Testing/Benchmark/area_sweep.py` prints this page; see [area lights](../methods/area-lights.md).
"""


@dataclass
class Receivers:
    """Places that the eye sees, the pixels that they are at, and their normals."""

    pixels: tuple[np.ndarray, np.ndarray]
    places: np.ndarray
    normals: np.ndarray


def find_receivers(measured: area.Measured, count: int) -> Receivers:
    """Return some of a frame's pixels with a surface, the same ones for the same frame."""
    depth = images.copy_buffer(measured.scene.renderer, "depth")[..., 0].astype(float)
    normal = images.copy_buffer(measured.scene.renderer, "normal").astype(float)
    rows, columns = np.nonzero((depth > 0.0) & (np.abs(normal).sum(axis=2) > 0.5))
    chosen = np.random.default_rng(7).choice(len(rows), min(count, len(rows)), replace=False)
    rows, columns = rows[chosen], columns[chosen]
    camera = measured.scene.renderer.GetActiveCamera()
    height, width = depth.shape
    eye, forward = np.array(camera.GetPosition()), np.array(camera.GetDirectionOfProjection())
    right = np.cross(forward, camera.GetViewUp())
    right /= np.linalg.norm(right)
    tangent = math.tan(math.radians(camera.GetViewAngle()) / 2.0)
    x = ((columns + 0.5) / width * 2.0 - 1.0) * tangent * width / height
    y = ((rows + 0.5) / height * 2.0 - 1.0) * tangent
    rays = forward + x[:, None] * right + y[:, None] * np.cross(right, forward)
    found = normal[rows, columns]
    return Receivers(
        (rows, columns),
        eye + depth[rows, columns][:, None] * rays,
        found / np.linalg.norm(found, axis=1, keepdims=True),
    )


def blocks() -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the scene's blocks: bounds, and the matrix from the world to their own coordinates."""
    actors = json.loads(area.SCENE.read_text(encoding="utf-8"))["actors"]
    return [
        (np.array(actor["bounds"]).reshape(3, 2),
         np.linalg.inv(np.array(actor["transform"]).reshape(4, 4)))
        for actor in actors if actor["source"] == "box"
    ]  # fmt: skip


def are_hidden(places: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return for segments, n x 3 to n x m x 3, whether a block is in the way."""
    hidden = np.zeros(points.shape[:2], dtype=bool)
    for bounds, matrix in blocks():
        begin = places @ matrix[:3, :3].T + matrix[:3, 3]
        way = points @ matrix[:3, :3].T + matrix[:3, 3] - begin[:, None]
        way = np.where(np.abs(way) < 1e-12, 1e-12, way)
        first = (bounds[:, 0] - begin)[:, None] / way
        second = (bounds[:, 1] - begin)[:, None] / way
        enter = np.minimum(first, second).max(axis=2)
        leave = np.maximum(first, second).min(axis=2)
        hidden |= (leave > np.maximum(enter, 0.0) + 1e-9) & (enter < 1.0) & (leave > 0.0)
    return hidden


def lamp_points(number: int) -> tuple[np.ndarray, np.ndarray]:
    """Return points of a lamp, one in each of POINTS x POINTS squares, and their shares of edges."""
    random = np.random.default_rng(number)
    index = np.stack(np.meshgrid(np.arange(POINTS), np.arange(POINTS)), axis=-1).reshape(-1, 2)
    shares = (index + random.random(index.shape)) / POINTS
    points = np.repeat(corner(number)[None], len(shares), axis=0)
    points[:, 0] += EDGE * shares[:, 0]
    points[:, 2] += EDGE * shares[:, 1]
    return points, shares


class Reference:
    """A1 at receivers, lamp by lamp."""

    def __init__(self, receivers: Receivers, lamps: int) -> None:
        self.weights: list[np.ndarray] = []
        self.visible: list[np.ndarray] = []
        self.shares: list[np.ndarray] = []
        off_surface = receivers.places + 1e-5 * receivers.normals
        for number in range(lamps):
            points, shares = lamp_points(number)
            way = points[None] - receivers.places[:, None]
            square = (way * way).sum(axis=2)
            cosines = np.maximum((way * receivers.normals[:, None]).sum(axis=2), 0.0)
            # The lamp looks down.
            sent = np.maximum(way[..., 1], 0.0)
            weight = cosines * sent / (math.pi * square * square) * EDGE * EDGE / len(points)
            self.weights.append(weight)
            self.visible.append(~are_hidden(off_surface, np.repeat(points[None], len(way), axis=0)))
            self.shares.append(shares)

    def sum(self, lamps: Sequence[Any], shadows: bool) -> np.ndarray:
        """Return the irradiance of the first lamps, receivers x 3."""
        total = np.zeros((len(self.weights[0]), 3))
        for number, lamp in enumerate(lamps):
            image = lamp.GetImage()
            radiance = np.full((len(self.shares[number]), 3), RADIANCE)
            if image is not None:
                edge = image.GetDimensions()[0]
                values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(edge, edge, 3)
                at = np.minimum((self.shares[number] * edge).astype(int), edge - 1)
                radiance = RADIANCE * values[at[:, 1], at[:, 0]] / 255.0
            weight = self.weights[number] * (self.visible[number] if shadows else 1.0)
            total += weight @ radiance
        return total


class Lit(area.Measured):
    """A number of lamps of a kind."""

    def __init__(self, size: tuple[int, int], kind: str, count: int, shadows: bool) -> None:
        super().__init__(size, kind * count + ("" if shadows else "-"), make_lamp)
        self.kind, self.count, self.shadows = kind, count, shadows

    def fill(self) -> None:
        """Render until maps are there, of lamps that stay where they are after a few frames."""
        for _ in range(FILLING_FRAMES):
            self.render()

    def lamps(self) -> list[Any]:
        """Return the lamps, in their order."""
        return [self.indirect.GetAreaLight(i) for i in range(self.count)]

    def judge(self, before: Any, receivers: int, known: dict[str, Any]) -> tuple[float, float]:
        """Return RMS and mean error of a moving frame over the mean of A1; the camera as `before`."""
        camera = self.scene.renderer.GetActiveCamera()
        camera.DeepCopy(before)
        camera.Modified()
        self.window.Render()
        if "reference" not in known:
            known["receivers"] = find_receivers(self, receivers)
            known["reference"] = Reference(known["receivers"], known["most"])
        found = images.copy_buffer(self.scene.renderer, "area")[known["receivers"].pixels]
        expected = known["reference"].sum(self.lamps(), self.shadows)
        apart = found.astype(float) - expected
        mean = expected.mean()
        return float(np.sqrt((apart * apart).mean()) / mean), float(apart.mean() / mean)


def measure(
    kind: str, size: tuple[int, int], counts: Sequence[int], rounds: int, known: dict[str, Any]
) -> list[str]:
    """Return the rows of a kind of lamp, a frame of each of them in turn."""
    plain, occluded = area.Measured(size, None), area.Measured(size, None)
    ssao.set_up(occluded.scene.renderer)
    occluded.scene.renderer.UseSSAOOn()
    lit = [Lit(size, kind, count, shadows) for shadows in (True, False) for count in counts]
    everything = [plain, occluded, *lit]
    cameras = [one.scene.renderer.GetActiveCamera() for one in everything]
    before = cameras[0].NewInstance()
    before.DeepCopy(cameras[0])
    for one in everything:
        one.fill()
        one.processor.clear()
    for _ in range(rounds):
        for one in everything:
            one.times.append(one.render())
    wall = [statistics.median(one.times) for one in everything]
    work = [statistics.median(one.processor) for one in everything]
    known["plain"][kind], known["ssao"][kind] = wall[0], wall[1] - wall[0]
    rows = []
    for number, one in enumerate(lit, start=2):
        rms, bias = one.judge(before, known["count"], known)
        stage = one.stages(3)["area"]
        known["gl"] = methods.report(one.indirect)["gl"]["renderer"]
        rows.append(
            f"| {KINDS[kind]} | {one.count} | {'yes' if one.shadows else 'no'} "
            f"| {wall[number]:.0f} | {(wall[number] - wall[0]) / (wall[1] - wall[0]):.2f} "
            f"| {(work[number] - work[0]) / (work[1] - work[0]):.2f} "
            f"| {stage / (wall[1] - wall[0]):.2f} | {rms:.4f} | {bias:+.4f} |"
        )
    for one in everything:
        one.window.Finalize()
    return rows


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("--size", default="x".join(map(str, area.SIZE)))
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--lamps", type=int, nargs="+", default=LAMPS)
    parser.add_argument("--receivers", type=int, default=RECEIVERS)
    options = parser.parse_args(arguments)
    width, height = map(int, options.size.split("x"))
    known: dict[str, Any] = {"most": max(options.lamps), "count": options.receivers}
    known |= {"plain": {}, "ssao": {}}
    rows: list[str] = []
    for kind in KINDS:
        rows += measure(kind, (width, height), options.lamps, options.rounds, known)
    print("# Speed against error: area lights by their number\n")
    plain = ", ".join(f"{known['plain'][kind]:.0f}" for kind in KINDS)
    occlusion = ", ".join(f"{known['ssao'][kind]:.0f}" for kind in KINDS)
    print(HEAD.format(
        width=width, height=height, gl=known["gl"], rounds=options.rounds, plain=plain,
        occlusion=occlusion, points=POINTS, receivers=options.receivers,
    ))  # fmt: skip
    print(
        "| lamps of | number | shadows | frame ms | adds, over SSAO | processor | direct alone, over "
        "SSAO | nRMSE A1 | bias A1 |"
    )
    print("|---|---:|---|---:|---:|---:|---:|---:|---:|")
    print("\n".join(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
