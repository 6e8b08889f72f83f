# SPDX-License-Identifier: BSD-3-Clause
"""The caustics of a metal ring, beside it the path tracer's, and of a ball of glass, for gallery.py.

On the left a ring of VTK's PBR metal with 4096 virtual lights, on the right a ball of glass. Between
them the irradiance of Testing/Scenes/ring_caustic.json, whose ring is of Phong's model: by 4096 virtual
lights, and path traced (R2), four times as bright as it is. Prints how far the first is from the
second, with 256 lights, too.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import numpy as np
import vtkindirect
from vtkindirect import images
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "Testing" / "Scenes" / "ring_caustic.json"
REFERENCE = ROOT / "Testing" / "Reference" / "data" / "ring_caustic.exr"
SIZE = 256
METAL = {
    "interpolation": "pbr",
    "metallic": 1.0,
    "roughness": 0.15,
    "color": [0.95, 0.75, 0.4],
    "diffuse": 1.0,
}
GLASS = {
    "name": "ball",
    "source": "sphere",
    "center": [0.45, 0.42, 0],
    "radius": 0.4,
    "resolution": 96,
    "color": [1.0, 1.0, 1.0],
    "opacity": 0.15,
    "interpolation": "pbr",
    "refraction_index": 1.5,
    "roughness": 0.15,
}
BRIGHTER = 4.0
GAP = 4


def load(size: int, material: dict | None = None, ball: bool = False) -> vtkindirect.Scene:
    """The scene, its ring of another material where one is given, or a ball of glass in its place."""
    values = json.loads(SCENE.read_text(encoding="utf-8"))
    values["size"] = [size, size]
    for actor in values["actors"]:
        if actor["name"] == "ring" and material is not None:
            actor.update(material)
    if ball:
        values["actors"] = [actor for actor in values["actors"] if actor["name"] != "ring"] + [GLASS]
    with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
        path = Path(name) / "ring.json"
        path.write_text(json.dumps(values), encoding="utf-8")
        return vtkindirect.load_scene(path)


def render(scene: vtkindirect.Scene, lights: int, buffer: str = "") -> np.ndarray:
    """The picture, bytes, or a buffer, floats; bottom row first."""
    window = scene.make_window()
    vtkindirect.enable(scene, lighting="scene")
    sampler = vtkindirect.vtkLightTreeSampler()
    sampler.SetNumberOfLights(lights)
    vtkindirect.pass_of(scene.renderer).SetSampler(sampler)
    window.Render()
    found = (
        vtkindirect.copy_buffer(scene.renderer, buffer) if buffer else images.window_bytes(window)
    )
    window.Finalize()
    return np.array(found)


def shown(irradiance: np.ndarray) -> np.ndarray:
    """Irradiance as bytes."""
    return (255.0 * np.clip(BRIGHTER * irradiance[..., :3], 0.0, 1.0)).astype(np.uint8)


def read_reference() -> np.ndarray:
    """The path tracer's irradiance of one bounce, R2; bottom row first."""
    reader = vtkindirect.vtkOpenEXRReader()
    reader.SetFileName(str(REFERENCE))
    reader.SetLayer("R2")
    reader.Update()
    image = reader.GetOutput()
    width, height, _depth = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return values[..., :3].astype(np.float64)


def picture() -> np.ndarray:
    """Render, print how far from the reference that is, and put the parts side by side."""
    traced = read_reference()
    for count in (256, 4096):
        found = render(load(traced.shape[1]), count, "irradiance")[..., :3]
        difference = np.sqrt(np.mean((found - traced) ** 2))
        print(
            f"ring, {count} lights: mean {found.mean() / traced.mean():.3f} of R2's, "
            f"RMS difference {difference / np.sqrt(np.mean(traced**2)):.3f} of its RMS"
        )
    ratio = SIZE // traced.shape[1]
    parts = [
        render(load(SIZE, METAL), 4096),
        shown(render(load(SIZE), 4096, "irradiance")),
        shown(np.repeat(np.repeat(traced, ratio, axis=0), ratio, axis=1)),
        render(load(SIZE, ball=True), 4096),
    ]
    gap = np.full((SIZE, GAP, 3), 255, dtype=np.uint8)
    return np.hstack([part for one in parts for part in (gap, one)][1:])
