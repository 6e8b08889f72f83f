# SPDX-License-Identifier: BSD-3-Clause
"""The lights of a scene file. One row of `LIGHTS` is one type of light."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit, vtkRenderer

from vtkindirect.fields import (
    Field,
    Table,
    array,
    check_keys,
    check_table,
    choice,
    color,
    direction,
    fail,
    member,
    number,
    point,
    required,
)

Values = dict[str, Any]

# VTK takes a cone angle of 90 degrees or more for a light without a cone.
_NO_CONE = 180.0


def _attenuation(value: Any, path: str) -> list[float]:
    """c, l, q of 1 / (c + l d + q d^2), at least one of them greater than 0."""
    result = array(number(minimum=0), length=3)(value, path)
    if not any(result):
        raise fail(path, "must not be all zero")
    return result


def _light(values: Values) -> vtkLight:
    light = vtkLight()
    light.SetColor(values["color"])
    light.SetIntensity(values["intensity"])
    light.SetLightTypeToSceneLight()
    return light


def _positional(values: Values) -> vtkLight:
    light = _light(values)
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


@dataclass(frozen=True)
class Light:
    """What a type of light is and its keys; a type that is not built has no `add`."""

    meaning: str
    fields: Table
    add: Callable[[vtkRenderer, Values], None] | None = None


_strength = {
    "color": Field(color, (1.0, 1.0, 1.0)),
    "intensity": Field(number(minimum=0), 1.0),
}
_place = {
    "position": required(point),
    **_strength,
    "attenuation": Field(_attenuation, (1.0, 0.0, 0.0)),
}

LIGHTS = {
    "spot": Light(
        "a cone of light from a point",
        {
            **_place,
            "focal_point": required(point),
            "cone_angle": Field(number(above=0, below=90), 30.0),
            "exponent": Field(number(minimum=0, maximum=128), 0.0),
        },
        _spot,
    ),
    "point": Light("light from a point in all directions", _place, _point),
    "directional": Light(
        "parallel light", {"direction": required(direction), **_strength}, _directional
    ),
    "headlight": Light("parallel light along the view", _strength, _headlight),
    "light_kit": Light("VTK's light kit", {"intensity": Field(number(minimum=0), 1.0)}, _light_kit),
    "area": Light("light from a rectangle", {}),
    "environment": Light("light from all around, given by an image", {}),
}


def check(value: Any, path: str) -> tuple[str, Values]:
    """Check one light; gives its type and its values."""
    if not isinstance(value, dict):
        check_keys(value, path, ())
    if "type" not in value:
        raise fail(member(path, "type"), "is missing")
    kind = choice(*LIGHTS)(value["type"], member(path, "type"))
    row = LIGHTS[kind]
    if row.add is None:
        raise fail(member(path, "type"), f"lights of type '{kind}' are not built in this version")
    values = check_table(value, path, {"type": Field(choice(kind)), **row.fields})
    if kind == "spot" and values["focal_point"] == values["position"]:
        raise fail(member(path, "focal_point"), "must differ from position")
    return kind, values


def add(renderer: vtkRenderer, light: tuple[str, Values]) -> None:
    """Add a checked light to a renderer."""
    kind, values = light
    row = LIGHTS[kind]
    assert row.add is not None
    row.add(renderer, values)
