# SPDX-License-Identifier: BSD-3-Clause
"""A sun and named surroundings of a renderer: what `enable` puts there, and takes away again."""

from __future__ import annotations

import importlib
import reprlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

from vtkindirect import chain, environments, lighting, skies, wrapped
from vtkindirect.errors import UsageError, check_text, unknown
from vtkindirect.keep import KEEP
from vtkindirect.skies import Sun

SUN_ANGLE = 0.27
"""Half of the sun's angle, in degrees, as it is seen from the earth: the softness of its shadow."""
IMPLIED = "overcast"
"""The sky that a sun brings where there is no environment."""

Vector = tuple[float, float, float]

_X, _Y, _Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def _minus(vector: Vector) -> Vector:
    return (-vector[0], -vector[1], -vector[2])


# Up, and what is east and north then: as on a map, with y to the north where z is up.
_AXES: dict[str, tuple[Vector, Vector, Vector]] = {
    "x": (_X, _Y, _Z),
    "-x": (_minus(_X), _Y, _minus(_Z)),
    "y": (_Y, _X, _minus(_Z)),
    "-y": (_minus(_Y), _X, _Z),
    "z": (_Z, _X, _Y),
    "-z": (_minus(_Z), _X, _minus(_Y)),
}
AXES = tuple(_AXES)


def directions(up: str) -> tuple[Vector, Vector, Vector]:
    """Return up, east and north where an axis of `AXES` is up."""
    return _AXES[up]


def check_sun(value: Any) -> Sun | None:
    """Return the sun of an azimuth and an elevation in degrees; None is none."""
    if value is None:
        return None
    pair = value.tolist() if hasattr(value, "tolist") else value
    numbers = isinstance(pair, Sequence) and not isinstance(pair, (str, bytes)) and len(pair) == 2
    if not numbers or not all(environments.is_number(part) for part in pair):
        raise UsageError(
            "sun must be two finite numbers, azimuth and elevation in degrees, or None, "
            f"not {reprlib.repr(value)}"
        )
    azimuth, elevation = (float(part) for part in pair)
    if not 0.0 <= elevation <= 90.0:
        raise UsageError(f"sun: the elevation must be from 0 to 90 degrees, not {elevation:g}")
    return Sun(azimuth % 360.0, elevation)


def check_up(value: Any) -> str | None:
    """Return the name of the axis that is up; None is that of the camera."""
    if value is None:
        return None
    check_text("up", value)
    if value not in AXES:
        raise UsageError(unknown("up", value, AXES))
    return value


@dataclass(frozen=True)
class Asked:
    """Words of a call of `enable`: checked values, or KEEP. An environment may be a name."""

    environment: Any = KEEP
    sun: Any = KEEP
    up: Any = KEEP

    @property
    def anything(self) -> bool:
        """Return whether the call says something."""
        return any(value is not KEEP for value in (self.environment, self.sun, self.up))


NOTHING = {"environment": KEEP, "sun": KEEP, "up": KEEP}
"""The words of a call that says nothing."""


def check(environment: Any, sun: Any, up: Any) -> Asked:
    """Check the words of a call."""
    return Asked(
        environment if environment is KEEP else environments.from_value(environment),
        sun if sun is KEEP else check_sun(sun),
        up if up is KEEP else check_up(up),
    )


def up_of_camera(renderer: vtkRenderer) -> str:
    """Return the axis that is nearest to the camera's view-up."""
    view_up = renderer.GetActiveCamera().GetViewUp()
    index = int(np.argmax(np.abs(view_up)))
    return ("-" if view_up[index] < 0.0 else "") + "xyz"[index]


def _ahead(renderer: vtkRenderer, up: Vector, east: Vector) -> Vector:
    """Return the right of a camera that looks at the horizon below what it looks at.

    It is east for a camera that looks straight up or down.
    """
    look = np.array(renderer.GetActiveCamera().GetDirectionOfProjection())
    right = np.cross(look, up)
    length = float(np.linalg.norm(right))
    return east if length < 1e-6 else tuple(float(part) for part in right / length)


def _make_sun(renderer: vtkRenderer) -> vtkLight:
    """Return a directional light; in a renderer of PyVista's one of PyVista's, as it expects."""
    light = vtkLight()
    if chain.is_pyvistas(renderer):
        light = importlib.import_module("pyvista").Light()
    light.SetLightTypeToSceneLight()
    light.PositionalOff()
    light.SetPosition(0.0, 0.0, 0.0)
    return light


@dataclass
class Surroundings:
    """Sky and sun of one renderer, with what they have changed in it."""

    sky: str | None = None
    sun: Sun | None = None
    up: str | None = None  # asked for; None: the camera's
    given: bool = False  # an environment has been given to `enable`
    _implied: bool = False  # the sky came with the sun
    _settled: bool = False  # a frame has been drawn with these axes
    _placed: tuple[Any, ...] | None = None  # what was placed last
    _environment: Any = None
    _light: vtkLight | None = None
    _off: list[vtkLight] = field(default_factory=list)
    _automatic: bool | None = None

    def check(self, asked: Asked, presets: bool, indirect: Any) -> None:
        """Raise where what is asked for has no effect; nothing has changed then.

        `presets`: whether a preset of lights is, or will be, in force.
        """
        sun = self.sun if asked.sun is KEEP else asked.sun
        if sun is not None and presets:
            raise UsageError(
                "a sun is none of the lights of a preset: the lighting must be auto or scene"
            )
        sky = self.sky if asked.environment is KEEP else asked.environment
        if asked.sun is not KEEP and sun is not None and indirect.GetEnvironment() is None:
            sky = sky or IMPLIED
        if asked.up not in (KEEP, None) and sun is None and not isinstance(sky, str):
            raise UsageError("up is for a sun or named surroundings, and there is neither")

    def ask(self, asked: Asked, indirect: Any) -> None:
        """Take what a call says; `place` brings it about."""
        if not asked.anything:
            return
        self._settled, self._placed = False, None
        if asked.up is not KEEP:
            self.up = asked.up
        if asked.environment is not KEEP:
            named = isinstance(asked.environment, str)
            self.sky, self._implied = asked.environment if named else None, False
            self.given = asked.environment is not None
            if not named:
                indirect.SetEnvironment(asked.environment)
        if asked.sun is not KEEP:
            self.sun = asked.sun
        if self._implied and self.sun is None:
            self.sky, self._implied = None, False
            indirect.SetEnvironment(None)
        none = asked.environment is KEEP and self.sky is None and indirect.GetEnvironment() is None
        if asked.sun is not KEEP and self.sun is not None and none:
            self.sky, self._implied = IMPLIED, True

    def place(self, renderer: vtkRenderer, indirect: Any, automatic: bool, frame: bool) -> None:
        """Bring sky, sun and lights to what they are to be; `frame`: one is about to be drawn.

        The axes follow the camera until the first frame, because a plotter places its camera late.
        `automatic` is whether the lighting is "auto", with which lights that follow the camera are
        off beside a sun or an environment that a call has given.
        """
        placed = self._placed
        if placed is not None and self.sky and indirect.GetEnvironment() is not self._environment:
            self.sky, self._implied = None, False  # somebody has set another one
        if self.sky is not None or self.sun is not None:
            if not self._settled:
                up, east, north = directions(self.up or up_of_camera(renderer))
                right = _ahead(renderer, up, east) if self.sky in skies.ROOMS else east
                self._place(renderer, indirect, (up, east, north), right)
                self._settled = frame
            self._keep_sun(renderer)
        elif self._light is not None:
            self._keep_sun(renderer)
        lit = self.sun is not None or (self.given and indirect.GetEnvironment() is not None)
        self._switch(renderer, automatic and lit)

    def _place(
        self,
        renderer: vtkRenderer,
        indirect: Any,
        axes: tuple[Vector, Vector, Vector],
        right: Vector,
    ) -> None:
        wanted = (self.sky, self.sun, axes, right)
        if wanted == self._placed:
            return
        self._placed = wanted
        up, east, north = axes
        if self.sky is not None:
            self._environment = wrapped.get(environments.CLASS)()
            self._environment.SetImage(skies.image(self.sky, self.sun))
            self._environment.SetUp(up)
            self._environment.SetRight(right)
            indirect.SetEnvironment(self._environment)
        if self.sun is not None:
            if self._light is None:
                self._light = _make_sun(renderer)
                indirect.SetLightAngle(self._light, SUN_ANGLE)
            self._light.SetFocalPoint([-part for part in self.sun.towards(east, north, up)])
            self._light.SetIntensity(skies.sun_irradiance(self.sky or IMPLIED, self.sun))

    def _keep_sun(self, renderer: vtkRenderer) -> None:
        there = bool(renderer.GetLights().IsItemPresent(self._light)) if self._light else False
        if self.sun is not None and not there:
            renderer.AddLight(self._light)
        elif self.sun is None and self._light is not None:
            if there:
                renderer.RemoveLight(self._light)
            self._light = None

    def _switch(self, renderer: vtkRenderer, off: bool) -> None:
        """Switch lights that follow the camera off, or those that were on before on again."""
        if not off:
            for light in self._off:
                light.SwitchOn()
            self._off = []
            if self._automatic is not None:
                renderer.SetAutomaticLightCreation(self._automatic)
                self._automatic = None
            return
        if self._automatic is None:
            self._automatic = bool(renderer.GetAutomaticLightCreation())
            renderer.AutomaticLightCreationOff()  # VTK makes one where none is on
        for light in lighting.lights_of(renderer):
            if lighting.follows_camera(light):
                light.SwitchOff()
                self._off.append(light)

    def leave(self, renderer: vtkRenderer) -> None:
        """Take the sun away, and give the renderer its own lights back."""
        self.sun = None
        self._keep_sun(renderer)
        self._switch(renderer, False)

    def report(self) -> tuple[list[dict[str, str]], list[dict[str, str]]]:
        """Return entries for `modelled` and `left_out` of a report."""
        modelled, left_out = [], []
        if self.sky is not None:
            why = "it comes with the sun" if self._implied else "it is set"
            modelled.append({"what": f"environment {self.sky}", "why": why})
        if self.sun is not None:
            place = f"azimuth {self.sun.azimuth:g}, elevation {self.sun.elevation:g} degrees"
            modelled.append({"what": "sun", "why": f"it is set: {place}"})
        if self._off:
            count = len(self._off)
            what = f"{count} light{'s' if count > 1 else ''} that follow{'' if count > 1 else 's'}"
            why = "lighting auto, and there is a sun or an environment"
            left_out.append({"what": f"{what} the camera", "why": why})
        return modelled, left_out
