#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
"""Turns what bench_viewer measured into BENCHMARK.md's table.

viewer_report.py BENCH.json [--page BENCHMARK.md]

Of repeated measurements the quickest counts. Prints the table; with --page, puts it
between that file's marks.
"""
import argparse
import json

from bench_report import number, put
from rough_report import table
from verify_report import quickest

WHAT = {
    ("paths", "moving"): "paths, while the view turns",
    ("paths", "still"): "paths, every point and smooth",
    ("play", "-"): "the cut, as it is played",
}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("bench")
    arguments.add_argument("--page")
    options = arguments.parse_args()
    with open(options.bench, encoding="utf-8") as bench:
        best = quickest(json.load(bench)["benchmarks"])
    rows = []
    for (what, title) in WHAT.items():
        for (group, _, case), run in best.items():
            if (group, case) == what:
                per_second = number(1000 / run["real_time"])
                rows.append([title, f"{run['points']:,.0f}", per_second])
    text = table(["what", "CL points", "pictures/s"], rows)
    print(text)
    if options.page:
        put(options.page, "viewer", text)


if __name__ == "__main__":
    main()
