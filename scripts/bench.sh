#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/bench.sh [OPTION...]
#   Builds and runs the benchmarks; OPTIONs go to Google Benchmark.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/dependencies.sh build bench
# The tests need more packages; where they are off, they stay off.
options=(-DPOINTMILL_BUILD_BENCH=ON)
[ -e build/release/build.ninja ] || options+=(-DPOINTMILL_BUILD_TESTS=OFF)
cmake --preset release "${options[@]}"
cmake --build --preset release --target bench_drop
exec build/release/bin/bench_drop "$@"
