#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing: all, or with the argument `run` those that build and
# run the programs; with `peers` those of peers.txt instead. Asks for root only when one is missing.
set -eu
cd "$(dirname "$0")"
missing=()
drop= list=packages.txt
[ "${1:-}" != run ] || drop=d
[ "${1:-}" != peers ] || list=peers.txt
for package in $(sed "/^# To test\$/,\$ { $drop }; s/#.*//" $list); do
    status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0
echo "Installing: ${missing[*]}"
if [ "$(id -u)" = 0 ]; then
    as_root() { "$@"; }
elif command -v sudo >/dev/null; then
    as_root() { sudo "$@"; }
else
    echo "Only root can, and there is no sudo. As root: apt-get install ${missing[*]}" >&2
    exit 1
fi
# A list that cannot be renewed, of this or of another source of packages, need not keep one from installing.
as_root apt-get update -qq || echo "The lists of packages could not all be renewed." >&2
as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
