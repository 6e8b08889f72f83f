# SPDX-License-Identifier: BSD-3-Clause
"""The plotter component: registered where PyVista can have it, and the same as the functions."""

import importlib
import os
import subprocess
import sys
import types
import unittest
from unittest import mock

from vtkmodules.vtkRenderingCore import vtkRenderer

import support
import vtkindirect
from vtkindirect import wrapped


class Plotter:
    """Stands for a PyVista plotter: something with a renderer."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()


def stand_in() -> types.ModuleType:
    """Return a module that registers components as PyVista 0.48 does."""
    module = types.ModuleType("pyvista")
    module.BasePlotter = type("BasePlotter", (), {})

    def register(name):
        return lambda component: setattr(module.BasePlotter, name, component)

    module.register_plotter_component = register
    return module


def load(pyvista) -> types.ModuleType:
    """Import the component's module beside a given PyVista, or without one."""
    with mock.patch.dict(sys.modules, {"pyvista": pyvista}):
        sys.modules.pop("vtkindirect.plotter", None)
        return importlib.import_module("vtkindirect.plotter")


class Component(support.DirectoryTest):
    def test_registered_once(self) -> None:
        pyvista = stand_in()
        module = load(pyvista)
        self.assertIs(pyvista.BasePlotter.indirect, module.IndirectComponent)
        first = pyvista.BasePlotter.indirect
        load(pyvista)
        self.assertIs(pyvista.BasePlotter.indirect, first)

    def test_without_pyvista_or_with_an_old_one(self) -> None:
        with mock.patch.dict(sys.modules, {"pyvista": None}):
            self.assertFalse(load(None).register())
        old = types.ModuleType("pyvista")
        old.BasePlotter = type("BasePlotter", (), {})
        old.__version__ = "0.46.4"
        with mock.patch.dict(sys.modules, {"pyvista": old}):
            self.assertFalse(load(old).register())
            plotter = old.BasePlotter()
            self.assertFalse(hasattr(plotter, "indirect"))
            with self.assertRaisesRegex(
                AttributeError, "needs PyVista 0.48 or later, and this is 0.46.4: call "
                r"vtkindirect.enable\(plotter\)"
            ):
                plotter.indirect.enable()

    def test_beside_a_pyvista_that_cannot_be_imported(self) -> None:
        (self.directory / "pyvista.py").write_text("raise AttributeError('of an older Python')")
        path = [str(self.directory), *sys.path]
        with mock.patch.dict(sys.modules), mock.patch.object(sys, "path", path):
            for name in ("pyvista", "vtkindirect.plotter"):
                sys.modules.pop(name, None)
            self.assertFalse(importlib.import_module("vtkindirect.plotter").register())

    def test_an_old_pyvista_imported_later(self) -> None:
        (self.directory / "pyvista.py").write_text(
            "__version__ = '0.46.4'\n\n\nclass BasePlotter:\n    pass\n"
        )
        program = "import vtkindirect, pyvista; pyvista.BasePlotter().indirect"
        environment = {
            **os.environ, "PYTHONPATH": os.pathsep.join([str(self.directory), *sys.path])
        }
        done = subprocess.run(
            [sys.executable, "-c", program], env=environment, capture_output=True, text=True
        )
        self.assertIn("call vtkindirect.enable(plotter)", done.stderr)

    def test_entry_point_names_the_module(self) -> None:
        text = (support.SOURCE / "Wrapping" / "Python" / "entry_points.txt").read_text()
        self.assertIn("[pyvista.plotter_components]\nindirect = vtkindirect.plotter", text)

    @unittest.skipUnless(
        wrapped.has("vtkIndirectIlluminationPass"), "the module vtkRenderingIndirect was not built"
    )
    def test_the_component_works(self) -> None:
        component = load(stand_in()).IndirectComponent(plotter := Plotter())
        self.assertFalse(component.enabled)
        indirect = component.enable("gather", number_of_lights=12)
        self.assertTrue(component.enabled)
        self.assertIs(plotter.renderer.GetPass(), indirect)
        self.assertIs(vtkindirect.pass_of(plotter), indirect)
        component.disable()
        self.assertFalse(component.enabled)
        component.enable()
        first = plotter.renderer
        plotter.renderer = vtkRenderer()  # another subplot becomes active
        component.enable()
        component.__plotter_close__()
        self.assertIsNone(first.GetPass())
        self.assertIsNone(plotter.renderer.GetPass())
