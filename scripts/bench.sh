#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/bench.sh [drop|rough|gcode|verify|viewer] [OPTION...]
#   Builds and runs the benchmarks, prints their tables, and puts those into BENCHMARK.md:
#     drop   the engine, with the plot doc/images/bench.svg. OPTIONs go to bench_drop:
#            --points=1e5,1e6,1e7,1e8 takes other numbers of points (the last needs
#            5 GiB), the rest is Google Benchmark's.
#     rough  the roughing strategies, with the pictures doc/images/rough_*.png. OPTIONs go
#            to bench_rough, they are Google Benchmark's.
#     gcode  writing and reading programs, and their sizes with and without arcs. OPTIONs
#            go to bench_gcode, they are Google Benchmark's.
#     verify the verification of an hour of finishing. OPTIONs are Google Benchmark's.
#     viewer the viewer with a million CL points. OPTIONs are Google Benchmark's.
#   Without a word all are run, and take no OPTIONs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

which=${1-all}
case $which in
  drop | rough | gcode | verify | viewer) shift ;;
  all) ;;
  *) sed -n 's/^# \{0,1\}//; 5,18p' "$0" >&2; exit 1 ;;
esac

scripts/dependencies.sh build bench
# The tests need more packages; where they are off, they stay off.
options=(-DPOINTMILL_BUILD_BENCH=ON)
[ -e build/release/build.ninja ] || options+=(-DPOINTMILL_BUILD_TESTS=OFF)
cmake --preset release "${options[@]}"

if [ "$which" = drop ] || [ "$which" = all ]; then
  cmake --build --preset release --target bench_drop
  build/release/bin/bench_drop --benchmark_repetitions=3 \
    --benchmark_out=build/release/bench.json --benchmark_out_format=json "$@"
  scripts/bench_report.py build/release/bench.json --page BENCHMARK.md \
    --plot doc/images/bench.svg
fi

if [ "$which" = rough ] || [ "$which" = all ]; then
  cmake --build --preset release --target bench_rough compare_roughing
  build/release/bin/bench_rough --benchmark_repetitions=5 \
    --benchmark_out=build/release/bench_rough.json --benchmark_out_format=json "$@"
  rm -f doc/images/rough_*.png
  build/release/bin/compare_roughing --pictures doc/images --width 600 \
    >build/release/compare_roughing.json
  scripts/rough_report.py build/release/bench_rough.json \
    build/release/compare_roughing.json --page BENCHMARK.md
fi

if [ "$which" = gcode ] || [ "$which" = all ]; then
  cmake --build --preset release --target bench_gcode pointmill pointmill_samples
  build/release/bin/bench_gcode --benchmark_repetitions=3 \
    --benchmark_out=build/release/bench_gcode.json --benchmark_out_format=json "$@"
  jobs=build/release/gcode_jobs
  rm -rf "$jobs"
  mkdir -p "$jobs"
  build/release/bin/pointmill_samples --freeform 300000 "$jobs/freeform.pcd"
  cp data/dome.pcd "$jobs/dome.pcd"
  cp data/sample_scan.pcd "$jobs/sample.pcd"
  mill() { # PART POST [OPTION]
    mkdir -p "$jobs/$1"
    build/release/bin/pointmill mill "$jobs/$1.pcd" -q --post "$2" -o "$jobs/$1/$2${3-}" ${3-}
  }
  for part in sample dome freeform; do
    mill $part linuxcnc
    mill $part linuxcnc --no-arcs
  done
  for post in fanuc grbl haas heidenhain heidenhain-iso mach siemens; do
    mill dome $post
  done
  scripts/gcode_report.py build/release/bench_gcode.json "$jobs" --page BENCHMARK.md
fi

if [ "$which" = verify ] || [ "$which" = all ]; then
  cmake --build --preset release --target bench_verify
  build/release/bin/bench_verify --benchmark_repetitions=3 \
    --benchmark_out=build/release/bench_verify.json --benchmark_out_format=json "$@"
  scripts/verify_report.py build/release/bench_verify.json --page BENCHMARK.md
fi

if [ "$which" = viewer ] || [ "$which" = all ]; then
  cmake --build --preset release --target bench_viewer
  build/release/bin/bench_viewer --benchmark_repetitions=3 \
    --benchmark_out=build/release/bench_viewer.json --benchmark_out_format=json "$@"
  scripts/viewer_report.py build/release/bench_viewer.json --page BENCHMARK.md
fi
