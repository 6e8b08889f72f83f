# SPDX-License-Identifier: BSD-3-Clause
"""The interactive window of a scene."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

from vtkindirect import messages, methods
from vtkindirect.errors import RenderError
from vtkindirect.frames import Job
from vtkindirect.scene import Scene

KEYS = "i: indirect light on or off; r: reset the camera; q: quit"


def view(scene: Scene, job: Job, lit: bool = True, size: tuple[int, int] | None = None) -> None:
    """Show a scene until its window is closed. The mouse turns, moves and zooms it.

    `job` is what the key switches on, and `lit` whether it is on from the beginning.
    """
    window = scene.make_window(size, offscreen=False)
    if lit:
        job.enable(scene)
    interactor = vtkRenderWindowInteractor()
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.SetRenderWindow(window)

    def title() -> None:
        state = "with" if methods.pass_of(scene.renderer) else "without"
        window.SetWindowName(f"{scene.name} {state} indirect light ({KEYS})")

    def on_key(caller: Any, _event: str) -> None:
        if caller.GetKeySym() != "i":
            return
        if methods.pass_of(scene.renderer):
            methods.disable(scene.renderer)
        else:
            job.enable(scene)
        title()
        window.Render()

    interactor.AddObserver("KeyPressEvent", on_key)
    interactor.Initialize()
    with messages.capture() as said:
        window.Render()
    if said.errors:
        raise RenderError(f"rendering failed: {said.first_error()}")
    title()
    interactor.Start()
