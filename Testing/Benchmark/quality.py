#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the words of `quality` on a knot above a table in PyVista's light kit.

    quality.py [PICTURE.png]

For each word it prints the processor time of a frame over that of plain VTK, the camera turning by
less than a pixel, as part of that of "interactive"; and the RMS error of the picture's light over
its mean, to 2048 virtual lights, 1024 directions of the sky and an error tolerance of 0.002. The
picture shows the words side by side. `quality.json` is the same for scenes with path-traced references.
"""

from __future__ import annotations

import statistics
import sys
import time
from typing import Any

import numpy as np

import vtkindirect
from vtkindirect import images, qualities, screenshot, windows

FRAMES = 9
BEST = {"NumberOfLights": 2048, "ErrorTolerance": 0.002, "NumberOfRefinements": 0}


def knot() -> Any:
    """Return a plotter of the knot."""
    import pyvista

    turn = np.linspace(0.0, 2.0 * np.pi, 600)
    radius = 1.2 + 0.5 * np.cos(3.0 * turn)
    curve = np.c_[
        radius * np.cos(2.0 * turn), radius * np.sin(2.0 * turn), -0.6 * np.sin(3.0 * turn)
    ]
    tube = pyvista.Spline(curve, 900).tube(radius=0.22, n_sides=48)
    plotter = pyvista.Plotter(off_screen=True, window_size=(800, 600))
    plotter.set_background("white")
    heights = tube.points[:, 2]
    plotter.add_mesh(tube, scalars=heights, smooth_shading=True, show_scalar_bar=False)
    plotter.add_mesh(pyvista.Plane(center=(0, 0, -0.85), i_size=6, j_size=6), color="white")
    plotter.camera_position = [(3, -4, 3.5), (0, 0, -0.2), (0, 0, 1)]
    return plotter


def measure(**words: Any) -> tuple[float, np.ndarray, np.ndarray]:
    """Return the milliseconds of a frame, the picture, and its light."""
    plotter = knot()
    vtkindirect.enable(plotter, **words)
    picture = screenshot(plotter)
    light = np.zeros(0)
    if words.get("method") != "off":
        light = images.copy_buffer(plotter, "final")
    times = []
    for _ in range(FRAMES):
        plotter.renderer.GetActiveCamera().Azimuth(1e-6)
        begin = time.process_time()
        plotter.render_window.Render()
        plotter.render_window.WaitForCompletion()
        times.append(1000.0 * (time.process_time() - begin))
    plotter.close()
    return statistics.median(times), picture, light


def main() -> int:
    """Print the table; returns the exit code."""
    if not windows.has_display():
        vtkindirect.use_headless()
    plain = measure(method="off")[0]
    best = measure(**BEST)[2]
    mean = best[best > 0.0].mean()
    found = {name: measure(quality=name) for name in qualities.NAMES}
    added = found[qualities.DEFAULT][0] - plain
    for name, (frame, _, light) in found.items():
        error = np.sqrt(np.square(light - best)[best > 0.0].mean()) / mean
        print(f"{name:12s} time {(frame - plain) / added:.2f} error {error:.4f}")
    if len(sys.argv) > 1:
        row = np.hstack([picture[::-1] for _, picture, _ in found.values()])
        images.write_png(images.check_output(sys.argv[1], (".png",)), row)
    return 0


if __name__ == "__main__":
    sys.exit(main())
