# SPDX-License-Identifier: BSD-3-Clause
"""Changes, in place, of all that VTK reads while it draws a prop.

Each function of CHANGES returns a prop and a function that changes the prop; `together` makes
several of them at once.
"""

from vtkmodules.vtkRenderingCore import vtkProp3D

from . import looks, mappers, meshes, props  # noqa: F401, to fill the list
from .looks import fill, make_canvas
from .parts import ALONE, BLUE, CHANGES, make_image, make_sheet, paint


def together(names):
    """Return the props of changes, at half their size beside each other, and what changes all."""
    props, turns = [], []
    for number, name in enumerate(names):
        prop, turn = CHANGES[name]()
        if len(names) > 1 and isinstance(prop, vtkProp3D):
            prop.SetScale(0.5)
            prop.AddPosition((-0.5, 0.5)[number % 2], (0, 0.6)[number // 2], 0)
        props.append(prop)
        turns.append(turn)

    def turn_all() -> None:
        for turn in turns:
            turn()

    return props, turn_all
