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


# A figure of compare_roughing: its key, its head, what it is divided by, and whether it
# is added up over the parts. A new figure needs a line here.
FIGURES = [
    ("cl_points", "CL points", 1, True),
    ("passes", "passes", 1, True),
    ("retracts", "retracts", 1, True),
    ("cutting_mm", "feed m", 1e3, True),
    ("rapid_mm", "rapid m", 1e3, True),
    ("minutes", "minutes", 1, True),
    ("removed_mm3", "removed cm3", 1e3, True),
    ("left_mm3", "left cm3", 1e3, True),
    ("plan_s", "plan ms", 1e-3, True),
    ("link_s", "link ms", 1e-3, True),
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


def cell(value, scale):
    return f"{value:,}" if isinstance(value, int) else number(value / scale)


def figures(strategies, columns):
    shown = [f for f in columns if f[0] in strategies[0]]
    rows = [
        [s["title"]] + [cell(s[key], scale) for key, _, scale, _ in shown]
        for s in strategies
    ]
    return table(["strategy"] + [title for _, title, _, _ in shown], rows)


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
    for i, strategy in enumerate(parts[0]["strategies"]):
        added = {"title": strategy["title"]}
        for key, _, _, adds in FIGURES:
            if adds and key in strategy:
                added[key] = sum(part["strategies"][i][key] for part in parts)
        sums.append(added)
    return figures(sums, [f for f in FIGURES if f[3]])


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
