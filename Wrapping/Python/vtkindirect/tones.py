# SPDX-License-Identifier: BSD-3-Clause
"""Curves from light to colours of the picture, by VTK's vtkToneMappingPass around the pass.

The pass of VTK takes colours for encoded with gamma 2.2: it decodes, multiplies by the exposure,
bends, and encodes. It has the exposure in two of its four curves, and in the family of the filmic
one, which includes the others' formulas. It bends what covers a pixel in part by that part only:
edges that are mixed before the curve, between light far above 1 and the background, stay bright. So
VTK's FXAA antialiases the picture behind the curve, in place of the pass.
"""

from __future__ import annotations

import json
import reprlib
import weakref
from dataclasses import dataclass
from typing import Any

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkToneMappingPass

from vtkindirect import arrays, chain, environments
from vtkindirect.errors import UsageError, check_text, unknown
from vtkindirect.keep import KEEP

NONE = "none"
CURVES = (NONE, "reinhard", "exponential", "filmic")
AUTO = "auto"

GAMMA = 2.2
PERCENTILE = 99.0
"""Share of the lit pixels, in percent, that exposure "auto" brings to 1 and below."""
BAND = (0.8, 1.25)
"""Bounds of the brightness at that share, times the exposure, between which the exposure stays."""
MOST_PIXELS = 100000
"""The brightness is that of every so many pixels in large pictures, which is fast."""

# Contrast, shoulder, mid in, mid out and greatest input of x / (b x + c): b = 0, c = 1 is x up to
# 1, and b = c = 1 is Reinhard's curve.
_STRAIGHT = (1.0, 1.0, 0.5, 0.5, 1.0)
_REINHARD = (1.0, 1.0, 0.5, 1.0 / 3.0, 1e30)


def check_curve(value: Any) -> str:
    """Return the name of a curve; None is "none"."""
    if value is None:
        return NONE
    check_text("tone_mapping", value)
    if value not in CURVES:
        raise UsageError(unknown("tone_mapping", value, CURVES))
    return value


def check_exposure(value: Any) -> float | str:
    """Return an exposure: a number above 0, or "auto"."""
    if isinstance(value, str) and value == AUTO:
        return value
    if not environments.is_number(value) or not float(value) > 0.0:
        raise UsageError(
            f'exposure must be a finite number above 0 or "auto", not {reprlib.repr(value)}'
        )
    return float(value)


@dataclass(frozen=True)
class Asked:
    """Words of a call of `enable`: checked values, or KEEP."""

    curve: Any = KEEP
    exposure: Any = KEEP


def check(curve: Any, exposure: Any) -> Asked:
    """Check the words of a call."""
    return Asked(
        curve if curve is KEEP else check_curve(curve),
        exposure if exposure is KEEP else check_exposure(exposure),
    )


def brightness(final: np.ndarray) -> float | None:
    """Return the luminance below which `PERCENTILE` of the lit pixels are, decoded; None: no pixel.

    `final` is the buffer of that name.
    """
    pixels = final.reshape(-1, final.shape[2])
    pixels = pixels[:: -(-len(pixels) // MOST_PIXELS)]
    luminance = np.maximum(pixels, 0.0) ** GAMMA @ (0.2126, 0.7152, 0.0722)
    lit = luminance[np.isfinite(luminance) & (luminance > 0.0)]
    return float(np.percentile(lit, PERCENTILE)) if lit.size else None


class Tone:
    """The curve of one renderer, the exposure, and the pass of VTK's that draws with them."""

    def __init__(self) -> None:
        self.curve = NONE
        self.exposure: float | str = 1.0
        self._found: float | None = None  # by "auto"
        self._complete = False  # no depth map was missing in the last frame
        self._pass: Any = None
        self._smooth: Any = None  # antialiases the picture behind the curve
        self._samples: tuple[Any, int] | None = None  # of a window, before the curve
        self._observed: tuple[Any, int] | None = None

    def check(self, asked: Asked, renderer: vtkRenderer) -> None:
        """Raise where somebody else maps tones already; nothing has changed then."""
        curve = self.curve if asked.curve is KEEP else asked.curve
        exposure = self.exposure if asked.exposure is KEEP else asked.exposure
        there = [found for found, _, _ in chain.links(renderer.GetPass())]
        others = [found for found in there if found is not self._pass and _maps_tones(found)]
        if (curve, exposure) != (NONE, 1.0) and others:
            raise UsageError("the renderer has a vtkToneMappingPass already")

    def ask(self, asked: Asked) -> None:
        """Take what a call says; `put` brings it about."""
        if asked.curve is not KEEP:
            self.curve = asked.curve
        if asked.exposure is not KEEP:
            self.exposure = asked.exposure
            self._found = None

    def put(self, renderer: vtkRenderer, indirect: Any, frame: bool = False) -> None:
        """Have the curve in the chain where there is something for it to do, else take it out.

        `frame`: one has begun, with the samples that the window had.
        """
        if (self.curve, self.exposure) == (NONE, 1.0):
            self.leave(renderer)
            return
        if self._pass is None:
            self._pass, self._smooth = vtkToneMappingPass(), vtkOpenGLFXAAPass()
        for effect in (self._smooth, self._pass):
            chain.take_off(renderer, effect)
        chain.put_around(renderer, chain.inside_of_curve(renderer, indirect), self._pass)
        if self._smooths(renderer, indirect) and self._takes_one_sample(renderer, frame):
            chain.put_around(renderer, self._pass, self._smooth)
        self._set()
        self._observe(indirect if self.exposure == AUTO else None)

    def start(self, renderer: vtkRenderer, indirect: Any) -> None:
        """Before a frame: see to windows and antialiasing that have come or gone."""
        if self._pass is not None:
            there = self._smooth.GetDelegatePass() is not None
            if self._smooths(renderer, indirect) != there:
                self.put(renderer, indirect, True)

    def _smooths(self, renderer: vtkRenderer, indirect: Any) -> bool:
        """Return whether edges are to be antialiased behind the curve."""
        return bool(indirect.GetAntialiasing()) and not chain.antialiases(renderer, self._smooth)

    def _takes_one_sample(self, renderer: vtkRenderer, frame: bool) -> bool:
        """Give the window one sample a pixel; return whether VTK's FXAA can draw there now.

        With several samples its picture is black. They are of no use for the colours of the pass.
        """
        window = renderer.GetRenderWindow()
        if window is None:
            return False
        samples = window.GetMultiSamples()
        if samples > 0:
            self._samples = window, samples
            window.SetMultiSamples(0)
        return samples <= 0 or not frame

    def _set(self) -> None:
        exposure = self._in_force()
        if self.curve == "exponential":
            self._pass.SetToneMappingType(vtkToneMappingPass.Exponential)
        elif self.curve == "reinhard" and self.exposure == 1.0:
            self._pass.SetToneMappingType(vtkToneMappingPass.Reinhard)
        else:
            self._pass.SetToneMappingType(vtkToneMappingPass.GenericFilmic)
            if self.curve == "filmic":
                self._pass.SetGenericFilmicDefaultPresets()
            else:
                parts = ("Contrast", "Shoulder", "MidIn", "MidOut", "HdrMax")
                for part, value in zip(parts, _STRAIGHT if self.curve == NONE else _REINHARD):
                    getattr(self._pass, f"Set{part}")(value)
                self._pass.SetUseACES(False)
        if self._pass.GetExposure() != exposure:
            self._pass.SetExposure(exposure)

    def _in_force(self) -> float:
        return (self._found or 1.0) if self.exposure == AUTO else float(self.exposure)

    def _observe(self, indirect: Any) -> None:
        """Look at each frame of a pass before its picture goes through the curve; None: at none."""
        if self._observed is not None and self._observed[0] is not indirect:
            self._observed[0].RemoveObserver(self._observed[1])
            self._observed = None
        if indirect is not None and self._observed is None:
            # Cycles of Python's through VTK's observers crash its garbage collection.
            tone = weakref.ref(self)

            def expose(caller: Any, _event: str) -> None:
                found = tone()
                if found is not None:
                    found._expose(caller)

            self._observed = indirect, indirect.AddObserver("EndEvent", expose)

    def _expose(self, indirect: Any) -> None:
        """Choose the exposure by a frame, unless the one in force still suits it."""
        report = json.loads(indirect.GetReport(False))
        if not report["paths"]:  # the delegate alone drew: no buffers
            return
        same = self._complete and not report["changed"]
        self._complete = report["counters"]["tiles_left"] == 0
        if same and self._found is not None:
            return
        image = vtkImageData()
        indirect.CopyBuffer("final", image)
        found = brightness(arrays.as_array(image))
        if found is None:
            return
        if self._found is None or not BAND[0] <= found * self._found <= BAND[1]:
            self._found = 1.0 / found
            self._pass.SetExposure(self._found)

    def leave(self, renderer: vtkRenderer) -> None:
        """Take VTK's pass out of the chain."""
        self._observe(None)
        if self._pass is None:
            return
        window = renderer.GetRenderWindow()
        if window is not None:
            window.MakeCurrent()
        for effect in (self._smooth, self._pass):
            chain.take_off(renderer, effect)
            if window is not None:
                effect.ReleaseGraphicsResources(window)
        if self._samples is not None and self._samples[0] is window:
            window.SetMultiSamples(self._samples[1])
        self._pass = self._smooth = self._samples = None

    def report(self) -> dict[str, Any]:
        """Return what is in force."""
        return {"curve": self.curve, "exposure": self._in_force(), "auto": self.exposure == AUTO}


def _maps_tones(found: Any) -> bool:
    return bool(found.IsA("vtkToneMappingPass"))
