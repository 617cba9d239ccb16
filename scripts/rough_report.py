#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
"""Turns what bench_rough and compare_roughing measured into BENCHMARK.md's tables.

rough_report.py BENCH.json COMPARE.json [--page BENCHMARK.md]

Of repeated measurements the quickest counts. Prints the tables; with --page, puts them
between that file's marks.
"""
import argparse
import json

from bench_report import number, put

# What a job of bench_rough is, by the first part of its name.
CASES = {
    "layer": "one layer",
    "plate": "large plate",
    "scan": "10<sup>7</sup> points",
}


def share_in_air(row):
    return 100 * row["air_mm"] / row["feed_mm"]


def lifts(row):
    return row["lifts"] + row["retracts"]


# A figure of compare_roughing: its head, its key or what computes it, what that is
# divided by, and whether it means something for figures added up over the parts. A new
# figure needs a line here.
FIGURES = [
    ("CL points", "cl_points", 1, True),
    ("feed m", "feed_mm", 1e3, True),
    ("in air m", "air_mm", 1e3, True),
    ("in air %", share_in_air, 1, True),
    ("rapid m", "rapid_mm", 1e3, True),
    ("lifts", lifts, 1, True),
    ("minutes", "minutes", 1, True),
    ("mean width mm", "mean_width_mm", 1, False),
    ("max width mm", "max_width_mm", 1, False),
    ("max depth mm", "max_depth_mm", 1, False),
    ("removed cm3", "removed_mm3", 1e3, True),
    ("left cm3", "left_mm3", 1e3, True),
    ("plan ms", "plan_s", 1e-3, True),
    ("link ms", "link_s", 1e-3, True),
]
PICTURES_A_ROW = 3


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def times(runs, titles):
    """Times and sizes of each case and strategy, the quickest of its repetitions."""
    best = {}
    for run in runs:
        if run.get("run_type") != "aggregate":
            kept = best.setdefault(tuple(run["name"].split("/")[:2]), run)
            for time in ("real_time", "cpu_time"):
                kept[time] = min(kept[time], run[time])
    rows = []
    for (case, strategy), run in best.items():
        rows.append(
            [
                CASES[case],
                titles[strategy],
                f"{run['cells']:,.0f}",
                f"{run['levels']:.0f}",
                f"{run['cl_points']:,.0f}",
                f"{run['cut_mm']:,.0f}",
                number(run["real_time"]),
                number(run["cpu_time"]),
            ]
        )
    head = ["job", "strategy", "cells", "levels", "CL points", "mm", "ms", "CPU ms"]
    return table(head, rows)


def cell(row, figure, scale):
    value = figure(row) if callable(figure) else row[figure]
    return f"{value:,}" if isinstance(value, int) else number(value / scale)


def figures(rows, columns):
    """A table with a line for each strategy."""
    lines = [
        [row["title"]] + [cell(row, figure, scale) for _, figure, scale, _ in columns]
        for row in rows
    ]
    return table(["strategy"] + [column[0] for column in columns], lines)


def pictures(part):
    """Rows of a table, each with some of the pictures under their titles."""
    shown = [s for s in part["strategies"] if "picture" in s]
    blocks = []
    for i in range(0, len(shown), PICTURES_A_ROW):
        row = shown[i : i + PICTURES_A_ROW]
        images = [
            f"![{part['title']}, {s['title']}](doc/images/{s['picture']})" for s in row
        ]
        blocks.append(table([s["title"] for s in row], [images]))
    return "\n\n".join(blocks)


def total(parts):
    """What a strategy needs for all parts."""
    sums = []
    for rows in zip(*(part["strategies"] for part in parts)):
        added = {"title": rows[0]["title"]}
        for key, value in rows[0].items():
            if not isinstance(value, str):
                added[key] = sum(row[key] for row in rows)
        sums.append(added)
    return figures(sums, [column for column in FIGURES if column[3]])


def report(bench, compared):
    parts = compared["parts"]
    titles = {s["name"]: s["title"] for s in parts[0]["strategies"]}
    blocks = [times(bench["benchmarks"], titles), "### All five parts", total(parts)]
    for part in parts:
        size = " x ".join(f"{edge:g}" for edge in (round(e, 1) for e in part["size_mm"]))
        blocks.append(f"### {part['title'].capitalize()}, {size} mm")
        blocks += [figures(part["strategies"], FIGURES), pictures(part)]
    return "\n\n".join(block for block in blocks if block)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("bench")
    arguments.add_argument("compare")
    arguments.add_argument("--page")
    options = arguments.parse_args()
    with open(options.bench, encoding="utf-8") as bench, open(
        options.compare, encoding="utf-8"
    ) as compare:
        text = report(json.load(bench), json.load(compare))
    print(text)
    if options.page:
        put(options.page, "roughing", text)


if __name__ == "__main__":
    main()
