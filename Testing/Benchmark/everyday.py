# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as users of PyVista and of VTK draw them, with nothing set: see worth.py.

Their data come with PyVista or stand in Testing/Data.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import vtkindirect
from vtkindirect import frames, windows
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

import readability
import shots


class Drawing(NamedTuple):
    """A scene in a window."""

    renderer: vtkRenderer
    render_window: vtkRenderWindow
    close: Callable[[], Any]
    bar: np.ndarray | None = None
    """Entries of the colour map, n x 3 bytes, where it is coloured by one."""


SCENES: dict[str, Callable[[int], Drawing]] = {}


def plotted(
    name: str,
    background: str,
    headlight: bool = False,
) -> Callable[[Callable[[Any], Any]], Callable[[Any], Any]]:
    """Add a scene that a function draws into a plotter; it may return a colour map's name."""

    def register(draw: Callable[[Any], Any]) -> Callable[[Any], Any]:
        def make(width: int) -> Drawing:
            import pyvista

            if not windows.has_display():
                vtkindirect.use_headless()
            plotter = pyvista.Plotter(off_screen=True, window_size=(width, width))
            plotter.render_window.SetMultiSamples(0)
            plotter.set_background(background)
            if headlight:
                readability.set_lights(plotter.renderer, "headlight")
            cmap = draw(plotter)
            if not plotter.camera_set:
                plotter.view_isometric()  # as plotter.show does
            bar = None if cmap is None else _entries(cmap)
            return Drawing(plotter.renderer, plotter.render_window, plotter.close, bar)

        SCENES[name] = make
        return draw

    return register


def _entries(cmap: str) -> np.ndarray:
    import pyvista

    table = pyvista.LookupTable(cmap, n_values=256)
    return np.asarray(table.values, dtype=np.uint8)[:, :3]


@plotted("knot on a plane", "white")
def _knot(plotter: Any) -> None:
    import pyvista

    t = np.linspace(0.0, 2.0 * np.pi, 400)
    path = np.c_[np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
    tube = pyvista.Spline(path, 800).tube(radius=0.35, n_sides=40)
    plotter.add_mesh(tube, color="tan", smooth_shading=True)
    plotter.add_mesh(pyvista.Plane(center=(0, 0, -1.4), i_size=9, j_size=9), color="white")
    plotter.view_isometric()
    plotter.camera.zoom(1.5)


@plotted("random hills", "white")
def _hills(plotter: Any) -> str:
    from pyvista import examples

    hills = examples.load_random_hills()
    plotter.add_mesh(hills, cmap="gist_earth", smooth_shading=True, show_scalar_bar=False)
    return "gist_earth"


@plotted("nut", "black")
def _nut(plotter: Any) -> None:
    import pyvista
    from pyvista import examples

    nut = pyvista.read(examples.nutfile)
    look = {"split_sharp_edges": True, "smooth_shading": True, "specular": 0.5}
    plotter.add_mesh(nut, color="lightblue", **look)


@plotted("stream tubes", "white")
def _streams(plotter: Any) -> str:
    import pyvista

    grid = pyvista.Wavelet()
    x, y = grid.points[:, 0], grid.points[:, 1]
    grid["v"] = np.c_[np.sin(y / 3), np.cos(x / 3), 0.3 * np.ones(grid.n_points)]
    lines = grid.streamlines("v", n_points=80, source_radius=8)
    tubes = lines.tube(radius=0.15)
    look = {"cmap": "viridis", "smooth_shading": True, "show_scalar_bar": False}
    plotter.add_mesh(tubes, scalars="RTData", **look)
    return "viridis"


@plotted("spheres", "white")
def _spheres(plotter: Any) -> None:
    import pyvista

    places = pyvista.PolyData(np.random.default_rng(0).normal(size=(400, 3)))
    balls = places.glyph(geom=pyvista.Sphere(radius=0.12), scale=False, orient=False)
    plotter.add_mesh(balls, color="orange", smooth_shading=True)
    plotter.add_mesh(pyvista.Plane(center=(0, 0, -2.5), i_size=8, j_size=8), color="white")


@plotted("white tray", "black")
def _tray(plotter: Any) -> None:
    import pyvista

    walls = [
        pyvista.Plane(center=(x, y, 0.4), direction=(abs(x), abs(y), 0), i_size=0.8, j_size=2)
        for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1))
    ]
    parts = pyvista.MultiBlock([pyvista.Plane(i_size=2, j_size=2), *walls])
    plotter.add_mesh(parts.combine().extract_surface(), color="white")
    plotter.camera_position = [(0, -2, 5), (0, 0, 0.2), (0, 1, 0)]


@plotted("smooth-shaded cube", "black")
def _cube(plotter: Any) -> None:
    import pyvista

    plotter.add_mesh(pyvista.Cube(), color="white", smooth_shading=True)
    plotter.camera_position = "xy"
    plotter.reset_camera()
    plotter.camera.azimuth = 15


@plotted("slices and contour", "white")
def _slices(plotter: Any) -> str:
    import pyvista

    grid = pyvista.Wavelet()
    slices = grid.slice_orthogonal()
    plotter.add_mesh(slices, cmap="viridis", show_scalar_bar=False)
    plotter.add_mesh(grid.contour([200.0]), color="white", smooth_shading=True)
    return "viridis"


@plotted("terrain", "black", headlight=True)
def _terrain(plotter: Any) -> str:
    import pyvista

    noise = pyvista.perlin_noise(1.0, (2.0, 2.0, 0.0), (0.0, 0.0, 0.0))
    grid = pyvista.sample_function(noise, bounds=(0, 4, 0, 4, 0, 0), dim=(160, 160, 1))
    land = grid.warp_by_scalar(factor=0.5).extract_surface()
    plotter.add_mesh(land, cmap="viridis", smooth_shading=True, show_scalar_bar=False)
    return "viridis"


def _shown(name: str, shot: str, lights: str, background: tuple[float, float, float]) -> None:
    """Add a shot of shots.py in the lights that VTK or PyVista would give it."""

    def make(width: int) -> Drawing:
        scene = readability.find(shot).load(size=(width, width), background=background)
        readability.set_lights(scene.renderer, lights)
        window = frames.open_window(scene, None)
        window.SetMultiSamples(0)
        return Drawing(scene.renderer, window, window.Finalize)

    SCENES[name] = make


_shown("brain", "brain", "headlight", (0.0, 0.0, 0.0))
_shown("molecule", "molecule", "headlight", (1.0, 1.0, 1.0))
_shown("machine part", readability.STANDING, "light kit", (1.0, 1.0, 1.0))
