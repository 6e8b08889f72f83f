#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits linearly transformed cosines to the specular lobe of VTK's physically based shading.

    Testing/Reference/fit_lobes.py FILE        write the table: Maps/vtkIndirectLobeTable.inl
    Testing/Reference/fit_lobes.py --errors    integrals of |lobe - fit| over the lobe's own

"Real-Time Polygonal-Light Shading with Linearly Transformed Cosines" (Heitz, Dupuy, Hill, Neubelt
2016). The lobe is D V cosL as VTK 9.1's lights evaluate it (SpecularIsotropic of its shaders): D of
Trowbridge and Reitz with alpha = roughness^2, V of Smith, height-correlated, with alpha = roughness.
Nothing of it lies below the horizon; the fit is cut there, too, and scaled so that under light of one
radiance from all around it reflects what the lobe does.

A row of the table: four entries of the inverse transform, over its middle one, of which the others
are 0 (first row x x: 00, 02; third row: 20, 22); the lobe's integral, and that with Schlick's weight
(1 - h.l)^5. Columns go with sqrt(1 - cosine of the view), rows with roughness, from LEAST to 1.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

ENTRIES = 24
LEAST = 0.06
"""Smoother surfaces are taken as of this roughness: highlights of half a degree."""
SAMPLES = 40
MOST_VIEW = 0.9995
"""Grazing views end here, at a cosine of 0.001."""

Parameters = tuple[float, float, float]


def roughness_of(row: int) -> float:
    """Return the roughness of a row of the table."""
    return LEAST + (1.0 - LEAST) * row / (ENTRIES - 1)


def cosine_of(column: int) -> float:
    """Return the cosine of the view of a column."""
    return float(1.0 - min(column / (ENTRIES - 1), MOST_VIEW) ** 2)


def view_of(cosine: float) -> np.ndarray:
    """Return the way to the eye; the normal is (0, 0, 1)."""
    return np.array((np.sqrt(max(1.0 - cosine * cosine, 0.0)), 0.0, cosine))


def lobe(roughness: float, view: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return D V cosL of ways to the light, n x 3, and h.l of each; 0 below the horizon."""
    middle = light + view
    middle /= np.maximum(np.linalg.norm(middle, axis=1, keepdims=True), 1e-12)
    cosine = np.maximum(light[:, 2], 0.0)
    alpha2 = roughness**4
    d = (middle[:, 2] * alpha2 - middle[:, 2]) * middle[:, 2] + 1.0
    distribution = alpha2 / (np.pi * d * d)
    a2 = roughness * roughness
    of_view = cosine * np.sqrt(a2 + view[2] * view[2] * (1.0 - a2))
    of_light = view[2] * np.sqrt(a2 + cosine * cosine * (1.0 - a2))
    shared = 0.5 / np.maximum(of_view + of_light, 1e-12)
    return distribution * shared * cosine, np.clip((middle * light).sum(axis=1), 0.0, 1.0)


def squares() -> tuple[np.ndarray, np.ndarray]:
    """Return places in the unit square, at the middles of squares."""
    middles = (np.arange(SAMPLES) + 0.5) / SAMPLES
    u, v = np.meshgrid(middles, middles)
    return u.ravel(), v.ravel()


def sample_lobe(roughness: float, view: np.ndarray) -> np.ndarray:
    """Return directions that D and the view make likely."""
    u, v = squares()
    tangent2 = roughness**4 * u / (1.0 - u)
    cosine = 1.0 / np.sqrt(1.0 + tangent2)
    sine = np.sqrt(np.maximum(1.0 - cosine * cosine, 0.0))
    phi = 2.0 * np.pi * v
    middle = np.stack((sine * np.cos(phi), sine * np.sin(phi), cosine), axis=1)
    return 2.0 * (middle @ view)[:, None] * middle - view


def density_of_lobe(roughness: float, view: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Return the density with which sample_lobe finds directions."""
    middle = light + view
    middle /= np.maximum(np.linalg.norm(middle, axis=1, keepdims=True), 1e-12)
    alpha2 = roughness**4
    d = middle[:, 2] ** 2 * (alpha2 - 1.0) + 1.0
    facing = np.maximum(middle @ view, 1e-9)
    return alpha2 / (np.pi * d * d) * np.maximum(middle[:, 2], 0.0) / (4.0 * facing)


def integrals(roughness: float, cosine: float) -> tuple[float, float, np.ndarray]:
    """Return the lobe's integral, that with Schlick's weight, and its mean direction."""
    view = view_of(cosine)
    light = sample_lobe(roughness, view)
    value, facing = lobe(roughness, view, light)
    weight = value / np.maximum(density_of_lobe(roughness, view, light), 1e-30)
    mean = (weight[:, None] * light).mean(axis=0)
    mean[1] = 0.0
    length = np.linalg.norm(mean)
    return (
        float(weight.mean()),
        float((weight * (1.0 - facing) ** 5).mean()),
        mean / length if length > 0.0 else np.array((0.0, 0.0, 1.0)),
    )


def transform(parameters: Parameters, middle: np.ndarray) -> np.ndarray:
    """Return the matrix that cosines are transformed by, about a lobe's mean direction."""
    x, y, skew = parameters
    frame = np.array(
        ((middle[2], 0.0, middle[0]), (0.0, 1.0, 0.0), (-middle[0], 0.0, middle[2]))
    )  # columns: tangent, bitangent, direction
    return frame @ np.array(((x, 0.0, skew), (0.0, y, 0.0), (0.0, 0.0, 1.0)))


def transformed(matrix: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Return the density of transformed cosines, of integral one over the part above the horizon."""
    inverse = np.linalg.inv(matrix)
    way = light @ inverse.T
    length2 = np.maximum((way * way).sum(axis=1), 1e-30)
    density = np.maximum(way[:, 2], 0.0) / (np.pi * length2 * length2)
    density *= abs(np.linalg.det(inverse))
    return np.where(light[:, 2] > 0.0, density, 0.0) / share_above(matrix)


def share_above(matrix: np.ndarray) -> float:
    """Return the share of transformed cosines that lies above the horizon.

    The horizon's half-space becomes one whose normal is the transpose times the old: a hemisphere
    and another at this angle to it.
    """
    normal = matrix.T @ np.array((0.0, 0.0, 1.0))
    return 0.5 * (1.0 + float(normal[2] / np.linalg.norm(normal)))


def compare(
    roughness: float, cosine: float, matrix: np.ndarray, power: float
) -> float:
    """Return the integral of |lobe - fit|^power, over the lobe's own, by samples of both."""
    view = view_of(cosine)
    u, v = squares()
    radius, phi = np.sqrt(u), 2.0 * np.pi * v
    cosines = np.stack((radius * np.cos(phi), radius * np.sin(phi), np.sqrt(1.0 - u)), axis=1)
    ways = cosines @ matrix.T
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    light = np.concatenate((sample_lobe(roughness, view), ways))
    value, _ = lobe(roughness, view, light)
    density = density_of_lobe(roughness, view, light)
    fitted = transformed(matrix, light)
    uncut = fitted * share_above(matrix)
    both = np.maximum(0.5 * (density + np.where(light[:, 2] > 0.0, uncut, 0.0)), 1e-30)
    above = light[:, 2] > 0.0
    integral = float(np.where(above, value / both, 0.0).mean())
    apart = np.where(above, np.abs(value / integral - fitted) ** power / both, 0.0)
    return float(apart.mean())


def minimize(
    function: Callable[[np.ndarray], float], start: Sequence[float], step: float
) -> np.ndarray:
    """Return where a function is least: Nelder and Mead 1965."""
    count = len(start)
    corners = [np.array(start, dtype=float)]
    for i in range(count):
        moved = np.array(start, dtype=float)
        moved[i] += step * (abs(moved[i]) if abs(moved[i]) > 0.01 else 0.1)
        corners.append(moved)
    values = [function(corner) for corner in corners]
    for _ in range(160):
        order = np.argsort(values, kind="stable")
        corners, values = [corners[i] for i in order], [values[i] for i in order]
        if values[-1] - values[0] <= 1e-7 * abs(values[0]):
            break
        center = np.mean(corners[:-1], axis=0)
        mirrored = 2.0 * center - corners[-1]
        found = function(mirrored)
        if found < values[0]:
            farther = 3.0 * center - 2.0 * corners[-1]
            other = function(farther)
            corners[-1], values[-1] = (farther, other) if other < found else (mirrored, found)
        elif found < values[-2]:
            corners[-1], values[-1] = mirrored, found
        else:
            nearer = 0.5 * (center + (mirrored if found < values[-1] else corners[-1]))
            other = function(nearer)
            if other < min(found, values[-1]):
                corners[-1], values[-1] = nearer, other
            else:
                corners = [corners[0]] + [0.5 * (corners[0] + corner) for corner in corners[1:]]
                values = [values[0]] + [function(corner) for corner in corners[1:]]
    return corners[int(np.argmin(values))]


def fit(roughness: float, cosine: float, start: Parameters) -> tuple[Parameters, np.ndarray]:
    """Return the parameters of the fit from a start, and its matrix."""
    middle = integrals(roughness, cosine)[2]
    even = cosine > 0.999999

    def matrix_of(free: np.ndarray) -> np.ndarray:
        x, y = np.exp(np.clip(free[:2], -9.0, 3.0)) if not even else np.exp(free[[0, 0]])
        return transform((x, y, 0.0 if even else float(free[2])), middle)

    first = [np.log(start[0]), np.log(start[1]), start[2]]
    free = minimize(lambda p: compare(roughness, cosine, matrix_of(p), 2.0), first, 0.05)
    matrix = matrix_of(free)
    x, y = np.exp(free[:2]) if not even else np.exp(free[[0, 0]])
    return (float(x), float(y), 0.0 if even else float(free[2])), matrix


def entry(roughness: float, cosine: float, matrix: np.ndarray) -> np.ndarray:
    """Return a row of the table."""
    inverse = np.linalg.inv(matrix)
    inverse /= inverse[1, 1]
    whole, grazing, _ = integrals(roughness, cosine)
    above = share_above(matrix)
    return np.array(
        (inverse[0, 0], inverse[0, 2], inverse[2, 0], inverse[2, 2], whole / above, grazing / above)
    )


def make_row(number: int) -> np.ndarray:
    """Return the table's entries of one roughness, each from its neighbour's parameters."""
    roughness = roughness_of(number)
    start: Parameters = (roughness**2, roughness**2, 0.0)
    row = []
    for column in range(ENTRIES):
        cosine = cosine_of(column)
        start, matrix = fit(roughness, cosine, start)
        row.append(entry(roughness, cosine, matrix))
    return np.array(row)


def make() -> np.ndarray:
    """Return the table: roughness, view, entry."""
    return np.array([make_row(number) for number in range(ENTRIES)])


def text_of(table: np.ndarray) -> str:
    """Return the table as initializers of C++, a roughness per line."""
    rows = [[", ".join(f"{value:.5g}" for value in values) for values in row] for row in table]
    return "".join("{ {" + "}, {".join(row) + "} },\n" for row in rows)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("file", nargs="?", type=Path)
    parser.add_argument("--errors", action="store_true")
    options = parser.parse_args(arguments)
    if options.errors:
        for number in range(0, ENTRIES, 3):
            roughness = roughness_of(number)
            start: Parameters = (roughness**2, roughness**2, 0.0)
            errors = []
            for column in range(ENTRIES):
                start, matrix = fit(roughness, cosine_of(column), start)
                errors.append(compare(roughness, cosine_of(column), matrix, 1.0))
            shown = " ".join(f"{error:.3f}" for error in errors[::3])
            print(f"roughness {roughness:.3f}: {shown}")
    if options.file:
        options.file.write_text(text_of(make()), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
