#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Traces a scene file with given numbers of samples and says how long each took.

    trace_rows.py SCENE.json FOLDER < job

Standard input is JSON: {"size": [width, height], "rows": [{"name", "samples", "depth", maybe
"azimuth"}]}. For each row FOLDER gets NAME.npz with `image`, the irradiance by bounces 1 to `depth`,
and `seconds`, the times of its repetitions: tracing only, warmed up, without loading, compiling and
the rays from the eye. A row with an azimuth, in degrees, is of a camera turned by that angle, has noise
of its own, and is traced once. A line "row NAME" says that it is there; the last line is "versions" and JSON. Rows of one
azimuth in a row share one process. The comparison runs this script, so that the path tracer stands beside
the methods.
"""

from __future__ import annotations

import itertools
import json
import sys
from pathlib import Path
from typing import Any

import exporter
import tools

REPEATS = 3


def main() -> int:
    """Trace what standard input asks for; returns the exit code."""
    if len(sys.argv) != 3:
        print("usage: trace_rows.py SCENE.json FOLDER < job", file=sys.stderr)
        return 2
    path, folder = Path(sys.argv[1]), Path(sys.argv[2])
    wanted = json.load(sys.stdin)

    def batch(row: dict[str, Any]) -> dict[str, Any]:
        turned = ["azimuth", row["azimuth"]] if "azimuth" in row else []
        return {
            "file": f"{row['name']}.npz",
            "kind": "bounces",
            "samples": row["samples"],
            "depth": row["depth"],
            # Not the seeds of the references, or their noise would look like the truth.
            "seed": [path.stem, "row", row["samples"], row["depth"], *turned],
            "repeats": 1 if turned else REPEATS,
        }

    def done(file: str) -> None:
        print(f"row {Path(file).stem}", flush=True)

    try:
        for azimuth, rows in itertools.groupby(wanted["rows"], lambda row: row.get("azimuth", 0.0)):
            tools.describe(path, azimuth).save(folder)
            job = {"size": wanted["size"], "batches": [batch(row) for row in rows]}
            versions = tools.trace(folder, job, on_batch=done)
    except (tools.ToolError, exporter.ExportError) as error:
        return tools.fail(error)
    print("versions " + json.dumps(versions), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
