# SPDX-License-Identifier: BSD-3-Clause
"""Denoises images in the reference environment; a program of its own, run by that Python with -I.

Each line of standard input is a file of NumPy's with image (irradiance), normal and repeats. The
denoised image goes to FILE.denoised.npy, and the answer is one line: seconds, or a sentence that begins with
"error: ".
"""

from __future__ import annotations

import statistics
import sys
import time
from importlib.metadata import version

import numpy as np

LONG_ENOUGH = 2.0
"""Seconds after which an image is not denoised once more."""


def denoised(image: np.ndarray, normal: np.ndarray, repeats: int) -> tuple[np.ndarray, float]:
    """The image by Intel's Open Image Denoise, and the median of the seconds of `repeats` times.

    Fewer times are enough once they have taken `LONG_ENOUGH`.

    The albedo is divided out of the image, so that the auxiliary albedo is 1; normals have no noise.
    """
    import pyoidn

    colour = np.ascontiguousarray(np.maximum(image, 0.0), dtype=np.float32)
    guides = {
        "albedo": np.ones_like(colour),
        "normal": np.ascontiguousarray(normal, dtype=np.float32),
    }
    seconds = []
    for _ in range(repeats):
        before = time.perf_counter()
        found = pyoidn.denoise(colour, **guides, hdr=True, clean_aux=True)
        seconds.append(time.perf_counter() - before)
        if sum(seconds) >= LONG_ENOUGH:
            break
    return found, statistics.median(seconds)


def main() -> int:
    """Answer until standard input ends; returns the exit code."""
    import pyoidn  # noqa: F401  fails now and not at the first image

    print(f"pyoidn {version('pyoidn')}", flush=True)
    for line in sys.stdin:
        path = line.strip()
        with np.load(path) as arrays:
            found = dict(arrays)
        try:
            image, seconds = denoised(found["image"], found["normal"], int(found["repeats"]))
            np.save(f"{path}.denoised.npy", image)
            answer = repr(seconds)
        except (RuntimeError, TypeError, ValueError) as error:
            answer = f"error: {error}"
        print(answer, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
