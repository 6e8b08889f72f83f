# SPDX-License-Identifier: BSD-3-Clause
"""Changes of data, of mappers' tables and of clipping planes."""

import numpy as np
from rooms import RED, make_actor, make_ball, make_mapper
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper

from .parts import BLUE, change, change_alone, make_halves, make_mesh, make_sheet, make_table, write


def make_plane():
    """Return a plane that cuts a ball in halves."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0.5, 0)
    plane.SetNormal(1, 0, 0)
    return plane


@change_alone
def plane_origin():
    prop = make_actor(make_ball())
    plane = make_plane()
    prop.GetMapper().AddClippingPlane(plane)
    return prop, lambda: plane.SetOrigin(0.3, 0.5, 0)


@change_alone
def plane_normal():
    prop, _ = plane_origin()
    return prop, lambda: prop.GetMapper().GetClippingPlanes().GetItem(0).SetNormal(-1, 0, 0)


@change_alone
def plane_removed():
    prop, _ = plane_origin()
    return prop, lambda: prop.GetMapper().RemoveAllClippingPlanes()


def make_scalars(table):
    ball = make_ball()
    ball.Update()
    mesh = ball.GetOutput()
    count = mesh.GetNumberOfPoints()
    mesh.GetPointData().SetScalars(numpy_to_vtk(np.full(count, 0.5, np.float32), deep=True))
    prop = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(table)
    prop.SetMapper(mapper)
    return prop, mesh


@change_alone
def lookup_table():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(1)
    table.SetTableValue(0, *RED, 1)
    return make_scalars(table)[0], lambda: table.SetTableValue(0, *BLUE, 1)


@change_alone
def color_transfer_function():
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0, *RED)
    colors.AddRGBPoint(1, *RED)

    def turn() -> None:
        colors.RemoveAllPoints()
        colors.AddRGBPoint(0, *BLUE)

    return make_scalars(colors)[0], turn


@change_alone
def scalars_in_place():
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0.5, *RED)
    colors.AddRGBPoint(1, *BLUE)
    prop, mesh = make_scalars(colors)

    def turn() -> None:
        scalars = mesh.GetPointData().GetScalars()
        vtk_to_numpy(scalars)[:] = 1
        scalars.Modified()

    return prop, turn


@change_alone
def points_in_place():
    prop, mesh = make_mesh()

    def shrink() -> None:
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points[:] = (points - (0, 0.5, 0)) * 0.5 + (0, 0.5, 0)
        mesh.GetPoints().Modified()

    return prop, shrink


@change
def normals_in_place():
    prop, mesh = make_mesh()
    return prop, lambda: write(mesh.GetPointData().GetNormals(), (0, 1, 0))


@change
def coordinates_in_place():
    prop, mesh = make_mesh(make_sheet())
    prop.SetTexture(make_halves())
    prop.GetProperty().SetColor(1, 1, 1)
    return prop, lambda: write(mesh.GetPointData().GetTCoords(), (1, 0))


@change
def cells_in_place():
    prop, mesh = make_mesh()

    def cut() -> None:
        cells = mesh.GetPolys()
        points = vtk_to_numpy(cells.GetConnectivityArray())
        points[: len(points) // 2] = points[0]
        cells.GetConnectivityArray().Modified()
        cells.Modified()

    return prop, cut


@change
def cells_replaced():
    prop, mesh = make_mesh()
    half = vtkCellArray()
    half.DeepCopy(mesh.GetPolys())
    half.ResizeExact(half.GetNumberOfCells() // 2, 3 * (half.GetNumberOfCells() // 2))
    return prop, lambda: mesh.SetPolys(half)


@change
def input_older():
    older = make_ball(0.2)
    older.Update()
    prop, _ = make_mesh()
    return prop, lambda: prop.GetMapper().SetInputData(older.GetOutput())


@change
def mapper_older():
    older = make_mapper(make_ball(0.2))
    prop = make_actor(make_ball())
    return prop, lambda: prop.SetMapper(older)


@change
def plane_added():
    prop = make_actor(make_ball())
    plane = make_plane()
    return prop, lambda: prop.GetMapper().AddClippingPlane(plane)


@change
def scalar_visibility():
    prop, _ = make_scalars(make_table(RED))
    prop.GetProperty().SetColor(*BLUE)
    return prop, lambda: prop.GetMapper().ScalarVisibilityOff()


@change
def array_selected():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    count = mesh.GetNumberOfPoints()
    for name, value in (("first", 0.2), ("second", 0.8)):
        array = numpy_to_vtk(np.full(count, value, np.float32), deep=True)
        array.SetName(name)
        mesh.GetPointData().AddArray(array)
    prop.GetMapper().SetScalarModeToUsePointFieldData()
    prop.GetMapper().SelectColorArray("first")
    return prop, lambda: prop.GetMapper().SelectColorArray("second")


@change
def cell_scalars_in_place():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    values = numpy_to_vtk(np.full(mesh.GetNumberOfCells(), 0.2, np.float32), deep=True)
    mesh.GetCellData().SetScalars(values)
    prop.GetMapper().SetScalarModeToUseCellData()
    return prop, lambda: write(values, 0.8)


@change
def scalar_range():
    prop, _ = make_scalars(make_table(RED, BLUE))
    prop.GetMapper().SetScalarRange(0.4, 2)
    return prop, lambda: prop.GetMapper().SetScalarRange(-1, 0.6)


@change
def table_range():
    table = make_table(RED, BLUE)
    table.SetTableRange(0.4, 2)
    prop, _ = make_scalars(table)
    prop.GetMapper().UseLookupTableScalarRangeOn()
    return prop, lambda: table.SetTableRange(-1, 0.6)


@change
def table_of_missing_values():
    table = make_table(BLUE)
    table.SetNanColor(*RED, 1)
    prop, mesh = make_scalars(table)
    write(mesh.GetPointData().GetScalars(), np.nan)
    return prop, lambda: table.SetNanColor(*BLUE, 1)


@change
def array_component():
    prop, mesh = make_scalars(make_table(RED, BLUE))
    values = np.full((mesh.GetNumberOfPoints(), 2), (0.2, 0.8), np.float32)
    array = numpy_to_vtk(values, deep=True)
    array.SetName("both")
    mesh.GetPointData().AddArray(array)
    mapper = prop.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.GetLookupTable().SetVectorModeToComponent()
    mapper.ColorByArrayComponent("both", 0)
    return prop, lambda: mapper.ColorByArrayComponent("both", 1)
