# SPDX-License-Identifier: BSD-3-Clause
"""Checks of JSON values. A format is a table of fields, and a check is a row's business.

A check is called with a value and its path in the document (``actors[2].color``). It returns the
value in the form that the rest of the package uses, or raises `SceneError` naming the path.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from vtkindirect.errors import SceneError, suggestion

Check = Callable[[Any, str], Any]


def fail(path: str, text: str) -> SceneError:
    """Return the error for the value at `path`."""
    return SceneError(f"{path}: {text}" if path else text)


def member(path: str, key: str) -> str:
    """Return the path of `key` in the object at `path`."""
    return f"{path}.{key}" if path else key


def _shown(value: Any) -> str:
    """Return a JSON-like rendering of a wrong value, short enough for one line."""
    if isinstance(value, bool) or value is None:
        return {True: "true", False: "false", None: "null"}[value]
    if isinstance(value, Mapping):
        return "an object"
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def number(
    *,
    minimum: float = -math.inf,
    maximum: float = math.inf,
    above: float = -math.inf,
    below: float = math.inf,
) -> Check:
    """A finite number; `minimum` and `maximum` are allowed values, `above` and `below` are not."""

    def check(value: Any, path: str) -> float:
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise fail(path, f"must be a number, not {_shown(value)}")
        try:
            result = float(value)
        except OverflowError:
            result = math.inf
        if not math.isfinite(result):
            raise fail(path, "must be a finite number")
        if result < minimum:
            raise fail(path, f"must be at least {minimum:g}, not {result:g}")
        if result > maximum:
            raise fail(path, f"must be at most {maximum:g}, not {result:g}")
        if result <= above:
            raise fail(path, f"must be greater than {above:g}, not {result:g}")
        if result >= below:
            raise fail(path, f"must be less than {below:g}, not {result:g}")
        return result

    return check


def integer(*, minimum: int, maximum: int) -> Check:
    """A whole number of the given range, both ends included."""

    def check(value: Any, path: str) -> int:
        if isinstance(value, bool) or not isinstance(value, (int, float)) or value != value // 1:
            raise fail(path, f"must be a whole number, not {_shown(value)}")
        if not minimum <= value <= maximum:
            raise fail(path, f"must be from {minimum} to {maximum}, not {value}")
        return int(value)

    return check


def boolean(value: Any, path: str) -> bool:
    """true or false."""
    if not isinstance(value, bool):
        raise fail(path, f"must be true or false, not {_shown(value)}")
    return value


def text(value: Any, path: str) -> str:
    """A string that is not empty."""
    if not isinstance(value, str):
        raise fail(path, f"must be a string, not {_shown(value)}")
    if not value or "\0" in value:
        raise fail(path, "must not be empty" if not value else "must not contain NUL")
    return value


def choice(*names: str) -> Check:
    """One of the given strings."""

    def check(value: Any, path: str) -> str:
        if not isinstance(value, str) or value not in names:
            hint = suggestion(value, names) if isinstance(value, str) else ""
            raise fail(path, f"must be one of {', '.join(names)}, not {_shown(value)}{hint}")
        return value

    return check


def array(check_item: Check, *, length: int | None = None, minimum: int = 0) -> Check:
    """A list, of exactly `length` items when given, else of at least `minimum`."""

    def check(value: Any, path: str) -> list[Any]:
        if not isinstance(value, list):
            raise fail(path, f"must be a list, not {_shown(value)}")
        if length is not None and len(value) != length:
            raise fail(path, f"must have {length} items, not {len(value)}")
        if len(value) < minimum:
            raise fail(path, f"must have at least {minimum} item{'s' if minimum > 1 else ''}")
        return [check_item(item, f"{path}[{i}]") for i, item in enumerate(value)]

    return check


def one_or_more(check_item: Check) -> Check:
    """A value or a list of values; gives a list."""
    many = array(check_item, minimum=1)

    def check(value: Any, path: str) -> list[Any]:
        return many(value, path) if isinstance(value, list) else [check_item(value, path)]

    return check


def one_or_three(check_item: Check) -> Check:
    """A value for all axes or a list of three; gives a list of three."""
    three = array(check_item, length=3)

    def check(value: Any, path: str) -> list[Any]:
        return three(value, path) if isinstance(value, list) else [check_item(value, path)] * 3

    return check


point = array(number(), length=3)


def direction(value: Any, path: str) -> list[float]:
    """Three numbers that are not all zero."""
    result = point(value, path)
    if not any(result):
        raise fail(path, "must not be the zero vector")
    return result


def interval(value: Any, path: str) -> list[float]:
    """Two numbers, the second greater than the first."""
    result = array(number(), length=2)(value, path)
    if result[0] >= result[1]:
        raise fail(path, "the second number must be greater than the first")
    return result


def bounds(value: Any, path: str) -> list[float]:
    """xmin, xmax, ymin, ymax, zmin, zmax, each pair in order."""
    result = array(number(), length=6)(value, path)
    for axis, name in enumerate("xyz"):
        if result[2 * axis] >= result[2 * axis + 1]:
            raise fail(path, f"{name} minimum must be less than {name} maximum")
    return result


def matrix(value: Any, path: str) -> list[float]:
    """16 numbers, row-major: an affine map that can be inverted."""
    result = array(number(), length=16)(value, path)
    if result[12:] != [0.0, 0.0, 0.0, 1.0]:
        raise fail(path, "the last row must be 0, 0, 0, 1")
    a, b, c, _, d, e, f, _, g, h, i, _ = result[:12]
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    lengths = [math.hypot(*row) for row in ((a, b, c), (d, e, f), (g, h, i))]
    if not abs(determinant) > 1e-12 * math.prod(lengths):
        raise fail(path, "must be invertible")
    return result


color = array(number(minimum=0, maximum=1), length=3)


@dataclass(frozen=True)
class Field:
    """One key of an object: how to check it, and its value when it is left out."""

    check: Check
    default: Any = None
    required: bool = False


def required(check: Check) -> Field:
    """A key that must be there."""
    return Field(check, required=True)


Table = Mapping[str, Field]


def check_keys(value: Any, path: str, allowed: Sequence[str]) -> None:
    """Raise unless `value` is an object with no other keys than the allowed ones."""
    if not isinstance(value, dict):
        raise fail(path, f"must be an object, not {_shown(value)}")
    for key in value:
        if key not in allowed:
            raise fail(
                member(path, key),
                f"unknown key{suggestion(key, allowed)}; known: {', '.join(allowed) or 'none'}",
            )


def check_table(value: Any, path: str, table: Table) -> dict[str, Any]:
    """Check an object against a table; returns it with defaults for what was left out."""
    check_keys(value, path, tuple(table))
    result = {}
    for key, field in table.items():
        if key in value:
            result[key] = field.check(value[key], member(path, key))
        elif field.required:
            raise fail(member(path, key), "is missing")
        else:
            result[key] = field.default
    return result
