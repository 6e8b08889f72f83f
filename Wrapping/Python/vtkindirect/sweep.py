# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps: which methods with which settings a comparison runs.

A sweep file is one JSON object of the format ``vtkindirect.sweep/1``::

    {"schema": "vtkindirect.sweep/1", "name": "gather",
     "rows": [{"method": "gather", "settings": {"NumberOfLights": [64, 256], "Interpolation": false}}]}

A list of values stands for one row each; several lists make every combination, the last one varying
fastest. Optional keys of a row: ``sampler``, ``label`` (default: the method and what the lists
chose), ``pace`` (one of `frames.PACES`: what the camera does meanwhile; default: it turns by less
than a pixel, and each frame is one of a camera that stands). Optional keys of the sweep:
``flicker`` (true, or labels of rows: also along a path of the camera), ``flicker_scenes`` (names;
default: all), ``moving`` (labels of rows: also the time of a frame while the camera turns),
``path_tracer`` (samples a pixel for each of its curves, {"one_bounce": […], "all_bounces": […]}),
``path_traced_scenes`` (names; default: all).
"""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from vtkindirect import document, methods, schema
from vtkindirect.errors import SceneError, UsageError

SCHEMA = "vtkindirect.sweep/1"
PATH_TRACER = {"one_bounce": [4, 16, 64, 256], "all_bounces": [4, 16, 64]}
"""Samples a pixel of the path tracer's curves when nobody says; it stratifies squares."""


@dataclass(frozen=True)
class Row:
    """One method with one set of settings."""

    label: str
    method: str
    sampler: str | None = None
    settings: dict[str, Any] = field(default_factory=dict)
    pace: str | None = None

    def key(self) -> str:
        """Return text that only this row has."""
        paced = [] if self.pace is None else [self.pace]
        return json.dumps([self.method, self.sampler, self.settings, *paced], sort_keys=True)


@dataclass(frozen=True)
class Sweep:
    """Rows that a comparison runs on each scene."""

    rows: list[Row]
    flicker: bool | list[str] = False
    """Rows that are measured along a path of the camera, too: all, none, or those of these labels."""
    path_tracer: dict[str, list[int]] = field(default_factory=lambda: dict(PATH_TRACER))
    path_traced_scenes: list[str] | None = None
    """Names of the scenes that the path tracer's rows are of; None for all."""
    moving: list[str] = field(default_factory=list)
    """Labels of rows whose frames are timed while the camera turns, too."""
    flicker_scenes: list[str] | None = None
    """Names of the scenes in which flicker is measured; None for all."""


def default(names: list[str]) -> Sweep:
    """A sweep of methods by name, with their own settings."""
    for name in names:
        methods.check_method(name)
    return Sweep([Row(name, name) for name in names])


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _expand(entry: dict[str, Any]) -> list[Row]:
    """Return the rows of an entry: one for each combination of the values in lists."""
    method, settings = entry["method"], entry["settings"]
    lists = {name: value for name, value in settings.items() if isinstance(value, list)}
    rows = []
    for choice in itertools.product(*lists.values()):
        chosen = dict(zip(lists, choice))
        words = [entry.get("label", method), *(f"{n}={_text(v)}" for n, v in chosen.items())]
        settings_of_row = {**settings, **chosen}
        rows.append(
            Row(" ".join(words), method, entry.get("sampler"), settings_of_row, entry.get("pace"))
        )
    return rows


def load(path: str | Path) -> Sweep:
    """Read a sweep file; a mistake is a `UsageError` that names the key."""
    try:
        content = schema.check(document.read(Path(path)), of="sweep")
    except SceneError as error:
        raise UsageError(f"{path}: {error}") from None
    rows = [row for entry in content["rows"] for row in _expand(entry)]
    labels = [row.label for row in rows]
    for label in labels:
        if labels.count(label) > 1:
            raise UsageError(f"{path}: two rows are called '{label}'; give them labels")
    samples = {key: sorted(set(content["path_tracer"][key])) for key in PATH_TRACER}
    traced, flickering = (content.get(f"{what}_scenes") for what in ("path_traced", "flicker"))
    return Sweep(rows, content["flicker"], samples, traced, content["moving"], flickering)
