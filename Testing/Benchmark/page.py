# SPDX-License-Identifier: BSD-3-Clause
"""The page of a comparison: tables, plots and difference images, as Markdown and as HTML."""

from __future__ import annotations

import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from vtkindirect import frames, images, references

import plot

Result = dict[str, Any]
NOTHING = "vtk"
"""The method of the row without indirect light."""

_COLUMNS = (
    ("method", "label", "{}"),
    ("frame ms", "frame_ms", "{:.1f}"),
    ("indirect ms", "indirect_ms", "{:.1f}"),
    ("processor ms", "processor_ms", "{:.1f}"),
    ("adds, over SSAO", "added_over_ssao", "{:.2f}"),
    ("processor", "added_processor_over_ssao", "{:.2f}"),
    ("first ms", "first_ms", "{:.0f}"),
    ("nRMSE R1", "nrmse_r1", "{:.4f}"),
    ("bias R1", "bias_r1", "{:+.4f}"),
    ("99 % R1", "p99_r1", "{:.3f}"),
    ("FLIP R1", "flip_r1", "{:.4f}"),
    ("relMSE R2", "relmse_r2", "{:.4f}"),
    ("bias R2", "bias_r2", "{:+.3f}"),
    ("FLIP R2", "flip_r2", "{:.4f}"),
    ("leak R2", "leak_percent", "{:.2f} %"),
    ("relMSE R3", "relmse_r3", "{:.4f}"),
    ("bias R3", "bias_r3", "{:+.3f}"),
    ("shape R3", "shape_r3", "{:.3f}"),
    ("FLIP R3", "flip_r3", "{:.4f}"),
    ("nRMSE S1", "nrmse_s1", "{:.4f}"),
    ("bias S1", "bias_s1", "{:+.4f}"),
    ("relMSE S1", "relmse_s1", "{:.4f}"),
    ("FLIP S1", "flip_s1", "{:.4f}"),
    ("nRMSE S3", "nrmse_s3", "{:.4f}"),
    ("bias S3", "bias_s3", "{:+.4f}"),
    ("relMSE S3", "relmse_s3", "{:.4f}"),
    ("FLIP S3", "flip_s3", "{:.4f}"),
    ("nRMSE A1", "nrmse_a1", "{:.4f}"),
    ("bias A1", "bias_a1", "{:+.4f}"),
    ("relMSE A1", "relmse_a1", "{:.4f}"),
    ("FLIP A1", "flip_a1", "{:.4f}"),
    ("nRMSE A3", "nrmse_a3", "{:.4f}"),
    ("bias A3", "bias_a3", "{:+.4f}"),
    ("relMSE A3", "relmse_a3", "{:.4f}"),
    ("FLIP A3", "flip_a3", "{:.4f}"),
    ("flicker", "flicker", "{:+.4f}"),
    ("error flicker", "flicker_error", "{:.4f}"),
    ("MB", "megabytes", "{:.1f}"),
)


def _values(result: Result) -> Result:
    values = dict(result)
    if result.get("bytes") is not None:
        values["megabytes"] = result["bytes"] / 1e6
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
    """What was run and on what: versions, commit, shaders, OpenGL."""
    return (
        f"vtk-indirect {_first(results, 'version')} "
        f"(commit {_first(results, 'commit') or 'unknown'}, "
        f"shaders {_first(results, 'shader_hash')[:12]}), VTK {_first(results, 'vtk')}, "
        f"{_first(results, 'gl')}, OpenGL {_first(results, 'gl_version')}."
    )


def worse_than_nothing(rows: Sequence[Result]) -> str:
    """Name the rows of a scene that are further from R2 than no indirect light at all."""
    limits = [row.get("relmse_r2") for row in rows if row["method"] == NOTHING]
    if not limits or limits[0] is None:
        return ""
    worse = [row for row in rows if (row.get("relmse_r2") or 0.0) > limits[0]]
    ours = [row["label"] for row in worse if row["method"] != "mitsuba"]
    if not ours:
        return "No row of ours is further from R2 than no indirect light at all."
    said = f"Further from R2 than no indirect light at all, by relMSE: {'; '.join(ours)}."
    if any(row["method"] == "auto" for row in worse):
        return f"{said} The default is one of them."
    measured = any(row["method"] == "auto" for row in rows)
    return f"{said} The default is not one of them." if measured else said


def main_of(rows: Sequence[Result]) -> str | None:
    """The reference that a scene's pictures of differences were made with."""
    return next(
        (name for name in references.MAIN if any(f"nrmse_{name.lower()}" in row for row in rows)),
        None,
    )


_OF_LIGHTS = (
    "Errors are of indirect irradiance with the albedo divided out, over the reference's mean. "
    "R1: every texel of 256 x 256 maps, no occlusion, on all pixels with a surface; R2: one "
    "bounce with visibility, path traced; R3: all bounces. R2 and R3 count receivers, away "
    "from silhouettes and creases, which a path tracer puts in other pixels; what share of the "
    "pixels that leaves out is said at each scene. leak: part of the light that is where R2 "
    "has none."
)
_OF_EMITTERS = (
    "Errors are of irradiance with the albedo divided out, on receivers away from silhouettes and "
    "creases. {one}: what comes directly from {what}, against the buffer {buffer}; {every}: all "
    "bounces of it and of lights, against irradiance; both path traced. nRMSE is the RMS error "
    "over the reference's mean, bias the mean error over it."
)
_EMITTERS = {references.SKY: "the sky", references.AREA: "area lights"}
_OF_PACES = (
    f"Rows at a pace keep maps and tiles from frame to frame, and those are there before any frame "
    f"is measured: first ms is the very first frame, in which they are made. moving: the camera "
    f"turns by {frames.TURN:g} degrees a frame and the window asks for "
    f"{frames.INTERACTIVE_RATE:g} frames a second; still: it turns likewise, and each frame has "
    f"all the work of one that stands; standing: the image after {frames.STANDING_FRAMES} frames "
    f"without a change, and the median of the frames meanwhile. The error is the last frame's."
)


_OVER_SSAO = (
    "Adds, over SSAO: how much longer a frame takes than plain VTK's, over how much longer that "
    "of the row ssao takes, by wall clock and by processor time, which is that of all threads of "
    "the process. Where OpenGL draws on the processor, processor time is all the work of a frame, "
    "whether cores work side by side or wait for each other; of a GPU's work it says nothing."
)


def _introduction(results: Sequence[Result]) -> list[str]:
    """Paragraphs on what was run, on what, and how to read it."""
    count = max(
        (r["frames"] for r in results if r["method"] != "mitsuba" and not r.get("pace")),
        default=results[0]["frames"],
    )
    said = [
        provenance(results),
        f"Times are medians of {count} frames of a camera that turns by less than a pixel, by wall "
        "clock; "
        "compare them within one run only. 95th percentiles, the time of each stage and all other "
        "columns are in rows.csv. Yardsticks of the same run: vtk is the frame without any pass, "
        "and the error of having no indirect light; ssao the same with VTK's screen-space ambient "
        "occlusion (kernel 32, blur), which darkens and adds nothing, so it has a time and no "
        "error.",
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
            "mitsuba is a path tracer at rising samples a pixel (spp), at the same size, with the "
            "same metrics and mask: one bounce converges to R2, all bounces to R3. Its time is "
            "that of tracing alone, on the same processor, median of up to three times; loading "
            "the scene, compiling its kernels and the rays from the eye are not counted."
        )
    if any(row.get("flip_r1") is not None for row in results):
        said.append(
            "FLIP is HDR-FLIP of the irradiance at 67 pixels a degree, from 0 (the same) to 1, "
            "mean over the receivers."
        )
    if any(row.get("flicker") is not None for row in results):
        said.append(
            "flicker: mean change from frame to frame over the reference's mean while the camera "
            "turns around its focal point, eight frames half a degree apart, beyond the change "
            "that R1 (maps of 128 x 128) shows at the same pixels; below zero the image changes "
            "too little. error flicker: mean change of the difference to R1, in which nothing "
            "cancels; an error that is fixed to a surface moves with it, so compare methods with "
            "the same lights."
        )
    said.append(
        "In the plots the numbers beside points are what the sweep varies, dashed lines are the "
        "path tracer, and grey ground is the noise of the reference itself."
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


def write(results: Sequence[Result], directory: Path) -> list[Path]:
    """Write index.md and index.html with their plots; returns the paths."""
    plots = {
        scene: f"{scene}.png"
        for scene, rows in _scenes(results).items()
        if plot.draw(rows, directory / f"{scene}.png")
    }
    written = [directory / "index.md", directory / "index.html"]
    images.write_text(written[0], _markdown(results, plots))
    images.write_text(written[1], _html(results, plots))
    return written
