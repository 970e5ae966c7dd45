#!/usr/bin/env bash
# ./run and ./test of a fresh clone in a bare Debian 12: shows that packages.txt names everything that is needed.
#   packaging/bare-debian.sh FOLDER        as root, with the package debootstrap; the system is made in FOLDER and stays there
set -eu
[ $# = 1 ] || { sed -n '2,3s/^# *//p' "$0"; exit 2; }
source=$(cd "$(dirname "$0")/.." && pwd)
root=$1
mirror=http://deb.debian.org/debian
[ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase bookworm "$root" $mirror

for folder in proc sys dev dev/pts dev/shm; do
    mountpoint -q "$root/$folder" || mount --bind "/$folder" "$root/$folder"
done
trap 'for folder in dev/shm dev/pts dev sys proc; do umount "$root/$folder"; done' EXIT
cp /etc/resolv.conf "$root/etc/"
rm -rf "$root/root/ensemble"
git clone -q "$source" "$root/root/ensemble"

# Nothing of this system but the folder: no variables, no cache of compiled files, no display, no input.
inside() { env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin CCACHE_DISABLE=1 chroot "$root" bash -c "cd /root/ensemble && $1" </dev/null; }
inside './run && ls -l memo.pdf'
inside './test'
