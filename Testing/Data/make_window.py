#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes window_evening.exr of Testing/Data: what a window of area_apartment shows, 48 x 40, halves.

    make_window.py [FOLDER]

Needs the package vtkindirect with OpenEXR. The first row is the lower one. Values are radiances
relative to the brightest; the plane that the scene draws behind the window has the same colours.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

COLUMNS, ROWS = 48, 40
NAME = "window_evening.exr"

# From the horizon on the right, where the sun has set, to the sky on the upper left; evenly spaced.
COLORS = np.array(
    [[1.0, 0.55, 0.22], [1.0, 0.74, 0.45], [0.72, 0.72, 0.7], [0.42, 0.56, 0.8], [0.25, 0.42, 0.78]]
)
RISE = 0.8  # how much of the way up is due to the height; the rest to the distance from the right


def evening() -> np.ndarray:
    """Return the image, (rows, columns, 3), the lower row first."""
    across = (np.arange(COLUMNS) + 0.5) / COLUMNS
    height = (np.arange(ROWS) + 0.5) / ROWS
    place = (RISE * height[:, None] + (1.0 - RISE) * (1.0 - across)) * (len(COLORS) - 1)
    knots = np.arange(len(COLORS))
    return np.stack([np.interp(place, knots, COLORS[:, c]) for c in range(3)], axis=-1)


def main() -> int:
    """Write the image into the folder that the command line names, or beside this file."""
    from vtkindirect import images

    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    images.write_exr(folder / NAME, evening().astype(np.float32))
    print(folder / NAME)
    return 0


if __name__ == "__main__":
    sys.exit(main())
