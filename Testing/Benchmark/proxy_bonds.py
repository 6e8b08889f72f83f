#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bonds as rows of spheres: error against rays of a ball-and-stick molecule, and the jump.

    Testing/Benchmark/proxy_bonds.py

Prints a table of Documentation/methods/sphere-proxies.md: part of the protein, drawn by
vtkMoleculeMapper's balls and sticks over a ground under a uniform sky. The light of the sky by
spheres, by spheres without bonds and by depth maps is held to rays that meet spheres, cylinders
and the ground at places and normals that the pass has seen itself; and the frame in motion to the
still one.
"""

from __future__ import annotations

import sys

import numpy as np
import vtkindirect
from proxy_pass import FOLDER, Spheres, View, compare, spheres_actor
from vtkindirect import methods
from vtkmodules.vtkCommonDataModel import vtkMolecule
from vtkmodules.vtkDomainsChemistry import vtkPeriodicTable
from vtkmodules.vtkDomainsChemistryOpenGL2 import vtkOpenGLMoleculeMapper
from vtkmodules.vtkRenderingCore import vtkActor

DIRECTIONS = 256
NUMBERS = {"C": 6, "N": 7, "O": 8, "S": 16}
ATOMS = 150
LONGEST_BOND = 2.0  # Angstroms, without hydrogen


def read(atoms: int) -> tuple[np.ndarray, list[int], list[tuple[int, int]]]:
    """Return places, atomic numbers and bonds of the first atoms of the protein."""
    text = (FOLDER / "Data" / "protein_1tii.pdb").read_text(encoding="ascii")
    lines = [line for line in text.splitlines() if line.startswith("ATOM")][:atoms]
    places = np.array([[float(line[i : i + 8]) for i in (30, 38, 46)] for line in lines])
    numbers = [NUMBERS.get(line[76:78].strip(), 6) for line in lines]
    far = np.linalg.norm(places[:, None] - places, axis=2)
    first, second = np.nonzero(np.triu(far < LONGEST_BOND, 1))
    return places, numbers, list(zip(first.tolist(), second.tolist()))


class BallsAndSticks(Spheres):
    """Rays that meet spheres, cylinders between them and the ground."""

    def __init__(
        self, spheres: np.ndarray, plane: np.ndarray, ends: np.ndarray, radius: float
    ) -> None:
        super().__init__(spheres, plane)
        self.starts = ends[:, 0]
        self.axes = ends[:, 1] - ends[:, 0]
        self.lengths = np.linalg.norm(self.axes, axis=1)
        self.axes /= self.lengths[:, None]
        self.radius = radius

    def nearest(self, place: np.ndarray, ways: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return distances, and -1 for what is met: only whether there is something counts."""
        t, which = super().nearest(place, ways)
        offset = place - self.starts
        along = (offset * self.axes).sum(axis=1)
        flat = offset - along[:, None] * self.axes
        slope = ways @ self.axes.T
        # Coefficients of the squared distance from the axis along a ray.
        a = 1.0 - slope**2
        b = ways @ flat.T
        c = (flat**2).sum(axis=1) - self.radius**2
        with np.errstate(divide="ignore", invalid="ignore"):
            hit = (-b - np.sqrt(b**2 - a * c)) / a
            at = along + hit * slope
        met = (hit > self.lift) & (at > 0) & (at < self.lengths)
        return np.minimum(t, np.where(met, hit, np.inf).min(axis=1)), which


def measure(style: str, atoms: int = ATOMS) -> dict[str, float]:
    """Print the rows of one style of drawing, and return the nRMSE of each."""
    places, numbers, bonds = read(atoms)
    molecule = vtkMolecule()
    for number, place in zip(numbers, places):
        molecule.AppendAtom(number, *place)
    for first, second in bonds:
        molecule.AppendBond(first, second, 1)
    mapper = vtkOpenGLMoleculeMapper()
    getattr(mapper, f"Use{style}Settings")()
    mapper.SetInputData(molecule)
    if mapper.GetAtomicRadiusTypeAsString() == "UnitRadius":
        radii = np.ones(len(places))
    else:
        radii = np.array([vtkPeriodicTable().GetVDWRadius(number) for number in numbers])
    spheres = np.c_[places, radii * mapper.GetAtomicRadiusScaleFactor()]
    mapper.SetBondColorModeToSingleColor()
    actor = vtkActor()
    actor.SetMapper(mapper)
    view = View([actor], np.array((places.min(axis=0), places.max(axis=0))), (320, 240))
    ends = np.array([(places[a], places[b]) for a, b in bonds])
    rays = BallsAndSticks(spheres, view.plane, ends, mapper.GetBondRadius())

    indirect = methods.enable(view.renderer, "proxies", environment=(1.0, 1.0, 1.0))
    view.window.SetDesiredUpdateRate(15.0)
    view.window.Render()
    (y, x), seen, normals = view.receivers()
    true = np.array([rays.sky(p, n, DIRECTIONS, i) for i, (p, n) in enumerate(zip(seen, normals))])

    def sky() -> np.ndarray:
        return vtkindirect.copy_buffer(view.renderer, "sky")[..., 0]

    errors: dict[str, float] = {}

    def row(label: str, image: np.ndarray) -> None:
        errors[label] = float(np.sqrt(((image[y, x] - true) ** 2).mean()) / true.mean())
        print(f"| {style} | {label} | {compare(image[y, x], true)} |", flush=True)

    print(
        f"{len(places)} atoms, {len(bonds)} bonds,"
        f" {indirect.GetEstimator().GetNumberOfSpheres()} spheres"
    )
    by_spheres = sky()
    row("spheres", by_spheres)
    # The same surfaces seen, and the bonds' spheres left out by spheres that are given.
    _, data = spheres_actor(spheres)
    data.GetPointData().GetArray("size").SetName("Radius")
    indirect.GetEstimator().SetProxies(actor, data)
    view.window.Render()
    atoms_alone = sky()
    row("spheres of atoms alone", atoms_alone)
    indirect.SetEstimator(None)
    images = {}
    for label, rate in (("64 maps, moving", 15.0), ("256 maps, still", 1e-4)):
        view.window.SetDesiredUpdateRate(rate)
        for _ in range(20):
            view.window.Render()
        images[label] = sky()
        row(label, images[label])
    still = images["256 maps, still"]
    for label, image in (("spheres", by_spheres), ("spheres of atoms alone", atoms_alone)):
        change = image - still
        tiles = [
            abs(change[j : j + 16, i : i + 16].mean())
            for j in range(0, 240, 16)
            for i in range(0, 320, 16)
        ]
        print(
            f"| {style} | {label}, jump | mean {change.mean() / still.mean():+.1%} |"
            f" largest tile {max(tiles) / still.mean():.3f} |"
            f" RMS {np.sqrt((change**2).mean()) / still.mean():.3f} |"
        )
    view.close()
    return errors


def main() -> int:
    """Print the table."""
    for style in ("BallAndStick", "LiquoriceStick"):
        measure(style)
    return 0


if __name__ == "__main__":
    sys.exit(main())
