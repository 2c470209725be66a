#!/usr/bin/env bash
# Installs what is needed and builds programs into build/devel/lib/poinsot.
#
# Usage: scripts/build.sh [TARGET ...]
#   TARGET  a program, such as simulate; default: all programs and the panel, without tests and benchmarks
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
  -*) bad_use "build.sh: expected names of programs, got the option '$1'" ;;
esac

"$root/scripts/setup.sh"
say "building"
build_package "${@:-programs}"
