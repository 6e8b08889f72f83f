#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes protein_1tii_modes.npz of Testing/Data: how the protein of protein_1tii.pdb would swing.

    make_modes.py [FOLDER]

The three slowest modes of an elastic network: springs between alpha carbons that are 15 Angstroms
apart or less, all of the same strength (Atilgan, Durell, Jernigan, Demirel, Keskin, Bahar 2001,
"Anisotropy of fluctuation dynamics of proteins with an elastic network model"). No force field, no
time scale: it is data that moves as proteins move, small and the same everywhere. Arrays:

- `residues` (atoms, uint16): the alpha carbon that each atom of the file which is no hetero atom
  moves with
- `modes` (3, residues, 3, float16): displacements, of a root mean square of 1
- `periods` (3, float32): of each mode, over that of the first

Needs numpy alone.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

REACH = 15.0
"""Angstroms."""
MODES = 3
NAME = "protein_1tii_modes.npz"


def read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return places of alpha carbons, and for each atom the number of its own one."""
    carbons: list[tuple[float, float, float]] = []
    numbers: dict[str, int] = {}
    keys = []
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("ATOM"):
            key = line[21:27]
            keys.append(key)
            if line[12:16].strip() == "CA" and key not in numbers:
                numbers[key] = len(carbons)
                carbons.append((float(line[30:38]), float(line[38:46]), float(line[46:54])))
    return np.array(carbons), np.array([numbers[key] for key in keys], np.uint16)


def find_modes(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return displacements and frequencies of the slowest modes that are no rigid motion."""
    count = len(places)
    apart = places[:, None] - places[None]
    squared = (apart**2).sum(axis=-1)
    near = (squared < REACH**2) & (squared > 0.0)
    hessian = np.zeros((count, 3, count, 3))
    strength = near / np.where(near, squared, 1.0)
    blocks = -apart[..., :, None] * apart[..., None, :] * strength[..., None, None]
    for i in range(count):
        hessian[i, :, :, :] = blocks[i].transpose(1, 0, 2)
        hessian[i, :, i, :] = -blocks[i].sum(axis=0)
    stiffness, vectors = np.linalg.eigh(hessian.reshape(3 * count, 3 * count))
    chosen = vectors.T[6 : 6 + MODES].reshape(MODES, count, 3)
    # The sign of an eigenvector is free: the largest component is made positive.
    for mode in chosen:
        mode *= np.sign(mode.flat[np.abs(mode).argmax()])
    size = np.sqrt((chosen**2).sum(axis=-1).mean(axis=-1))
    return chosen / size[:, None, None], np.sqrt(stiffness[6 : 6 + MODES])


def main() -> int:
    """Write the file into the folder that the command line names, or beside this file."""
    here = Path(__file__).resolve().parent
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else here
    places, residues = read(here / "protein_1tii.pdb")
    modes, frequencies = find_modes(places)
    np.savez_compressed(
        folder / NAME,
        residues=residues,
        modes=modes.astype(np.float16),
        periods=(frequencies[0] / frequencies).astype(np.float32),
    )
    print(folder / NAME)
    return 0


if __name__ == "__main__":
    sys.exit(main())
