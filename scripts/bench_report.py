#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
"""Turns what bench_drop measured into the table of BENCHMARK.md and a plot.

bench_report.py FILE.json... --page BENCHMARK.md --plot doc/images/bench.svg

Of repeated measurements the quickest counts. Prints the table; with --page, puts it
between that file's marks; with --plot, draws seconds over the number of points.
"""
import argparse
import json
import math
import re

# Route in the names of the benchmarks, its name in the table, colour (Okabe and Ito's,
# which the colour-blind tell apart) and dashes in the plot. A new route needs a line here.
ROUTES = [
    ("points_2", "PointIndex, 2 threads", "#0072b2", ""),
    ("points_1", "PointIndex, 1 thread", "#56b4e9", "7 4"),
    ("smooth_2", "SurfaceModel, 2 threads", "#cc79a7", ""),
    ("single_drops", "PointIndex, drop by drop", "#009e73", "2 4"),
    ("kd_tree", "kd-tree of PCL, 1 thread", "#e69f00", ""),
    ("brute_force", "every point, 1 thread", "#d55e00", ""),
]


def read(files):
    """{(route, surface): {points: best measurement}}"""
    best = {}
    for file in files:
        with open(file, encoding="utf-8") as stream:
            runs = json.load(stream)["benchmarks"]
        for run in runs:
            if run.get("run_type") == "aggregate":
                continue
            route, surface, points = run["name"].split("/")[:3]
            run.setdefault("seconds", run["cpu_time"])  # chords have no more
            series = best.setdefault((route, surface), {})
            old = series.get(float(points))
            if old is None or run["seconds"] < old["seconds"]:
                series[float(points)] = run
    return best


def power(points):
    exponent = round(math.log10(points))
    return f"10<sup>{exponent}</sup>" if points == 10**exponent else f"{points:g}"


def number(value):
    """Three digits at most, no exponent."""
    if value >= 100:
        return f"{value:,.0f}"
    if value < 1e-6:
        return "-"
    return f"{value:.{max(0, 2 - math.floor(math.log10(value)))}f}"


def table(best):
    lines = [
        "| points | route | seconds | index | drops | GiB | RMS um | p99 um | max um |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    sizes = sorted({n for (_, s), runs in best.items() if s == "freeform" for n in runs})
    for size in sizes:
        for route, name, _, _ in ROUTES:
            run = best.get((route, "freeform"), {}).get(size)
            if not run:
                continue
            cells = [power(size), name, number(run["seconds"])]
            cells += [number(run[k]) for k in ("index_s", "drop_s", "memory_GiB")]
            cells += [number(run[k]) for k in ("rms_um", "p99_um", "max_um")]
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def more(best):
    """What the other surfaces and the chords say."""
    lines = [
        "| points | hemisphere RMS / p99 um | level ground sinks by um, expected | chord us |",
        "|---|---|---|---|",
    ]
    for size, run in sorted(best.get(("points_2", "hemisphere"), {}).items()):
        level = best[("points_2", "level")][size]
        chord = best[("chord", "freeform")][size]
        expected = 1e3 / (2 * math.pi * size / 1e4 * 1.5)
        lines.append(
            f"| {power(size)} | {number(run['rms_um'])} / {number(run['p99_um'])} "
            f"| {number(-level['mean_um'])}, {number(expected)} "
            f"| {number(chord['cpu_time'] / 1e3)} |"
        )
    return "\n".join(lines)


def plot(best):
    series = [
        (name, colour, dash, sorted(best[(route, "freeform")].items()))
        for route, name, colour, dash in ROUTES
        if (route, "freeform") in best
    ]
    points = [n for s in series for n, _ in s[3]]
    seconds = [run["seconds"] for s in series for _, run in s[3]]
    x0, x1 = math.log10(min(points)), math.log10(max(points))
    y0, y1 = math.floor(math.log10(min(seconds))), math.ceil(math.log10(max(seconds)))
    left, top, width, height, legend = 70, 20, 420, 320, 240

    def px(n):
        return left + width * (math.log10(n) - x0) / max(x1 - x0, 1e-9)

    def py(s):
        return top + height * (y1 - math.log10(s)) / (y1 - y0)

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + width + legend}" '
        f'height="{top + height + 60}" font-family="sans-serif" font-size="13">',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    for e in range(y0, y1 + 1):
        y, label = py(10.0**e), f"{10.0**e:g}"
        out.append(f'<path d="M{left} {y:.1f}h{width}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
    for e in range(math.ceil(x0), math.floor(x1) + 1):
        x = px(10.0**e)
        out.append(f'<path d="M{x:.1f} {top}v{height}" stroke="#ddd"/>')
        out.append(
            f'<text x="{x:.1f}" y="{top + height + 20}" text-anchor="middle">10'
            f'<tspan dy="-6" font-size="10">{e}</tspan></text>'
        )
    middle = left + width / 2
    out.append(
        f'<text x="{middle}" y="{top + height + 44}" text-anchor="middle">points</text>'
    )
    out.append(
        f'<text x="18" y="{top + height / 2}" text-anchor="middle" '
        f'transform="rotate(-90 18 {top + height / 2})">'
        "seconds for 333,000 CL points</text>"
    )
    # The legend in the order of the lines' right ends.
    series.sort(key=lambda s: -s[3][-1][1]["seconds"])
    for k, (name, colour, dash, runs) in enumerate(series):
        style = f'stroke="{colour}" stroke-width="2.5" stroke-dasharray="{dash}"'
        path = " ".join(f"{px(n):.1f},{py(run['seconds']):.1f}" for n, run in runs)
        out.append(f'<polyline points="{path}" fill="none" {style}/>')
        for n, run in runs:
            out.append(
                f'<circle cx="{px(n):.1f}" cy="{py(run["seconds"]):.1f}" r="3.5" '
                f'fill="{colour}"/>'
            )
        y = top + 14 + 24 * k
        x = left + width + 16
        out.append(f'<path d="M{x} {y}h26" {style}/>')
        out.append(f'<text x="{x + 32}" y="{y + 4}">{name}</text>')
    out.append("</svg>")
    return "\n".join(out) + "\n"


def put(path, mark, text):
    """Replaces what stands between <!-- mark: ... --> and <!-- /mark --> of a page."""
    with open(path, encoding="utf-8") as page:
        old = page.read()
    new, found = re.subn(
        rf"(<!-- {mark}:[^\n]*\n).*(<!-- /{mark} -->)",
        lambda m: m[1] + "\n" + text + "\n\n" + m[2],
        old,
        flags=re.S,
    )
    if not found:
        raise SystemExit(f"{path} has no marks for {mark}")
    with open(path, "w", encoding="utf-8") as page:
        page.write(new)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("files", nargs="+")
    arguments.add_argument("--page")
    arguments.add_argument("--plot")
    options = arguments.parse_args()
    best = read(options.files)
    text = table(best) + "\n\n" + more(best)
    print(text)
    if options.plot:
        with open(options.plot, "w", encoding="utf-8") as out:
            out.write(plot(best))
    if options.page:
        put(options.page, "figures", text)


if __name__ == "__main__":
    main()
