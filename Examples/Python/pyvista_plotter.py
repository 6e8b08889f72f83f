#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A PyVista plotter with indirect light. Needs PyVista; writes pyvista_plotter.png."""

import sys

try:
    import pyvista
except ImportError as error:
    sys.exit(f"pyvista_plotter.py: needs PyVista (python3 -m pip install pyvista): {error}")

import vtkindirect

if not vtkindirect.has_display():
    vtkindirect.use_headless()

plotter = pyvista.Plotter(off_screen=True, lighting="none", window_size=(640, 480))
plotter.add_mesh(pyvista.Plane(i_size=4, j_size=4), color="red")
plotter.add_mesh(pyvista.Sphere(radius=0.6, center=(0, 0, 0.7)), color="white", smooth_shading=True)
plotter.add_light(
    pyvista.Light(
        position=(2, 2, 4), focal_point=(0, 0, 0), positional=True, cone_angle=40, exponent=0
    )
)
vtkindirect.enable(plotter)  # with PyVista 0.48 or later also: plotter.indirect.enable()
plotter.screenshot("pyvista_plotter.png")
