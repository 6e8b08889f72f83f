#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that the rooms of Module/Rendering are in order: no file includes one of a later room.

    Testing/Structure/check_rooms.py [MODULE]

The order is that of Documentation/architecture.md, which must name every room, and that of the
shaders' folders. Public classes are flat; each belongs to a room all the same.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from faults import report

ROOMS = [
    "OpenGL",
    "Scene",
    "Plan",
    "Capture",
    "Emitters",
    "Maps",
    "Senders",
    "Visibility",
    "Sums",
    "Gather",
    "Sky",
    "Area",
    "Splatting",
    "Multiresolution",
    "RadianceHints",
    "Proxies",
    "Picture",
    "Error",
    "Pipeline",
]
PUBLIC = {
    "vtkIndirectSettings": "Plan",
    "vtkAreaLight": "Emitters",
    "vtkEnvironmentLight": "Emitters",
    "vtkIndirectEmitterBase": "Emitters",
    "vtkReflectiveShadowMapPass": "Maps",
    "vtkAreaLightSampler": "Senders",
    "vtkImportanceLightSampler": "Senders",
    "vtkLightTreeSampler": "Senders",
    "vtkRandomWalkLightSampler": "Senders",
    "vtkUniformLightSampler": "Senders",
    "vtkVirtualLightSampler": "Senders",
    "vtkRSMGatherPass": "Gather",
    "vtkIndirectSplattingPass": "Splatting",
    "vtkMultiresolutionSplattingPass": "Multiresolution",
    "vtkRadianceHintsPass": "RadianceHints",
    "vtkProxyAccumulationPass": "Proxies",
    # Classes that a user puts on a renderer: above all rooms.
    "vtkIndirectEstimatorPass": "",
    "vtkIndirectIlluminationPass": "",
    "vtkIndirectIlluminationPassKeys": "",
}
# The base class of estimators is in no room; these derive from it or call it.
MAY_NAME_ESTIMATORS = {
    "vtkRSMGatherPass",
    "vtkIndirectSplattingPass",
    "vtkMultiresolutionSplattingPass",
    "vtkRadianceHintsPass",
    "vtkProxyAccumulationPass",
    "vtkIndirectSum",
    "vtkIndirectPipeline",
    "vtkIndirectBounceLight",
}


def room_of(path: Path, module: Path) -> str | None:
    """Return the room of a source file, "" above all, or None of a public class unknown here."""
    parts = path.relative_to(module).parts
    if parts[0] == "Private":
        return parts[1]
    return PUBLIC.get(path.stem)


def find_faults(module: Path) -> list[str]:
    """Return a line for each include that reaches into a later room, or into none."""
    faults = []
    sources = [*module.glob("*.h"), *module.glob("*.cxx"), *module.glob("Private/*/*")]
    if len(sources) < 80:
        faults.append(f"{module} has {len(sources)} sources only")
    for path in sorted(sources):
        if path.suffix not in (".h", ".cxx"):
            continue
        room = room_of(path, module)
        if room is None or (room and room not in ROOMS):
            faults.append(f"{path.name} is in no room that this knows")
            continue
        place = ROOMS.index(room) if room else len(ROOMS)
        for name in re.findall(r'#include "([^"]+)"', path.read_text(encoding="utf-8")):
            stem = Path(name).stem
            target = name.split("/")[0] if "/" in name else PUBLIC.get(stem)
            if target is None or target == room:
                continue
            if target == "" and path.stem in MAY_NAME_ESTIMATORS:
                continue
            where = ROOMS.index(target) if target in ROOMS else len(ROOMS)
            if where > place:
                faults.append(f"{room or 'above'}: {path.name} includes {name}")
    return faults


def main() -> int:
    """Print the faults; returns the exit code."""
    root = Path(__file__).resolve().parents[2]
    module = Path(sys.argv[1]) if len(sys.argv) > 1 else root / "Module" / "Rendering"
    faults = find_faults(module)
    page = (root / "Documentation" / "architecture.md").read_text(encoding="utf-8")
    places = [page.find(f"| `{room}` |") for room in ROOMS]
    if -1 in places or places != sorted(places):
        faults.append("Documentation/architecture.md does not list the rooms in their order")
    for folder in ("Private", "glsl"):
        for path in (module / folder).iterdir():
            if path.is_dir() and path.name not in (*ROOMS, "lib"):
                faults.append(f"{folder}/{path.name} is no room")
    return report(faults)


if __name__ == "__main__":
    sys.exit(main())
