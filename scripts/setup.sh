#!/usr/bin/env bash
# Installs the Debian packages that Poinsot needs and that are missing.  Usage: scripts/setup.sh [--peers]
#   --peers   also the solvers that scripts/benchmark.sh compares it with
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

lists=("$root/scripts/packages.txt")
case "${1:-}" in
  '') ;;
  --peers) lists+=("$root/scripts/packages_peers.txt") ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "setup.sh: unknown word '$1'; it takes --peers or none" ;;
esac

missing=()
while read -r package; do
  dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2> /dev/null | grep -q '^ii' || missing+=("$package")
done < <(sed 's/#.*//' "${lists[@]}" | awk 'NF {print $1}')
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
