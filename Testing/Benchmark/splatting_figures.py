# SPDX-License-Identifier: BSD-3-Clause
"""Figures of Dachsbacher and Stamminger 2006, for splatting.py.

- 3, colour plate 3: the picture with I_low of 1, 5 and 7 %, cut off as there, and 5 % with the far field.
- 5: a level of the importance warping: the light's map with the mean flux of its quarters, places
  before it, after its vertical and after its horizontal step (equations 4 to 6), and these on the map.
- 7: virtual lights drawn with 1 to 4 levels of methods A and B, as the light sees them.
- 8: the number of splats at each pixel, white for 256: ellipsoids, and lists of tiles.
- 9: iso-surfaces of exponents 1, 10 and 100.
- 10: iso-surfaces and their ellipses, of exponents 1 and 10, and of a lobe that is widened near its light.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import plot
import vtkindirect
from vtkindirect import frames, images, methods
from vtkindirect.scene import Scene

LIGHTS = 768


def open_scene(path: Path, size: int, method: str, **settings: Any) -> Scene:
    """Return a scene in a window, its pass without visibility and of one bounce."""
    scene = vtkindirect.load_scene(path)
    frames.open_window(scene, (size, size))
    methods.enable(scene.renderer, method, settings.pop("sampler", "uniform"), Caching=False,
                   Visibility="none", NumberOfBounces=1, **settings)  # fmt: skip
    return scene


def write_png(path: Path, image: np.ndarray) -> None:
    """Write an image, top row first, of values from 0 to 1."""
    pyplot = plot.require_plots()
    pyplot.imsave(path, np.clip(image, 0.0, 1.0))


def draw_thresholds(source: Path, size: int, path: Path) -> None:
    """Draw colour plate 3."""
    scene = open_scene(source, size, "splatting", NumberOfLights=LIGHTS)
    estimator = methods.pass_of(scene.renderer).GetEstimator()
    pictures = []
    for share, far in ((0.01, False), (0.05, False), (0.07, False), (0.05, True)):
        estimator.SetIntensityThreshold(share)
        estimator.SetFarField(far)
        scene.render_window.Render()
        pictures.append(images.copy_buffer(scene.renderer, "final")[..., :3])
    write_png(path, np.concatenate(pictures, axis=1)[::-1])


def draw_overdraw(source: Path, size: int, path: Path) -> None:
    """Draw figure 8."""
    pictures = []
    for paths in ("compute=off", "compute=on"):
        os.environ["VTK_INDIRECT_PATHS"] = paths
        scene = open_scene(source, size, "splatting", NumberOfLights=LIGHTS,
                           IntensityThreshold=0.05, FarField=False)  # fmt: skip
        scene.render_window.Render()
        pictures.append(images.copy_buffer(scene.renderer, "splat.overdraw")[..., :3])
        scene.render_window.Finalize()
    write_png(path, np.concatenate(pictures, axis=1)[::-1])


def sobol(count: int) -> np.ndarray:
    """Return places of the unit square, evenly spread: the R2 sequence."""
    steps = np.array([0.7548776662466927, 0.5698402909980532])
    return (0.5 + np.arange(count)[:, None] * steps) % 1.0


def warp(places: np.ndarray, share: np.ndarray, axis: int) -> np.ndarray:
    """Move a coordinate so that its lower half has a share of the places (equation 5)."""
    result = places.copy()
    value = places[:, axis]
    lower = value / np.maximum(2.0 * share, 1e-12)
    upper = (1.0 + value - 2.0 * share) / np.maximum(2.0 * (1.0 - share), 1e-12)
    result[:, axis] = np.where(value < share, lower, upper)
    return result


def draw_warping(source: Path, size: int, path: Path) -> None:
    """Draw figure 5 of the scene's first map."""
    pyplot = plot.require_plots()
    scene = open_scene(source, size, "gather")
    scene.render_window.Render()
    flux = images.copy_buffer(scene.renderer, "rsm0.density")[..., :3]
    half = flux.shape[0] // 2
    quarters = np.array([[part.sum() for part in np.split(rows, [half], axis=1)]
                         for rows in np.split(flux.sum(axis=2), [half], axis=0)])  # fmt: skip
    places = sobol(400)
    lower = quarters[0].sum() / quarters.sum()
    vertical = warp(places, np.full(len(places), lower), 1)
    row = (vertical[:, 1] >= 0.5).astype(int)
    left = quarters[:, 0] / np.maximum(quarters.sum(axis=1), 1e-30)
    both = warp(vertical, left[row], 0)
    picture = np.sqrt(np.clip(flux / max(float(np.percentile(flux, 99.0)), 1e-30), 0.0, 1.0))
    means = np.kron(quarters / quarters.max(), np.ones((half, half)))
    figure, axes = pyplot.subplots(1, 5, figsize=(13.0, 2.9))
    panels = (
        ("(a) mean flux of quarters", means, None),
        ("(b) places", None, places),
        ("(c) after the vertical step", None, vertical),
        ("(d) after the horizontal step", None, both),
        ("(e) on the map", picture, both),
    )
    for axis, (title, background, points) in zip(axes, panels):
        if background is not None:
            axis.imshow(background, origin="lower", extent=(0, 1, 0, 1), cmap="gray", vmin=0, vmax=1)
        if points is not None:
            axis.plot(points[:, 0], points[:, 1], ".", color="#d55e00", markersize=3)
        axis.axhline(0.5, color="0.5", linewidth=0.8)
        axis.axvline(0.5, color="0.5", linewidth=0.8)
        axis.set(xlim=(0, 1), ylim=(0, 1), xticks=[], yticks=[], aspect="equal")
        axis.set_title(title, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=80)


def look_along(scene: Scene) -> Any:
    """Let the eye see what the scene's first light sees; return the camera."""
    light = scene.renderer.GetLights().GetItemAsObject(0)
    camera = scene.renderer.GetActiveCamera()
    position, target = np.array(light.GetPosition()), np.array(light.GetFocalPoint())
    axis = (target - position) / np.linalg.norm(target - position)
    camera.SetPosition(*position)
    camera.SetFocalPoint(*target)
    camera.SetViewUp(*np.eye(3)[int(np.argmin(np.abs(axis)))])
    camera.SetViewAngle(min(2.0 * light.GetConeAngle(), 130.0))
    scene.renderer.ResetCameraClippingRange()
    return camera


def draw_levels(source: Path, size: int, path: Path) -> None:
    """Draw figure 7: lights by levels and methods, over what is lit, as the light sees it."""
    pyplot = plot.require_plots()
    scene = open_scene(source, size, "gather", sampler="importance")
    look_along(scene)
    sampler = methods.pass_of(scene.renderer).GetSampler()
    sampler.SetNumberOfLights(LIGHTS)
    # The paper's importance alone: (1 - O), and none spread evenly.
    sampler.SetEvenness(0.0)
    sampler.SetOcclusion(1.0)
    matrix = None
    figure, axes = pyplot.subplots(2, 4, figsize=(10.0, 5.3))
    for line, (method, name) in enumerate(((0, "A"), (1, "B"))):
        for column in range(4):
            sampler.SetWarping(method)
            sampler.SetLevels(column + 1)
            scene.render_window.Render()
            if matrix is None:
                camera = scene.renderer.GetActiveCamera()
                to_clip = camera.GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
                matrix = np.array([[to_clip.GetElement(i, j) for j in range(4)] for i in range(4)])
                lit = images.copy_buffer(scene.renderer, "direct")[..., :3]
                lit = np.sqrt(np.clip(lit / max(float(np.percentile(lit, 99.0)), 1e-30), 0.0, 1.0))
            table = images.copy_buffer(scene.renderer, "lights")
            sends = table[:, 2, :3].max(axis=1) > 0.0
            places = np.concatenate([table[sends, 0, :3], np.ones((int(sends.sum()), 1))], axis=1)
            clip = places @ matrix.T
            seen = clip[:, :2] / clip[:, 3:]
            axis = axes[line][column]
            axis.imshow(0.8 * lit, origin="lower", extent=(-1, 1, -1, 1))
            axis.plot(seen[:, 0], seen[:, 1], ".", color="#00d0ff", markersize=2)
            axis.set(xlim=(-1, 1), ylim=(-1, 1), xticks=[], yticks=[], aspect="equal")
            levels = f"{column + 1} level{'s' if column else ''}"
            axis.set_title(f"method {name}, {levels}", fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=80)


def outline(axis: Any, exponent: float) -> None:
    """Add the iso-surface cos^n / r^2 = 1."""
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 4001)
    radius = np.cos(angle) ** (0.5 * exponent)
    axis.plot(radius * np.cos(angle), radius * np.sin(angle), "k", label="iso-surface")


def ellipse(axis: Any, center: float, along: float, across: float) -> None:
    """Add an ellipse about a place on the axis."""
    turn = np.linspace(0.0, 2.0 * np.pi, 400)
    axis.plot(center + along * np.cos(turn), across * np.sin(turn), "0.6", label="ellipse")


def finish(figure: Any, axes: Any, path: Path) -> None:
    """Write a figure of outlines."""
    for axis in axes:
        axis.set_aspect("equal")
        axis.grid(True, alpha=0.3)
    axes[0].legend(fontsize=8, loc="lower right")
    figure.tight_layout()
    figure.savefig(path, dpi=72)


def draw_surfaces(_source: Path, _size: int, path: Path) -> None:
    """Draw figure 9: iso-surfaces of exponents 1, 10 and 100."""
    pyplot = plot.require_plots()
    figure, axes = pyplot.subplots(1, 3, figsize=(9.0, 3.2), sharex=True, sharey=True)
    for axis, exponent in zip(axes, (1, 10, 100)):
        outline(axis, exponent)
        axis.set_title(f"n = {exponent}")
    finish(figure, axes, path)


def draw_bounds(_source: Path, _size: int, path: Path) -> None:
    """Draw figure 10: ellipses of exponents 1 and 10, and of a lobe with a beam near its light."""
    pyplot = plot.require_plots()
    figure, axes = pyplot.subplots(1, 3, figsize=(9.0, 3.2), sharex=True, sharey=True)
    for axis, n in zip(axes, (1, 10)):
        center = (n / (n + 2)) ** (0.25 * (n + 2))
        height = (n / (n + 2)) ** (0.25 * n) * np.sqrt(2.0 / (n + 2))
        outline(axis, n)
        ellipse(axis, center, max(center, 1.0 - center), height)
        axis.set_title(f"n = {n}")
    # As vtkiMakeLobeSplat, its light of this area for a reach of one.
    n, area = 100.0, 6e-3
    reach = min(0.5 * np.sqrt(n * area), 1.0)
    distance = np.linspace(1e-3, 1.0, 2000)
    widened = n * np.minimum(distance / (0.5 * np.sqrt(n * area)), 1.0) ** 2

    def integral(exponent: np.ndarray) -> np.ndarray:
        return 2.0 * np.pi / (exponent + 1.0)

    flux = integral(np.array(n)) * (1.0 + area / (np.pi * n))
    level = flux / (integral(widened) * (distance**2 + area / (np.pi * np.maximum(widened, 1.0))))
    counts = level >= 1.0
    angle = np.arccos(np.clip(level[counts] ** (-1.0 / np.maximum(widened[counts], 1e-6)), 0.0, 1.0))
    x, y = distance[counts] * np.cos(angle), distance[counts] * np.sin(angle)
    axes[2].plot(np.concatenate([x, x[::-1]]), np.concatenate([y, -y[::-1]]), "k")
    center = (n / (n + 2)) ** (0.25 * (n + 2))
    height = (n / (n + 2)) ** (0.25 * n) * np.sqrt(2.0 / (n + 2))
    beam = min(np.sqrt(0.5 * area * np.log(1.17 * 2.0 * flux / (np.pi * area))), reach)
    across = max(height, np.sqrt(2.0) * beam)
    ends = max(center, reach - center) / np.sqrt(1.0 - (beam / across) ** 2)
    ellipse(axes[2], center, max(center, 1.0 - center, ends), across)
    axes[2].set_title("n = 100, widened near its light")
    finish(figure, axes, path)


FIGURES: dict[str, Callable[[Path, int, Path], None]] = {
    "3": draw_thresholds,
    "5": draw_warping,
    "7": draw_levels,
    "8": draw_overdraw,
    "9": draw_surfaces,
    "10": draw_bounds,
}
