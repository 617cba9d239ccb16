#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
"""Turns what bench_verify measured into BENCHMARK.md's tables.

verify_report.py BENCH.json [--page BENCHMARK.md]

Of repeated measurements the quickest counts. Prints the tables; with --page, puts them
between that file's marks.
"""
import argparse
import json

from bench_report import number, put
from rough_report import table

# The tools by their names in bench_verify.
TOOLS = {
    "ball_6": "ball 6 mm",
    "bull_6": "bull nose 6 mm, corner 1 mm",
    "taper_ball_1": "tapered ball 1 mm, 5 degrees",
}


def quickest(runs):
    """{(group, case, way): the quickest of its repetitions}"""
    best = {}
    for run in runs:
        if run.get("run_type") == "aggregate":
            continue
        key = tuple(run["name"].split("/")[:3])
        kept = best.setdefault(key, run)
        for time in ("real_time", "cpu_time"):
            kept[time] = min(kept[time], run[time])
    return best


def verified(best):
    rows = []
    for (group, tool, threads), run in best.items():
        if group == "verify":
            rows.append(
                [TOOLS[tool], threads[-1], f"{run['moves']:,.0f}", f"{run['cells']:,.0f}"]
                + [number(run[key]) for key in ("real_time", "cpu_time", "gouge_um")]
                + [number(run["residual_p99_um"])]
            )
    head = ["tool", "threads", "moves", "cells", "s", "CPU s", "gouge um"]
    return table(head + ["left p99 um"], rows)


def stock(best):
    rows = []
    for tool, title in TOOLS.items():
        swept = best[("stock", tool, "swept")]
        stamped = best[("stock", tool, "stamped")]
        seconds = [run["cpu_time"] for run in (swept, stamped)]
        ratio = number(seconds[1] / seconds[0])
        rows.append([title, *map(number, seconds), ratio, number(stamped["left_um"])])
    head = ["tool", "swept CPU s", "stamped CPU s", "ratio", "stamps leave um"]
    return table(head, rows)


def level(best):
    rows = []
    on, deep = (
        next(run for key, run in best.items() if key[:2] == ("level", case))
        for case in ("on_it", "too_deep")
    )
    shown = [("deepest gouge, 0.05 mm too deep", deep, "gouge")]
    shown += [(f"left over, {q}", on, f"left_{q}") for q in ("p50", "p99", "max")]
    for title, run, key in shown:
        rows.append([title, f"{run[key + '_um']:.3f}", f"{run[key + '_true_um']:.3f}"])
    return table(["level ground, ball 6 mm", "found um", "closed form um"], rows)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("bench")
    arguments.add_argument("--page")
    options = arguments.parse_args()
    with open(options.bench, encoding="utf-8") as bench:
        best = quickest(json.load(bench)["benchmarks"])
    text = "\n\n".join(show(best) for show in (verified, stock, level))
    print(text)
    if options.page:
        put(options.page, "verification", text)


if __name__ == "__main__":
    main()
