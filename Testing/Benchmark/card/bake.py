# SPDX-License-Identifier: BSD-3-Clause
"""Writes scenes in the form that the benchmark for cards reads without Python.

    bake.py FOLDER [--scene NAME]...

FOLDER/scenes/pack.txt says in a line what the pack is of. For each scene FOLDER/scenes/<name>/scene.json
has the camera, the lights and the actors as plain values;
<i>.vtp the geometry of actor i after its pipeline, with its colours as bytes; reference.vti the
irradiance that errors are measured against, at the pixels of the stored reference: R1, computed
here by the CPU, R2 and R3 from Testing/Reference/data, and a mask of the pixels that count.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkLight

import vtkindirect
from vtkindirect import frames, references
from vtkindirect.errors import IndirectError

ROOT = Path(__file__).resolve().parents[3]
SCENES = ("apartment_living", "brain", "cornell_box", "frog", "many_objects", "room_fire")
"""Closed and open, one light and several, few triangles and many, translucent ones."""

# Properties that are copied as they are: the Get and Set methods of both sides have these names.
CAMERA = ("Position", "FocalPoint", "ViewUp", "ViewAngle", "ParallelProjection", "ParallelScale",
          "ClippingRange")
LIGHT = ("LightType", "Positional", "Position", "FocalPoint", "DiffuseColor", "SpecularColor",
         "AmbientColor", "Intensity", "ConeAngle", "Exponent", "AttenuationValues")
PROPERTY = ("AmbientColor", "DiffuseColor", "SpecularColor", "Ambient", "Diffuse", "Specular",
            "SpecularPower", "Opacity", "Interpolation", "Metallic", "Roughness", "BaseIOR")


def values_of(thing: Any, names: tuple[str, ...]) -> dict[str, Any]:
    """Return what the Get methods of a VTK object give, by their names."""
    return {name: getattr(thing, f"Get{name}")() for name in names}


def write(writer: Any, data: Any, path: Path) -> None:
    """Write a data set of VTK, uncompressed: the whole pack is compressed better than its parts."""
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    if not writer.Write():
        raise SystemExit(f"bake: {path} cannot be written")


def bake_actor(actor: vtkActor, path: Path) -> dict[str, Any]:
    """Write an actor's geometry with normals and colours alone; returns its other values."""
    mapper = actor.GetMapper()
    mapper.Update()
    found = mapper.GetInput()
    baked = vtkPolyData()
    baked.CopyStructure(found)
    baked.GetPointData().SetNormals(found.GetPointData().GetNormals())
    colors = mapper.MapScalars(1.0) if mapper.GetScalarVisibility() else None
    if colors is not None:
        colors.SetName("colors")
        at_points = colors.GetNumberOfTuples() == found.GetNumberOfPoints()
        (baked.GetPointData() if at_points else baked.GetCellData()).SetScalars(colors)
    write(vtkXMLPolyDataWriter(), baked, path)
    matrix = actor.GetMatrix()
    return {
        "File": path.name,
        "Colored": colors is not None,
        "Matrix": [matrix.GetElement(row, column) for row in range(4) for column in range(4)],
        **values_of(actor.GetProperty(), PROPERTY),
    }


def bake_reference(scene: Any, name: str, path: Path) -> list[int]:
    """Write the references of a scene; returns their size in pixels."""
    stored = ROOT / "Testing/Reference/data" / f"{name}.exr"
    natural = references.natural_size(stored)
    if natural is None:
        raise SystemExit(f"bake: {stored} has no reference")
    size = [edge // references.FACTOR for edge in natural]
    scene.make_window(tuple(size))
    layers = {"R1": references.r1(scene)}
    window = frames.open_window(scene, natural)
    vtkindirect.enable(scene.renderer, "gather", NumberOfLights=1)
    window.Render()
    centre = slice(references.FACTOR // 2, None, references.FACTOR)
    mask = references.mask(scene)[centre, centre]
    vtkindirect.disable(scene.renderer)
    found, missing = references.stored_images(stored, natural)
    if missing:
        raise SystemExit(f"bake: {missing}")
    layers.update(found)
    image = vtkImageData()
    image.SetDimensions(*size, 1)
    for layer, values in {**layers, "mask": mask[..., np.newaxis]}.items():
        flat = np.ascontiguousarray(values.reshape(-1, values.shape[-1]), dtype=np.float32)
        array = numpy_to_vtk(flat, deep=True)
        array.SetName(layer)
        image.GetPointData().AddArray(array)
    write(vtkXMLImageDataWriter(), image, path)
    return size


def bake(name: str, folder: Path) -> None:
    """Write one scene of Testing/Scenes into `folder`/`name`."""
    scene = vtkindirect.load_scene(ROOT / "Testing/Scenes" / f"{name}.json")
    target = folder / name
    target.mkdir(parents=True, exist_ok=True)
    camera: vtkCamera = scene.renderer.GetActiveCamera()
    lights: list[vtkLight] = scene.lights
    values = {
        "Name": name,
        "Background": scene.renderer.GetBackground(),
        "Camera": values_of(camera, CAMERA),
        "Lights": [values_of(light, LIGHT) for light in lights],
        "Actors": [
            bake_actor(actor, target / f"{i}.vtp")
            for i, actor in enumerate(scene.actors.values())
            if actor.GetVisibility()
        ],
        "ReferenceSize": bake_reference(scene, name, target / "reference.vti"),
    }
    (target / "scene.json").write_text(json.dumps(values, indent=1) + "\n", encoding="utf-8")


def name_pack() -> str:
    """Return the version, and the commit where there is one: which distinguish results."""
    git = shutil.which("git")
    commit = ""
    if git is not None:
        said = subprocess.run(
            [git, "-C", ROOT, "describe", "--always", "--dirty", "--abbrev=12"],
            capture_output=True, text=True, check=False,
        )
        commit = f", commit {said.stdout.strip()}" if said.returncode == 0 else ""
    return f"{vtkindirect.__version__}{commit}"


def main() -> int:
    """Bake what the command line names."""
    parser = argparse.ArgumentParser(prog="bake.py", description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scene", action="append", choices=SCENES, help="default: all of them")
    options = parser.parse_args()
    names = options.scene or SCENES
    scenes = options.folder / "scenes"
    scenes.mkdir(parents=True, exist_ok=True)
    (scenes / "pack.txt").write_text(name_pack() + "\n", encoding="utf-8")
    try:
        for name in names:
            print(f"baking {name}", flush=True)
            bake(name, scenes)
    except IndirectError as error:
        print(f"bake: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
