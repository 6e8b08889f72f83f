# SPDX-License-Identifier: BSD-3-Clause
"""A window on the screen, in VTK's own event loop, until its picture is finished after a drag.

Prints a row for each frame: the window's update rate, the report's batches_left, and the mean of the
irradiance. Arguments: settings of the pass, as NAME=VALUE.
"""

import sys

import support  # noqa: F401
import vtkmodules.vtkInteractionStyle  # noqa: F401
from rooms import make_actor, make_ball, make_room
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor

import vtkindirect

INTERACTIVE = 1.0
"""Frames a second that tell frames in motion from still ones: VTK's interactors ask for 15."""


def main() -> None:
    renderer = make_room(make_actor(make_ball()))
    given = dict(argument.split("=") for argument in sys.argv[1:])
    vtkindirect.enable(renderer, lighting="scene", **{k: float(v) for k, v in given.items()})
    window = vtkRenderWindow()
    window.SetSize(160, 120)
    window.AddRenderer(renderer)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    rates: list[float] = []

    def end_frame(*_: object) -> None:
        left = vtkindirect.report(renderer)["counters"]["batches_left"]
        rates.append(window.GetDesiredUpdateRate())
        print(rates[-1], left, vtkindirect.copy_buffer(renderer, "irradiance").mean(), flush=True)
        if left == 0 and rates[-1] < INTERACTIVE <= max(rates):
            interactor.TerminateApp()

    window.AddObserver("EndEvent", end_frame)
    window.Render()
    interactor.Start()


if __name__ == "__main__":
    main()
