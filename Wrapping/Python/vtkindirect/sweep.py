# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps: which methods with which settings a comparison runs.

A sweep file is one JSON object of the format ``vtkindirect.sweep/1``::

    {"schema": "vtkindirect.sweep/1", "name": "gather",
     "rows": [{"method": "gather", "settings": {"NumberOfLights": [64, 256], "Interpolation": false}}]}

A list of values stands for one row each; several lists make every combination, the last one varying
fastest. Optional keys of a row: ``sampler``, ``label`` (default: the method and what the lists
chose). Optional keys of the sweep: ``flicker`` (true: also along a path of the camera),
``path_tracer`` (samples a pixel for each of its curves, {"one_bounce": […], "all_bounces": […]}).
"""

from __future__ import annotations

import itertools
import json
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from vtkindirect import document, methods
from vtkindirect.errors import SceneError, UsageError

SCHEMA = "vtkindirect.sweep/1"
_KEYS = {"method", "sampler", "settings", "label"}
_SWEEP_KEYS = {"schema", "name", "rows", "flicker", "path_tracer"}

PATH_TRACER = {"one_bounce": [4, 16, 64, 256], "all_bounces": [4, 16, 64]}
"""Samples a pixel of the path tracer's curves when nobody says; it stratifies squares."""

MOST_SAMPLES = 4096


@dataclass(frozen=True)
class Row:
    """One method with one set of settings."""

    label: str
    method: str
    sampler: str | None = None
    settings: dict[str, Any] = field(default_factory=dict)

    def key(self) -> str:
        """What tells this row from others, as text."""
        return json.dumps([self.method, self.sampler, self.settings], sort_keys=True)


@dataclass(frozen=True)
class Sweep:
    """What a comparison runs on each scene."""

    rows: list[Row]
    flicker: bool = False
    path_tracer: dict[str, list[int]] = field(default_factory=lambda: dict(PATH_TRACER))


def default(names: list[str]) -> Sweep:
    """A sweep of methods by name, with their own settings."""
    for name in names:
        methods.check_method(name)
    return Sweep([Row(name, name) for name in names])


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _expand(entry: dict[str, Any], where: str) -> list[Row]:
    if not isinstance(entry, dict):
        raise UsageError(f"{where}: must be an object")
    for key in entry:
        if key not in _KEYS:
            raise UsageError(f"{where}.{key}: unknown key; known: {', '.join(sorted(_KEYS))}")
    method = entry.get("method")
    if not isinstance(method, str):
        raise UsageError(f"{where}.method: is missing or no text")
    sampler = entry.get("sampler")
    settings = entry.get("settings", {})
    if not isinstance(settings, dict):
        raise UsageError(f"{where}.settings: must be an object")
    lists = {name: value for name, value in settings.items() if isinstance(value, list)}
    for name, values in lists.items():
        if not values:
            raise UsageError(f"{where}.settings.{name}: the list is empty")
    rows = []
    for choice in itertools.product(*lists.values()):
        chosen = dict(zip(lists, choice))
        label = " ".join(
            [entry.get("label", method), *(f"{n}={_text(v)}" for n, v in chosen.items())]
        )
        rows.append(Row(label, method, sampler, {**settings, **chosen}))
    return rows


def _path_tracer(value: Any, where: str) -> dict[str, list[int]]:
    if not isinstance(value, dict):
        raise UsageError(f"{where}: must be an object")
    for key, samples in value.items():
        if key not in PATH_TRACER:
            raise UsageError(f"{where}.{key}: unknown key; known: {', '.join(PATH_TRACER)}")
        if not isinstance(samples, list):
            raise UsageError(f"{where}.{key}: must be a list of numbers of samples")
        for number in samples:
            # Squares are what the sampler stratifies as it is told.
            if (
                not isinstance(number, int)
                or isinstance(number, bool)
                or not 1 <= number <= MOST_SAMPLES
                or math.isqrt(number) ** 2 != number
            ):
                raise UsageError(
                    f"{where}.{key}: must be squares from 1 to {MOST_SAMPLES}, not {number!r}"
                )
    return {key: sorted(set(value.get(key, []))) for key in PATH_TRACER}


def load(path: str | Path) -> Sweep:
    """Read a sweep file; a mistake is a `UsageError` that names the key."""
    try:
        content = document.read(Path(path))
    except SceneError as error:
        raise UsageError(f"{path}: {error}") from None
    if not isinstance(content, dict):
        raise UsageError(f"{path}: the file must hold one JSON object")
    if content.get("schema") != SCHEMA:
        raise UsageError(f"{path}: schema: must be '{SCHEMA}'")
    for key in content:
        if key not in _SWEEP_KEYS:
            known = ", ".join(sorted(_SWEEP_KEYS))
            raise UsageError(f"{path}: {key}: unknown key; known: {known}")
    entries = content.get("rows")
    if not isinstance(entries, list) or not entries:
        raise UsageError(f"{path}: rows: must be a list with at least one row")
    rows: list[Row] = []
    for index, entry in enumerate(entries):
        rows += _expand(entry, f"{path}: rows[{index}]")
    labels = [row.label for row in rows]
    for label in labels:
        if labels.count(label) > 1:
            raise UsageError(f"{path}: two rows are called '{label}'; give them labels")
    flicker = content.get("flicker", False)
    if not isinstance(flicker, bool):
        raise UsageError(f"{path}: flicker: must be true or false")
    samples = content.get("path_tracer", PATH_TRACER)
    return Sweep(rows, flicker, _path_tracer(samples, f"{path}: path_tracer"))
