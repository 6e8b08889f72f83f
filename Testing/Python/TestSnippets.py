# SPDX-License-Identifier: BSD-3-Clause
"""Every block of code on every page is run, or listed here with the reason why it is not."""

import io
import os
import re
import shlex
import unittest
from contextlib import redirect_stderr, redirect_stdout
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkNIFTIImageReader, vtkNIFTIImageWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import support
import vtkindirect
from vtkindirect import cli, document, plotter, sweep, windows, wrapped
from vtkindirect import scene as scenes

WHY_NOT = support.why_no_rendering()
WHY_NO_PYVISTA = support.why_no_pyvista()

PAGES = [
    support.SOURCE / "README.md",
    support.SOURCE / "CONTRIBUTING.md",
    *sorted((support.SOURCE / "Documentation").rglob("*.md")),
]

CXX = "a fragment of C++; the tests build and run Examples/Cxx"
FORMULA = "a formula"
ERROR = "what an error looks like; Python.CommandLine makes such ones"

PACK = "it packs for minutes; Benchmark.pack and Benchmark.card do that in small"
BENCHMARKS = "hours of benchmarks that make the page itself"

# (page, how the block begins) -> why it is not run.
NOT_RUN = {
    ("README.md", "./bootstrap demo"): "it runs these tests",
    ("README.md", "cmake --preset release"): "it builds what is tested",
    ("README.md", "vtkNew<vtkIndirectIlluminationPass> pass;"): CXX,
    ("CONTRIBUTING.md", "./bootstrap test"): "it runs these tests",
    ("CONTRIBUTING.md", "cmake --preset dev"): "it builds the project a second time",
    ("CONTRIBUTING.md", "sudo Testing/Compatibility/run"): "it installs another Debian",
    ("CONTRIBUTING.md", "Testing/Benchmark/gpu pack"): PACK,
    ("CONTRIBUTING.md", "Testing/Images/renew"): "it renders what ctest -L image compares",
    ("CONTRIBUTING.md", "LD_PRELOAD="): "it runs tests; Drivers.garbage runs some of them so",
    ("Documentation/architecture.md", "scene ─▶ Plan"): "a drawing",
    ("Documentation/architecture.md", "VTK_INDIRECT_PATHS="): "Contract.ChoicesTake sets each of them",
    ("Documentation/command-line.md", "Testing/Benchmark/comparison.py"): (
        "it needs minutes; Benchmark.comparison runs such words on a small scene"
    ),
    ("Documentation/gpu.md", "Testing/Benchmark/gpu pack"): PACK,
    ("Documentation/gpu.md", "./gpu list"): "Benchmark.card runs such lines",
    ("Documentation/methods/glossy-senders.md", "E += "): "a formula",
    ("Documentation/guide.md", "vtkNew<vtkEnvironmentLight> sky;"): CXX,
    ("Documentation/guide.md", "vtkNew<vtkAreaLight> window;"): CXX,
    ("Documentation/guide.md", "vtkIndirectIlluminationPass::SetLightRadius"): CXX,
    ("Documentation/guide.md", "pass->SetLightingToStudio();"): CXX,
    ("Documentation/guide.md", "vtkNew<vtkMultiresolutionSplattingPass>"): CXX,
    ("Documentation/guide.md", "splatting->SetPresetToPaper();"): CXX,
    ("Documentation/guide.md", "vtkNew<vtkInformation> keys;"): CXX,
    ("Documentation/guide.md", "keys->Set(vtkIndirectIlluminationPass::CATCHES_LIGHT()"): CXX,
    ("Documentation/papers.md", "Testing/Benchmark/papers.py"): (
        "it needs minutes; Benchmark.pages looks for its figures"
    ),
    ("Documentation/headless.md", "vtkNew<vtkEGLHeadlessRenderWindow>"): CXX,
    ("Documentation/headless.md", "vtkIndirectHeadlessFactory::Enable();"): CXX,
    ("Documentation/headless.md", "window->Initialize();"): CXX,
    ("Documentation/headless.md", "EGL device 0: hardware"): "what a machine with two cards prints",
    ("Documentation/methods/area-lights.md", "Phong: ks"): FORMULA,
    ("Documentation/methods/gather.md", "E(x) ="): FORMULA,
    ("Documentation/methods/light-tree.md", "w → w (1 + b)"): FORMULA,
    ("Documentation/methods/light-tree.md", "along its plane"): FORMULA,
    ("Documentation/methods/random-walk.md", "first bounce    B A ="): FORMULA,
    ("Documentation/methods/random-walk.md", "later bounces   B A ="): FORMULA,
    ("Documentation/methods/splatting.md", "E(x) ="): FORMULA,
    ("Documentation/methods/splatting.md", "I_low ="): FORMULA,
    ("Documentation/methods/path-correction.md", "Σ share("): FORMULA,
    ("Documentation/methods/multiresolution-splatting.md", "    E(x) ="): FORMULA,
    ("Documentation/methods/radiance-hints.md", "c_lm ="): FORMULA,
    ("Documentation/methods/sphere-proxies.md", "g = Σ log"): FORMULA,
    ("Documentation/openexr.md", "vtkNew<vtkOpenEXRWriter>"): CXX,
    ("Documentation/openexr.md", "vtkNew<vtkOpenEXRReader>"): CXX,
    ("Documentation/radiometry.md", "F ="): FORMULA,
    ("Documentation/radiometry.md", "I_p ="): FORMULA,
    ("Documentation/radiometry.md", "B A ="): FORMULA,
    ("Documentation/reference.md", "Testing/Reference/make_environment"): (
        "it installs a path tracer and runs it for hours"
    ),
    ("Documentation/scene-files.md", "corner.json: actors[1]"): ERROR,
    ("Documentation/speed-vs-error.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/speed-vs-error/benchmarks.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/speed-vs-error/convergence.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/speed-vs-error/hints.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/speed-vs-error/sky.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/speed-vs-error/spheres.md", "Testing/Benchmark/report"): BENCHMARKS,
    ("Documentation/tutorial.md", "#include"): CXX,
    ("Documentation/tutorial.md", "vtkNew<vtkLight> lamp;"): CXX,
    ("Documentation/tutorial.md", "cmake -S Examples/Cxx"): "Install.Consume builds Examples/Cxx",
}

# Command -> why lines with it are checked for their words only.
LINES_NOT_RUN = {
    "view": "it shows a window until somebody closes it",
    "demo": "Python.Demos runs it, which takes half a minute",
}

# Words that make a line take seconds; the pages name what users would want.
FOR_SPEED = {
    "furnace": ["--size", "64x48"],
    "render": ["--size", "64x48"],
    "compare": ["--size", "48x48", "--frames", "2", "--reference-python", "none"],
}
# The same for lines with a word: all texels of a map of the default's size are a quarter million.
FOR_SPEED_OF_A_WORD = {"Mode=all_texels": ["--set", "ReflectiveShadowMapResolution=64"]}


class Block(NamedTuple):
    page: str
    language: str
    text: str

    @property
    def commands(self) -> list[list[str]]:
        """The words of each line that runs vtk-indirect."""
        lines = re.findall(r"^(?:[\w./]*/)?vtk-indirect (.*)$", self.text, re.MULTILINE)
        return [shlex.split(line, comments=True) for line in lines]

    @property
    def name(self) -> str:
        return f"{self.page}: {self.text.splitlines()[0]}"

    def reason(self) -> str | None:
        """Return why the block is not run, from the list, or None."""
        for (page, begin), why in NOT_RUN.items():
            if page == self.page and self.text.startswith(begin):
                return why
        return None


def blocks(page: Path) -> list[Block]:
    """Return the blocks between fences and those that are indented by four."""
    name = page.relative_to(support.SOURCE).as_posix()
    found: list[Block] = []
    fence, lines, before = None, [], ""
    for line in [*page.read_text(encoding="utf-8").splitlines(), ""]:
        if fence is not None:
            if line.startswith("```"):
                found.append(Block(name, fence, "\n".join(lines)))
                fence, lines = None, []
            else:
                lines.append(line)
        elif line.startswith("```"):
            fence = line[3:].strip()
        elif line.startswith("    ") and (lines or not before.strip()):
            lines.append(line[4:])
        elif lines:
            found.append(Block(name, "", "\n".join(lines)))
            lines = []
        before = line
    return found


def with_component(kind: type) -> type:
    """Return a class of plotters with the component as later versions of PyVista have it."""

    class Plotter(kind):
        indirect = cached_property(plotter.IndirectComponent)

        def close(self) -> None:
            self.indirect.__plotter_close__()
            super().close()

    return Plotter


ALL = [block for page in PAGES for block in blocks(page)]


class Every(support.DirectoryTest):
    def test_block_is_run_or_listed(self) -> None:
        for block in ALL:
            kinds = [
                bool(block.commands),
                block.language == "python",
                block.text.startswith("{"),
                block.reason() is not None,
            ]
            with self.subTest(block=block.name):
                self.assertEqual(sum(kinds), 1, "run it here, or list in NOT_RUN why it cannot")
                if block.commands:
                    lines = [line for line in block.text.splitlines() if line.strip()]
                    self.assertEqual(len(block.commands), len(lines), "other lines in between")

    def test_entry_of_the_list_is_there(self) -> None:
        for page, begin in NOT_RUN:
            found = [b for b in ALL if b.page == page and b.text.startswith(begin)]
            with self.subTest(page=page, begin=begin):
                self.assertEqual(len(found), 1)

    def test_page_is_looked_at(self) -> None:
        self.assertGreater(len(ALL), 30)
        for page in PAGES:  # a fence of another kind would hide a block
            self.assertNotIn("~~~", page.read_text(encoding="utf-8"))

    def test_object_is_right(self) -> None:
        for block in ALL:
            if not block.text.startswith("{"):
                continue
            with self.subTest(block=block.name):
                value = document.parse(block.text)
                if value["schema"] == scenes.SCHEMA:
                    scenes.check(value)
                else:
                    sweep.load(self.write("sweep.json", block.text))


class Run(support.DirectoryTest):
    """Blocks that run do so in a directory with the files that they name."""

    def setUp(self) -> None:
        super().setUp()
        self.write("scene.json", {**support.small_scene(), "size": [320, 240]})
        (self.directory / "Testing").symlink_to(support.TESTING)
        self.write_small_brain()
        source = vtkSphereSource()
        thickness = vtkElevationFilter()
        thickness.SetInputConnection(source.GetOutputPort())
        thickness.Update()
        head = thickness.GetOutput()
        head.GetPointData().GetScalars().SetName("thickness")
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(head)
        writer.SetFileName(str(self.directory / "head.vtp"))
        writer.Write()
        self.addCleanup(os.chdir, Path.cwd())
        os.chdir(self.directory)

    def write_small_brain(self) -> None:
        """Write every eighth voxel of each axis of the brain, a file as users have them."""
        reader = vtkNIFTIImageReader()
        reader.SetFileName(str(support.DATA / "brain_mri_colin27_ch2bet.nii.gz"))
        shrink = vtkImageShrink3D()
        shrink.SetInputConnection(reader.GetOutputPort())
        shrink.SetShrinkFactors(8, 8, 8)
        writer = vtkNIFTIImageWriter()
        writer.SetInputConnection(shrink.GetOutputPort())
        writer.SetFileName(str(self.directory / "brain.nii.gz"))
        writer.Write()

    def test_lines_that_are_not_run(self) -> None:
        for block in ALL:
            for words in block.commands:
                self.assertIn(words[0], {**FOR_SPEED, **LINES_NOT_RUN})
                cli.commands()[cli.PROGRAM].parse_args(words)

    @unittest.skipIf(WHY_NOT, WHY_NOT or "")
    def test_command_lines(self) -> None:
        ran = 0
        for block in ALL:
            for words in block.commands:
                if words[0] in LINES_NOT_RUN:
                    continue
                # Levels of coarse subsplats need a picture of some size; of two sizes the last counts.
                if not any("subsplat" in word for word in words):
                    words = [*words, *FOR_SPEED[words[0]]]
                for word, more in FOR_SPEED_OF_A_WORD.items():
                    words = [*words, *(more if word in words else ())]
                with self.subTest(line=" ".join(words)):
                    said, printed = io.StringIO(), io.StringIO()
                    with redirect_stderr(said), redirect_stdout(printed):
                        code = cli.main(words)
                    self.assertEqual(code, 0, said.getvalue())
                    files = re.findall(r"^\S+\.\w+$", printed.getvalue(), re.MULTILINE)
                    self.assertTrue(files or "pixels" in printed.getvalue())
                    for path in files:
                        self.assertTrue(Path(path).exists(), path)
                    ran += 1
        self.assertGreater(ran, 10)

    @unittest.skipIf(WHY_NOT, WHY_NOT or "")
    def test_python(self) -> None:
        for page in PAGES:
            texts = [block for block in blocks(page) if block.language == "python"]
            if not texts:
                continue
            names = self.names_of_a_page()
            for block in texts:
                with self.subTest(block=block.name):
                    if re.search(r"\bplotter\b", re.sub("#.*", "", block.text)):
                        if WHY_NO_PYVISTA:
                            self.skipTest(WHY_NO_PYVISTA)
                        names["plotter"] = self.plotter()
                    if "vtkIndirectHeadless" in block.text:
                        if wrapped.missing("vtkIndirectHeadless"):
                            self.skipTest("the module vtkIndirectHeadless was not built")
                        self.addCleanup(vtkindirect.use_headless, not windows.has_display())
                    with redirect_stdout(io.StringIO()):
                        exec(compile(block.text, block.name, "exec"), names)  # noqa: S102

    def names_of_a_page(self) -> dict[str, Any]:
        """Return what a page's first block may take as given."""
        scene = vtkindirect.load_scene("scene.json")
        window = scene.make_window()
        self.addCleanup(window.Finalize)
        return {
            "renderer": scene.renderer,
            "actor": scene.renderer.GetActors().GetLastActor(),
            "window": window,
            "vtkindirect": vtkindirect,
        }

    def plotter(self) -> Any:
        """Return a plotter with something to show, and the component that early PyVistas lack."""
        import pyvista

        if not windows.has_display():
            vtkindirect.use_headless()
        kind = pyvista.Plotter
        if not hasattr(pyvista, "register_plotter_component"):
            kind = with_component(kind)
        result = kind(off_screen=True, window_size=(64, 48))
        self.addCleanup(result.close)
        result.add_mesh(pyvista.Plane())
        result.add_mesh(pyvista.Sphere(center=(0, 0, 0.5)))
        return result
