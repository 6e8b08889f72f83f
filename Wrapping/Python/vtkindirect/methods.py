# SPDX-License-Identifier: BSD-3-Clause
"""Names of the methods, and functions that switch indirect light on and off.

One row of `METHODS` is one method. A method whose C++ class was not built is known by name and
refused with a clear message; nothing else needs to change when the class is there.
"""

from __future__ import annotations

import atexit
import json
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from vtkindirect import (
    area_lights,
    chain,
    environments,
    messages,
    names,
    qualities,
    surroundings,
    tones,
    widgets,
    wrapped,
)
from vtkindirect import ground as grounds
from vtkindirect import lighting as lightings
from vtkindirect import settings as properties
from vtkindirect.errors import UsageError, check_text, unknown
from vtkindirect.keep import KEEP
from vtkindirect.partaking import Warner
from vtkindirect.surroundings import Surroundings


@dataclass(frozen=True)
class Method:
    """Parts of a method: its estimator and the sampler that it has by default."""

    name: str
    estimator: str | None
    sampler: str | None
    meaning: str


_ROWS = (
    Method(
        "auto", None, None, "the pass's defaults: multiresolution splatting with lights of a tree"
    ),
    Method("off", None, None, "no indirect light: VTK's own image"),
    Method("gather", "vtkRSMGatherPass", "vtkLightTreeSampler", "sum over virtual lights"),
    Method(
        "splatting", "vtkIndirectSplattingPass", "vtkLightTreeSampler", "virtual lights drawn"
    ),
    Method(
        "multiresolution",
        "vtkMultiresolutionSplattingPass",
        "vtkLightTreeSampler",
        "sum over virtual lights, once for each group of pixels that looks alike",
    ),
    Method("hints", "vtkRadianceHintsPass", None, "light sampled in a grid of the space"),
    Method("proxies", "vtkProxyAccumulationPass", None, "sphere proxies under an environment"),
    Method(
        "reference",
        "vtkRSMReferencePass",
        "vtkUniformLightSampler",
        "sum over all texels or virtual lights, on the CPU: exact, slow",
    ),
)

METHODS = {method.name: method for method in _ROWS}

SAMPLERS = {
    "tree": "vtkLightTreeSampler",
    "uniform": "vtkUniformLightSampler",
    "importance": "vtkImportanceLightSampler",
    "random_walk": "vtkRandomWalkLightSampler",
}


def _class_or_error(class_name: str, kind: str, name: str) -> Any:
    if not wrapped.has("vtkIndirectIlluminationPass"):
        wrapped.get("vtkIndirectIlluminationPass")  # raises and says why
    if not wrapped.has(class_name):
        why = wrapped.explain(class_name)
        raise UsageError(f"{kind} '{name}' is not built in this version{f': {why}' if why else ''}")
    return wrapped.get(class_name)


def check_method(name: str) -> Method:
    """Return the row of a method that can be used now."""
    check_text("method", name)
    if name not in METHODS:
        raise UsageError(unknown("method", name, METHODS))
    method = METHODS[name]
    if method.estimator is not None:
        _class_or_error(method.estimator, "method", name)
    return method


def check_sampler(name: str) -> str:
    """Return the class name of a sampler that can be used now."""
    check_text("sampler", name)
    if name not in SAMPLERS:
        raise UsageError(unknown("sampler", name, SAMPLERS))
    _class_or_error(SAMPLERS[name], "sampler", name)
    return SAMPLERS[name]


PRESET = "Preset"
"""The property of every estimator that makes it the method as published."""


def is_preset(name: str) -> bool:
    """Return whether a setting's name is that of the estimators' preset."""
    return properties.camel(name).lower() == PRESET.lower()


# The passes that are on ------------------------------------------------------------------------


@dataclass
class _Record:
    """Changes of `enable` to a renderer, and the settings that were asked for since."""

    indirect: Any
    method: str | None = None
    settings: dict[str, Any] = field(default_factory=dict)
    configured: tuple[Any, ...] = ()
    quality: str = qualities.DEFAULT
    lighting: str | None = None  # asked for; None: nothing but what the pass has been set to
    chosen: tuple[str, str] | None = None  # what "auto" stood for last, and why
    warner: Warner = field(default_factory=Warner)
    around: Surroundings = field(default_factory=Surroundings)
    tone: tones.Tone = field(default_factory=tones.Tone)
    woven: chain.Woven | None = None
    renderer: vtkWeakReference = field(default_factory=vtkWeakReference)
    # Tags, and what is called: a renderer in a cycle of garbage has it called after Python has
    # cleared it, unless something else holds it.
    observers: list[tuple[int, Any]] = field(default_factory=list)
    names: tuple[str, ...] = ()  # of PyVista's actors
    ground: grounds.Ground | None = None


# By the address of the C++ renderer: a Python object for it may come and go.
_records: dict[str, _Record] = {}
# Lights of PyVista's cannot go after PyVista has.
atexit.register(_records.clear)


def _settled(renderer: vtkRenderer) -> Any:
    """Return the pass that is on in a renderer, or None, after a look at its chain of passes.

    PyVista puts its chain together anew for every effect that is switched on or off, without the
    pass that `enable` has put in; then it is put in again. Any other pass that is set stays.
    """
    link = chain.find(renderer.GetPass())
    if link is not None:
        return link[0]
    record = _records.get(renderer.__this__)
    if record is None or record.woven is None:
        return None
    if renderer.GetPass() is not None:
        pyvistas = chain.has_pyvistas_effects(renderer)
    else:  # as PyVista leaves it when the last effect is switched off
        pyvistas = chain.is_pyvistas(renderer) and record.woven.before is not None
    if not pyvistas:
        return None
    _weave(renderer, record)
    return record.indirect


def _weave(renderer: vtkRenderer, record: _Record) -> None:
    """Put the pass into the renderer's chain; one warning names what has no effect any more."""
    known = record.woven.left_out if record.woven is not None else []
    record.woven = chain.weave(renderer.GetPass(), record.indirect)
    renderer.SetPass(record.woven.top)
    record.tone.put(renderer, record.indirect)
    new = [name for name in record.woven.left_out if name not in known]
    if new:
        reasons = "; ".join(f"{name}: {chain.why_left_out(name)}" for name in new)
        warnings.warn(
            f"without effect until vtkindirect.disable, while indirect light is on: {reasons}",
            stacklevel=messages.users_level(),
        )


def _keep(renderer: vtkRenderer, record: _Record) -> None:
    """Remember a record while its renderer lives, and look after its pass from now on."""
    key = renderer.__this__
    # PyVista removes all observers of a renderer that it closes, so some are found here.
    for gone in [old for old, kept in _records.items() if kept.renderer.Get() is None]:
        del _records[gone]
    if _records.get(key) is record:
        return
    _forget(renderer)
    _records[key] = record
    record.renderer.Set(renderer)
    for event, called in (
        ("DeleteEvent", lambda *_: _records.pop(key, None)),
        # The first when a pass is set; the second when the begin of the chain stays the same.
        ("ModifiedEvent", lambda caller, _event: _settled(caller)),
        ("StartEvent", lambda caller, _event: _start(caller)),
        ("EndEvent", lambda caller, _event: _end(caller)),
    ):
        record.observers.append((renderer.AddObserver(event, called), called))


def _start(renderer: vtkRenderer) -> None:
    """Before a frame: see to what PyVista or others have changed since the last one."""
    there = _settled(renderer)
    record = _records.get(renderer.__this__)
    widgets.leave_out_of_maps(renderer)
    if record is not None:
        _light(renderer, record)
        record.around.place(renderer, record.indirect, record.lighting == lightings.AUTO, True)
        record.tone.start(renderer, record.indirect)
        record.names = names.take_pyvistas(renderer, record.names)
        record.warner.start(renderer)
        if record.ground is not None and there is record.indirect:
            record.ground.begin(renderer)


def _end(renderer: vtkRenderer) -> None:
    """After a frame: leave the renderer as its owner knows it."""
    record = _records.get(renderer.__this__)
    if record is not None and record.ground is not None:
        record.ground.end(renderer)
    if record is not None:
        record.warner.look(renderer, record.indirect)


def _light(renderer: vtkRenderer, record: _Record) -> None:
    """Let the lighting "auto" follow the renderer's lights, unless the pass has been set since."""
    if record.lighting != lightings.AUTO:
        return
    indirect = record.indirect
    if record.chosen is not None and _lighting_of(indirect) != record.chosen[0]:
        record.lighting = record.chosen = None
        return
    record.chosen = lightings.choose(
        renderer, indirect.GetEnvironment(), indirect.GetNumberOfAreaLights()
    )
    if _lighting_of(indirect) != record.chosen[0]:
        properties.set_property(indirect, lightings.PROPERTY, record.chosen[0])


def _lighting_of(indirect: Any) -> str:
    return lightings.PRESETS[indirect.GetLighting()]


def _has_preset(record: _Record, there: Any, lighting: Any, settings: dict[str, Any]) -> bool:
    """Return whether a preset of lights is in force after a call, other than by "auto"."""
    by_name = [value for name, value in settings.items() if lightings.is_property(name)]
    if by_name:
        lighting = by_name[0]
    elif lighting is KEEP and (there is None or record.lighting == lightings.AUTO):
        lighting = lightings.AUTO
    elif lighting is KEEP:
        lighting = _lighting_of(record.indirect)
    return lighting not in (lightings.AUTO, lightings.SCENE)


def _forget(renderer: vtkRenderer) -> _Record | None:
    record = _records.pop(renderer.__this__, None)
    if record is not None:
        for tag, _ in record.observers:
            renderer.RemoveObserver(tag)
        record.around.leave(renderer)
        record.tone.leave(renderer)
    return record


def renderers_of(target: Any) -> Iterator[vtkRenderer]:
    """Yield the renderers that a renderer, a render window or a plotter stands for.

    A window stands for all its renderers, a plotter with subplots for the active one, as with
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
    """Return where properties are looked up: the estimator, the sampler, the pass itself.

    Where the pass chooses for itself, these are what it has chosen.
    """
    automatic = indirect.GetEstimator() is None
    sampler = indirect.GetActiveSampler() if automatic else indirect.GetSampler()
    found = [indirect.GetActiveEstimator(), sampler, indirect]
    return [part for part in found if part is not None]


def _configure(
    record: _Record,
    method: Method,
    sampler: str | None,
    quality: str,
    settings: dict[str, Any],
) -> None:
    """Bring the pass to a method and set properties; keeps what a call does not mention.

    Earlier settings hold for another estimator or sampler, too, where it has them. After an error
    everything is as it was.
    """
    indirect = record.indirect
    before = indirect.GetEstimator(), indirect.GetSampler()
    estimator = indirect.GetActiveEstimator()
    preset = estimator.GetPreset()
    changed = record.method != method.name
    try:
        if changed:
            indirect.SetEstimator(wrapped.get(method.estimator)() if method.estimator else None)
            indirect.SetSampler(wrapped.get(method.sampler)() if method.sampler else None)
        presets = {name: value for name, value in settings.items() if is_preset(name)}
        if presets:
            properties.apply([indirect.GetActiveEstimator()], presets)
            if method.sampler is not None:
                own = indirect.GetActiveEstimator().GetSamplerOfPreset()
                indirect.SetSampler(own or wrapped.get(method.sampler)())
        if sampler is not None:
            indirect.SetSampler(wrapped.get(check_sampler(sampler))())
        targets = parts(indirect)
        for name in settings:
            if properties.find(targets, name) is None:
                _explain_owner(name, method, indirect.GetSampler())
        new = [target for target in targets if target not in record.configured]
        properties.apply_where_possible(new, record.settings)
        asked = properties.apply(targets, settings)
    except UsageError:
        indirect.SetEstimator(before[0])
        indirect.SetSampler(before[1])
        if estimator.GetPreset() != preset:
            estimator.SetPreset(preset)
            properties.apply_where_possible([estimator], record.settings)
        raise
    record.method, record.configured = method.name, tuple(targets)
    record.settings.update(asked)
    qualities.apply(targets, new, record.quality, quality, record.settings)
    record.quality = quality


def _explain_owner(name: str, method: Method, sampler: Any) -> None:
    """Raise when a property belongs to another method or sampler than the one in use."""

    def owns(class_name: str | None) -> bool:
        if class_name is None or not wrapped.has(class_name):
            return False
        return properties.find([wrapped.get(class_name)()], name) is not None

    for other, class_name in SAMPLERS.items():
        if owns(class_name) and (sampler is None or not sampler.IsA(class_name)):
            raise UsageError(f"property '{name}' belongs to sampler '{other}': name it, too")
    for row in METHODS.values():
        if owns(row.estimator):
            raise UsageError(
                f"property '{name}' belongs to method '{row.name}', not '{method.name}'"
            )


def as_the_scene_has_it(
    rendering: dict[str, Any], method: str, sampler: str | None, settings: dict[str, Any]
) -> tuple[str, str | None, dict[str, Any]]:
    """Return method, sampler and settings, where no method is named those of a scene file.

    Settings that are named hold beside the file's.
    """
    if method != "auto" or not rendering:
        return method, sampler, settings
    settings = {**rendering["settings"], **settings}
    return rendering["method"], sampler or rendering.get("sampler"), settings


def enable(
    target: Any,
    method: str = "auto",
    sampler: str | None = None,
    *,
    environment: Any = KEEP,
    sun: Any = KEEP,
    up: Any = KEEP,
    lighting: Any = KEEP,
    quality: Any = KEEP,
    tone_mapping: Any = KEEP,
    exposure: Any = KEEP,
    ground: Any = KEEP,
    **settings: Any,
) -> Any:
    """Switch indirect light on; returns the vtkIndirectIlluminationPass.

    `target` is a vtkRenderer, a vtkRenderWindow, a `Scene` or a PyVista plotter. For a window with several
    renderers the result is a list of passes. `method` is one of `METHODS` ("off" is `disable`, and
    gives None), `sampler` one of `SAMPLERS`; None keeps the method's own.

    `settings` are properties of the estimator, the sampler or the pass, in that order, by their
    VTK name or in lower case: ``NumberOfLights=256`` or ``number_of_lights=256``. Enumerated values
    are names: ``mode="all_texels"``. A value that is out of range is an error. ``preset="paper"`` is
    the method as published, with the paper's sampler unless `sampler` names one; other settings of
    the same call hold beside it.

    With the method "auto" these are the estimator and sampler that the pass has chosen.

    `environment` is the light of the sky: "uniform", "overcast" and "clear" (the CIE's skies) or
    "studio" (a dark room with three soft boxes), the path of an equirectangular image, a radiance
    of three numbers, a vtkEnvironmentLight, or None for none. Left out, it is that of the scene
    file from which the renderer was loaded. A `Scene` whose file names a method has that method where the
    call says "auto".

    `sun` is the sun's azimuth, clockwise from north, and its elevation, in degrees: one directional
    light with a soft shadow, and the environment "overcast" where there is none. None takes it
    away.
    `up` is the axis that is up: "x", "y", "z", "-x", "-y" or "-z"; None, the default, is the one
    nearest to the camera's view-up when the first frame is drawn. North is y where z is up, and -z
    where y is up; east is x.

    `lighting` is one of "auto", "scene" (the renderer's lights as they are), "soft", "full",
    "gentle" and "studio". "auto", which a new pass gets, is "studio" where nobody has placed lights
    in the scene: where all of the renderer's lights follow its camera, as VTK's headlight, light
    kits and PyVista's three lights do; and "scene" where somebody has placed some or set an
    environment. `report` says which, and why. Beside a sun or an environment of a call "auto"
    switches lights that follow the camera off, until `disable`; "scene" leaves them on.

    `quality` is "draft", "interactive", which a new pass has, or "final": settings for how long a
    picture may take (`qualities.QUALITIES`). Settings that a call names hold beside it.

    `tone_mapping` is None or "none", "reinhard", "exponential" or "filmic", the curves of VTK's
    vtkToneMappingPass; `exposure` the factor on light before the curve, 1 by default, or "auto":
    so that 99 % of the lit pixels are at most 1. They are for the whole picture but a plain
    background: colour bars and texts go through the curve as surfaces do.

    `ground` is True for a plane below what is visible that shows nothing but the shadows on it and
    the light that it catches, on any background; a height; the axis that points up, such as "z"; or
    an axis and a height. By itself up is the camera's in the first frame. False takes it away.

    Calling again changes the method and the settings that are given and keeps the others, where the
    method has them. After an error everything is as it was.

    A pass that the renderer has already comes back with `disable`. If it works on a picture, as
    vtkSSAAPass, PyVista's depth of field, blur and eye-dome lighting do, it stays in effect and
    works on the picture with indirect light. Others, such as vtkSSAOPass and VTK's shadows, have no
    effect meanwhile, which a warning says. With PyVista it is the same when they come later.
    """
    rendering = getattr(target, "rendering", None)
    if isinstance(rendering, dict):
        method, sampler, settings = as_the_scene_has_it(rendering, method, sampler, settings)
    row = check_method(method)
    if row.name == "off":
        words = {"environment": environment, "sun": sun, "up": up, "lighting": lighting}
        words.update(quality=quality, tone_mapping=tone_mapping, exposure=exposure, ground=ground)
        given = [*settings, *(name for name, value in words.items() if value is not KEEP)]
        given += ["sampler"] if sampler else []
        if given:
            raise UsageError(f"method 'off' has no property '{given[0]}'")
        disable(target)
        return None
    around = surroundings.check(environment, sun, up)
    tone = tones.check(tone_mapping, exposure)
    if quality is not KEEP:
        qualities.check(quality)
    place = None if ground is KEEP else grounds.from_value(ground)
    by_name = any(lightings.is_property(name) for name in settings)
    if lighting is not KEEP:
        lightings.check(lighting)
        if by_name:
            raise UsageError("lighting is given twice")
    passes = []
    for renderer in renderers_of(target):
        there = _settled(renderer)
        record = _records.get(renderer.__this__)
        if record is None or record.indirect is not there:
            record = _Record(there or wrapped.get("vtkIndirectIlluminationPass")())
        attached = environments.attached(renderer)
        if there is None and environment is KEEP and attached is not None:
            record.indirect.SetEnvironment(attached)
        record.around.check(around, _has_preset(record, there, lighting, settings), record.indirect)
        record.tone.check(tone, renderer)
        wanted = record.quality if quality is KEEP else quality
        _configure(record, row, sampler, wanted, settings)
        record.around.ask(around, record.indirect)
        record.tone.ask(tone)
        if there is None:
            for light in area_lights.attached(renderer):
                record.indirect.AddAreaLight(light)
        if by_name:
            record.lighting = record.chosen = None
        elif lighting is not KEEP or there is None:
            record.lighting = lightings.AUTO if lighting is KEEP else lighting
            record.chosen = None
            if record.lighting != lightings.AUTO:
                properties.set_property(record.indirect, lightings.PROPERTY, record.lighting)
        record.around.place(
            renderer, record.indirect, record.lighting == lightings.AUTO, False
        )
        if ground is not KEEP:
            if record.ground is not None:
                record.ground.release(renderer)
            record.ground = grounds.Ground(place) if place is not None else None
        _light(renderer, record)
        _keep(renderer, record)
        if there is None:
            _weave(renderer, record)
        else:
            record.tone.put(renderer, record.indirect)
        passes.append(record.indirect)
    if not passes:
        raise UsageError("the window has no renderer")
    return passes[0] if len(passes) == 1 else passes


def disable(target: Any) -> None:
    """Switch indirect light off again and restore the passes that were there before.

    In a chain that has been changed since, VTK's usual steps take the place of indirect light, and
    a renderer whose pass was set by somebody else since is left alone. Graphics memory is freed.
    """
    for renderer in renderers_of(target):
        record = _forget(renderer)
        if record is not None and record.ground is not None:
            record.ground.release(renderer)
        link = chain.find(renderer.GetPass())
        if link is None:
            continue
        woven = record.woven if record is not None and record.indirect is link[0] else None
        if woven is not None and woven.intact(renderer):
            chain.unweave(woven, renderer)
        else:
            chain.take_out(renderer, woven.replaced if woven is not None else None)
        window = renderer.GetRenderWindow()
        if window is not None:
            window.MakeCurrent()
            link[0].ReleaseGraphicsResources(window)


def pass_of(target: Any) -> Any:
    """Return the pass that is on, or None. `target` as for `enable`, or a pass.

    It is found wherever it is in the renderer's chain of passes, such as in a vtkSSAAPass, and
    whoever has set it.
    """
    if hasattr(target, "CopyBuffer"):
        return target
    for renderer in renderers_of(target):
        indirect = _settled(renderer)
        if indirect is not None:
            return indirect
    return None


def counters(target: Any) -> dict[str, int]:
    """Return the counters of the report of a pass that is on, without the cost of an estimated error."""
    found: dict[str, int] = json.loads(pass_of(target).GetReport(False))["counters"]
    return found


def report(target: Any) -> dict[str, Any]:
    """Return the last frame's report of a pass: what was decided, times, memory.

    `target` is a pass, or what `enable` was called with. The keys are those of the format
    ``vtkindirect.report/1``; times in milliseconds. The first report of a still picture takes 0.05 to
    1 s: it traces paths for the estimated error.
    """
    indirect = pass_of(target)
    if indirect is None:
        raise UsageError("indirect light is off, there is nothing to report")
    result: dict[str, Any] = json.loads(indirect.GetReport())
    result["lighting"] = {"used": _lighting_of(indirect), "why": "it is set"}
    for record in _records.values():
        if record.indirect is indirect and record.chosen is not None:
            used, why = record.chosen
            result["lighting"] = {"used": used, "why": f"auto: {why}"}
            result["modelled"].append({"what": f"lighting auto: {used}", "why": why})
        if record.indirect is indirect:
            result["quality"] = record.quality
            result["tone_mapping"] = record.tone.report()
            modelled, left_out = record.around.report()
            result["modelled"] += modelled
            result["left_out"] += left_out
    return result
