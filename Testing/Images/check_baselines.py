# SPDX-License-Identifier: BSD-3-Clause
"""Check that the baselines are complete and small, and that the metrics find errors in each.

    check_baselines.py CASE...
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import reference
from cases import alternatives, read_png

MAXIMUM_BYTES = 2_000_000
STEP = 8
"""Offset of 255 for each pixel: VTK's own metric of versions before 9.4 ignores it."""
SCALE = 1.03
"""Factor of the irradiance: less than the effect of a wrong constant or a lost cosine."""


def check_picture(path: Path) -> list[str]:
    """Return the faults of one picture."""
    picture = read_png(path)
    if picture.dtype != np.uint8 or picture.shape[2] != 3:
        return [f"{path.name} is no picture of three components of eight bits"]
    faults = []
    lighter = np.minimum(picture.astype(int) + STEP, 255).astype(np.uint8)
    if reference.pixels_agree(lighter, picture):
        faults.append(f"{path.name}: {STEP} of 255 more would not be found")
    if picture.shape[0] > 192 or picture.shape[1] > 256:
        faults.append(f"{path.name} is too large")
    return faults


def check_grids(path: Path) -> list[str]:
    """Return the faults of the grids of one case."""
    faults = []
    for name, grid in reference.read_grids(path).items():
        kind = name.rpartition(".")[2]
        changed = grid * SCALE if kind == "irradiance" else grid + STEP / 255
        if reference.deviation(changed, grid).is_small:
            faults.append(f"{path.name}: a change of {name} would not be found")
        if reference.deviation(grid, grid).worst != 0:
            faults.append(f"{path.name}: {name} differs from itself")
    return faults


def main() -> int:
    """Print the faults; returns the exit code."""
    faults = []
    expected = set()
    for case in sys.argv[1:]:
        path = reference.BASELINES / f"{case}.png"
        if not path.exists():
            faults.append(f"{case} has no baseline")
            continue
        for picture in alternatives(path):
            expected.add(picture)
            faults += check_picture(picture)
            grids = picture.with_suffix(".json")
            if grids.exists():
                expected.add(grids)
                faults += check_grids(grids)
            if picture != path and reference.is_out_of_date(picture):
                faults.append(f"{picture.name} is out of date; renew it where {case} fails")
    found = set(reference.BASELINES.iterdir())
    faults += [f"{path.name} is no case's" for path in sorted(found - expected)]
    size = sum(path.stat().st_size for path in found)
    if size > MAXIMUM_BYTES:
        faults.append(f"{size} bytes of baselines, {MAXIMUM_BYTES} are allowed")
    for fault in faults:
        print(fault)
    print(f"{len(found)} files, {size} bytes, {len(faults)} faults")
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main())
