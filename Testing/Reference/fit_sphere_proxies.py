#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits what sums over spheres need in spherical harmonics of order 4.

    Testing/Reference/fit_sphere_proxies.py TABLE PRODUCT OPERATOR
        write Proxies/vtkIndirectProxyTable.h and of glsl/lib vtkIndirectLibHarmonicProduct.glsl and
        vtkIndirectLibProxyOperator.glsl
    Testing/Reference/fit_sphere_proxies.py --errors
        how good the fits are

"Image-Based Proxy Accumulation for Real-Time Soft Global Illumination" (Sloan, Govindaraju,
Nowrouzezahrai, Snyder 2007) and, for the exponential, "Real-time Soft Shadows in Dynamic Scenes using
Spherical Harmonic Exponentiation" (Ren, Wang, Snyder, Zhou, Liu, Sun, Hua, Guo, Shum 2006).

*Product.* Integrals of three functions, by a quadrature that is exact for them.
*Exponential.* e^(f0 Y00) (a 1 + b g + g^2 / 2) squared p times, where g is f without its constant f0,
halved p times; a and b are even in |g|, fitted to the exponentials of random functions. (Without g^2
the error is that of f^2 / 2^(p + 1), with it that of f^3 / 4^p / 6.)
*Visibility.* For spheres seen under sin = r/d, the zonal logarithm whose exponential, by exactly that
formula, is nearest to the projection of the visibility.
*Average.* Radiance of a sphere under distant light, averaged over its visible disk, is a zonal
operator of its normals' light: D0 to D2 as polynomials of sin.
*Operator.* Not averaged (Eq 16): integrals over the disk of a function at the direction times one at
the sphere's normal there, over the solid angle, as polynomials of sin and cos.
"""

from __future__ import annotations

import argparse
import itertools
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

ORDER = 4
COUNT = ORDER * ORDER
ENTRIES = 64
"""Entries of the table of visibility, at even steps of solid angle: 1 - cos = i / (ENTRIES - 1)."""
HALVING = 0.25
"""f is halved until it is no larger than this."""
SMOOTH = 10
"""Halvings of each fit's exponential: as many for all, so that nothing jumps."""
STIFFNESS = 1e-5
"""Squared length of a logarithm over squared error: near a full hemisphere there is no shorter one."""
WEIGHTS_OF_BANDS = np.array((1.0, 0.7, 0.25, 0.03))
"""Weights of the errors of bands. From sin = 0.75 on no vector of order 4 has the visibility as its
exponential; irradiance takes bands by about 1, 2/3, 1/4 and 0."""

Y00 = 0.5 / np.sqrt(np.pi)


def basis(way: np.ndarray) -> np.ndarray:
    """Return the 16 functions at unit directions, n x 3 to n x 16, by l (l + 1) + m."""
    x, y, z = way[..., 0], way[..., 1], way[..., 2]
    return np.stack(
        (
            np.full_like(x, Y00),
            np.sqrt(3 / (4 * np.pi)) * y,
            np.sqrt(3 / (4 * np.pi)) * z,
            np.sqrt(3 / (4 * np.pi)) * x,
            np.sqrt(15 / (4 * np.pi)) * x * y,
            np.sqrt(15 / (4 * np.pi)) * y * z,
            np.sqrt(5 / (16 * np.pi)) * (3 * z * z - 1),
            np.sqrt(15 / (4 * np.pi)) * x * z,
            np.sqrt(15 / (16 * np.pi)) * (x * x - y * y),
            np.sqrt(35 / (32 * np.pi)) * y * (3 * x * x - y * y),
            np.sqrt(105 / (4 * np.pi)) * x * y * z,
            np.sqrt(21 / (32 * np.pi)) * y * (5 * z * z - 1),
            np.sqrt(7 / (16 * np.pi)) * z * (5 * z * z - 3),
            np.sqrt(21 / (32 * np.pi)) * x * (5 * z * z - 1),
            np.sqrt(105 / (16 * np.pi)) * z * (x * x - y * y),
            np.sqrt(35 / (32 * np.pi)) * x * (x * x - 3 * y * y),
        ),
        axis=-1,
    )


def sphere_rule(rings: int = 24, around: int = 48) -> tuple[np.ndarray, np.ndarray]:
    """Return directions and weights: exact up to degree 2 rings - 1 and around - 1."""
    z, w = np.polynomial.legendre.leggauss(rings)
    phi = 2 * np.pi * (np.arange(around) + 0.5) / around
    s = np.sqrt(1 - z * z)
    way = np.stack(
        (
            np.outer(s, np.cos(phi)),
            np.outer(s, np.sin(phi)),
            np.repeat(z[:, None], around, axis=1),
        ),
        axis=-1,
    )
    return way.reshape(-1, 3), np.repeat(w * 2 * np.pi / around, around)


WAYS, WEIGHTS = sphere_rule()
VALUES = basis(WAYS)
TRIPLE = np.einsum("n,ni,nj,nk->ijk", WEIGHTS, VALUES, VALUES, VALUES, optimize=True)
TRIPLE[np.abs(TRIPLE) < 1e-12] = 0.0
ZONAL = np.array([0, 2, 6, 12])


def product(f: np.ndarray, g: np.ndarray) -> np.ndarray:
    """Return the product of two vectors, cut to order 4."""
    return np.einsum("ijk,i,j->k", TRIPLE, f, g)


def exponential_of(f: np.ndarray) -> np.ndarray:
    """Return the projection of the exponential of a function, by quadrature."""
    return (WEIGHTS * np.exp(VALUES @ f)) @ VALUES


def fit_linear() -> np.ndarray:
    """Return the coefficients of a and b: rows, in powers of |f|^2, 0 and 1."""
    random = np.random.Generator(np.random.PCG64(4))
    sizes = np.linspace(0.25 * HALVING, HALVING, 13)
    a, b = [], []
    for size in sizes:
        rows, right = [], []
        for _ in range(60):
            f = random.normal(size=COUNT)
            f[0] = 0.0
            f *= size / np.linalg.norm(f)
            exact = exponential_of(f) - 0.5 * product(f, f)
            rows.append((1.0 / Y00, f @ exact / (f @ f), exact[0]))
        a.append(np.mean([r[2] for r in rows]) * Y00)
        b.append(np.mean([r[1] for r in rows]))
    powers = sizes[:, None] ** 2
    fits = [np.linalg.lstsq(powers, np.array(v) - 1.0, rcond=None)[0] for v in (a, b)]
    return np.array([[1.0, *fit] for fit in fits])


LINEAR = fit_linear()


def exponential(f: np.ndarray, halvings: int | None = None) -> np.ndarray:
    """Return the exponential of a vector as shaders take it, or with a number of halvings."""
    rest = f.copy()
    rest[0] = 0.0
    size = np.linalg.norm(rest)
    if halvings is None:
        halvings = int(np.ceil(np.log2(max(size / HALVING, 1.0))))
    size *= 0.5**halvings
    rest *= 0.5**halvings
    a, b = LINEAR @ np.array((1.0, size**2))
    result = b * rest + 0.5 * product(rest, rest)
    result[0] += a / Y00
    for _ in range(halvings):
        result = product(result, result)
    return np.exp(f[0] * Y00) * result


def zonal(values: np.ndarray) -> np.ndarray:
    """Return the vector of four zonal coefficients."""
    found = np.zeros(COUNT)
    found[ZONAL] = values
    return found


def sine_of(row: int) -> float:
    """Return the sine of half the angle of a row of the table."""
    share = row / (ENTRIES - 1)
    return float(np.sqrt(share * (2 - share)))


def visibility(sine: float) -> np.ndarray:
    """Return the zonal coefficients of what a sphere about +z leaves to be seen."""
    cosine = np.sqrt(max(1.0 - sine * sine, 0.0))
    z, w = np.polynomial.legendre.leggauss(16)
    at = -1.0 + (z + 1.0) * 0.5 * (cosine + 1.0)
    weight = w * 0.5 * (cosine + 1.0) * 2 * np.pi
    way = np.stack((np.sqrt(1 - at * at), np.zeros_like(at), at), axis=-1)
    return weight @ basis(way)[:, ZONAL]


def logarithm(target: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return the zonal vector whose exponential is nearest to a target: Gauss and Newton, damped."""
    f = start.copy()
    damping = 1e-6

    def off(values: np.ndarray) -> np.ndarray:
        wrong = (exponential(zonal(values), SMOOTH)[ZONAL] - target) * WEIGHTS_OF_BANDS
        return np.concatenate((wrong, np.sqrt(STIFFNESS) * values))

    error = off(f)
    for _ in range(200):
        step = 1e-6
        slope = np.stack(
            [(off(f + step * np.eye(4)[i]) - off(f - step * np.eye(4)[i])) / (2 * step)
             for i in range(4)],
            axis=1,
        )
        move = np.linalg.solve(
            slope.T @ slope + damping * np.eye(4), -slope.T @ error
        )
        tried = off(f + move)
        if tried @ tried < error @ error:
            f, error = f + move, tried
            damping = max(damping * 0.3, 1e-12)
            if np.linalg.norm(move) < 1e-10:
                break
        else:
            damping *= 4.0
            if damping > 1e6:
                break
    return f


def visibility_table() -> np.ndarray:
    """Return the zonal logarithms, ENTRIES x 4."""
    table = np.zeros((ENTRIES, 4))
    for i in range(1, ENTRIES):
        table[i] = logarithm(visibility(sine_of(i)), table[i - 1])
    return table


def over_rows(table: np.ndarray) -> np.ndarray:
    """Return the logarithms over 1 - cos: of nothing, as of a small disk, over its solid angle.

    Between rows it is this that is linear, so that spheres of any size hide what they cover.
    """
    share = np.arange(ENTRIES) / (ENTRIES - 1)
    first = -2 * np.pi * basis(np.array((0.0, 0.0, 1.0)))[ZONAL]
    return np.vstack((first, table[1:] / share[1:, None]))


def average(sines: np.ndarray) -> np.ndarray:
    """Return D0 to D2, n x 3: the mean over the visible disk of Y_l0 at the sphere's normals.

    The sphere lies along +z at the distance 1 with the radius sin.
    """
    found = []
    x, w = np.polynomial.legendre.leggauss(64)
    for sine in sines:
        cosine = np.sqrt(1 - sine * sine)
        # Substituted so that the root at the disk's border is smooth.
        u = 0.5 * (x + 1.0)
        z = cosine + (1 - cosine) * u * u
        weight = 0.5 * w * 2 * u  # of dz / (1 - cosine)
        distance = z - np.sqrt(np.maximum(z * z - cosine * cosine, 0.0))
        normal = (distance * z - 1.0) / sine
        way = np.stack(
            (np.sqrt(np.maximum(1 - normal**2, 0)), np.zeros_like(normal), normal), axis=-1
        )
        found.append(weight @ basis(way)[:, ZONAL[:3]])
    return np.array(found)


def fit_average() -> tuple[np.ndarray, np.ndarray, tuple[float, float]]:
    """Return D1 and D2 as polynomials of sin, highest power first, and their squared errors."""
    x, w = np.polynomial.legendre.leggauss(64)
    sines = 0.5 * (x + 1.0)
    exact = average(sines)
    fits, errors = [], []
    for band, degree in ((1, 2), (2, 3)):
        fits.append(np.polyfit(sines, exact[:, band], degree, w=np.sqrt(w)))
        off = np.polyval(fits[-1], sines) - exact[:, band]
        errors.append(float((w @ off**2) / (w @ exact[:, band] ** 2)))
    return fits[0], fits[1], (errors[0], errors[1])


PAIRS = (
    *((0, row, column) for row in range(3) for column in range(3)),
    *((1, row, column) for row in (1, 2) for column in (1, 2)),
    (2, 2, 2),
)
"""Entries of the operator that irradiance takes: m, bands of directions and of normals. Cosines have
no band 3, and m and -m have the same; where m differ it is zero, as the disk is round."""


def operator(sines: np.ndarray) -> np.ndarray:
    """Return the entries for spheres along +z, n x 14: means over the visible disk."""
    functions = {(0, 0): 0, (0, 1): 2, (0, 2): 6, (1, 1): 3, (1, 2): 7, (2, 2): 8}
    x, w = np.polynomial.legendre.leggauss(64)
    phi = 2 * np.pi * (np.arange(8) + 0.5) / 8  # exact: degree 4
    u = 0.5 * (x + 1.0)
    weight = np.repeat(w * u, 8) / 8
    around = np.stack((np.cos(phi), np.sin(phi)), axis=-1)
    found = []
    for sine in sines:
        cosine = np.sqrt(1 - sine * sine)
        z = cosine + (1 - cosine) * u * u
        s = np.sqrt(1 - z * z)
        distance = z - np.sqrt(np.maximum(z * z - cosine * cosine, 0.0))
        ways, normals = (
            basis(
                np.concatenate(
                    (r[:, None, None] * around, np.repeat(h[:, None, None], 8, axis=1)), axis=2
                ).reshape(-1, 3)
            )
            for r, h in ((s, z), (distance * s / sine, (distance * z - 1.0) / sine))
        )
        found.append(
            [
                weight @ (ways[:, functions[m, row]] * normals[:, functions[m, column]])
                for m, row, column in PAIRS
            ]
        )
    return np.array(found)


def operator_terms(sines: np.ndarray) -> np.ndarray:
    """Return what the fit of the operator is linear in, n x 7."""
    s, c = sines, np.sqrt(1 - sines**2)
    return np.stack((np.ones_like(s), s, s * s, s**3, c, s * c, s * s * c), axis=-1)


def fit_operator() -> tuple[np.ndarray, float]:
    """Return the factors of the terms, 7 x 14, and the largest error of any entry."""
    x, w = np.polynomial.legendre.leggauss(64)
    sines = 0.5 * (x + 1.0)
    exact, terms = operator(sines), operator_terms(sines)
    root = np.sqrt(w)[:, None]
    factors = np.linalg.lstsq(root * terms, root * exact, rcond=None)[0]
    return factors, float(np.abs(terms @ factors - exact).max())


def operator_text() -> str:
    """Return the kernel of the operator."""
    factors, _ = fit_operator()
    rows = np.zeros((7, 16))
    rows[:, :14] = factors
    lines = [
        "// Light that a sphere reflects, over its solid angle, for a light along +z: the operator of",
        "// \"Image-Based Proxy Accumulation for Real-Time Soft Global Illumination\", Sloan, Govindaraju,",
        "// Nowrouzezahrai, Snyder 2007, Eq 16. Written by Testing/Reference/fit_sphere_proxies.py; not to be edited.",
        "#ifndef vtkIndirectLibProxyOperator",
        "#define vtkIndirectLibProxyOperator",
        '#include "vtkIndirectLibPortable.glsl"',
        "",
        "/* Means over the visible disk of a function of the direction times one of the sphere's normal there, of the",
        " * same m; by bands of direction and normal. m = 0: 00, 01, 02, 10; 11, 12, 20, 21; 22; m = 1, or -1: 11, 12, 21;",
        " * 22; m = 2, or -2: 22. */",
        "struct vtkiProxyOperator",
        "{",
        "  vec4 A;",
        "  vec4 B;",
        "  vec4 C;",
        "  vec4 D;",
        "};",
        "",
        "/* By the sine of half the angle, from 0 to 1. */",
        "vtkiProxyOperator vtkiExactOperator(float sine)",
        "{",
        "  float s2 = sine * sine;",
        "  float s3 = s2 * sine;",
        "  float c = sqrt(max(1.0f - s2, 0.0f));",
        "  float sc = sine * c;",
        "  float s2c = s2 * c;",
        "  vtkiProxyOperator m;",
    ]
    for part in range(4):
        vectors = [
            "vec4(" + ", ".join(f"{round(v, 7) + 0.0:.7f}f" for v in row[4 * part : 4 * part + 4]) + ")"
            for row in rows
        ]
        lines.append(f"  m.{'ABCD'[part]} = {vectors[0]};")
        for name, vector in zip(("sine", "s2", "s3", "c", "sc", "s2c"), vectors[1:]):
            lines.append(f"  m.{'ABCD'[part]} += {name} * {vector};")
    return "\n".join([*lines, "  return m;", "}", "#endif", ""])


def product_text() -> str:
    """Return the kernel of the product of two vectors."""
    lines = [
        "// The product of two functions in spherical harmonics of order 4, cut to that order. Written by",
        "// Testing/Reference/fit_sphere_proxies.py; not to be edited.",
        "#ifndef vtkIndirectLibHarmonicProduct",
        "#define vtkIndirectLibHarmonicProduct",
        '#include "vtkIndirectLibPortable.glsl"',
        "",
        "/* Coefficients by l (l + 1) + m, four in each. */",
        "struct vtkiHarmonics4",
        "{",
        "  vec4 A;",
        "  vec4 B;",
        "  vec4 C;",
        "  vec4 D;",
        "};",
        "",
        "vtkiHarmonics4 vtkiHarmonicProduct(vtkiHarmonics4 f, vtkiHarmonics4 g)",
        "{",
        "  vtkiHarmonics4 h;",
    ]
    name = [f"{'ABCD'[i // 4]}.{'xyzw'[i % 4]}" for i in range(COUNT)]
    for k in range(COUNT):
        lines.append(f"  h.{name[k]} =")
        for i, j in itertools.combinations_with_replacement(range(COUNT), 2):
            value = TRIPLE[i, j, k]
            if value == 0.0:
                continue
            products = f"f.{name[i]} * g.{name[j]}"
            if i != j:
                products += f" + f.{name[j]} * g.{name[i]}"
            term = f"{'-' if value < 0.0 else '+'} {abs(value):.8f}f * ({products})"
            if len(lines[-1]) + len(term) > 98:
                lines.append("   ")
            lines[-1] += " " + (term if "=" not in lines[-1][-1] else term.removeprefix("+ "))
        lines[-1] += ";"
    return "\n".join([*lines, "  return h;", "}", "#endif", ""])


def table_text() -> str:
    """Return the table as a header of C++."""
    table = over_rows(visibility_table())
    lines = [
        "// SPDX-License-Identifier: BSD-3-Clause",
        "// Tables in spherical harmonics for sums over spheres. Written by",
        "// Testing/Reference/fit_sphere_proxies.py, which says what the numbers are; not to be edited.",
        "#pragma once",
        "",
        "// clang-format off",
        f"constexpr int vtkIndirectProxyEntries = {ENTRIES};",
        "// Zonal logarithm of visibility over 1 - cos where 1 - cos = row / (entries - 1).",
        f"constexpr float vtkIndirectProxyTable[{ENTRIES}][4] = {{",
    ]
    lines += ["  {" + ", ".join(f"{v:.7g}f" if "." in f"{v:.7g}" or "e" in f"{v:.7g}"
                                else f"{v:.1f}f" for v in row) + "}," for row in table]
    lines += ["};", "// clang-format on", ""]
    return "\n".join(lines)


def errors() -> None:
    """Print how good the fits are."""
    print("a, b:", LINEAR.tolist())
    table = visibility_table()
    for i in range(0, ENTRIES, 7):
        target = visibility(sine_of(i))
        off = np.linalg.norm(exponential(zonal(table[i]))[ZONAL] - target)
        print(f"sin {sine_of(i):.3f}: {off:.2e} of {np.linalg.norm(target):.3f}  {table[i]}")
    first, second, squared = fit_average()
    print("D1:", first, "D2:", second)
    print(f"relative squared errors: {squared[0]:.3g}, {squared[1]:.3g}")
    print(f"operator, largest error of an entry: {fit_operator()[1]:.3g}")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE")
    parser.add_argument("--errors", action="store_true")
    options = parser.parse_args(arguments)
    if options.errors:
        errors()
    if options.files:
        options.files[0].write_text(table_text(), encoding="utf-8")
        options.files[1].write_text(product_text(), encoding="utf-8")
        options.files[2].write_text(operator_text(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
