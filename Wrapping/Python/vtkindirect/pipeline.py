# SPDX-License-Identifier: BSD-3-Clause
"""The steps between a data file and a surface: short names for VTK's filters, or any by its class.

One row of `STEPS` is one short name: the filters that it stands for, written as a scene file would
write them, with ``$key`` where the step's own keys go.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkPointSet, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform

from vtkindirect import arrays, labels, normals, objects, voxels
from vtkindirect.objects import ARRAY, surface_of
from vtkindirect.schema import check, fail, member, optional

Values = dict[str, Any]

_PLANE = {"vtkPlane": {"Origin": "$origin", "Normal": "$normal"}}
_ISO = {ARRAY: "$array", "ComputeScalars": True, "Value": "$value"}

STEPS: dict[str, Values] = {
    "contour": {"vtkContourFilter": {**_ISO, "ComputeNormals": True}},
    "discrete_marching_cubes": {"vtkDiscreteFlyingEdges3D": _ISO},
    "label_mask": {},
    "gaussian_smooth": {
        "vtkImageGaussianSmooth": {
            "StandardDeviations": "$standard_deviation",
            "RadiusFactors": [3, 3, 3],
        }
    },
    "extract": {"vtkExtractVOI": {"VOI": "$extent", "SampleRate": "$step"}},
    "threshold": {
        "vtkThreshold": {
            ARRAY: "$array",
            "ThresholdFunction": "$function",
            "LowerThreshold": "$lower",
            "UpperThreshold": "$upper",
            "Invert": "$invert",
        }
    },
    "surface": {"vtkDataSetSurfaceFilter": {}},
    "normals": {
        "vtkPolyDataNormals": {
            "FeatureAngle": "$feature_angle",
            "Splitting": "$splitting",
            "Consistency": "$consistency",
            "FlipNormals": "$flip",
            "AutoOrientNormals": "$orient",
        }
    },
    "glyph_spheres": {
        "vtkGlyph3D": {
            "SourceConnection": {
                "vtkSphereSource": {
                    "Radius": "$radius",
                    "ThetaResolution": "$resolution",
                    "PhiResolution": "$rings",
                }
            },
            "Orient": False,
            "Clamping": False,
            "Scaling": "$scaling",
            "ScaleMode": "scale_by_scalar",
            ARRAY: "$scale_by",
        }
    },
    "tube": {
        "vtkTubeFilter": {
            "Radius": "$radius",
            "NumberOfSides": "$sides",
            "Capping": "$capping",
            "VaryRadius": 0,
        }
    },
    "stream_tracer": {
        "vtkStreamTracer": {
            ARRAY: "$vectors",
            "SourceData": "$seeds",
            "IntegratorType": "runge_kutta45",
            "IntegrationDirection": "$direction",
            "IntegrationStepUnit": 2,  # lengths of cells
            "InitialIntegrationStep": "$step",
            "MaximumIntegrationStep": "$step",
            "MaximumPropagation": "$max_length",
            "MaximumNumberOfSteps": 20000,
            "ComputeVorticity": False,
        }
    },
    "warp_scalar": {
        "vtkWarpScalar": {
            ARRAY: "$array", "ScaleFactor": "$scale", "UseNormal": "$along", "Normal": "$normal"
        }
    },
    "smooth": {
        "vtkWindowedSincPolyDataFilter": {
            "NumberOfIterations": "$iterations",
            "PassBand": "$pass_band",
            "NormalizeCoordinates": True,
            "FeatureEdgeSmoothing": False,
            "BoundarySmoothing": False,
        }
    },
    "decimate": {
        "vtkTriangleFilter": {}, "vtkQuadricDecimation": {"TargetReduction": "$reduction"}
    },
    "connectivity": {
        "vtkPolyDataConnectivityFilter": {"ExtractionMode": "$mode", "ClosestPoint": "$closest_to"},
        "vtkCleanPolyData": {  # the filter keeps the points of the other parts
            "PointMerging": False,
            "ConvertLinesToPoints": False,
            "ConvertPolysToLines": False,
            "ConvertStripsToPolys": False,
        },
    },
    "clip": {"vtkClipPolyData": {"ClipFunction": _PLANE}},
    "slice": {"vtkCutter": {"CutFunction": _PLANE}},
    "transform": {"vtkTransformFilter": {"Transform": "$transform"}},
}  # fmt: skip

# With data of another kind, or for one, the filter of a step is another one.
_OF_IMAGES = {"vtkContourFilter": "vtkFlyingEdges3D"}
_OF_OTHER_CELLS = {"vtkClipPolyData": "vtkClipDataSet"}

_NEW_NORMALS = ("warp_scalar", "smooth", "decimate")
"""Steps that move points or drop some: smooth normals are computed anew where there were any."""


# Filters that a step makes of its keys ------------------------------------------------------------


def _three(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value] * 3


def _image(data: vtkDataSet, path: str) -> vtkImageData:
    if not isinstance(data, vtkImageData):
        raise fail(path, f"needs image data, not {data.GetClassName()}")
    return data


def _array(data: vtkDataSet, values: Values, path: str, key: str, on_cells: bool = False) -> None:
    """Replace the name of an array, maybe none, by the array."""
    values[key] = arrays.find(data, values[key], member(path, key), on_cells)


def _at_points(data: vtkDataSet, values: Values, path: str, key: str) -> vtkDataSet:
    """Replace the name of an array, maybe none, by the array at points; returns data with it."""
    known = arrays.names(data, on_cells=False)
    on_cells = values[key] not in known if values[key] is not None else not known
    found = arrays.find(data, values[key], member(path, key), on_cells)
    data, values[key] = voxels.at_points(data, found)
    return data


def _contour(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    data = _at_points(data, values, path, "array")
    if not isinstance(values["value"], list):
        values["value"] = [values["value"]]
    low, high = values["array"].span
    for value in values["value"]:
        if not low <= value <= high:
            raise fail(
                member(path, "value"),
                f"{value:g} is outside of array '{values['array'].name}', {low:g} to {high:g}",
            )
    if isinstance(data, vtkImageData) and min(data.GetDimensions()) < 2:
        raise fail(path, "needs an image of three dimensions")
    return data


def _label_mask(data: vtkDataSet, values: Values, path: str) -> vtkImageData:
    image = _image(_at_points(_image(data, path), values, path, "array"), path)
    found = values["array"]
    if found.array.GetNumberOfComponents() != 1:
        raise fail(member(path, "array"), "must have one component")
    wanted = values["value"] if isinstance(values["value"], list) else [values["value"]]
    inside = np.isin(labels.grid(image, found), wanted)
    if not inside.any():
        shown = ", ".join(f"{value:g}" for value in wanted)
        raise fail(member(path, "value"), f"array '{found.name}' has no voxel of {shown}")
    part, first = labels.box(inside, int(values["margin"]))
    mask = labels.part_of(image, inside[part].astype(np.float32), first)
    mask.GetPointData().GetScalars().SetName("mask")
    return mask


def _gaussian_smooth(data: vtkDataSet, values: Values, _path: str) -> vtkDataSet:
    values["standard_deviation"] = _three(values["standard_deviation"])
    return data


def _extract(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    whole = _image(data, path).GetExtent()
    values["step"] = _three(values["step"])
    part = values["extent"] = values["extent"] or whole
    for axis in range(3):
        low, high = part[2 * axis], part[2 * axis + 1]
        if not whole[2 * axis] <= low <= high <= whole[2 * axis + 1]:
            raise fail(member(path, "extent"), f"must lie in {', '.join(map(str, whole))}")
    return data


def _threshold(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    _array(data, values, path, "array", on_cells=True)
    if values["upper"] is None:
        values["function"], values["upper"] = 2, values["lower"]  # at least "upper", says VTK
    elif values["lower"] is None:
        values["function"], values["lower"] = 1, values["upper"]
    return data


def _normals(data: vtkDataSet, _values: Values, path: str) -> vtkDataSet:
    return normals.without(surface_of(data, path))


def points_of(data: vtkDataSet) -> vtkPolyData:
    """Return the points with their numeric arrays, without cells; text is costly to copy."""
    points = vtkPolyData()
    if isinstance(data, vtkPointSet):
        points.SetPoints(data.GetPoints())
    else:
        points.SetPoints(vtkPoints())
        for index in range(data.GetNumberOfPoints()):
            points.GetPoints().InsertNextPoint(data.GetPoint(index))
    for name in arrays.names(data, on_cells=False):
        points.GetPointData().AddArray(data.GetPointData().GetArray(name))
    return points


def _glyph_spheres(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    points = points_of(data)
    values["scaling"] = values["scale_by"] is not None
    values["rings"] = max(3, int(values["resolution"]) // 2 + 1)
    if values["scaling"]:
        _array(points, values, path, "scale_by")
    return points


def _stream_tracer(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    data = _at_points(data, values, path, "vectors")
    found = values["vectors"]
    if found.array.GetNumberOfComponents() != 3:
        raise fail(member(path, "vectors"), f"array '{found.name}' has no three components")
    seeds = vtkPolyData()
    seeds.SetPoints(vtkPoints())
    for position in _seed_positions(values["seeds"]):
        seeds.GetPoints().InsertNextPoint(position)
    values["seeds"] = seeds
    values["max_length"] = values["max_length"] or 4.0 * data.GetLength()
    return data


def _seed_positions(seeds: Values) -> list[list[float]]:
    """Return points that are evenly spaced on a line, or evenly spread in a sphere."""
    count = int(seeds["count"])
    if "point1" in seeds:
        start, end = np.array(seeds["point1"]), np.array(seeds["point2"])
        return [list(start + (end - start) * t) for t in np.linspace(0, 1, count)]
    golden = math.pi * (3.0 - math.sqrt(5.0))
    positions = []
    for index in range(count):
        radius = seeds["radius"] * ((index * 0.7548776662466927 + 0.5) % 1.0) ** (1 / 3)
        z = 1.0 - 2.0 * (index + 0.5) / count
        ring, angle = math.sqrt(1.0 - z * z), golden * index
        offset = (ring * math.cos(angle), ring * math.sin(angle), z)
        positions.append([c + radius * o for c, o in zip(seeds["center"], offset)])
    return positions


def _warp_scalar(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    data = _at_points(data, values, path, "array")
    values["along"] = values["normal"] is not None
    return data


def _connectivity(data: vtkDataSet, values: Values, _path: str) -> vtkDataSet:
    near = values["closest_to"] is not None
    values["mode"] = "closest_point_region" if near else "largest_region"
    return data


def _transform(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    if not isinstance(data, vtkPointSet):
        raise fail(path, f"needs points or cells, not {data.GetClassName()}")
    transform = values["transform"] = vtkTransform()
    if values["matrix"] is not None:
        elements = vtkMatrix4x4()
        elements.DeepCopy(values["matrix"])
        transform.SetMatrix(elements)
    else:
        transform.Translate(values["translate"] or (0.0, 0.0, 0.0))
        if values["rotate"] is not None:
            transform.RotateWXYZ(*values["rotate"])
        transform.Scale(_three(values["scale"] or 1.0))
    return data


_PREPARE: dict[str, Callable[[vtkDataSet, Values, str], vtkDataSet]] = {
    "contour": _contour,
    "discrete_marching_cubes": lambda data, v, path: _contour(_image(data, path), v, path),
    "label_mask": _label_mask,
    "gaussian_smooth": _gaussian_smooth,
    "extract": _extract,
    "threshold": _threshold,
    "normals": _normals,
    "glyph_spheres": _glyph_spheres,
    "stream_tracer": _stream_tracer,
    "warp_scalar": _warp_scalar,
    "connectivity": _connectivity,
    "transform": _transform,
}


# Doing them ---------------------------------------------------------------------------------------


def _short(name: str, values: Values, data: vtkDataSet, path: str) -> vtkDataSet:
    """Do a step by its short name."""
    if name in _NEW_NORMALS:
        data = surface_of(data, path)
    before = data
    if name in _PREPARE:
        data = _PREPARE[name](data, values, path)
    for kind, properties in objects.filled(STEPS[name], values).items():
        if isinstance(data, vtkImageData):
            kind = _OF_IMAGES.get(kind, kind)
        if not isinstance(data, vtkPolyData):
            kind = _OF_OTHER_CELLS.get(kind, kind)
        if kind == "vtkFlyingEdges3D":
            several = data.GetPointData().GetNumberOfArrays() > 1
            properties = {**properties, "InterpolateAttributes": several}
        data = objects.apply(kind, properties, data, path)
    if name in _NEW_NORMALS:
        return normals.anew(data, normals.has(before))
    if name == "contour":
        data = voxels.without_missing(surface_of(data, path))
    if name == "contour" and data.GetNumberOfPoints() > 0 and isinstance(before, vtkImageData):
        return normals.mend(data)
    if name == "threshold" and isinstance(before, vtkPolyData):
        return surface_of(data, path)
    return data


def run(data: vtkDataSet, steps: list[Values], path: str) -> vtkDataSet:
    """Do checked steps, one after another; what each leaves must not be empty."""
    for index, step in enumerate(steps):
        ((name, values),) = step.items()
        place = member(f"{path}[{index}]", name)
        if name in STEPS:
            data = _short(name, optional(values), data, place)
        else:
            data = objects.apply(name, values, data, place)
        if data.GetNumberOfPoints() == 0:
            raise fail(place, "leaves nothing")
    return data


def done(data: vtkDataSet, steps: list[Values], path: str = "pipeline") -> vtkDataSet:
    """Check steps and do them."""
    return run(data, check(steps, path, "pipeline"), path)
