# SPDX-License-Identifier: BSD-3-Clause
"""Light of the sky: making it from a file, a colour or a name, and where a renderer keeps it.

A renderer keeps its environment in VTK's information about it, so that whoever has the renderer has
the environment: `vtkindirect.enable` finds it there, and it goes when the renderer goes.
"""

from __future__ import annotations

import math
import os
import reprlib
from collections.abc import Sequence
from typing import Any

from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageShiftScale
from vtkmodules.vtkRenderingCore import vtkRenderer

from vtkindirect import data, skies, wrapped
from vtkindirect.errors import UsageError, suggestion

CLASS = "vtkEnvironmentLight"


def attach(renderer: vtkRenderer, light: Any) -> None:
    """Make a vtkEnvironmentLight that of a renderer; None takes it away."""
    renderer.GetInformation().Set(wrapped.get(CLASS).ENVIRONMENT(), light)


def attached(renderer: vtkRenderer) -> Any:
    """Return the vtkEnvironmentLight of a renderer, or None."""
    if not wrapped.has(CLASS):
        return None
    return renderer.GetInformation().Get(wrapped.get(CLASS).ENVIRONMENT())


def read_picture(path: str | os.PathLike[str]) -> vtkImageData:
    """Return an image as vtkIndirectEmitterBase takes it: bytes, or floats that are radiances.

    Other whole numbers become parts of the largest that their type can hold, as the class does it
    with bytes.
    """
    image = data.read_image(path)
    if image.GetScalarType() in (VTK_UNSIGNED_CHAR, VTK_FLOAT, VTK_DOUBLE):
        return image
    convert = vtkImageShiftScale()
    convert.SetInputData(image)
    convert.SetScale(1.0 / image.GetScalarTypeMax())
    convert.SetOutputScalarTypeToFloat()
    convert.Update()
    return convert.GetOutput()


def build(values: dict[str, Any]) -> Any:
    """Return the vtkEnvironmentLight of a checked light of a scene file; `file` is a whole path."""
    light = wrapped.get(CLASS)()
    if "radiance" in values:
        light.SetRadiance(values["radiance"])
    else:
        light.SetImage(read_picture(values["file"]))
    light.SetScale(values["scale"])
    if "up" in values:
        light.SetUp(values["up"])
    if "right" in values:
        light.SetRight(values["right"])
    return light


def from_value(value: Any) -> Any:
    """Return the vtkEnvironmentLight that a value stands for, or the name of known surroundings.

    `value` is one, a name of `skies.NAMES`, the path of an equirectangular image, a radiance of
    three numbers, or None for no environment, which gives None. Raises `UsageError`.
    """
    if value is None or (wrapped.has(CLASS) and isinstance(value, wrapped.get(CLASS))):
        return value
    if isinstance(value, str):
        if value in skies.NAMES:
            wrapped.get(CLASS)
            return value
        if not os.path.exists(value):
            raise UsageError(
                f"{value}: no such file, and no name of an environment"
                f"{suggestion(value, skies.NAMES)}; known: {', '.join(skies.NAMES)}"
            )
    light = wrapped.get(CLASS)()
    if isinstance(value, (str, os.PathLike)):
        light.SetImage(read_picture(value))
        return light
    radiance = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(radiance, Sequence) or isinstance(radiance, bytes):
        raise UsageError(
            f"environment must be a {CLASS}, a name ({', '.join(skies.NAMES)}), the path of an "
            f"image, three numbers or None, not {reprlib.repr(value)}"
        )
    if len(radiance) != 3 or not all(is_number(part) and part >= 0.0 for part in radiance):
        raise UsageError(
            "environment: a radiance must be three finite numbers, none of them negative, "
            f"not {reprlib.repr(value)}"
        )
    light.SetRadiance([float(part) for part in radiance])
    return light


def is_number(value: Any) -> bool:
    """Return whether a value is a finite number."""
    if hasattr(value, "item"):  # a number of NumPy's
        value = value.item()
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and math.isfinite(value)
