# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the papers, with this project's scenes: papers.py [NAME...] [-o DIRECTORY].

Draws the figures of Documentation/papers.md that no other program draws, by the preset "paper" of
each method unless a panel says otherwise. Data is drawn with a gamma of 2.2 at one exposure a figure.
"""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import plot
import random_walk
import vtkindirect
from vtkindirect import frames, images, references
from vtkindirect.frames import Job

ROOT = Path(__file__).resolve().parents[2]
DIRECTORY = ROOT / "Documentation" / "papers"
SIZE = (320, 240)
Panel = tuple[str, np.ndarray]


def scene_of(name: str) -> Path:
    """The file of a scene."""
    return ROOT / "Testing" / "Scenes" / f"{name}.json"


def render(
    name: str, method: str, buffer: str = "final", sampler: str | None = None,
    size: tuple[int, int] = SIZE, specular: tuple[float, float] | None = None, **settings: Any,
) -> np.ndarray:  # fmt: skip
    """Render a scene and return a buffer of three channels, top row first.

    `specular`: coefficient and power of Phong's model, for all that stands in front of ground and wall.
    """
    scene = vtkindirect.load_scene(scene_of(name))
    if specular is not None:
        for part, actor in scene.actors.items():
            if part not in ("ground", "wall"):
                actor.GetProperty().SetSpecular(specular[0])
                actor.GetProperty().SetSpecularPower(specular[1])
    window = frames.open_window(scene, size)
    frames.render(scene, window, Job(method, sampler, settings))
    found = images.copy_buffer(scene.renderer, buffer)
    window.Finalize()
    return np.repeat(found, 3, axis=2)[::-1] if found.shape[2] == 1 else found[::-1, :, :3]


def stored(name: str, layer: str) -> np.ndarray:
    """A path traced image, top row first."""
    found = references.read_layer(ROOT / "Testing" / "Reference" / "data" / f"{name}.exr", layer)
    if found is None:
        raise SystemExit(f"papers.py: {name}.exr has no layer {layer}")
    return found[::-1, :, :3]


def size_of(name: str) -> tuple[int, int]:
    """Width and height of a scene's path traced images."""
    height, width = stored(name, references.names_of(vtkindirect.load_scene(scene_of(name)))[0]).shape[:2]
    return width, height


def shown(values: np.ndarray, brightest: float) -> np.ndarray:
    """Values up to `brightest` as a picture."""
    return np.clip(values / brightest, 0.0, 1.0) ** (1.0 / 2.2)


def compare(panels: list[Panel]) -> list[Panel]:
    """Give pictures of irradiance one exposure: 1.5 times the 95th percentile of the last one."""
    brightest = 1.5 * float(np.percentile(panels[-1][1], 95))
    return [(title, shown(values, brightest)) for title, values in panels]


def draw(rows: list[list[Panel]], path: Path) -> None:
    """Draw panels under their titles, in rows."""
    pyplot = plot.require_plots()
    columns = max(len(row) for row in rows)
    figure, axes = pyplot.subplots(
        len(rows), columns, squeeze=False, figsize=(2.6 * columns, 2.2 * len(rows))
    )
    for line, row in zip(axes, rows):
        for axis in line:
            axis.axis("off")
        for axis, (title, values) in zip(line, row):
            axis.imshow(np.clip(values, 0.0, 1.0), interpolation="nearest")
            axis.set_title(title, fontsize=8)
    figure.tight_layout(pad=0.4)
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=100, bbox_inches="tight", pad_inches=0.05)
    pyplot.close(figure)
    # 256 colours take a third of the space.
    Image.open(drawn).convert("RGB").quantize(256).save(path, optimize=True)


# Nichols and Wyman 2009, multiresolution splatting ------------------------------------------------


def subsplats() -> list[list[Panel]]:
    """Figure 1: direct light, subsplats, direct and indirect light."""
    return [[
        ("direct light", render("brain", "multiresolution", preset="paper", IndirectScale=0.0)),
        ("subsplats", render("brain", "multiresolution", "subsplat.outline", preset="paper")),
        ("direct and indirect light", render("brain", "multiresolution", preset="paper")),
    ]]  # fmt: skip


def map_channels() -> list[list[Panel]]:
    """Figure 2: the parts of a reflective shadow map."""
    found = []
    for title, name in (("distance", "depth"), ("normal", "normal"), ("reflected flux", "density")):
        values = render("cornell_box", "gather", f"rsm0.{name}", ReflectiveShadowMapResolution=256)
        lowest = -1.0 if name == "normal" else 0.0
        highest = 1.0 if name == "normal" else float(values.max())
        found.append((title, (values - lowest) / (highest - lowest)))
    return [found]


def phong() -> list[list[Panel]]:
    """Figure 6: an object with Phong's model, indirect light that it reflects in its lobe, and all light."""
    def one(buffer: str = "final", **settings: Any) -> np.ndarray:
        return render("frog", "multiresolution", buffer, size=(480, 360), preset="paper",
                      specular=(0.5, 25.0), **settings)  # fmt: skip

    glossy = one("glossy")
    return [[
        ("direct light", one(IndirectScale=0.0)),
        ("indirect light in the lobe, scaled", shown(glossy, float(np.percentile(glossy, 99.5)))),
        ("direct and all indirect light", one()),
    ]]  # fmt: skip


def thresholds() -> list[list[Panel]]:
    """Figure 9: four scenes, direct light, two thresholds, and surface detail."""
    rows = []
    for name in ("brain", "frog", "protein", "room_fire"):
        def one(name: str = name, **settings: Any) -> np.ndarray:
            return render(name, "multiresolution", preset="paper", **settings)

        rows.append([
            (f"{name}: direct light", one(IndirectScale=0.0)),
            ("normal threshold 0.2", one(NormalThreshold=0.2)),
            ("normal threshold 1.5", one(NormalThreshold=1.5)),
            ("1.5, surface detail 0.5", one(NormalThreshold=1.5, SurfaceDetail=0.5)),
        ])  # fmt: skip
    return rows


def form_factors() -> list[list[Panel]]:
    """Equation 1: lights as patches and as points, beside path tracing."""
    rows = []
    for name in ("contact_corner", "cornell_box"):
        size = size_of(name)

        def one(name: str = name, size: tuple[int, int] = size, **settings: Any) -> np.ndarray:
            return render(
                name, "multiresolution", "irradiance", size=size, preset="paper", **settings
            )

        rows.append(compare([
            (f"{name}: patches", one()),
            ("points, equation 1", one(FormFactor="point")),
            ("path traced, one bounce", stored(name, "R2")),
        ]))  # fmt: skip
    return rows


# Papaioannou 2011, radiance hints -----------------------------------------------------------------


def hint_scenes() -> list[list[Panel]]:
    """Figures 1 and 9: two bounces by hints in six scenes."""
    names = ("cornell_box", "apartment_living", "room_fire", "two_rooms", "many_objects", "frog")
    found = [(name, render(name, "hints", preset="paper", NumberOfBounces=2)) for name in names]
    return [found[:3], found[3:]]


def hint_orders() -> list[list[Panel]]:
    """Figure 3: three bounces with harmonics of order 2 and 3, beside path tracing."""
    size = size_of("apartment_living")

    def one(**settings: Any) -> np.ndarray:
        return render(
            "apartment_living", "hints", "irradiance", size=size, NumberOfBounces=3, **settings
        )

    rows = []
    for preset in ("paper", "robust"):
        rows.append(compare([
            (f"{preset}, order 2", one(preset=preset, Order=2)),
            (f"{preset}, order 3", one(preset=preset, Order=3)),
            ("path traced, all bounces", stored("apartment_living", "R3")),
        ]))  # fmt: skip
    return rows


def hint_depth() -> list[list[Panel]]:
    """Figures 5 and 7: a wall that no light sees, without and with the eye's depth."""
    def one(**settings: Any) -> np.ndarray:
        return render("two_rooms", "hints", "irradiance", size=(240, 240), NumberOfBounces=1, **settings)

    return [compare([
        ("paper", one(preset="paper")),
        ("paper, eye's depth hides", one(preset="paper", DepthOcclusion=True)),
        ("robust: voxels hide", one(preset="robust")),
        ("path traced, one bounce", stored("two_rooms", "R2")),
    ])]  # fmt: skip


def hint_extent() -> list[list[Panel]]:
    """Figure 6: a large flat scene with few hints along its height."""
    return [[
        (f"{x} x {y} x {z} hints", render("many_objects", "hints", preset="paper",
                                          GridResolution=(x, y, z), NumberOfBounces=2))
        for x, y, z in ((8, 8, 3), (16, 16, 3), (32, 32, 3))
    ]]  # fmt: skip


def hint_parameters() -> list[list[Panel]]:
    """Figure 8: hints, samples, and range of bounces, beside path tracing."""
    size = size_of("cornell_box")
    truth = ("path traced", stored("cornell_box", "R3"))

    def one(**settings: Any) -> np.ndarray:
        settings = {"NumberOfBounces": 3, "NumberOfSamples": 40, **settings}
        return render("cornell_box", "hints", "irradiance", size=size, preset="paper", **settings)

    rows = []
    for name, values in (
        ("GridResolution", ((4, 4, 4), (8, 8, 8), (16, 16, 16))),
        ("NumberOfSamples", (12, 40, 160)),
        ("BounceRange", (0.2, 0.5, 1.0)),
        ("MapCoverage", (0.1, 0.5, 0.9)),
    ):
        panels = [(f"{name} {value}", one(**{name: value})) for value in values]
        rows.append(compare([*panels, truth]))
    return rows


# Dachsbacher and Stamminger 2006, splatting -------------------------------------------------------


def instant_radiosity() -> list[list[Panel]]:
    """Figure 6: 1000 lights of a quasi-random walk, without and with a depth map each, and path tracing."""
    scene = vtkindirect.load_scene(scene_of("cornell_box"))
    truth = stored("cornell_box", "R3")
    frames.open_window(scene, truth.shape[1::-1])
    pictures, light = [], []
    for name, visibility in (("nothing hides them", "none"), ("each with a depth map", "maps")):
        values = random_walk.render(scene, visibility, lights=1000, bounces=16)
        pictures.append((f"1000 lights, {name}", values[::-1] / 255.0))
        values = images.copy_buffer(scene.renderer, "irradiance")[::-1, :, :3]
        light.append((f"indirect light, {name}", values))
    scene.render_window.Finalize()
    taken = shown(np.maximum(light[0][1] - light[1][1], 0.0), float(light[0][1].max()))
    pictures.append(("light that the depth maps take away", taken))
    return [pictures, compare([*light, ("path traced, all bounces", truth)])]


def occlusion() -> list[list[Panel]]:
    """Figure 13: 256 even lights as they are, and times their ambient occlusion."""
    rows = []
    for name in ("cornell_box", "brain"):
        def one(name: str = name, **settings: Any) -> np.ndarray:
            return render(name, "splatting", sampler="uniform", preset="paper", NumberOfLights=256, **settings)

        rows.append([
            (f"{name}: even lights", one()),
            ("times ambient occlusion", one(AmbientOcclusion=True)),
            ("importance, 768 lights", render(name, "splatting", preset="paper")),
        ])  # fmt: skip
    return rows


# Sloan et al. 2007, sums over spheres -------------------------------------------------------------


def operators() -> list[list[Panel]]:
    """Figure 5: light of spheres by their middle, averaged, and exact."""
    name = "sky_particles"
    size = size_of(name)

    def one(buffer: str, **settings: Any) -> np.ndarray:
        settings = {"preset": "paper", "ReceiverStep": 1, **settings}
        return render(name, "proxies", buffer, size=size, **settings)

    return [compare([
        ("bounce: middle (Eq 13)", one("bounce", IndirectLight="middle")),
        ("averaged (Eq 15)", one("bounce", IndirectLight="averaged")),
        ("exact (Eq 17)", one("bounce", IndirectLight="exact")),
        ("robust: shadowed", one("bounce", preset="robust")),
        ("path traced, all bounces", stored(name, "S3") - stored(name, "S1")),
    ])]  # fmt: skip


def receivers() -> list[list[Panel]]:
    """Figures 7 and 8: fewer receivers, beside path tracing."""
    rows = []
    for name in ("sky_protein", "sky_frog"):
        size = size_of(name)
        panels = [
            (f"{name}: 1 / {step * step} {upsampling}",
             render(name, "proxies", "sky", size=size, preset="paper", ReceiverStep=step,
                    Upsampling=upsampling))
            for step, upsampling in (
                (1, "bilateral"), (4, "bilateral"), (4, "bilinear"), (8, "bilateral")
            )
        ]  # fmt: skip
        rows.append(compare([*panels, ("path traced", stored(name, "S1"))]))
    return rows


def bleeding() -> list[list[Panel]]:
    """Figure 9: without and with light that spheres send."""
    return [[
        (f"{name}: {'with' if on != 'off' else 'without'} light of spheres",
         render(name, "proxies", preset="paper", IndirectLight=on))
        for name in ("sky_protein", "sky_particles") for on in ("off", "averaged")
    ]]  # fmt: skip


FIGURES: dict[str, Callable[[], list[list[Panel]]]] = {
    "multiresolution_1": subsplats,
    "multiresolution_2": map_channels,
    "multiresolution_6": phong,
    "multiresolution_9": thresholds,
    "multiresolution_equation_1": form_factors,
    "hints_1_9": hint_scenes,
    "hints_3": hint_orders,
    "hints_5_7": hint_depth,
    "hints_6": hint_extent,
    "hints_8": hint_parameters,
    "splatting_6": instant_radiosity,
    "splatting_13": occlusion,
    "proxies_5": operators,
    "proxies_7_8": receivers,
    "proxies_9": bleeding,
}


def main() -> int:
    """Draw the figures that the command line names, or all; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(FIGURES))
    parser.add_argument("-o", "--output", type=Path, default=DIRECTORY, metavar="DIRECTORY")
    words = parser.parse_args()
    for name in words.names:
        if name not in FIGURES:
            parser.error(f"there is no figure '{name}'; known: {', '.join(FIGURES)}")
    words.output.mkdir(parents=True, exist_ok=True)
    for name in words.names or FIGURES:
        path = words.output / f"{name}.png"
        draw(FIGURES[name](), path)
        print(path, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
