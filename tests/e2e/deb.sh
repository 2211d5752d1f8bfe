#!/usr/bin/env bash
# Builds the Debian package, installs it on a bare Debian 12 (debootstrap, in a mount namespace) and runs a case there.
# By hand, as root; downloads that system and what the package depends on.   usage: deb.sh SOURCE [BARE]
#   BARE  a folder with such a system already, left as it is
set -euo pipefail
source=$(cd "$1" && pwd) bare=${2:-}
if [ "${SCREE_DEB_INSIDE:-}" != 1 ]; then SCREE_DEB_INSIDE=1 exec unshare -m --propagation private "$0" "$@"; fi
cd "$source"
cmake --preset package >/dev/null
cmake --build --preset package --parallel "$(nproc)"
(cd build/package && cpack -G DEB)
root=$(mktemp -d)
trap 'umount -l "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
if [ -n "$bare" ]; then cp -a "$bare/." "$root"; else debootstrap --variant=minbase bookworm "$root" >/dev/null; fi
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mkdir -p "$root/proc"
mount --bind /proc "$root/proc"
cp build/package/scree_*.deb "$root/root/"
inside() { chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get update -qq
inside sh -c 'apt-get install -y --no-install-recommends /root/scree_*.deb' >"$root/apt.log" 2>&1 || { tail -20 "$root/apt.log"; exit 1; }
inside scree --version
inside scree cases list
inside scree run /usr/share/scree/cases/incline/case.toml --out /root/run
inside test -s /root/run/run.vtkhdf
inside sh -c 'apt-get install -y --no-install-recommends make $(dpkg-query -f "\${Suggests}" -W scree | tr -d ,)' >"$root/apt.log" 2>&1 ||
  { tail -20 "$root/apt.log"; exit 1; }
inside sh -c 'cp -r /usr/share/doc/scree/examples/embed /root && cd /root/embed && cmake -B build >/dev/null && cmake --build build && build/slide && build/own_law'
