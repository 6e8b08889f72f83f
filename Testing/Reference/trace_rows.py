#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Traces a scene file with given numbers of samples and says how long each took.

    trace_rows.py SCENE.json FOLDER < job

Standard input is JSON: {"size": [width, height], "rows": [{"name", "samples", "depth"}]}. For each
row FOLDER gets NAME.npz with `image`, the irradiance by bounces 1 to `depth`, and `seconds`, the
times of its repetitions: tracing only, warmed up, without loading, compiling and the rays from the
eye. A line "row NAME" says that it is there; the last line is "versions" and JSON. `vtk-indirect
compare` runs this, so that the path tracer stands beside the methods.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

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
    batches = [
        {
            "file": f"{row['name']}.npz",
            "kind": "bounces",
            "samples": row["samples"],
            "depth": row["depth"],
            # Not the seeds of the references, or their noise would look like the truth.
            "seed": [path.stem, "row", row["samples"], row["depth"]],
            "repeats": REPEATS,
        }
        for row in wanted["rows"]
    ]

    def done(file: str) -> None:
        print(f"row {Path(file).stem}", flush=True)

    try:
        tools.describe(path).save(folder)
        job = {"size": wanted["size"], "batches": batches}
        versions = tools.trace(folder, job, on_batch=done, niceness=0)
    except (tools.ToolError, exporter.ExportError) as error:
        return tools.fail(error)
    print("versions " + json.dumps(versions), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
