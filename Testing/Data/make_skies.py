#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the skies of Testing/Data from formulas: equirectangular, 256 x 128, halves.

    make_skies.py [FOLDER]

Needs the package vtkindirect with OpenEXR. The image's middle looks along -z, see
vtkEnvironmentLight. Values are radiances in VTK's units: E is 1 under a radiance of 1 everywhere.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

COLUMNS, ROWS = 256, 128

SUN_DIAMETER = 2.0  # degrees
SUN_ALTITUDE, SUN_AZIMUTH = 35.0, 60.0  # degrees; azimuth from -z to +x
SUN_IRRADIANCE = np.array([2.0, 1.8, 1.5])  # on a surface that faces the sun, in VTK's units
PIECES = 16  # of a pixel in each direction, to find how much of it the sun covers


def altitudes() -> np.ndarray:
    """Return the altitude of each row's middle in radians, the nadir's row first."""
    return np.pi * ((np.arange(ROWS) + 0.5) / ROWS - 0.5)


def _mixed(ends: tuple[list[float], list[float]], part: np.ndarray) -> np.ndarray:
    low, high = (np.array(end) for end in ends)
    return low + part[:, None] * (high - low)


def _sky(horizon: list[float], zenith: list[float], ground: list[float]) -> np.ndarray:
    """Return a sky whose colour depends on the altitude only; below the horizon is the ground."""
    height = np.sin(altitudes())
    above = _mixed((horizon, zenith), np.sqrt(np.maximum(height, 0.0)))
    rows = np.where(height[:, None] > 0.0, above, np.array(ground))
    return np.repeat(rows[:, None, :], COLUMNS, axis=1)


def gradient() -> np.ndarray:
    """Return an evening sky: blue above, warm at the horizon, dark below."""
    return _sky([1.6, 0.9, 0.45], [0.25, 0.45, 0.95], [0.02, 0.02, 0.02])


def sun_cover() -> np.ndarray:
    """Return the part of each pixel that the sun's disk covers."""
    latitude = np.pi * ((np.arange(ROWS * PIECES) + 0.5) / (ROWS * PIECES) - 0.5)
    longitude = 2.0 * np.pi * ((np.arange(COLUMNS * PIECES) + 0.5) / (COLUMNS * PIECES) - 0.5)
    altitude, azimuth = np.radians([SUN_ALTITUDE, SUN_AZIMUTH])
    cosine = np.sin(latitude)[:, None] * np.sin(altitude)
    cosine = cosine + (np.cos(latitude)[:, None] * np.cos(longitude - azimuth)) * np.cos(altitude)
    inside = cosine >= np.cos(np.radians(0.5 * SUN_DIAMETER))
    return inside.reshape(ROWS, PIECES, COLUMNS, PIECES).mean(axis=(1, 3))


def solid_angles() -> np.ndarray:
    """Return the solid angle of a pixel of each row."""
    edges = np.sin(np.pi * (np.arange(ROWS + 1) / ROWS - 0.5))
    return 2.0 * np.pi / COLUMNS * np.diff(edges)


def sun() -> np.ndarray:
    """Return a blue sky with a sun of 2 degrees, dark below the horizon.

    The sun's radiance follows from its irradiance: E = L times its solid angle, by pi.
    """
    cover = sun_cover()
    solid_angle = (cover * solid_angles()[:, None]).sum()
    radiance = np.pi * SUN_IRRADIANCE / solid_angle
    return _sky([0.55, 0.7, 0.9], [0.12, 0.25, 0.6], [0.03, 0.03, 0.03]) + cover[..., None] * radiance


SKIES = {"sky_gradient.exr": gradient, "sky_sun.exr": sun}


def main() -> int:
    """Write the skies into the folder that the command line names, or beside this file."""
    from vtkindirect import images

    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    for name, make in SKIES.items():
        images.write_exr(folder / name, make().astype(np.float32))
        print(folder / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
