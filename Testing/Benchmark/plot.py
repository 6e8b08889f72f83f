# SPDX-License-Identifier: BSD-3-Clause
"""The plot of a comparison: error against time, one picture a scene, one panel a reference."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vtkindirect.errors import RenderError

Result = dict[str, Any]

PANELS = {
    "r1": "R1: what the method converges to\n(one bounce, nothing in the way)",
    "r2": "R2: one bounce with true visibility",
    "r3": "R3: all bounces",
    "s1": "S1: light that comes directly from the sky",
    "s3": "S3: light of the sky, all bounces",
    "a1": "A1: light that comes directly from area lights",
    "a3": "A3: light of area lights, all bounces",
}
_TRACED = {
    "mitsuba one bounce": ("r2",),
    "mitsuba one bounce denoised": ("r2",),
    "mitsuba all bounces": ("r3",),
    "mitsuba all bounces denoised": ("r3",),
}
"""The panels in which the path tracer's curves stand: those of what they compute."""

_COLORS = (
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c564b", "#7f3c8d",
    "#6a9f00", "#b2182b",
)  # fmt: skip
_MARKERS = "osD^vP*Xph"


WHOLE = "r3"
"""The reference of plots that have the time until a still picture is there."""


@dataclass
class Series:
    """The points of one method: time, error and what tells it from the others."""

    name: str
    points: list[tuple[float, float, str]]
    traced: bool


def require_plots() -> Any:
    """matplotlib's pyplot, for files only; raises `RenderError` when it is not installed."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    try:
        from matplotlib import pyplot
    except ImportError:
        raise RenderError(
            "the plots of a comparison need matplotlib (Debian: python3-matplotlib)"
        ) from None
    return pyplot


def name_of(row: Result) -> tuple[str, str]:
    """The series that a row belongs to, and what tells its point from the others."""
    words = row["label"].split(" ")
    if row["method"] == "mitsuba":
        return (" ".join(words[:-2]), words[-2]) if words[-1] == "spp" else (row["label"], "")
    return words[0], " ".join(word.rpartition("=")[2] for word in words[1:])


def series(rows: Sequence[Result], reference: str, whole: bool = False) -> list[Series]:
    """The series of a panel, in the order of the rows, each by rising time.

    whole: the time until a still picture is there, in place of that of a frame's indirect light.
    """
    found: dict[str, Series] = {}
    for row in rows:
        error, time = row.get(f"relmse_{reference}"), row.get("indirect_ms")
        time = (row.get("first_ms") or time) if whole else time
        if error is None or not time:
            continue
        name, point = name_of(row)
        traced = row["method"] == "mitsuba"
        if traced and reference not in _TRACED.get(name, ()):
            continue
        # An error of exactly nothing is drawn where a logarithm still has a place for it.
        known = found.setdefault(name, Series(name, [], traced))
        known.points.append((time, max(error, 1e-8), point))
    for one in found.values():
        one.points.sort()
    return list(found.values())


def _by_label(rows: Sequence[Result], label: str, key: str) -> float | None:
    return next((row.get(key) for row in rows if row["label"] == label), None)


def _lines(axis: Any, rows: Sequence[Result], reference: str) -> None:
    """The yardsticks that are lines: no indirect light, VTK's frame, what SSAO adds to it."""
    nothing = _by_label(rows, "vtk", f"relmse_{reference}")
    if nothing:
        axis.axhline(nothing, color="0.35", linestyle=(0, (6, 3)), linewidth=1.2, zorder=1)
    noise = next((row.get(f"noise_{reference}") for row in rows), None)
    if noise:
        axis.axhspan(1e-12, noise, color="0.9", zorder=0)
    for where, _ in _times(rows):
        axis.axvline(where, color="0.6", linestyle=":", linewidth=1.2, zorder=1)


def _times(rows: Sequence[Result]) -> list[tuple[float, str]]:
    """The yardsticks that are times, and what to call them."""
    frame, ssao = _by_label(rows, "vtk", "frame_ms"), _by_label(rows, "ssao", "frame_ms")
    found = [(frame, "frame of plain VTK")] if frame else []
    if frame and ssao and ssao > frame:
        found.append((ssao - frame, "what SSAO adds"))
    return found


def _limits(axis: Any, found: list[Series], rows: Sequence[Result], reference: str) -> None:
    """Room for all points and lines, a decade at the least."""
    errors = [point[1] for one in found for point in one.points]
    nothing = _by_label(rows, "vtk", f"relmse_{reference}")
    errors += [nothing] if nothing else []
    low, high = min(errors), max(errors)
    axis.set_ylim(min(0.5 * low, 0.1 * high), 2.2 * high)
    times = [point[0] for one in found for point in one.points]
    times += [time for time, _ in _times(rows)]
    axis.set_xlim(0.6 * min(times), 1.9 * max(times))


def _ticks(axis: Any) -> None:
    """Ticks at powers of ten, also between them where there are few; plain numbers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    low, high = axis.get_xlim()
    few = high < 150.0 * low
    axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if few else (1.0,)))
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _place: f"{value:g}"))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.yaxis.set_minor_formatter(NullFormatter())


def _along(axis: Any, found: list[Series]) -> list[tuple[float, float]]:
    """Places on the screen that the curves go through, a few pixels apart."""
    places: list[tuple[float, float]] = []
    for one in found:
        ends = [tuple(axis.transData.transform((time, error))) for time, error, _ in one.points]
        places += ends
        for (x0, y0), (x1, y1) in zip(ends, ends[1:]):
            count = int(max(abs(x1 - x0), abs(y1 - y0)) / 4.0) + 1
            parts = [i / count for i in range(count)]
            places += [(x0 + (x1 - x0) * part, y0 + (y1 - y0) * part) for part in parts]
    return places


class _Room:
    """Places in a plot that have room for text."""

    def __init__(self, figure: Any, axis: Any, found: list[Series]) -> None:
        figure.canvas.draw()
        self.axis = axis
        self._renderer = figure.canvas.get_renderer()
        self._curves = _along(axis, found)
        self._taken = [text.get_window_extent(self._renderer) for text in axis.texts]

    def _fits(self, box: Any, curves: bool) -> bool:
        if any(box.overlaps(other) for other in self._taken):
            return False
        if not (self.axis.bbox.containsx(box.x0) and self.axis.bbox.containsx(box.x1)):
            return False
        return not curves or not any(box.contains(*place) for place in self._curves)

    def write(
        self, text: str, choices: Sequence[dict[str, Any]], needed: bool, **style: Any
    ) -> None:
        """Write a text at the first choice that touches nothing, else where it touches no text."""
        for curves in (True, False):
            for choice in choices:
                made = self.axis.annotate(text, textcoords="offset points", **choice, **style)
                box = made.get_window_extent(self._renderer)
                if self._fits(box, curves):
                    self._taken.append(box)
                    return
                made.remove()
        if needed:
            self.axis.annotate(text, textcoords="offset points", **choices[0], **style)


def _names(
    figure: Any, axis: Any, found: list[Series], rows: Sequence[Result], reference: str
) -> None:
    """Write what the lines are, and beside points what tells them apart."""
    room = _Room(figure, axis, found)
    nothing = _by_label(rows, "vtk", f"relmse_{reference}")
    for where, text in _times(rows):
        room.write(
            text,
            [
                {"xy": (where, y), "xycoords": ("data", "axes fraction"), "xytext": (dx, 0),
                 "ha": ha, "va": va}
                for y, va in ((0.02, "bottom"), (0.98, "top"), (0.5, "center"))
                for dx, ha in ((-2, "right"), (3, "left"))
            ],
            True,
            rotation=90,
            fontsize=7,
            color="0.35",
        )  # fmt: skip
    if nothing:
        room.write(
            "plain VTK: no indirect light",
            [
                {"xy": (x, nothing), "xycoords": ("axes fraction", "data"), "xytext": (0, dy),
                 "ha": ha}
                for dy in (3, -10)
                for x, ha in ((0.985, "right"), (0.5, "center"), (0.015, "left"))
            ],
            True,
            fontsize=7,
            color="0.25",
        )  # fmt: skip
    for one in found:
        for time, error, name in one.points:
            if name:
                room.write(
                    name,
                    [
                        {"xy": (time, error), "xytext": (dx, dy), "ha": ha}
                        for dx, dy, ha in (
                            (5, 4, "left"), (-5, -10, "right"), (5, -10, "left"), (-5, 4, "right"),
                            (0, 7, "center"), (0, -13, "center"),
                        )
                    ],
                    False,
                    fontsize=6.5,
                    color="0.2",
                )  # fmt: skip


def looks(number: int) -> list[tuple[str, str]]:
    """Return a colour and a marker for each of a number of methods, no two alike up to 100."""
    return [
        (_COLORS[i % len(_COLORS)], _MARKERS[(i + i // len(_COLORS)) % len(_MARKERS)])
        for i in range(number)
    ]


def draw(rows: Sequence[Result], path: Path, whole: bool = False) -> bool:
    """Write the plot of one scene's rows; False when no row has an error and a time.

    whole: as for `series`.
    """
    pyplot = require_plots()
    panels = {name: series(rows, name, whole) for name in ([WHOLE] if whole else PANELS)}
    panels = {name: found for name, found in panels.items() if found}
    if not panels:
        return False
    names = list(dict.fromkeys(one.name for found in panels.values() for one in found))
    methods = [name for name in names if name not in _TRACED]
    style: dict[str, tuple[str, str]] = dict(zip(methods, looks(len(methods))))
    for bounces, marker in (("one bounce", "<"), ("all bounces", ">")):
        style |= {f"mitsuba {bounces}": ("0.0", marker)}
        style |= {f"mitsuba {bounces} denoised": ("0.45", marker)}
    figure, axes = pyplot.subplots(
        1, len(panels), figsize=(4.9 * len(panels) + 0.3, 4.9), squeeze=False
    )
    handles: dict[str, Any] = {}
    for (reference, found), axis in zip(panels.items(), axes[0]):
        axis.set_xscale("log")
        axis.set_yscale("log")
        for one in found:
            color, marker = style[one.name]
            (handles[one.name],) = axis.plot(
                [point[0] for point in one.points],
                [point[1] for point in one.points],
                color=color,
                marker=marker,
                markersize=6 if one.traced else 5.5,
                markerfacecolor="white" if one.traced else color,
                linestyle=(0, (4, 2)) if one.traced else "-",
                linewidth=1.4,
                zorder=3,
            )
        _limits(axis, found, rows, reference)
        _lines(axis, rows, reference)
        axis.set_title(PANELS[reference], fontsize=9)
        axis.set_xlabel(
            "time until the picture is there, ms" if whole else "time of the indirect light, ms"
        )
        axis.set_ylabel(f"relMSE to {reference.upper()}")
        _ticks(axis)
        axis.grid(True, which="major", alpha=0.35)
        axis.grid(True, which="minor", alpha=0.12)
    first = rows[0]
    figure.suptitle(f"{first['scene']}, {first['width']} x {first['height']}", fontsize=12)
    order = [name for name in names if name in handles]
    columns = min(2 * len(panels) + 1, len(order))
    lines = -(-len(order) // columns)
    figure.legend(
        [handles[name] for name in order], order, loc="lower center", ncol=columns, fontsize=8.5,
        frameon=False,
    )  # fmt: skip
    figure.tight_layout(rect=(0, 0.02 + 0.045 * lines, 1, 1))
    for (reference, found), axis in zip(panels.items(), axes[0]):
        _names(figure, axis, found, rows, reference)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
    return True
