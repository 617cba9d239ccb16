#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/format.sh [--check]
#   Formats all sources with clang-format 14; with --check, changes nothing and fails where
#   one is not formatted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1-} in
  "") options=(-i) ;;
  --check) options=(--dry-run --Werror) ;;
  *) echo "usage: format.sh [--check]" >&2; exit 1 ;;
esac
scripts/dependencies.sh check
find apps bench examples modules test \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' \) \
  -print0 | sort -z | xargs -0 clang-format-14 --style=file "${options[@]}"
