# SPDX-License-Identifier: BSD-3-Clause
"""What an area light loses as part of an environment in spherical harmonics of order 4.

For Documentation/methods/sphere-proxies.md: quadrature in double precision, no rendering.

    python3 far_area_light.py
"""

from __future__ import annotations

import numpy as np

COUNT = 200_000
"""Directions, evenly spread over the sphere."""
BANDS = np.repeat([0, 1, 2, 3], [1, 3, 5, 7])
COSINE = np.array([1, 2 / 3, 1 / 4, 0])[BANDS]
"""Of the clamped cosine over pi: what it makes of each band."""


def directions(count: int) -> np.ndarray:
    """Return unit vectors, evenly spread."""
    i = np.arange(count) + 0.5
    z = 1 - 2 * i / count
    s = np.sqrt(1 - z * z)
    turn = np.pi * (1 + np.sqrt(5)) * i
    return np.stack([s * np.cos(turn), s * np.sin(turn), z], -1)


def harmonics(d: np.ndarray) -> np.ndarray:
    """Return the 16 functions of order 4."""
    x, y, z = d[..., 0], d[..., 1], d[..., 2]
    rest = x * x - y * y
    rows = [0.28209479 + 0 * x, 0.48860251 * y, 0.48860251 * z, 0.48860251 * x]
    rows += [1.09254843 * x * y, 1.09254843 * y * z, 0.31539157 * (3 * z * z - 1)]
    rows += [1.09254843 * x * z, 0.54627422 * rest, 0.59004359 * y * (3 * x * x - y * y)]
    rows += [2.89061144 * x * y * z, 0.45704580 * y * (5 * z * z - 1)]
    rows += [0.37317633 * z * (5 * z * z - 3), 0.45704580 * x * (5 * z * z - 1)]
    rows += [1.44530572 * z * rest, 0.59004359 * x * (x * x - 3 * y * y)]
    return np.stack(rows, -1)


def polar(tilt: float, turn: float = 0) -> np.ndarray:
    """Return the unit vector so many degrees from +z, turned about it."""
    t, p = np.radians([tilt, turn])
    return np.array([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)])


def shadows() -> None:
    """Print errors of disks at infinity over a plane, alone and behind a sphere."""
    d = directions(COUNT)
    basis = harmonics(d)
    weight = 4 * np.pi / COUNT
    cosine = np.maximum(d[:, 2], 0) / np.pi

    def project(values: np.ndarray) -> np.ndarray:
        return values @ basis * weight

    print("| half angle | open, largest | shadow, RMS | shadow, largest |\n|---:|---:|---:|---:|")
    for angle in (5, 10, 20, 30, 45, 60, 90):
        opens, errors = [], []
        for middle in (polar(0), polar(40)):
            light = (d @ middle > np.cos(np.radians(angle))).astype(float)
            cut = project(light)
            whole = light @ cosine * weight
            for tilt in (0, 30, 60):
                n = polar(tilt)
                exact = light @ np.maximum(d @ n, 0) / np.pi * weight
                opens.append((cut @ (COSINE * harmonics(n)) - exact) / whole)
            lit = project((basis @ cut) * (basis @ (COSINE * harmonics(polar(0)))))
            everywhere = lit @ project(np.ones(COUNT))
            for sine in (0.1, 0.25, 0.5, 0.7):
                for tilt in np.linspace(0, 80, 9):
                    for turn in (0, 60, 120, 180) if tilt > 0 else (0,):
                        seen = d @ polar(tilt, turn) < np.sqrt(1 - sine * sine)
                        exact = (light * seen) @ cosine * weight / whole
                        errors.append(lit @ project(seen * 1.0) / everywhere - exact)
        found = np.array(errors)
        print(
            f"| {angle}° | {np.abs(opens).max():.3f} | {np.sqrt((found**2).mean()):.3f}"
            f" | {np.abs(found).max():.2f} |"
        )


def form_factor(x: float, half: float, height: float) -> float:
    """Return the irradiance of a square of radiance 1 that is parallel to the receiver."""
    at = ((np.arange(60) + 0.5) / 60 * 2 - 1) * half
    u, v = np.meshgrid(at, at)
    squared = (u - x) ** 2 + v**2 + height**2
    return float((height**2 / squared**2).sum() * (2 * half / 60) ** 2 / np.pi)


def distances() -> None:
    """Print how far a square's light is from the same all over a scene of radius 1."""
    print("\n| distance | half angle | sideways | nearer |\n|---:|---:|---:|---:|")
    for angle in (30, 45):
        for distance in (2, 4, 8, 16, 32, 64):
            half = distance * np.tan(np.radians(angle))
            middle = form_factor(0, half, distance)
            sideways = form_factor(1, half, distance) / middle - 1
            nearer = form_factor(0, half, distance - 1) / middle - 1
            print(f"| {distance} | {angle}° | {sideways:+.3f} | {nearer:+.3f} |")


if __name__ == "__main__":
    shadows()
    distances()
