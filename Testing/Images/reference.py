# SPDX-License-Identifier: BSD-3-Clause
"""Data of baselines beside a picture: block means of float buffers, and the metrics.

The same in C++: Cxx/ImageReference.cxx. The tolerances of both are in tolerance.json.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

SCHEMA = "vtkindirect.image/1"
PLACE = Path(__file__).resolve().parent
BASELINES = PLACE / "Baseline"
TOLERANCE: dict[str, Any] = json.loads((PLACE / "tolerance.json").read_text(encoding="utf-8"))
WIDTH, HEIGHT = 16, 12
ALTERNATIVE_SHARE = 1 / 2
"""Largest share of blocks in which an alternative may differ from its case's baseline."""

Grids = dict[str, np.ndarray]


def make_grid(buffer: np.ndarray) -> np.ndarray:
    """Return the means over blocks of an array of rows, columns, components."""
    rows = [j * buffer.shape[0] // HEIGHT for j in range(HEIGHT + 1)]
    columns = [i * buffer.shape[1] // WIDTH for i in range(WIDTH + 1)]
    return np.array(
        [
            [
                buffer[rows[j] : rows[j + 1], columns[i] : columns[i + 1]].mean(
                    axis=(0, 1), dtype=np.float64
                )
                for i in range(WIDTH)
            ]
            for j in range(HEIGHT)
        ]
    )


class Deviation(NamedTuple):
    """Differences of blocks in units of their tolerance."""

    worst: float
    share: float  # share of blocks with a deviation above 1

    @property
    def is_small(self) -> bool:
        """Return whether that is within the tolerance."""
        return self.share <= TOLERANCE["block_share"] and self.worst <= TOLERANCE["block_limit"]

    def __str__(self) -> str:
        return (
            f"off by up to {self.worst:.4g} of the tolerance; "
            f"by more than it in {100 * self.share:.4g} % of the blocks"
        )


def deviation(now: np.ndarray, stored: np.ndarray) -> Deviation:
    """Return how far a grid is from a stored one."""
    if now.shape != stored.shape or not np.isfinite(now).all():
        return Deviation(float("inf"), 1.0)
    allowed = TOLERANCE["block_relative"] * np.abs(stored)
    allowed += TOLERANCE["block_absolute"] * np.abs(stored).mean()
    difference = np.abs(now - stored)
    with np.errstate(divide="ignore", invalid="ignore"):
        blocks = np.where(difference > 0, difference / allowed, 0.0).max(axis=2)
    return Deviation(float(blocks.max()), float((blocks > 1).mean()))


def is_out_of_date(alternative: Path) -> bool:
    """Return whether an alternative is of another state of the project than the baseline beside it.

    Another driver or version of VTK draws a part of the picture otherwise: up to 36 % of the blocks
    of the alternatives there are. Where light has changed since, nearly all blocks differ.
    """
    case = alternative.stem.rpartition("_")[0]
    paths = alternative.with_name(f"{case}.json"), alternative.with_suffix(".json")
    stored, grids = (read_grids(path) if path.exists() else {} for path in paths)
    return stored.keys() != grids.keys() or any(
        deviation(grids[name], grid).share > ALTERNATIVE_SHARE for name, grid in stored.items()
    )


def pixel_difference(now: np.ndarray, stored: np.ndarray) -> tuple[float, float]:
    """Return the mean difference of two pictures of 8 bits, and the share of pixels off."""
    if now.shape != stored.shape:
        return 255.0, 1.0
    steps = np.abs(now.astype(int) - stored.astype(int))
    off = steps.max(axis=2) > TOLERANCE["pixel_step"]
    return float(steps.mean()), float(off.mean())


def pixels_agree(now: np.ndarray, stored: np.ndarray) -> bool:
    """Return whether two pictures of 8 bits are the same within the tolerance."""
    mean, share = pixel_difference(now, stored)
    return mean <= TOLERANCE["pixel_mean"] and share <= TOLERANCE["pixel_share"]


def read_grids(path: Path) -> Grids:
    """Return the grids of a file by their names."""
    file = json.loads(path.read_text(encoding="utf-8"))
    if file["schema"] != SCHEMA:
        raise ValueError(f"{path}: the schema is not {SCHEMA}")
    return {
        name: np.array(grid["rows"]).reshape(HEIGHT, WIDTH, grid["components"]) * grid["unit"]
        for name, grid in file["buffers"].items()
    }


def write_grids(path: Path, grids: Grids) -> None:
    """Write grids as whole numbers of a unit, a row a line.

    Rounding costs up to a quarter of the absolute part of the tolerance.
    """
    parts = []
    for name, grid in sorted(grids.items()):
        unit = float(f"{0.5 * TOLERANCE['block_absolute'] * np.abs(grid).mean():.3g}") or 1.0
        rows = [
            "[" + ",".join(str(round(value / unit)) for value in row.ravel().tolist()) + "]"
            for row in grid
        ]
        parts.append(
            f'"{name}":{{"components":{grid.shape[2]},"unit":{unit},"rows":[\n'
            + ",\n".join(rows)
            + "]}"
        )
    text = f'{{"schema":"{SCHEMA}","buffers":{{\n' + ",\n".join(parts) + "}}\n"
    path.write_text(text, encoding="utf-8")
