#!/bin/bash
# Runs the quickstart with the archive of `./mien tarball` in a root of any distribution, and compares with what this
# machine made of it.
#
#   tests/fresh/tarball.sh ARCHIVE ROOT [out/quickstart]
#
# ROOT is a folder with a system, for example of debootstrap. Needs root's rights and zstd. Exits with 0 if videos,
# sheets and clips have the same bytes as in the given study (out/quickstart).
set -euo pipefail
[ $# -ge 2 ] || { sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2; exit 2; }
archive=$1 root=$2 made=${3:-out/quickstart}
name=$(basename "$archive" .tar.zst)
mkdir -p "$root/opt"
rm -rf "$root/opt/$name" "$root/root/tried"
tar --zstd -xf "$archive" -C "$root/opt"
began=$SECONDS
unshare --mount --propagation private --pid --fork bash -c '
  root=$1 name=$2
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/bin:/bin sh -euc \
    "cd /root; /opt/$name/bin/mien run quickstart --out tried; /opt/$name/bin/mien verify tried/quickstart"' _ "$root" "$name"
echo "tarball.sh: took $((SECONDS - began)) s"
for part in videos sheets clips; do diff -r "$made/$part" "$root/root/tried/quickstart/$part"; done
echo "tarball.sh: the same bytes as in $made"
