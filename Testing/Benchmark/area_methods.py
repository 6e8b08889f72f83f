#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Methods of area lights: error against a path tracer, and time of all processors.

    Testing/Benchmark/area_methods.py [SCENE ...]

Prints a table for Documentation/methods/area-lights.md. Errors are those of the irradiance to A3,
all bounces of all light. First: the first picture; all: frames until a still picture is complete.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import vtkindirect
from vtkindirect import frames, images, methods, references

SCENES = Path(__file__).resolve().parents[1] / "Scenes"
STORED = SCENES.parent / "Reference" / "data"
NAMES = ("area_cornell", "area_machine", "area_apartment")
FRAMES = 40
METHODS = {
    "closed form": ("AUTOMATIC", "auto", "robust"),
    "virtual lights": ("VIRTUAL_LIGHTS", "auto", "robust"),
    "multiresolution splatting, preset `paper`": ("AUTOMATIC", "multiresolution", "paper"),
}


def measure(name: str, label: str) -> str:
    """Return a row of the table."""
    choice, method, preset = METHODS[label]
    scene = vtkindirect.load_scene(SCENES / f"{name}.json")
    stored = STORED / f"{name}.exr"
    size = references.natural_size(stored)
    window = frames.open_window(scene, size)
    found, _missing = references.stored_images(stored, size, references.names_of(scene))
    for light in scene.area_lights:
        light.SetMethod(getattr(type(light), choice))
    indirect = methods.enable(scene.renderer, method, lighting="scene", preset=preset)
    start = time.process_time()
    window.Render()
    first = time.process_time() - start
    for _ in range(FRAMES):
        window.Render()
        if frames.tiles_left(indirect) == 0:
            break
    everything = time.process_time() - start
    judge = references.References(references.mask(scene), found)
    seen = {buffer: images.copy_buffer(scene.renderer, buffer) for buffer in judge.buffers()}
    error = judge.errors(seen)["A3"]
    methods.disable(scene.renderer)
    window.Finalize()
    return (
        f"| {name} | {label} | {error.relmse:.4f} | {error.bias:+.3f} | {first:.1f} | "
        f"{everything:.1f} |"
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=str(__doc__).split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", default=NAMES)
    print("| scene | area lights by | relMSE A3 | bias A3 | first, s | all, s |")
    print("|---|---|---:|---:|---:|---:|")
    for name in parser.parse_args(arguments).scenes:
        for label in METHODS:
            print(measure(name, label), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
