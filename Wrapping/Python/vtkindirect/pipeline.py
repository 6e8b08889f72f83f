# SPDX-License-Identifier: BSD-3-Clause
"""The steps between a data file and a surface. One row of `STEPS` is one step."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkDataSet,
    vtkImageData,
    vtkPlane,
    vtkPointSet,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkClipPolyData,
    vtkContourFilter,
    vtkCutter,
    vtkFlyingEdges3D,
    vtkGlyph3D,
    vtkPolyDataConnectivityFilter,
    vtkPolyDataNormals,
    vtkQuadricDecimation,
    vtkThreshold,
    vtkTriangleFilter,
    vtkTubeFilter,
    vtkWindowedSincPolyDataFilter,
)
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import (
    vtkClipDataSet,
    vtkDiscreteFlyingEdges3D,
    vtkTransformFilter,
    vtkWarpScalar,
)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth

from vtkindirect import arrays, normals
from vtkindirect.schema import check, fail, member, optional

Values = dict[str, Any]

# Helpers ------------------------------------------------------------------------------------------


def _many(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def _three(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value] * 3


def _run(filter_: vtkAlgorithm, data: vtkDataSet) -> Any:
    filter_.SetInputData(data)
    filter_.Update()
    return filter_.GetOutput()


def _image(data: vtkDataSet, path: str) -> vtkImageData:
    if not isinstance(data, vtkImageData):
        raise fail(path, f"needs image data, not {data.GetClassName()}")
    return data


def surface_of(data: vtkDataSet, path: str) -> vtkPolyData:
    """Return polygonal data as it is, and the outer surface of other cells."""
    if isinstance(data, vtkImageData):
        raise fail(path, "needs a surface, not image data: put a contour step before")
    return data if isinstance(data, vtkPolyData) else _run(vtkDataSetSurfaceFilter(), data)


def _point_set(data: vtkDataSet, path: str) -> vtkPointSet:
    if not isinstance(data, vtkPointSet):
        raise fail(path, f"needs points or cells, not {data.GetClassName()}")
    return data


def _check_in_range(found: arrays.Found, values: list[float], path: str) -> None:
    low, high = found.span
    for value in values:
        if not low <= value <= high:
            raise fail(
                member(path, "value"),
                f"{value:g} is outside of array '{found.name}', {low:g} to {high:g}",
            )


def _plane(values: Values) -> vtkPlane:
    plane = vtkPlane()
    plane.SetOrigin(values["origin"])
    plane.SetNormal(values["normal"])
    return plane


# Steps --------------------------------------------------------------------------------------------


def _contour(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    found = arrays.find(data, values["array"], member(path, "array"), on_cells=False)
    _check_in_range(found, _many(values["value"]), path)
    contour = vtkFlyingEdges3D() if isinstance(data, vtkImageData) else vtkContourFilter()
    if isinstance(data, vtkImageData):
        if min(data.GetDimensions()) < 2:
            raise fail(path, "needs an image of three dimensions")
        contour.SetInterpolateAttributes(data.GetPointData().GetNumberOfArrays() > 1)
    contour.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
    contour.ComputeNormalsOn()
    contour.ComputeScalarsOn()
    for index, value in enumerate(_many(values["value"])):
        contour.SetValue(index, value)
    result = _run(contour, data)
    return normals.mend(result) if isinstance(data, vtkImageData) else result


def _discrete(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    image = _image(data, path)
    found = arrays.find(image, values["array"], member(path, "array"), on_cells=False)
    _check_in_range(found, _many(values["value"]), path)
    contour = vtkDiscreteFlyingEdges3D()
    contour.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
    contour.ComputeScalarsOn()
    for index, value in enumerate(_many(values["value"])):
        contour.SetValue(index, value)
    return _run(contour, image)


def _label_mask(data: vtkDataSet, values: Values, path: str) -> vtkImageData:
    image = _image(data, path)
    found = arrays.find(image, values["array"], member(path, "array"), on_cells=False)
    if found.array.GetNumberOfComponents() != 1:
        raise fail(member(path, "array"), "must have one component")
    nx, ny, nz = image.GetDimensions()
    inside = np.isin(found.numbers().reshape(nz, ny, nx), _many(values["value"]))
    if not inside.any():
        shown = ", ".join(f"{value:g}" for value in _many(values["value"]))
        raise fail(member(path, "value"), f"array '{found.name}' has no voxel of {shown}")
    margin, first, part = values["margin"], [], []
    for axis, count in ((2, nx), (1, ny), (0, nz)):
        others = tuple(other for other in range(3) if other != axis)
        (where,) = np.nonzero(inside.any(axis=others))
        first.append(max(0, int(where[0]) - margin))
        part.append(slice(first[-1], min(count, int(where[-1]) + margin + 1)))
    inside = inside[part[2], part[1], part[0]]
    mask = vtkImageData()
    mask.SetDimensions(inside.shape[::-1])
    mask.SetSpacing(image.GetSpacing())
    mask.SetDirectionMatrix(image.GetDirectionMatrix())
    start = image.GetExtent()[::2]
    corner = [0.0, 0.0, 0.0]
    image.TransformIndexToPhysicalPoint(*(a + b for a, b in zip(start, first)), corner)
    mask.SetOrigin(corner)
    scalars = numpy_to_vtk(inside.astype(np.float32).ravel(), deep=True)
    scalars.SetName("mask")
    mask.GetPointData().SetScalars(scalars)
    return mask


def _gaussian_smooth(data: vtkDataSet, values: Values, path: str) -> vtkImageData:
    smooth = vtkImageGaussianSmooth()
    smooth.SetStandardDeviations(_three(values["standard_deviation"]))
    smooth.SetRadiusFactors(3.0, 3.0, 3.0)
    return _run(smooth, _image(data, path))


def _extract(data: vtkDataSet, values: Values, path: str) -> vtkImageData:
    image = _image(data, path)
    whole = image.GetExtent()
    part = values["extent"] or whole
    for axis in range(3):
        low, high = part[2 * axis], part[2 * axis + 1]
        if not whole[2 * axis] <= low <= high <= whole[2 * axis + 1]:
            raise fail(member(path, "extent"), f"must lie in {', '.join(map(str, whole))}")
    extract = vtkExtractVOI()
    extract.SetVOI(*part)
    extract.SetSampleRate(*_three(values["step"]))
    return _run(extract, image)


def _threshold(data: vtkDataSet, values: Values, path: str) -> vtkDataSet:
    found = arrays.find(data, values["array"], member(path, "array"))
    low = -math.inf if values["lower"] is None else values["lower"]
    high = math.inf if values["upper"] is None else values["upper"]
    threshold = vtkThreshold()
    threshold.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(low)
    threshold.SetUpperThreshold(high)
    threshold.SetInvert(values["invert"])
    result = _run(threshold, data)
    return surface_of(result, path) if isinstance(data, vtkPolyData) else result


def _surface(data: vtkDataSet, _values: Values, _path: str) -> vtkPolyData:
    return _run(vtkDataSetSurfaceFilter(), data)


def _normals(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    step = vtkPolyDataNormals()
    step.SetFeatureAngle(values["feature_angle"])
    step.SetSplitting(values["splitting"])
    step.SetConsistency(values["consistency"])
    step.SetFlipNormals(values["flip"])
    step.SetAutoOrientNormals(values["orient"])
    return _run(step, normals.without(surface_of(data, path)))


def _numeric_points(data: vtkDataSet) -> vtkPolyData:
    """Return the points of a data set with their numeric arrays; text is costly to copy."""
    points = vtkPolyData()
    if isinstance(data, vtkPointSet):
        points.SetPoints(data.GetPoints())
    else:
        copied = vtkPoints()
        copied.SetNumberOfPoints(data.GetNumberOfPoints())
        for index in range(data.GetNumberOfPoints()):
            copied.SetPoint(index, data.GetPoint(index))
        points.SetPoints(copied)
    for index in range(data.GetPointData().GetNumberOfArrays()):
        values = data.GetPointData().GetArray(index)
        if values is not None:
            points.GetPointData().AddArray(values)
    return points


def _glyph_spheres(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    points = _numeric_points(data)
    sphere = vtkSphereSource()
    sphere.SetRadius(values["radius"])
    sphere.SetThetaResolution(values["resolution"])
    sphere.SetPhiResolution(max(3, values["resolution"] // 2 + 1))
    glyphs = vtkGlyph3D()
    glyphs.SetSourceConnection(sphere.GetOutputPort())
    glyphs.OrientOff()
    glyphs.ClampingOff()
    if values["scale_by"] is None:
        glyphs.ScalingOff()
    else:
        found = arrays.find(points, values["scale_by"], member(path, "scale_by"), on_cells=False)
        glyphs.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
        glyphs.SetScaleModeToScaleByScalar()
    return _run(glyphs, points)


def _tube(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    lines = surface_of(data, path)
    if lines.GetNumberOfLines() == 0:
        raise fail(path, "the data has no lines")
    tube = vtkTubeFilter()
    tube.SetRadius(values["radius"])
    tube.SetNumberOfSides(values["sides"])
    tube.SetCapping(values["capping"])
    tube.SetVaryRadiusToVaryRadiusOff()
    return _run(tube, lines)


def _stream_tracer(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    found = arrays.find(data, values["vectors"], member(path, "vectors"), on_cells=False)
    if found.array.GetNumberOfComponents() != 3:
        raise fail(member(path, "vectors"), f"array '{found.name}' has no three components")
    seeds = vtkPolyData()
    seeds.SetPoints(vtkPoints())
    for position in _seed_positions(values["seeds"]):
        seeds.GetPoints().InsertNextPoint(position)
    tracer = vtkStreamTracer()
    tracer.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
    tracer.SetSourceData(seeds)
    tracer.SetIntegratorTypeToRungeKutta45()
    tracer.SetIntegrationDirection({"forward": 0, "backward": 1, "both": 2}[values["direction"]])
    tracer.SetIntegrationStepUnit(vtkStreamTracer.CELL_LENGTH_UNIT)
    tracer.SetInitialIntegrationStep(values["step"])
    tracer.SetMaximumIntegrationStep(values["step"])
    tracer.SetMaximumPropagation(values["max_length"] or 4.0 * data.GetLength())
    tracer.SetMaximumNumberOfSteps(20000)
    tracer.SetComputeVorticity(False)
    return _run(tracer, data)


def _seed_positions(seeds: Values) -> list[list[float]]:
    """Return points that are evenly spaced on a line, or evenly spread in a sphere."""
    count = seeds["count"]
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


def _warp_scalar(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    surface = surface_of(data, path)
    found = arrays.find(surface, values["array"], member(path, "array"), on_cells=False)
    warp = vtkWarpScalar()
    warp.SetInputArrayToProcess(0, 0, 0, found.association, found.name)
    warp.SetScaleFactor(values["scale"])
    if values["normal"] is not None:
        warp.UseNormalOn()
        warp.SetNormal(values["normal"])
    return normals.anew(_run(warp, surface), normals.has(surface))


def _smooth(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    surface = surface_of(data, path)
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetNumberOfIterations(values["iterations"])
    smooth.SetPassBand(values["pass_band"])
    smooth.NormalizeCoordinatesOn()
    smooth.FeatureEdgeSmoothingOff()
    smooth.BoundarySmoothingOff()
    return normals.anew(_run(smooth, surface), normals.has(surface))


def _decimate(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    surface = surface_of(data, path)
    decimate = vtkQuadricDecimation()
    decimate.SetTargetReduction(values["reduction"])
    result = _run(decimate, _run(vtkTriangleFilter(), surface))
    return normals.anew(result, normals.has(surface))


def _connectivity(data: vtkDataSet, values: Values, path: str) -> vtkPolyData:
    parts = vtkPolyDataConnectivityFilter()
    if values["closest_to"] is None:
        parts.SetExtractionModeToLargestRegion()
    else:
        parts.SetExtractionModeToClosestPointRegion()
        parts.SetClosestPoint(values["closest_to"])
    unused = vtkCleanPolyData()  # the filter keeps the points of the other parts
    unused.PointMergingOff()
    unused.ConvertLinesToPointsOff()
    unused.ConvertPolysToLinesOff()
    unused.ConvertStripsToPolysOff()
    return _run(unused, _run(parts, surface_of(data, path)))


def _clip(data: vtkDataSet, values: Values, _path: str) -> vtkDataSet:
    clip = vtkClipPolyData() if isinstance(data, vtkPolyData) else vtkClipDataSet()
    clip.SetClipFunction(_plane(values))
    return _run(clip, data)


def _slice(data: vtkDataSet, values: Values, _path: str) -> vtkPolyData:
    cutter = vtkCutter()
    cutter.SetCutFunction(_plane(values))
    return _run(cutter, data)


def _transform(data: vtkDataSet, values: Values, path: str) -> vtkPointSet:
    transform = vtkTransform()
    if values["matrix"] is not None:
        elements = vtkMatrix4x4()
        elements.DeepCopy(values["matrix"])
        transform.SetMatrix(elements)
    else:
        transform.Translate(values["translate"] or (0.0, 0.0, 0.0))
        if values["rotate"] is not None:
            transform.RotateWXYZ(*values["rotate"])
        transform.Scale(_three(values["scale"] or 1.0))
    move = vtkTransformFilter()
    move.SetTransform(transform)
    return _run(move, _point_set(data, path))


# The table ----------------------------------------------------------------------------------------


STEPS: dict[str, Callable[[vtkDataSet, Values, str], vtkDataSet]] = {
    "contour": _contour,
    "discrete_marching_cubes": _discrete,
    "label_mask": _label_mask,
    "gaussian_smooth": _gaussian_smooth,
    "extract": _extract,
    "threshold": _threshold,
    "surface": _surface,
    "normals": _normals,
    "glyph_spheres": _glyph_spheres,
    "tube": _tube,
    "stream_tracer": _stream_tracer,
    "warp_scalar": _warp_scalar,
    "smooth": _smooth,
    "decimate": _decimate,
    "connectivity": _connectivity,
    "clip": _clip,
    "slice": _slice,
    "transform": _transform,
}


def run(data: vtkDataSet, steps: list[Values], path: str) -> vtkDataSet:
    """Do checked steps, one after another; what each leaves must not be empty."""
    for index, step in enumerate(steps):
        ((name, values),) = step.items()
        place = member(f"{path}[{index}]", name)
        data = STEPS[name](data, optional(values), place)
        if data.GetNumberOfPoints() == 0:
            raise fail(place, "leaves nothing")
    return data


def done(data: vtkDataSet, steps: list[Values], path: str = "pipeline") -> vtkDataSet:
    """Check steps and do them."""
    return run(data, check(steps, path, "pipeline"), path)
