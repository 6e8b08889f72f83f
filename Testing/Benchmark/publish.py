# SPDX-License-Identifier: BSD-3-Clause
"""Puts a comparison's table and plots into the documentation: publish.py REPORT [DOCUMENTATION].

REPORT is a directory that ``vtk-indirect compare`` has made. Testing/Benchmark/report does both.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

DOCUMENTATION = Path(__file__).resolve().parent.parent.parent / "Documentation"

PREFACE = """
Regenerate this page with one command, which also writes difference images of every row (build/report):

    Testing/Benchmark/report --environment

The rows with all their columns: [rows.csv](speed-vs-error/rows.csv).

How to read it: R1 is what the method converges to as virtual lights grow, so the columns R1 are its sampling
error, most of it where surfaces meet. R2 adds what ignoring visibility between sender and receiver costs: the
bias turns positive. R3 adds the bounces that one bounce leaves out: the bias is negative. In closed, pale rooms
(the apartment) more than half of all indirect light is beyond the first bounce. The relMSE divides by the
reference at each pixel, so light where there should be none weighs most: behind the thin wall of two_rooms a
method that does not test visibility is further from the truth than no indirect light at all.
"""


def publish(report: Path, documentation: Path) -> None:
    """Write the page, the table and the plots."""
    results = json.loads((report / "rows.json").read_text(encoding="utf-8"))
    target = documentation / "speed-vs-error"
    target.mkdir(exist_ok=True)
    for old in target.glob("*.png"):
        old.unlink()
    shutil.copy(report / "rows.csv", target / "rows.csv")
    for scene in dict.fromkeys(result["scene"] for result in results):
        if (report / f"{scene}.png").is_file():
            shutil.copy(report / f"{scene}.png", target / f"{scene}.png")
    lines: list[str] = []
    for line in (report / "index.md").read_text(encoding="utf-8").splitlines():
        if " | ![" in line or line == "---|---":
            continue  # pictures of every row stay in the report
        if line.startswith("## ") and not any(old.startswith("## ") for old in lines):
            lines += PREFACE.strip().splitlines() + [""]
        lines.append(
            line.replace("![error against time](", "![error against time](speed-vs-error/")
        )
    text = "\n".join(lines).rstrip() + "\n"
    while "\n\n\n" in text:
        text = text.replace("\n\n\n", "\n\n")
    (documentation / "speed-vs-error.md").write_text(text, encoding="utf-8")


def main() -> int:
    """Publish what the command line names; returns the exit code."""
    if len(sys.argv) not in (2, 3) or not (Path(sys.argv[1]) / "rows.json").is_file():
        print("usage: publish.py REPORT [DOCUMENTATION] (REPORT has rows.json)", file=sys.stderr)
        return 2
    publish(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) == 3 else DOCUMENTATION)
    return 0


if __name__ == "__main__":
    sys.exit(main())
