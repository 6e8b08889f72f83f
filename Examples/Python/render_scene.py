#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Loads a scene file, renders it off screen and reads the indirect light as an array.

Usage: render_scene.py SCENE_OR_DATA
"""

import sys

import vtkindirect

if len(sys.argv) != 2:
    sys.exit("usage: render_scene.py SCENE_OR_DATA")
try:
    scene = vtkindirect.load_scene(sys.argv[1])
except vtkindirect.IndirectError as error:
    sys.exit(f"render_scene.py: {error}")
window = scene.make_window()
vtkindirect.enable(scene.renderer, "gather", number_of_lights=512)
window.Render()

direct = vtkindirect.copy_buffer(scene.renderer, "direct")[..., :3]
indirect = vtkindirect.copy_buffer(scene.renderer, "indirect")[..., :3]
part = indirect.sum() / (direct.sum() + indirect.sum())
print(f"{scene.name}: {part:.1%} of the light is indirect")
for item in vtkindirect.report(scene.renderer)["left_out"]:
    print(f"left out: {item['what']}, {item['why']}")
