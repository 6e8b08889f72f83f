# SPDX-License-Identifier: BSD-3-Clause
"""Changes of places, parts and levels of detail."""

from rooms import RED, make_actor, make_ball, make_mapper
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import (
    vtkAssembly,
    vtkLODProp3D,
    vtkPropAssembly,
    vtkProperty,
    vtkTexture,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor

from .parts import BLUE, change, change_alone, make_image, make_sheet, paint


@change_alone
def level_property():
    prop = vtkLODProp3D()
    look = vtkProperty()
    look.SetColor(*RED)
    prop.AddLOD(make_mapper(make_ball()), look, 0.0)
    return prop, lambda: look.SetColor(*BLUE)


@change_alone
def level_source():
    prop = vtkLODProp3D()
    ball = make_ball()
    look = vtkProperty()
    look.SetColor(*RED)
    prop.AddLOD(make_mapper(ball), look, 0.0)
    return prop, lambda: ball.SetRadius(0.2)


@change_alone
def level_actor_property():
    prop = vtkLODActor()
    prop.SetMapper(make_mapper(make_ball()))
    prop.GetProperty().SetColor(*RED)
    return prop, lambda: prop.GetProperty().SetColor(*BLUE)


@change_alone
def part_property():
    prop = vtkAssembly()
    part = make_actor(make_ball())
    prop.AddPart(part)
    return prop, lambda: part.GetProperty().SetColor(*BLUE)


@change_alone
def part_removed():
    prop = vtkAssembly()
    prop.AddPart(make_actor(make_ball(0.2)))
    part = make_actor(make_ball())
    prop.AddPart(part)
    return prop, lambda: prop.RemovePart(part)


@change_alone
def user_transform():
    prop = make_actor(make_ball(0.2))
    transform = vtkTransform()
    prop.SetUserTransform(transform)
    return prop, lambda: transform.Translate(0.4, 0, 0)


@change_alone
def user_matrix():
    prop = make_actor(make_ball(0.2))
    matrix = vtkMatrix4x4()
    prop.SetUserMatrix(matrix)
    return prop, lambda: matrix.SetElement(0, 3, 0.4)


@change_alone
def hidden():
    prop = make_actor(make_ball())
    return prop, lambda: prop.VisibilityOff()


@change
def user_transform_input():
    prop = make_actor(make_ball(0.2))
    inner = vtkTransform()
    transform = vtkTransform()
    transform.SetInput(inner)
    prop.SetUserTransform(transform)
    return prop, lambda: inner.Translate(0.4, 0, 0)


@change
def user_matrix_removed():
    prop, _ = user_matrix()
    prop.GetUserMatrix().SetElement(0, 3, 0.4)
    return prop, lambda: prop.SetUserMatrix(None)


def make_group(kind):
    """Return an assembly of a small ball, and the ball."""
    prop = kind()
    part = make_actor(make_ball(0.2))
    prop.AddPart(part)
    return prop, part


@change
def assembly_moved():
    prop, _ = make_group(vtkAssembly)
    return prop, lambda: prop.SetPosition(0.4, 0, 0)


@change
def part_moved():
    prop, part = make_group(vtkAssembly)
    return prop, lambda: part.SetPosition(0.4, 0, 0)


@change
def part_of_a_part_moved():
    prop = vtkAssembly()
    inner, _ = make_group(vtkAssembly)
    prop.AddPart(inner)
    return prop, lambda: inner.SetPosition(0.4, 0, 0)


@change
def part_of_a_group_moved():
    prop, part = make_group(vtkPropAssembly)
    return prop, lambda: part.SetPosition(0.4, 0, 0)


@change
def level_texture():
    prop = vtkLODProp3D()
    image = make_image(RED)
    texture = vtkTexture()
    texture.SetInputData(image)
    prop.AddLOD(make_mapper(make_sheet()), vtkProperty(), texture, 0.0)
    return prop, lambda: paint(image, BLUE)


def make_levels():
    """Return a prop with two levels of which the first is drawn, and their numbers."""
    prop = vtkLODProp3D()
    prop.AutomaticLODSelectionOff()
    look = vtkProperty()
    look.SetColor(*RED)
    numbers = [prop.AddLOD(make_mapper(make_ball(size)), look, 0.0) for size in (0.4, 0.2)]
    prop.SetSelectedLODID(numbers[0])
    return prop, numbers


@change
def level_selected():
    prop, numbers = make_levels()
    return prop, lambda: prop.SetSelectedLODID(numbers[1])


@change
def level_removed():
    prop, numbers = make_levels()

    def remove() -> None:
        prop.RemoveLOD(numbers[0])
        prop.SetSelectedLODID(numbers[1])

    return prop, remove
