# SPDX-License-Identifier: BSD-3-Clause
"""The lights of a scene file. One row of `LIGHTS` is one type of light."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit, vtkRenderer

from vtkindirect import area_lights, environments, wrapped
from vtkindirect.errors import SceneError, UsageError
from vtkindirect.schema import member

Values = dict[str, Any]

_PASS = "vtkIndirectIlluminationPass"

# VTK takes a cone angle of 90 degrees or more for a light without a cone.
_NO_CONE = 180.0


def _light(values: Values) -> vtkLight:
    light = vtkLight()
    light.SetColor(values["color"])
    light.SetIntensity(values["intensity"])
    light.SetLightTypeToSceneLight()
    return light


def _set_size(light: vtkLight, name: str, size: float) -> None:
    """Give a light its own size, which is kept with it; VTK has none."""
    # Without the module nothing draws shadows that a size could soften.
    if size > 0.0 and wrapped.has(_PASS):
        getattr(wrapped.get(_PASS), f"SetLight{name}")(light, size)


def _positional(values: Values) -> vtkLight:
    light = _light(values)
    _set_size(light, "Radius", values["radius"])
    light.PositionalOn()
    light.SetPosition(values["position"])
    light.SetAttenuationValues(values["attenuation"])
    return light


def _spot(renderer: vtkRenderer, values: Values) -> None:
    light = _positional(values)
    light.SetFocalPoint(values["focal_point"])
    light.SetConeAngle(values["cone_angle"])
    light.SetExponent(values["exponent"])
    renderer.AddLight(light)


def _point(renderer: vtkRenderer, values: Values) -> None:
    light = _positional(values)
    x, y, z = values["position"]
    light.SetFocalPoint(x, y - 1.0, z)
    light.SetConeAngle(_NO_CONE)
    renderer.AddLight(light)


def _directional(renderer: vtkRenderer, values: Values) -> None:
    light = _light(values)
    light.PositionalOff()
    light.SetPosition(0.0, 0.0, 0.0)
    light.SetFocalPoint(values["direction"])
    _set_size(light, "Angle", values["angle"])
    renderer.AddLight(light)


def _headlight(renderer: vtkRenderer, values: Values) -> None:
    light = _light(values)
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)


def add_light_kit(renderer: vtkRenderer, intensity: float = 1.0) -> None:
    """Add VTK's light kit: five lights without a position that move with the camera."""
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(kit.GetKeyLightIntensity() * intensity)
    kit.AddLightsToRenderer(renderer)


def _light_kit(renderer: vtkRenderer, values: Values) -> None:
    add_light_kit(renderer, values["intensity"])


def _environment(renderer: vtkRenderer, values: Values) -> None:
    environments.attach(renderer, environments.build(values))


def _area(renderer: vtkRenderer, values: Values) -> None:
    area_lights.attach(renderer, area_lights.build(values))


FILES = ("file", "texture")
"""Keys of lights that name a file."""

LIGHTS: dict[str, Callable[[vtkRenderer, Values], None]] = {
    "spot": _spot,
    "point": _point,
    "directional": _directional,
    "headlight": _headlight,
    "light_kit": _light_kit,
    "environment": _environment,
    "area": _area,
}


def add(renderer: vtkRenderer, values: Values, path: str, directory: Path) -> None:
    """Add a checked light to a renderer. Files are relative to `directory`.

    `path` is the light's place in the scene file, for the error of a file that cannot be read.
    """
    named = next((key for key in FILES if key in values), "")
    if named:
        values = {**values, named: directory / values[named]}
    try:
        LIGHTS[values["type"]](renderer, values)
    except UsageError as error:
        raise SceneError(f"{member(path, named)}: {error}" if named else str(error)) from None
