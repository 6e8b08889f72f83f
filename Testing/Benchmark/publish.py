# SPDX-License-Identifier: BSD-3-Clause
"""Puts a comparison's table and plots into the documentation: publish.py REPORT_DIRECTORY.

The report is made by ``vtk-indirect compare`` with Testing/Benchmark/report.json; see
Documentation/speed-vs-error.md, which this writes, for the command.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

DOCUMENTATION = Path(__file__).resolve().parent.parent.parent / "Documentation"

PREFACE = """
Regenerate with

    build/bin/vtk-indirect compare Testing/Scenes/{cornell_box,room_fire,apartment_living,frog,protein,brain}.json \\
      --sweep Testing/Benchmark/report.json --frames 5 -o report
    python3 Testing/Benchmark/publish.py report

which also writes difference images. The rows with all their columns: [rows.csv](speed-vs-error/rows.csv).

How to read it: R1 is what the method converges to as virtual lights grow, so the columns R1 are its sampling
error, most of it where surfaces meet. R2 adds what ignoring visibility between sender and receiver costs: the
bias turns positive. R3 adds the bounces that one bounce leaves out: the bias is negative. In closed, pale rooms
(the apartment) more than half of all indirect light is beyond the first bounce.
"""


def main() -> int:
    """Write the page; returns the exit code."""
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "rows.json").is_file():
        print("usage: publish.py REPORT_DIRECTORY (with rows.json)", file=sys.stderr)
        return 2
    report = Path(sys.argv[1])
    results = json.loads((report / "rows.json").read_text(encoding="utf-8"))
    target = DOCUMENTATION / "speed-vs-error"
    target.mkdir(exist_ok=True)
    shutil.copy(report / "rows.csv", target / "rows.csv")
    scenes = list(dict.fromkeys(result["scene"] for result in results))
    for scene in scenes:
        shutil.copy(report / f"{scene}.png", target / f"{scene}.png")
    lines = []
    for line in (report / "index.md").read_text(encoding="utf-8").splitlines():
        if " | ![" in line or line == "---|---":
            continue  # pictures of every row stay in the report
        if line.startswith("## ") and not any(old.startswith("## ") for old in lines):
            lines += PREFACE.strip().splitlines() + [""]
        lines.append(line.replace("![error against time](", "![error against time](speed-vs-error/"))
    text = "\n".join(lines).rstrip() + "\n"
    while "\n\n\n" in text:
        text = text.replace("\n\n\n", "\n\n")
    (DOCUMENTATION / "speed-vs-error.md").write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
