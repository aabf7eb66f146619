#!/usr/bin/env bash
# clean_root.sh PACKAGES: as root. What lintian says of the packages in that folder (./dev package
# puts them into build/packages); then they are installed in a Debian 12 that knows nothing of
# Coppice, used there, and purged, after which nothing of them is left.
# Needs the package group `package`, and a mirror: that of this machine, or $MIRROR.
set -euo pipefail
packages=$(cd "$1" && pwd)
mirror=${MIRROR:-$(apt-cache policy | sed -n 's/^ *[0-9]* \(http[^ ]*\) bookworm\/main.*/\1/p' | head -1)}
root=$(mktemp -d)
trap 'umount "$root/proc" 2> /dev/null || true; rm -rf "$root"' EXIT

say() { echo "== $*"; }
inside() { chroot "$root" env PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
  LC_ALL=C http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "$@"; }

# expect TEXT COMMAND...: the command, inside, prints that.
expect() {
  local text=$1 printed
  shift
  printed=$(inside "$@" 2>&1) || { echo "$*: $printed"; exit 1; }
  [[ $printed == *"$text"* ]] || { echo "$*: no \"$text\" in: $printed"; exit 1; }
}

# `etc/shadow-` and its like are the copies that adduser leaves.
files() { (cd "$root" && find etc usr var/lib opt home srv -not -path 'var/lib/apt/*' \
  -not -path 'var/lib/dpkg/*' -not -path 'etc/*shadow-' -not -path 'etc/passwd-' \
  -not -path 'etc/group-' -not -path 'usr/share/doc' | sort); }

say "lintian"
lintian --allow-root --fail-on error "$packages"/*.deb

say "a clean Debian"
debootstrap --variant=minbase bookworm "$root" "$mirror" > /tmp/debootstrap.log ||
  { tail /tmp/debootstrap.log; exit 1; }
cp /etc/resolv.conf "$root/etc/" || true
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
mount -t proc proc "$root/proc"
inside apt-get update -q > /dev/null
# What the packages need comes first: it is not theirs, and may stay.
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages/"
needed=$(for deb in "$packages"/*.deb; do dpkg-deb -f "$deb" Depends; done | tr ',' '\n' |
  sed 's/|.*//; s/(.*)//; s/ //g' | grep -v coppice | sort -u)
inside apt-get install -q -y --no-install-recommends g++ make cmake $needed > /dev/null
files > "$root.before"

say "installed, and used"
inside sh -c 'apt-get install -q -y --no-install-recommends /packages/*.deb > /dev/null'
expect "coppice " coppice --version
cat > "$root/packages/tree.xml" << 'TREE'
<root BTCPP_format="4"><BehaviorTree ID="M"><Delay delay_msec="10"><AlwaysSuccess/></Delay></BehaviorTree></root>
TREE
expect SUCCESS coppice run /packages/tree.xml --quiet
if [ -x "$root/usr/bin/coppice-edit" ]; then
  inside coppice export /packages/tree.xml -o /packages/tree.svg
  [ -s "$root/packages/tree.svg" ]
fi
if [ -d "$root/usr/lib/python3/dist-packages/coppice" ]; then
  expect Status.SUCCESS python3 -B -c 'import coppice; print(coppice.load("/packages/tree.xml").run())'
fi
if [ -x "$root/usr/bin/coppice-robot" ]; then
  robot=/usr/share/coppice/robot
  expect "" coppice check --models $robot/trees/models.xml $robot/trees/monitor/monitor.xml
  inside id robot > /dev/null  # whom the unit runs as
  # The whole robot under its supervisor: it drives, and ends in order.
  expect "The demonstration went well" \
    coppice-demo --rounds 1 --stops 1 --no-editor --run /packages/run
fi
mkdir "$root/packages/robot"
cat > "$root/packages/robot/CMakeLists.txt" << 'CMAKE'
cmake_minimum_required(VERSION 3.16)
project(robot CXX)
find_package(coppice REQUIRED)
add_executable(robot robot.cc)
target_link_libraries(robot coppice::bt_core)
CMAKE
cat > "$root/packages/robot/robot.cc" << 'CODE'
#include <bt_core/engine/registry.h>
#include <iostream>
int main() { std::cout << coppice::Registry().entries().size() << " node types\n"; }
CODE
inside sh -c 'cd /packages/robot && cmake -B b > log && cmake --build b >> log' ||
  { cat "$root/packages/robot/log"; exit 1; }
expect "node types" /packages/robot/b/robot

say "purged"
if [ -x "$root/usr/bin/coppice-robot" ]; then  # as the unit does
  mkdir -p "$root/var/lib/coppice/institute" "$root/var/log/coppice"
fi
inside sh -c 'dpkg --purge $(dpkg-query -W -f "\${Package}\n" | grep "coppice") > /dev/null'
files > "$root.after"
diff "$root.before" "$root.after" || { echo "this is left, or gone"; exit 1; }
rm "$root.before" "$root.after"
say "nothing is left"
