# SPDX-License-Identifier: BSD-3-Clause
"""Puts comparisons and benchmarks into the documentation: publish.py REPORTS DOCUMENTATION PAGE...

REPORTS is the directory that Testing/Benchmark/report fills: ``all``, ``hints``, ``sky``
and ``spheres`` are comparisons by ``comparison.py``, ``*.md`` are tables that benchmarks printed
(the page ``benchmarks``), and ``area_sweep.page`` is the whole page ``area``. Only the named pages
are written.
"""

from __future__ import annotations

import csv
import json
import shutil
import sys
from pathlib import Path
from typing import Any, NamedTuple

from vtkindirect import frames, load_scene

import comparison
from page import provenance

DOCUMENTATION = Path(__file__).resolve().parent.parent.parent / "Documentation"

HOW = """
This command makes this page again:

    Testing/Benchmark/report{only}
"""
PICTURES = "It also writes difference images of every row (build/report)."

ALL = """
Further pages: [light from the sky](speed-vs-error/sky.md), [the same by spheres](speed-vs-error/spheres.md), [area
lights by their number](speed-vs-error/area.md), [lights of a tree](speed-vs-error/light-tree.md), [radiance hints and
their paper](speed-vs-error/hints.md), [pictures left alone beside the path tracer](speed-vs-error/convergence.md), [multiresolution splatting and hints against the gather, SSAO and their
papers](speed-vs-error/benchmarks.md).

## Rows

| row | method |
|---|---|
| default | nothing set: lights of a tree, depth maps, all bounces |
| default-moving | the same in frames of a camera in motion |
| default-one-bounce, -open, -voxels | the default with one bounce, with nothing that hides senders, with voxels in place of depth maps |
| uniform, importance | the default with lights of these samplers in place of the tree |
| gather, gather-random-walk | the gather at every pixel with the default's lights, and with 1000 vertices of a walk |
| splatting | splats of 256 even lights |
| hints | radiance hints, 8 bounces |
| gather-paper, splatting-paper, multiresolution-paper, hints-paper | [the papers' versions](guide.md#the-papers-versions): Dachsbacher and Stamminger 2005 and 2006, Nichols and Wyman 2009, Papaioannou 2011 |
| mitsuba | the path tracer by samples a pixel |

Each method by default and as published has a time of moving frames; flicker is measured of the default, gather,
multiresolution-paper, hints, and the path tracer with 4 samples, raw and denoised, in the scenes that are path traced. Rows of papers and -open ignore occluders
between senders and receivers, as the papers do. They converge to R1, and their light in places that should be dark is a large part of relMSE, which divides by the reference at each pixel. Rows
with one bounce are compared with R2; against R3 they lack the later bounces, more than half of all indirect light in
closed, pale rooms.
"""

HINTS = """
The version of the paper (`Preset` `paper`) and the defaults (`all`), by bounces, by the six grids and numbers of samples of the paper's Table 2, and with
single properties changed; nothing is reused between frames. See [radiance hints](../methods/radiance-hints.md).
"""

CONVERGENCE = """
A picture that is [left alone](../guide.md#a-picture-left-alone): the first one, and its refinements, of 2048
virtual lights and of paths that [correct it](../methods/path-correction.md), beside the path tracer, raw and denoised. Times are those until the picture is there, from the first frame
of a new window, shaders and maps included; those of the path tracer leave out its start and the building of its scene.
"""

SKY = """
Scenes under a sky: a machine part and a statue under a uniform sky, a terrain under a blue sky with a sun of 2 degrees, a courtyard with a lamp under an
evening sky that is warm at the horizon, and four scenes with a closed form. [Depth maps](../methods/depth-maps.md#the-sky) describe the method,
[references](../reference.md) S1 and S3.
"""

SPHERES = """
Scenes under a sky that spheres can stand for: organs of a frog and a cortex, which get at most 256 spheres each, particles and the atoms of a protein.
Rows proxies sum over spheres, proxies-paper as in the [paper](../methods/sphere-proxies.md#the-papers-version); the other rows look depth maps up; finer has 512 directions, the least number whose error is expected below 0.021. All
scenes stand still; in motion maps are drawn again and spheres are not: [sums over spheres](../methods/sphere-proxies.md#time) has times of moving
spheres. [References](../reference.md) describe S1 and S3.
"""

BENCHMARKS = """# Benchmarks

Ratios within one run: frames of the compared methods alternate on one window, so that other load falls on all alike. See [multiresolution
splatting](../methods/multiresolution-splatting.md) and [radiance hints](../methods/radiance-hints.md).
"""


OF_PAPER = ("Preset", "NumberOfSamples")
"""Properties of the paper's version that ours has not."""


class Page(NamedTuple):
    """Files and texts of a comparison's page."""

    file: str
    title: str
    figures: str
    """First letters of the names of its table and plots, from the documentation's folder."""
    link: str
    """The same, from the page."""
    preface: str


PAGES = {
    "all": Page("speed-vs-error.md", "Speed against error", "speed-vs-error/", "speed-vs-error/", ALL),
    "hints": Page(
        "speed-vs-error/hints.md",
        "Speed against error: radiance hints",
        "speed-vs-error/hints-",
        "hints-",
        HINTS,
    ),
    "convergence": Page(
        "speed-vs-error/convergence.md",
        "Speed against error: pictures left alone",
        "speed-vs-error/convergence-",
        "convergence-",
        CONVERGENCE,
    ),
    "sky": Page(
        "speed-vs-error/sky.md",
        "Speed against error: light from the sky",
        "speed-vs-error/sky-",
        "sky-",
        SKY,
    ),
    "spheres": Page(
        "speed-vs-error/spheres.md",
        "Speed against error: light from the sky by spheres",
        "speed-vs-error/spheres-",
        "spheres-",
        SPHERES,
    ),
}


TOGETHER = ("all", "sky", "spheres")
"""Pages of comparisons that a run without --only makes, so that their rows are of one commit."""


def read(report: Path) -> list[dict[str, Any]]:
    """Return the rows of a comparison."""
    return json.loads((report / "rows.json").read_text(encoding="utf-8"))


def publish(report: Path, page: Page, documentation: Path) -> None:
    """Write a comparison's page, table and plots, in place of those that are there."""
    results = read(report)
    old = documentation / f"{page.figures}rows.csv"
    if old.is_file():
        for scene in {row["scene"] for row in read_table(old)}:
            (documentation / f"{page.figures}{scene}.png").unlink(missing_ok=True)
    shutil.copy(report / "rows.csv", documentation / f"{page.figures}rows.csv")
    for scene in dict.fromkeys(result["scene"] for result in results):
        if (report / f"{scene}.png").is_file():
            shutil.copy(report / f"{scene}.png", documentation / f"{page.figures}{scene}.png")
    table = f"The rows with all their columns: [rows.csv]({page.link}rows.csv)."
    alone = report.name not in TOGETHER
    how = HOW.format(only=f" --only {report.name}" if alone else " --environment")
    preface = "\n\n".join(text.strip() for text in (how, PICTURES, table, page.preface))
    summaries = {
        "all": summary_of_all,
        "convergence": beside_the_tracer,
        "hints": equals,
        "sky": light_from_the_sky,
        "spheres": light_from_the_sky,
    }
    if report.name in summaries:
        preface += "\n\n" + summaries[report.name](results)
    lines: list[str] = []
    for line in (report / "index.md").read_text(encoding="utf-8").splitlines():
        if " | ![" in line or line == "---|---":
            continue  # pictures of every row stay in the report
        if line.startswith("## ") and not any(old.startswith("## ") for old in lines):
            lines += preface.splitlines() + [""]
        line = f"# {page.title}" if line.startswith("# ") else line
        lines.append(line.replace("![error against time](", f"![error against time]({page.link}"))
    text = "\n".join(lines).rstrip() + "\n"
    while "\n\n\n" in text:
        text = text.replace("\n\n\n", "\n\n")
    (documentation / page.file).write_text(text, encoding="utf-8")
    if report.name == "all":
        for name, table in TABLES.items():
            path = documentation.parent / name
            if path.is_file() and BEGIN in path.read_text(encoding="utf-8"):
                text = with_table(path.read_text(encoding="utf-8"), table(results))
                path.write_text(text, encoding="utf-8")


def tracer_seconds(rows: list[dict[str, Any]], error: float) -> tuple[float, bool] | None:
    """Seconds of the path tracer's quickest row whose relMSE to R3 is at most `error`, and True.

    Where no row reaches that error: the seconds of the slowest row, and False. None: no row traced.
    """
    traced = [row for row in rows if row["method"] == "mitsuba" and row.get("relmse_r3") is not None]
    if not traced:
        return None
    reached = [row["indirect_ms"] for row in traced if row["relmse_r3"] <= error]
    longest = max(row["indirect_ms"] for row in traced)
    return (min(reached) / 1000.0, True) if reached else (longest / 1000.0, False)


def least_error(rows: list[dict[str, Any]]) -> float:
    """The least relMSE to R3 of the path tracer's rows."""
    return min(row["relmse_r3"] for row in rows
               if row["method"] == "mitsuba" and row.get("relmse_r3") is not None)  # fmt: skip


def error_cell(row: dict[str, Any]) -> str:
    """relMSE and bias of a row to all path-traced bounces."""
    error = row.get("relmse_r3")
    if error is None:
        return ""
    bias = round(100.0 * row["bias_r3"])
    return f"{error:.3f}, {bias:+d} %" if bias else f"{error:.3f}, 0 %"


def by_label(results: list[dict[str, Any]], scene: str) -> dict[str, dict[str, Any]]:
    """The rows of a scene that did not fail, by their labels."""
    return {row["label"]: row for row in results if row["scene"] == scene and not row.get("error")}


def at_a_glance(results: list[dict[str, Any]]) -> str:
    """A table of the default, hints and the path tracer at the default's error, a row a scene."""
    lines = [
        "## At a glance",
        "",
        "Frames of a camera that turns in a scene that stands still: plain VTK's processor time, what a "
        "frame adds over what SSAO adds, and relMSE and bias to all path-traced bounces (R3). Path "
        "tracer: the time in which Mitsuba, raw or denoised, has at most the default's relMSE, and that "
        "time over the default's whole frame; wall clock of the same processor. A time with > is that of "
        "the row with the most samples, which does not reach the default's relMSE.",
        "",
        "| scene | plain VTK, ms | SSAO, ms | default: adds, over SSAO | relMSE R3, bias | moving: adds | "
        "relMSE R3, bias | hints, 8 bounces: adds | relMSE R3, bias | path tracer, s | over the default |",
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|",
    ]
    sooner: dict[str, list[str]] = {"frame_ms": [], "first_ms": []}
    closer = []
    for scene in dict.fromkeys(row["scene"] for row in results):
        named = by_label(results, scene)
        cells = [f"{named[name]['processor_ms']:.0f}" if name in named else "" for name in ("vtk", "ssao")]
        for label in ("default", "default-moving", "hints"):
            row = named.get(label, {})
            added = row.get("added_processor_over_ssao")
            cells += ["" if added is None else f"{added:.2f}", error_cell(row)]
        error = named.get("default", {}).get("relmse_r3")
        traced = None if error is None else tracer_seconds(list(named.values()), error)
        if traced is None:
            cells += ["", ""]
        else:
            seconds, more = traced[0], "" if traced[1] else "> "
            times = 1000.0 * seconds / named["default"]["frame_ms"]
            cells += [f"{more}{seconds:.1f}", f"{more}{times:.1f}"]
            for time, scenes in sooner.items():
                if traced[1] and 1000.0 * seconds < (named["default"].get(time) or 0.0):
                    scenes.append(scene)
            if least_error(list(named.values())) < error:
                closer.append(scene)
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    names = {what: ", ".join(scenes) or "none of these scenes" for what, scenes in sooner.items()}
    lines += [
        "",
        f"Where the path tracer wins. It has the default's relMSE before the default's frame ends in: "
        f"{names['frame_ms']}; before the default's first frame, which makes all maps and shaders, is there in: "
        f"{names['first_ms']}. Its least relMSE, whatever the time, is below the default's in: "
        f"{', '.join(closer) or 'none of these scenes'}.",
    ]
    return "\n".join(lines)


NEARER = 0.9
"""A row is nearer than a quicker one from this share of its relMSE on: repeated runs differ by less."""
TIMES = {
    "first": ("first_ms", "first pictures"),
    "moving": ("moving_ms", "frames of a moving camera"),
}
"""Columns of times, and what they are times of."""


def nearest_by_time(rows: list[dict[str, Any]], time: str) -> list[dict[str, Any]]:
    """The rows of our methods that no quicker row is as near to R3 as, of the quickest first.

    Rows of another pace, whose first frame is the same, do not count.
    """
    ours = [
        row
        for row in rows
        if row["method"] not in ("vtk", "ssao", "mitsuba")
        and not row["label"].endswith("-moving")
        and row.get(time)
        and row.get("relmse_r3") is not None
    ]
    nearest: list[dict[str, Any]] = []
    for row in sorted(ours, key=lambda row: row[time]):
        if not nearest or row["relmse_r3"] < NEARER * nearest[-1]["relmse_r3"]:
            nearest.append(row)
    return nearest


def which_wins(results: list[dict[str, Any]]) -> str:
    """A table of the rows that are nearest to R3 for their time, and which of them win where."""
    lines = [
        "## Which method wins where",
        "",
        "The rows, ours alone, that are nearer to all path-traced bounces than every quicker row: wall clock and "
        f"relMSE to R3. A row counts as nearer from {NEARER} of the relMSE on. First pictures make all maps and "
        "shaders, of which a gather has fewer.",
        "",
        "| scene | first picture | moving camera |",
        "|---|---|---|",
    ]
    last: dict[str, dict[str, list[str]]] = {name: {} for name in TIMES}
    for scene in dict.fromkeys(row["scene"] for row in results):
        cells = []
        for name, (column, _) in TIMES.items():
            nearest = nearest_by_time(list(by_label(results, scene).values()), column)
            cells.append(", ".join(f"{row['label']} {row[column]:.0f} ms {row['relmse_r3']:.3f}" for row in nearest))
            if nearest:
                last[name].setdefault(nearest[-1]["label"], []).append(scene)
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    lines.append("")
    for name, (_, what) in TIMES.items():
        winners = "; ".join(f"{label} in {', '.join(scenes)}" for label, scenes in last[name].items())
        lines.append(f"Nearest of all {what}: {winners}.")
    return "\n".join(lines)


def summary_of_all(results: list[dict[str, Any]]) -> str:
    """The tables that the page of all methods begins with."""
    return f"{at_a_glance(results)}\n\n{which_wins(results)}"


README_SCENES = {"cornell_box": "Cornell box", "apartment_living": "living room", "frog": "frog"}


def table_of_readme(results: list[dict[str, Any]]) -> str:
    """README's table: whole frames of three scenes, and the default's and hints' error."""
    lines = [
        provenance(results),
        "",
        "| scene | plain VTK | VTK with `UseSSAO` | all bounces (default) | relMSE, bias | "
        "radiance hints, 8 bounces | relMSE, bias |",
        "|---|---:|---:|---:|---:|---:|---:|",
    ]
    for scene, name in README_SCENES.items():
        named = by_label(results, scene)
        cells = [f"{named[label]['processor_ms']:.0f}" for label in ("vtk", "ssao")]
        for label in ("default-moving", "hints"):
            cells += [f"{named[label]['processor_ms']:.0f}", error_cell(named[label])]
        lines.append(f"| [{name}](Testing/Scenes/{scene}.json) | " + " | ".join(cells) + " |")
    return "\n".join(lines)


GUIDE_ROWS = {
    "nothing set": "default",
    "nothing set, moving": "default-moving",
    "one bounce": "default-one-bounce",
    "`Visibility` `none`": "default-open",
    "`Visibility` `voxels`": "default-voxels",
    "256 lights, `uniform`": "uniform",
    "256 lights, `importance`": "importance",
    "`gather`": "gather",
    "`splatting`, 256 lights, `uniform`": "splatting",
    "`hints`": "hints",
}
GUIDE_TIMES = ("cornell_box", "apartment_living", "frog")
GUIDE_ERRORS = ("cornell_box", "apartment_living", "room_fire", "frog", "protein", "brain")


def table_of_guide(results: list[dict[str, Any]]) -> str:
    """The guide's table: what each method adds over what SSAO adds, and its error."""
    heads = [*(f"adds: {scene}" for scene in GUIDE_TIMES), *(f"relMSE, bias: {scene}" for scene in GUIDE_ERRORS)]
    lines = [provenance(results), ""]
    lines += ["| method | " + " | ".join(heads) + " |", "|---|" + "---:|" * len(heads)]
    for name, label in GUIDE_ROWS.items():
        rows = {scene: by_label(results, scene).get(label, {}) for scene in GUIDE_ERRORS}
        added = [rows[scene].get("added_processor_over_ssao") for scene in GUIDE_TIMES]
        cells = ["" if value is None else f"{value:.2f}" for value in added]
        cells += [error_cell(rows[scene]) for scene in GUIDE_ERRORS]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


TABLES = {
    "README.md": table_of_readme,
    "Documentation/guide.md": table_of_guide,
}
"""Tables of other pages that are made of the rows of speed-vs-error.md."""
BEGIN = "<!-- Testing/Benchmark/report writes this table -->"
END = "<!-- end of the table -->"


def with_table(text: str, table: str) -> str:
    """A page with another table between the marks."""
    before, _, rest = text.partition(BEGIN)
    after = rest.partition(END)[2]
    return f"{before}{BEGIN}\n{table}\n{END}{after}"


WORDS = ("label", "scene", "method", "error", "settings", "commit", "shader_hash", "version", "vtk", "gl",
         "gl_version", "machine")  # fmt: skip
"""Columns whose values are text even where they look like numbers."""


def read_table(path: Path) -> list[dict[str, Any]]:
    """The rows of a table of comma-separated values, with numbers where there are numbers."""

    def value(name: str, text: str) -> Any:
        if text == "":
            return None
        if name in WORDS:
            return text
        try:
            return float(text)
        except ValueError:
            return text

    with path.open(newline="", encoding="utf-8") as stream:
        return [{name: value(name, text) for name, text in row.items()} for row in csv.DictReader(stream)]


def equals(results: list[dict[str, Any]]) -> str:
    """A table of the paper's rows against ours with equal bounces, order and grid."""

    def key(row: dict[str, Any]) -> str:
        settings = {k: v for k, v in row["settings"].items() if k not in OF_PAPER}
        settings.setdefault("Order", 2)
        return json.dumps([row["scene"], settings], sort_keys=True)

    rows = [row for row in results if row["method"] == "hints" and not row.get("error")]
    theirs = [row for row in rows if row["settings"].get("Preset") == "paper"
              and "Visibility" not in row["settings"]]  # fmt: skip
    ours = {key(row): row for row in rows if "Preset" not in row["settings"]}
    lines = [
        "## Paper against ours, equal bounces, order and grid",
        "",
        "Automatic grids are equal too: both follow `ErrorTolerance`.",
        "",
        "| scene | paper | ours | relMSE R3: paper | ours | paper over ours | indirect ms: paper "
        "| ours |",
        "|---|---|---|---:|---:|---:|---:|---:|",
    ]
    for row in theirs:
        mine = ours.get(key(row))
        if mine is None or row.get("relmse_r3") is None:
            continue
        lines.append(
            f"| {row['scene']} | {row['label']} | {mine['label']} | {row['relmse_r3']:.4f} "
            f"| {mine['relmse_r3']:.4f} | {row['relmse_r3'] / mine['relmse_r3']:.1f} "
            f"| {row['indirect_ms']:.1f} | {mine['indirect_ms']:.1f} |"
        )
    return "\n".join(lines)


_SKY_COLUMNS = (
    ("frame ms", "frame_ms", "{:.0f}"),
    ("indirect ms", "indirect_ms", "{:.0f}"),
    ("adds, over SSAO", "added_over_ssao", "{:.2f}"),
    ("processor", "added_processor_over_ssao", "{:.2f}"),
    ("sky alone, over SSAO", "sky_over_ssao", "{:.2f}"),
    ("first ms", "first_ms", "{:.0f}"),
    ("nRMSE S1", "nrmse_s1", "{:.3f}"),
    ("bias S1", "bias_s1", "{:+.3f}"),
    ("relMSE S1", "relmse_s1", "{:.4f}"),
    ("nRMSE S3", "nrmse_s3", "{:.3f}"),
    ("bias S3", "bias_s3", "{:+.3f}"),
    ("relMSE S3", "relmse_s3", "{:.4f}"),
)


def light_from_the_sky(results: list[dict[str, Any]]) -> str:
    """A table of moving and still frames under a sky: time, and error to S1 and S3 in its row."""
    lines = [
        "## Light from the sky",
        "",
        "Defaults, at the pace of each row; plain VTK's row is the frame and the error without any "
        "light of the sky. Indirect: all that the pass adds to surfaces, light maps and VTK's own "
        "light; what surfaces reflect of the sky is in it. Sky alone: the stage that sums its direct "
        "light, by wall clock.",
        "",
        "| scene | frame | " + " | ".join(title for title, _, _ in _SKY_COLUMNS) + " |",
        "|---|---|" + "---:|" * len(_SKY_COLUMNS),
    ]
    for scene in dict.fromkeys(row["scene"] for row in results):
        rows = [row for row in results if row["scene"] == scene]
        for row in rows:
            if not (row.get("pace") or row["method"] == "vtk"):
                continue
            cells = [
                form.format(row[key]) if row.get(key) is not None else ""
                for _, key, form in _SKY_COLUMNS
            ]
            if row.get("error"):
                cells = [f"failed: {row['error']}".replace("|", "\\|"), *[""] * (len(cells) - 1)]
            lines.append(f"| {scene} | {row['label']} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def beside_the_tracer(results: list[dict[str, Any]]) -> str:
    """Return each picture beside the path tracer's denoised picture of at most the same time."""
    lines = [
        "| scene | picture | s | relMSE R3 | bias | path tracer, denoised, no later: s | relMSE R3 |",
        "|---|---|---:|---:|---:|---:|---:|",
    ]
    behind = []
    for row in results:
        if row["label"].split(" ")[0] != "picture":
            continue
        seconds, error = row["first_ms"] / 1000, row["relmse_r3"]
        traced = [
            (other["indirect_ms"] / 1000, other["relmse_r3"])
            for other in results
            if other["scene"] == row["scene"] and f"{comparison.DENOISED} " in other["label"]
        ]
        sooner = max((pair for pair in traced if pair[0] <= seconds), default=None)
        cells = ("none", "") if sooner is None else (f"{sooner[0]:.1f}", f"{sooner[1]:.4f}")
        name = row["label"].partition("=")[2] or "0"
        lines.append(
            f"| {row['scene']} | {name} | {seconds:.1f} | {error:.4f} | {row['bias_r3']:+.3f} "
            f"| {cells[0]} | {cells[1]} |"
        )
        if sooner is not None and sooner[1] < error:
            behind.append(f"{row['scene']} {name}")
    said = (
        "Numbers of pictures are numbers of refinements. In no more time, the denoised path tracer is "
        f"nearer to the truth in: {', '.join(behind)}."
        if behind
        else "Numbers of pictures are numbers of refinements. The denoised path tracer is nearer to "
        "the truth in none of these scenes in the time of a picture."
    )
    return said + "\n\n" + "\n".join(lines)


def mixed(results: list[dict[str, Any]]) -> str:
    """Return what differs between rows that one run has made; empty: nothing."""
    for name in ("commit", "shader_hash", "vtk", "gl"):
        values = {row[name] for row in results if row.get(name)}
        if len(values) > 1:
            return f"rows of several runs: {name} is {' and '.join(sorted(values))}"
    return ""


def here() -> dict[str, Any]:
    """Return what a row of a comparison would say of this machine, its OpenGL and this commit."""
    scene = load_scene(Path(__file__).resolve().parent.parent / "Scenes" / "contact_corner.json")
    window = frames.open_window(scene, (32, 32))
    report = frames.render(scene, window, frames.Job())
    window.Finalize()
    return {
        **{name: report[name] for name in ("version", "vtk", "shader_hash")},
        "gl": report["gl"]["renderer"],
        "gl_version": report["gl"]["version"],
        "commit": comparison.commit(Path(__file__).parent),
        "machine": comparison.machine(),
    }


def publish_tables(reports: Path, documentation: Path) -> None:
    """Write the page of what the benchmarks printed on this machine at this commit."""
    texts = [BENCHMARKS, provenance([here()]), HOW.format(only=" --only benchmarks")]
    texts += [file.read_text(encoding="utf-8") for file in sorted(reports.glob("*.md"))]
    text = "\n\n".join(part.strip() for part in texts) + "\n"
    (documentation / "speed-vs-error" / "benchmarks.md").write_text(text, encoding="utf-8")


def main() -> int:
    """Publish the pages that the command line names; returns the exit code."""
    known = (*PAGES, "area", "benchmarks")
    names = sys.argv[3:]
    if not names or not set(names) <= set(known):
        print(f"usage: publish.py REPORTS DOCUMENTATION PAGE... (of {', '.join(known)})", file=sys.stderr)
        return 2
    reports, documentation = Path(sys.argv[1]), Path(sys.argv[2])
    compared = [name for name in names if name in PAGES]
    missing = [name for name in compared if not (reports / name / "rows.json").is_file()]
    if missing:
        print(f"publish.py: {reports} has no rows.json of {', '.join(missing)}", file=sys.stderr)
        return 2
    every = [row for name in compared for row in read(reports / name)]
    if mixed(every):
        print(f"publish.py: {mixed(every)}; remove {reports} and run it again", file=sys.stderr)
        return 1
    (documentation / "speed-vs-error").mkdir(exist_ok=True)
    for name in compared:
        publish(reports / name, PAGES[name], documentation)
    if "area" in names:
        shutil.copy(reports / "area_sweep.page", documentation / "speed-vs-error" / "area.md")
    if "benchmarks" in names:
        publish_tables(reports, documentation)
    return 0


if __name__ == "__main__":
    sys.exit(main())
