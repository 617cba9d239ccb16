#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/pictures.sh
#   Mills the sample, and makes the documents' pictures and README.md's figures from it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/quickstart.sh
mkdir -p doc/images
cp out/sample/preview.png doc/images/sample.png
cp out/sample/occupancy_2.png doc/images/occupancy.png
build/release/bin/pointmill_viewer out/sample --at 58% --size 1600x900 \
  --screenshot doc/images/viewer.png

# A program with the wrong tool, and why it is refused.
sed 's/^T3 M6$/T1 M6/; s/^G43 H3$/G43 H1/' out/sample/program.ngc >out/sample/wrong_tool.ngc
status=0
build/release/bin/pointmill check out/sample/wrong_tool.ngc --dir out/sample --quiet \
  --picture doc/images/refused.png || status=$?
[ $status = 3 ]

# Without the seconds that it took, the last column: they differ from run to run.
figures=$(build/release/bin/pointmill mill data/sample_scan.pcd -o out/sample |
          sed -E '/^operation/,/^verified/ { /^verified/! s/ +[^ ]+$// }')
{
  sed '/^<!-- sample:/q' README.md
  echo '```'
  echo "$figures"
  echo '```'
  sed -n '/^<!-- \/sample/,$p' README.md
} >README.md.new
cat README.md.new >README.md
rm README.md.new
