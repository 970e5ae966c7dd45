#!/usr/bin/env bash
# as_ordinary_user.sh PROGRAM: runs a test program of root's as nobody, from a copy that nobody can
# read. Where the tests are an ordinary user's already, PROGRAM has run as one: exit code 77.
set -eu
if [ "$(id -u)" != 0 ]; then
    echo "These tests are an ordinary user's already."
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$1" "$folder/program"
chmod 755 "$folder" "$folder/program"
cd "$folder"
HOME=/nonexistent TMPDIR=/tmp setpriv --reuid=nobody --regid=nogroup --clear-groups ./program
