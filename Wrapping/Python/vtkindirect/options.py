# SPDX-License-Identifier: BSD-3-Clause
"""Words of `vtkindirect.enable` as options of the command line."""

from __future__ import annotations

import argparse
from typing import Any

from vtkindirect import qualities, skies, surroundings, tones
from vtkindirect.errors import UsageError

NONE = "none"
"""It stands for Python's None."""


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
        help=f"the axis that is up for --environment and --sun: {', '.join(surroundings.AXES)} "
        "(default: the one nearest to the camera's view-up)",
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
        action="store_true",
        help="shadows on a ground below the scene that is not seen otherwise",
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


def parse(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the words that a command line names; raises `UsageError` before anything is loaded."""
    found: dict[str, Any] = {}
    what = getattr(arguments, "environment", None)
    if what is not None:
        found["environment"] = None if what == NONE else _numbers(what, 3) or what
    if getattr(arguments, "sun", None) is not None:
        found["sun"] = _sun(arguments.sun)
    if getattr(arguments, "up", None) is not None:
        found["up"] = arguments.up
    if getattr(arguments, "quality", None) is not None:
        found["quality"] = qualities.check(arguments.quality)
    if getattr(arguments, "tone_mapping", None) is not None:
        found["tone_mapping"] = tones.check_curve(arguments.tone_mapping)
    if getattr(arguments, "exposure", None) is not None:
        number = _numbers(arguments.exposure, 1)
        found["exposure"] = tones.check_exposure(number[0] if number else arguments.exposure)
    if getattr(arguments, "ground", False):
        found["ground"] = True
    around = {name: found[name] for name in surroundings.NOTHING if name in found}
    surroundings.check(**{**surroundings.NOTHING, **around})
    return found
