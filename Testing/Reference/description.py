# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a scene as VTK draws it: the only thing that the two sides of a reference share.

VTK writes a description (`exporter.py`, the system's Python) and Mitsuba reads it (`tracer.py`, an
environment of its own), so that no process needs both. A description is a folder with `scene.json`,
`surface.npz`, where there is light from all around `environment.npz`, and where there are area lights
`area_lights.npz` with their images. Lengths are in scene units, light strengths in VTK's units.
"""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

SCHEMA = "vtkindirect.reference-scene/1"

# The tracer works in coordinates of its own, relative to the scene's centre, in which the bounds'
# diagonal has this length: its offsets against self-intersection are then 5e-5 of the diagonal.
TRACER_DIAGONAL = 100.0


@dataclass
class Camera:
    """A camera: unit vectors `right`, `up`, `forward` in world coordinates.

    `half_height`: the tangent of half the vertical angle, or for a parallel camera half the height
    of the view in scene units. `near`, `far`: distances along `forward` in scene units.
    """

    position: list[float]
    right: list[float]
    up: list[float]
    forward: list[float]
    half_height: float
    parallel: bool
    near: float
    far: float

    def rays(self, width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
        """Return origins and unit directions, (height, width, 3) each, bottom row first.

        One ray goes through the centre of each pixel. Origins lie on the near plane, where VTK
        starts to draw.
        """
        x = (2.0 * (np.arange(width) + 0.5) / width - 1.0) * self.half_height * width / height
        y = (2.0 * (np.arange(height) + 0.5) / height - 1.0) * self.half_height
        aside = x[None, :, None] * np.array(self.right) + y[:, None, None] * np.array(self.up)
        forward = np.broadcast_to(np.array(self.forward), aside.shape)
        if self.parallel:
            return np.array(self.position) + aside + self.near * forward, forward.copy()
        through = forward + aside
        origin = np.array(self.position) + self.near * through
        return origin, through / np.linalg.norm(through, axis=-1, keepdims=True)


@dataclass
class Light:
    """A light of VTK: position and unit direction in world coordinates.

    `strength`: colour times intensity. `attenuation`: c, l, q of 1 / (c + l d + q d^2). `cone`:
    half the cone's angle in degrees, or None for a light without a cone.
    """

    positional: bool
    position: list[float]
    direction: list[float]
    strength: list[float]
    attenuation: list[float] = field(default_factory=lambda: [1.0, 0.0, 0.0])
    cone: float | None = None
    exponent: float = 0.0


@dataclass
class Environment:
    """Light from all around: radiance in VTK's units, (rows, columns, 3), the nadir's row first.

    `image` is equirectangular, each pixel of one colour; a single pixel is the same radiance from
    everywhere. `right`, `up`, `back`: unit vectors in world coordinates. The image's middle lies
    opposite of `back`, its right half to the right, its upper edge above.
    """

    image: np.ndarray
    right: np.ndarray
    up: np.ndarray
    back: np.ndarray

    def directions(self, row: np.ndarray, column: np.ndarray) -> np.ndarray:
        """Return unit directions in world coordinates to places in the image, in pixels.

        `row`, `column` of the same shape: 0 is the edge of the first pixel, 0.5 its centre.
        """
        latitude = np.pi * (np.asarray(row) / self.image.shape[0] - 0.5)
        longitude = 2.0 * np.pi * (np.asarray(column) / self.image.shape[1] - 0.5)
        flat = np.cos(latitude)
        parts = flat * np.sin(longitude), np.sin(latitude), -flat * np.cos(longitude)
        axes = (self.right, self.up, self.back)
        return sum(part[..., None] * axis for part, axis in zip(parts, axes))

    def solid_angles(self) -> np.ndarray:
        """Return the solid angle of a pixel of each row, in steradians."""
        rows, columns = self.image.shape[:2]
        heights = np.sin(np.pi * (np.arange(rows + 1) / rows - 0.5))
        return 2.0 * np.pi / columns * np.diff(heights)


@dataclass
class AreaLight:
    """A parallelogram that sends light: a corner and two edges in world coordinates.

    It sends the same radiance in every direction of the side that edge1 x edge2 points to, and with
    `two_sided` also of the other one. `image`: radiance in VTK's units, (rows, columns, 3), each
    pixel a piece of one radiance; the first one lies at the corner, rows along `edge1`.
    """

    corner: np.ndarray
    edge1: np.ndarray
    edge2: np.ndarray
    image: np.ndarray
    two_sided: bool = False

    @property
    def normal(self) -> np.ndarray:
        """The side that it sends light to, unit."""
        span = np.cross(self.edge1, self.edge2)
        return span / np.linalg.norm(span)

    @property
    def area(self) -> float:
        """In square scene units."""
        return float(np.linalg.norm(np.cross(self.edge1, self.edge2)))

    def places(self, row: np.ndarray, column: np.ndarray) -> np.ndarray:
        """Return places in world coordinates, given in pixels: 0 is the first pixel's edge."""
        rows, columns = self.image.shape[:2]
        along1 = np.asarray(column)[..., None] / columns * self.edge1
        return self.corner + along1 + np.asarray(row)[..., None] / rows * self.edge2


@dataclass
class Surface:
    """Triangles: `points`, `normals` (unit, of either side) and `albedo` at vertices, `faces`.

    `specular`: colour and power of VTK's specular term at vertices, (vertices, 4); None where no
    surface has one.

    Normals need not agree with the winding of the faces. As in VTK, the winding decides which side
    is seen, and the normal is turned round when that is the back.
    """

    points: np.ndarray
    normals: np.ndarray
    albedo: np.ndarray
    faces: np.ndarray
    specular: np.ndarray | None = None

    @property
    def area(self) -> float:
        """Sum of the triangles' areas, in square scene units."""
        a, b, c = (self.points[self.faces[:, i]] for i in range(3))
        return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())

    @classmethod
    def join(cls, parts: list[Surface]) -> Surface:
        """Return all triangles of several surfaces as one."""
        offsets = np.cumsum([0] + [len(part.points) for part in parts[:-1]])
        specular = None
        if any(part.specular is not None for part in parts):
            specular = np.concatenate(
                [
                    np.zeros((len(part.points), 4)) if part.specular is None else part.specular
                    for part in parts
                ]
            )
        return cls(
            np.concatenate([part.points for part in parts]),
            np.concatenate([part.normals for part in parts]),
            np.concatenate([part.albedo for part in parts]),
            np.concatenate([part.faces + shift for part, shift in zip(parts, offsets)]),
            specular,
        )


@dataclass
class Description:
    """A scene as VTK's opaque pass draws it. `left_out` says what is not in it, and why."""

    name: str
    size: tuple[int, int]
    camera: Camera
    lights: list[Light]
    surface: Surface
    left_out: list[dict[str, str]] = field(default_factory=list)
    environment: Environment | None = None
    area_lights: list[AreaLight] = field(default_factory=list)

    @property
    def center(self) -> np.ndarray:
        """Centre of the bounds, the origin of the tracer's coordinates."""
        points = self.surface.points
        return 0.5 * (points.min(axis=0) + points.max(axis=0))

    @property
    def scale(self) -> float:
        """Tracer units per scene unit."""
        points = self.surface.points
        return TRACER_DIAGONAL / float(np.linalg.norm(np.ptp(points, axis=0)))

    def save(self, directory: Path) -> None:
        """Write the description into a folder that exists."""
        surface = self.surface
        more = {}
        if surface.specular is not None:
            more["specular"] = surface.specular.astype(np.float32)
        np.savez(
            directory / "surface.npz",
            points=surface.points,
            normals=surface.normals.astype(np.float32),
            albedo=surface.albedo.astype(np.float32),
            faces=surface.faces.astype(np.uint32),
            **more,
        )
        (directory / "environment.npz").unlink(missing_ok=True)
        if self.environment is not None:
            np.savez(directory / "environment.npz", **asdict(self.environment))
        (directory / "area_lights.npz").unlink(missing_ok=True)
        if self.area_lights:
            arrays = {
                f"{key}{index}": value
                for index, light in enumerate(self.area_lights)
                for key, value in asdict(light).items()
            }
            np.savez(directory / "area_lights.npz", **arrays)
        values: dict[str, Any] = {
            "schema": SCHEMA,
            "name": self.name,
            "size": list(self.size),
            "camera": asdict(self.camera),
            "lights": [asdict(light) for light in self.lights],
            "left_out": self.left_out,
        }
        (directory / "scene.json").write_text(json.dumps(values, indent=1) + "\n")


def _load_area_lights(path: Path) -> list[AreaLight]:
    lights: list[AreaLight] = []
    with np.load(path) as arrays:
        while f"corner{len(lights)}" in arrays:
            values = [
                arrays[f"{key}{len(lights)}"] for key in ("corner", "edge1", "edge2", "image")
            ]
            lights.append(AreaLight(*values, bool(arrays[f"two_sided{len(lights)}"])))
    return lights


def load(directory: Path) -> Description:
    """Read the description in a folder."""
    values = json.loads((directory / "scene.json").read_text())
    if values["schema"] != SCHEMA:
        raise ValueError(f"{directory}: schema {values['schema']}, not {SCHEMA}")
    with np.load(directory / "surface.npz") as arrays:
        surface = Surface(*(arrays[key] for key in ("points", "normals", "albedo", "faces")))
        if "specular" in arrays:
            surface.specular = arrays["specular"]
    environment = None
    if (directory / "environment.npz").exists():
        with np.load(directory / "environment.npz") as arrays:
            environment = Environment(**arrays)
    areas = directory / "area_lights.npz"
    return Description(
        values["name"],
        tuple(values["size"]),
        Camera(**values["camera"]),
        [Light(**light) for light in values["lights"]],
        surface,
        values["left_out"],
        environment,
        _load_area_lights(areas) if areas.exists() else [],
    )


def emitter(light: Light, center: np.ndarray, scale: float) -> dict[str, Any]:
    """Return the emitter that equals a light of VTK, as numbers in tracer coordinates.

    VTK's light reflects ``albedo * strength`` where a physical diffuse surface reflects ``albedo /
    pi`` times the irradiance, so every strength gains a factor pi. Keys: `type` is one of Mitsuba's
    ``point``, ``spot``, ``directional``, or ``vtk_light`` where none of them equals it; `intensity`
    (point, spot) or `irradiance` (directional, and vtk_light's at unit attenuation); `position`,
    `direction`, `cone` in degrees, `attenuation` for distances in tracer units, `exponent`.
    """
    strength = [math.pi * value for value in light.strength]
    if not light.positional:
        return {"type": "directional", "irradiance": strength, "direction": light.direction}
    position = ((np.array(light.position) - center) * scale).tolist()
    constant, linear, quadratic = light.attenuation
    placed = {"position": position, "direction": light.direction}
    if constant == 0.0 and linear == 0.0 and (light.cone is None or light.exponent == 0.0):
        intensity = [value * scale * scale / quadratic for value in strength]
        if light.cone is None:
            return {"type": "point", "intensity": intensity, **placed}
        return {"type": "spot", "intensity": intensity, "cone": light.cone, **placed}
    return {
        "type": "vtk_light",
        "irradiance": strength,
        "cone": light.cone,
        "exponent": light.exponent if light.cone is not None else 0.0,
        "attenuation": [constant, linear / scale, quadratic / scale**2],
        **placed,
    }


def irradiance_at(emitted: dict[str, Any], point: np.ndarray) -> np.ndarray:
    """Return physical irradiance / pi on a surface at `point` that faces the emitter.

    `point` in tracer coordinates. It is VTK's light at that point, and what tests compare.
    """
    if emitted["type"] == "directional":
        return np.array(emitted["irradiance"]) / math.pi
    away = point - np.array(emitted["position"])
    distance = float(np.linalg.norm(away))
    cosine = float(away @ np.array(emitted["direction"])) / distance
    inside = emitted.get("cone") is None or cosine >= math.cos(math.radians(emitted["cone"]))
    if emitted["type"] == "vtk_light":
        constant, linear, quadratic = emitted["attenuation"]
        value = np.array(emitted["irradiance"]) / math.pi
        value /= constant + linear * distance + quadratic * distance**2
        if emitted["cone"] is not None:
            value = value * max(cosine, 0.0) ** emitted["exponent"]
    else:
        value = np.array(emitted["intensity"]) / math.pi / distance**2
    return value if inside else np.zeros(3)
