# SPDX-License-Identifier: BSD-3-Clause
"""What the capture costs: the geometry buffer and one light's map over VTK's own frame.

    PYTHONPATH=build/lib/python3.11/site-packages python3 Testing/Benchmark/capture.py
        [--frames N] [--size N] [--map N]

A ball of 80000 triangles at SIZE x SIZE under a spot light with a map of MAP texels squared.
Prints processor time of all threads, in which what else the machine does is not: the least of
FRAMES frames each, and their ratio with the one that is aimed at. Nothing is passed or failed
here.
"""

from __future__ import annotations

import argparse
import sys
import time

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkLightsPass,
    vtkRenderPassCollection,
    vtkSequencePass,
)

from vtkindirect import windows, wrapped

TARGET = 1.6


def scene() -> vtkRenderer:
    """Return a renderer with the ball and its light."""
    source = vtkSphereSource()
    source.SetThetaResolution(285)
    source.SetPhiResolution(143)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPositional(True)
    light.SetPosition(1, 1, 2)
    light.SetFocalPoint(0, 0, 0)
    light.SetConeAngle(30.0)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.AddLight(light)
    return renderer


def capture(*stages) -> vtkCameraPass:
    """Return a pass that draws these stages and nothing else."""
    passes = vtkRenderPassCollection()
    for stage in (vtkLightsPass(), *stages):
        passes.AddItem(stage)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    return camera


def main() -> int:
    """Measure and print; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=12, help="of each kind (default: 12)")
    parser.add_argument("--size", type=int, default=1024, help="edge of the window (default: 1024)")
    parser.add_argument("--map", type=int, default=512, help="edge of the map (default: 512)")
    words = parser.parse_args()
    if min(words.frames, words.size, words.map) < 1:
        parser.error("--frames, --size and --map must be 1 or more")

    renderer = scene()
    window = windows.render_window((words.size, words.size))
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    maps = wrapped.get("vtkReflectiveShadowMapPass")()
    maps.CachingOff()
    maps.SetResolution(words.map)
    geometry = wrapped.get("vtkGeometryBufferPass")()
    kinds = {
        "VTK's own frame": None,
        "geometry buffer": capture(geometry),
        "map and geometry buffer": capture(maps, geometry),
    }
    least = dict.fromkeys(kinds, float("inf"))
    # Not by turns: actors whose pass is another than in the frame before build their shaders anew.
    for kind, stages in kinds.items():
        renderer.SetPass(stages)
        window.Render()
        for _ in range(words.frames):
            window.WaitForCompletion()
            start = time.process_time()
            window.Render()
            window.WaitForCompletion()
            least[kind] = min(least[kind], 1e3 * (time.process_time() - start))
    renderer.SetPass(None)
    for stages in kinds.values():
        if stages:
            stages.ReleaseGraphicsResources(window)
    window.Finalize()

    plain = least["VTK's own frame"]
    print("| frame | processor time, ms | over VTK's own |\n|---|---:|---:|")
    for kind, milliseconds in least.items():
        print(f"| {kind} | {milliseconds:.1f} | {milliseconds / plain:.2f} |")
    ratio = least["map and geometry buffer"] / plain
    print(f"\nratio {ratio:.2f}, target {TARGET}: {'met' if ratio <= TARGET else 'not met'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
