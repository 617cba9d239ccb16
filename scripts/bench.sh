#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/bench.sh [OPTION...]
#   Builds and runs the benchmarks, prints their table, and puts it into BENCHMARK.md with
#   the plot doc/images/bench.svg. OPTIONs go to bench_drop: --points=1e5,1e6,1e7,1e8 takes
#   other numbers of points (the last needs 5 GiB), the rest is Google Benchmark's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/dependencies.sh build bench
# The tests need more packages; where they are off, they stay off.
options=(-DPOINTMILL_BUILD_BENCH=ON)
[ -e build/release/build.ninja ] || options+=(-DPOINTMILL_BUILD_TESTS=OFF)
cmake --preset release "${options[@]}"
cmake --build --preset release --target bench_drop
build/release/bin/bench_drop --benchmark_repetitions=3 \
  --benchmark_out=build/release/bench.json --benchmark_out_format=json "$@"
scripts/bench_report.py build/release/bench.json --page BENCHMARK.md \
  --plot doc/images/bench.svg
