# SPDX-License-Identifier: BSD-3-Clause
"""Finished pictures of what `enable` takes: with all depth maps, at any size, with transparency."""

from __future__ import annotations

import contextlib
import os
import reprlib
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from vtkindirect import frames, images, messages, methods, windows
from vtkindirect.errors import RenderError, UsageError

FORMATS = (".png", ".jpg", ".jpeg")

_WITHOUT_DISPLAY = ("vtkEGLHeadlessRenderWindow", "vtkEGLRenderWindow", "vtkOSOpenGLRenderWindow")


def _check(path: Any, scale: Any, transparent: Any) -> Any:
    """Return the path to write, or None; raises `UsageError` before anything is drawn."""
    whole = hasattr(scale, "__index__") and not isinstance(scale, bool)
    if not whole or int(scale) < 1:
        raise UsageError(f"scale must be a whole number from 1 on, not {reprlib.repr(scale)}")
    if not isinstance(transparent, (bool, np.bool_)):
        raise UsageError(f"transparent must be True or False, not {reprlib.repr(transparent)}")
    if path is None:
        return None
    if not isinstance(path, (str, os.PathLike)):
        raise UsageError(f"path must be the path of a file or None, not {reprlib.repr(path)}")
    found = images.check_output(path, FORMATS)
    if transparent and images.ending(found, FORMATS) != ".png":
        raise UsageError(f"{path}: JPEG has no transparency, the file name must end in .png")
    return found


def _place_cameras(plotter: Any) -> None:
    """Place the cameras of a PyVista plotter that was not shown yet, as `show` does."""
    for renderer in getattr(plotter, "renderers", ()):
        camera = getattr(renderer, "camera", None)
        if hasattr(camera, "is_set") and not camera.is_set:
            renderer.camera_position = renderer.get_default_cam_pos()
            renderer.ResetCamera()
            camera.is_set = True


@contextlib.contextmanager
def _window_of(target: Any) -> Iterator[vtkRenderWindow]:
    """Give the window that shows a target; a renderer without one is in a hidden one meanwhile."""
    if isinstance(target, vtkRenderWindow):
        yield target
        return
    (renderer,) = methods.renderers_of(target)
    _place_cameras(target)
    window = renderer.GetRenderWindow() or getattr(target, "render_window", None)
    if window is not None:
        yield window
    elif hasattr(target, "make_window"):  # a Scene, which keeps it
        yield target.make_window()
    else:
        window = windows.render_window(offscreen=True)
        window.AddRenderer(renderer)
        try:
            yield window
        finally:
            window.RemoveRenderer(renderer)
            window.Finalize()


@contextlib.contextmanager
def _hidden(window: vtkRenderWindow) -> Iterator[bool]:
    """Keep a window that was never drawn from appearing; gives whether the window is hidden."""
    without = any(window.IsA(name) for name in _WITHOUT_DISPLAY)
    if without or window.GetOffScreenRendering() or not window.GetShowWindow():
        yield True
        return
    if not windows.has_display() and window.IsA("vtkXOpenGLRenderWindow"):
        raise RenderError(
            "there is no display for the window to draw in: call vtkindirect.use_headless() "
            "before the window is made"
        )
    if not (window.GetNeverRendered() and window.IsA("vtkXOpenGLRenderWindow")):
        yield False
        return
    window.SetOffScreenRendering(True)
    try:
        yield True
    finally:
        window.Finalize()  # the next frame makes one that is shown
        window.SetOffScreenRendering(False)


@contextlib.contextmanager
def _resized(window: vtkRenderWindow, scale: int) -> Iterator[None]:
    """Make a window larger for a picture."""
    before = tuple(window.GetSize())
    if scale == 1:
        yield
        return
    wanted = (before[0] * scale, before[1] * scale)
    windows.start(window)
    windows.check_size(window, wanted)
    window.SetSize(wanted)
    try:
        yield
    finally:
        window.SetSize(before)


@contextlib.contextmanager
def _before(renderers: list[vtkRenderer], grey: float) -> Iterator[None]:
    """Give renderers a plain background."""
    names = ("Background", "GradientBackground", "TexturedBackground")
    before = [[(name, getattr(one, f"Get{name}")()) for name in names] for one in renderers]
    try:
        for renderer in renderers:
            for name, value in zip(names, ((grey, grey, grey), False, False)):
                getattr(renderer, f"Set{name}")(value)
        yield
    finally:
        for renderer, values in zip(renderers, before):
            for name, value in values:
                getattr(renderer, f"Set{name}")(value)


@contextlib.contextmanager
def _at_rest(window: vtkRenderWindow) -> Iterator[None]:
    """Ask for frames of a window that stands still."""
    before = window.GetDesiredUpdateRate()
    window.SetDesiredUpdateRate(frames.STILL_RATE)
    try:
        yield
    finally:
        window.SetDesiredUpdateRate(before)


def _pixels(window: vtkRenderWindow, scale: int) -> np.ndarray:
    """Return what a window shows; where it is scaled VTK draws it again, in parts."""
    if scale == 1:
        return images.window_bytes(window)
    tiled = vtkWindowToImageFilter()
    tiled.SetInput(window)
    tiled.SetScale(scale)
    tiled.ReadFrontBufferOff()
    tiled.Update()
    return images.as_array(tiled.GetOutput())


def _with_alpha(black: np.ndarray, white: np.ndarray) -> np.ndarray:
    """Return colours and alpha, of the same picture before black and before white.

    VTK's own alpha of translucent props is too low.
    """
    shown = (white.astype(np.float32) - black).mean(axis=2, keepdims=True) / 255.0
    alpha = np.clip(1.0 - shown, 0.0, 1.0)
    colors = np.clip(black / np.maximum(alpha, 1.0 / 255.0), 0.0, 255.0)
    return np.rint(np.dstack([colors, 255.0 * alpha])).astype(np.uint8)


def _bar(stack: contextlib.ExitStack) -> frames.Step:
    """Return what counts the frames on a terminal."""
    if not sys.stderr.isatty():
        return frames.no_step
    try:
        from vtkindirect.progress import Progress
    except ImportError:  # the picture does not need it
        return frames.no_step
    return stack.enter_context(Progress("screenshot", 1)).step


def screenshot(
    target: Any,
    path: str | os.PathLike[str] | None = None,
    scale: int = 1,
    transparent: bool = False,
) -> np.ndarray:
    """Return a finished picture: frames are drawn until no depth map is missing.

    `target` is what `enable` takes; indirect light may be on or off. It may be a PyVista plotter
    before `show`. The result is an array of height x width x 3 bytes, top row first, or x 4 with
    alpha where `transparent`: then the background covers nothing. `path` is a .png, .jpg or .jpeg
    file to write, too.

    `scale` is a whole number of times the window's size. A window that is not on a display is made
    that large meanwhile; VTK draws one that is in parts, in each of which edges are antialiased by
    themselves. Widths of lines and points, and texts of fixed size, stay as they are in pixels.

    An error that VTK reports while drawing is a `RenderError`. On a terminal, a bar shows progress
    where tqdm is installed.
    """
    written = _check(path, scale, transparent)
    with contextlib.ExitStack() as stack:
        window = stack.enter_context(_window_of(target))
        hidden = stack.enter_context(_hidden(window))
        renderers = list(methods.renderers_of(window))
        said = stack.enter_context(messages.capture())
        stack.enter_context(_at_rest(window))
        stack.enter_context(_resized(window, int(scale) if hidden else 1))
        step = _bar(stack)
        step("drawing")
        passes = [one for one in map(methods.pass_of, renderers) if one is not None]
        passes = [one for one in passes if one.GetCaching()]
        with frames.maps_first(passes):
            window.Render()
            for _ in frames.fill(passes, step):
                window.Render()
        if transparent:
            found = []
            for grey in (0.0, 1.0):
                with _before(renderers, grey):
                    window.Render()
                    found.append(_pixels(window, 1 if hidden else int(scale)))
            values = _with_alpha(*found)
        else:
            values = _pixels(window, 1 if hidden else int(scale))
        if said.errors:
            raise RenderError(f"rendering failed: {said.first_error()}")
    values = np.ascontiguousarray(values[::-1])
    if written is not None:
        images.write_bytes(written, values[::-1])
    return values
