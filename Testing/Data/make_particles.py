#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes particles.vtp of Testing/Data: 3,000 spheres at random in a flat box.

    make_particles.py [FOLDER]

Point data `radius`: 0.5 to 1.3, in the units of the box of 100 x 50 x 100. Single precision, from a
generator of a fixed seed. Needs VTK and numpy.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

NAME = "particles.vtp"
COUNT = 3000
LOWER, UPPER = (-50, -20, -50), (50, 30, 50)
RADII = (0.5, 1.3)


def make() -> tuple[np.ndarray, np.ndarray]:
    """Return places, (count, 3), and radii."""
    random = np.random.Generator(np.random.PCG64(5))
    places = random.uniform(LOWER, UPPER, (COUNT, 3))
    return places.astype(np.float32), random.uniform(*RADII, COUNT).astype(np.float32)


def main() -> int:
    """Write the file."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    places, radii = make()
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data.SetPoints(points)
    array = numpy_to_vtk(radii, deep=True)
    array.SetName("radius")
    data.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(folder / NAME))
    writer.SetInputData(data)
    writer.SetHeaderTypeToUInt32()
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOn()
    writer.SetCompressorTypeToZLib()
    return 0 if writer.Write() else 1


if __name__ == "__main__":
    sys.exit(main())
