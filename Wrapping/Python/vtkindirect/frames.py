# SPDX-License-Identifier: BSD-3-Clause
"""Renders the frames of a scene and says how long they took."""

from __future__ import annotations

import contextlib
import math
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderWindow

from vtkindirect import messages, methods, windows
from vtkindirect.errors import RenderError
from vtkindirect.scene import Scene

REPORT_SCHEMA = "vtkindirect.report/1"
DELEGATE_ALONE = "the delegate alone"
"""Entry of a report's `modelled` when the pass left the picture to VTK."""
NO_INDIRECT_LIGHT = "indirect light"
"""Entry of a report's `left_out` when there is only direct light."""

PACES = ("moving", "still", "standing")
"""Names for the camera's motion while frames are measured, and for the time of a frame.

moving: it turns around its focal point, at the rate that VTK asks for while somebody drags.
still: it turns likewise, and each frame is rendered as one of a camera that stands.
standing: it has turned and stands; the image is that of `STANDING_FRAMES` later.
In all of them what is kept between frames is there before any is measured, and the last frame has
the camera where the scene has it.
"""
INTERACTIVE_RATE, STILL_RATE = 15.0, 0.0001
"""Frames a second: vtkRenderWindowInteractor's DesiredUpdateRate and StillUpdateRate by default."""
TURN = 0.5
"""Degrees between frames of a camera that turns: a few pixels of a picture of usual size."""
TINY_TURN = 1e-6
"""The same of a camera that turns by so little that no pixel changes."""
WARM_UP_FRAMES = 8
"""Frames of a camera that stands before frames of one that turns are measured, at least."""
STANDING_FRAMES = 40
"""As many as two seconds have of frames of 50 ms. Frames are counted, not seconds, so that a busy
machine shows the same image."""
MOST_FILLING_FRAMES = 64
"""Frames to wait for depth maps, which arrive over several: of lights that turn with the camera
they never are all there."""

Step = Callable[..., None]
"""Called with what begins and, maybe, the number of steps that will follow at least."""


def no_step(_what: str, _left: int = 0) -> None:
    """Take the place of a bar."""


Filling = Callable[[], bool]
"""True if the last frame has drawn depth maps, so that there may be more to draw."""


@dataclass
class Job:
    """A method to render with, its settings and the number of frames to measure.

    `pace` is one of `PACES`, or None: the camera turns by so little that no pixel changes.
    `lighting` as `vtkindirect.enable` has it; None keeps what it does by itself. `words` are
    further ones of `enable`, such as ``environment``.
    """

    method: str = "auto"
    sampler: str | None = None
    settings: dict[str, Any] = field(default_factory=dict)
    frames: int = 1
    pace: str | None = None
    lighting: str | None = None
    words: dict[str, Any] = field(default_factory=dict)

    def enable(self, scene: Scene) -> Any:
        """Switch indirect light on in a scene, or off; returns the pass, or None."""
        values = {**self.settings, **self.words}
        if self.lighting is not None:
            values["lighting"] = self.lighting
        return methods.enable(scene.renderer, self.method, self.sampler, **values)

    @property
    def all_frames(self) -> int:
        """The frames to render, and at least one to warm up when more than one is measured."""
        return self.frames + 1 if self.frames > 1 else 1


def percentile_95(values: list[float]) -> float:
    """Return the least of the values that at least 95 % of them do not exceed.

    The reports of the passes mean the same by ``p95_ms``.
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


def timed_render(window: vtkRenderWindow) -> float:
    """Render a frame and wait until it is there; returns milliseconds."""
    window.WaitForCompletion()
    begin = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    return 1000.0 * (time.perf_counter() - begin)


def tiles_drawn(indirect: Any) -> int:
    """Return how many depth maps a pass has drawn so far; 0 without a pass."""
    return 0 if indirect is None else methods.counters(indirect)["tiles_drawn"]


def tiles_left(indirect: Any) -> int:
    """Return how many depth maps further frames will draw; 0 without a pass."""
    return 0 if indirect is None else methods.counters(indirect)["tiles_left"]


def batches_left(indirect: Any) -> int:
    """Return how many frames will refine a still picture; 0 without a pass."""
    return 0 if indirect is None else methods.counters(indirect)["batches_left"]


def _never() -> bool:
    return False


def _stand(least: int, filling: Filling = _never) -> Iterator[None]:
    """Yield before each of so many frames of a camera that stands.

    Until there are `MOST_FILLING_FRAMES` it goes on while frames draw depth maps.
    """
    count = 0
    while count < least or (count < MOST_FILLING_FRAMES and filling()):
        yield
        count += 1


def fill(passes: list[Any], step: Step = no_step) -> Iterator[None]:
    """Yield before each frame that draws missing depth maps, or refines a still picture.

    The passes are those of `maps_first`; the last frame has light, whatever is missing still.
    """
    count = before = 0
    while count < MOST_FILLING_FRAMES and any(tiles_left(indirect) > 0 for indirect in passes):
        count += 1
        if count == MOST_FILLING_FRAMES:
            for indirect in passes:
                indirect.MapsFirstOff()
        left, now = sum(map(tiles_left, passes)), sum(map(tiles_drawn, passes))
        step(f"{left} depth maps to draw", math.ceil(left / max(now - before, 1)) - 1)
        before = now
        yield
    # A time budget may begin anew with more batches.
    left, before = max(map(batches_left, passes), default=0), 0
    while left not in (0, before):
        step(f"{left} batches of lights to sum", left - 1)
        yield
        left, before = max(map(batches_left, passes), default=0), left


def _steps(
    scene: Scene, window: vtkRenderWindow, job: Job, filling: Filling, least: int = 1
) -> Iterator[bool]:
    """Yield before each frame whether it is one to warm up; the camera is then where it should be.

    A camera with a pace stands for `least` frames first. Camera and rate are as they were afterwards.
    """
    camera, rate = scene.renderer.GetActiveCamera(), window.GetDesiredUpdateRate()
    before = vtkCamera()
    before.DeepCopy(camera)

    def turn(steps: int) -> None:
        camera.DeepCopy(before)
        camera.Modified()  # a copy alone leaves VTK drawing with the matrices that it has
        if steps:
            camera.Azimuth((TINY_TURN if job.pace is None else TURN) * steps)
            camera.OrthogonalizeViewUp()

    try:
        if job.pace is not None:
            turn(job.frames + 1)
            window.SetDesiredUpdateRate(STILL_RATE)
            for _ in _stand(least, filling):
                yield True
            turn(job.frames)
            window.SetDesiredUpdateRate(STILL_RATE if job.pace == "still" else INTERACTIVE_RATE)
            yield True
        elif job.frames > 1:
            turn(job.frames)
            for _ in _stand(least, filling):
                yield True
        if job.pace == "standing":
            turn(0)
            window.SetDesiredUpdateRate(STILL_RATE)
            for _ in _stand(STANDING_FRAMES):
                yield False
        else:
            for left in reversed(range(job.frames)):
                turn(left)
                yield False
    finally:
        turn(0)
        window.SetDesiredUpdateRate(rate)


@contextlib.contextmanager
def maps_first(passes: list[Any]) -> Iterator[None]:
    """Let light wait for its depth maps, and give the passes their own setting back."""
    before = [indirect.GetMapsFirst() for indirect in passes]
    for indirect in passes:
        indirect.MapsFirstOn()
    try:
        yield
    finally:
        for indirect, value in zip(passes, before):
            indirect.SetMapsFirst(value)


def moving(scene: Scene, window: vtkRenderWindow, count: int) -> float:
    """Return the median milliseconds of frames of a camera that turns, by the pass that is on.

    All that the pass keeps is there already. Camera and rate are as they were afterwards.
    """
    times = []
    with messages.capture() as said:
        for warm_up in _steps(scene, window, Job(frames=count, pace="moving"), _never):
            elapsed = timed_render(window)
            if not warm_up:
                times.append(elapsed)
        if said.errors:
            raise RenderError(f"rendering failed: {said.first_error()}")
    return statistics.median(times)


def render(
    scene: Scene,
    window: vtkRenderWindow,
    job: Job,
    step: Step = no_step,
) -> dict[str, Any]:
    """Render a scene in its window; returns the report, in the form ``vtkindirect.report/1``.

    `step` is called before each frame, with what it is and how many will follow at least. An error
    that VTK reports while rendering, such as a shader that does not compile, is a `RenderError`.
    Several frames are those of a camera that turns in a
    scene that stands still, by so little that no pixel changes, and ends where it was. ``wall_ms``
    is the time of a frame, ``processor_ms`` the processor time that all threads of this process
    spend meanwhile: those of a renderer that draws on the processor among them. The frames that
    make what is kept are apart (``first_ms``, ``warm_up_frames``): depth maps are all there before
    a frame is measured, where `MOST_FILLING_FRAMES` suffice for them. A single frame is rendered
    again until then, with light in the last of them (``MapsFirst``), and ``wall_ms`` is the time of
    all of it.
    """
    indirect = job.enable(scene)
    times: list[float] = []
    processor: list[float] = []
    first: float | None = None
    warm_up_frames = tiles = new_tiles = 0
    keeps = indirect is not None and indirect.GetCaching()
    # A single frame is a picture to look at: its time is that until no depth map is missing.
    fills = keeps and job.frames == 1 and job.pace is None
    least = {None: 1, "standing": STANDING_FRAMES}.get(job.pace, WARM_UP_FRAMES)
    steps = _steps(scene, window, job, lambda: keeps and new_tiles > 0, least)
    waiting = maps_first([indirect] if fills else [])
    with contextlib.closing(steps), waiting, messages.capture() as said:
        for warm_up in steps:
            if indirect is not None:
                indirect.SetTiming(not warm_up)
            step("warming up" if warm_up else f"frame {len(times) + 1} of {job.frames}")
            spent = time.process_time()
            elapsed = timed_render(window)
            spent = 1000.0 * (time.process_time() - spent)
            first = elapsed if first is None else first
            if warm_up:
                warm_up_frames += 1
                drawn = tiles_drawn(indirect)
                tiles, new_tiles = drawn, drawn - tiles
            else:
                times.append(elapsed)
                processor.append(spent)
            if said.errors:
                raise RenderError(f"rendering failed: {said.first_error()}")
        for _ in fill([indirect], step) if fills else ():
            spent = time.process_time()
            times[0] += timed_render(window)
            processor[0] += 1000.0 * (time.process_time() - spent)
            if said.errors:
                raise RenderError(f"rendering failed: {said.first_error()}")
    median, p95 = statistics.median(times), percentile_95(times)
    if indirect is not None:
        result = methods.report(indirect)
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
    result["processor_ms"] = {
        "median_ms": statistics.median(processor),
        "p95_ms": percentile_95(processor),
    }
    if job.frames > 1:
        result["first_ms"], result["warm_up_frames"] = first, warm_up_frames
    if job.pace is not None:
        result["frames"], result["pace"] = len(times), job.pace
    return result


def open_window(scene: Scene, size: tuple[int, int] | None) -> vtkRenderWindow:
    """Return a started window of a scene that is never shown."""
    size = size or scene.size
    scene.fit(size)
    window = windows.render_window((1, 1), offscreen=True)
    windows.start(window)
    windows.check_size(window, size)
    window.SetSize(size)
    scene.move_to(window)
    return window
