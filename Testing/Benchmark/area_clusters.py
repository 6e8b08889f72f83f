#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Virtual lights of area lights before and after clustering, after figure 2 of "Direct Illumination
from Dynamic Area Lights" (Nichols and Wyman 2009).

    Testing/Benchmark/area_clusters.py [--lights N] [--dense N] FILE.png

Rows: the window of area_apartment, and a slice through a brain. Left: evenly dense sampling, N by N
lights. Middle: those of vtkAreaLightSampler by least and greatest luminance, as in the paper. Right:
its default, by variance. All hold the same light, and dots go with the area that a light represents.
The script prints by how much the sums differ.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

import plot
import slices
from vtkindirect import area_lights, environments, images, methods, windows, wrapped

WINDOW = slices.DATA / "window_evening.exr"
LIGHTS = 256
DENSE = 32
BRAIN = (0.5, 256)
"""The slice, and pixels along its edge."""


@dataclass
class Lights:
    """Virtual lights: places in [0,1] along the rectangle's edges, areas and B A of each."""

    places: np.ndarray
    areas: np.ndarray
    powers: np.ndarray


def find(image: vtkImageData, count: int, min_max: bool) -> Lights:
    """Return the lights of a rectangle of edge 1 that shows an image."""
    lamp = wrapped.get(area_lights.CLASS)()
    lamp.SetOrigin(0.0, 0.0, 1.0)
    lamp.SetPoint1(0.0, 1.0, 1.0)  # towards the floor
    lamp.SetPoint2(1.0, 0.0, 1.0)
    lamp.SetImage(image)
    sampler = wrapped.get("vtkAreaLightSampler")()
    sampler.AddLight(lamp)
    sampler.SetNumberOfLights(count)
    sampler.SetClustering(int(min_max))
    floor = vtkPlaneSource()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(floor.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    renderer.AddActor(actor)
    window = windows.render_window((16, 16), offscreen=True)
    window.AddRenderer(renderer)
    indirect = methods.enable(renderer, "gather", lighting="scene")
    indirect.SetVisibilityToNone()
    indirect.AddSampler(sampler)
    window.Render()
    # A row of three texels: position, area; normal; B A.
    rows = images.copy_buffer(renderer, "lights").reshape(-1, 3, 4)
    rows = rows[rows[:, 0, 3] > 0.0]
    window.Finalize()
    return Lights(rows[:, 0, [1, 0]], rows[:, 0, 3], rows[:, 2, :3])


def values_of(image: vtkImageData) -> np.ndarray:
    """Return an image as height x width x 3."""
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(np.float64)
    return values.reshape(height, width, -1)[..., :3]


def dense(image: vtkImageData, edge: int) -> Lights:
    """Return edge x edge lights at equal distances, of the light around each."""
    values = values_of(image)
    height, width, _ = values.shape

    def shares(pixels: int) -> np.ndarray:
        lower = np.arange(edge)[:, None] / edge
        first = np.arange(pixels)[None, :] / pixels
        inside = np.minimum(lower + 1.0 / edge, first + 1.0 / pixels) - np.maximum(lower, first)
        return np.maximum(inside, 0.0)

    sums = np.einsum("ij,jkc,lk->ilc", shares(height), values, shares(width))
    middles = (np.arange(edge) + 0.5) / edge
    x, y = np.meshgrid(middles, middles)
    places = np.stack((x, y), axis=-1).reshape(-1, 2)
    return Lights(places, np.full(edge * edge, 1.0 / edge**2), sums.reshape(-1, 3))


def as_floats(image: vtkImageData) -> vtkImageData:
    """Return an image whose values are radiances."""
    values = values_of(image)
    if values.max() > 1.0 and image.GetScalarTypeAsString() == "unsigned char":
        values = values / 255.0
    result = vtkImageData()
    result.SetDimensions(image.GetDimensions())
    scalars = numpy_to_vtk(values.reshape(-1, 3).astype(np.float32), deep=1)
    result.GetPointData().SetScalars(scalars)
    return result


def draw(axis: Any, image: vtkImageData, lights: Lights, title: str) -> None:
    """Draw lights as dots over the image."""
    picture = values_of(image)
    axis.imshow(
        np.clip(picture / picture.max(), 0.0, 1.0) ** (1.0 / 2.2),
        origin="lower", extent=(0, 1, 0, 1), interpolation="nearest",
    )  # fmt: skip
    # Points are 1/72 inch; an axis is 3 inches wide. A third of the edge of a light's square.
    sizes = lights.areas * (3.0 * 72.0 * 0.33) ** 2
    axis.scatter(
        lights.places[:, 0], lights.places[:, 1], s=np.maximum(sizes, 1.5),
        c="#ffd21f", edgecolors="black", linewidths=0.35,
    )  # fmt: skip
    axis.set(xticks=(), yticks=(), xlim=(0, 1), ylim=(0, 1), aspect="equal")
    axis.set_title(title, fontsize=9)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n\n", maxsplit=1)[0])
    parser.add_argument("file", type=Path, metavar="FILE.png")
    parser.add_argument("--lights", type=int, default=LIGHTS)
    parser.add_argument("--dense", type=int, default=DENSE)
    options = parser.parse_args(arguments)
    pyplot = plot.require_plots()
    pictures = {
        "window": as_floats(environments.read_picture(WINDOW)),
        "brain": as_floats(slices.as_image(slices.slice_of("brain", *BRAIN))),
    }
    figure, axes = pyplot.subplots(2, 3, figsize=(9.4, 6.7))
    for (name, image), (left, *others) in zip(pictures.items(), axes):
        before = dense(image, options.dense)
        draw(left, image, before, f"{name}: {len(before.areas)} lights, evenly")
        for axis, (how, min_max) in zip(others, (("least and greatest", True), ("variance", False))):
            after = find(image, options.lights, min_max)
            draw(axis, image, after, f"{name}: {len(after.areas)} lights, {how}")
            sums = before.powers.sum(axis=0), after.powers.sum(axis=0)
            apart = np.abs(sums[1] - sums[0]).max() / sums[0].max()
            print(f"{name}: {len(after.areas)} lights by {how}; sums differ by {apart:.1e}")
    figure.tight_layout(pad=0.6)
    figure.savefig(options.file, dpi=110)
    pyplot.close(figure)
    return 0


if __name__ == "__main__":
    sys.exit(main())
