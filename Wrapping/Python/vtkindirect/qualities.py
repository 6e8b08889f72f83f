# SPDX-License-Identifier: BSD-3-Clause
"""Words for how long a picture may take: each stands for settings of the pass and the sampler.

The guide has the times and errors that chose them.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Sequence
from typing import Any

from vtkindirect import settings
from vtkindirect.errors import UsageError, check_text, unknown

QUALITIES: dict[str, dict[str, Any]] = {
    "draft": {"NumberOfLights": 64, "ErrorTolerance": 0.2, "NumberOfRefinements": 0},
    "interactive": {},
    "final": {
        "NumberOfLights": 1024,
        "ErrorTolerance": 0.01,
        "MapsFirst": True,
        "NumberOfRefinements": 0,
    },
}
"""Settings by name; what a word does not name has its default."""
NAMES = tuple(QUALITIES)
DEFAULT = "interactive"


def check(name: Any) -> str:
    """Return the name of a quality that is known."""
    check_text("quality", name)
    if name not in NAMES:
        raise UsageError(unknown("quality", name, NAMES))
    return name


def _default(target: Any, name: str) -> Any:
    return getattr(target.NewInstance(), f"Get{name}")()


def apply(
    targets: Sequence[Any], fresh: Sequence[Any], before: str, after: str, own: Iterable[str]
) -> None:
    """Bring properties from one quality to another, but none that a call has named (`own`).

    `fresh` are the objects that have come since the last call, with their defaults. A property that
    somebody has set on the object itself since then stays as well.
    """
    for name in {**QUALITIES[before], **QUALITIES[after]}:
        found = settings.find(targets, name)
        if found is None or name in own:
            continue
        target, proper = found
        default = _default(target, proper)
        old = default if target in fresh else QUALITIES[before].get(name, default)
        if getattr(target, f"Get{proper}")() == old:
            with contextlib.suppress(UsageError):  # out of the range of a sampler of another kind
                settings.set_property(target, proper, QUALITIES[after].get(name, default))
