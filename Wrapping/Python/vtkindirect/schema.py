# SPDX-License-Identifier: BSD-3-Clause
"""Checks JSON values against ``*.schema.json``: defaults are filled in, a mistake is one line.

A function of `CHECKS` says what a schema cannot, such as that two points differ; the schema
names it with the keyword ``x-check``. These run when everything else is right.
"""

from __future__ import annotations

import copy
import json
import math
import re
from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

from vtkindirect.errors import SceneError, suggestion

Values = dict[str, Any]
Wrong = Iterator[tuple[Any, ...]]
"""A fault and its place in the value: a text and the steps to the place."""


def fail(path: str, text: str) -> SceneError:
    """Return the error for the value at `path`."""
    return SceneError(f"{path}: {text}" if path else text)


def member(path: str, key: str) -> str:
    """Return the path of `key` in the object at `path`."""
    return f"{path}.{key}" if path else key


# Rules that the schema cannot state ---------------------------------------------------------------


def _direction(value: list[float]) -> Wrong:
    if not any(value):
        yield ("must not be the zero vector",)


def _interval(value: list[float]) -> Wrong:
    if value[0] >= value[1]:
        yield ("the second number must be greater than the first",)


def _bounds(value: list[float]) -> Wrong:
    for axis, name in enumerate("xyz"):
        if value[2 * axis] >= value[2 * axis + 1]:
            yield (f"{name} minimum must be less than {name} maximum",)


def _matrix(value: list[float]) -> Wrong:
    if value[12:] != [0, 0, 0, 1]:
        yield ("the last row must be 0, 0, 0, 1",)
    a, b, c, _, d, e, f, _, g, h, i, _ = value[:12]
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    lengths = [math.hypot(*row) for row in ((a, b, c), (d, e, f), (g, h, i))]
    if not abs(determinant) > 1e-12 * math.prod(lengths):
        yield ("must be invertible",)


def _area(a: list[float], b: list[float]) -> float:
    """The area of the parallelogram of two vectors over the product of their lengths."""
    (ax, ay, az), (bx, by, bz) = a, b
    area = math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    lengths = math.hypot(*a) * math.hypot(*b)
    return area / lengths if lengths > 0.0 else 0.0


def _between(start: list[float], end: list[float]) -> list[float]:
    return [b - a for a, b in zip(start, end)]


def _camera(value: Values) -> Wrong:
    view = _between(value["position"], value["focal_point"])
    if not any(view):
        yield "must differ from position", "focal_point"
    elif any(value["view_up"]) and not _area(view, value["view_up"]) > 1e-6:
        yield "must not be parallel to the direction of view", "view_up"
    if "view_angle" in value and "parallel_scale" in value:
        yield "cannot be given together with view_angle", "parallel_scale"
    if value.get("clipping_range", [1])[0] <= 0:
        yield "must be greater than 0", "clipping_range", 0


def _light(value: Values) -> Wrong:
    if value["type"] == "spot" and value["focal_point"] == value["position"]:
        yield "must differ from position", "focal_point"
    if value["type"] == "environment":
        yield from _environment(value)


def _environment(value: Values) -> Wrong:
    if ("file" in value) == ("radiance" in value):
        yield ("must have either file or radiance",)
    for key in ("up", "right"):
        if "radiance" in value and key in value:
            yield "cannot be given together with radiance, which is the same from everywhere", key
    up = value.get("up", [0, 1, 0])
    if "right" in value and any(up) and not _area(up, value["right"]) > 1e-6:
        yield "must not be parallel to up", "right"


def _lights(value: list[Values]) -> Wrong:
    places = [i for i, light in enumerate(value) if light["type"] == "environment"]
    for place in places[1:]:
        yield f"is a second environment beside lights[{places[0]}]; there can be one", place


def _attenuation(value: list[float]) -> Wrong:
    if not any(value):
        yield ("must not be all zero",)


def _actor(value: Values) -> Wrong:
    if ("file" in value) == ("source" in value):
        yield ("must have either file or source",)
    if "color" in value and "scalars" in value:
        yield "cannot be given together with scalars", "color"
    if "spheres" in value and "transform" in value:
        yield "cannot be given together with spheres; move the data in the pipeline", "transform"


def _visible(value: list[Values]) -> Wrong:
    if not any(actor["visible"] for actor in value):
        yield ("none of them is visible",)


def _plane(value: Values) -> Wrong:
    edges = [_between(value["origin"], value[end]) for end in ("point1", "point2")]
    if not _area(*edges) > 1e-9:
        yield "origin, point1 and point2 must span an area", "point2"


def _disk(value: Values) -> Wrong:
    if value["inner"] >= value["outer"]:
        yield "must be less than outer", "inner"


def _threshold(value: Values) -> Wrong:
    if "lower" not in value and "upper" not in value:
        yield ("needs lower, upper or both",)
    elif value.get("lower", -math.inf) > value.get("upper", math.inf):
        yield "must not be less than lower", "upper"


def _rotation(value: list[float]) -> Wrong:
    if not any(value[1:]):
        yield ("the axis must not be the zero vector",)


def _transform(value: Values) -> Wrong:
    given = [key for key in ("translate", "rotate", "scale") if key in value]
    if "matrix" in value and given:
        yield "cannot be given together with matrix", given[0]


def _square(value: int) -> Wrong:
    if math.isqrt(int(value)) ** 2 != value:  # what the sampler stratifies as it is told
        yield (f"must be a square, not {value}",)


def _map(value: Any) -> Wrong:
    from vtkindirect import colormaps

    wrong = colormaps.unknown(value) if isinstance(value, str) else None
    if wrong is not None:
        yield (wrong,)


CHECKS: dict[str, Callable[[Any], Wrong]] = {
    "actor": _actor,
    "attenuation": _attenuation,
    "bounds": _bounds,
    "camera": _camera,
    "direction": _direction,
    "disk": _disk,
    "interval": _interval,
    "light": _light,
    "lights": _lights,
    "map": _map,
    "matrix": _matrix,
    "plane": _plane,
    "rotation": _rotation,
    "square": _square,
    "threshold": _threshold,
    "transform": _transform,
    "visible": _visible,
}


# The validators -----------------------------------------------------------------------------------


@cache
def schema(of: str = "scene") -> Values:
    """Return a schema: that of scene files, or ``"sweep"``."""
    return json.loads(Path(__file__).with_name(f"{of}.schema.json").read_text(encoding="utf-8"))


@cache
def _validators() -> tuple[Any, Any]:
    """Return the validators without and with what the schema cannot say."""
    try:
        from jsonschema import Draft202012Validator, ValidationError
        from jsonschema.validators import extend
    except ImportError as error:
        raise ImportError(
            f"scene files need jsonschema 4 or later (Debian: python3-jsonschema): {error}"
        ) from None

    def properties(validator: Any, wanted: Values, instance: Any, whole: Values) -> Iterator[Any]:
        """The keyword ``properties``, which also fills in defaults."""
        if isinstance(instance, dict):
            for key, part in wanted.items():
                if "default" in part:
                    instance.setdefault(key, copy.deepcopy(part["default"]))
        yield from Draft202012Validator.VALIDATORS["properties"](
            validator, wanted, instance, whole
        )

    def check_of(_validator: Any, name: str, instance: Any, _whole: Values) -> Iterator[Any]:
        """The keyword ``x-check``."""
        for text, *place in CHECKS[name](instance):
            yield ValidationError(text, path=place)

    plain = extend(Draft202012Validator, {"properties": properties})
    return plain, extend(plain, {"x-check": check_of})


_KINDS = {
    "array": "a list",
    "boolean": "true or false",
    "integer": "a whole number",
    "number": "a number",
    "object": "an object",
    "string": "a string",
}


def _shown(value: Any) -> str:
    """Return a JSON-like rendering of a wrong value, short enough for one line."""
    if isinstance(value, dict):
        return "an object"
    text = repr(value) if isinstance(value, str) else json.dumps(value)
    return text if len(text) <= 40 else text[:37] + "..."


def known_keys(part: Values, instance: Any) -> list[str]:
    """Return the keys that a part of the schema of scene files knows for an object."""
    if "$ref" in part:
        part = schema()["$defs"][part["$ref"].rpartition("/")[2]]
    names = list(part.get("properties", ()))
    for one in part.get("allOf", ()):
        names += known_keys(one, instance)
    if "if" in part and _validators()[0](part["if"]).is_valid(instance):
        names += known_keys(part.get("then", {}), instance)
    return list(dict.fromkeys(names))


def _sentence(error: Any) -> tuple[list[Any], str] | None:
    """Return the place of an error and what it says; None of one that follows from others."""
    place, value, wanted = list(error.absolute_path), error.instance, error.validator_value
    rule = error.schema if isinstance(error.schema, dict) else {}
    if error.validator == "type":
        return place, f"must be {_KINDS[wanted]}, not {_shown(value)}"
    if error.validator in ("minimum", "maximum") and rule.get("type") == "integer":
        return place, f"must be from {rule['minimum']} to {rule['maximum']}, not {value}"
    words = {
        "minimum": "at least",
        "maximum": "at most",
        "exclusiveMinimum": "greater than",
        "exclusiveMaximum": "less than",
    }
    if error.validator in words:
        return place, f"must be {words[error.validator]} {wanted:g}, not {value:g}"
    if error.validator in ("minItems", "maxItems"):
        if rule.get("minItems") == rule.get("maxItems"):
            return place, f"must have {wanted} items, not {len(value)}"
        return place, f"must have at least {wanted} item{'s' if wanted > 1 else ''}"
    if error.validator == "enum":
        hint = suggestion(value, wanted) if isinstance(value, str) else ""
        return place, f"must be one of {', '.join(wanted)}, not {_shown(value)}{hint}"
    if error.validator == "required":
        missing = next(key for key in wanted if key not in value)
        return [*place, missing], "is missing"
    if error.validator in ("additionalProperties", "unevaluatedProperties"):
        known = known_keys(rule, value)
        patterns = rule.get("patternProperties", ())
        unknown = (key for key in value if key not in known)
        extra = next((k for k in unknown if not any(re.search(p, k) for p in patterns)), None)
        if extra is None:
            return None
        some = f"{suggestion(extra, known)}; known: {', '.join(known) or 'none'}"
        return [*place, extra], f"unknown key{some}"
    if error.validator in ("minProperties", "maxProperties"):
        what = "step" if "properties" in rule else "class of VTK"
        return place, f"must hold exactly one {what}, not {len(value)}"
    if error.validator == "minLength":
        return place, "must not be empty"
    if error.validator == "pattern":
        return place, "must not contain NUL"
    return place, error.message


def _path(start: str, place: list[Any]) -> str:
    path = start
    for step in place:
        path = f"{path}[{step}]" if isinstance(step, int) else member(path, step)
    return path


def check(value: Any, path: str = "", part: str | None = None, of: str = "scene") -> Any:
    """Check a value at `path` against a schema, or a part of it; defaults are filled in in place.

    Raises the `SceneError` of the innermost mistake: a wrong key makes the object around it wrong.
    With another format than the schema's nothing else matters.
    """
    whole = schema(of)
    if part is not None:
        whole = {"$ref": f"#/$defs/{part}", "$defs": whole["$defs"]}
    for kind in _validators():
        found = [said for said in map(_sentence, kind(whole).iter_errors(value)) if said]
        if found:
            place, text = max(found, key=lambda said: (said[0] == ["schema"], len(said[0])))
            raise fail(_path(path, place), text)
    return value


def optional(values: Values) -> Values:
    """Return values in which what was left out, and has no default, is None."""
    return defaultdict(lambda: None, values)
