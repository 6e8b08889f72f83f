# SPDX-License-Identifier: BSD-3-Clause
"""Computes HDR-FLIP in the reference environment; a program of its own, run by that Python with -I.

It knows neither VTK nor this package: metrics are loaded from the file that the command line names.
Each line of standard input is a file of NumPy's with image, reference and mask; the answer is one
line, a number or a sentence that begins with "error: ".
"""

from __future__ import annotations

import importlib.util
import sys
from importlib.metadata import version
from typing import Any

import numpy as np


PIXELS_PER_DEGREE = 67.0
"""Viewing condition of FLIP: a 0.7 m wide 4K monitor from 0.7 m."""


def _load(path: str) -> Any:
    spec = importlib.util.spec_from_file_location("vtkindirect_metrics", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


def flip(metrics: Any, image: np.ndarray, reference: np.ndarray, mask: np.ndarray) -> float:
    """HDR-FLIP: the difference that an eye sees when flipping between the two, from 0 to 1.

    Mean over the pixels that count. Others are made equal to the reference, so that what lies
    behind a silhouette does not reach over it, and take no part in the choice of exposures.
    `metrics` is the package's module of that name.
    """
    import flip_evaluator

    counted, expected, _ = metrics.pair(image, reference, mask)
    if counted.shape[1] != 3:
        raise metrics.MetricError("HDR-FLIP needs three channels")
    shown = np.maximum(np.asarray(reference, dtype=np.float32), 0.0)
    test = shown.copy()
    test[mask] = np.maximum(counted, 0.0)

    def evaluate(first: np.ndarray, second: np.ndarray, **parameters: Any) -> Any:
        return flip_evaluator.evaluate(
            first,
            second,
            "HDR",
            applyMagma=False,
            parameters={"ppd": PIXELS_PER_DEGREE, **parameters},
        )

    # FLIP takes its exposures from the median and the largest luminance of the reference: with a
    # dark background the median would be that. It is asked about three pixels that have those of
    # the receivers.
    order = expected[np.argsort(expected @ (0.2126, 0.7152, 0.0722))].astype(np.float32)
    middle, brightest = order[len(order) // 2], order[-1]
    few = np.stack([middle, middle, brightest])[np.newaxis]
    chosen = evaluate(few, few)[2]
    names = ("startExposure", "stopExposure", "numExposures")
    errors = evaluate(shown, test, **{name: chosen[name] for name in names})[0]
    return float(np.asarray(errors)[..., 0][mask].mean(dtype=np.float64))


def main() -> int:
    """Answer until standard input ends; returns the exit code."""
    metrics = _load(sys.argv[1])
    import flip_evaluator  # noqa: F401  fails now and not at the first image

    print(f"flip-evaluator {version('flip-evaluator')}", flush=True)
    for line in sys.stdin:
        with np.load(line.strip()) as arrays:
            found = dict(arrays)
        try:
            answer = repr(flip(metrics, found["image"], found["reference"], found["mask"]))
        except metrics.MetricError as error:
            answer = f"error: {error}"
        print(answer, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
