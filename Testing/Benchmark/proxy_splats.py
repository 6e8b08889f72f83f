#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Splats that are cut off like spheres: the sky by spheres and by maps, against rays.

    Testing/Benchmark/proxy_splats.py

Particles drawn by vtkPointGaussianMapper over a ground, under a uniform sky. Receivers are places
of the ground, since splats have no surface of their own. Rays meet spheres of the splats' radii.
"""

from __future__ import annotations

import sys

import numpy as np
import vtkindirect
from proxy_pass import Spheres, View, compare, particles, spheres_actor
from vtkindirect import methods
from vtkmodules.vtkRenderingCore import vtkActor, vtkPointGaussianMapper

DIRECTIONS = 256
CODE = """//VTK::Color::Impl
if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) { discard; }
"""


def main() -> int:
    """Print a table."""
    spheres = particles(1000)
    _, data = spheres_actor(spheres)
    mapper = vtkPointGaussianMapper()
    mapper.SetInputData(data)
    mapper.SetScaleFactor(1.0)
    mapper.SetScaleArray("size")
    mapper.EmissiveOff()
    mapper.ScalarVisibilityOff()
    mapper.SetSplatShaderCode(CODE)
    actor = vtkActor()
    actor.SetMapper(mapper)
    box = np.array((spheres[:, :3].min(axis=0), spheres[:, :3].max(axis=0)))
    view = View([actor], box, (320, 240))
    indirect = methods.enable(view.renderer, "proxies", environment=(1.0, 1.0, 1.0))
    view.window.Render()
    (y, x), seen, normals = view.receivers()
    ground = abs(seen[:, 1] - view.plane[4]) < 1e-3 * np.ptp(box[:, 1])
    y, x, seen, normals = y[ground], x[ground], seen[ground], normals[ground]
    rays = Spheres(spheres, view.plane)
    true = np.array([rays.sky(p, n, DIRECTIONS, i) for i, (p, n) in enumerate(zip(seen, normals))])
    print(f"{len(true)} receivers, of which splats leave {true.mean():.3f} of the sky")
    images = {"spheres": vtkindirect.copy_buffer(view.renderer, "sky")[y, x, 0]}
    indirect.SetEstimator(None)
    indirect.SpheresInMotionOff()
    for _ in range(20):
        view.window.Render()
    images["256 maps, still"] = vtkindirect.copy_buffer(view.renderer, "sky")[y, x, 0]
    for label, sky in images.items():
        print(f"| {label} | {compare(sky, true)} |")
    change = images["spheres"].mean() / images["256 maps, still"].mean() - 1.0
    print(f"from maps to spheres the mean changes by {change:+.1%}")
    view.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
