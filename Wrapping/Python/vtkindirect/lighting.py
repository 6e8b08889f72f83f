# SPDX-License-Identifier: BSD-3-Clause
"""Which lighting a renderer gets: a preset of the pass, or what suits the lights that it has."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

from vtkindirect import settings
from vtkindirect.errors import UsageError, check_text, unknown

AUTO = "auto"
PRESETS = ("scene", "soft", "full", "gentle", "studio")
NAMES = (AUTO, *PRESETS)

PROPERTY = "Lighting"

# vtkLightKit has a headlight and, of lights that stand still beside the camera, a key, a fill and
# two at the back; so has PyVista's.
_KIT = {"headlight": 1, "camera": 4}


def check(name: str) -> str:
    """Return the name of a lighting that is known."""
    check_text("lighting", name)
    if name not in NAMES:
        raise UsageError(unknown("lighting", name, NAMES))
    return name


def is_property(name: str) -> bool:
    """Whether a setting's name is that of the pass's property."""
    return settings.camel(name).lower() == PROPERTY.lower()


def _lights(renderer: vtkRenderer) -> list[vtkLight]:
    """Return the lights that are on."""
    found = renderer.GetLights()
    lights = [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]
    return [light for light in lights if light.GetSwitch()]


def _is_as_made_by_vtk(light: vtkLight) -> bool:
    """Whether a light is as the one that VTK makes for a renderer without any."""
    return (
        bool(light.LightTypeIsHeadlight())
        and not light.GetPositional()
        and light.GetIntensity() == 1.0
        and tuple(light.GetDiffuseColor()) == (1.0, 1.0, 1.0)
    )


def _is_kit(lights: list[vtkLight]) -> bool:
    if any(light.GetPositional() or light.LightTypeIsSceneLight() for light in lights):
        return False
    headlights = sum(1 for light in lights if light.LightTypeIsHeadlight())
    return {"headlight": headlights, "camera": len(lights) - headlights} == _KIT


def _has_image_light(renderer: vtkRenderer) -> bool:
    if not renderer.GetUseImageBasedLighting():
        return False
    # VTK has harmonics since 9.2, and from 9.4 on needs no texture beside them.
    harmonics = getattr(renderer, "GetSphericalHarmonics", lambda: None)()
    return renderer.GetEnvironmentTexture() is not None or harmonics is not None


def choose(
    renderer: vtkRenderer, environment: Any = None, area_lights: int = 0
) -> tuple[str, str]:
    """Return the preset that "auto" stands for, and why.

    That is "full" where nobody has chosen the renderer's lights, else "scene". `environment` is the
    pass's, or None, and `area_lights` how many it has.
    """
    if environment is not None:
        return "scene", "an environment is set"
    if area_lights > 0:
        return "scene", "there are area lights"
    if _has_image_light(renderer):
        return "scene", "the renderer has image-based lighting"
    lights = _lights(renderer)
    automatic = bool(renderer.GetAutomaticLightCreation())
    if not lights:
        if automatic:
            return "full", "the renderer has no light but the headlight that VTK gives it"
        return "scene", "the renderer has no light and is to have none"
    if len(lights) == 1 and automatic and _is_as_made_by_vtk(lights[0]):
        return "full", "the renderer has no light but VTK's own headlight"
    if _is_kit(lights):
        return "full", "the renderer has no light but those of a light kit"
    return "scene", "somebody has placed the renderer's lights"
