# SPDX-License-Identifier: BSD-3-Clause
"""The page of a comparison: tables, plots and difference images, as Markdown and as HTML."""

from __future__ import annotations

import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from vtkindirect import frames, images, references

import orbit
import plot

Result = dict[str, Any]
NOTHING = "vtk"
"""The method of the row without indirect light."""
DEFAULT = "default"
"""The label of the row in which nothing is set."""

_COLUMNS = (
    ("method", "label", "{}"),
    ("frame ms", "frame_ms", "{:.1f}"),
    ("moving ms", "moving_ms", "{:.1f}"),
    ("processor ms", "processor_ms", "{:.1f}"),
    ("adds, over SSAO", "added_processor_over_ssao", "{:.2f}"),
    ("first ms", "first_ms", "{:.0f}"),
    ("nRMSE R1", "nrmse_r1", "{:.4f}"),
    ("relMSE R2", "relmse_r2", "{:.4f}"),
    ("bias R2", "bias_r2", "{:+.3f}"),
    ("leak R2", "leak_percent", "{:.2f} %"),
    ("relMSE R3", "relmse_r3", "{:.4f}"),
    ("of 99 %", "relmse_trimmed_r3", "{:.4f}"),
    ("bias R3", "bias_r3", "{:+.3f}"),
    ("FLIP R3", "flip_r3", "{:.4f}"),
    ("nRMSE S1", "nrmse_s1", "{:.4f}"),
    ("bias S1", "bias_s1", "{:+.4f}"),
    ("relMSE S1", "relmse_s1", "{:.4f}"),
    ("nRMSE S3", "nrmse_s3", "{:.4f}"),
    ("bias S3", "bias_s3", "{:+.4f}"),
    ("relMSE S3", "relmse_s3", "{:.4f}"),
    ("FLIP S3", "flip_s3", "{:.4f}"),
    ("nRMSE A1", "nrmse_a1", "{:.4f}"),
    ("bias A1", "bias_a1", "{:+.4f}"),
    ("relMSE A1", "relmse_a1", "{:.4f}"),
    ("nRMSE A3", "nrmse_a3", "{:.4f}"),
    ("bias A3", "bias_a3", "{:+.4f}"),
    ("relMSE A3", "relmse_a3", "{:.4f}"),
    ("FLIP A3", "flip_a3", "{:.4f}"),
    ("flicker", "flicker", "{:+.4f}"),
    ("MB", "megabytes", "{:.1f}"),
)


def _values(result: Result) -> Result:
    values = dict(result)
    if result.get("bytes") is not None:
        values["megabytes"] = result["bytes"] / 1e6
    if result["method"] == "mitsuba":
        values.setdefault("frame_ms", result.get("indirect_ms"))
    if result.get("leak_r2") is not None:
        values["leak_percent"] = 100.0 * result["leak_r2"]
    return values


def _columns(results: Sequence[Result]) -> list[tuple[str, str, str]]:
    """Columns in which any row has a value; why others are empty is said beside the table."""
    held = [_values(result) for result in results]
    return [
        column for column in _COLUMNS if any(row.get(column[1]) is not None for row in held)
    ]


def _cells(result: Result, columns: Sequence[tuple[str, str, str]]) -> list[str]:
    if result.get("error"):
        return [result["label"], f"failed: {result['error']}"] + [""] * (len(columns) - 2)
    values = _values(result)
    return [
        form.format(values[key]) if values.get(key) is not None else "" for _, key, form in columns
    ]


def _scenes(results: Sequence[Result]) -> dict[str, list[Result]]:
    found: dict[str, list[Result]] = {}
    for result in results:
        found.setdefault(result["scene"], []).append(result)
    return found


def _first(results: Sequence[Result], key: str) -> str:
    return next((str(result[key]) for result in results if result.get(key)), "")


def provenance(results: Sequence[Result]) -> str:
    """Return what was run and on what: versions, commit, shaders, OpenGL, processor."""
    machine = _first(results, "machine") and f", {_first(results, 'machine')}"
    return (
        f"vtk-indirect {_first(results, 'version')} "
        f"(commit {_first(results, 'commit') or 'unknown'}, "
        f"shaders {_first(results, 'shader_hash')[:12]}), VTK {_first(results, 'vtk')}, "
        f"{_first(results, 'gl')}, OpenGL {_first(results, 'gl_version')}{machine}."
    )


def worse_than_nothing(rows: Sequence[Result]) -> str:
    """Name the rows of a scene that are further from all bounces (R3) than no indirect light at all."""
    limits = [row.get("relmse_r3") for row in rows if row["method"] == NOTHING]
    if not limits or limits[0] is None:
        return ""
    worse = [row for row in rows if (row.get("relmse_r3") or 0.0) > limits[0]]
    ours = [row["label"] for row in worse if row["method"] != "mitsuba"]
    if not ours:
        return "No row of ours is further from R3 than no indirect light at all."
    said = f"Further from R3 than no indirect light at all, by relMSE: {'; '.join(ours)}."
    if any(row["label"] == DEFAULT for row in worse):
        return f"{said} The default is one of them."
    measured = any(row["label"] == DEFAULT for row in rows)
    return f"{said} The default is not one of them." if measured else said


def main_of(rows: Sequence[Result]) -> str | None:
    """The reference that a scene's pictures of differences were made with."""
    return next(
        (name for name in references.MAIN if any(f"nrmse_{name.lower()}" in row for row in rows)),
        None,
    )


_OF_LIGHTS = (
    "Errors compare indirect irradiance, without the albedo, with references. R1 sums every texel of "
    "256 x 256 maps with nothing that hides them, R2 is one path-traced bounce, R3 all path-traced "
    "bounces. relMSE is the mean of the squared error over the squared reference, nRMSE the RMS "
    "error over the reference's mean, bias the mean error over it, leak the part of the light that "
    "is where R2 has none. R2 and R3 leave out silhouettes and creases, which a path tracer puts in "
    "other pixels; each scene says how many pixels these are."
)
_OF_EMITTERS = (
    "Errors compare irradiance, without the albedo, with path-traced references, away from "
    "silhouettes and creases. {one} is the light that comes directly from {what} (buffer {buffer}), "
    "{every} all bounces of that light and of lights (buffer irradiance). nRMSE is the RMS error "
    "over the reference's mean, bias the mean error over it."
)
_EMITTERS = {references.SKY: "the sky", references.AREA: "area lights"}
_OF_PACES = (
    f"Rows with a pace keep maps from frame to frame, and all maps exist before the first measured "
    f"frame. moving: the camera turns by {frames.TURN:g} degrees a frame and the window asks for "
    f"{frames.INTERACTIVE_RATE:g} frames a second. still: the camera turns likewise, and each frame "
    f"does all the work of one that stands. standing: nothing changes for "
    f"{frames.STANDING_FRAMES} frames. The error is the last frame's."
)


_OVER_SSAO = (
    "Adds, over SSAO: the processor time that a row adds to plain VTK's frame, over the processor "
    "time that the row ssao adds. Processor time counts all threads of the process; where OpenGL "
    "draws on the processor it is all the work of a frame, of a GPU's work it says nothing."
)


def _introduction(results: Sequence[Result]) -> list[str]:
    """Paragraphs on what was run, on what, and how to read it."""
    count = max(
        (r["frames"] for r in results if r["method"] != "mitsuba" and not r.get("pace")),
        default=results[0]["frames"],
    )
    said = [
        provenance(results),
        f"Times are medians of {count} frames of a camera that turns by less than a pixel; compare "
        "times of one run only. frame ms is wall clock, first ms the frame that makes maps, hints and "
        "shaders, moving ms a frame of a camera that turns by half a degree a frame while the window "
        "asks for 15 frames a second. The row vtk is the frame without a pass, with the error of no indirect light; ssao "
        "is VTK's screen-space ambient occlusion (kernel 32, blur), which has a time and no error. "
        "rows.csv has each stage, 95th percentiles and further columns.",
    ]
    if any(row.get("added_over_ssao") is not None for row in results):
        said.append(_OVER_SSAO)
    for (one, every), what in _EMITTERS.items():
        if any(row.get(f"nrmse_{one.lower()}") is not None for row in results):
            buffer = references.buffer_of(one)
            said.append(_OF_EMITTERS.format(one=one, every=every, what=what, buffer=buffer))
    if any(row.get("nrmse_r1") is not None for row in results):
        said.append(_OF_LIGHTS)
    if any(row.get("pace") for row in results):
        said.append(_OF_PACES)
    if any(row["method"] == "mitsuba" for row in results):
        said.append(
            "mitsuba is a path tracer by samples a pixel (spp), with the same size, metrics and "
            "pixels. One bounce converges to R2, all bounces to R3. Its frame ms is wall clock of "
            "tracing alone on the same processor, the median of up to three runs, and of denoising "
            "where the row says so."
        )
    if any(row.get("flip_r3") is not None for row in results):
        said.append(
            "FLIP is HDR-FLIP of the irradiance at 67 pixels a degree, from 0 (the same) to 1, "
            "mean over the receivers."
        )
    if any(row.get("flicker") is not None for row in results):
        said.append(
            f"flicker: while the camera turns around its focal point, {orbit.FRAMES} frames half a "
            "degree apart, the mean change from frame to frame beyond that of R1 (maps of 128 x 128), "
            "over the reference's mean. Below zero the image changes too little."
        )
    said.append(
        "In the plots, numbers beside points are the property that the sweep varies, dashed lines the "
        "path tracer, grey ground the noise of the reference."
    )
    return said


def _left_out(rows: Sequence[Result]) -> list[str]:
    """Sentences on what is not there, and why."""
    return [f"Left out: {name}, because {why}." for name, why in rows[0].get("missing", {}).items()]


def _notes(rows: Sequence[Result]) -> list[str]:
    """Sentences beside a scene's table."""
    notes = _left_out(rows)
    share = next((row["masked_share"] for row in rows if row.get("masked_share") is not None), None)
    if share is not None:
        emitted = (pair for pair in _EMITTERS if main_of(rows) in pair)
        names = next(emitted, references.LIGHTS)
        who, rest = " and ".join(names), "; R1 none" if names == references.LIGHTS else ""
        notes.append(f"{who} leave out {100.0 * share:.1f} % of the pixels with a surface{rest}.")
    worse = worse_than_nothing(rows)
    return [*notes, worse] if worse else notes


def _markdown(results: Sequence[Result], plots: dict[str, str]) -> str:
    columns = _columns(results)
    lines = ["# Speed against error"]
    for paragraph in _introduction(results):
        lines += ["", paragraph]
    for scene, rows in _scenes(results).items():
        lines += ["", f"## {scene}, {rows[0]['width']} x {rows[0]['height']}", ""]
        if scene in plots:
            lines += [f"![error against time]({plots[scene]})", ""]
        for sentence in _notes(rows):
            lines += [sentence, ""]
        lines.append("| " + " | ".join(title for title, _, _ in columns) + " |")
        lines.append("|" + "|".join("---" if i == 0 else "---:" for i in range(len(columns))) + "|")
        lines += [
            "| " + " | ".join(cell.replace("|", "\\|") for cell in _cells(row, columns)) + " |"
            for row in rows
        ]
        main = main_of(rows)
        lines += ["", f"{main} | ![{main}]({scene}-{main}.png)", "---|---"] if main else []
        for row in rows:
            if row.get("image"):
                lines.append(
                    f"{row['label']} | ![irradiance]({row['image']}) "
                    f"![too bright red, too dark blue]({row['difference']})"
                )
    return "\n".join(lines) + "\n"


_STYLE = (
    "body{font:15px sans-serif;margin:2em;max-width:100em}p{max-width:60em}"
    "table{border-collapse:collapse;font-size:13px}"
    "td,th{padding:.2em .6em;text-align:right;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child{text-align:left}td.failed{text-align:left;color:#a00}"
    ".left-out{color:#a00}.plot{max-width:100%}"
    ".pictures{display:flex;flex-wrap:wrap;gap:1em}figure{margin:0}"
    "figure img{width:15em;margin-right:.2em}figcaption{font-size:12px;max-width:30em}"
)


def _html(results: Sequence[Result], plots: dict[str, str]) -> str:
    columns = _columns(results)
    parts = [
        "<!doctype html><html lang='en'><meta charset='utf-8'><title>Speed against error</title>",
        f"<style>{_STYLE}</style>",
        "<h1>Speed against error</h1>",
    ]
    parts += [f"<p>{html.escape(paragraph)}</p>" for paragraph in _introduction(results)]
    for scene, rows in _scenes(results).items():
        parts.append(f"<h2>{html.escape(scene)}, {rows[0]['width']} x {rows[0]['height']}</h2>")
        if scene in plots:
            parts.append(f"<img class='plot' src='{plots[scene]}' alt='error against time'>")
        parts += [f"<p class='left-out'>{html.escape(line)}</p>" for line in _notes(rows)]
        parts.append("<table><tr>" + "".join(f"<th>{t}</th>" for t, _, _ in columns) + "</tr>")
        for row in rows:
            cells = [html.escape(cell) for cell in _cells(row, columns)]
            if row.get("error"):
                text = f"<td>{cells[0]}</td><td class='failed' colspan='99'>{cells[1]}</td>"
            else:
                text = "".join(f"<td>{cell}</td>" for cell in cells)
            parts.append(f"<tr>{text}</tr>")
        parts.append("</table>")
        parts.append(
            f"<p>Irradiance, and its difference to {main_of(rows) or 'a reference'}: red too "
            "bright, blue too dark, full colour at half the mean.</p><div class='pictures'>"
        )
        parts += [
            f"<figure><img src='{scene}-{name}.png'><figcaption>{name}</figcaption></figure>"
            for name in ("R1", *references.STORED)
            if any(row.get(f"relmse_{name.lower()}") is not None for row in rows)
        ]
        parts += [
            f"<figure><img src='{html.escape(row['image'])}'>"
            f"<img src='{html.escape(row['difference'])}'>"
            f"<figcaption>{html.escape(row['label'])}</figcaption></figure>"
            for row in rows
            if row.get("image")
        ]
        parts.append("</div>")
    return "\n".join(parts) + "\n</html>\n"


def write(results: Sequence[Result], directory: Path, whole: bool = False) -> list[Path]:
    """Write index.md and index.html with their plots; returns the paths.

    whole: plots have the time until a still picture is there, in place of that of a frame.
    """
    plots = {
        scene: f"{scene}.png"
        for scene, rows in _scenes(results).items()
        if plot.draw(rows, directory / f"{scene}.png", whole)
    }
    written = [directory / "index.md", directory / "index.html"]
    images.write_text(written[0], _markdown(results, plots))
    images.write_text(written[1], _html(results, plots))
    return written
