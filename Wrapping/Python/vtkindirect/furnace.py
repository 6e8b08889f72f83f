# SPDX-License-Identifier: BSD-3-Clause
"""The white furnace: surfaces that reflect all light, under a sky of 1, have an irradiance of 1.

Every surface then sees a radiance of 1 in every direction, from the sky or from other surfaces,
whatever the geometry. Less than 1 is light that a method loses, more than 1 light that it invents.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import VTK_PBR, VTK_PHONG, vtkActor, vtkProperty

from vtkindirect import area_lights, environments, frames, images, wrapped
from vtkindirect.errors import RenderError
from vtkindirect.frames import Job, Step
from vtkindirect.scene import Scene

PERCENTILES = (1, 50, 99)


@dataclass(frozen=True)
class Furnace:
    """Irradiance at the pixels with a surface; 1 is right."""

    irradiance: np.ndarray
    """height x width x 3, float32, bottom row first; 0 where there is no surface."""
    surfaces: np.ndarray
    """height x width, true at pixels with a surface."""

    @property
    def values(self) -> np.ndarray:
        """The mean of the three channels at each pixel with a surface."""
        return self.irradiance[self.surfaces].mean(axis=1, dtype=np.float64)

    def line(self, name: str) -> str:
        """One line for people: mean, least, percentiles and largest."""
        values = self.values
        few = ", ".join(f"{p} % {np.percentile(values, p):.3f}" for p in PERCENTILES)
        return (
            f"{name}: mean {values.mean():.4f}, least {values.min():.3f}, {few}, "
            f"largest {values.max():.3f} of 1 at {len(values)} pixels"
        )


def whiten_actor(actor: vtkActor) -> None:
    """Let an actor reflect all light evenly, whatever its colours, scalars and textures say."""
    before = actor.GetProperty()
    white = vtkProperty()
    white.DeepCopy(before)
    white.RemoveAllTextures()
    white.SetColor(1.0, 1.0, 1.0)
    white.SetAmbient(0.0)
    white.SetDiffuse(1.0)
    white.SetSpecular(0.0)
    white.SetOpacity(1.0)
    if white.GetInterpolation() == VTK_PBR:
        white.SetInterpolation(VTK_PHONG)
    actor.SetProperty(white)
    actor.SetBackfaceProperty(None)
    actor.SetTexture(None)
    mapper = actor.GetMapper()
    if mapper is None:
        return
    mapper.ScalarVisibilityOff()
    if hasattr(mapper, "SetAtomColorMode"):
        mapper.SetAtomColorMode(mapper.SingleColor)
        mapper.SetAtomColor(255, 255, 255)
        mapper.SetBondColorMode(mapper.SingleColor)
        mapper.SetBondColor(255, 255, 255)
    blocks = getattr(mapper, "GetCompositeDataDisplayAttributes", lambda: None)()
    if blocks is not None:
        blocks.RemoveBlockColors()
        blocks.RemoveBlockOpacities()


def prepare(scene: Scene) -> None:
    """Make all surfaces of a scene white and a uniform sky of 1 its only light."""
    found = scene.renderer.GetActors()
    for i in range(found.GetNumberOfItems()):
        whiten_actor(found.GetItemAsObject(i))
    scene.renderer.RemoveAllLights()
    area_lights.detach_all(scene.renderer)
    sky = wrapped.get(environments.CLASS)()
    sky.SetRadiance(1.0, 1.0, 1.0)
    environments.attach(scene.renderer, sky)


def measure(scene: Scene, window: Any, job: Job, step: Step = frames.no_step) -> Furnace:
    """Render the furnace of a scene in its window; raises `RenderError` where no surface is seen."""
    prepare(scene)
    frames.render(scene, window, job, step)
    irradiance = images.copy_buffer(scene.renderer, "irradiance")
    normal = images.copy_buffer(scene.renderer, "normal")
    found = Furnace(irradiance, np.linalg.norm(normal, axis=-1) > 0.5)
    if not found.surfaces.any():
        raise RenderError(f"{scene.name}: no surface is in the picture")
    return found
