# SPDX-License-Identifier: BSD-3-Clause
"""The actors of a scene file: geometry, colour, material."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

from vtkindirect import arrays, colormaps, objects, pipeline, sources
from vtkindirect.errors import SceneError, UsageError
from vtkindirect.schema import fail, member, optional

Values = dict[str, Any]
Read = Callable[[Path], vtkDataSet]

DIRECT_COLORS = "RGB"
RADIUS = "Radius"
"""Point data of points that are shown as spheres."""


def what(values: Values) -> str:
    """Return what an actor of a scene file shows: its file, or its source by its name."""
    if values.get("file") is not None:
        return Path(values["file"]).name
    source = values.get("source")
    return source if isinstance(source, str) else next(iter(source or {}), "")


def _geometry(values: Values, path: str, directory: Path, read: Read) -> vtkPolyData:
    """Read or make the geometry of an actor and take it through its pipeline."""
    if values["source"] is not None:
        data = sources.build(values, path)
    else:
        try:
            data = read(directory / values["file"])
        except UsageError as error:
            raise SceneError(f"{member(path, 'file')}: {error}") from None
    data = pipeline.run(data, values["pipeline"], member(path, "pipeline"))
    if values["spheres"] is not None:
        points = _spheres(data, optional(values["spheres"]), member(path, "spheres"))
        check_finite(points, path)
        return points
    surface = objects.surface_of(data, path)
    if surface.GetNumberOfCells() == 0:
        raise fail(
            path,
            "has points but no cells to show: give it spheres, or put glyph_spheres in its pipeline",
        )
    check_finite(surface, path)
    return surface


def _spheres(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    """Return points as vertices with their radii as point data."""
    points = pipeline.points_of(data)
    count = points.GetNumberOfPoints()
    radii = np.full(count, values["radius"], np.float32)
    if values["scale_by"] is not None:
        place = member(path, "scale_by")
        found = arrays.find(points, values["scale_by"], place, on_cells=False)
        radii *= found.numbers().reshape(count, -1)[:, 0]
        if not (np.isfinite(radii) & (radii >= 0.0)).all():
            raise fail(place, f"array '{found.name}' has values that are no radii")
    array = numpy_to_vtk(radii, deep=True)
    array.SetName(RADIUS)
    points.GetPointData().AddArray(array)
    places = np.arange(count + 1, dtype=np.int64)
    vertices = vtkCellArray()
    vertices.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True) for part in (places, places[:-1])))
    points.SetVerts(vertices)
    return points


def check_finite(surface: vtkPolyData, path: str) -> None:
    """Raise when a point or a normal is NaN or infinite."""
    points = surface.GetPoints().GetData()
    if not arrays.finite(points):
        rows = np.isfinite(arrays.Found(points, True).numbers()).all(axis=1)
        raise fail(path, f"point {int(np.argmin(rows))} is not finite (NaN or infinity)")
    if not arrays.finite(surface.GetPointData().GetNormals()):
        raise fail(path, "has normals that are not finite (NaN or infinity)")


def _show_direct(mapper: vtkPolyDataMapper, found: arrays.Found) -> None:
    """Take the bytes of an array as colours."""
    mapper.ScalarVisibilityOn()
    mapper.SelectColorArray(found.name)
    if found.on_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SetColorModeToDirectScalars()


def _is_direct(found: arrays.Found) -> bool:
    array = found.array
    return array.GetDataTypeAsString() == "unsigned char" and array.GetNumberOfComponents() >= 3


def direct_colors(surface: vtkPolyData, name: str = DIRECT_COLORS) -> arrays.Found | None:
    """Return the array of colours called `name`, if the data has one."""
    if name not in arrays.names(surface):
        return None
    found = arrays.find(surface, name, "")
    return found if _is_direct(found) else None


def _show_scalars(
    mapper: vtkPolyDataMapper, surface: vtkPolyData, scalars: Values, path: str
) -> None:
    """Colour by an array: bytes of three components as they are, anything else by a map."""
    found = arrays.find(surface, scalars["array"], member(path, "array"))
    if not _is_direct(found) and not arrays.finite(found.array):
        raise fail(member(path, "array"), f"array '{found.name}' has values that are not finite")
    _show_found(mapper, found, scalars, path)


def _show_found(
    mapper: vtkPolyDataMapper, found: arrays.Found, scalars: Values, path: str
) -> None:
    """Colour by an array that is there; `scalars` has the map and maybe the range."""
    _show_direct(mapper, found)
    if _is_direct(found):
        return
    distinct: list[float] = []
    if colormaps.is_categorical(scalars["map"]):
        distinct = np.unique(found.numbers()).tolist()
        if len(distinct) > 1024:
            raise fail(
                member(path, "map"),
                f"is for categories, and array '{found.name}' has {len(distinct)} distinct values",
            )
    span = list(scalars.get("range") or found.span)
    if span[0] == span[1]:
        span[1] = span[0] + max(1.0, abs(span[0]))
    mapper.SetColorModeToMapScalars()
    table = colormaps.lookup_table(scalars["map"], span, distinct)
    table.SetNanColor(*colormaps.MISSING, 1.0)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()


def _set_material(prop: vtkProperty, values: Values) -> None:
    prop.SetColor(values["color"] or (1.0, 1.0, 1.0))
    prop.SetAmbient(values["ambient"])
    prop.SetDiffuse(values["diffuse"])
    prop.SetSpecular(values["specular"])
    prop.SetSpecularPower(values["specular_power"])
    prop.SetOpacity(values["opacity"])
    {
        "phong": prop.SetInterpolationToPhong,
        "flat": prop.SetInterpolationToFlat,
        "gouraud": prop.SetInterpolationToGouraud,
        "pbr": prop.SetInterpolationToPBR,
    }[values["interpolation"]]()
    prop.SetMetallic(values["metallic"])
    prop.SetRoughness(values["roughness"])
    prop.SetBaseIOR(values["refraction_index"])


def show_spheres(points: vtkPolyData) -> vtkActor:
    """Return an actor that shows points as spheres of the point data `RADIUS`, in white."""
    mapper = vtkOpenGLSphereMapper()
    mapper.SetInputData(points)
    mapper.SetScaleArray(RADIUS)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def show_surface(surface: vtkPolyData) -> vtkActor:
    """Return an actor that shows a surface in white, without any scalars."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def color_by(actor: vtkActor, found: arrays.Found) -> None:
    """Colour an actor by an array of bytes."""
    _show_direct(actor.GetMapper(), found)


def color_by_category(actor: vtkActor, name: str) -> None:
    """Colour an actor by an array of a few values, a colour for each."""
    mapper = actor.GetMapper()
    _show_scalars(mapper, mapper.GetInput(), {"array": name, "map": "tab10"}, "")


def color_by_values(actor: vtkActor, found: arrays.Found) -> tuple[float, float] | None:
    """Colour an actor by an array as ParaView and PyVista do; returns the range, or None.

    The map is `colormaps.DEFAULT` over all values, of vectors over their lengths; bytes of three
    or four components are colours. An array with one value says nothing, and the actor stays as it
    is.
    """
    mapper = actor.GetMapper()
    vectors = found.array.GetNumberOfComponents() > 1
    low, high = found.array.GetFiniteRange(-1 if vectors else 0)
    if not _is_direct(found) and not low < high:
        return None
    _show_found(mapper, found, {"map": colormaps.DEFAULT, "range": (low, high)}, "")
    if vectors and not _is_direct(found):
        mapper.GetLookupTable().SetVectorModeToMagnitude()
    return low, high


def build(values: Values, path: str, directory: Path, read: Read) -> vtkActor:
    """Make a checked actor. Files are relative to `directory`."""
    values = optional(values)
    surface = _geometry(values, path, directory, read)
    actor = show_surface(surface) if values["spheres"] is None else show_spheres(surface)
    if values["scalars"] is not None:
        _show_scalars(actor.GetMapper(), surface, values["scalars"], member(path, "scalars"))
    elif values["color"] is None:
        found = direct_colors(surface)
        if found is not None:
            color_by(actor, found)
    _set_material(actor.GetProperty(), values)
    if values["transform"] is not None:
        elements = vtkMatrix4x4()
        elements.DeepCopy(values["transform"])
        actor.SetUserMatrix(elements)
    actor.SetVisibility(values["visible"])
    return actor
