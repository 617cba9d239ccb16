#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/test.sh [PRESET]
#   Installs what is missing (Debian 12, as root or with sudo), builds everything and runs
#   all tests. PRESET: release (default), asan or tsan. With POINTMILL_WERROR=ON in the
#   environment, warnings are errors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:-release}

scripts/dependencies.sh build test
options=(-DPOINTMILL_BUILD_TESTS=ON)
if [ "${POINTMILL_WERROR-}" ]; then
  options+=("-DPOINTMILL_WERROR=$POINTMILL_WERROR")
fi
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel 2 --output-on-failure --no-tests=error
