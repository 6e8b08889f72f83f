# SPDX-License-Identifier: BSD-3-Clause
"""The images that errors are measured against.

* R1: every texel of 256 x 256 maps summed in double precision, nothing between sender and receiver.
  Computed on the spot by vtkRSMReferencePass, in a build of the project with its tests.
* R2: one diffuse bounce with true visibility, R3: all bounces; path traced beforehand and stored as
  layers of ``<scene>.exr`` (irradiance in VTK's units, albedo divided out).
* S1: what comes directly from the sky, which is the buffer ``sky``, S3: that and all bounces of sky
  and lights; A1: what comes directly from area lights, the buffer ``area``, A3: that, all bounces
  and what sky there is. They are stored likewise, and take the place of the others in scenes with an
  environment or area lights, because R1, R2 and R3 know VTK's lights only and an image holds all
  light.

Where none is stored, the default method itself makes them (`refined`): a picture left alone, refined
three times, whose error is estimated.

A stored reference may be smaller than the image it judges, by an odd factor: its pixels are then
the centres of blocks of pixels, and the very same points are compared. R1 has the size of the stored
references.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vtkindirect import frames, images, messages, methods, metrics, wrapped
from vtkindirect.errors import RenderError, UsageError
from vtkindirect.scene import Scene

LIGHTS, SKY, AREA = ("R2", "R3"), ("S1", "S3"), ("A1", "A3")
STORED = (*LIGHTS, *SKY, *AREA)
MAIN = ("R3", "A3", "S3", "R2", "A1", "S1", "R1")
"""The reference that pictures of differences are made with: the first of these that is there."""
ALL_LIGHT = "irradiance"
"""The buffer that references are of, but for those of `BUFFERS`."""
BUFFERS = {"S1": "sky", "A1": "area"}
"""The buffer that a reference is of."""
Buffers = Mapping[str, np.ndarray]
"""Buffers of a frame's light by name."""
MAP_TEXELS = 256
"""Edge of the maps that make R1; at 128 its own relMSE is below 2e-5."""
FACTOR = 3
"""Width of an image over that of its stored reference, if no size is given."""
REFINEMENTS = 3
"""Refinements of the pictures that are references where none is stored."""
STEPWISE_RATE = 0.01
"""Update rate of a window off screen with which each frame does a part of the work."""


@dataclass
class References:
    """References of one scene at one image size, with the receivers that count."""

    mask: np.ndarray
    """Receivers: pixels in which a path tracer sees the same surface."""
    images: dict[str, np.ndarray] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)
    """The reason why a reference is not there, by its name."""
    surfaces: np.ndarray | None = None
    """All pixels with a surface, which R1 counts: it comes from the very same pixels."""
    estimated: dict[str, float] = field(default_factory=dict)
    """The estimated RMS error over the mean of references that the default method has made."""

    def masked_share(self) -> float | None:
        """Share of the pixels with a surface that are no receivers: silhouettes and creases."""
        if self.surfaces is None or not self.surfaces.any():
            return None
        return 1.0 - float((self.mask & self.surfaces).sum() / self.surfaces.sum())

    @property
    def main(self) -> str | None:
        """The name of the reference that pictures of differences are made with."""
        return next((name for name in MAIN if name in self.images), None)

    def buffers(self) -> tuple[str, ...]:
        """The buffers that the references are of."""
        return tuple(dict.fromkeys((ALL_LIGHT, *(buffer_of(name) for name in self.images))))

    def pairs(self, seen: Buffers) -> Iterator[tuple[str, tuple[np.ndarray, ...]]]:
        """For each reference its name, and image, reference and mask at the reference's pixels.

        Nothing is compared with references of buffers that are not there.
        """
        for name, reference in self.images.items():
            image, mask = seen.get(buffer_of(name)), self.mask
            if image is None:
                continue
            if name == "R1" and self.surfaces is not None:
                mask = self.surfaces
            factor = image.shape[0] // reference.shape[0]
            if factor > 1:
                centre = slice(factor // 2, None, factor)
                image, mask = image[centre, centre], mask[centre, centre]
            yield name, (image, reference, mask)

    def errors(self, seen: Buffers) -> dict[str, metrics.Errors]:
        """Errors of a frame against each reference that is there, by its name; as for `pairs`."""
        return {name: metrics.compare(*pair) for name, pair in self.pairs(seen)}


def buffer_of(name: str) -> str:
    """Return the buffer that a reference is of."""
    return BUFFERS.get(name, ALL_LIGHT)


def names_of(scene: Scene) -> tuple[str, ...]:
    """Return the stored references that judge images of a scene."""
    if scene.area_lights:
        return AREA if scene.environment is None else (SKY[0], *AREA)
    return SKY if scene.environment is not None else LIGHTS


def has_r1(scene: Scene) -> bool:
    """Return whether R1 judges images of a scene: whether they hold light of VTK's lights alone."""
    return names_of(scene) == LIGHTS


def r1(scene: Scene, by: int = 1) -> np.ndarray:
    """R1 of a scene in its window, at the window's size over `by`: height x width x 3.

    An odd `by` makes R1 at the centres of blocks of pixels.
    """
    methods.disable(scene.renderer)
    width, height = scene.render_window.GetSize()
    scene.render_window.SetSize(width // by, height // by)
    methods.enable(
        scene.renderer,
        "reference",
        lighting="scene",
        ReflectiveShadowMapResolution=MAP_TEXELS,
        NumberOfBounces=1,
    )
    try:
        with messages.capture() as said:
            scene.render_window.Render()
        if said.errors:
            raise RenderError(f"the reference failed: {said.first_error()}")
        return images.copy_buffer(scene.renderer, "irradiance")
    finally:
        methods.disable(scene.renderer)
        scene.render_window.SetSize(width, height)


def mask(scene: Scene) -> np.ndarray:
    """Receivers of the frame that was rendered last with the pass on."""
    depth = images.copy_buffer(scene.renderer, "depth")[..., 0]
    return metrics.receiver_mask(depth, images.copy_buffer(scene.renderer, "normal"))


def eye(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Receivers (see `mask`) and normals, 0 without a surface, of a scene in its window."""
    methods.enable(scene.renderer, "gather", lighting="scene", NumberOfLights=1)
    try:
        scene.render_window.Render()
        return mask(scene), images.copy_buffer(scene.renderer, "normal")
    finally:
        methods.disable(scene.renderer)


def read_layer(path: Path, layer: str) -> np.ndarray | None:
    """A layer of an EXR file, bottom row first; None when the file has no such layer."""
    reader = wrapped.get("vtkOpenEXRReader")()
    reader.SetFileName(os.fspath(path))
    with messages.capture() as said:
        reader.UpdateInformation()
        names = [reader.GetLayerName(i) for i in range(reader.GetNumberOfLayers())]
        if said.errors:
            raise UsageError(f"{path}: {said.first_error()}")
        if layer not in names:
            return None
        reader.SetLayer(layer)
        reader.Update()
        if said.errors:
            raise UsageError(f"{path}: {said.first_error()}")
    image = reader.GetOutput()
    scalars = image.GetPointData().GetScalars()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(scalars).reshape(height, width, -1)[..., :3].astype(np.float64)


def natural_size(stored: Path | None) -> tuple[int, int] | None:
    """Width and height that a stored reference suits best; None when there is none."""
    if stored is None or not stored.exists():
        return None
    for name in STORED:
        layer = read_layer(stored, name)
        if layer is not None:
            return FACTOR * layer.shape[1], FACTOR * layer.shape[0]
    return None


def stored_images(
    stored: Path | None, size: tuple[int, int], names: Sequence[str] = LIGHTS
) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """Layers of the EXR file `stored`, for images of `size`, and why those are missing that are.

    A file is of no use when its size does not divide the image's by the same odd number, because no
    pixel centres would coincide.
    """
    found: dict[str, np.ndarray] = {}
    missing: dict[str, str] = {}
    for name in names:
        if stored is None or not stored.exists():
            missing[name] = "there is no stored reference"
            continue
        layer = read_layer(stored, name)
        if layer is None:
            missing[name] = f"{stored.name} has no layer '{name}'"
            continue
        height, width = layer.shape[:2]
        factor = size[0] // width
        if size != (factor * width, factor * height) or factor % 2 == 0:
            missing[name] = (
                f"the {width} x {height} pixels of {stored.name} fit images of an odd multiple of "
                f"that size, not {size[0]} x {size[1]}"
            )
            continue
        found[name] = layer
    return found, missing


def _refined_picture(
    scene: Scene, bounces: int, step: frames.Step
) -> tuple[dict[str, np.ndarray], float]:
    """Render a refined picture; returns its buffers and its estimated error."""
    window = scene.render_window
    rate = window.GetDesiredUpdateRate()
    window.SetDesiredUpdateRate(STEPWISE_RATE)
    indirect = methods.enable(
        scene.renderer,
        "auto",
        lighting="scene",
        NumberOfBounces=bounces,
        NumberOfRefinements=REFINEMENTS,
    )
    try:
        with messages.capture() as said:
            window.Render()
            for _ in frames.fill([indirect], step):
                window.Render()
        if said.errors:
            raise RenderError(f"the refined picture failed: {said.first_error()}")
        report = methods.report(indirect)
        if report["counters"]["refinements"] == 0:
            why = [entry["why"] for entry in report["left_out"] if "refinement" in entry["what"]]
            raise RenderError(f"no picture can be refined: {'; '.join(why)}")
        seen = {
            name: images.copy_buffer(scene.renderer, name)
            for name in {ALL_LIGHT, *map(buffer_of, names_of(scene))}
        }
        return seen, report["estimated_error"]
    finally:
        methods.disable(scene.renderer)
        window.SetDesiredUpdateRate(rate)


def refined(
    scene: Scene, step: frames.Step = frames.no_step
) -> tuple[dict[str, np.ndarray], dict[str, float]]:
    """References of a scene in its window, made by the default method, and their estimated errors.

    They have a third of the window's size, whose pixels' centres are centres of the window's pixels, or
    the whole where it cannot be divided by three. `step` is told of each frame.
    """
    width, height = scene.render_window.GetSize()
    by = FACTOR if width % FACTOR == 0 and height % FACTOR == 0 else 1
    names = names_of(scene)
    scene.render_window.SetSize(width // by, height // by)
    try:
        found, errors = {}, {}
        for bounces in (1, 0) if "R2" in names else (0,):
            picture, error = _refined_picture(scene, bounces, step)
            for name in names:
                if (name == "R2") == (bounces == 1):
                    found[name] = picture[buffer_of(name)].astype(np.float64)
                    errors[name] = error
        return found, errors
    finally:
        scene.render_window.SetSize(width, height)


def collect(
    scene: Scene,
    size: tuple[int, int],
    stored: Path | None,
    *,
    makes: bool = False,
    step: frames.Step = frames.no_step,
) -> References:
    """All references of a scene at an image size of (width, height) pixels.

    `stored` is the EXR file with the stored ones, or None. `makes`: the default method makes them instead;
    `step` is told of each of its frames.
    """
    estimated: dict[str, float] = {}
    missing: dict[str, str] = {}
    if makes:
        images_found, estimated = refined(scene, step)
    else:
        images_found, missing = stored_images(stored, size, names_of(scene))
    first = {}
    if has_r1(scene) and wrapped.has(wrapped.ORACLE):
        # Beside stored references R1 needs no more pixels than these.
        heights = {image.shape[0] for image in images_found.values()}
        first["R1"] = r1(scene, size[1] // max(heights) if heights else 1)
    receivers, normal = eye(scene)
    surfaces = np.linalg.norm(normal, axis=-1) > 0.5
    return References(receivers, {**first, **images_found}, missing, surfaces, estimated)
