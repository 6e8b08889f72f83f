# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: what a scene file says, checked and turned into a renderer.

A scene file is one JSON object of the format ``vtkindirect.scene/1``. A data file is a scene too:
its surface on white, seen from a side that shows it, in colours of its values, lit by VTK's light
kit.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkDataSet, vtkImageData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
)

from vtkindirect import (
    actors,
    area_lights,
    arrays,
    bodies,
    data,
    document,
    environments,
    labels,
    lights,
    looks,
    names,
    objects,
    pipeline,
    schema,
    views,
    voxels,
    windows,
)
from vtkindirect.errors import SceneError, UsageError, check_text
from vtkindirect.looks import Look

SCHEMA = "vtkindirect.scene/1"


def check(value: Any) -> dict[str, Any]:
    """Check the JSON value of a whole scene; returns it with defaults filled in."""
    if not isinstance(value, dict):
        raise SceneError("not a scene: the file must hold one JSON object")
    if "schema" not in value:
        raise SceneError(f'schema: is missing; a scene file begins with "schema": "{SCHEMA}"')
    return schema.check(value)


class Scene:
    """A scene that is ready to be shown: a renderer with camera, lights and actors.

    Attributes: `name`; `path` of the file; `size` in pixels (width, height); `renderer`; `actors`,
    the vtkActors by name (an actor without one is called "actor 0" by its place); `notes`, one line
    for each thing that was decided for the user; `rendering`, the file's "method", "sampler" and
    "settings", which `enable` takes where a call names no method; `up`, the name of the axis that
    points up in a data file, None in a scene file; `can_stand`, whether a data file shows a body
    that a ground suits (`vtkindirect.bodies`). `render_window` is None until `make_window`.
    """

    def __init__(self, name: str, path: Path, size: tuple[int, int]) -> None:
        self.name = name
        self.path = path
        self.size = size
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.actors: dict[str, vtkActor] = {}
        self.notes: list[str] = []
        self.rendering: dict[str, Any] = {}
        self.render_window: vtkRenderWindow | None = None
        self.up: str | None = None
        self.can_stand = False
        self._outline: tuple[np.ndarray, np.ndarray] | None = None
        self._placed = 0  # when the camera was, for data files

    @property
    def lights(self) -> list[vtkLight]:
        """The lights of the renderer."""
        found = self.renderer.GetLights()
        return [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]

    @property
    def environment(self) -> Any:
        """The light of the sky, a vtkEnvironmentLight that `enable` gives to the pass, or None."""
        return environments.attached(self.renderer)

    @property
    def area_lights(self) -> list[Any]:
        """The vtkAreaLights that `enable` gives to the pass."""
        return area_lights.attached(self.renderer)

    @property
    def bounds(self) -> tuple[float, ...]:
        """xmin, xmax, ymin, ymax, zmin, zmax of the visible actors, in scene units."""
        return self.renderer.ComputeVisiblePropBounds()

    def add_actor(self, name: str | None, actor: vtkActor, called: str = "") -> None:
        """Add an actor to the renderer under a name that is not taken.

        `called` is what reports call it, by default its name.
        """
        names.give(actor, called or name or "")
        name = name or f"actor {len(self.actors)}"
        while name in self.actors:
            name += "'"
        self.actors[name] = actor
        self.renderer.AddViewProp(actor)

    def view_data(self, outline: np.ndarray, up: str, view: Any = None) -> None:
        """Look at data from a side that shows them, or that a checked `view` names.

        `outline` are the points that lie farthest out.
        """
        self.up = up
        self._outline = outline, views.direction(outline, up, view)
        self._placed = self.renderer.GetActiveCamera().GetMTime()
        self.fit(self.size)

    def leave_room(self) -> None:
        """Leave room in the picture for shadows on a ground below what a data file shows."""
        if self._outline is not None and self.up is not None:
            points, toward = self._outline
            self._outline = views.with_ground(points, self.up), toward
            self.fit(self.size)

    def fit(self, size: tuple[int, int]) -> None:
        """Bring the camera as near as a picture of a size has room for what a data file shows.

        The camera of a scene file stays where the file has it, and one that somebody has moved
        since where it is.
        """
        camera = self.renderer.GetActiveCamera()
        if self._outline is None or self.up is None or camera.GetMTime() != self._placed:
            return
        outline, toward = self._outline
        views.place(camera, outline, toward, self.up, size[0] / size[1])
        self.renderer.ResetCameraClippingRange()
        self._placed = camera.GetMTime()

    def make_window(
        self, size: tuple[int, int] | None = None, offscreen: bool | None = True
    ) -> vtkRenderWindow:
        """Return a new window that shows the scene; see `vtkindirect.render_window`.

        `size` in pixels; default: that of the scene. `offscreen` is by default True: no window is
        shown even when there is a display. The scene leaves the window that it was in.
        """
        window = windows.render_window(size or self.size, offscreen=offscreen)
        self.fit(size or self.size)
        window.SetWindowName(self.name)
        self.move_to(window)
        return window

    def move_to(self, window: vtkRenderWindow) -> None:
        """Show the scene in a window, and no longer in the one before.

        A renderer's OpenGL objects belong to one window: VTK crashes when it is in two.
        """
        if self.render_window is not None:
            self.render_window.RemoveRenderer(self.renderer)
        window.AddRenderer(self.renderer)
        self.render_window = window


def _check_extent(scene: Scene) -> None:
    """Raise unless the visible actors extend in two directions at least."""
    low_high = scene.bounds
    lengths = sorted(low_high[2 * i + 1] - low_high[2 * i] for i in range(3))
    if not vtkBoundingBox.IsValid(low_high) or not lengths[1] > 1e-9 * lengths[2]:
        raise SceneError("actors: they have no area to show (all their points lie on a line)")


def _set_camera(camera: vtkCamera, values: dict[str, Any]) -> None:
    camera.SetPosition(values["position"])
    camera.SetFocalPoint(values["focal_point"])
    camera.SetViewUp(values["view_up"])
    if "parallel_scale" in values:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(values["parallel_scale"])
    else:
        camera.SetViewAngle(values.get("view_angle", 30.0))


def _from_document(path: Path, progress: Callable[[int, str], None]) -> Scene:
    values = check(document.read(path))
    scene = Scene(values.get("name", path.stem), path, tuple(map(int, values["size"])))
    scene.renderer.SetBackground(values["background"])
    scene.rendering = values.get("rendering", {})
    for index, light in enumerate(values["lights"]):
        lights.add(scene.renderer, light, f"lights[{index}]", path.parent)
    known: dict[Path, vtkDataSet] = {}

    def read(file: Path) -> vtkDataSet:
        place = Path(os.path.normpath(file))
        if place not in known:
            known[place] = data.read(file)
        return known[place]

    for index, actor in enumerate(values["actors"]):
        called = actor.get("name") or actors.what(actor)
        progress(len(values["actors"]), called)
        built = actors.build(actor, f"actors[{index}]", path.parent, read)
        scene.add_actor(actor.get("name"), built, called)
    _check_extent(scene)
    _set_camera(scene.renderer.GetActiveCamera(), values["camera"])
    if "clipping_range" in values["camera"]:
        scene.renderer.GetActiveCamera().SetClippingRange(values["camera"]["clipping_range"])
    else:
        scene.renderer.ResetCameraClippingRange()
    return scene


def _slice(scene: Scene, image: vtkImageData, look: Look) -> vtkActor:
    """Show an image of one layer of points as it is, in colours."""
    surface = objects.apply("vtkImageDataGeometryFilter", {}, image, "")
    return _colored(scene, actors.show_surface(surface), look)


def _actor_of_image(scene: Scene, held: vtkImageData, look: Look) -> vtkActor:
    """Show the surfaces of an image's labels, or where its values are half of their range."""
    found = arrays.default(held)
    if found is None:
        raise SceneError("the image has no values to show, neither at points nor at cells")
    image, found = voxels.at_points(held, found)
    if min(image.GetDimensions()) < 2:
        return _slice(scene, held, look)
    known = labels.find(image, found)
    if known is not None:
        count = len(known.values)
        scene.notes.append(
            f"'{found.name}' holds labels: {count} surfaces, none of {known.background:g}, a "
            "little smoothed, in colours by their order; a scene file can say others"
        )
        actor = actors.show_surface(labels.surface(image, found, known))
        if look.color_by not in (None, found.name):
            return _colored(scene, actor, look)
        actors.color_by_category(actor, labels.NAME)
        return actor
    low, high = found.span
    if not low <= high:
        raise SceneError(f"array '{found.name}' has no values, all of them are missing (NaN)")
    if low == high:
        raise SceneError(f"array '{found.name}' is constant, there is no iso-surface")
    value = 0.5 * (low + high)
    missing = voxels.number_missing(found)
    scene.notes.append(
        f"contour of '{found.name}' at {value:g}, half of its range {low:g} to {high:g}"
        + (f", without {missing} missing values (NaN)" if missing else "")
        + "; a scene file can say another value"
    )
    steps = [{"contour": {"array": found.name, "value": value}}]
    actor = actors.show_surface(pipeline.done(image, steps))
    return actor if look.color_by is None else _colored(scene, actor, look)


def _colored(scene: Scene, actor: vtkActor, look: Look) -> vtkActor:
    """Colour an actor by what its data hold, or by the array that a look names, and say so."""
    surface = actor.GetMapper().GetInput()
    if look.color_by == looks.NONE:
        return actor
    if look.color_by is not None:
        found = arrays.find(surface, look.color_by, "color_by")
        span = actors.color_by_values(actor, found)
        if span is None:
            scene.notes.append(f"not coloured by '{found.name}', which is constant here")
        return actor
    for name in (actors.DIRECT_COLORS, "rgb_colors"):
        direct = actors.direct_colors(surface, name)
        if direct is not None:
            actors.color_by(actor, direct)
            return actor
    usual = arrays.default(surface)
    span = None if usual is None else actors.color_by_values(actor, usual)
    if span is not None:
        scene.notes.append(
            f"coloured by '{usual.name}', {span[0]:g} to {span[1]:g}; color_by names another array"
        )
    return actor


def _actor_of_file(scene: Scene, look: Look) -> vtkActor:
    """Show a data file by a look, and where the look says nothing as suits the data."""
    held = data.read(scene.path)
    if isinstance(held, vtkImageData):
        return _actor_of_image(scene, held, look)
    surface = objects.surface_of(held, "")
    if data.is_molecule(scene.path):
        spheres = {"radius": 1.0, "scale_by": "radius", "resolution": 12}
        scene.notes.append("atoms are shown as spheres of their van der Waals radius")
        surface = pipeline.done(surface, [{"glyph_spheres": spheres}])
    return _colored(scene, actors.show_surface(surface), look)


def _from_data(path: Path, progress: Callable[[int, str], None], look: Look) -> Scene:
    progress(1, path.name)
    scene = Scene(data.stem(path), path, (512, 512))
    scene.renderer.SetBackground(look.background or looks.BACKGROUND)
    actor = _actor_of_file(scene, look)
    surface = actor.GetMapper().GetInput()
    if surface.GetNumberOfCells() == 0:
        raise SceneError(
            "the file has nothing to show, it holds points but no cells; "
            "a scene file can show them as spheres"
        )
    actors.check_finite(surface, "")
    scene.add_actor(scene.name, actor, path.name)
    _check_extent(scene)
    lights.add_light_kit(scene.renderer)
    outline = views.extremes(vtk_to_numpy(surface.GetPoints().GetData()))
    scene.view_data(outline, look.up or data.up_axis(path), look.view)
    scene.can_stand = bodies.can_stand(surface)
    return scene


def is_scene_file(path: str | os.PathLike[str]) -> bool:
    """Return whether a path is that of a scene file; others are data files."""
    return Path(path).suffix.lower() == ".json"


def load_scene(
    path: str | os.PathLike[str],
    progress: Callable[[int, str], None] | None = None,
    *,
    view: Any = None,
    color_by: str | None = None,
    up: str | None = None,
    background: Any = None,
) -> Scene:
    """Load a scene file (.json) or a data file.

    `progress` is called before each actor with their number and the actor's name. Raises
    `UsageError`, whose text is one line that names the file and the place in it.

    `view` is the side of a data file that is seen: "iso" (obliquely from above), "x", "-x", "y",
    "-y", "z" or "-z" (from where that axis points), or a direction from the data to the camera; by
    default "iso", or the broad side of data that are thin from there. `color_by` is the name of an
    array, or "none"; by default the active scalars. `up` is the axis that points up, "z" by default
    and "y" in glTF and OBJ files. A scene file says these itself. `background` is a colour, by its
    name, ``"#rrggbb"``, or red, green and blue from 0 to 1; by default white, or the scene file's.
    """
    if not isinstance(path, (str, os.PathLike)):
        check_text("path", path)
    path = Path(path)
    data.readable(path)
    look = looks.check(view, color_by, up, background)
    progress = progress or (lambda _total, _name: None)
    if not is_scene_file(path):
        try:
            return _from_data(path, progress, look)
        except SceneError as error:
            raise UsageError(f"{path}: {error}") from None
    if look.first_of_data is not None:
        raise UsageError(f"{path}: {look.first_of_data} is for data files, and this is a scene")
    try:
        scene = _from_document(path, progress)
    except SceneError as error:
        raise SceneError(f"{path}: {error}") from None
    if look.background is not None:
        scene.renderer.SetBackground(look.background)
    return scene
