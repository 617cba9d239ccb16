#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
"""Turns what bench_gcode measured and what jobs report into BENCHMARK.md's tables.

gcode_report.py BENCH.json JOBS [--page BENCHMARK.md]

JOBS has a folder for each job, PART/POST and PART/POST--no-arcs. Of repeated measurements
the quickest counts. Prints the tables; with --page, puts them between that file's marks.
"""
import argparse
import json
import pathlib

from bench_report import number, power, put
from rough_report import table

# The parts by the names of their folders.
PARTS = {
    "sample": "sample scan, 100 x 70 mm",
    "dome": "dome, 60 x 60 mm",
    "freeform": "freeform, 100 x 100 mm",
}


def speeds(runs):
    """Of each control: blocks per second written and read, of one number of blocks."""
    best = {}
    for run in runs:
        if run.get("run_type") == "aggregate":
            continue
        way, post, blocks = run["name"].split("/")[:3]
        kept = best.setdefault((post, int(blocks)), {})
        if way not in kept or run["real_time"] < kept[way]["real_time"]:
            kept[way] = run
    rows = []
    for (post, blocks), run in best.items():
        written, read = run["write"], run.get("read")
        per_block = written["bytes/s"] / written["blocks/s"]
        rows.append(
            [post, power(blocks), f"{per_block:.1f}"]
            + [number(way["real_time"] / 1e3) for way in (written, read)]
            + [number(way["blocks/s"] / 1e6) for way in (written, read)]
        )
    head = ["post", "CL points", "bytes a block", "write s", "read s"]
    return table(head + ["million blocks/s written", "read"], rows)


def figures(report):
    program, verification = report["program"], report["verification"]
    return [
        f"{program['lines']:,}",
        f"{program['bytes']:,}",
        number(1e3 * verification["gouge_max_mm"]),
        number(report["minutes"]),
    ]


def jobs(folder):
    """A table with a line for each job, of the parts in the order above."""
    rows = []
    for part, title in PARTS.items():
        for file in sorted((folder / part).glob("*/report.json")):
            with open(file, encoding="utf-8") as stream:
                report = json.load(stream)
            program = report["program"]
            planned = f"{program['feed_moves_planned']:,}"
            way = "arcs" if program["arcs"] else "chords only"
            rows.append([title, program["control"], planned, way, *figures(report)])
    head = ["part", "control", "CL moves", "written as", "blocks", "bytes", "gouge um"]
    return table(head + ["minutes"], rows)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("bench")
    arguments.add_argument("jobs", type=pathlib.Path)
    arguments.add_argument("--page")
    options = arguments.parse_args()
    with open(options.bench, encoding="utf-8") as bench:
        text = speeds(json.load(bench)["benchmarks"])
    text += "\n\n" + jobs(options.jobs)
    print(text)
    if options.page:
        put(options.page, "programs", text)


if __name__ == "__main__":
    main()
