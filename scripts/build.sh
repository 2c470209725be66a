#!/usr/bin/env bash
# Builds programs into build/devel/lib/poinsot, with what they need installed.
#
# Usage: scripts/build.sh [TARGET ...]
#   TARGET  a program, such as simulate; default: all programs and the panel, without tests and benchmarks
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
  -*) bad_use "build.sh: unknown option '$1'; expected names of programs" ;;
esac

"$root/scripts/setup.sh"
say "building"
build_package "${@:-programs}"
