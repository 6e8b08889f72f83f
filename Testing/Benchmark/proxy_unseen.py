#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sums over spheres in scenes that nothing was chosen for, against rays: nRMSE and bias.

    Testing/Benchmark/proxy_unseen.py [--seed N] [--only N,N]

Six scenes of particles at random: how dense they are, how much radii differ, from where they are
seen, a ground or none, a uniform sky or an evening's. An organ, and a chain of the protein, are
seen from a side at random. Beside nRMSE is what rays alone make of it, from two halves of them.
Prints a table of Documentation/methods/sphere-proxies.md. All is white; every pixel is a receiver.
"""

from __future__ import annotations

import argparse
import sys
import time

import numpy as np
import vtkindirect
from vtkindirect import environments, methods
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference as by_reference
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

import proxy_pass

SIZE = (160, 120)
RECEIVERS = 300
DIRECTIONS = 256
"""Directions of each receiver in each of two halves."""
SENT = 120
BOUNCE = (64, 48)
"""Receivers whose bounce is compared; directions of each, and of each place that it sees."""
NO_PLANE = np.array((1.0, -1.0, 1.0, -1.0, 0.0))
EVENING = proxy_pass.FOLDER / "Data" / "sky_gradient.exr"
"""Depends on the altitude alone."""


class Sky:
    """A uniform sky of radiance 1, or an evening's; the mean of its colours."""

    def __init__(self, evening: bool) -> None:
        self.rows: np.ndarray | None = None
        if evening:
            picture = environments.read_picture(EVENING)
            columns, rows, _ = picture.GetDimensions()
            values = vtk_to_numpy(picture.GetPointData().GetScalars())
            self.rows = values.reshape(rows, columns, -1)[:, 0, :3].astype(float).mean(axis=1)

    def value(self) -> object:
        """Return what `methods.enable` takes."""
        return (1.0, 1.0, 1.0) if self.rows is None else str(EVENING)

    def radiance(self, ways: np.ndarray) -> np.ndarray:
        """Return what comes from directions."""
        if self.rows is None:
            return np.ones(len(ways))
        count = len(self.rows)
        altitude = np.arcsin(np.clip(ways[:, 1], -1.0, 1.0)) / np.pi + 0.5
        return self.rows[np.clip((altitude * count).astype(int), 0, count - 1)]


class Spheres:
    """Rays that meet spheres and the ground, and what they find of a sky."""

    def __init__(self, spheres: np.ndarray, plane: np.ndarray) -> None:
        self.met = proxy_pass.Spheres(spheres, plane)
        self.lift = self.met.lift

    def first(self, place: np.ndarray, ways: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return distances, infinite of the sky, and normals of what is met."""
        t, which = self.met.nearest(place, ways)
        normals = np.zeros_like(ways)
        normals[:, 1] = np.where(ways[:, 1] < 0.0, 1.0, -1.0)
        on = which >= 0
        at = place + t[on, None] * ways[on]
        spheres = self.met.spheres[which[on]]
        normals[on] = (at - spheres[:, :3]) / spheres[:, 3:]
        return t, normals


class Triangles:
    """The same of a mesh."""

    def __init__(self, mesh: vtkPolyData, plane: np.ndarray) -> None:
        self.plane = plane
        self.mesh = mesh
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(mesh)
        self.locator.BuildLocator()
        self.length = 10.0 * mesh.GetLength()
        self.lift = 1e-5 * self.length

    def first(self, place: np.ndarray, ways: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return distances, infinite of the sky, and normals of what is met."""
        t, sub, cell = by_reference(0.0), by_reference(0), by_reference(0)
        at, inner = [0.0] * 3, [0.0] * 3
        found = proxy_pass.Spheres.meets_plane(self, place, ways)
        normals = np.zeros_like(ways)
        normals[:, 1] = np.where(ways[:, 1] < 0.0, 1.0, -1.0)
        for i, way in enumerate(ways):
            end = place + self.length * way
            hit = self.locator.IntersectWithLine(place, end, 1e-9, t, at, inner, sub, cell)
            if hit and float(t) * self.length < found[i]:
                found[i] = float(t) * self.length
                corners = vtk_to_numpy(self.mesh.GetCell(int(cell)).GetPoints().GetData())
                normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
                length = np.linalg.norm(normal)
                normals[i] = normal / length if length > 0.0 else -way
                normals[i] *= -np.sign(normals[i] @ way) or 1.0
        return found, normals


Rays = Spheres | Triangles


def direct(
    rays: Rays, sky: Sky, place: np.ndarray, normal: np.ndarray, count: int, turn: float
) -> float:
    """Return the irradiance of the sky."""
    ways = proxy_pass.directions(normal, count, turn)
    t, _ = rays.first(place + rays.lift * normal, ways)
    return float((np.isinf(t) * sky.radiance(ways)).mean())


def bounce(rays: Rays, sky: Sky, place: np.ndarray, normal: np.ndarray, turn: float) -> float:
    """Return the light of the sky of what a place sees, all of it white."""
    ways = proxy_pass.directions(normal, BOUNCE[0], turn)
    start = place + rays.lift * normal
    t, normals = rays.first(start, ways)
    return sum(
        direct(rays, sky, start + t[i] * ways[i], normals[i], BOUNCE[1], turn + 1.7 * i)
        for i in np.flatnonzero(np.isfinite(t))
    ) / len(ways)


class View(proxy_pass.View):
    """White surfaces before a given camera."""

    def __init__(
        self, actor: vtkActor, box: np.ndarray, place: np.ndarray, target: np.ndarray, grounded: bool
    ) -> None:
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        plane, self.plane = proxy_pass.ground(*box)
        actors = [actor, plane] if grounded else [actor]
        if not grounded:
            self.plane = NO_PLANE
        for each in actors:
            each.GetProperty().SetColor(1.0, 1.0, 1.0)
            self.renderer.AddActor(each)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(*target)
        camera.SetPosition(*place)
        camera.SetViewAngle(34)
        self.renderer.ResetCameraClippingRange()
        self.window = vtkindirect.render_window(SIZE)
        self.window.AddRenderer(self.renderer)


def row(name: str, view: View, rays: Rays, sky: Sky) -> None:
    """Print the row of a scene."""
    begin = time.process_time()
    indirect = methods.enable(view.renderer, "proxies", environment=sky.value())
    view.window.Render()
    (y, x), places, normals = view.receivers(count=RECEIVERS)
    step = methods.report(indirect)["settings"]["ReceiverStep"]
    halves = np.array(
        [
            [direct(rays, sky, p, n, DIRECTIONS, i + half) for half in (0.0, 0.5)]
            for i, (p, n) in enumerate(zip(places, normals))
        ]
    )
    true = halves.mean(axis=1)
    noise = np.sqrt(((halves[:, 0] - halves[:, 1]) ** 2).mean()) / 2.0 / true.mean()
    sent = np.array(
        [bounce(rays, sky, p, n, i) for i, (p, n) in enumerate(zip(places[:SENT], normals[:SENT]))]
    )
    found = {
        buffer: vtkindirect.copy_buffer(view.renderer, buffer)[y, x, :3].mean(axis=1)
        for buffer in ("sky", "bounce")
    }
    off = found["bounce"][:SENT] - sent
    spheres = indirect.GetEstimator().GetNumberOfSpheres()
    print(
        f"| {name} | {spheres} | {true.mean():.2f} | {proxy_pass.compare(found['sky'], true)} | "
        f"{noise:.3f} | {off.mean() / sent.mean():+.1%} | "
        f"{np.sqrt((off**2).mean()) / true.mean():.3f} |",
        flush=True,
    )
    # By how open places are: which of them are off.
    order = np.argsort(true)
    thirds = " ".join(
        f"{true[part].mean():.2f}: {(found['sky'] - true)[part].mean():+.3f}"
        for part in np.array_split(order, 3)
    )
    print(
        f"{name}: step {step}, {time.process_time() - begin:.0f} s; thirds by openness {thirds}",
        file=sys.stderr,
    )
    view.close()


def particles_scene(number: int, seed: int) -> None:
    """Print the row of particles at random; the number alone says whence they are seen."""
    random = np.random.Generator(np.random.PCG64((seed, number)))
    count = int(np.exp(random.uniform(np.log(200), np.log(3000))))
    half = random.uniform(0.3, 1.0, 3)
    places = random.uniform(-half, half, (count, 3))
    share = np.exp(random.uniform(np.log(0.01), np.log(0.25)))
    spread = random.uniform(1.0, 6.0)
    radii = np.exp(random.uniform(0.0, np.log(spread), count))
    # So that the spheres' volumes are this share of the box.
    radii *= (share * 8.0 * half.prod() / (4.0 / 3.0 * np.pi * (radii**3).sum())) ** (1.0 / 3.0)
    spheres = np.c_[places, radii].astype(np.float32).astype(float)
    grounded, evening = bool(random.integers(2)), bool(random.integers(2))
    whence = ("near", "far", "among")[number % 3]
    way = random.normal(size=3)
    way[1] = abs(way[1])
    way /= np.linalg.norm(way)
    target = np.zeros(3)
    eye = {"near": 1.6, "far": 4.5, "among": 0.0}[whence] * np.linalg.norm(half) * way
    if whence == "among":
        # The freest of places inside.
        tries = random.uniform(-0.7 * half, 0.7 * half, (64, 3))
        gaps = (np.linalg.norm(tries[:, None] - places, axis=2) - radii).min(axis=1)
        eye = tries[gaps.argmax()]
        target = eye - way * np.linalg.norm(half)
    actor, _ = proxy_pass.spheres_actor(spheres)
    box = np.array((-half - radii.max(), half + radii.max()))
    view = View(actor, box, eye, target, grounded)
    name = (
        f"{whence}, {share:.1%} of the space, radii 1 to {spread:.1f}, "
        f"{'ground' if grounded else 'no ground'}, {'evening' if evening else 'uniform'}"
    )
    row(name, view, Spheres(spheres, view.plane), Sky(evening))


def around(box: np.ndarray, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return a camera's place at a side of a box, and the middle."""
    angle, height = random.uniform(0.0, 2.0 * np.pi), random.uniform(0.1, 0.9)
    way = np.array((np.cos(angle), height, np.sin(angle)))
    middle = box.mean(axis=0)
    return middle + 1.7 * np.linalg.norm(box[1] - box[0]) * way / np.linalg.norm(way), middle


def organ_scene(part: str, seed: int) -> None:
    """Print the row of an organ of the frog."""
    own, mesh = proxy_pass.part_of("frog", part)
    box = np.array(mesh.GetBounds()).reshape(3, 2).T
    random = np.random.Generator(np.random.PCG64((seed, 100)))
    view = View(own, box, *around(box, random), grounded=True)
    row(f"{part} of the frog, ground, evening", view, Triangles(mesh, view.plane), Sky(True))


def chain_scene(letter: str, seed: int) -> None:
    """Print the row of a chain of the protein, its atoms at their radii."""
    spheres = proxy_pass.protein(letter)
    actor, _ = proxy_pass.spheres_actor(spheres)
    box = np.array((spheres[:, :3].min(axis=0), spheres[:, :3].max(axis=0)))
    random = np.random.Generator(np.random.PCG64((seed, 101)))
    view = View(actor, box, *around(box, random), grounded=False)
    row(
        f"chain {letter} of the protein, no ground, uniform",
        view,
        Spheres(spheres, view.plane),
        Sky(False),
    )


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description="Scenes that nothing was chosen for.")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--only", default="", help="numbers of scenes, 0 to 7, with commas")
    given = parser.parse_args()
    chosen = {int(number) for number in given.only.split(",") if number} or set(range(8))
    print(
        "| scene | spheres | mean | nRMSE, sky | bias | of it rays | bias, bounce | its RMSE over "
        "the sky's mean |\n|---|---:|---:|---:|---:|---:|---:|---:|"
    )
    for number in range(6):
        if number in chosen:
            particles_scene(number, given.seed)
    if 6 in chosen:
        organ_scene("kidney", given.seed)
    if 7 in chosen:
        chain_scene("A", given.seed)
    return 0


if __name__ == "__main__":
    sys.exit(main())
