# SPDX-License-Identifier: BSD-3-Clause
"""With nothing set a picture with the pass is no worse than plain VTK's: scenes of everyday.py."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import everyday
import support
import worth

WHY_NOT = support.why_no_rendering() or support.why_no_pyvista()
SIZE = 144
NAMES = tuple(name for name in everyday.SCENES if name != "molecule")
"""The first picture of the molecule takes 17 s."""

CLIPPED = 0.005
BRIGHTNESS = 0.1
BAR = 1.5
DOTS = 5.0
"""Dots on smooth faces, of 10,000 pixels."""

rendering = pytest.mark.skipif(WHY_NOT is not None, reason=f"{WHY_NOT}")


def scenes(**faults: str) -> Any:
    """All scenes; those that fail have their figure, and to pass is a failure of theirs."""
    marks = {
        name.replace("_", " "): pytest.mark.xfail(reason=why, strict=True)
        for name, why in faults.items()
    }
    assert marks.keys() <= set(NAMES)
    params = [pytest.param(name, marks=marks.get(name, ())) for name in NAMES]
    return pytest.mark.parametrize("name", params)


@functools.cache
def default(name: str) -> worth.Worth:
    """Return the measures of the default."""
    return seen(name).worth[worth.DEFAULT]


@functools.cache
def seen(name: str) -> worth.Seen:
    return worth.see_scene(name, SIZE, whole=False)


@rendering
@scenes()
def test_nothing_clips(name: str) -> None:
    assert default(name).clipped <= CLIPPED


@rendering
@scenes(stream_tubes="0.883 of VTK's brightness: tubes hide light from tubes")
def test_as_bright(name: str) -> None:
    assert abs(default(name).brightness - 1.0) <= BRIGHTNESS


@rendering
@scenes()
def test_faces_are_smooth(name: str) -> None:
    assert default(name).dots <= DOTS


@rendering
@scenes()
def test_colours_are_read_off_the_bar(name: str) -> None:
    bar = default(name).bar
    assert bar is None or bar <= BAR


@rendering
@scenes()
def test_nothing_lights_what_is_unlit(name: str) -> None:
    assert not seen(name).unlit_changed


def test_measures() -> None:
    """Each measure finds what it is for."""
    plain = np.full((40, 40, 3), 100, dtype=np.uint8)
    picture = plain.copy()
    picture[10, 10] = 255  # a dot, which clips
    picture[20:, :] = 110  # a step is none
    bar = np.stack([np.arange(256), 255 - np.arange(256), np.full(256, 9)], axis=-1)
    every = np.ones((40, 40), dtype=bool)
    surface = worth.Surface(every, every, None, None, ~every)
    found = worth.measure(picture, plain, surface, stepped=picture)
    assert found.clipped == 1 / 1600
    assert found.dots == found.specks == 1e4 / 1600
    assert found.creases == 0.0  # all is smooth
    rough = worth.Surface(every, ~every, None, None, ~every)
    assert worth.measure(picture, plain, rough, stepped=picture).creases == 1e4 / 1600
    assert found.brightness == pytest.approx(1.05 + 1.55 / 1600, abs=1e-3)
    # A colour at half of its brightness is the same entry, and one that is shifted is not.
    entries = np.tile(np.arange(0, 240, 6), (40, 1))
    colors = bar[entries]
    np.testing.assert_array_equal(worth.find_entries(colors.astype(np.uint8), bar), entries)
    assert np.abs(worth.read_bar((colors / 2).astype(np.uint8), bar) - entries).max() <= 2
    read = worth.Surface(every, every, None, entries, ~every)
    shifted = bar[entries + 10].astype(np.uint8)
    assert worth.measure(shifted, plain, read, bar).bar == pytest.approx(1000 / 255)
