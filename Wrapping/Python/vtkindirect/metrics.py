# SPDX-License-Identifier: BSD-3-Clause
"""Errors of an image against a reference.

Images are float arrays of shape (height, width) or (height, width, channels), linear and unclamped;
for indirect light they are irradiance, with the albedo divided out. A mask of shape (height, width)
chooses the pixels that count: receivers, away from silhouettes. Every function raises MetricError
for images that cannot be compared (shapes, no pixel left, values that are not finite, a reference
without light), because a number would be taken for a result.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

RELATIVE_FLOOR = 0.01
"""Part of the reference's squared mean that keeps relMSE finite in the dark."""

TRIMMED_SHARE = 0.01
"""Share of the worst pixels that the trimmed relMSE leaves out.

Where a rasteriser and a path tracer give a pixel to different surfaces, 1 % of the pixels makes
three quarters of relMSE.
"""

LEAK_FLOOR = 1e-3
"""A pixel whose reference is below this share of the reference's mean counts as unlit."""


class MetricError(ValueError):
    """The images cannot be compared."""


@dataclass(frozen=True)
class Errors:
    """Errors of one image; all are relative to the reference's mean unless the name says otherwise."""

    nrmse: float
    """Root of the mean squared difference over the reference's mean."""
    relmse: float
    """mean((I - R)^2 / (R^2 + RELATIVE_FLOOR mean(R)^2))."""
    relmse_trimmed: float
    """The same without the worst TRIMMED_SHARE of pixels."""
    bias: float
    """mean(I - R) / mean(R), signed."""
    p99: float
    """99th percentile of |I - R| over the reference's mean."""
    shape: float
    """nrmse after the one scale that fits best: what is left when brightness is forgiven."""
    scale: float
    """The scale of `shape`: image times scale fits the reference best."""
    leak: float
    """Share of the image's light that lies where the reference has none."""

    def as_dict(self) -> dict[str, float]:
        """The fields by name."""
        return asdict(self)


def pair(
    image: np.ndarray, reference: np.ndarray, mask: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray, float]:
    """Masked pixels as (n, channels) in double precision, and the reference's mean."""
    image = np.asarray(image, dtype=np.float64)
    reference = np.asarray(reference, dtype=np.float64)
    if image.shape != reference.shape:
        raise MetricError(f"shapes differ: image {image.shape}, reference {reference.shape}")
    if image.ndim not in (2, 3):
        raise MetricError(f"an image has 2 or 3 dimensions, not {image.ndim}")
    if image.ndim == 2:
        image = image[..., np.newaxis]
        reference = reference[..., np.newaxis]
    if mask is None:
        mask = np.ones(image.shape[:2], dtype=bool)
    mask = np.asarray(mask, dtype=bool)
    if mask.shape != image.shape[:2]:
        raise MetricError(f"mask has shape {mask.shape}, image {image.shape[:2]}")
    if not mask.any():
        raise MetricError("the mask leaves no pixel")
    image = image[mask]
    reference = reference[mask]
    for name, values in (("image", image), ("reference", reference)):
        if not np.isfinite(values).all():
            raise MetricError(f"the {name} holds values that are not finite")
    mean = float(reference.mean())
    if not mean > 0.0:
        raise MetricError("the reference holds no light")
    return image, reference, mean


def compare(
    image: np.ndarray, reference: np.ndarray, mask: np.ndarray | None = None
) -> Errors:
    """All errors of an image against a reference."""
    image, reference, mean = pair(image, reference, mask)
    difference = image - reference
    squared = difference**2
    relative = squared / (reference**2 + RELATIVE_FLOOR * mean**2)
    per_pixel = np.sort(relative.mean(axis=1))
    kept = max(1, int(np.ceil(per_pixel.size * (1.0 - TRIMMED_SHARE))))

    energy = float((image**2).sum())
    scale = float((image * reference).sum()) / energy if energy > 0.0 else 1.0
    shape = np.sqrt(((scale * image - reference) ** 2).mean()) / mean

    dark = reference.mean(axis=1) < LEAK_FLOOR * mean
    total = float(image.sum())
    leak = float(image[dark].sum()) / total if total > 0.0 else 0.0
    return Errors(
        nrmse=float(np.sqrt(squared.mean()) / mean),
        relmse=float(relative.mean()),
        relmse_trimmed=float(per_pixel[:kept].mean()),
        bias=float(difference.mean() / mean),
        p99=float(np.percentile(np.abs(difference).mean(axis=1), 99.0) / mean),
        shape=float(shape),
        scale=scale,
        leak=leak,
    )


def receiver_mask(
    depth: np.ndarray, normal: np.ndarray, *, slope: float = 0.02, cosine: float = 0.95
) -> np.ndarray:
    """Pixels whose 3 x 3 neighbourhood is one smooth surface: no silhouette, no crease.

    depth: (height, width), 0 for background; normal: (height, width, 3). slope: largest relative
    departure of the depth from a plane through the neighbours; cosine: least between normals.
    A rasteriser and a path tracer put edges in different pixels; such pixels judge neither.
    """
    depth = np.asarray(depth, dtype=np.float64)
    normal = np.asarray(normal, dtype=np.float64)
    height, width = depth.shape
    mask = np.zeros(depth.shape, dtype=bool)
    if height < 3 or width < 3:
        return mask
    centre = depth[1:-1, 1:-1]
    inside = (centre > 0.0) & (np.linalg.norm(normal[1:-1, 1:-1], axis=-1) > 0.5)
    with np.errstate(divide="ignore", invalid="ignore"):
        for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
            first = depth[1 + dy : height - 1 + dy, 1 + dx : width - 1 + dx]
            second = depth[1 - dy : height - 1 - dy, 1 - dx : width - 1 - dx]
            # On a plane 1 / depth is linear over the image, for perspective views; parallel views
            # differ from that by second order only.
            bend = np.abs(0.5 * (1.0 / first + 1.0 / second) * centre - 1.0)
            inside &= (first > 0.0) & (second > 0.0) & (bend < slope)
            for sy, sx in ((dy, dx), (-dy, -dx)):
                other = normal[1 + sy : height - 1 + sy, 1 + sx : width - 1 + sx]
                inside &= (other * normal[1:-1, 1:-1]).sum(axis=-1) > cosine
    mask[1:-1, 1:-1] = inside
    return mask
