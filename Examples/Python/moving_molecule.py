#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A protein that swings under a bright sky: every atom shadows the ground and its neighbours.

    moving_molecule.py [PROTEIN.pdb MODES.npz]

Atoms move in every frame, and with the method "proxies" that costs no more than if they stood: the
light of the sky is summed over them as spheres, without maps. Writes moving_molecule.png, six
frames side by side. The files are by default those that vtkindirect was installed or built with;
Testing/Data/make_modes.py of the sources says what the motion is.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOChemistry import vtkPDBReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

import vtkindirect
from vtkindirect import images, locations

if len(sys.argv) not in (1, 3):
    sys.exit("usage: moving_molecule.py [PROTEIN.pdb MODES.npz]")
try:
    protein, modes = sys.argv[1:] or (
        locations.data_file("protein_1tii.pdb"),
        locations.data_file("protein_1tii_modes.npz"),
    )
    motion = np.load(modes)
except (vtkindirect.IndirectError, OSError, ValueError) as error:
    sys.exit(f"moving_molecule.py: {error}; name PROTEIN.pdb and MODES.npz")
FRAMES = 6
SWING = 3.0  # Angstroms, root mean square, of the slowest mode

reader = vtkPDBReader()
reader.SetFileName(str(protein))
reader.Update()
read = reader.GetOutput()
if read.GetNumberOfPoints() == 0:
    sys.exit(f"moving_molecule.py: {protein} holds no atoms")
kept = vtk_to_numpy(read.GetPointData().GetArray("ishetatm")) == 0
rest = vtk_to_numpy(read.GetPoints().GetData())[kept].astype(np.float32)
radii = vtk_to_numpy(read.GetPointData().GetArray("radius")).reshape(len(kept), -1)[kept, 0]


def place(phase):
    """Return where the atoms are at a phase of the slowest mode, from 0 to 1."""
    moved = rest.copy()
    for mode, period in zip(motion["modes"], motion["periods"]):
        swing = SWING * period * np.sin(2.0 * np.pi * phase / period)
        moved += swing * mode[motion["residues"]].astype(np.float32)
    return moved


atoms = vtkPolyData()
points = vtkPoints()
points.SetData(numpy_to_vtk(rest, deep=True))
atoms.SetPoints(points)
sizes = numpy_to_vtk(radii.astype(np.float32), deep=True)
sizes.SetName("radius")
atoms.GetPointData().AddArray(sizes)
cells = vtkCellArray()
for i in range(len(rest)):
    cells.InsertNextCell(1, [i])
atoms.SetVerts(cells)
mapper = vtkOpenGLSphereMapper()
mapper.SetInputData(atoms)
mapper.SetScaleArray("radius")
mapper.ScalarVisibilityOff()
molecule = vtkActor()
molecule.SetMapper(mapper)
molecule.GetProperty().SetColor(0.85, 0.6, 0.45)

ground = vtkPlaneSource()
ground.SetOrigin(-90, -27, 140)
ground.SetPoint1(190, -27, 140)
ground.SetPoint2(-90, -27, -110)
ground_mapper = vtkPolyDataMapper()
ground_mapper.SetInputConnection(ground.GetOutputPort())
plane = vtkActor()
plane.SetMapper(ground_mapper)
plane.GetProperty().SetColor(0.85, 0.85, 0.85)

renderer = vtkRenderer()
renderer.AutomaticLightCreationOff()
renderer.SetBackground(0.75, 0.82, 0.9)
renderer.AddActor(molecule)
renderer.AddActor(plane)
camera = renderer.GetActiveCamera()
camera.SetPosition(48, 75, 190)
camera.SetFocalPoint(48, 4, 8)
camera.SetViewAngle(32)
renderer.ResetCameraClippingRange()
window = vtkindirect.render_window((260, 240))
window.AddRenderer(renderer)

vtkindirect.enable(renderer, "proxies", environment=(1.0, 1.0, 1.0))
window.SetDesiredUpdateRate(15.0)
strip = []
for frame in range(FRAMES):
    vtk_to_numpy(points.GetData())[:] = place(frame / FRAMES)
    points.Modified()
    atoms.Modified()
    window.Render()
    strip.append(images.window_bytes(window))

picture = np.hstack(strip)
shown = vtkImageData()
shown.SetDimensions(picture.shape[1], picture.shape[0], 1)
colors = numpy_to_vtk(np.ascontiguousarray(picture[:, :, :3]).reshape(-1, 3), deep=True)
shown.GetPointData().SetScalars(colors)
writer = vtkPNGWriter()
writer.SetFileName("moving_molecule.png")
writer.SetInputData(shown)
writer.Write()
