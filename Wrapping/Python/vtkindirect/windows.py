# SPDX-License-Identifier: BSD-3-Clause
"""Render windows: on a display when there is one, without one otherwise."""

from __future__ import annotations

import ctypes
import ctypes.util
import operator
import os
import reprlib
import sys
import warnings

import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from vtkindirect import messages, wrapped
from vtkindirect.errors import RenderError, UsageError

# The largest texture of common drivers; `check_size` asks the driver at hand for its own limit.
LARGEST = 16384


def has_display() -> bool:
    """Return whether a window can be shown. Opens and closes a connection to the X server."""
    if sys.platform in ("win32", "darwin"):
        return True
    if not os.environ.get("DISPLAY"):
        return False
    try:
        x11 = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.argtypes = [ctypes.c_char_p]
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = x11.XOpenDisplay(None)
    if not display:
        return False
    x11.XCloseDisplay(display)
    return True


def _headless() -> vtkRenderWindow | None:
    """Return a window that needs no display: VTK's own where it has one, else this project's."""
    if hasattr(opengl, "vtkEGLRenderWindow"):
        return opengl.vtkEGLRenderWindow()
    if wrapped.has("vtkEGLHeadlessRenderWindow"):
        return wrapped.get("vtkEGLHeadlessRenderWindow")()
    return None


def render_window(
    size: tuple[int, int] = (512, 512), offscreen: bool | None = None
) -> vtkRenderWindow:
    """Return a new render window without multisampling.

    `size`: width and height in pixels, from 1 to 16384, default 512 x 512. `offscreen`: None (the
    default) shows the window when there is a display and needs none otherwise; True never shows it;
    False raises when there is no display. Raises `RenderError` when no window can be had at all.
    """
    try:
        width, height = (operator.index(length) for length in size)
    except (TypeError, ValueError):
        raise UsageError(
            f"size must be a width and a height in pixels, not {reprlib.repr(size)}"
        ) from None
    if not (1 <= width <= LARGEST and 1 <= height <= LARGEST):
        raise UsageError(f"size {width}x{height}: must be from 1x1 to {LARGEST}x{LARGEST}")
    display = False if offscreen is True else has_display()
    if offscreen is False and not display:
        where = os.environ.get("DISPLAY")
        reason = f"cannot connect to DISPLAY '{where}'" if where else "DISPLAY is not set"
        raise RenderError(f"there is no display to show a window on: {reason}")
    window = None if display else _headless()
    if window is None:
        if not (display or has_display()):
            raise RenderError(
                "there is no display and no way to render without one: "
                + (wrapped.explain("vtkEGLHeadlessRenderWindow") or "VTK has no EGL window")
            )
        window = vtkRenderWindow()
        window.SetOffScreenRendering(not display)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    return window


def use_headless(on: bool = True) -> None:
    """Make VTK's own windows render without a display, in the whole process.

    After it `vtkRenderWindow()` needs no display and `vtkRenderWindowInteractor().Start()` renders
    once and returns. Windows that exist already stay what they are.
    """
    factory = wrapped.get("vtkIndirectHeadlessFactory")
    if on:
        factory.Enable()
    else:
        factory.Disable()


def start(window: vtkRenderWindow) -> None:
    """Make the window's OpenGL context; raises `RenderError` when that fails.

    A RuntimeWarning tells, once in a process, of a graphics card that is there and does not render.
    """
    size = window.GetSize()
    with messages.capture() as said:
        if hasattr(window, "Initialize"):
            window.Initialize()
        works = window.SupportsOpenGL()
    if said.errors or not works:
        reason = said.first_error()
        if hasattr(window, "GetLastErrorMessage"):
            reason = window.GetLastErrorMessage() or reason
        raise RenderError(f"OpenGL does not work here: {reason or 'no context could be made'}")
    if said.warnings and hasattr(window, "GetLastWarningMessage"):
        text = window.GetLastWarningMessage()
        if text:
            warnings.warn(text, RuntimeWarning, stacklevel=2)
    if tuple(window.GetSize()) != tuple(size):
        window.SetSize(size)


def check_size(window: vtkRenderWindow, size: tuple[int, int]) -> None:
    """Raise `UsageError` when the driver has no textures of `size`. Needs a started window."""
    window.MakeCurrent()
    limit = opengl.vtkTextureObject.GetMaximumTextureSize(window)
    if limit > 0 and max(size) > limit:
        raise UsageError(
            f"size {size[0]}x{size[1]}: this OpenGL driver goes up to {limit}x{limit} pixels"
        )
