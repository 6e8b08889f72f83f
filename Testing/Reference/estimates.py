# SPDX-License-Identifier: BSD-3-Clause
"""Means and errors of independent batches of an image, and when to stop following bounces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Estimate:
    """An image (height, width, 3), its standard error, and batches' means over the receivers."""

    image: np.ndarray
    error: np.ndarray
    batch_means: np.ndarray

    def noise(self, valid: np.ndarray, of: np.ndarray | None = None) -> float:
        """Return the part of relMSE that the image's own noise makes.

        relMSE = mean((I - R)^2 / (R^2 + 0.01 mean(R)^2)) over receivers and colours; `of` is R
        where it is not this image.
        """
        reference = (self.image if of is None else of)[valid].astype(np.float64)
        floor = 0.01 * reference.mean() ** 2
        if floor == 0.0:
            return 0.0
        return float((self.error[valid].astype(np.float64) ** 2 / (reference**2 + floor)).mean())

    def rmse_over_mean(self, valid: np.ndarray) -> float:
        """Return the root mean square of the standard error over the receivers, by their mean."""
        mean = float(self.image[valid].mean())
        return float(np.sqrt((self.error[valid] ** 2).mean())) / mean if mean > 0.0 else 0.0

    def mean(self) -> np.ndarray:
        """Return the mean over the receivers, for each colour."""
        return self.batch_means.mean(axis=0)

    def error_of_mean(self) -> np.ndarray:
        """Return the standard error of `mean`."""
        count = len(self.batch_means)
        return self.batch_means.std(axis=0, ddof=1) / np.sqrt(count)

    def __add__(self, other: Estimate) -> Estimate:
        """Return the sum of two independent estimates."""
        shortest = min(len(self.batch_means), len(other.batch_means))
        return Estimate(
            self.image + other.image,
            np.hypot(self.error, other.error),
            self.batch_means[:shortest] + other.batch_means[:shortest],
        )


def combine(batches: list[np.ndarray], valid: np.ndarray) -> Estimate:
    """Return mean and standard error of at least two independent images of the same thing."""
    stack = np.stack(batches).astype(np.float64)
    error = stack.std(axis=0, ddof=1) / np.sqrt(len(stack))
    return Estimate(stack.mean(axis=0), error, stack[:, valid].mean(axis=1))


def tail(means: np.ndarray, depth: int) -> float:
    """Return what bounces beyond `depth` add, as a fraction of all bounces.

    `means`: light by bounce 1, 2, ... Beyond the last one that is known each bounce is thought to
    hold the same part of the one before, at most 0.99, taken from the last half of those known: of
    two pairs at least, because light between two surfaces comes in turns.
    """
    total = float(means.sum())
    if total <= 0.0 or len(means) < 2:
        return 0.0
    span = max(min(2, len(means) // 2), len(means) // 4)
    recent, earlier = float(means[-span:].sum()), float(means[-2 * span : -span].sum())
    ratio = min(0.99, (recent / earlier) ** (1.0 / span)) if earlier > 0.0 else 0.0
    beyond = float(means[-1]) * ratio / (1.0 - ratio)
    return (float(means[depth:].sum()) + beyond) / (total + beyond)


def depth_for(means: np.ndarray, allowed: float) -> int:
    """Return the number of bounces beyond which at most the fraction `allowed` is left out.

    It is the number of `means` when even that leaves more out.
    """
    for depth in range(2, len(means)):
        if tail(means, depth) <= allowed:
            return depth
    return len(means)
