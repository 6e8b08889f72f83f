# SPDX-License-Identifier: BSD-3-Clause
"""The list of changes, and what several of them are made of."""

import numpy as np
from rooms import RED, make_ball
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

BLUE = (0.1, 0.1, 0.9)

# Each makes a prop and what changes it.
CHANGES = {}
# Names of the changes that are drawn one by one; the others are drawn in groups.
ALONE = []


def change(function):
    CHANGES[function.__name__] = function
    return function


def change_alone(function):
    ALONE.append(function.__name__)
    return change(function)


def make_sheet() -> vtkPlaneSource:
    sheet = vtkPlaneSource()
    sheet.SetOrigin(-0.5, 0.1, 0)
    sheet.SetPoint1(-0.5, 0.9, 0)
    sheet.SetPoint2(0.5, 0.1, 0)
    return sheet


def make_image(color) -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(4, 4, 1)
    pixels = np.full((16, 3), np.array(color) * 255, np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    return image


def paint(image: vtkImageData, color) -> None:
    scalars = image.GetPointData().GetScalars()
    vtk_to_numpy(scalars)[:] = np.array(color) * 255
    scalars.Modified()


def make_halves() -> vtkTexture:
    """A texture with a red and a blue half."""
    image = vtkImageData()
    image.SetDimensions(2, 1, 1)
    pixels = np.array((RED, BLUE)) * 255
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.astype(np.uint8), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    return texture


def make_mesh(ball=None):
    """Return a prop with data of its own, and the data."""
    ball = ball or make_ball()
    ball.Update()
    mesh = ball.GetOutput()
    prop = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(*RED)
    return prop, mesh


def write(array, values) -> None:
    vtk_to_numpy(array)[:] = values
    array.Modified()


def make_table(*colors) -> vtkLookupTable:
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    for number, color in enumerate(colors):
        table.SetTableValue(number, *color, 1)
    return table
