# SPDX-License-Identifier: BSD-3-Clause
"""VTK's filters and sources by the names of their classes, with properties by their names.

A property ``Name`` is what ``SetName`` sets: a number, a list of them, true or false, a text, the
name of an enumerated value in lower case, or another object of VTK, {"vtkPlane": {…}}. The array
that a filter works on is the property ``InputArrayToProcess``, by the array's name.
"""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import Any

import vtkmodules
from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkDataSetSurfaceFilter

from vtkindirect import arrays, messages, settings, working
from vtkindirect.errors import UsageError, suggestion
from vtkindirect.schema import fail, member

ARRAY = "InputArrayToProcess"

_MODULES = ("vtkFilters", "vtkImaging", "vtkCommonDataModel", "vtkCommonTransforms")
"""Modules whose classes a scene file may name begin so."""

_LIKELY = ("vtkFiltersCore", "vtkFiltersGeneral", "vtkFiltersSources", "vtkCommonDataModel")

# Properties of every filter; the pipeline sets the inputs.
_INHERITED = frozenset((*dir(vtkAlgorithm), "SetInputData", "SetOutput"))


def _members(module: str) -> dict[str, Any]:
    try:
        return vars(importlib.import_module(f"vtkmodules.{module}"))
    except ImportError:  # it needs what is not installed, such as MPI
        return {}


@cache
def _class(name: str) -> type | None:
    """Return a class that can be named; modules are loaded until one has it."""
    modules = [module.name for module in pkgutil.iter_modules(vtkmodules.__path__)]
    for module in (*_LIKELY, *(found for found in modules if found.startswith(_MODULES))):
        kind = _members(module).get(name)
        if isinstance(kind, type) and issubclass(kind, vtkObjectBase):
            return kind
    return None


def _all_names() -> list[str]:
    modules = [module.name for module in pkgutil.iter_modules(vtkmodules.__path__)]
    return [name for one in modules if one.startswith(_MODULES) for name in _members(one)]


def _create(name: str, path: str) -> Any:
    """Return a new object of a class by name."""
    kind = _class(name)
    if kind is None:
        hint = suggestion(name, _all_names())
        raise fail(path, f"VTK has no filter or source '{name}'{hint}")
    try:
        return kind()
    except (TypeError, NotImplementedError):
        raise fail(path, f"{name} is abstract, name a class that derives from it") from None


def _property_names(target: vtkObjectBase) -> list[str]:
    """Return what can be set; a step neither reads files of its own nor writes any."""
    names = [name for name in dir(target) if name.startswith("Set") and len(name) > 3]
    return [name[3:] for name in names if name not in _INHERITED and "File" not in name]


def _set_unreadable(target: vtkObjectBase, name: str, value: Any) -> None:
    """Set a property that VTK has no getter for, or each of its values by an index."""
    set_ = getattr(target, f"Set{name}")
    try:
        set_(value)
    except TypeError:
        for index, one in enumerate(value if isinstance(value, (list, tuple)) else [value]):
            set_(index, one)


def _set_value(target: vtkObjectBase, name: str, value: Any, path: str) -> None:
    """Set a property to what is no object; VTK must have taken it."""
    getter = getattr(target, f"Get{name}", None)
    try:
        current = getter() if getter is not None else None
    except TypeError:
        getter = None
    try:
        if getter is None:
            _set_unreadable(target, name, value)
            return
        if isinstance(value, str) and isinstance(current, (int, float, tuple)):
            if not settings.choices(target, name) and not hasattr(target, f"{name}On"):
                raise fail(path, f"must be a number, not '{value}'")
        settings.set_property(target, name, value)
    except UsageError as error:
        raise fail(path, str(error).removeprefix(f"{path}: ").removeprefix(f"{name}: ")) from None
    except (TypeError, ValueError, OverflowError) as error:
        raise fail(path, f"cannot be set to {value!r}: {error}") from None


def _connect(target: vtkObjectBase, name: str, part: Any, path: str) -> None:
    """Set a property to an object, or to what an algorithm makes."""
    if isinstance(part, vtkAlgorithm) and name.endswith("Connection"):
        part = part.GetOutputPort()
    elif isinstance(part, vtkAlgorithm) and name.endswith("Data"):
        part = output_of(part, path)
    try:
        getattr(target, f"Set{name}")(part)
    except TypeError as error:
        raise fail(path, f"cannot be a {part.GetClassName()}: {error}") from None


def configure(
    target: Any, properties: dict[str, Any], path: str, data: vtkDataSet | None = None
) -> Any:
    """Set properties of an object and return it; `data` is what a filter is going to work on."""
    for name, value in properties.items():
        place = member(path, name)
        if name == ARRAY and data is not None:
            found = value
            if not isinstance(value, arrays.Found):
                found = arrays.find(data, value, place)
            target.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
            continue
        known = _property_names(target)
        if name not in known:
            hint = suggestion(name, known)
            raise fail(place, f"{target.GetClassName()} has no such property{hint}")
        if isinstance(value, dict):
            if len(value) != 1:
                raise fail(place, "must hold exactly one class of VTK")
            ((kind, inner),) = value.items()
            inside = member(place, kind)
            if not isinstance(inner, dict):
                raise fail(inside, "must be an object of properties")
            value = configure(_create(kind, inside), inner, inside)
        if isinstance(value, vtkObjectBase):
            _connect(target, name, value, place)
        else:
            _set_value(target, name, value, place)
    return target


def filled(part: Any, values: dict[str, Any]) -> Any:
    """Return properties with values for ``$key``; those without a value are left out."""
    if isinstance(part, str) and part.startswith("$"):
        return values[part[1:]]
    if isinstance(part, dict):
        inner = {name: filled(one, values) for name, one in part.items()}
        return {name: value for name, value in inner.items() if value is not None}
    return part


def surface_of(data: vtkDataSet, path: str) -> vtkPolyData:
    """Return polygonal data as it is, and the outer surface of other cells."""
    if isinstance(data, vtkImageData):
        raise fail(path, "needs a surface, not image data: put a contour step before")
    if isinstance(data, vtkPolyData):
        return data
    outside = vtkDataSetSurfaceFilter()
    outside.SetInputData(data)
    return output_of(outside, path)


def output_of(algorithm: vtkAlgorithm, path: str) -> Any:
    """Return what an algorithm makes; what it reports is the error."""
    with messages.capture() as said, working.watching(algorithm):
        algorithm.Update()
        result = algorithm.GetOutputDataObject(0)
        if isinstance(result, vtkCompositeDataSet):
            surface = vtkCompositeDataGeometryFilter()
            surface.SetInputDataObject(result)
            surface.Update()
            result = surface.GetOutput()
    if said.errors:
        raise fail(path, f"{algorithm.GetClassName()}: {said.first_error()}")
    if not isinstance(result, vtkDataSet):
        raise fail(path, f"{algorithm.GetClassName()} makes nothing that has a surface")
    return result


def _fitting(algorithm: vtkAlgorithm, data: vtkDataSet, path: str) -> vtkDataSet:
    """Return data as a filter wants it: of volume cells the outer surface where need be."""
    key = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
    information = algorithm.GetInputPortInformation(0)
    wanted = [information.Get(key, index) for index in range(information.Length(key))]
    if not wanted or any(data.IsA(name) for name in wanted):
        return data
    if "vtkPolyData" in wanted:
        return surface_of(data, path)
    if wanted == ["vtkImageData"]:
        raise fail(path, f"needs image data, not {data.GetClassName()}")
    raise fail(path, f"needs {' or '.join(wanted)}, not {data.GetClassName()}")


def apply(name: str, properties: dict[str, Any], data: vtkDataSet, path: str) -> vtkDataSet:
    """Return what a filter, by the name of its class, makes of data."""
    target = _create(name, path)
    if not isinstance(target, vtkAlgorithm) or target.GetNumberOfInputPorts() < 1:
        raise fail(path, f"{name} is no filter")
    data = _fitting(target, data, path)
    target.SetInputDataObject(0, data)
    return output_of(configure(target, properties, path, data), path)


def make(name: str, properties: dict[str, Any], path: str) -> vtkDataSet:
    """Return what a source, by the name of its class, makes."""
    target = _create(name, path)
    if not isinstance(target, vtkAlgorithm) or target.GetNumberOfInputPorts() > 0:
        raise fail(path, f"{name} is no source")
    return output_of(configure(target, properties, path), path)
