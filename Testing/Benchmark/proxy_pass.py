#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Light of the sky by spheres: error against rays, time against numbers, beside the sky's maps.

    Testing/Benchmark/proxy_pass.py errors    molecules, particles and meshes against rays
    Testing/Benchmark/proxy_pass.py times     spheres that move in every frame, beside UseSSAO
    Testing/Benchmark/proxy_pass.py paper     the ratios of Sloan et al. 2007, figures 7 and 9
    Testing/Benchmark/proxy_pass.py numbers   1,000 to 100,000 spheres, and a plot (--plot FILE)

Tables of Documentation/methods/sphere-proxies.md. Python finds the package by PYTHONPATH, as with
the other programs here. References are rays of this program, of spheres as they are and of the
triangles of meshes, at places and normals that the pass has seen itself. Times are the processor's
of all threads, of frames of each kind in turn: compare them within one run.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import methods
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference as by_reference
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

FOLDER = Path(__file__).resolve().parents[1]
RECEIVERS = 400
DIRECTIONS = 512
BOUNCE = (96, 64)
"""Directions of a receiver, and of each place that it sees."""
GOLDEN = np.pi * (3.0 - np.sqrt(5.0))


# Scenes ------------------------------------------------------------------------------------------


def protein(chain: str | None = None) -> np.ndarray:
    """Return the atoms of the protein, or of one chain: x, y, z, radius; Angstroms."""
    radii = {"C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8}
    rows = []
    for line in (FOLDER / "Data" / "protein_1tii.pdb").read_text(encoding="ascii").splitlines():
        if line.startswith("ATOM") and chain in (None, line[21]):
            place = [float(line[i : i + 8]) for i in (30, 38, 46)]
            rows.append([*place, radii.get(line[76:78].strip(), 1.7)])
    return np.array(rows)


def particles(count: int, seed: int = 5) -> np.ndarray:
    """Return spheres at random in a flat box, so many that they hide about as much anyhow."""
    random = np.random.Generator(np.random.PCG64(seed))
    size = (3000.0 / count) ** (1.0 / 2.0)
    places = random.uniform((-50, -20, -50), (50, 30, 50), (count, 3))
    return np.c_[places, size * random.uniform(0.6, 1.6, count)]


def spheres_actor(spheres: np.ndarray) -> tuple[vtkActor, vtkPolyData]:
    """Return an actor of vtkOpenGLSphereMapper and its data."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(spheres[:, :3].astype(np.float32), deep=True))
    data.SetPoints(points)
    sizes = numpy_to_vtk(spheres[:, 3].astype(np.float32), deep=True)
    sizes.SetName("size")
    data.GetPointData().AddArray(sizes)
    count = len(spheres)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(count + 1, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.arange(count, dtype=np.int64), deep=True),
    )
    data.SetVerts(cells)
    mapper = vtkOpenGLSphereMapper()
    mapper.SetInputData(data)
    mapper.SetScaleArray("size")
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, data


def ground(lower: np.ndarray, upper: np.ndarray) -> tuple[vtkActor, np.ndarray]:
    """Return a plane below a box, three times as wide, and x, z of its ends and its height."""
    middle, half = 0.5 * (lower + upper), 1.5 * (upper - lower).max()
    height = lower[1] - 0.02 * (upper[1] - lower[1])
    ends = np.array((middle[0] - half, middle[0] + half, middle[2] - half, middle[2] + half))
    source = vtkPlaneSource()
    source.SetOrigin(ends[0], height, ends[3])
    source.SetPoint1(ends[1], height, ends[3])
    source.SetPoint2(ends[0], height, ends[2])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, np.array((*ends, height))


class View:
    """A scene of white surfaces over a ground, in a window."""

    def __init__(self, actors: list[vtkActor], box: np.ndarray, size: tuple[int, int]) -> None:
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        lower, upper = box
        plane, self.plane = ground(lower, upper)
        for actor in (*actors, plane):
            actor.GetProperty().SetColor(1.0, 1.0, 1.0)
            self.renderer.AddActor(actor)
        middle, length = 0.5 * (lower + upper), np.linalg.norm(upper - lower)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + length * np.array((0.25, 0.7, 1.7))))
        camera.SetViewAngle(34)
        self.renderer.ResetCameraClippingRange()
        self.window = vtkindirect.render_window(size)
        self.window.AddRenderer(self.renderer)

    def receivers(
        self, seed: int = 1, count: int = RECEIVERS
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return pixels (y, x), places and normals of some of what the last frame has seen."""
        depth = vtkindirect.copy_buffer(self.renderer, "depth")[..., 0].astype(float)
        normals = vtkindirect.copy_buffer(self.renderer, "normal").astype(float)
        height, width = depth.shape
        camera = self.renderer.GetActiveCamera()
        ahead = np.array(camera.GetDirectionOfProjection())
        right = np.cross(ahead, camera.GetViewUp())
        right /= np.linalg.norm(right)
        tangent = np.tan(np.radians(camera.GetViewAngle() / 2))
        y, x = np.nonzero(depth > 0)
        chosen = np.random.Generator(np.random.PCG64(seed)).choice(
            len(y), min(count, len(y)), replace=False
        )
        y, x = y[chosen], x[chosen]
        across = ((x + 0.5) / width * 2 - 1) * tangent * width / height
        upward = ((y + 0.5) / height * 2 - 1) * tangent
        way = ahead + across[:, None] * right + upward[:, None] * np.cross(right, ahead)
        places = np.array(camera.GetPosition()) + depth[y, x][:, None] * way
        return np.stack((y, x)), places, normals[y, x]

    def close(self) -> None:
        self.window.Finalize()


# Rays --------------------------------------------------------------------------------------------


def directions(normal: np.ndarray, count: int, turn: float) -> np.ndarray:
    """Return directions about a normal that are distributed as the cosine."""
    share = (np.arange(count) + 0.5) / count
    angle = GOLDEN * np.arange(count) + turn
    helper = np.array((1.0, 0, 0) if abs(normal[0]) < 0.9 else (0, 1.0, 0))
    u = np.cross(normal, helper)
    u /= np.linalg.norm(u)
    v = np.cross(normal, u)
    flat = np.sqrt(share)[:, None]
    return flat * (np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * v) + np.sqrt(
        1.0 - share
    )[:, None] * normal


class Spheres:
    """Rays that meet spheres and the ground."""

    def __init__(self, spheres: np.ndarray, plane: np.ndarray) -> None:
        self.spheres = spheres
        self.plane = plane
        self.lift = 1e-4 * spheres[:, 3].min()

    def meets_plane(self, place: np.ndarray, ways: np.ndarray) -> np.ndarray:
        """Return distances, infinite where the ground is not met."""
        with np.errstate(divide="ignore", invalid="ignore"):
            t = (self.plane[4] - place[1]) / ways[:, 1]
            at = place + t[:, None] * ways
        hit = (t > self.lift) & (at[:, 0] > self.plane[0]) & (at[:, 0] < self.plane[1])
        hit &= (at[:, 2] > self.plane[2]) & (at[:, 2] < self.plane[3])
        return np.where(hit, t, np.inf)

    def nearest(self, place: np.ndarray, ways: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return distances and the spheres that are met first; -1: the ground, or nothing."""
        offset = self.spheres[:, :3] - place
        keep = offset[:, 0] ** 2 + offset[:, 1] ** 2 + offset[:, 2] ** 2 > 0
        along = ways @ offset.T
        gap = (offset**2).sum(axis=1) - self.spheres[:, 3] ** 2
        room = along**2 - gap
        with np.errstate(invalid="ignore"):
            t = along - np.sqrt(room)
        t = np.where((room > 0) & (t > 0) & keep, t, np.inf)
        which = t.argmin(axis=1)
        first = t[np.arange(len(ways)), which]
        below = self.meets_plane(place, ways)
        return np.minimum(first, below), np.where(first < below, which, -1)

    def sky(self, place: np.ndarray, normal: np.ndarray, count: int, turn: float) -> float:
        """Return the open share of a uniform sky."""
        place = place + self.lift * normal
        return float(np.isinf(self.nearest(place, directions(normal, count, turn))[0]).mean())

    def bounce(self, place: np.ndarray, normal: np.ndarray, turn: float) -> float:
        """Return the light of a uniform sky of what a place sees, all of it white."""
        place = place + self.lift * normal
        ways = directions(normal, BOUNCE[0], turn)
        t, which = self.nearest(place, ways)
        total = 0.0
        for i in np.flatnonzero(np.isfinite(t)):
            at = place + t[i] * ways[i]
            facing = np.array((0.0, 1.0 if ways[i][1] < 0 else -1.0, 0.0))
            if which[i] >= 0:
                facing = (at - self.spheres[which[i], :3]) / self.spheres[which[i], 3]
            total += self.sky(at, facing, BOUNCE[1], turn + i)
        return total / len(ways)


class Triangles:
    """Rays that meet a mesh and the ground."""

    def __init__(self, mesh: vtkPolyData, plane: np.ndarray) -> None:
        self.plane = plane
        self.mesh = mesh
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(mesh)
        self.locator.BuildLocator()
        self.length = 3.0 * (plane[1] - plane[0])
        self.lift = 1e-5 * self.length

    def sky(self, place: np.ndarray, normal: np.ndarray, count: int, turn: float) -> float:
        """Return the open share of a uniform sky."""
        place = place + self.lift * normal
        t, sub = by_reference(0.0), by_reference(0)
        at, inner = [0.0] * 3, [0.0] * 3
        ways = directions(normal, count, turn)
        below = Spheres.meets_plane(self, place, ways)
        hit = 0
        for way, plane in zip(ways, below):
            end = place + self.length * way
            hit += np.isfinite(plane) or self.locator.IntersectWithLine(
                place, end, 1e-9, t, at, inner, sub
            )
        return 1.0 - hit / count


# Errors ------------------------------------------------------------------------------------------


def compare(found: np.ndarray, true: np.ndarray) -> str:
    """Return nRMSE and bias, as cells of a table."""
    error = np.sqrt(((found - true) ** 2).mean()) / true.mean()
    return f"{error:.3f} | {(found - true).mean() / true.mean():+.1%}"


def against_rays(view: View, rays: Spheres | Triangles) -> tuple[np.ndarray, np.ndarray, str]:
    """Return pixels of the last frame, the sky that rays find there, and the cells of a table."""
    (y, x), places, normals = view.receivers()
    count = DIRECTIONS if isinstance(rays, Spheres) else DIRECTIONS // 2
    true = np.array([rays.sky(p, n, count, i) for i, (p, n) in enumerate(zip(places, normals))])
    sky = vtkindirect.copy_buffer(view.renderer, "sky")[y, x, 0]
    cells = compare(sky, true)
    if isinstance(rays, Spheres):
        some = slice(0, 120)
        sent = np.array(
            [rays.bounce(p, n, i) for i, (p, n) in enumerate(zip(places[some], normals[some]))]
        )
        bounce = vtkindirect.copy_buffer(view.renderer, "bounce")[y, x, 0][some]
        cells += f" | {(bounce - sent).mean() / sent.mean():+.1%}"
        cells += f" | {np.sqrt(((bounce - sent) ** 2).mean()) / true.mean():.3f}"
    else:
        cells += " | | "
    return np.stack((y, x)), true, cells


def error_rows(name: str, view: View, rays: Spheres | Triangles) -> None:
    """Print the rows of a scene."""
    indirect = methods.enable(view.renderer, "proxies", environment=(1.0, 1.0, 1.0))
    view.window.SetDesiredUpdateRate(15.0)
    view.window.Render()
    (y, x), true, cells = against_rays(view, rays)
    spheres = indirect.GetEstimator().GetNumberOfSpheres()
    print(f"| {name} | {spheres} spheres | {cells} |")
    indirect.SetEstimator(None)
    for label, rate in (("64 maps, moving", 15.0), ("256 maps, still", 1e-4)):
        view.window.SetDesiredUpdateRate(rate)
        for _ in range(20):
            view.window.Render()
        sky = vtkindirect.copy_buffer(view.renderer, "sky")[y, x, 0]
        print(f"| {name} | {label} | {compare(sky, true)} | | |", flush=True)
    view.close()


def part_of(scene: str, part: str) -> tuple[vtkActor, vtkPolyData]:
    """Return an actor in white of a part of a scene, and its triangles, shaded smoothly."""
    actor = vtkindirect.load_scene(FOLDER / "Scenes" / f"{scene}.json").actors[part]
    actor.GetMapper().Update()
    triangles = vtkTriangleFilter()
    triangles.SetInputData(actor.GetMapper().GetInput())
    smooth = vtkPolyDataNormals()
    smooth.SetInputConnection(triangles.GetOutputPort())
    smooth.SplittingOff()
    smooth.Update()
    mesh = smooth.GetOutput()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    own = vtkActor()
    own.SetMapper(mapper)
    return own, mesh


def errors() -> None:
    """Print the table of errors."""
    print(
        "| scene | by | nRMSE, sky | bias | bias, bounce | its RMSE over the sky's mean |\n"
        "|---|---|---:|---:|---:|---:|"
    )
    for name, spheres in (("protein", protein()), ("particles", particles(5000))):
        actor, _ = spheres_actor(spheres)
        box = np.array((spheres[:, :3].min(axis=0), spheres[:, :3].max(axis=0)))
        view = View([actor], box, (512, 384))
        error_rows(name, view, Spheres(spheres, view.plane))
    for scene, part in (("brain", "cortex"), ("frog", "liver"), ("frog", "stomach")):
        own, mesh = part_of(scene, part)
        bounds = np.array(mesh.GetBounds()).reshape(3, 2).T
        view = View([own], bounds, (512, 384))
        error_rows(f"{part} of {scene}", view, Triangles(mesh, view.plane))


# Times -------------------------------------------------------------------------------------------


class Moving:
    """Spheres that are elsewhere in every frame."""

    def __init__(self, spheres: np.ndarray, size: tuple[int, int]) -> None:
        actor, self.data = spheres_actor(spheres)
        self.rest = spheres[:, :3].astype(np.float32)
        self.swing = 0.2 * float(np.median(spheres[:, 3]))
        box = np.array((spheres[:, :3].min(axis=0), spheres[:, :3].max(axis=0)))
        self.view = View([actor], box, size)

    def frame(self, number: int) -> float:
        """Move, render, and return the processor's milliseconds."""
        places = vtk_to_numpy(self.data.GetPoints().GetData())
        places[:] = self.rest + self.swing * np.sin(number + self.rest[:, (1, 2, 0)])
        self.data.GetPoints().Modified()
        self.data.Modified()
        start = time.process_time()
        self.view.window.Render()
        return 1e3 * (time.process_time() - start)


def in_turn(kinds: dict[str, Moving], frames: int = 7) -> dict[str, float]:
    """Return medians of frames of each kind in turn."""
    spent: dict[str, list[float]] = {name: [] for name in kinds}
    for number in range(frames + 2):
        for name, moving in kinds.items():
            took = moving.frame(number)
            if number > 1:
                spent[name].append(took)
    return {name: statistics.median(values) for name, values in spent.items()}


def with_proxies(moving: Moving, **settings: object) -> Moving:
    """Switch the method on."""
    methods.enable(moving.view.renderer, "proxies", environment=(1.0, 1.0, 1.0), **settings)
    moving.view.window.SetDesiredUpdateRate(15.0)
    return moving


def with_maps(moving: Moving) -> Moving:
    """Switch on depth maps of the sky, and virtual lights."""
    indirect = methods.enable(moving.view.renderer, environment=(1.0, 1.0, 1.0))
    indirect.SpheresInMotionOff()
    moving.view.window.SetDesiredUpdateRate(15.0)
    return moving


def by_default(moving: Moving) -> Moving:
    """Switch on what the pass does by itself."""
    indirect = with_maps(moving).view.renderer.GetPass()
    indirect.SpheresInMotionOn()
    return moving


def with_lamp(moving: Moving) -> Moving:
    """Add a lamp, whose light virtual lights send on."""
    lamp = vtkLight()
    lamp.PositionalOn()
    lamp.SetConeAngle(35)
    places = moving.rest
    middle, length = places.mean(axis=0), float(np.linalg.norm(np.ptp(places, axis=0)))
    lamp.SetPosition(*(middle + length * np.array((0.6, 0.9, 0.4))))
    lamp.SetFocalPoint(*middle)
    moving.view.renderer.AddLight(lamp)
    return moving


def with_ssao(moving: Moving) -> Moving:
    """Switch VTK's ambient occlusion on."""
    renderer = moving.view.renderer
    renderer.UseSSAOOn()
    renderer.SetSSAORadius(0.2 * float(np.ptp(moving.rest, axis=0).max()))
    renderer.SetSSAOBias(0.1)
    renderer.SetSSAOKernelSize(32)
    renderer.SSAOBlurOn()
    return moving


def times() -> None:
    """Print spheres that move in every frame, beside UseSSAO, and their error; 1024 x 1024."""
    size = (1024, 1024)
    print(
        "| scene | frame | processor ms | over UseSSAO's | added over UseSSAO's | nRMSE, sky |"
        " bias | bias, bounce | its RMSE over the sky's mean |\n"
        "|---|---|---:|---:|---:|---:|---:|---:|---:|"
    )
    for scene, spheres in (("protein", protein()), ("particles", particles(5000))):
        kinds = {
            "vtk": Moving(spheres, size),
            "UseSSAO": with_ssao(Moving(spheres, size)),
            "sky alone": with_proxies(Moving(spheres, size), indirect_light="off"),
            "with a bounce": with_proxies(Moving(spheres, size)),
        }
        if scene == "protein":
            kinds |= {
                "maps, with a bounce": with_maps(Moving(spheres, size)),
                "by default": by_default(Moving(spheres, size)),
                "maps, and a lamp": with_lamp(with_maps(Moving(spheres, size))),
                "by default, and a lamp": with_lamp(by_default(Moving(spheres, size))),
            }
        found = in_turn(kinds)
        for name, spent in found.items():
            added = (spent - found["vtk"]) / (found["UseSSAO"] - found["vtk"])
            cells = "| | | "
            if name == "with a bounce":
                places = vtk_to_numpy(kinds[name].data.GetPoints().GetData()).astype(float)
                view = kinds[name].view
                rays = Spheres(np.c_[places, spheres[:, 3]], view.plane)
                _, _, cells = against_rays(view, rays)
            print(
                f"| {scene} | {name} | {spent:.0f} | {spent / found['UseSSAO']:.2f} | {added:.2f} |"
                f" {cells} |",
                flush=True,
            )


PAPER_RECEIVERS = {
    "all pixels": ({"receiver_step": 1}, 8),
    "1/16, bilateral": ({"receiver_step": 4}, 66),
    "1/16, bilinear": ({"receiver_step": 4, "upsampling": "bilinear"}, None),
    "1/64, bilateral": ({"receiver_step": 8}, 99),
    "1/64, bilinear": ({"receiver_step": 8, "upsampling": "bilinear"}, 171),
}
"""Settings of figure 7, and the paper's frames a second (GeForce 8800 GTX); one of them is illegible."""
PAPER_BLEEDING = {"without light of spheres": ("off", 55), "with light of spheres": ("averaged", 41)}
"""The light of figure 9, and the paper's frames a second."""


def paper(size: int, frames: int) -> None:
    """Print ratios of figures 7 and 9: receivers and upsampling, light of spheres; 60 spheres."""
    spheres = particles(60)

    def one(**settings: object) -> Moving:
        return with_proxies(Moving(spheres, (size, size)), preset="paper", **settings)

    kinds = {
        f"Figure 7: {name}": one(indirect_light="off", **settings)
        for name, (settings, _) in PAPER_RECEIVERS.items()
    }
    kinds |= {f"Figure 9: {name}": one(indirect_light=light) for name, (light, _) in PAPER_BLEEDING.items()}
    kinds["vtk"] = Moving(spheres, (size, size))
    found = in_turn(kinds, frames)
    print(f"60 spheres that move, {size} x {size}, preset paper; rates are over those of a figure's first row:")
    print("of whole frames, and of what the method adds to plain VTK's frame "
          f"({found['vtk']:.0f} ms of the processor).\n")  # fmt: skip
    print("| what | frame, processor ms | rate of frames | of what is added | paper |\n|---|---:|---:|---:|---:|")
    for figure, rates in (("Figure 7", PAPER_RECEIVERS), ("Figure 9", PAPER_BLEEDING)):
        first: tuple[float, float] | None = None
        for name, (_, rate) in rates.items():
            spent = found[f"{figure}: {name}"]
            added = spent - found["vtk"]
            first = first or (spent, added)
            published = rate and f"{rate / next(iter(rates.values()))[1]:.2f} ({rate} a second)"
            print(f"| {figure}: {name} | {spent:.0f} | {first[0] / spent:.2f} | {first[1] / added:.2f} "
                  f"| {published or ''} |")  # fmt: skip


def numbers(plot: Path | None) -> None:
    """Print time against the number of spheres; 512 x 512."""
    counts = (100, 300, 1000, 3000, 10000, 30000, 100000)
    print("| spheres | vtk | sky alone, added | with a bounce, added |\n|---:|---:|---:|---:|")
    rows = []
    for count in counts:
        spheres = particles(count)
        found = in_turn(
            {
                "vtk": Moving(spheres, (512, 512)),
                "sky": with_proxies(Moving(spheres, (512, 512)), indirect_light="off"),
                "bounce": with_proxies(Moving(spheres, (512, 512))),
            },
            5,
        )
        row = (found["vtk"], found["sky"] - found["vtk"], found["bounce"] - found["vtk"])
        rows.append(row)
        print(f"| {count:,} | {row[0]:.0f} | {row[1]:.0f} | {row[2]:.0f} |", flush=True)
    if plot is not None:
        from matplotlib import pyplot

        figure, axes = pyplot.subplots(figsize=(5, 3.4), layout="constrained")
        for column, name in enumerate(("plain VTK's frame", "sky alone", "sky and a bounce")):
            axes.loglog(counts, [row[column] for row in rows], marker="o", label=name)
        axes.set_xlabel("spheres, all moving in every frame")
        axes.set_ylabel("processor ms")
        axes.grid(which="both", alpha=0.3)
        axes.legend()
        figure.savefig(plot, dpi=100)
        print(plot)


def main() -> int:
    """Print what the command line asks for."""
    parser = argparse.ArgumentParser(description="Light of the sky by spheres.")
    parser.add_argument("what", choices=("errors", "times", "paper", "numbers"))
    parser.add_argument("--plot", type=Path, help="numbers: draw them, too")
    parser.add_argument("--size", type=int, default=512, help="paper: edge of the window (default: 512)")
    parser.add_argument("--frames", type=int, default=7, help="paper: frames of each kind (default: 7)")
    given = parser.parse_args()
    work: dict[str, Callable[[], None]] = {
        "errors": errors,
        "times": times,
        "paper": lambda: paper(given.size, given.frames),
        "numbers": lambda: numbers(given.plot),
    }
    work[given.what]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
