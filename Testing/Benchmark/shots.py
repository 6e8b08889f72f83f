# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as people look at them, made of those of Testing/Scenes: other camera, background, lights.

`Shot.load` gives a scene for the public API; nothing of a scene file is written down twice.
"""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import vtkindirect

SCENES = Path(__file__).resolve().parent.parent / "Scenes"
WHITE = (1.0, 1.0, 1.0)
SIZE = (400, 300)

Values = dict[str, Any]
LIGHT_KIT: Values = {"type": "light_kit"}
STUDIO: Values = {"environment": "studio", "ground": True}


@dataclass(frozen=True)
class Shot:
    """A scene file with changes.

    `without`: names of its actors to leave out. `ground`: what the object stands on. `changes` take
    the place of its keys. `sun`: the direction in which light of a single sun travels. `lights`: None
    for those of the scene file. `lighting`: the preset that suits it. `words`: those of
    `vtkindirect.enable` for a picture to publish.
    """

    title: str
    scene: str
    sun: tuple[float, float, float]
    without: tuple[str, ...] = ()
    ground: tuple[str, ...] = ()
    changes: Values = field(default_factory=dict)
    lights: tuple[Values, ...] | None = (LIGHT_KIT,)
    lighting: str = "scene"
    words: Values = field(default_factory=dict)

    def document(self) -> Values:
        """The scene file with its changes; paths of data files are whole."""
        path = SCENES / f"{self.scene}.json"
        values = json.loads(path.read_text(encoding="utf-8"))
        values |= {"background": WHITE, "size": SIZE}
        values |= {"lights": self.lights} if self.lights is not None else {}
        values |= self.changes
        values["actors"] = [
            actor for actor in values["actors"] if actor.get("name") not in self.without
        ]
        for part in (*values["actors"], *values["lights"]):
            if "file" in part:
                part["file"] = str((SCENES / part["file"]).resolve())
        return json.loads(json.dumps(values))

    def load(self, lights: tuple[Values, ...] | None = None, **changes: Any) -> vtkindirect.Scene:
        """The scene; `lights` in place of its own, and further changes."""
        values = self.document() | changes
        if lights is not None:
            values["lights"] = lights
        with tempfile.TemporaryDirectory(prefix="vtkindirect-") as name:
            path = Path(name) / "shot.json"
            path.write_text(json.dumps(values), encoding="utf-8")
            return vtkindirect.load_scene(path)

    def alone(self) -> Shot:
        """The same without what the object stands on."""
        return replace(self, without=(*self.without, *self.ground))

    def one_sun(self) -> tuple[Values, ...]:
        """A single parallel light and nothing else."""
        return ({"type": "directional", "direction": self.sun},)


def _isosurface(value: float, color: tuple[float, float, float]) -> Values:
    """A surface of VTK's wavelet."""
    return {
        "name": f"{value:g}",
        "source": {"vtkRTAnalyticSource": {}},
        "pipeline": [{"contour": {"array": "RTData", "value": value}}],
        "color": color,
    }


def _superquadric() -> Values:
    shape = {"Toroidal": True, "Thickness": 0.33, "PhiRoundness": 0.6, "ThetaRoundness": 0.6}
    fine = {"PhiResolution": 64, "ThetaResolution": 64}
    source = {"vtkSuperquadricSource": {**shape, **fine}}
    return {"name": "superquadric", "source": source, "color": (0.2, 0.6, 0.5)}


def _quadric(value: float, color: tuple[float, float, float]) -> Values:
    """A surface of a structured grid, as in VTK's own example of a quadric."""
    quadric = {"vtkQuadric": {"Coefficients": [0.5, 1, 0.2, 0, 0.1, 0, 0, 0.2, 0, 0]}}
    grid = {"SampleDimensions": [40, 40, 40], "ImplicitFunction": quadric}
    return {
        "name": f"{value:g}",
        "source": {"vtkSampleFunction": grid},
        "pipeline": [{"vtkContourFilter": {"Value": [0, value]}}],
        "color": color,
    }


def _air(count: int, radius: float) -> Values:
    """Paths of air in the room of a fire, coloured by its temperature."""
    seeds = {"point1": [0.4, 0.1, 0.15], "point2": [4.9, 2.3, 2.2], "count": count}
    return {
        "name": "air",
        "file": "../Data/room_fire_cfd.vtu",
        "pipeline": [
            {"stream_tracer": {"vectors": "uvw", "seeds": seeds}},
            {"tube": {"radius": radius, "sides": 16}},
            {"normals": {"feature_angle": 60}},
        ],
        "scalars": {"array": "t", "range": [298, 420], "map": "coolwarm"},
    }


SHOTS = {
    "molecule": Shot(
        "A protein, atoms coloured by chain",
        "protein",
        (-0.6, -0.7, -0.4),
        without=("ground", "wall", "back"),
        changes={
            "camera": {
                "position": [78, 40, 165], "focal_point": [47, 6, 10], "view_angle": 26
            }
        },
        lighting="soft",
        words=STUDIO,
    ),
    "isosurfaces": Shot(
        "Isosurfaces of a wavelet",
        "cornell_box",
        (-0.5, -0.8, -0.4),
        changes={
            "camera": {"position": [25, 18, 38], "focal_point": [0, -1, 0], "view_angle": 36},
            "actors": [
                _isosurface(110.0, (0.3, 0.5, 0.85)),
                _isosurface(160.0, (0.9, 0.75, 0.3)),
                _isosurface(210.0, (0.85, 0.3, 0.2)),
            ],
        },
        lighting="full",
    ),
    "tissues": Shot(
        "Tissues of a frog, smoothed surfaces of labels",
        "frog",
        (-0.6, -0.7, -0.4),
        without=("ground", "wall"),
    ),
    "superquadric": Shot(
        "A superquadric torus",
        "cornell_box",
        (-0.6, -0.7, -0.4),
        changes={
            "camera": {"position": [1.2, 1.6, 1.6], "focal_point": [0, 0, 0], "view_angle": 30},
            "actors": [_superquadric()],
        },
    ),
    "quadric": Shot(
        "Contours of a quadric, one within the other",
        "cornell_box",
        (-0.6, -0.7, -0.4),
        changes={
            "camera": {"position": [2.2, 2.0, 4.0], "focal_point": [0, 0, 0], "view_angle": 35},
            "actors": [
                _quadric(0.1, (0.8, 0.3, 0.2)),
                _quadric(0.5, (0.3, 0.6, 0.3)),
                _quadric(0.9, (0.3, 0.4, 0.8)),
            ],
        },
    ),
    "machine": Shot(
        "A machine part",
        "sky_machine",
        (-0.6, -0.7, -0.4),
        ground=("table",),
        lighting="full",
        words=STUDIO,
    ),
    "terrain": Shot(
        "A terrain under sky and sun",
        "sky_terrain",
        (0.7, -0.6, -0.3),
        changes={
            "camera": {"position": [2.0, 9.0, 11.5], "focal_point": [0.1, 0, 0.4], "view_angle": 32}
        },
        lights=(
            {
                "type": "directional", "direction": (0.7, -0.6, -0.3),
                "color": (1.0, 0.93, 0.8), "intensity": 1.1,
            },
            {"type": "environment", "radiance": (0.25, 0.34, 0.5)},
        ),
    ),
    "fire": Shot(
        "A fire in a room: hot layer, paths of air",
        "room_fire",
        (-0.3, -0.8, -0.5),
        changes={"background": (0.03, 0.03, 0.04)},
        lights=None,
    ),
    "streamlines": Shot(
        "Paths of air in a room, coloured by temperature",
        "room_fire",
        (-0.6, -0.7, -0.4),
        changes={
            "camera": {
                "position": [-0.6, 4.2, 7.2], "focal_point": [2.9, 1.0, 1.2], "view_angle": 27
            },
            "actors": [_air(70, 0.022)],
        },
        words=STUDIO,
    ),
    "particles": Shot(
        "Particles of a granular flow, coloured by radius",
        "sky_particles",
        (-0.6, -0.7, -0.4),
        ground=("ground",),
        changes={
            "camera": {
                "position": [27.7, 92.6, 184.9], "focal_point": [0, -4, 0], "view_angle": 28
            },
            "actors": [
                {
                    "name": "particles",
                    "file": "../Data/particles.vtp",
                    "spheres": {"radius": 1, "scale_by": "radius"},
                    "scalars": {"array": "radius", "map": "viridis"},
                },
                {
                    "name": "ground",
                    "source": "plane",
                    "origin": [-90, -21, 70],
                    "point1": [90, -21, 70],
                    "point2": [-90, -21, -70],
                    "color": [0.8, 0.8, 0.8],
                },
            ],
        },
        words={"environment": "overcast"},
    ),
    "brain": Shot(
        "A brain, the contour of an MRI",
        "brain",
        (0.5, -0.6, -0.6),
        without=("ground", "wall"),
        changes={
            "camera": {
                "position": [-215, 340, 180], "focal_point": [92, 105, 72], "view_up": [0, 0, 1],
                "view_angle": 24,
            }
        },
        lighting="soft",
        words=STUDIO,
    ),
    "apartment": Shot(
        "A flat at noon, its roof cut away",
        "apartment_living",
        (0.35, -0.8, -0.45),
        changes={
            "camera": {
                "position": [6.9, 17.5, 14.5], "focal_point": [5.85, 0.3, 4.25], "view_angle": 28
            },
            "actors": [
                {
                    "name": "flat",
                    "file": "../Data/apartment_2BedroomApartment.vtp",
                    "pipeline": [
                        {"threshold": {"array": "is_light", "upper": 0}},
                        {"clip": {"origin": [0, 2.0, 0], "normal": [0, -1, 0]}},
                    ],
                }
            ],
        },
        lights=(
            {
                "type": "directional", "direction": (0.35, -0.8, -0.45),
                "color": (1.0, 0.95, 0.86), "intensity": 0.8,
            },
            {"type": "environment", "radiance": (0.3, 0.36, 0.45)},
        ),
    ),
}  # fmt: skip
