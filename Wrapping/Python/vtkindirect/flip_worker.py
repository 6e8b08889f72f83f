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


def _load(path: str) -> Any:
    spec = importlib.util.spec_from_file_location("vtkindirect_metrics", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


def main() -> int:
    """Answer until standard input ends; returns the exit code."""
    metrics = _load(sys.argv[1])
    import flip_evaluator  # noqa: F401  fails now and not at the first image

    print(f"flip-evaluator {version('flip-evaluator')}", flush=True)
    for line in sys.stdin:
        with np.load(line.strip()) as arrays:
            found = dict(arrays)
        try:
            answer = repr(metrics.flip(found["image"], found["reference"], found["mask"]))
        except metrics.MetricError as error:
            answer = f"error: {error}"
        print(answer, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
