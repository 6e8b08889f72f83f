# SPDX-License-Identifier: BSD-3-Clause
"""The Python side of the image suite: scene files, by the package `vtkindirect`.

    cases.py CASE -T FOLDER -V BASELINE

Renders one case, writes what came out into FOLDER and compares it with the baseline: the picture by
VTK's own metric and pixel by pixel, the pass's buffers by block means (reference.py). Exits with
125 when nothing can be rendered here.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

import reference
import vtkindirect
from vtkindirect import frames

try:
    from vtkmodules.vtkTestingRendering import vtkTesting
except ImportError as error:
    WHY_NO_HARNESS = f"VTK's Python package is without its harness ({error})"
else:
    WHY_NO_HARNESS = None

SKIPPED = 125
THRESHOLD = 0.05
"""Threshold of VTK's metric: the default from 9.4 on."""
SCENES = reference.PLACE.parent / "Scenes"


@dataclass(frozen=True)
class Case:
    """A scene file, its rendering, and the buffers compared beside the picture."""

    name: str
    scene: str
    size: tuple[int, int] = (160, 120)
    method: str = "gather"
    sampler: str | None = "uniform"
    settings: dict[str, Any] = field(default_factory=dict)
    buffers: tuple[str, ...] = ("final", "irradiance")
    # Degrees of azimuth and elevation. In views along walls rasterizers differ in edge pixels.
    turn: tuple[float, float] = (0, 0)


# CMake finds a case by the beginning of its line.
CASES = [
    # The demonstrations.
    Case("DemoRoomFire", "room_fire", size=(200, 100)),
    Case("DemoApartment", "apartment_living"),
    Case("DemoFrog", "frog"),
    Case("DemoProtein", "protein"),
    Case("DemoBrain", "brain"),
    # Scenes of tests and benchmarks, by each method.
    Case("SceneStatueProxies", "sky_statue", method="proxies", sampler=None, buffers=("final", "sky", "bounce")),
    Case("SceneProteinProxies", "protein", (160, 120), "proxies", None, {"environment": (1.0, 1.0, 1.0), "lighting": "scene"}),
    Case("SceneCornellBox", "cornell_box", (128, 128), turn=(4, 3)),
    Case("SceneCornellBoxAuto", "cornell_box", (128, 128), "auto", None, turn=(4, 3)),
    Case("SceneCornellBoxOff", "cornell_box", (128, 128), "off", None, buffers=(), turn=(4, 3)),
    Case("SceneContactCorner", "contact_corner", size=(128, 128), method="multiresolution"),
    Case("SceneFoldedSheet", "folded_sheet", size=(128, 128)),
    Case("SceneGrazingLight", "grazing_light", size=(128, 128), method="multiresolution"),
    Case("SceneManyObjects", "many_objects", size=(128, 128)),
    Case("SceneAntialiasing", "many_objects", (128, 128), settings={"antialiasing": True}),
    Case("SceneTwoPlanes", "two_planes", size=(128, 128)),
    Case("SceneRingCaustic", "ring_caustic", size=(128, 128)),
    Case("SceneClosedSphere", "closed_sphere", (128, 128), settings={"number_of_lights": 1024}),
    # A rectangular lamp.
    Case("SceneAreaCornell", "area_cornell", (128, 128), "auto", None, buffers=("final", "irradiance", "area"), turn=(4, 3)),
    # A wall between the rooms blocks the light.
    Case("SceneTwoRooms", "two_rooms", (128, 128), settings={"visibility": "voxels"}, turn=(8, 3)),
    Case("SceneTwoRoomsHints", "two_rooms", (128, 128), "hints", None, turn=(8, 3)),
]


def grab(window: vtkRenderWindow) -> vtkWindowToImageFilter:
    """Return the picture of a window."""
    pixels = vtkWindowToImageFilter()
    pixels.SetInput(window)
    pixels.ReadFrontBufferOff()
    pixels.ShouldRerenderOff()
    pixels.Update()
    return pixels


def as_array(image: Any) -> np.ndarray:
    """Return an image's values in rows, columns, components."""
    width, height, _depth = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def read_png(path: Path) -> np.ndarray:
    """Return the pixels of a file, bottom row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return as_array(reader.GetOutput())


def alternatives(baseline: Path) -> list[Path]:
    """Return a baseline and its alternatives, whose names end with _1, _2 and so on."""
    found = [baseline]
    while (
        path := baseline.with_name(f"{baseline.stem}_{len(found)}{baseline.suffix}")
    ).exists():
        found.append(path)
    return found


class Checks:
    """Counts comparisons and collects failures."""

    def __init__(self) -> None:
        self.failures: list[str] = []

    def check(self, holds: bool, what: str) -> None:
        """Print a failure."""
        if not holds:
            self.failures.append(what)
            print(f"FAILED {what}")


def compare(checks: Checks, pixels: Any, grids: reference.Grids, arguments: list[str]) -> None:
    """Compare a frame with its baseline."""
    baseline = Path(arguments[arguments.index("-V") + 1])
    checks.check(baseline.exists(), f"there is no baseline {baseline}")
    if checks.failures:
        return
    testing = vtkTesting()
    for argument in arguments:
        testing.AddArgument(argument)
    verdict = testing.RegressionTest(pixels, THRESHOLD)
    checks.check(verdict == vtkTesting.PASSED, "VTK's metric")
    differences: list[str] = []
    for path in alternatives(baseline):
        found = find_differences(as_array(pixels.GetOutput()), grids, path)
        if not found:
            return
        differences += found
    checks.check(False, f"what differs: {', '.join(differences)}")


def find_differences(picture: np.ndarray, grids: reference.Grids, path: Path) -> list[str]:
    """Return the differences of a frame from one baseline."""
    found = []
    stored = read_png(path)
    mean, share = reference.pixel_difference(picture, stored)
    print(f"{path.name}\n  picture: mean {mean:.4g}, {100 * share:.4g} % of the pixels off")
    if not reference.pixels_agree(picture, stored):
        found.append("the picture")
    stored_grids = reference.read_grids(path.with_suffix(".json")) if grids else {}
    found += [f"{name} (on one side only)" for name in grids.keys() ^ stored_grids.keys()]
    for name in sorted(grids.keys() & stored_grids.keys()):
        deviation = reference.deviation(grids[name], stored_grids[name])
        print(f"  {name}: {deviation}")
        if not deviation.is_small:
            found.append(name)
    return found


def run(case: Case, arguments: list[str]) -> bool:
    """Render a case and compare it; returns True if it equals the baseline."""
    folder = Path(arguments[arguments.index("-T") + 1])
    checks = Checks()
    scene = vtkindirect.load_scene(SCENES / f"{case.scene}.json")
    camera = scene.renderer.GetActiveCamera()
    camera.Azimuth(case.turn[0])
    camera.Elevation(case.turn[1])
    window = frames.open_window(scene, case.size)
    # Separate cases test antialiasing: aliased edges show more of the other cases' subjects.
    settings = {} if case.method == "off" else {"antialiasing": False}
    settings.update(case.settings)
    frames.render(scene, window, frames.Job(case.method, case.sampler, settings))
    pixels = grab(window)
    grids = {
        name: reference.make_grid(vtkindirect.copy_buffer(scene.renderer, name)[..., :3])
        for name in case.buffers
    }
    for name, grid in grids.items():
        checks.check(bool(np.isfinite(grid).all()), f"{name} holds infinite or undefined values")
    if checks.failures:
        return False
    # Files that `renew` collects.
    writer = vtkPNGWriter()
    writer.SetInputConnection(pixels.GetOutputPort())
    writer.SetFileName(str(folder / f"{case.name}.now.png"))
    writer.Write()
    reference.write_grids(folder / f"{case.name}.now.json", grids)
    compare(checks, pixels, grids, arguments)
    window.Finalize()
    return not checks.failures


def why_not() -> str | None:
    """Return the reason if rendering or comparison is impossible here, or None."""
    if WHY_NO_HARNESS:
        return WHY_NO_HARNESS
    try:
        window = vtkindirect.render_window((8, 8), offscreen=True)
        window.Render()
        window.Finalize()
    except (ImportError, vtkindirect.RenderError) as error:
        return str(error)
    return None


def main(arguments: list[str]) -> int:
    """Run the case that the command line names."""
    table = {case.name: case for case in CASES}
    if arguments[:1] == ["--compare"]:
        odd = sorted(table.keys() ^ set(arguments[1:]))
        print("CMake and this file differ in:", *odd)
        return 1 if odd or len(table) < len(CASES) else 0
    if not arguments or arguments[0] not in table:
        print("which case? known are", *table)
        return 1
    reason = why_not()
    if reason:
        print("skipped:", reason)
        return SKIPPED
    return 0 if run(table[arguments[0]], arguments[1:]) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
