# SPDX-License-Identifier: BSD-3-Clause
"""The yardstick: VTK's own screen-space ambient occlusion, as people set it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager

from vtkmodules.vtkRenderingCore import vtkRenderer


def set_up(renderer: vtkRenderer) -> None:
    """Set a renderer's ambient occlusion up, without switching it on."""
    bounds = renderer.ComputeVisiblePropBounds()
    diagonal = math.dist(bounds[::2], bounds[1::2])
    # Usual choices for these: a tenth and a thousandth of the scene.
    renderer.SetSSAORadius(0.1 * diagonal)
    renderer.SetSSAOBias(0.001 * diagonal)
    renderer.SetSSAOKernelSize(32)
    renderer.SSAOBlurOn()


@contextmanager
def used(renderer: vtkRenderer) -> Iterator[None]:
    """Switch a renderer's UseSSAO on for a while."""
    set_up(renderer)
    renderer.UseSSAOOn()
    try:
        yield
    finally:
        renderer.UseSSAOOff()
