# SPDX-License-Identifier: BSD-3-Clause
"""Chains of render passes: finds the project's pass in one, puts it in, takes it out.

VTK's effects that work on a picture (antialiasing, blur, depth of field, eye-dome lighting) have a
delegate that draws that picture. Indirect light is such a delegate: it takes the place of the pass
that draws the scene, at the end of the chain. Passes that make shadows or occlusion of their own
cannot be in one picture with it and are left out meanwhile.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderPass

PASS = "vtkIndirectIlluminationPass"

# The pass draws the same as these passes, in the order that VTK draws it.
_PLAIN = frozenset(
    (
        "vtkCameraPass",
        "vtkSequencePass",
        "vtkRenderStepsPass",
        "vtkLightsPass",
        "vtkDefaultPass",
        "vtkOpaquePass",
        "vtkTranslucentPass",
        "vtkVolumetricPass",
        "vtkOverlayPass",
    )
)

# The part of another pass of this list; one name is enough.
_PARTS = frozenset(("vtkShadowMapBakerPass",))

_WHY_LEFT_OUT = {
    "vtkSSAOPass": "it darkens corners by a guess at the light that indirect light computes",
    "vtkShadowMapPass": "indirect light comes with shadows, see the setting Shadows",
}


def _children(parent: Any) -> Iterator[tuple[str, Any]]:
    """Yield the passes that a pass runs, each with the name of the property that holds it."""
    if parent.IsA("vtkSequencePass"):
        passes = parent.GetPasses()
        for index in range(passes.GetNumberOfItems() if passes is not None else 0):
            yield "Passes", passes.GetItemAsObject(index)
        return
    for name in dir(parent):
        if name.startswith("Get") and name.endswith(("Pass", "Sequence")):
            child = getattr(parent, name)()
            if isinstance(child, vtkRenderPass):
                yield name[3:], child


def links(top: Any) -> Iterator[tuple[Any, str, Any]]:
    """Yield (pass, property of its parent, parent) for a pass and all below it, once each.

    The passes that the project's own pass delegates to are its own affair.
    """
    seen = set()
    waiting = [(top, "", None)] if top is not None else []
    while waiting:
        found = waiting.pop()
        if found[0].__this__ in seen:
            continue
        seen.add(found[0].__this__)
        yield found
        if not found[0].IsA(PASS):
            waiting += [(child, name, found[0]) for name, child in _children(found[0])]


def find(top: Any) -> tuple[Any, str, Any] | None:
    """Return the link to the project's pass in the chain that begins with `top`, if it is there."""
    for link in links(top):
        if link[0].IsA(PASS):
            return link
    return None


def _works_on_a_picture(a_pass: Any) -> bool:
    return isinstance(a_pass, (opengl.vtkImageProcessingPass, opengl.vtkSSAAPass)) and hasattr(
        a_pass, "SetDelegatePass"
    )


def _effects(top: Any) -> tuple[list[Any], Any]:
    """Split a chain into the passes that work on a picture and the one that draws the scene."""
    effects: list[Any] = []
    while top is not None and _works_on_a_picture(top) and top not in effects:
        effects.append(top)
        top = top.GetDelegatePass()
    return effects, top


@dataclass
class Woven:
    """A chain with the project's pass in it, and how to undo that.

    `replaced` is the pass that drew the scene, or None; `left_out` are the class names of passes
    that have no effect now.
    """

    before: Any
    top: Any
    replaced: Any
    left_out: list[str]
    # Each pass that has another delegate now, this delegate, and the one before.
    delegates: list[tuple[Any, Any, Any]] = field(default_factory=list)

    def intact(self, renderer: vtkRenderer) -> bool:
        """Return whether the renderer's chain is still as it was woven."""
        return renderer.GetPass() is self.top and all(
            effect.GetDelegatePass() is now for effect, now, _ in self.delegates
        )


def weave(before: Any, indirect: Any) -> Woven:
    """Put the project's pass into a chain, in place of what draws the scene; None is no chain.

    The chain's new begin is `top`, which the caller gives to the renderer.
    """
    effects, base = _effects(before)
    kept = [effect for effect in effects if effect.GetClassName() not in _WHY_LEFT_OUT]
    names = [effect.GetClassName() for effect in effects if effect not in kept]
    names += [found.GetClassName() for found, _, _ in links(base)]
    left_out = [name for name in dict.fromkeys(names) if name not in _PLAIN | _PARTS]
    woven = Woven(before, (kept or [indirect])[0], base, left_out)
    for effect, following in zip(kept, [*kept[1:], indirect]):
        woven.delegates.append((effect, following, effect.GetDelegatePass()))
        effect.SetDelegatePass(following)
    return woven


def unweave(woven: Woven, renderer: vtkRenderer) -> None:
    """Bring the chain back that there was before `weave`."""
    for effect, _, delegate in woven.delegates:
        effect.SetDelegatePass(delegate)
    renderer.SetPass(woven.before)


def take_out(renderer: vtkRenderer, replacement: Any) -> None:
    """Take the project's pass out of a renderer's chain, whoever put it there.

    At the end of a chain `replacement`, or else VTK's usual steps, draw the scene.
    """
    link = find(renderer.GetPass())
    if link is None:
        return
    begins = link[2] is None
    _replace(renderer, link, replacement or (None if begins else opengl.vtkRenderStepsPass()))


def _replace(renderer: vtkRenderer, link: tuple[Any, str, Any], replacement: Any) -> None:
    """Put another pass in the place of one that `links` has found."""
    there, name, parent = link
    if parent is None:
        renderer.SetPass(replacement)
    elif name == "Passes":
        passes = parent.GetPasses()
        for index in range(passes.GetNumberOfItems()):
            if passes.GetItemAsObject(index) is there:
                passes.ReplaceItem(index, replacement)
        parent.Modified()
    else:
        getattr(parent, f"Set{name}")(replacement)


# Effects that look up the depth of what they work on, of which a curve for tones leaves nothing.
_WITH_DEPTH = frozenset(("vtkEDLShading", "vtkDepthOfFieldPass"))

_ANTIALIASING = frozenset(("vtkOpenGLFXAAPass", "vtkSSAAPass"))


def inside_of_curve(renderer: vtkRenderer, indirect: Any) -> Any:
    """Return what a curve for tones goes around: the project's pass, or effects that need depth.

    All other effects go around the curve, because their pictures have no values above 1.
    """
    effects, _ = _effects(renderer.GetPass())
    return next((found for found in effects if found.GetClassName() in _WITH_DEPTH), indirect)


def antialiases(renderer: vtkRenderer, but: Any = None) -> bool:
    """Return whether an effect in a renderer's chain, but one, antialiases the picture."""
    effects, _ = _effects(renderer.GetPass())
    return any(
        found.GetClassName() in _ANTIALIASING for found in effects if found is not but
    )


def put_around(renderer: vtkRenderer, inner: Any, effect: Any) -> None:
    """Put a pass that works on a picture around another one of the renderer's chain."""
    (link,) = [found for found in links(renderer.GetPass()) if found[0] is inner]
    effect.SetDelegatePass(inner)
    _replace(renderer, link, effect)


def take_off(renderer: vtkRenderer, effect: Any) -> None:
    """Undo `put_around`, where the effect is still in the renderer's chain."""
    for link in [found for found in links(renderer.GetPass()) if found[0] is effect]:
        _replace(renderer, link, effect.GetDelegatePass())
    effect.SetDelegatePass(None)


def why_left_out(name: str) -> str:
    """Return why a pass of a class has no effect while indirect light is on."""
    return _WHY_LEFT_OUT.get(name, "it draws the scene itself, in place of indirect light")


def has_pyvistas_effects(renderer: vtkRenderer) -> bool:
    """Return whether a renderer's chain is one that PyVista has put together for its own effects.

    It ends in a camera pass around a sequence that begins with VTK's usual steps.
    """
    _, base = _effects(renderer.GetPass())
    sequence = base.GetDelegatePass() if isinstance(base, opengl.vtkCameraPass) else None
    if not is_pyvistas(renderer) or sequence is None or not sequence.IsA("vtkSequencePass"):
        return False
    passes = sequence.GetPasses()
    return passes is not None and isinstance(passes.GetItemAsObject(0), opengl.vtkRenderStepsPass)


def is_pyvistas(renderer: vtkRenderer) -> bool:
    """Return whether a renderer is of PyVista's own class."""
    return type(renderer).__module__.partition(".")[0] == "pyvista"
