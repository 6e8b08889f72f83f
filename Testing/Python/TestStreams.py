# SPDX-License-Identifier: BSD-3-Clause
"""Output of the command line through links, into pipes and devices, and early ends."""

import contextlib
import fcntl
import json
import os
import pty
import signal
import struct
import subprocess
import sys
import termios
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import support
from vtkindirect import images, progress, working
from vtkindirect.errors import RenderError, UsageError

WHY_NOT = support.why_no_rendering()
PICTURE = np.zeros((2, 3, 3), np.uint8)
PNG = b"\x89PNG\r\n"
FULL = Path("/dev/full")


class Files(support.DirectoryTest):
    def test_a_link_stays_and_its_target_is_written(self) -> None:
        (self.directory / "deep").mkdir()
        target = self.write("deep/target.png", "before")
        target.chmod(0o640)
        link = self.directory / "link.png"
        for name in ("target.png", "new.png"):  # one that is there, one that is not yet
            link.symlink_to(Path("deep") / name)
            images.check_output(link, images.FORMATS)
            images.write_image(link, PICTURE)
            self.assertTrue(link.is_symlink())
            self.assertTrue((self.directory / "deep" / name).read_bytes().startswith(PNG))
            link.unlink()
        self.assertEqual(target.stat().st_mode & 0o777, 0o640)
        self.assertEqual(sorted(os.listdir(target.parent)), ["new.png", "target.png"])

    def test_links_that_lead_nowhere(self) -> None:
        loop = self.directory / "loop.png"
        loop.symlink_to(loop)
        lost = self.directory / "lost.png"
        lost.symlink_to(self.directory / "none" / "a.png")
        for path, expected in ((loop, "leads back to itself"), (lost, "no such directory")):
            with self.assertRaisesRegex(UsageError, expected):
                images.check_output(path, images.FORMATS)
            self.assertTrue(path.is_symlink())

    def test_a_pipe_gets_all_of_it(self) -> None:
        for name in ("pipe.png", "pipe"):
            pipe = self.directory / name
            os.mkfifo(pipe)
            got: list[bytes] = []
            reader = threading.Thread(target=lambda pipe=pipe: got.append(pipe.read_bytes()))
            reader.start()
            images.check_output(pipe, images.FORMATS)
            images.write_image(pipe, PICTURE)
            reader.join()
            self.assertTrue(got[0].startswith(PNG))
            self.assertTrue(pipe.is_fifo())
        self.assertEqual(self.names(), ["pipe", "pipe.png"])

    @unittest.skipUnless(FULL.exists(), "this system has no /dev/full")
    def test_a_device_that_is_full(self) -> None:
        images.check_output(FULL, (".json",))
        with self.assertRaisesRegex(RenderError, "/dev/full: cannot be written: No space left"):
            images.write_text(FULL, "{}")
        images.write_text(images.check_output("/dev/null", (".json",)), "{}")
        self.assertFalse(Path("/dev/null").is_file())


class Ends(support.DirectoryTest):
    """The program that ends before its time writes one line."""

    def start(self, *words, **how) -> subprocess.Popen:
        return subprocess.Popen(
            [sys.executable, "-B", "-m", "vtkindirect", *map(str, words)],
            stderr=subprocess.PIPE,
            **how,
        )

    def assert_one_line(self, program: subprocess.Popen, expected: str, code: int) -> None:
        said = program.communicate()[1].decode()
        self.assertEqual(program.returncode, code, said)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertTrue(said.startswith("vtk-indirect: error: "), said)
        self.assertIn(expected, said)

    @unittest.skipUnless(FULL.exists(), "this system has no /dev/full")
    def test_standard_output_is_full(self) -> None:
        for word in ("--version", "--help"):
            with FULL.open("wb") as full:
                program = self.start(word, stdout=full)
            self.assert_one_line(program, "standard output: cannot be written: No space left", 1)

    def test_standard_output_is_closed(self) -> None:
        read, write = os.pipe()
        os.close(read)
        program = self.start("--version", stdout=write)
        os.close(write)
        self.assert_one_line(program, "standard output: cannot be written: nobody reads it", 1)

    def test_an_interrupt_while_the_package_is_imported(self) -> None:
        # The package waits for the signal in the middle of an import.
        stop = self.directory / "vtkmodules"
        stop.mkdir()
        (stop / "__init__.py").write_text(
            "import pathlib, time\n"
            f"pathlib.Path({str(self.directory / 'there')!r}).touch()\n"
            "time.sleep(100)\n"
        )
        package = Path(images.__file__).resolve().parents[1]
        program = package.parents[2] / "bin" / "vtk-indirect"
        for words in (["-m", "vtkindirect"], [str(program)]):
            if words[0] != "-m" and not program.exists():
                continue
            process = subprocess.Popen(
                [sys.executable, "-B", *words, "--version"],
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env={**os.environ, "PYTHONPATH": f"{self.directory}{os.pathsep}{package}"},
            )
            while not (self.directory / "there").exists():
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            with self.subTest(words=words):
                self.assert_one_line(process, "interrupted", 130)
            (self.directory / "there").unlink()

    @unittest.skipIf(WHY_NOT, WHY_NOT or "")
    def test_an_interrupt_while_rendering_leaves_nothing(self) -> None:
        scene = self.write("scene.json", support.small_scene())
        out = self.write("a.png", "before")
        # Many frames; the signal comes when the first of them begin, in VTK's calls or between.
        program = self.start(
            "render", scene, "-o", out, "--frames", 90000, "--size", "16x16",
            stdout=subprocess.PIPE,
        )  # fmt: skip
        time.sleep(0.2)
        while b"libGL" not in Path(f"/proc/{program.pid}/maps").read_bytes() and not program.poll():
            time.sleep(0.05)
        program.send_signal(signal.SIGINT)
        self.assert_one_line(program, "interrupted", 130)
        self.assertEqual(self.names(), ["a.png", "scene.json"])
        self.assertEqual(out.read_text(), "before")


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class StandardOutput(support.DirectoryTest):
    def test_it_has_the_file_and_nothing_else(self) -> None:
        scene = self.write("scene.json", support.small_scene())
        result = support.command_line_here(
            *("render", scene, "--method", "off", "--size", "16x16"),
            *("--report", "/dev/stdout", "-o", self.directory / "a.png"),
        )
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(json.loads(result.stdout)["size"], [16, 16])
        self.assertEqual(self.names(), ["a.png", "scene.json"])


@unittest.skipIf(WHY_NOT, WHY_NOT or "")
class Terminal(support.DirectoryTest):
    def test_a_bar_is_shown_and_wiped_off(self) -> None:
        """On a terminal of 80 columns: what goes on, and at last nothing but the file's name."""
        scene = self.write("scene.json", support.small_scene())
        out = self.directory / "a.png"
        terminal, end = pty.openpty()
        self.addCleanup(os.close, terminal)
        fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        with subprocess.Popen(
            [sys.executable, "-B", "-m", "vtkindirect", "render", scene, "--size", "9x9", "-o", out],
            stdout=subprocess.PIPE,
            stderr=end,
        ) as program:
            os.close(end)
            shown = b""
            with contextlib.suppress(OSError):  # Linux: the last writer has closed its end
                while piece := os.read(terminal, 4096):
                    shown += piece
            written = program.stdout.read()
        self.assertEqual((program.returncode, written.decode()), (0, f"{out}\n"))
        lines = shown.decode().split("\r")
        for what in ("loading scene.json", "rendering ", "frame 1 of 1"):
            self.assertTrue(any(what in line for line in lines), (what, lines))
        self.assertEqual((lines[-2].strip(), lines[-1]), ("", ""))
        self.assertNotIn("\n", shown.decode())


class Bar(unittest.TestCase):
    """A bar is there before work that nobody can look into, and says what goes on in it."""

    def bar(self, total: int) -> tuple[progress.Progress, list[str]]:
        shown: list[str] = []
        with mock.patch.object(sys, "stderr") as terminal:
            terminal.isatty.return_value = True
            terminal.encoding = "utf-8"
            terminal.write.side_effect = shown.append
            bar = progress.Progress("work", total)
        return bar, shown

    def test_it_is_there_from_the_beginning(self) -> None:
        bar, shown = self.bar(3)
        self.assertIn("work", "".join(shown))
        bar.step("first")
        self.assertIn("first", "".join(shown))
        bar.close()

    def test_steps_may_be_more(self) -> None:
        bar, _ = self.bar(1)
        bar.step()
        bar.step("maps", 4)
        self.assertEqual((bar.n, bar.total), (1, 6))  # one is done, one begins, four follow
        bar.step("maps", 2)
        self.assertEqual((bar.n, bar.total), (2, 6))
        bar.close()

    def test_readers_and_filters_say_how_far_they_are(self) -> None:
        from vtkmodules.vtkFiltersSources import vtkSphereSource

        heard: list[str] = []
        ball = vtkSphereSource()
        with working.listening(heard.append), working.watching(ball):
            ball.Update()
        self.assertEqual(heard[0], "vtkSphereSource")
        self.assertRegex(heard[-1], r"vtkSphereSource \d+%")
        count = len(heard)
        ball.Modified()
        ball.Update()
        self.assertEqual(len(heard), count)


if __name__ == "__main__":
    unittest.main()
