# SPDX-License-Identifier: BSD-3-Clause
"""Sets properties of VTK objects by name, from text or from Python values.

A property ``Name`` is a pair of methods ``SetName`` and ``GetName``; with methods ``SetNameToThis``
it is an enumeration whose values are written ``this``. Each value is read back: VTK clamps in
silence, and here a value that did not take is an error.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Iterable, Sequence
from typing import Any

from vtkmodules.vtkCommonCore import vtkObject, vtkObjectBase

from vtkindirect.errors import UsageError, unknown

_INHERITED = frozenset(dir(vtkObject))
_INTERNAL = frozenset(("ActiveDrawBuffers",))  # of every render pass; set while it draws
_BOOLEANS = {"true": True, "on": True, "1": True, "false": False, "off": False, "0": False}


def camel(name: str) -> str:
    """``number_of_lights`` -> ``NumberOfLights``; a name that begins in upper case stays."""
    if name[:1].isupper():
        return name
    return "".join(word[:1].upper() + word[1:] for word in name.split("_"))


def snake(name: str) -> str:
    """``AllTexels`` -> ``all_texels``."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def _readable(target: vtkObjectBase, name: str) -> bool:
    """Return whether a property has a value: its getter takes no arguments."""
    try:
        getattr(target, f"Get{name}")()
    except TypeError:
        return False
    return True


def properties(target: vtkObjectBase) -> list[str]:
    """Return the names of the properties of an object, without those that every object has."""
    there = set(dir(target))
    names = sorted(
        name[3:]
        for name in there
        if name.startswith("Set") and "Get" + name[3:] in there and name not in _INHERITED
    )
    return [name for name in names if name not in _INTERNAL and _readable(target, name)]


def choices(target: vtkObjectBase, name: str) -> dict[str, str]:
    """Return the values of an enumeration, each with the method that chooses it."""
    prefix = f"Set{name}To"
    return {
        snake(method[len(prefix) :]): method
        for method in dir(target)
        if method.startswith(prefix) and len(method) > len(prefix)
    }


def _number(text: str, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise UsageError(f"{name}: '{text}' is not a number") from None


def _boolean(value: Any, name: str) -> bool:
    if isinstance(value, str) and value.lower() in _BOOLEANS:
        return _BOOLEANS[value.lower()]
    if isinstance(value, (bool, int)) and value in (0, 1):
        return bool(value)
    raise UsageError(f"{name}: must be true, false, on, off, 1 or 0, not '{value}'")


def _scalar(value: Any, current: Any, name: str) -> Any:
    """Return `value` in the type of `current`, a number."""
    number = _number(value, name) if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, (int, float)):
        raise UsageError(f"{name}: must be a number, not {value!r}")
    if not math.isfinite(number):
        raise UsageError(f"{name}: must be a finite number, not '{value}'")
    if isinstance(current, int):
        if number != int(number):
            raise UsageError(f"{name}: must be a whole number, not '{value}'")
        return int(number)
    return float(number)


def _vector(value: Any, current: Sequence[Any], name: str) -> tuple[Any, ...]:
    parts = value.split(",") if isinstance(value, str) else value
    if not isinstance(parts, Sequence) or len(parts) != len(current):
        raise UsageError(f"{name}: must be {len(current)} numbers separated by commas")
    parts = [part.strip() if isinstance(part, str) else part for part in parts]
    return tuple(_scalar(part, old, name) for part, old in zip(parts, current))


def _converted(value: Any, current: Any, name: str) -> Any:
    """Return `value` in the type that the property has now."""
    if isinstance(current, bool):
        return _boolean(value, name)
    if isinstance(current, (int, float)):
        return _scalar(value, current, name)
    if isinstance(current, (tuple, list)):
        return _vector(value, current, name)
    if isinstance(current, str):
        if not isinstance(value, str):
            raise UsageError(f"{name}: must be text, not {value!r}")
        return value
    if isinstance(value, str) or (value is not None and not isinstance(value, vtkObjectBase)):
        raise UsageError(f"{name}: holds an object and cannot be given as '{value}'")
    return value


def _same(wanted: Any, got: Any) -> bool:
    if isinstance(wanted, (tuple, list)):
        return len(wanted) == len(got) and all(_same(a, b) for a, b in zip(wanted, got))
    if isinstance(wanted, float):
        return math.isclose(wanted, got, rel_tol=1e-6, abs_tol=1e-30)
    return bool(wanted == got)


def _shown(value: Any) -> str:
    if isinstance(value, (tuple, list)):
        return ",".join(_shown(part) for part in value)
    return f"{value:g}" if isinstance(value, float) else str(value)


def set_property(target: vtkObjectBase, name: str, value: Any) -> None:
    """Set one property of an object that has it."""
    get, set_ = getattr(target, f"Get{name}"), getattr(target, f"Set{name}")
    named = choices(target, name)
    before = get()
    if named and isinstance(value, str) and not value.lstrip("+-").isdigit():
        if value.lower() not in named:
            raise UsageError(f"{name}: " + unknown("value", value, named))
        getattr(target, named[value.lower()])()
        return
    if type(before) is int and hasattr(target, f"{name}On"):
        wanted: Any = int(_boolean(value, name))
    else:
        wanted = _converted(value, before, name)
    try:
        set_(wanted)
    except (TypeError, ValueError, OverflowError) as error:
        raise UsageError(f"{name}: cannot be set to '{_shown(value)}': {error}") from None
    got = get()
    if not _same(wanted, got):
        set_(before)
        raise UsageError(
            f"{name}: {_shown(value)} is out of range, the nearest value allowed is {_shown(got)}"
        )


def find(targets: Iterable[vtkObjectBase], name: str) -> tuple[vtkObjectBase, str] | None:
    """Return the first object that has a property, and the property's proper name."""
    for target in targets:
        known = {candidate.lower(): candidate for candidate in properties(target)}
        proper = known.get(camel(name).lower())
        if proper is not None:
            return target, proper
    return None


def apply(targets: Sequence[vtkObjectBase], values: dict[str, Any]) -> dict[str, Any]:
    """Set properties, each on the first of the objects that has it; all of them or none.

    Returns the values by the properties' proper names.
    """
    # NumPy's numbers and arrays become Python's.
    values = {
        name: value.tolist() if hasattr(value, "tolist") else value
        for name, value in values.items()
    }
    places = []
    for name in values:
        found = find(targets, name)
        if found is None:
            known = sorted({p for target in targets for p in properties(target)})
            raise UsageError(unknown("property", name, known))
        places.append(found)
    before = [getattr(target, f"Get{name}")() for target, name in places]
    try:
        for place, value in zip(places, values.values()):
            set_property(*place, value)
    except UsageError:
        for (target, name), value in zip(places, before):
            getattr(target, f"Set{name}")(value)
        raise
    return {name: value for (_, name), value in zip(places, values.values())}


def apply_where_possible(targets: Sequence[vtkObjectBase], values: dict[str, Any]) -> None:
    """Set those of the properties that an object has, and that take the value."""
    for name, value in values.items():
        with contextlib.suppress(UsageError):
            apply(targets, {name: value})


def parse(assignments: Iterable[str]) -> dict[str, str]:
    """Turn ``Name=value`` texts into a dictionary; the last of the same name counts."""
    result = {}
    for text in assignments:
        name, equals, value = text.partition("=")
        if not equals or not name.strip() or not value.strip():
            raise UsageError(f"--set {text}: must be Property=value")
        result[name.strip()] = value.strip()
    return result
