# SPDX-License-Identifier: BSD-3-Clause
"""Flicker: how much more an image changes along a path of the camera than it should.

The camera turns around its focal point in small steps, half of them to either side of where the
scene has it. The image should change as much as R1 changes, with smaller maps than for the
errors: rendered at a fraction of the size, so that its pixels are centres of blocks of pixels, and
compared with the very same points of the row's images.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera

from vtkindirect import images, messages, methods, references
from vtkindirect.errors import RenderError
from vtkindirect.metrics import MetricError, pair
from vtkindirect.scene import Scene

FRAMES = 5
STEP = 0.5
"""Degrees between frames: a few pixels at the sizes that are compared."""

ANGLES = [STEP * (index - 0.5 * (FRAMES - 1)) for index in range(FRAMES)]
"""Azimuth of each frame, in degrees from where the scene has the camera."""

MAP_TEXELS = 128
"""Edge of the maps that make the reference; its own relMSE is below 2e-5."""

LEAST_WIDTH = 96
"""Images are thinned out to no less than this many pixels, in either direction."""


@dataclass(frozen=True)
class Truth:
    """The reference's frames, the pixels that count, and how far images are thinned out."""

    frames: list[np.ndarray]
    masks: list[np.ndarray]
    factor: int


def factor(size: tuple[int, int]) -> int:
    """The largest odd number that divides both lengths and leaves enough of them."""
    common = math.gcd(*size)
    fits = (n for n in range(common, 0, -1) if n % 2 == 1 and common % n == 0)
    return next((n for n in fits if min(size) // n >= LEAST_WIDTH), 1)


def thin(image: np.ndarray, by: int) -> np.ndarray:
    """The pixels in the centres of blocks of `by` x `by` pixels."""
    centre = slice(by // 2, None, by)
    return image[centre, centre]


def _frames(scene: Scene) -> Iterator[None]:
    """Render each frame of the path; the camera is as before afterwards."""
    camera = scene.renderer.GetActiveCamera()
    before = vtkCamera()
    before.DeepCopy(camera)
    try:
        for angle in ANGLES:
            camera.DeepCopy(before)
            camera.Azimuth(angle)
            camera.OrthogonalizeViewUp()
            with messages.capture() as said:
                scene.render_window.Render()
            if said.errors:
                raise RenderError(f"rendering failed: {said.first_error()}")
            yield
    finally:
        camera.DeepCopy(before)


def frames(scene: Scene, by: int) -> list[np.ndarray]:
    """Irradiance of each frame by the pass that is on, thinned out."""
    return [thin(images.copy_buffer(scene.renderer, "irradiance"), by) for _ in _frames(scene)]


def normals(scene: Scene) -> list[np.ndarray]:
    """Normals of each frame's pixels, 0 without a surface."""
    methods.enable(scene.renderer, "gather", lighting="scene", NumberOfLights=1)
    try:
        return [images.copy_buffer(scene.renderer, "normal") for _ in _frames(scene)]
    finally:
        methods.disable(scene.renderer)


def truth(scene: Scene, size: tuple[int, int]) -> Truth:
    """The reference along the path, for images of `size`; leaves the window at that size."""
    by = factor(size)
    window = scene.render_window
    methods.disable(scene.renderer)
    try:
        methods.enable(scene.renderer, "gather", NumberOfLights=1)
        masks = [thin(references.mask(scene), by) for _ in _frames(scene)]
        methods.disable(scene.renderer)
        window.SetSize(size[0] // by, size[1] // by)
        methods.enable(scene.renderer, "reference", ReflectiveShadowMapResolution=MAP_TEXELS)
        return Truth(frames(scene, 1), masks, by)
    finally:
        methods.disable(scene.renderer)
        window.SetSize(*size)


def _steps(
    images: list[np.ndarray],
    references: list[np.ndarray],
    masks: list[np.ndarray] | None,
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, float]]:
    """Yield each frame and the next, at pixels that count in both, and their reference's mean.

    Image, reference, next image, next reference, mean of the reference.
    """
    if len(images) != len(references) or len(images) < 2:
        raise MetricError("flicker needs two or more frames, and a reference for each")
    for i in range(len(images) - 1):
        mask = None if masks is None else np.asarray(masks[i]) & np.asarray(masks[i + 1])
        first, first_reference, mean = pair(images[i], references[i], mask)
        second, second_reference, _ = pair(images[i + 1], references[i + 1], mask)
        yield first, first_reference, second, second_reference, mean


def error_flicker(
    images: list[np.ndarray],
    references: list[np.ndarray],
    masks: list[np.ndarray] | None = None,
) -> float:
    """Mean change of the error from frame to frame, over the reference's mean; never negative.

    `flicker` is blind to a change that the image lacks elsewhere; here nothing cancels. An error
    that stays where it is on a surface moves over the screen with it and counts too, so this is to
    be compared with that of another method with the same lights, not with nothing.
    """
    total = 0.0
    light = 0.0
    for first, first_reference, second, second_reference, mean in _steps(images, references, masks):
        error = (second - second_reference) - (first - first_reference)
        total += float(np.abs(error).mean())
        light += mean
    return total / light


def change(images: list[np.ndarray], masks: list[np.ndarray] | None = None) -> float:
    """Mean change from frame to frame over the mean of the frames, whatever its cause.

    The list holds the frames of one camera or light path, in order; at least two.
    """
    if len(images) < 2:
        raise MetricError("a change needs two or more frames")
    total = 0.0
    light = 0.0
    for i in range(len(images) - 1):
        mask = None if masks is None else np.asarray(masks[i]) & np.asarray(masks[i + 1])
        first, second, mean = pair(images[i], images[i + 1], mask)
        total += float(np.abs(second - first).mean())
        light += 0.5 * (float(first.mean()) + mean)
    return total / light


def flicker(
    images: list[np.ndarray],
    references: list[np.ndarray],
    masks: list[np.ndarray] | None = None,
) -> float:
    """Mean change from frame to frame beyond the reference's own, over the reference's mean.

    The lists hold the frames of one camera or light path, in order; at least two.
    """
    total = 0.0
    light = 0.0
    for first, first_reference, second, second_reference, mean in _steps(images, references, masks):
        total += float(np.abs(second - first).mean())
        total -= float(np.abs(second_reference - first_reference).mean())
        light += mean
    return total / light


def judge(found: list[np.ndarray], against: Truth) -> dict[str, float]:
    """Flicker of thinned images and of their error, and how much the images change at all."""
    return {
        "flicker": flicker(found, against.frames, against.masks),
        "flicker_error": error_flicker(found, against.frames, against.masks),
        "change": change(found, against.masks),
    }
