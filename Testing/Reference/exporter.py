# SPDX-License-Identifier: BSD-3-Clause
"""Writes down what VTK's opaque pass draws of a scene, for a path tracer.

Needs VTK and the package vtkindirect; needs no OpenGL. Everything is taken from the VTK objects,
not from the scene file, so whatever made them is in the reference too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkPolygon
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkLight,
    vtkMapper,
    vtkProperty,
    vtkRenderer,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

from vtkindirect.actors import RADIUS

from description import AreaLight, Camera, Description, Environment, Light, Surface

# vtkMapper's scalar modes, by number in VTK's headers.
_DEFAULT, _POINT, _CELL, _POINT_FIELD, _CELL_FIELD = range(5)


class ExportError(Exception):
    """The scene has something that the reference cannot have; the text says what."""


# Camera and lights --------------------------------------------------------------------------------


def export_camera(camera: vtkCamera) -> Camera:
    """Return a camera. Shears, off-centre windows and explicit matrices are refused."""
    if (
        tuple(camera.GetWindowCenter()) != (0.0, 0.0)
        or tuple(camera.GetViewShear()) != (0.0, 0.0, 1.0)
        or camera.GetUseHorizontalViewAngle()
        or camera.GetUseOffAxisProjection()
        or camera.GetUseExplicitProjectionTransformMatrix()
        or camera.GetUserViewTransform() is not None
    ):
        raise ExportError("the camera's projection is not a plain one")
    view = matrix_of(camera.GetViewTransformMatrix())
    parallel = bool(camera.GetParallelProjection())
    near, far = camera.GetClippingRange()
    half_height = (
        camera.GetParallelScale()
        if parallel
        else math.tan(math.radians(0.5 * camera.GetViewAngle()))
    )
    return Camera(
        list(camera.GetPosition()),
        view[0, :3].tolist(),
        view[1, :3].tolist(),
        (-view[2, :3]).tolist(),
        half_height,
        parallel,
        near,
        far,
    )


def export_light(light: vtkLight) -> Light:
    """Return a light as VTK's shaders see it."""
    position = np.array(light.GetTransformedPosition())
    direction = np.array(light.GetTransformedFocalPoint()) - position
    length = np.linalg.norm(direction)
    if not length > 0.0:
        raise ExportError("a light has no direction")
    strength = [light.GetIntensity() * value for value in light.GetDiffuseColor()]
    direction = (direction / length).tolist()
    if not light.GetPositional():
        return Light(False, position.tolist(), direction, strength)
    cone = light.GetConeAngle() if light.GetConeAngle() < 90.0 else None
    return Light(
        True,
        position.tolist(),
        direction,
        strength,
        list(light.GetAttenuationValues()),
        cone,
        light.GetExponent() if cone is not None else 0.0,
    )


def _axes(up: tuple[float, ...], right: tuple[float, ...]) -> list[np.ndarray]:
    """Return the unit vectors right, up, back of an environment whose axes are given."""
    y = np.array(up) / np.linalg.norm(up)
    x = np.array(right) - (np.array(right) @ y) * y
    if not np.linalg.norm(x) > 1e-9 * np.linalg.norm(right):
        raise ExportError("the environment's Right is along its Up")
    x /= np.linalg.norm(x)
    return [x, y, np.cross(x, y)]


def _image_of(light: Any) -> np.ndarray | None:
    """Return the values of a vtkIndirectEmitterBase's image or texture, (rows, columns, 3); None without."""
    image, encoded = light.GetImage(), light.GetEncoded()
    if image is None and light.GetTexture() is not None:
        light.GetTexture().Update()
        image = light.GetTexture().GetInput()
        encoded = encoded or light.GetTexture().GetUseSRGBColorSpace()
    if image is None:
        return None
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    values = pixels.astype(np.float64) / (255.0 if pixels.dtype == np.uint8 else 1.0)
    values = values[..., :3] if values.shape[2] >= 3 else np.repeat(values[..., :1], 3, axis=2)
    values = np.where(np.isfinite(values) & (values >= 0.0), values, 0.0)
    if encoded:  # the transfer function of sRGB, IEC 61966-2-1
        low = values <= 0.04045
        values = np.where(low, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    return values


def export_environment(light: Any) -> Environment:
    """Return what a vtkEnvironmentLight sends, from its image, its texture or its radiance."""
    values = _image_of(light)
    if values is None:
        values = np.array(light.GetRadiance()).reshape(1, 1, 3)
    return Environment(light.GetScale() * values, *_axes(light.GetUp(), light.GetRight()))


def export_area_light(light: Any) -> AreaLight | None:
    """Return what a vtkAreaLight sends; None where it is off, dark or without area."""
    image = _image_of(light)
    values = np.ones((1, 1, 3)) if image is None else image
    corner, *ends = (
        np.array(point) for point in (light.GetOrigin(), light.GetPoint1(), light.GetPoint2())
    )
    radiance = light.GetScale() * np.array(light.GetRadiance()) * values
    found = AreaLight(corner, *(end - corner for end in ends), radiance, light.GetTwoSided())
    lit = light.GetSwitch() and found.area > 0.0 and radiance.max() > 0.0
    return found if lit else None


# Surfaces -----------------------------------------------------------------------------------------


def matrix_of(matrix: vtkMatrix4x4) -> np.ndarray:
    """Return a matrix of VTK as an array of 4 x 4."""
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _fans(cells: vtkCellArray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangle fans of polygons of `count` points, and the index of each's cell."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray()).astype(np.int64)
    points = vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64)
    (which,) = np.nonzero(np.diff(offsets) == count)
    corners = points[offsets[which][:, None] + np.arange(count)]
    faces = [corners[:, [0, i, i + 1]] for i in range(1, count - 1)]
    return np.stack(faces, axis=1).reshape(-1, 3), np.repeat(which, count - 2)


def _earcuts(data: vtkPolyData, cells: vtkCellArray) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles of polygons of seven points and more, as VTK's mapper cuts them."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    faces: list[list[int]] = []
    which: list[int] = []
    corners, cut = vtkIdList(), vtkIdList()
    for cell in np.nonzero(np.diff(offsets) > 6)[0].tolist():
        cells.GetCellAtId(cell, corners)
        polygon = vtkPolygon()
        polygon.Initialize(corners.GetNumberOfIds(), corners_of(corners), data.GetPoints())
        if hasattr(polygon, "TriangulateLocalIds"):  # the name in newer VTKs
            polygon.TriangulateLocalIds(0, cut)
        else:
            polygon.Triangulate(cut)
        for i in range(0, cut.GetNumberOfIds() - 2, 3):
            faces.append([corners.GetId(cut.GetId(i + k)) for k in range(3)])
            which.append(cell)
    return np.array(faces, dtype=np.int64).reshape(-1, 3), np.array(which, dtype=np.int64)


def corners_of(points: vtkIdList) -> list[int]:
    """Return a list of VTK's as a list."""
    return [points.GetId(i) for i in range(points.GetNumberOfIds())]


def _strips(cells: vtkCellArray) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles of strips; every second one is turned round."""
    faces: list[list[int]] = []
    which: list[int] = []
    corners = vtkIdList()
    for cell in range(cells.GetNumberOfCells()):
        cells.GetCellAtId(cell, corners)
        strip = corners_of(corners)
        for i in range(len(strip) - 2):
            odd = i % 2
            faces.append([strip[i], strip[i + 1 + odd], strip[i + 2 - odd]])
            which.append(cell)
    return np.array(faces, dtype=np.int64).reshape(-1, 3), np.array(which, dtype=np.int64)


def triangles(data: vtkPolyData) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles that VTK's mapper draws, and the data's cell of each."""
    parts: list[tuple[np.ndarray, np.ndarray]] = []
    before = data.GetNumberOfVerts() + data.GetNumberOfLines()
    if data.GetNumberOfPolys():
        polys = data.GetPolys()
        sizes = np.unique(np.diff(vtk_to_numpy(polys.GetOffsetsArray())))
        parts += [_fans(polys, count) for count in sizes.tolist() if 3 <= count <= 6]
        if sizes[-1] > 6:
            parts.append(_earcuts(data, polys))
        parts = [(faces, cells + before) for faces, cells in parts]
    if data.GetNumberOfStrips():
        faces, cells = _strips(data.GetStrips())
        parts.append((faces, cells + before + data.GetNumberOfPolys()))
    if not parts:
        return np.zeros((0, 3), dtype=np.int64), np.zeros(0, dtype=np.int64)
    return np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])


def scalar_colors(mapper: vtkMapper, data: vtkPolyData) -> tuple[np.ndarray, bool] | None:
    """Return the colours 0 to 1 by which a mapper colours, and whether they are the cells'."""
    if not mapper.GetScalarVisibility():
        return None
    mode = mapper.GetScalarMode()
    if mode == _DEFAULT:
        on_cells = data.GetPointData().GetScalars() is None
    elif mode in (_POINT, _POINT_FIELD, _CELL, _CELL_FIELD):
        on_cells = mode in (_CELL, _CELL_FIELD)
    else:
        raise ExportError("an actor is coloured by field data")
    colors = mapper.MapScalars(1.0)
    if colors is None:
        return None
    if mapper.GetInterpolateScalarsBeforeMapping() and not on_cells:
        raise ExportError("an actor interpolates scalars before it maps them")
    return vtk_to_numpy(colors)[:, :3].astype(np.float64) / 255.0, on_cells


def _check_material(prop: vtkProperty, actor: vtkActor) -> None:
    if prop.GetInterpolationAsString() == "Physically based rendering":
        raise ExportError("an actor has a physically based material; references are for Phong")
    if prop.GetRepresentationAsString() != "Surface":
        raise ExportError("an actor is drawn as points or as wires")
    if prop.GetFrontfaceCulling() or prop.GetBackfaceCulling() or actor.GetBackfaceProperty():
        raise ExportError("an actor draws its front and back differently")
    if actor.GetTexture() is not None or prop.GetNumberOfTextures():
        raise ExportError("an actor has a texture")


def ball(subdivisions: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Return places, (vertices, 3), and faces of an icosahedron; all are cut into four as often.

    Places are on a sphere so much larger than the unit sphere that shadows of all directions have
    on the mean the unit disk's area (Cauchy: a quarter of the surface's). With 1,280 triangles the
    surface is at most 0.4 % of the radius away from the unit sphere.
    """
    golden = 0.5 * (1.0 + math.sqrt(5.0))
    one = np.array([[0.0, s, t * golden] for s in (-1, 1) for t in (-1, 1)])
    places = np.concatenate([np.roll(one, axis, axis=1) for axis in range(3)])
    apart = np.linalg.norm(places[:, None] - places[None], axis=-1)
    near = (apart > 0.0) & (apart < 2.1)
    faces = np.array(
        [
            (i, j, k) if np.linalg.det(places[[i, j, k]]) > 0.0 else (i, k, j)
            for i in range(12)
            for j in range(i + 1, 12)
            for k in range(j + 1, 12)
            if near[i, j] and near[j, k] and near[k, i]
        ]
    )
    for _ in range(subdivisions):
        sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=-1)
        edges, which = np.unique(sides.reshape(-1, 2), axis=0, return_inverse=True)
        a, b, c = faces.T
        ab, bc, ca = (which.reshape(-1, 3) + len(places)).T
        places = np.concatenate([places, places[edges].sum(axis=1)])
        places /= np.linalg.norm(places, axis=1, keepdims=True)
        faces = np.stack([a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca], axis=1).reshape(-1, 3)
    corners = places[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * np.linalg.norm(across, axis=1).sum()
    return places * math.sqrt(4.0 * math.pi / area), faces


def export_spheres(actor: vtkActor) -> Surface:
    """Return the spheres of a vtkOpenGLSphereMapper as triangles that have the spheres' normals."""
    prop, mapper = actor.GetProperty(), actor.GetMapper()
    data = mapper.GetInput()
    if not np.array_equal(matrix_of(actor.GetMatrix()), np.eye(4)):
        raise ExportError("its spheres are moved by the actor's matrix")
    radii = data.GetPointData().GetArray(RADIUS)
    if radii is None:
        raise ExportError(f"its spheres have no array {RADIUS}")
    colors = scalar_colors(mapper, data)
    radii = vtk_to_numpy(radii).astype(np.float64)
    drawn = radii > 0.0
    centers = vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64)[drawn]
    color = np.array(prop.GetDiffuseColor())[None] if colors is None else colors[0][drawn]
    places, faces = ball()
    count = len(places)
    points = centers[:, None] + radii[drawn, None, None] * places
    normals = np.tile(places / np.linalg.norm(places, axis=1, keepdims=True), (len(centers), 1))
    albedo = np.broadcast_to(prop.GetDiffuse() * color[:, None], points.shape)
    starts = count * np.arange(len(centers))
    return Surface(
        points.reshape(-1, 3),
        normals,
        albedo.reshape(-1, 3),
        (starts[:, None, None] + faces).reshape(-1, 3),
        _specular(prop, count * len(centers)),
    )


def export_actor(actor: vtkActor) -> Surface:
    """Return the triangles of an actor in world coordinates, shaded as its mapper does."""
    prop = actor.GetProperty()
    _check_material(prop, actor)
    mapper = actor.GetMapper()
    mapper.Update()
    if isinstance(mapper, vtkOpenGLSphereMapper):
        return export_spheres(actor)
    data = mapper.GetInput()
    faces, cells = triangles(data)
    to_world = matrix_of(actor.GetMatrix())
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64)
    points = points @ to_world[:3, :3].T + to_world[:3, 3]
    edges = [points[faces[:, i]] - points[faces[:, 0]] for i in (1, 2)]
    facet = np.cross(*edges)
    area = np.linalg.norm(facet, axis=1)
    drawn = area > 0.0
    faces, cells, facet = faces[drawn], cells[drawn], facet[drawn] / area[drawn, None]

    turn = np.linalg.inv(to_world[:3, :3])  # from the right: the inverse transposed
    flat = prop.GetInterpolationAsString() == "Flat"
    point_normals = None if flat else data.GetPointData().GetNormals()
    cell_normals = data.GetCellData().GetNormals() if point_normals is None else None
    colors = scalar_colors(mapper, data)
    shared = point_normals is not None and not (colors is not None and colors[1])
    corners = np.unique(faces) if shared else faces.reshape(-1)
    of_cell = None if shared else np.repeat(cells, 3)

    if point_normals is not None:
        normals = (vtk_to_numpy(point_normals).astype(np.float64) @ turn)[corners]
    elif cell_normals is not None:
        normals = (vtk_to_numpy(cell_normals).astype(np.float64) @ turn)[of_cell]
    else:
        normals = np.repeat(facet, 3, axis=0)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = normals / np.where(length > 0.0, length, 1.0)

    if colors is None:
        color = np.broadcast_to(np.array(prop.GetDiffuseColor()), normals.shape)
    else:
        color = colors[0][of_cell if colors[1] else corners]
    if shared:
        faces = np.searchsorted(corners, faces)
    else:
        faces = np.arange(len(corners)).reshape(-1, 3)
    return Surface(
        points[corners], normals, prop.GetDiffuse() * color, faces, _specular(prop, len(corners))
    )


def _specular(prop: vtkProperty, vertices: int) -> np.ndarray | None:
    """Return colour and power of VTK's specular term at each vertex; None without one."""
    color = prop.GetSpecular() * np.array(prop.GetSpecularColor())
    if not (prop.GetLighting() and color.max() > 0.0):
        return None
    return np.tile([*color, prop.GetSpecularPower()], (vertices, 1))


def _why_left_out(actor: vtkActor) -> str | None:
    """Return why the indirect light passes draw nothing of a visible actor, or None."""
    if actor.HasTranslucentPolygonalGeometry():
        return "translucent"
    mapper = actor.GetMapper()
    data = mapper.GetInput()
    if isinstance(mapper, vtkOpenGLSphereMapper) and data is not None and data.GetNumberOfVerts():
        return None
    if data is None or data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        return "has no polygons"
    return None


def export_renderer(
    renderer: vtkRenderer,
    name: str,
    size: tuple[int, int],
    actors: Iterable[tuple[str, vtkActor]],
    environment: Any = None,
    area_lights: Iterable[Any] = (),
) -> Description:
    """Return what a renderer draws of its actors at `size` pixels.

    `environment`: the vtkEnvironmentLight around them, or None. `area_lights`: vtkAreaLights, which
    are not drawn themselves.
    """
    renderer.UpdateLightsGeometryToFollowCamera()
    left_out: list[dict[str, str]] = []
    parts: list[Surface] = []
    for label, actor in actors:
        if not actor.GetVisibility():
            continue
        reason = _why_left_out(actor)
        if reason is not None:
            left_out.append({"what": label, "why": reason})
            continue
        try:
            parts.append(export_actor(actor))
        except ExportError as error:
            raise ExportError(f"{name}, {label}: {error}") from None
    if not parts:
        raise ExportError(f"{name}: nothing opaque is visible")
    found = renderer.GetLights()
    lights = [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]
    return Description(
        name,
        size,
        export_camera(renderer.GetActiveCamera()),
        [export_light(light) for light in lights if light.GetSwitch()],
        Surface.join(parts),
        left_out,
        None if environment is None else export_environment(environment),
        [found for found in map(export_area_light, area_lights) if found is not None],
    )
