#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the PointMill authors
#
# scripts/dependencies.sh SET...
#   Installs the Debian 12 packages of these sets that are missing; does nothing, and needs
#   neither network nor rights, where none is. Sets: build test check tidy bench.
# scripts/dependencies.sh --list SET...
#   Prints the packages of these sets.
set -euo pipefail

# The one place that names the packages.
packages_of() {
  case $1 in
    build) echo g++ cmake ninja-build ccache libpcl-dev libcli11-dev nlohmann-json3-dev \
                libyaml-cpp-dev libjs-three libegl-dev libegl1 libx11-dev libgl1-mesa-dri ;;
    # LinuxCNC's interpreter reads programs, Chromium shows pages, xdotool uses the viewer.
    test)  echo libgtest-dev linuxcnc-uspace xvfb xdotool chromium ;;
    check) echo clang-format-14 ;;
    tidy)  echo clang clang-tidy ;;
    bench) echo libbenchmark-dev python3-minimal ;;
    *) echo "dependencies.sh: no set $1 (build, test, check, tidy, bench)" >&2; return 1 ;;
  esac
}

list_only=
if [ "${1-}" = --list ]; then
  list_only=yes
  shift
fi
packages=()
for set in "$@"; do
  names=$(packages_of "$set")
  read -ra more <<<"$names"
  packages+=("${more[@]}")
done
if [ ${#packages[@]} = 0 ]; then
  echo "usage: dependencies.sh [--list] build|test|check|tidy|bench ..." >&2
  exit 1
fi
if [ "$list_only" ]; then
  printf '%s\n' "${packages[@]}"
  exit
fi

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "No apt here. These Debian packages, or what they hold, must be installed:" \
       "${packages[*]}" >&2
  exit
fi
missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" != 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages. As root: apt-get install --no-install-recommends" \
         "${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
# A source that does not answer matters only if a package is not found then.
"${as_root[@]}" apt-get update -qq </dev/null || true
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 \
  "${missing[@]}" </dev/null
