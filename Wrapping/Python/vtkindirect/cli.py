# SPDX-License-Identifier: BSD-3-Clause
"""The command line ``vtk-indirect``.

A mistake in the input is one line on standard error and exit code 2; a failure at run time is one
line and exit code 1. Nothing is written unless everything went well.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import json
import os
import re
import sys
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from vtkindirect import (
    compare,
    console,
    demo,
    frames,
    images,
    lighting,
    locations,
    methods,
    options,
    settings,
    windows,
    working,
    wrapped,
)
from vtkindirect.errors import RenderError, UsageError, unknown
from vtkindirect.frames import Job
from vtkindirect.progress import Progress
from vtkindirect.scene import Scene, load_scene

PROGRAM = "vtk-indirect"
MAXIMUM_FRAMES = 100000


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        raise UsageError(message)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Take words that argparse would misread for what they are."""
        words = sys.argv[1:] if args is None else args
        return super().parse_known_args(options.joined(words), namespace)

    def _print_message(self, message: str, file: Any = None) -> None:
        console.say(message.rstrip("\n"))


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,9})x(\d{1,9})", text)
    if not match:
        raise argparse.ArgumentTypeError(
            f"'{text}' must be WIDTHxHEIGHT in pixels, such as 800x600"
        )
    width, height = int(match[1]), int(match[2])
    if not (1 <= width <= windows.LARGEST and 1 <= height <= windows.LARGEST):
        raise argparse.ArgumentTypeError(
            f"'{text}' must be from 1x1 to {windows.LARGEST}x{windows.LARGEST}"
        )
    return width, height


def _frames(text: str) -> int:
    if not re.fullmatch(r"\d{1,9}", text) or not 1 <= int(text) <= MAXIMUM_FRAMES:
        raise argparse.ArgumentTypeError(
            f"'{text}' must be a whole number from 1 to {MAXIMUM_FRAMES}"
        )
    return int(text)


def _add_lighting_argument(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--lighting",
        metavar="NAME",
        help=f"what lights the scene: {', '.join(lighting.NAMES)} (default: {lighting.AUTO}, which "
        f"is {lighting.FOLLOWING} where all lights follow the camera, as those of data files do, else "
        f"{lighting.SCENE})",
    )


def _add_scene_arguments(parser: argparse.ArgumentParser, lit: bool = True) -> None:
    """Add the arguments of a picture; `lit`: with the lighting."""
    known = ", ".join(methods.METHODS)
    parser.add_argument(
        "scene", metavar="SCENE_OR_DATA", help="a scene file (.json) or a data file that VTK reads"
    )
    parser.add_argument(
        "--method",
        default="auto",
        metavar="NAME",
        help=f"{known} (default: auto, which is the scene file's method where it names one)",
    )
    parser.add_argument(
        "--sampler",
        metavar="NAME",
        help="how virtual lights are chosen: "
        f"{', '.join(methods.SAMPLERS)} (default: the method's own)",
    )
    parser.add_argument(
        "--preset",
        metavar="NAME",
        help="robust (default), or paper: the method and its lights as published",
    )
    if lit:
        _add_lighting_argument(parser)
        options.add_arguments(parser)
        options.add_look_arguments(parser)
    parser.add_argument(
        "--size", type=_size, metavar="WxH", help="picture size in pixels (default: the scene's)"
    )
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        dest="assignments",
        metavar="PROPERTY=VALUE",
        help="set a property of the estimator, the sampler or the pass, such as NumberOfLights=256 "
        "or Mode=all_texels; can be repeated",
    )


def commands() -> dict[str, argparse.ArgumentParser]:
    """Return the parser of each command, and that of the program under its own name."""
    parser = _Parser(
        prog=PROGRAM,
        description="Real-time indirect light for VTK scenes and data.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="print versions and exit")
    known = parser.add_subparsers(dest="command", metavar="COMMAND")

    render = known.add_parser(
        "render", help="render a picture", description="Render a scene or a data file to pictures."
    )
    _add_scene_arguments(render)
    render.add_argument(
        "-o",
        "--output",
        action="append",
        default=[],
        metavar="FILE",
        help="a .png or .exr file; can be repeated (default: NAME.png in the working directory, "
        "or no picture when there is a --report). "
        "A .png of the final picture is what the window shows; a .png of another buffer is its "
        "values clamped to 0 to 1. An .exr holds the linear values, unclamped",
    )
    render.add_argument(
        "--buffer",
        default=images.FINAL,
        metavar="NAME",
        help=f"what to write: {', '.join(images.BUFFERS)}, rsm<i>.depth, rsm<i>.normal, "
        f"rsm<i>.density, with the method multiresolution {', '.join(images.SUBSPLAT_BUFFERS)}, "
        f"with the method splatting {', '.join(images.SPLAT_BUFFERS)} (default: final)",
    )
    render.add_argument(
        "--float", action="store_true", dest="full", help="store .exr in 32 bits instead of 16"
    )
    render.add_argument(
        "--frames",
        type=_frames,
        default=1,
        metavar="N",
        help="frames to render and measure, after some to warm up if N > 1, while the camera turns by "
        "less than a pixel; Caching=off measures all work in each (default: 1)",
    )
    render.add_argument(
        "--report", metavar="FILE", help="write decisions and times to a .json file"
    )
    render.set_defaults(run=_render)

    view = known.add_parser(
        "view",
        help="show an interactive window",
        description="Show a scene or a data file in a window; the key i switches indirect light.",
    )
    _add_scene_arguments(view)
    view.set_defaults(run=_view)

    show = known.add_parser(
        "demo",
        help="render the demonstration scenes in plain VTK and with indirect light",
        description="Render the demonstration scenes, each in plain VTK and with indirect light.",
    )
    show.add_argument(
        "names", nargs="*", metavar="NAME", help=f"{', '.join(locations.DEMOS)} (default: all)"
    )
    show.add_argument(
        "-o",
        "--output",
        default=".",
        metavar="DIRECTORY",
        help="where to write; made if it is not there (default: here)",
    )
    _add_lighting_argument(show)
    show.add_argument(
        "--size", type=_size, metavar="WxH", help="size of each picture (default: the scene's)"
    )
    show.set_defaults(run=_demo)

    white = known.add_parser(
        "furnace",
        help="check that no light is lost or invented",
        description="Render all surfaces white under a sky of 1. The irradiance is 1 everywhere, whatever "
        "the geometry; print how far it is from 1.",
    )
    _add_scene_arguments(white, lit=False)
    white.add_argument(
        "-o", "--output", metavar="FILE", help="a .png or .exr file of the irradiance (default: none)"
    )
    white.set_defaults(run=_furnace, lighting="scene")

    versus = known.add_parser(
        "compare",
        help="measure speed against error",
        description="Render scenes with many methods and settings; write their times and errors as "
        "tables.",
    )
    compare.add_arguments(versus, _size, _frames)
    return {PROGRAM: parser, **known.choices}


def _load(path: str, **look: Any) -> Scene:
    """Load a scene, with a bar when that takes long; prints what was decided for the user."""
    bars: list[Progress] = []

    def step(total: int, name: str) -> None:
        if not bars:
            bars.append(Progress(f"loading {Path(path).name}", total))
        bars[0].step(name)

    def show(what: str) -> None:
        for bar in bars:
            bar.show(what)

    try:
        with working.listening(show):
            scene = load_scene(path, step, **look)
    finally:
        for bar in bars:
            bar.close()
    for note in scene.notes:
        _note(note)
    return scene


def _note(text: str) -> None:
    with contextlib.suppress(OSError):  # standard error is full or closed
        print(f"{PROGRAM}: note: {text}", file=sys.stderr, flush=True)


def _note_warning(message: Warning | str, *_: object) -> None:
    """Take the place of `warnings.showwarning`, which would add a line of source code."""
    _note(" ".join(str(message).split()))


def _job(arguments: argparse.Namespace, count: int = 1) -> Job:
    """Return what to render; unknown names are errors before anything is loaded."""
    methods.check_method(arguments.method)
    if arguments.sampler is not None:
        methods.check_sampler(arguments.sampler)
    values = settings.parse(arguments.assignments)
    if arguments.preset is not None:
        if any(methods.is_preset(name) for name in values):
            raise UsageError("preset is given twice")
        values[methods.PRESET] = arguments.preset
    light = arguments.lighting
    for name in [name for name in values if lighting.is_property(name)]:
        if light is not None:
            raise UsageError("lighting is given twice")
        light = values.pop(name)
    if light is not None:
        lighting.check(light)
    said = options.parse(arguments)
    asked = [name for name, value in said.items() if (name, value) != ("ground", False)]
    if arguments.method == "off" and (values or arguments.sampler or light or asked):
        name = next(iter(values), "sampler" if arguments.sampler else "lighting" if light else "")
        raise UsageError(f"method 'off' has no property '{name or asked[0]}'")
    return Job(arguments.method, arguments.sampler, values, count, lighting=light, words=said)


def _of_scene(job: Job, scene: Scene) -> Job:
    """Return a job with the scene file's method, where the command line names none."""
    method, sampler, values = methods.as_the_scene_has_it(
        scene.rendering, job.method, job.sampler, job.settings
    )
    return dataclasses.replace(job, method=method, sampler=sampler, settings=values)


def _suited(job: Job, scene: Scene) -> Job:
    """Return a job with what suits a data file, where the command line does not say.

    VTK's own picture has no ground, and shows the data at the same place.
    """
    words = options.suited(job.words, scene)
    return dataclasses.replace(job, words={} if job.method == "off" else words)


def _picture(scene: Scene, buffer: str, job: Job, linear: bool) -> np.ndarray:
    """Return the values to write to a file of linear values, or of what the window shows."""
    if buffer == images.FINAL and not linear:
        return images.window_bytes(scene.render_window)
    if job.method == "off":
        return images.window_floats(scene.render_window)
    return images.copy_buffer(scene.renderer, buffer)


def _check_places(outputs: list[Path], scene: str) -> None:
    """Raise when a file is named twice, or is the one that the scene comes from."""
    places = [images.target_of(path) for path in outputs]
    for place in places:
        if places.count(place) > 1:
            raise UsageError(f"{place}: is named twice as an output")
        if place == images.target_of(Path(scene)):
            raise UsageError(f"{place}: is the input, it cannot be the output too")


def _render(arguments: argparse.Namespace) -> None:
    job = _job(arguments, arguments.frames)
    look = options.parse_look(arguments)
    images.check_buffer(arguments.buffer)
    if job.method == "off" and arguments.buffer != images.FINAL:
        raise UsageError(f"buffer '{arguments.buffer}': method 'off' has only the buffer 'final'")
    names = arguments.output
    if not names and not arguments.report:
        names = [f"{Path(arguments.scene).name.split('.')[0] or 'scene'}.png"]
    outputs = [images.check_output(name, images.FORMATS) for name in names]
    report_path = None
    if arguments.report:
        report_path = images.check_output(arguments.report, (".json",))
    written = [path for path in (*outputs, report_path) if path is not None]
    _check_places(written, arguments.scene)

    scene = _load(arguments.scene, **look)
    job = _suited(_of_scene(job, scene), scene)
    window = frames.open_window(scene, arguments.size)
    with Progress(f"rendering {scene.name}", job.all_frames) as bar:
        report = frames.render(scene, window, job, bar.step)
    if job.method != "off":
        for entry in report["modelled"]:
            if entry["what"] == frames.DELEGATE_ALONE:
                _note(f"no indirect light, {entry['what']} drew the picture: {entry['why']}")
        for entry in report["left_out"]:
            if entry["what"] == frames.NO_INDIRECT_LIGHT:
                _note(f"no indirect light: {entry['why']}")
    pictures = [
        _picture(scene, arguments.buffer, job, images.ending(path, images.FORMATS) == ".exr")
        for path in outputs
    ]
    for path, values in zip(outputs, pictures):
        images.write_image(path, values, arguments.full)
    if report_path is not None:
        images.write_text(report_path, json.dumps(report, indent=2) + "\n")
    # If standard output has one of these files, it has nothing else.
    if not any(map(images.is_stdout, written)):
        for path in written:
            console.say(os.path.abspath(path))


def _view(arguments: argparse.Namespace) -> None:
    job = _job(arguments)
    look = options.parse_look(arguments)
    if not windows.has_display():
        windows.render_window(offscreen=False)  # raises and says why
    from vtkindirect import viewer

    scene = _load(arguments.scene, **look)
    job = _of_scene(job, scene)
    lit = job.method != "off"
    job = job if lit else dataclasses.replace(job, method="auto")
    viewer.view(scene, _suited(job, scene), lit, arguments.size)


def _furnace(arguments: argparse.Namespace) -> None:
    from vtkindirect import furnace

    if arguments.method == "off":
        raise UsageError("method 'off' has no irradiance")
    job = _job(arguments)
    output = images.check_output(arguments.output, images.FORMATS) if arguments.output else None
    if output is not None:
        _check_places([output], arguments.scene)
    scene = _load(arguments.scene)
    job = _of_scene(job, scene)
    window = frames.open_window(scene, arguments.size)
    with Progress(f"furnace of {scene.name}", job.all_frames) as bar:
        found = furnace.measure(scene, window, job, bar.step)
    if output is not None:
        images.write_image(output, found.irradiance, False)
    if output is None:
        console.say(found.line(scene.name))
    elif not images.is_stdout(output):
        console.say(f"{found.line(scene.name)}\n{os.path.abspath(output)}")


def _demo(arguments: argparse.Namespace) -> None:
    names = list(dict.fromkeys(arguments.names)) or list(locations.DEMOS)
    for name in names:
        if name not in locations.DEMOS:
            raise UsageError(unknown("demonstration", name, locations.DEMOS))
    methods.check_method("auto")
    if arguments.lighting is not None:
        lighting.check(arguments.lighting)
    wrapped.get("vtkIndirectIlluminationPass")
    directory = Path(arguments.output)
    images.check_directory(directory if directory.exists() else directory.absolute().parent)
    steps = 2 * (demo.FRAMES + 1)
    for index, name in enumerate(names):
        scene = _load(str(locations.demo_scene(name)))
        with Progress(f"{name} ({index + 1} of {len(names)})", steps) as bar:
            line = demo.run(scene, directory, arguments.size, bar.step, arguments.lighting)
        console.say(line)


def _versions() -> str:
    from vtkmodules.vtkCommonCore import vtkVersion

    from vtkindirect import __version__

    missing = [name for name in wrapped.MODULES if wrapped.missing(name)]
    without = f", without {', '.join(missing)}" if missing else ""
    return f"{PROGRAM} {__version__} with VTK {vtkVersion.GetVTKVersion()}{without}"


Comparison = Callable[[argparse.Namespace, Callable[[str], Scene]], None]


def _dispatch(words: Sequence[str], comparison: Comparison) -> None:
    arguments = commands()[PROGRAM].parse_args(words)
    if arguments.version:
        console.say(_versions())
    elif arguments.command is None:
        raise UsageError("a command is needed: render, view, demo, furnace or compare (see --help)")
    elif arguments.command == "compare":
        comparison(arguments, _load)
    else:
        arguments.run(arguments)


def main(words: Sequence[str] | None = None, comparison: Comparison = compare.run) -> int:
    """Run the command line; returns the exit code. `comparison` does the command ``compare``."""
    os.environ.setdefault("EGL_LOG_LEVEL", "fatal")  # what EGL tries is in our own error
    try:
        with warnings.catch_warnings():
            warnings.showwarning = _note_warning  # type: ignore[assignment]
            _dispatch(sys.argv[1:] if words is None else words, comparison)
    except UsageError as error:
        code, text = 2, str(error)
    except (RenderError, ImportError) as error:
        code, text = 1, str(error)
    except KeyboardInterrupt:
        code, text = 130, "interrupted"
    except MemoryError:
        code, text = 1, "out of memory"
    except Exception as error:  # a defect of this program; still one line
        if os.environ.get("VTKINDIRECT_TRACEBACK"):
            raise
        code, text = 1, f"internal error: {type(error).__name__}: {error}"
    else:
        return 0
    with contextlib.suppress(OSError):
        print(f"{PROGRAM}: error: {' '.join(text.split())}", file=sys.stderr, flush=True)
    return code
