#!/usr/bin/env bash
# Installs the Debian packages that are missing for what is asked for: those of scripts/packages/NAME.txt.
#
# Usage: scripts/setup.sh [--NAME ...]
#   (always)      what the demo needs
#   --pictures    a virtual display, and pictures of it
#   --films       scripts/film.sh
#   --tests       scripts/test.sh
#   --tests_long  scripts/test.sh --all
#   --benchmarks  the benchmarks and the reference rows
#   --peers       the solvers that scripts/benchmark.sh compares Poinsot with
#   --docs        scripts/docs.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

lists=("$root/scripts/packages/demo.txt")
for word in "$@"; do
  case "$word" in
    -h | --help) usage; exit 0 ;;
    --pictures | --films | --tests | --tests_long | --benchmarks | --peers | --docs)
      lists+=("$root/scripts/packages/${word#--}.txt") ;;
    *) bad_use "setup.sh: unknown word '$word'; see setup.sh --help" ;;
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
  command -v sudo > /dev/null || fail "setup.sh: root rights are needed to install: ${missing[*]}"
  as_root=(sudo)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
# The list of packages may be too old to fetch from: renew it only then.
install() { "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}" > "$log" 2>&1; }
if ! install; then
  "${as_root[@]}" apt-get update > "$log" 2>&1 || { tail -n 20 "$log" >&2; fail "setup.sh: apt-get update failed"; }
  install || { tail -n 20 "$log" >&2; fail "setup.sh: apt-get install failed"; }
fi
