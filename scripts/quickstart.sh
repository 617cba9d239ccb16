#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/quickstart.sh
#   From a fresh Debian 12, as root or with sudo, to a milled sample: installs what is
#   missing, builds the program and its viewer into build/release and mills
#   data/sample_scan.pcd into out/sample. Run again, it installs and builds only what has
#   changed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

scripts/dependencies.sh build
if [ ! -e build/release/build.ninja ]; then # later, the build looks after itself
  cmake --preset release -DPOINTMILL_BUILD_TESTS=OFF
fi
cmake --build --preset release --target pointmill pointmill_viewer_app

echo
exec build/release/bin/pointmill mill data/sample_scan.pcd -o "$root/out/sample"
