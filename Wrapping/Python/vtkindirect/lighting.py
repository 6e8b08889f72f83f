# SPDX-License-Identifier: BSD-3-Clause
"""Choice of a renderer's lighting: a preset of the pass, or the one that suits its lights."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

from vtkindirect import settings
from vtkindirect.errors import UsageError, check_text, unknown

AUTO = "auto"
SCENE = "scene"
PRESETS = (SCENE, "soft", "full", "gentle", "studio")
NAMES = (AUTO, *PRESETS)
FOLLOWING = "studio"
"""The preset of "auto" where all lights follow the camera."""

PROPERTY = "Lighting"


def check(name: str) -> str:
    """Return the name of a lighting that is known."""
    check_text("lighting", name)
    if name not in NAMES:
        raise UsageError(unknown("lighting", name, NAMES))
    return name


def is_property(name: str) -> bool:
    """Return whether a setting's name is that of the pass's property."""
    return settings.camel(name).lower() == PROPERTY.lower()


def lights_of(renderer: vtkRenderer) -> list[vtkLight]:
    """Return the lights that are on."""
    found = renderer.GetLights()
    lights = [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]
    return [light for light in lights if light.GetSwitch()]


def follows_camera(light: vtkLight) -> bool:
    """Return whether a light stands still beside the camera and lights all that it sees.

    One with a place, a cone or falloff does not: somebody has aimed it.
    """
    return not light.LightTypeIsSceneLight() and not light.GetPositional()


def _shines(light: vtkLight) -> bool:
    """Return whether a light adds something."""
    return light.GetIntensity() > 0.0 and max(light.GetDiffuseColor()) > 0.0


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

    It is `FOLLOWING` where nobody has placed lights in the scene: where it has none but those that
    follow the camera, however many; else "scene". `environment` is the pass's, or None, and
    `area_lights` how many it has.
    """
    if environment is not None:
        return "scene", "an environment is set"
    if area_lights > 0:
        return "scene", "there are area lights"
    if _has_image_light(renderer):
        return "scene", "the renderer has image-based lighting"
    lights = lights_of(renderer)
    if not lights:
        if renderer.GetAutomaticLightCreation():
            return FOLLOWING, "the renderer has no light but the headlight that VTK gives it"
        return "scene", "the renderer has no light and is to have none"
    if not all(follows_camera(light) for light in lights):
        return "scene", "somebody has placed the renderer's lights"
    if not all(_shines(light) for light in lights):
        return "scene", "a light of the renderer adds no light"
    return FOLLOWING, "all lights of the renderer follow its camera"
