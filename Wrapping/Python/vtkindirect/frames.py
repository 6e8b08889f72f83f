# SPDX-License-Identifier: BSD-3-Clause
"""Renders the frames of a scene and says how long they took."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from vtkindirect import messages, methods, settings, windows
from vtkindirect.errors import RenderError
from vtkindirect.scene import Scene

REPORT_SCHEMA = "vtkindirect.report/1"
_TURN = 1e-6
"""Degrees that the camera turns from frame to frame while frames are timed."""
DELEGATE_ALONE = "the delegate alone"
"""What a report says to be modelled when the pass left the picture to VTK."""
NO_INDIRECT_LIGHT = "indirect light"
"""What a report says to be left out when there is only direct light."""


@dataclass
class Job:
    """What to render: a method, its settings and the number of frames to measure."""

    method: str = "auto"
    sampler: str | None = None
    settings: dict[str, Any] = field(default_factory=dict)
    frames: int = 1

    @property
    def all_frames(self) -> int:
        """The frames to render: one more to warm up when there is more than one to measure."""
        return self.frames + 1 if self.frames > 1 else 1


def percentile_95(values: list[float]) -> float:
    """Return the least of the values that at least 95 % of them do not exceed.

    That is what the reports of the passes mean by ``p95_ms``, too.
    """
    return sorted(values)[(95 * len(values) + 99) // 100 - 1]


def _gl_name(window: vtkRenderWindow) -> dict[str, str]:
    """Return the OpenGL renderer and version of a window."""
    found = {"renderer": "", "version": ""}
    for line in window.ReportCapabilities().splitlines():
        for key in found:
            if line.startswith(f"OpenGL {key} string:"):
                found[key] = line.partition(":")[2].strip()
    return found


def _timed_render(window: vtkRenderWindow) -> float:
    """Render a frame and wait until it is there; returns milliseconds."""
    window.WaitForCompletion()
    begin = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    return 1000.0 * (time.perf_counter() - begin)


def render(
    scene: Scene,
    window: vtkRenderWindow,
    job: Job,
    step: Callable[[str], None] = lambda _what: None,
) -> dict[str, Any]:
    """Render a scene in its window; returns the report, in the form ``vtkindirect.report/1``.

    `step` is called before each frame. An error that VTK reports while rendering, such as a shader
    that does not compile, is a `RenderError`. Several frames are those of a camera that turns in a
    scene that stands still, the first one, which makes all that is kept, apart (``first_ms``): it
    turns by so little that no pixel changes, and ends where it was.
    """
    indirect = methods.enable(scene.renderer, job.method, job.sampler, **job.settings)
    times: list[float] = []
    first: float | None = None
    camera = scene.renderer.GetActiveCamera()
    place, up = camera.GetPosition(), camera.GetViewUp()
    with messages.capture() as said:
        for frame in range(job.all_frames):
            warm_up = job.frames > 1 and frame == 0
            if indirect is not None:
                indirect.SetTiming(not warm_up)
            camera.SetPosition(place)
            camera.SetViewUp(up)
            left = job.all_frames - 1 - frame
            if left > 0:
                camera.Azimuth(_TURN * left)
            step("warming up" if warm_up else f"frame {len(times) + 1} of {job.frames}")
            elapsed = _timed_render(window)
            if warm_up:
                first = elapsed
            else:
                times.append(elapsed)
            if said.errors:
                raise RenderError(f"rendering failed: {said.first_error()}")
    median, p95 = statistics.median(times), percentile_95(times)
    if indirect is not None:
        result = methods.report(indirect)
        described = settings.describe(methods.parts(indirect))
        result["settings"] = {**described, **result.get("settings", {})}
    else:
        result = {
            "stages": {"delegate": {"median_ms": median, "p95_ms": p95}},
            "indirect_ms": 0.0,
            "frame_ms": median,
            "virtual_lights": 0,
            "modelled": [],
            "left_out": [{"what": "indirect light", "why": "method off"}],
            "gl": _gl_name(window),
            "vtk": vtkVersion.GetVTKVersion(),
            "settings": {},
        }
    result["schema"] = REPORT_SCHEMA
    result["scene"] = scene.name
    result["size"] = list(window.GetSize())
    result.setdefault("method", job.method)
    result.setdefault("frames", job.frames)
    result["wall_ms"] = {"median_ms": median, "p95_ms": p95}
    if first is not None:
        result["first_ms"] = first
    return result


def open_window(scene: Scene, size: tuple[int, int] | None) -> vtkRenderWindow:
    """Return a started window of a scene that is never shown."""
    size = size or scene.size
    window = windows.render_window((1, 1), offscreen=True)
    windows.start(window)
    windows.check_size(window, size)
    window.SetSize(size)
    scene.move_to(window)
    return window
