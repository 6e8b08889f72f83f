# SPDX-License-Identifier: BSD-3-Clause
"""Which methods there are, and switching indirect light on and off.

One row of `METHODS` is one method. A method whose C++ class was not built is known by name and
refused with a clear message; nothing else needs to change when the class is there.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from vtkindirect import settings as properties
from vtkindirect import wrapped
from vtkindirect.errors import UsageError, unknown


@dataclass(frozen=True)
class Method:
    """How a method is made: its estimator and the sampler that it has by default."""

    name: str
    estimator: str | None
    sampler: str | None
    meaning: str


_ROWS = (
    Method("auto", None, None, "the pass chooses from the scene"),
    Method("off", None, None, "no indirect light: VTK's own image"),
    Method("gather", "vtkRSMGatherPass", "vtkUniformLightSampler", "sum over virtual lights"),
    Method(
        "splatting", "vtkIndirectSplattingPass", "vtkUniformLightSampler", "virtual lights drawn"
    ),
    Method(
        "multiresolution",
        "vtkMultiresolutionSplattingPass",
        "vtkUniformLightSampler",
        "sum over virtual lights, once for each group of pixels that looks alike",
    ),
    Method("hints", "vtkRadianceHintsPass", None, "light sampled in a grid of the space"),
    Method("proxies", "vtkProxyAccumulationPass", None, "sphere proxies under an environment"),
    Method("reference", "vtkRSMReferencePass", None, "sum over all texels, on the CPU: exact, slow"),
)

METHODS = {method.name: method for method in _ROWS}

SAMPLERS = {
    "uniform": "vtkUniformLightSampler",
    "importance": "vtkImportanceLightSampler",
    "random_walk": "vtkRandomWalkLightSampler",
    "area": "vtkAreaLightSampler",
}


def _class_or_error(class_name: str, kind: str, name: str) -> Any:
    if not wrapped.has("vtkIndirectIlluminationPass"):
        wrapped.get("vtkIndirectIlluminationPass")  # raises and says why
    if not wrapped.has(class_name):
        raise UsageError(f"{kind} '{name}' is not built in this version")
    return wrapped.get(class_name)


def check_method(name: str) -> Method:
    """Return the row of a method that can be used now."""
    if name not in METHODS:
        raise UsageError(unknown("method", name, METHODS))
    method = METHODS[name]
    if method.estimator is not None:
        _class_or_error(method.estimator, "method", name)
    return method


def check_sampler(name: str) -> str:
    """Return the class name of a sampler that can be used now."""
    if name not in SAMPLERS:
        raise UsageError(unknown("sampler", name, SAMPLERS))
    _class_or_error(SAMPLERS[name], "sampler", name)
    return SAMPLERS[name]


# The passes that are on ------------------------------------------------------------------------


@dataclass
class _Record:
    """What `enable` did to a renderer."""

    indirect: Any
    previous: Any
    method: str | None = None


# By the address of the C++ renderer: a Python object for it may come and go.
_records: dict[str, _Record] = {}


def _record_of(renderer: vtkRenderer) -> _Record | None:
    """Return what `enable` did, unless somebody has set another pass since."""
    record = _records.get(renderer.__this__)
    return record if record is not None and renderer.GetPass() is record.indirect else None


def _keep(renderer: vtkRenderer, record: _Record) -> None:
    key = renderer.__this__
    if key not in _records:
        renderer.AddObserver("DeleteEvent", lambda *_: _records.pop(key, None))
    _records[key] = record


def renderers_of(target: Any) -> Iterator[vtkRenderer]:
    """Yield the renderers that a renderer, a render window or a plotter stands for.

    Of a window these are all its renderers; of a plotter with subplots the active one, as with
    PyVista's own effects.
    """
    if isinstance(target, vtkRenderer):
        yield target
    elif isinstance(target, vtkRenderWindow):
        collection = target.GetRenderers()
        for index in range(collection.GetNumberOfItems()):
            yield collection.GetItemAsObject(index)
    elif isinstance(getattr(target, "renderer", None), vtkRenderer):
        yield target.renderer
    else:
        raise UsageError(
            f"a renderer, a render window or a plotter is needed, not {type(target).__name__}"
        )


def parts(indirect: Any) -> list[Any]:
    """Return where properties are looked up: the estimator, the sampler, the pass itself."""
    found = [indirect.GetEstimator(), indirect.GetSampler(), indirect]
    return [part for part in found if part is not None]


def _configure(
    record: _Record, method: Method, sampler: str | None, settings: dict[str, Any]
) -> None:
    """Bring the pass to a method and set properties; keeps what a call does not mention."""
    indirect = record.indirect
    if record.method != method.name:
        estimator = wrapped.get(method.estimator)() if method.estimator else None
        indirect.SetEstimator(estimator)
        indirect.SetSampler(wrapped.get(method.sampler)() if method.sampler else None)
        record.method = method.name
    if sampler is not None:
        indirect.SetSampler(wrapped.get(check_sampler(sampler))())
    targets = parts(indirect)
    for name in settings:
        if properties.find(targets, name) is None:
            _explain_owner(name, method)
    properties.apply(targets, settings)


def _explain_owner(name: str, method: Method) -> None:
    """Raise when a property belongs to another method than the one in use."""
    for other in METHODS.values():
        for class_name in (other.estimator, other.sampler):
            if class_name is None or not wrapped.has(class_name):
                continue
            if properties.find([wrapped.get(class_name)()], name) is not None:
                raise UsageError(
                    f"property '{name}' belongs to method '{other.name}', not '{method.name}'"
                )


def enable(target: Any, method: str = "auto", sampler: str | None = None, **settings: Any) -> Any:
    """Switch indirect light on; returns the vtkIndirectIlluminationPass.

    `target` is a vtkRenderer, a vtkRenderWindow or a PyVista plotter. For a window with several
    renderers the result is a list of passes. `method` is one of `METHODS` ("off" is `disable`, and
    gives None), `sampler` one of `SAMPLERS`; None keeps the method's own.

    `settings` are properties of the estimator, the sampler or the pass, in that order, by their
    VTK name or in lower case: ``NumberOfLights=256`` or ``number_of_lights=256``. Enumerated values
    are names: ``mode="all_texels"``. A value that is out of range is an error.

    The pass that the renderer had before is kept and comes back with `disable`. Calling again
    changes the method and the settings that are given and keeps the others.
    """
    row = check_method(method)
    if row.name == "off":
        if settings or sampler:
            raise UsageError(f"method 'off' has no property '{[*settings, 'sampler'][0]}'")
        disable(target)
        return None
    passes = []
    for renderer in renderers_of(target):
        record = _record_of(renderer)
        if record is None:
            indirect = wrapped.get("vtkIndirectIlluminationPass")()
            record = _Record(indirect, renderer.GetPass())
        _configure(record, row, sampler, settings)
        renderer.SetPass(record.indirect)
        _keep(renderer, record)
        passes.append(record.indirect)
    if not passes:
        raise UsageError("the window has no renderer")
    return passes[0] if len(passes) == 1 else passes


def disable(target: Any) -> None:
    """Switch indirect light off again and restore the pass that was there before.

    A renderer whose pass was set by somebody else since is left alone. Graphics memory is freed.
    """
    for renderer in renderers_of(target):
        record = _record_of(renderer)
        _records.pop(renderer.__this__, None)
        if record is not None:
            renderer.SetPass(record.previous)
            window = renderer.GetRenderWindow()
            if window is not None:
                record.indirect.ReleaseGraphicsResources(window)


def pass_of(target: Any) -> Any:
    """Return the pass that `enable` set, or None. `target` as for `enable`, or a pass."""
    if hasattr(target, "CopyBuffer"):
        return target
    for renderer in renderers_of(target):
        record = _record_of(renderer)
        if record is not None:
            return record.indirect
    return None


def report(target: Any) -> dict[str, Any]:
    """Return the last frame's report of a pass: what was decided, times, memory.

    `target` is a pass, or what `enable` was called with. The keys are those of the format
    ``vtkindirect.report/1``; times in milliseconds.
    """
    indirect = pass_of(target)
    if indirect is None:
        raise UsageError("indirect light is off, there is nothing to report")
    return json.loads(indirect.GetReport())
