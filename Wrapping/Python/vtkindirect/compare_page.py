# SPDX-License-Identifier: BSD-3-Clause
"""The page of a comparison: tables, plots and difference images, as Markdown and as HTML."""

from __future__ import annotations

import html
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from vtkindirect import images
from vtkindirect.errors import RenderError

Result = dict[str, Any]

_COLUMNS = (
    ("method", "label", "{}"),
    ("frame ms", "frame_ms", "{:.1f}"),
    ("indirect ms", "indirect_ms", "{:.1f}"),
    ("nRMSE R1", "nrmse_r1", "{:.4f}"),
    ("bias R1", "bias_r1", "{:+.4f}"),
    ("99 % R1", "p99_r1", "{:.3f}"),
    ("relMSE R2", "relmse_r2", "{:.4f}"),
    ("bias R2", "bias_r2", "{:+.3f}"),
    ("relMSE R3", "relmse_r3", "{:.4f}"),
    ("bias R3", "bias_r3", "{:+.3f}"),
    ("shape R3", "shape_r3", "{:.3f}"),
    ("MB", "megabytes", "{:.1f}"),
)


def _cells(result: Result) -> list[str]:
    values = dict(result)
    if result.get("bytes") is not None:
        values["megabytes"] = result["bytes"] / 1e6
    if result.get("error"):
        return [result["label"], f"failed: {result['error']}"] + [""] * (len(_COLUMNS) - 2)
    return [
        form.format(values[key]) if values.get(key) is not None else ""
        for _, key, form in _COLUMNS
    ]


def _scenes(results: Sequence[Result]) -> list[str]:
    return list(dict.fromkeys(result["scene"] for result in results))


def _markdown(results: Sequence[Result], plots: dict[str, str]) -> str:
    first = results[0]
    lines = [
        "# Speed against error",
        "",
        f"vtk-indirect {next((r['version'] for r in results if r.get('version')), '')} (commit {first['commit'] or 'unknown'}, shaders "
        f"{next((r['shader_hash'] for r in results if r.get('shader_hash')), '')[:12]}), VTK "
        f"{first['vtk']}, {next((r['gl'] for r in results if r.get('gl')), '')}.",
        "",
        f"Times are medians of {first['frames']} frames with nothing reused between them, by wall "
        "clock; compare them within one run only. `vtk` is the frame without any pass, `ssao` the "
        "same with VTK's screen-space ambient occlusion (kernel 32, blur). Errors are of indirect "
        "irradiance with the albedo divided out, on receivers away from silhouettes, over the "
        "reference's mean. R1: every texel of 256 x 256 maps, no occlusion; R2: one bounce with "
        "visibility, path traced; R3: all bounces.",
    ]
    for scene in _scenes(results):
        rows = [result for result in results if result["scene"] == scene]
        lines += ["", f"## {scene}, {rows[0]['width']} x {rows[0]['height']}", ""]
        if scene in plots:
            lines += [f"![error against time]({plots[scene]})", ""]
        for name, why in rows[0].get("missing", {}).items():
            lines += [f"No {name}: {why}.", ""]
        lines.append("| " + " | ".join(title for title, _, _ in _COLUMNS) + " |")
        lines.append("|" + "|".join("---" if i == 0 else "---:" for i in range(len(_COLUMNS))) + "|")
        lines += ["| " + " | ".join(_cells(row)) + " |" for row in rows]
        lines += ["", f"R1 | ![R1]({scene}-R1.png)", "---|---"]
        for row in rows:
            if row.get("image"):
                lines.append(
                    f"{row['label']} | ![irradiance]({row['image']}) "
                    f"![too bright red, too dark blue]({row['difference']})"
                )
    return "\n".join(lines) + "\n"


def _html(results: Sequence[Result], plots: dict[str, str]) -> str:
    parts = [
        "<!doctype html><meta charset='utf-8'><title>Speed against error</title>",
        "<style>body{font:15px sans-serif;margin:2em;max-width:90em}table{border-collapse:collapse}"
        "td,th{padding:.2em .7em;text-align:right;border-bottom:1px solid #ddd}"
        "td:first-child,th:first-child{text-align:left}img{max-width:30em;margin:.3em}</style>",
        "<h1>Speed against error</h1>",
    ]
    for scene in _scenes(results):
        rows = [result for result in results if result["scene"] == scene]
        parts.append(f"<h2>{html.escape(scene)}, {rows[0]['width']} x {rows[0]['height']}</h2>")
        if scene in plots:
            parts.append(f"<img style='max-width:60em' src='{plots[scene]}' alt='error against time'>")
        for name, why in rows[0].get("missing", {}).items():
            parts.append(f"<p>No {name}: {html.escape(why)}.</p>")
        parts.append("<table><tr>" + "".join(f"<th>{t}</th>" for t, _, _ in _COLUMNS) + "</tr>")
        for row in rows:
            cells = "".join(f"<td>{html.escape(cell)}</td>" for cell in _cells(row))
            parts.append(f"<tr>{cells}</tr>")
        parts.append("</table>")
        parts.append(f"<figure><img src='{scene}-R1.png'><figcaption>R1</figcaption></figure>")
        for row in rows:
            if row.get("image"):
                parts.append(
                    f"<figure><img src='{html.escape(row['image'])}'>"
                    f"<img src='{html.escape(row['difference'])}'>"
                    f"<figcaption>{html.escape(row['label'])}; difference to R1: red too bright, "
                    "blue too dark, full colour at half the mean</figcaption></figure>"
                )
    return "\n".join(parts) + "\n"


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


def _plots(results: Sequence[Result], directory: Path) -> dict[str, str]:
    """One plot a scene, error against time."""
    pyplot = require_plots()
    written = {}
    for scene in _scenes(results):
        axes_names = [
            name
            for name in ("r1", "r2", "r3")
            if any(row.get(f"relmse_{name}") is not None for row in results if row["scene"] == scene)
        ]
        if not axes_names:
            continue
        figure, axes = pyplot.subplots(
            1, len(axes_names), figsize=(5.0 * len(axes_names), 4.2), squeeze=False
        )
        for name, axis in zip(axes_names, axes[0]):
            by_method: dict[str, list[tuple[float, float]]] = {}
            for row in results:
                error = row.get(f"relmse_{name}")
                if row["scene"] == scene and error is not None and row.get("indirect_ms"):
                    by_method.setdefault(row["label"].split(" ")[0], []).append(
                        (row["indirect_ms"], max(error, 1e-12))
                    )
            for method, points in by_method.items():
                points.sort()
                axis.plot(*zip(*points), marker="o", label=method)
            axis.set_xscale("log")
            axis.set_yscale("log")
            axis.set_xlabel("indirect stages, ms")
            axis.set_ylabel(f"relMSE to {name.upper()}")
            axis.grid(True, which="both", alpha=0.3)
            axis.legend()
        figure.suptitle(scene)
        figure.tight_layout()
        path = directory / f"{scene}.png"
        figure.savefig(path, dpi=100)
        pyplot.close(figure)
        written[scene] = path.name
    return written


def write(results: Sequence[Result], directory: Path) -> list[Path]:
    """Write index.md and index.html with their plots; returns the paths."""
    plots = _plots(results, directory)
    written = [directory / "index.md", directory / "index.html"]
    images.write_text(written[0], _markdown(results, plots))
    images.write_text(written[1], _html(results, plots))
    return written
