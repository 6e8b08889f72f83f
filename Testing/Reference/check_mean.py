#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares R1, the project's own sum over a map's texels, with the path tracer; see compare().

    check_mean.py [SCENE...] [--size W] [--maps N]

SCENE is a name in Testing/Scenes or a scene file; default: cornell_box. Prints a table and exits
with 1 where R1 and the tracer without visibility differ by more than 3 % in the mean.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import exporter
import tools

LIMIT = 0.03
LAYERS = 64


@dataclass(frozen=True)
class Means:
    """Mean irradiance over receivers that both see: R1, traced without and with visibility.

    `typical`: the median over pixels of |R1 - open| / open, where open is above a tenth of its
    mean; `open_noise` the tracer's own standard error of its mean.
    """

    pixels: int
    r1: float
    open: float
    visible: float
    typical: float
    open_noise: float


def sum_over_texels(path: Path, size: tuple[int, int], texels: int) -> tuple:
    """Draw a scene with R1; returns its description, irradiance and depth."""
    import vtkindirect

    scene = vtkindirect.load_scene(path)
    window = scene.make_window(size)
    vtkindirect.enable(scene.renderer)
    indirect = vtkindirect.pass_of(scene.renderer)
    indirect.SetEstimator(vtkindirect.vtkRSMReferencePass())
    indirect.SetReflectiveShadowMapResolution(texels)
    window.Render()
    images = [vtkindirect.copy_buffer(scene.renderer, name) for name in ("irradiance", "depth")]
    found = exporter.export_renderer(scene.renderer, scene.name, size, scene.actors.items())
    window.Finalize()
    return found, *images


def compare(path: Path, width: int, texels: int, samples: int = 256) -> Means:
    """Compute R1, and one bounce by the tracer without and with visibility."""
    import vtkindirect

    shape = vtkindirect.load_scene(path).size
    size = (width, max(1, round(width * shape[1] / shape[0])))
    found, r1, depth = sum_over_texels(path, size, texels)
    with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
        folder = Path(name)
        found.save(folder)
        batches = [
            {"file": f"{kind}{k}.npz", "kind": kind, "depth": layers, "seed": [k]}
            for kind, layers in (("open", LAYERS), ("bounces", 1))
            for k in range(2)
        ]
        for batch in batches:
            batch["samples"] = samples
        job = {"size": list(size), "surfaces": "surfaces.npz", "batches": batches}
        tools.trace(folder, job)
        with np.load(folder / "surfaces.npz") as arrays:
            traced = dict(arrays)
        images = [np.load(folder / batch["file"])["image"] for batch in batches]
    mask = (traced["valid"] > 0) & (
        np.abs(traced["depth"] - depth[..., 0]) <= 5e-3 * np.abs(depth[..., 0])
    )
    opened, visible = 0.5 * (images[0] + images[1]), 0.5 * (images[2] + images[3])
    r1, value = r1[mask].mean(axis=-1), opened[mask].mean(axis=-1)
    bright = value > 0.1 * value.mean()
    return Means(
        int(mask.sum()),
        float(r1.mean()),
        float(value.mean()),
        float(visible[mask].mean()),
        float(np.median(np.abs(r1 - value)[bright] / value[bright])),
        abs(float(images[0][mask].mean() - images[1][mask].mean())) / 2,
    )


def main() -> int:
    """Compare the scenes of the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=["cornell_box"])
    parser.add_argument("--size", type=int, default=128, help="width in pixels")
    parser.add_argument("--maps", type=int, default=256, help="texels along a map's edge")
    options = parser.parse_args()
    columns = ("pixels", "R1", "open", "R1/open", "typical", "visible", "R1/visible")
    print(f"{'scene':20}" + "".join(f"{column:>11}" for column in columns))
    good = True
    for name in options.scenes:
        path = Path(name) if name.endswith(".json") else tools.SCENES / f"{name}.json"
        try:
            means = compare(path, options.size, options.maps)
        except (tools.ToolError, exporter.ExportError) as error:
            return tools.fail(error)
        ratio = means.r1 / means.open
        good &= abs(ratio - 1.0) <= LIMIT
        print(
            f"{path.stem:20}{means.pixels:11d}{means.r1:11.5f}{means.open:11.5f}{ratio:11.4f}"
            f"{100 * means.typical:10.2f}%{means.visible:11.5f}{means.r1 / means.visible:11.4f}",
            flush=True,
        )
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
