# SPDX-License-Identifier: BSD-3-Clause
"""Compares references that the default method makes with stored path-traced ones.

    check_refined.py [SCENE...]

Prints a row for each reference of a scene in Testing/Scenes: the RMS difference over the mean, the
estimate of it, the root of the relMSE (best 99 %), that of the noise of path tracing alone, the bias
and the seconds. It needs the build's Python package on PYTHONPATH.
"""

from __future__ import annotations

import json
import math
import sys
import time
from pathlib import Path

from vtkindirect import frames, load_scene, metrics, references

ROOT = Path(__file__).resolve().parents[1]


def check(name: str) -> None:
    """Print the rows of a scene."""
    scene = load_scene(ROOT / "Scenes" / f"{name}.json")
    stored = ROOT / "Reference" / "data" / f"{name}.exr"
    record = json.loads(stored.with_suffix(".json").read_text(encoding="utf-8"))
    window = frames.open_window(scene, references.natural_size(stored))
    began = time.monotonic()
    found, estimated = references.refined(scene)
    seconds = time.monotonic() - began
    receivers, _normal = references.eye(scene)
    centre = slice(references.FACTOR // 2, None, references.FACTOR)
    for layer, image in found.items():
        errors = metrics.compare(image, references.read_layer(stored, layer), receivers[centre, centre])
        noise = math.sqrt(record[layer]["noise_relmse"])
        root = math.sqrt(errors.relmse_trimmed)
        print(
            f"| {name} | {layer} | {errors.nrmse:.4f} | {estimated[layer]:.4f} | {root:.3f} |"
            f" {noise:.3f} | {errors.bias:+.4f} | {seconds:.0f} |",
            flush=True,
        )
    window.Finalize()


if __name__ == "__main__":
    for scene_name in sys.argv[1:]:
        check(scene_name)
