# SPDX-License-Identifier: BSD-3-Clause
"""Named surroundings, made as images, and the share of the light that the sun has.

An image has the radiances that `RADIANCES` states, times one factor, so that a horizontal surface
in full view of it gets `IRRADIANCE`: nearly what VTK's and PyVista's light kits give to a floor
that is seen from above. Beside a sun that is the light of a surface that faces it, of which the sky
has `sky_share`. The ground below sends `GROUND` of what it gets back. All light is white, so that
colours of data keep their hue.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from vtkindirect import arrays

IRRADIANCE = 0.9
"""The irradiance of a horizontal surface in full view, in VTK's units."""
GROUND = 0.2
"""Albedo of the ground, which fills the lower half: that of grass and fields in daylight practice.
"""
HEIGHT, WIDTH = 64, 128
"""Pixels of the images: 2.8 degrees each."""

Directions = np.ndarray  # elevation or azimuth of the pixels, in radians


@dataclass(frozen=True)
class Sun:
    """A place of the sun, in degrees: azimuth clockwise from north, seen from above, elevation."""

    azimuth: float
    elevation: float

    def towards(self, east: Sequence[float], north: Sequence[float], up: Sequence[float]) -> list:
        """Return the unit vector to the sun."""
        azimuth, elevation = math.radians(self.azimuth), math.radians(self.elevation)
        parts = (
            math.cos(elevation) * math.sin(azimuth),
            math.cos(elevation) * math.cos(azimuth),
            math.sin(elevation),
        )
        axes = (east, north, up)
        return [sum(part * axis[i] for part, axis in zip(parts, axes)) for i in range(3)]


ZENITH = Sun(0.0, 90.0)
"""Where the clear sky has its sun when there is none."""


# Extinction of the sun in one air mass, and what the sky gives to the ground: A + B sin(h)^C, in
# kilolux, h the sun's elevation.
_CLEAR_DAY = (0.21, 0.8, 15.5, 0.5)
_HAZY_DAY = (0.80, 0.3, 45.0, 1.0)
_SOLAR_ILLUMINANCE = 127.5  # kilolux, above the atmosphere


def sky_share(name: str, sun: Sun) -> float:
    """Return the share of the light of a surface that faces the sun that the surroundings give.

    By the daylight formulas of the Illuminating Engineering Society of North America (Lighting
    Handbook, 9th edition, chapter 8) with the air mass of Kasten and Young (1989): of a clear day
    for the clear sky, of one with some clouds for all others.
    """
    extinction, least, more, power = _CLEAR_DAY if name == "clear" else _HAZY_DAY
    sine = math.sin(math.radians(sun.elevation))
    mass = 1.0 / (sine + 0.50572 * (sun.elevation + 6.07995) ** -1.6364)
    direct = _SOLAR_ILLUMINANCE * math.exp(-extinction * mass)
    diffuse = least + more * sine**power
    return diffuse / (direct + diffuse)


def _uniform(elevation: Directions, _azimuth: Directions, _sun: Sun) -> np.ndarray:
    return np.ones_like(elevation)


def _overcast(elevation: Directions, _azimuth: Directions, _sun: Sun) -> np.ndarray:
    """The CIE standard overcast sky: three times as bright at the zenith as at the horizon."""
    return (1.0 + 2.0 * np.sin(elevation)) / 3.0


def _clear(elevation: Directions, azimuth: Directions, sun: Sun) -> np.ndarray:
    """The CIE standard clear sky (Kittler), relative; `sun` is where it is brightest."""
    height, turn = math.radians(sun.elevation), azimuth - math.radians(sun.azimuth)
    cosine = np.sin(elevation) * math.sin(height)
    cosine += np.cos(elevation) * math.cos(height) * np.cos(turn)
    cosine = np.clip(cosine, -1.0, 1.0)
    indicatrix = 0.91 + 10.0 * np.exp(-3.0 * np.arccos(cosine)) + 0.45 * cosine**2
    return indicatrix * (1.0 - np.exp(-0.32 / np.maximum(np.sin(elevation), 1e-3)))


# Azimuth of the middle clockwise from where the camera looks, elevation of the middle, width and
# height, all in degrees, and radiance over that of the key.
_BOXES = (
    (-135.0, 45.0, 60.0, 45.0, 1.0),  # the key, behind the camera on its left
    (110.0, 25.0, 60.0, 45.0, 0.35),  # the fill, on the right
    (15.0, 60.0, 120.0, 20.0, 0.6),  # the rim, a strip above what is behind the object
)
_ROOM = 0.04
"""Radiance of the studio's dark walls over that of the key."""


def _studio(elevation: Directions, azimuth: Directions, _sun: Sun) -> np.ndarray:
    """A dark room with three soft boxes."""
    found = np.full_like(elevation, _ROOM)
    for middle, height, width, tall, radiance in _BOXES:
        turn = np.abs((np.degrees(azimuth) - middle + 180.0) % 360.0 - 180.0)
        inside = (turn < width / 2.0) & (np.abs(np.degrees(elevation) - height) < tall / 2.0)
        found[inside] = np.maximum(found[inside], radiance)
    return found


Radiances = Callable[[Directions, Directions, Sun], np.ndarray]
RADIANCES: dict[str, Radiances] = {
    "uniform": _uniform,
    "overcast": _overcast,
    "clear": _clear,
    "studio": _studio,
}
"""Relative radiance of the upper half of each; the image's middle is north, or for a room where the
camera looks."""
NAMES = tuple(RADIANCES)
FROM_EVERYWHERE = ("uniform",)
"""Surroundings that are the same below the horizon."""
ROOMS = ("studio",)
"""Surroundings that are turned with the camera that looks at them first, and have walls below."""


def irradiances(radiances: np.ndarray) -> tuple[float, float]:
    """Return what an image gives to a horizontal surface that looks up, and to one that looks down.

    `radiances` has a row for each elevation, from the nadir up.
    """
    edges = np.linspace(-math.pi / 2.0, math.pi / 2.0, len(radiances) + 1)
    # The integral over azimuth and elevation of |sin| cos, over pi: each row has its share.
    parts = np.abs(np.diff(np.sin(edges) ** 2))
    rows = radiances.mean(axis=1) * parts
    return float(rows[len(rows) // 2 :].sum()), float(rows[: len(rows) // 2].sum())


def radiances(name: str, sun: Sun | None = None) -> np.ndarray:
    """Return the radiances of named surroundings, a row for each elevation, from the nadir up."""
    rows = (np.arange(HEIGHT) + 0.5) / HEIGHT * math.pi - math.pi / 2.0
    columns = (np.arange(WIDTH) + 0.5) / WIDTH * 2.0 * math.pi - math.pi
    elevation, azimuth = np.meshgrid(rows, columns, indexing="ij")
    found = RADIANCES[name](np.abs(elevation), azimuth, sun or ZENITH)
    irradiance = IRRADIANCE * (sky_share(name, sun) if sun is not None else 1.0)
    found *= irradiance / irradiances(found)[0]
    if name in ROOMS:
        walls = found.min()
        found[: HEIGHT // 2] = walls
    elif name not in FROM_EVERYWHERE:
        below = irradiance
        if sun is not None:
            below += sun_irradiance(name, sun) * math.sin(math.radians(sun.elevation))
        found[: HEIGHT // 2] = GROUND * below
    return found


def sun_irradiance(name: str, sun: Sun) -> float:
    """Return what the sun gives to a surface that faces it beside named surroundings."""
    return IRRADIANCE * (1.0 - sky_share(name, sun))


def image(name: str, sun: Sun | None = None) -> vtkImageData:
    """Return the image of named surroundings as vtkEnvironmentLight takes it."""
    return arrays.as_image(radiances(name, sun).astype(np.float32)[:, :, np.newaxis])
