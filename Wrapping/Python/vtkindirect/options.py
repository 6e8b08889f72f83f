# SPDX-License-Identifier: BSD-3-Clause
"""Words of `vtkindirect.enable` as options of the command line."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from typing import Any

from vtkindirect import looks, qualities, skies, surroundings, tones, views
from vtkindirect.errors import UsageError
from vtkindirect.scene import Scene, is_scene_file

NONE = "none"
"""It stands for Python's None."""


_SIGNED = ("--up", "--view", "--sun")
"""Options whose value may begin with a minus sign, which argparse takes for another option."""


def joined(words: Sequence[str]) -> list[str]:
    """Return the words of a command line with such options and their values as one word."""
    found: list[str] = []
    for word in words:
        if found and found[-1] in _SIGNED and re.fullmatch(r"-([xyz]|[\d.].*)", word):
            found[-1] += f"={word}"
        else:
            found.append(word)
    return found


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options to a parser."""
    parser.add_argument(
        "--environment",
        metavar="WHAT",
        help=f"light from all around: {', '.join(skies.NAMES)}, an equirectangular image, a "
        "radiance R,G,B, or none (default: the scene's)",
    )
    parser.add_argument(
        "--sun",
        metavar="AZ,EL",
        help="a sun at an azimuth, clockwise from north, and an elevation, in degrees, and the "
        "environment overcast where there is none",
    )
    parser.add_argument(
        "--up",
        metavar="AXIS",
        help=f"the axis that is up for --environment, --sun and a data file: "
        f"{', '.join(surroundings.AXES)} (default: z of a data file, y of glTF and OBJ files; in a "
        "scene the one nearest to the camera's view-up)",
    )
    parser.add_argument(
        "--quality",
        metavar="NAME",
        help=f"how long a picture may take: {', '.join(qualities.NAMES)} "
        f"(default: {qualities.DEFAULT})",
    )
    parser.add_argument(
        "--tone-mapping",
        metavar="NAME",
        help=f"curve from light to colours: {', '.join(tones.CURVES)} (default: {tones.NONE})",
    )
    parser.add_argument(
        "--exposure",
        metavar="NUMBER",
        help=f"factor on light before that curve, or {tones.AUTO} (default: 1)",
    )
    parser.add_argument(
        "--ground",
        action="store_const",
        const=True,
        help="shadows on a ground below the scene that is not seen otherwise (default: below a data "
        "file that shows a body, such as a closed surface that is no tube)",
    )
    parser.add_argument(
        "--no-ground", action="store_const", const=False, dest="ground", help="no such ground"
    )


def add_look_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options for the look of a data file."""
    parser.add_argument(
        "--view",
        metavar="SIDE",
        help=f"side of a data file that is seen: {', '.join(views.NAMES)}, or a direction X,Y,Z from "
        "the data to the camera (default: iso, or the broad side of what is thin from there)",
    )
    parser.add_argument(
        "--color-by",
        metavar="ARRAY",
        help=f"array that colours a data file, or {looks.NONE} (default: the active scalars)",
    )
    parser.add_argument(
        "--background",
        metavar="COLOR",
        help="name of a colour, #rrggbb, or R,G,B from 0 to 1 (default: white, or the scene file's)",
    )


def _numbers(text: str, count: int) -> list[float] | None:
    """Return the numbers of a text with commas, or None."""
    parts = text.split(",")
    try:
        return [float(part) for part in parts] if len(parts) == count else None
    except ValueError:
        return None


def _sun(text: str) -> list[float]:
    numbers = _numbers(text, 2)
    if numbers is None:
        raise UsageError(f"--sun {text}: must be AZIMUTH,ELEVATION in degrees, such as 135,40")
    return numbers


def parse_look(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the words of `load_scene` that a command line names, checked."""
    names = ("view", "color_by", "background")
    found = {name: getattr(arguments, name, None) for name in names}
    for name in ("view", "background"):
        if found[name] is not None:
            found[name] = _numbers(found[name], 3) or found[name]
    up = getattr(arguments, "up", None)
    found["up"] = None if is_scene_file(arguments.scene) else up
    looks.check(**found)
    return found


def suited(words: dict[str, Any], scene: Scene) -> dict[str, Any]:
    """Return words of `enable` for a scene: a data file says what is up, and has a ground.

    It has the ground where it can stand, unless the background is black, which shows no shadow.
    """
    if scene.up is None:
        return words
    found = {name: value for name, value in words.items() if name != "ground"}
    if isinstance(found.get("environment"), str) and found["environment"] in skies.NAMES:
        found["up"] = scene.up
    if found.get("sun") is not None:
        found["up"] = scene.up
    if words.get("ground", scene.can_stand and any(scene.renderer.GetBackground())):
        found["ground"] = scene.up
        scene.leave_room()
    return found


def parse(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the words that a command line names; raises `UsageError` before anything is loaded.

    The axis that is up in a data file is a word of `parse_look`.
    """
    found: dict[str, Any] = {}
    what = getattr(arguments, "environment", None)
    if what is not None:
        found["environment"] = None if what == NONE else _numbers(what, 3) or what
    if getattr(arguments, "sun", None) is not None:
        found["sun"] = _sun(arguments.sun)
    if getattr(arguments, "up", None) is not None and is_scene_file(arguments.scene):
        found["up"] = arguments.up
    if getattr(arguments, "quality", None) is not None:
        found["quality"] = qualities.check(arguments.quality)
    if getattr(arguments, "tone_mapping", None) is not None:
        found["tone_mapping"] = tones.check_curve(arguments.tone_mapping)
    if getattr(arguments, "exposure", None) is not None:
        number = _numbers(arguments.exposure, 1)
        found["exposure"] = tones.check_exposure(number[0] if number else arguments.exposure)
    if getattr(arguments, "ground", None) is not None:
        found["ground"] = arguments.ground
    around = {name: found[name] for name in surroundings.NOTHING if name in found}
    surroundings.check(**{**surroundings.NOTHING, **around})
    return found
