#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lights of a tree beside even ones: error against time, and how many nodes receivers sum.

    Testing/Benchmark/light_tree.py [--size WxH] [--frames N] FILE.png SCENE...

The gather at every pixel with nothing hidden, so that what differs is the lights: even ones by their
number, and those of the tree by their number and by `ErrorTolerance`. Errors are mean squared
relative ones to the sum over all texels; times are processor time of the frame. Prints a page, with
the mean and the 95th percentile of the nodes that receivers sum, by the buffers `lights` and
`branches`.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import plot
import vtkindirect
from vtkindirect import frames, images, methods
from vtkindirect.scene import Scene

PER_NODE = 8
FAMILY = PER_NODE + 1
RECEIVERS = 2000
EVEN = (64, 128, 256, 512, 1024)
TREE = (32, 64, 128, 256, 512)
TOLERANCES = (0.005, 0.01, 0.02, 0.05, 0.1)
FLOOR = 1e-2
"""Share of the mean that is added to the divisor of relative errors."""


@dataclass
class Row:
    """One choice of lights: its time, its error, and nodes where there is a tree."""

    name: str
    seconds: float
    error: float
    bias: float
    nodes: tuple[float, float] | None = None


def render(scene: Scene, count: int) -> tuple[np.ndarray, float]:
    """Return the irradiance, and the median processor time of frames."""
    seconds = []
    for _ in range(count + 1):
        begin = time.process_time()
        scene.render_window.Render()
        seconds.append(time.process_time() - begin)
    return vtkindirect.copy_buffer(scene.renderer, "bounce"), float(np.median(seconds[1:]))


def receivers(scene: Scene) -> np.ndarray:
    """Return places that the eye sees, evenly chosen, in world units."""
    depth = vtkindirect.copy_buffer(scene.renderer, "depth")[..., 0]
    height, width = depth.shape
    camera = scene.renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, 0.0, 1.0)
    projection = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    eye = np.array(camera.GetPosition())
    forward = np.array(camera.GetDirectionOfProjection())
    inverse = np.linalg.inv(projection)
    there = np.argwhere(depth > 0.0)
    there = there[:: max(1, len(there) // RECEIVERS)]
    ndc = np.stack([
        2.0 * (there[:, 1] + 0.5) / width - 1.0,
        2.0 * (there[:, 0] + 0.5) / height - 1.0,
        np.full(len(there), 0.5),
        np.ones(len(there)),
    ])  # fmt: skip
    points = inverse @ ndc
    ways = (points[:3] / points[3]).T - eye
    along = ways @ forward
    return eye + ways * (depth[there[:, 0], there[:, 1]] / along)[:, np.newaxis]


def count_nodes(scene: Scene) -> tuple[float, float]:
    """Return the mean and the 95th percentile of the nodes that receivers sum."""
    lights = vtkindirect.copy_buffer(scene.renderer, "lights").reshape(-1, 12)
    branches = vtkindirect.copy_buffer(scene.renderer, "branches").reshape(
        len(lights), PER_NODE, FAMILY, 12
    )
    exists = branches[..., 7] >= 0.0
    counts = []
    for place in receivers(scene):
        near = np.linalg.norm(lights[:, :3] - place, axis=1) < lights[:, 7]
        children = branches[near][:, :, 0]
        nearer = np.linalg.norm(children[..., :3] - place, axis=-1) < children[..., 7]
        counts.append(
            len(lights) + exists[near][:, :, 0].sum() + exists[near][:, :, 1:][nearer].sum()
        )
    return float(np.mean(counts)), float(np.percentile(counts, 95))


def measure(path: str, size: tuple[int, int], count: int) -> list[Row]:
    """Return the rows of a scene."""
    scene = vtkindirect.load_scene(path)
    frames.open_window(scene, size)
    common = {
        "Visibility": "none",
        "Interpolation": False,
        "Caching": False,
        "NumberOfBounces": 1,
    }

    def show(sampler: str, **settings: Any) -> tuple[np.ndarray, float]:
        methods.enable(scene.renderer, "gather", sampler, **common, **settings)
        return render(scene, count)

    truth, _ = show("uniform", Mode="all_texels")
    mean = truth.mean()

    def judge(name: str, found: tuple[np.ndarray, float], tree: bool) -> Row:
        image, seconds = found
        error = ((image - truth) ** 2 / (truth**2 + FLOOR * mean**2)).mean()
        bias = image.mean() / mean - 1.0
        return Row(name, seconds, float(error), float(bias), count_nodes(scene) if tree else None)

    rows = [
        judge(f"even {n}", show("uniform", Mode="virtual_lights", NumberOfLights=n), False)
        for n in EVEN
    ]
    rows += [judge(f"tree {n}", show("tree", NumberOfLights=n), True) for n in TREE]
    rows += [
        judge(f"tolerance {t}", show("tree", NumberOfLights=256, ErrorTolerance=t), True)
        for t in TOLERANCES
    ]
    scene.render_window.Finalize()
    return rows


def draw(found: dict[str, list[Row]], path: Path) -> None:
    """Write the plot: error against time, a panel for each scene."""
    pyplot = plot.require_plots()
    figure, axes = pyplot.subplots(1, len(found), figsize=(4.3 * len(found), 4.2), squeeze=False)
    for (name, rows), axis in zip(found.items(), axes[0]):
        for kind, label, style in (
            ("even", "even lights", "o-"),
            ("tree", "tree, by its number of lights", "s-"),
            ("tolerance", "tree, by ErrorTolerance", "^--"),
        ):
            chosen = [row for row in rows if row.name.startswith(kind)]
            axis.loglog([row.seconds for row in chosen], [row.error for row in chosen], style,
                        label=label)  # fmt: skip
            for row in chosen:
                axis.annotate(row.name.split()[1], (row.seconds, row.error), fontsize=7,
                              xytext=(3, 3), textcoords="offset points")  # fmt: skip
        axis.set_title(name)
        axis.set_xlabel("processor time of a frame, s")
        axis.grid(True, which="both", alpha=0.3)
    axes[0][0].set_ylabel("mean squared relative error to all texels")
    axes[0][-1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, draw, print the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=Path)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--size", default="192x192")
    parser.add_argument("--frames", type=int, default=3)
    given = parser.parse_args(arguments)
    images.check_output(given.file, (".png",))
    width, height = (int(n) for n in given.size.split("x"))
    found = {
        Path(scene).stem: measure(scene, (width, height), given.frames) for scene in given.scenes
    }
    draw(found, given.file)
    print("| scene | lights | time, s | error | of the mean | nodes: mean | nodes: 95 % |")
    print("|---|---|---|---|---|---|---|")
    for name, rows in found.items():
        for row in rows:
            nodes = ["", ""] if row.nodes is None else [f"{value:.0f}" for value in row.nodes]
            print(f"| {name} | {row.name} | {row.seconds:.3f} | {row.error:.4f} "
                  f"| {100 * row.bias:+.1f} % | {nodes[0]} | {nodes[1]} |")  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main())
