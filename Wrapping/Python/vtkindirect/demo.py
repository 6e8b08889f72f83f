# SPDX-License-Identifier: BSD-3-Clause
"""The demonstration: real data in plain VTK and with indirect light, side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkTextActor

from vtkindirect import frames, images, methods, wrapped
from vtkindirect.frames import Job
from vtkindirect.scene import Scene

FRAMES = 3
MULTISAMPLES = 8
"""Samples that a vtkRenderWindow asks for by default."""
_GAP = 4


def caption(scene: Scene, text: str) -> vtkTextActor:
    """Return a caption in the lower left corner; its size goes with the picture's."""
    actor = vtkTextActor()
    actor.SetInput(text)
    look = actor.GetTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(max(10, scene.size[1] // 26))
    look.SetColor(1.0, 1.0, 1.0)
    look.SetBackgroundColor(0.0, 0.0, 0.0)
    look.SetBackgroundOpacity(0.6)
    actor.SetPosition(8, 8)
    return actor


def _captioned(scene: Scene, window: Any, text: str) -> np.ndarray:
    """Return the picture with a caption, which no measured frame has."""
    shown = caption(scene, text)
    scene.renderer.AddViewProp(shown)
    window.Render()
    picture = images.window_bytes(window)
    scene.renderer.RemoveViewProp(shown)
    return picture


def summary(report: dict[str, Any]) -> str:
    """Return one line about what the pass did."""
    parts = [f"method {report.get('method', 'auto')}"]
    if report.get("virtual_lights"):
        parts.append(f"{report['virtual_lights']} virtual lights")
    if isinstance(report.get("indirect_ms"), (int, float)):
        parts.append(f"indirect {report['indirect_ms']:.0f} ms")
    if isinstance(report.get("estimated_error"), (int, float)):
        parts.append(f"estimated error {100 * report['estimated_error']:.1f} %")
    if isinstance(report.get("bytes"), (int, float)):
        parts.append(f"{report['bytes'] / 1e6:.0f} MB of graphics memory")
    left_out = [item["what"] for item in report.get("left_out", []) if "what" in item]
    if left_out:
        parts.append("left out: " + ", ".join(left_out))
    return ", ".join(parts)


def run(
    scene: Scene,
    directory: Path,
    size: tuple[int, int] | None,
    step: frames.Step = frames.no_step,
    lighting: str | None = None,
) -> str:
    """Render a scene twice and write its files; returns the line that tells of them.

    The left half of the picture is plain VTK's, with the multisampling that windows have by
    default. The times are those of VTK without the pass, and of the pass while the camera turns.
    """
    scene.size = size or scene.size
    window = frames.open_window(scene, scene.size)
    off = frames.render(scene, window, Job(method="off", frames=FRAMES), step)
    on = frames.render(scene, window, Job(frames=FRAMES, lighting=lighting), step)
    light = images.copy_buffer(scene.renderer, images.FINAL)
    right = _captioned(scene, window, "with indirect light")
    methods.disable(scene.renderer)
    window.Finalize()
    window = scene.make_window()
    window.SetMultiSamples(MULTISAMPLES)
    left = _captioned(scene, window, "plain VTK")
    window.Finalize()

    gap = np.full((left.shape[0], _GAP, 3), 255, dtype=np.uint8)
    directory.mkdir(exist_ok=True)
    written = [directory / f"{scene.name}.png"]
    images.write_png(written[0], np.hstack((left, gap, right)))
    if wrapped.has("vtkOpenEXRWriter"):
        written.append(directory / f"{scene.name}.exr")
        images.write_exr(written[1], light)
    return (
        f"{scene.name}: {' '.join(map(str, written))}; frame {off['wall_ms']['median_ms']:.0f} ms "
        f"without, {on['wall_ms']['median_ms']:.0f} ms with indirect light; {summary(on)}"
    )
