# SPDX-License-Identifier: BSD-3-Clause
"""Reads JSON strictly: no duplicate keys, finite numbers, and errors that name the place."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from vtkindirect.errors import SceneError
from vtkindirect.schema import fail, member

MAXIMUM_BYTES = 64 * 1024 * 1024


class _Object(dict):
    """A JSON object that remembers the first key that came twice."""

    duplicate: str | None = None


def _object(pairs: list[tuple[str, Any]]) -> _Object:
    result = _Object()
    for key, value in pairs:
        if key in result and result.duplicate is None:
            result.duplicate = key
        result[key] = value
    return result


def _refuse_constant(name: str) -> Any:
    raise SceneError(f"{name} is not a JSON number")


def _finite(value: float) -> bool:
    try:
        return math.isfinite(value)
    except OverflowError:  # an integer beyond all floats
        return False


def _check(value: Any, path: str) -> None:
    if isinstance(value, _Object):
        if value.duplicate is not None:
            raise fail(member(path, value.duplicate), "is given twice")
        for key, item in value.items():
            _check(item, member(path, key))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            _check(item, f"{path}[{index}]")
    elif isinstance(value, (int, float)) and not _finite(value):
        raise fail(path, "must be a finite number")


def parse(text: str) -> Any:
    """Return the value of a JSON text."""
    try:
        value = json.loads(text, object_pairs_hook=_object, parse_constant=_refuse_constant)
        _check(value, "")
    except json.JSONDecodeError as error:
        raise SceneError(
            f"not JSON: {error.msg} (line {error.lineno}, column {error.colno})"
        ) from None
    except RecursionError:
        raise SceneError("not a scene: nested too deeply") from None
    except SceneError:
        raise
    except ValueError as error:
        raise SceneError(f"not JSON: {error}") from None
    return value


def read(path: Path) -> Any:
    """Return the value of a JSON file."""
    try:
        if path.stat().st_size > MAXIMUM_BYTES:
            raise SceneError(f"larger than {MAXIMUM_BYTES // 1024**2} MiB, not a scene file")
        return parse(path.read_text(encoding="utf-8-sig"))
    except UnicodeDecodeError:
        raise SceneError("not JSON: the text is not UTF-8") from None
    except OSError as error:
        raise SceneError(f"cannot be read: {error.strerror}") from None
