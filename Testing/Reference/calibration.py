# SPDX-License-Identifier: BSD-3-Clause
"""Direct light by VTK and by the path tracer, case by case: the check that units agree.

VTK's side is the buffer `direct` of the pass with shadows on, in floats; the tracer's is albedo
times the irradiance at the same points. Only pixels are compared whose neighbourhood is one smooth
surface, lit or dark as a whole, because there the two agree on what they draw.
"""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import exporter
import tools

SIZE = (160, 120)
TOLERANCE = 0.001

_FLOOR = {
    "name": "floor",
    "source": "plane",
    "origin": [-2, 0, 2],
    "point1": [2, 0, 2],
    "point2": [-2, 0, -2],
    "color": [0.8, 0.5, 0.25],
}
_WALL = {
    "name": "wall",
    "source": "plane",
    "origin": [-2, 0, -1],
    "point1": [2, 0, -1],
    "point2": [-2, 2.5, -1],
    "color": [0.3, 0.6, 0.9],
}
_SPHERE = {
    "name": "sphere",
    "source": "sphere",
    "center": [-0.5, 0.4, 0.2],
    "radius": 0.4,
    "resolution": 48,
    "color": [0.9, 0.9, 0.9],
    "diffuse": 0.7,
}
_BOX = {
    "name": "box",
    "source": "box",
    "bounds": [-0.3, 0.3, 0, 0.6, -0.3, 0.3],
    "transform": [0.8, 0, 0.6, 0.7, 0, 1, 0, 0, -0.6, 0, 0.8, 0, 0, 0, 0, 1],
    "interpolation": "flat",
    "color": [0.6, 0.2, 0.2],
}
_ACTORS = [_FLOOR, _WALL, _SPHERE, _BOX]
_CAMERA = {"position": [0.4, 1.6, 4.5], "focal_point": [0, 0.5, 0], "view_angle": 34}
_PLACE = {"position": [1.2, 2.6, 1.8], "focal_point": [0, 0.2, 0]}


def _spot(**changes: Any) -> dict[str, Any]:
    return {"type": "spot", **_PLACE, "cone_angle": 30, **changes}


@dataclass(frozen=True)
class Case:
    """A scene document's lights, and what else of it is not the common scene."""

    name: str
    lights: list[dict[str, Any]]
    changes: dict[str, Any]


def _case(name: str, *lights: dict[str, Any], **changes: Any) -> Case:
    return Case(name, list(lights), changes)


_KEY = {"type": "point", "position": [1.2, 2.6, 1.8]}

CASES = (
    _case("hard spot", _spot(intensity=0.9)),
    _case("hard spot, inverse square", _spot(attenuation=[0, 0, 0.4])),
    _case("cosine spot, exponent 8", _spot(exponent=8, cone_angle=50)),
    _case("spot, polynomial attenuation", _spot(attenuation=[0.5, 0.3, 0.1], exponent=1)),
    _case("point", {**_KEY, "color": [1, 0.6, 0.3]}),
    _case("point, inverse square", {**_KEY, "attenuation": [0, 0, 0.2]}),
    _case("point, polynomial", {**_KEY, "attenuation": [0.2, 0.1, 0.3]}),
    _case("directional", {"type": "directional", "direction": [-0.5, -1.0, -0.7]}),
    _case("headlight", {"type": "headlight", "intensity": 0.8}),
    _case("light kit", {"type": "light_kit"}),
    _case(
        "two lights",
        _spot(intensity=0.5, color=[1, 0.5, 0.2]),
        {"type": "directional", "direction": [0.6, -1.0, -0.4], "color": [0.2, 0.4, 1]},
    ),
    _case(
        "orthographic",
        _spot(),
        camera={"position": [0.4, 1.6, 4.5], "focal_point": [0, 0.5, 0], "parallel_scale": 1.4},
    ),
    _case("odd aspect", _spot(), size=[201, 67]),
    _case(
        "winding turned round",
        _spot(),
        actors=[_FLOOR, {**_WALL, "point1": [-2, 2.5, -1], "point2": [2, 0, -1]}, _BOX],
    ),
    _case(
        "sheet lit from behind",
        {"type": "spot", "position": [0, 2.0, -3.5], "focal_point": [0, 0.5, 0], "cone_angle": 40},
        actors=[_FLOOR, {**_WALL, "point2": [-2, 1.0, -1]}, _BOX],
    ),
    _case(
        "mirrored",  # VTK turns the winding round, not the normals, and draws the sphere black
        _spot(),
        actors=[_FLOOR, {**_SPHERE, "transform": [-1, *[0] * 4, 1, *[0] * 4, 1, *[0] * 4, 1]}],
    ),
    _case(
        "far from the origin, large",
        _spot(position=[5001200, 2600, 1800], focal_point=[5000000, 200, 0]),
        actors=[
            {
                **actor,
                "transform": [1000, 0, 0, 5e6, 0, 1000, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1],
            }
            for actor in (_FLOOR, _WALL, _SPHERE)
        ],
        camera={"position": [5000400, 1600, 4500], "focal_point": [5e6, 500, 0], "view_angle": 34},
    ),
)


@dataclass(frozen=True)
class Result:
    """Agreement of one case: signed error of the sum, and of single pixels, relative.

    `dark`: the brightest that VTK draws where the tracer sees no light, relative to the brightest
    of the picture, but for the worst pixel in a hundred. `albedo`: greatest absolute difference.
    """

    name: str
    pixels: int
    of_sum: float
    median: float
    worst_of_99: float
    dark: float
    albedo: float

    @property
    def good(self) -> bool:
        """Return whether the case agrees within the tolerance."""
        return (
            self.pixels > 500
            and abs(self.of_sum) <= TOLERANCE
            and self.worst_of_99 <= TOLERANCE
            and self.dark <= TOLERANCE
            and self.albedo <= 0.002
        )


def document(case: Case) -> dict[str, Any]:
    """Return the scene file of a case."""
    return {
        "schema": "vtkindirect.scene/1",
        "name": case.name,
        "size": list(SIZE),
        "camera": _CAMERA,
        "actors": _ACTORS,
        "lights": case.lights,
        **case.changes,
    }


def vtk_buffers(path: Path) -> tuple[Any, dict[str, np.ndarray]]:
    """Draw a scene file with the pass; returns its description and its buffers."""
    import vtkindirect

    scene = vtkindirect.load_scene(path)
    window = scene.make_window()
    vtkindirect.enable(scene.renderer, "gather", lighting="scene", number_of_lights=16)
    indirect = vtkindirect.pass_of(scene.renderer)
    indirect.SetShadows(True)
    indirect.SetReflectiveShadowMapResolution(1024)
    window.Render()
    names = ("direct", "albedo", "normal", "depth")
    buffers = {name: vtkindirect.copy_buffer(scene.renderer, name) for name in names}
    found = exporter.export_renderer(scene.renderer, scene.name, scene.size, scene.actors.items())
    window.Finalize()
    return found, buffers


def _around(values: np.ndarray, radius: int) -> np.ndarray:
    """Return the square neighbourhoods of an image's pixels, along a new first axis."""
    padded = np.pad(values, [(radius, radius)] * 2 + [(0, 0)] * (values.ndim - 2), mode="edge")
    height, width = values.shape[:2]
    steps = range(2 * radius + 1)
    return np.stack([padded[j : j + height, i : i + width] for j in steps for i in steps])


def smooth_masks(
    vtk: dict[str, np.ndarray], traced: dict[str, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the pixels where both see the same smooth surface, away from edges of shadows.

    The first mask is of lit surfaces, the second of those that the tracer sees no light on.
    """
    valid = traced["valid"] > 0
    depth, other = traced["depth"], vtk["depth"][..., 0]
    same = valid & (np.abs(depth - other) <= 2e-3 * np.where(valid, depth, 1.0))
    same &= (traced["normal"] * vtk["normal"]).sum(axis=-1) > 0.999
    same = _around(same, 1).all(axis=0)
    normals = _around(traced["normal"], 1)
    same &= ((normals * traced["normal"]).sum(axis=-1) > 0.98).all(axis=0)
    colors = _around(traced["albedo"], 1)
    same &= (np.abs(colors - traced["albedo"]).max(axis=-1) < 1e-3).all(axis=0)
    dark = same & (_around(traced["direct"], 3).max(axis=-1).max(axis=0) == 0.0)
    # One light's shadow edge shows as a jump of the direct light; so does a cone's rim.
    for light in (traced["direct"].sum(axis=-1), vtk["direct"].sum(axis=-1)):
        near = _around(light, 2)
        same &= near.min(axis=0) > 0.8 * near.max(axis=0)
    # At a grazing angle one step of a normal's rounding is already one percent.
    level = traced["direct"].sum(axis=-1)
    return same & (level > 0.05 * level.max()), dark


def compare(case: Case) -> Result:
    """Draw a case both ways and compare."""
    with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
        folder = Path(name)
        (folder / "case.json").write_text(json.dumps(document(case)))
        found, vtk = vtk_buffers(folder / "case.json")
        found.save(folder)
        tools.trace(folder, {"size": list(found.size), "surfaces": "surfaces.npz"})
        with np.load(folder / "surfaces.npz") as arrays:
            traced = dict(arrays)
    mask, dark = smooth_masks(vtk, traced)
    leaks = vtk["direct"][dark].max(axis=-1) / vtk["direct"].max() if dark.any() else np.zeros(1)
    drawn, expected = vtk["direct"][mask], (traced["albedo"] * traced["direct"])[mask]
    error = (drawn.sum(axis=-1) - expected.sum(axis=-1)) / expected.sum(axis=-1)
    return Result(
        case.name,
        int(mask.sum()),
        float(drawn.sum() / expected.sum() - 1.0) if mask.any() else float("nan"),
        float(np.median(error)) if mask.any() else float("nan"),
        float(np.percentile(np.abs(error), 99)) if mask.any() else float("nan"),
        float(np.percentile(leaks, 99)),
        float(np.abs(vtk["albedo"] - traced["albedo"])[mask].max()) if mask.any() else 1.0,
    )
