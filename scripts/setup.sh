#!/usr/bin/env bash
# Installs the missing Debian packages of the lists scripts/packages/NAME.txt.
#
# Usage: scripts/setup.sh [--NAME ...]
#   (always)      what the demo needs
#   --pictures    a virtual display, and tools to take pictures of it
#   --films       for scripts/film.sh
#   --plots       for scripts/plot.py
#   --tests       for scripts/test.sh
#   --tests_long  for scripts/test.sh --all
#   --benchmarks  for the benchmarks and the reference rows
#   --peers       the solvers with which scripts/benchmark.sh compares Poinsot
#   --docs        for scripts/docs.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

lists=("$root/scripts/packages/demo.txt")
for word in "$@"; do
  case "$word" in
    -h | --help) usage; exit 0 ;;
    --pictures | --films | --plots | --tests | --tests_long | --benchmarks | --peers | --docs)
      lists+=("$root/scripts/packages/${word#--}.txt") ;;
    *) bad_use "setup.sh: unknown option '$word'; see setup.sh --help" ;;
  esac
done

mapfile -t wanted < <(sed 's/#.*//' "${lists[@]}" | awk 'NF {print $1}' | sort -u)
mapfile -t missing < <(
  dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' "${wanted[@]}" 2> /dev/null | sed -n 's/^ii *//p' | sort -u |
    comm -23 <(printf '%s\n' "${wanted[@]}") -)
[ ${#missing[@]} -gt 0 ] || exit 0

say "installing ${#missing[@]} Debian packages"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || fail "setup.sh: expected root rights or sudo, to install ${missing[*]}"
  as_root=(sudo)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
# If this fails, the list of packages may be out of date: update it and try again.
install() { "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}" > "$log" 2>&1; }
if ! install; then
  "${as_root[@]}" apt-get update > "$log" 2>&1 || { tail -n 20 "$log" >&2; fail "setup.sh: apt-get update failed"; }
  install || { tail -n 20 "$log" >&2; fail "setup.sh: apt-get install failed"; }
fi
