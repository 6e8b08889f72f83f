# SPDX-License-Identifier: BSD-3-Clause
"""Origin of a reference, and a check that it still belongs to its scene file.

Needs neither VTK nor Mitsuba.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

SCHEMA = "vtkindirect.reference/1"

# Goes up when the tools' answer for an unchanged scene changes, which makes references stale.
METHOD = 1

HERE = Path(__file__).resolve().parent
SCENES = HERE.parent / "Scenes"
DATA = HERE / "data"


def scene_file(scene: str | Path) -> Path:
    """Return the file of a scene, given by its name in Testing/Scenes or as a path."""
    return Path(scene) if str(scene).endswith(".json") else SCENES / f"{scene}.json"


def file_hash(path: Path) -> str:
    """Return the SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def scene_hash(path: Path) -> str:
    """Return the SHA-256 of what a scene file says; how its text is laid out does not matter."""
    values = json.loads(path.read_text(encoding="utf-8-sig"))
    text = json.dumps(values, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def data_hashes(path: Path) -> dict[str, str]:
    """Return the SHA-256 of each data file that a scene file names, by the name that it uses."""
    values = json.loads(path.read_text(encoding="utf-8-sig"))
    named = [*values["actors"], *values.get("lights", [])]
    names = sorted({part[key] for part in named for key in ("file", "texture") if key in part})
    return {name: file_hash(path.parent / name) for name in names}


def paths(scene: str | Path, directory: Path = DATA) -> tuple[Path, Path]:
    """Return the image and the provenance of a scene's reference, whether they exist or not."""
    name = scene_file(scene).stem
    return directory / f"{name}.exr", directory / f"{name}.json"


def read(scene: str | Path, directory: Path = DATA) -> dict[str, Any]:
    """Return the provenance of a scene's reference."""
    return json.loads(paths(scene, directory)[1].read_text())


def why_stale(scene: str | Path, directory: Path = DATA) -> str | None:
    """Return why there is no valid reference of a scene, or None when there is one."""
    image, record = paths(scene, directory)
    if not image.is_file() or not record.is_file():
        return "there is no reference"
    found = read(scene, directory)
    path = scene_file(scene)
    if found.get("schema") != SCHEMA or found["method"] != METHOD:
        return "it was made by another version of the tools"
    if found["scene"]["sha256"] != scene_hash(path):
        return "the scene file has changed"
    if found["data"] != data_hashes(path):
        return "a data file has changed"
    if found["image"]["sha256"] != file_hash(image):
        return "the image is not the one that was made"
    return None


def is_current(scene: str | Path, directory: Path = DATA) -> bool:
    """Return whether the reference of a scene exists and belongs to the scene file as it is now."""
    return why_stale(scene, directory) is None
