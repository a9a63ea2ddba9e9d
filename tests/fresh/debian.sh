#!/bin/bash
# Does what README's first commands say on a fresh Debian machine, and installs the package on a second one.
#
#   tests/fresh/debian.sh bookworm|trixie [FOLDER]
#
# A fresh machine is a root of Debian's smallest kind (debootstrap, minbase) with git and ca-certificates. The
# first one gets a clone of this repository's HEAD and nothing else, and there `./mien run
# manifests/quickstart.yaml`, `./mien test` and `./mien package` are run; the second one gets the package, and
# there `mien run quickstart`. FOLDER (a new temporary one unless it is given, removed at the end) holds the
# roots, 5 GB each. Needs root's rights, debootstrap, and a network that reaches Debian's mirrors and npm's
# registry. MIEN_DEBIAN_MIRROR names another mirror. Certificates that this machine adds to Debian's
# (/usr/local/share/ca-certificates) are added in the roots too, and MIEN_DATA is taken along, so that the
# tests of real motions run. Exits with 0 when all of it worked.
set -euo pipefail

release=${1:-}
case $release in
  bookworm | trixie) ;;
  *)
    sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
mirror=${MIEN_DEBIAN_MIRROR:-http://deb.debian.org/debian}
project=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
data=${MIEN_DATA:-$project/../shared/data}
[ "$(id -u)" -eq 0 ] || { echo "debian.sh: making a root needs root's rights" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "debian.sh: install debootstrap" >&2; exit 1; }

if [ -n "${2:-}" ]; then
  mkdir -p "$2"
  folder=$(CDPATH='' cd -- "$2" && pwd)
else
  folder=$(mktemp -d "${TMPDIR:-/var/tmp}/mien-fresh-XXXXXX")
  trap 'rm -rf --one-file-system "$folder"' EXIT
fi

say() { printf '%s debian.sh: %s\n' "$(date +%H:%M:%S)" "$*"; }

make_root() {
  [ ! -e "$1" ] || { echo "debian.sh: $1 is there already; name a folder without it" >&2; exit 1; }
  debootstrap --variant=minbase --include=git,ca-certificates "$release" "$1" "$mirror" >"$1.debootstrap.log" 2>&1 ||
    { tail -n 5 "$1.debootstrap.log" >&2; exit 1; }
  cp --dereference /etc/resolv.conf "$1/etc/resolv.conf"
  printf '127.0.0.1 localhost\n127.0.1.1 %s\n' "$(uname -n)" >"$1/etc/hosts"  # Debian's installer writes it
  if ls /usr/local/share/ca-certificates/*.crt >/dev/null 2>&1; then
    cp /usr/local/share/ca-certificates/*.crt "$1/usr/local/share/ca-certificates/"
    chroot "$1" update-ca-certificates >/dev/null 2>&1
    # npm and Node.js have certificates of their own unless they are told.
    mkdir -p "$1/usr/etc" "$1/etc"
    echo 'cafile=/etc/ssl/certs/ca-certificates.crt' | tee "$1/etc/npmrc" >"$1/usr/etc/npmrc"
  fi
}

# Runs a command in a root, in mount and process namespaces that end with it: nothing stays mounted, nothing runs on.
in_root() {
  unshare --mount --propagation private --pid --fork bash -c '
    root=$1 data=$2 command=$3
    mount --rbind "$root" "$root"  # a mount point is its /, as on a machine: tests mount disks of their own
    mount -t proc proc "$root/proc"
    mount --rbind /sys "$root/sys"  # Slurm reads there what processors there are
    mount --rbind /dev "$root/dev"
    mount -t tmpfs tmpfs "$root/dev/shm"
    given=
    if [ -d "$data" ]; then
      mkdir -p "$root/mnt/data"
      mount --bind -o ro "$data" "$root/mnt/data"
      given=MIEN_DATA=/mnt/data
    fi
    exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt $given bash -euc "$command"' \
    in_root "$1" "$data" "$2" </dev/null
}

timed() {
  local began=$SECONDS
  say "$1"
  in_root "$2" "$3" || { say "FAILED: $1"; exit 1; }
  say "took $(((SECONDS - began) / 60)) min $(((SECONDS - began) % 60)) s: $1"
}

build=$folder/$release-build
use=$folder/$release-use
say "a fresh $release"
make_root "$build"
git clone -q --no-hardlinks "file://$project" "$build/root/mien"
say "commit $(git -C "$build/root/mien" log -1 --format='%h %s')"
timed './mien run manifests/quickstart.yaml' "$build" 'cd /root/mien && ./mien run manifests/quickstart.yaml && test -s out/quickstart/report.html'
timed './mien test' "$build" 'cd /root/mien && ./mien test'
timed './mien package' "$build" 'cd /root/mien && ./mien package'

say "another fresh $release, for the package"
make_root "$use"
cp "$build"/root/mien/build/release/package/*.deb "$use/root/"
timed 'apt install ./mien_*.deb; mien run quickstart' "$use" \
  'cd /root && apt-get update -q >/dev/null && DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends ./mien_*.deb >/dev/null &&
   mien version && mien run quickstart && test -s out/quickstart/report.html'
say "$release: all of it worked"
