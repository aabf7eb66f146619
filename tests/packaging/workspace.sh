#!/usr/bin/env bash
# workspace.sh: Coppice and two packages that use it in one catkin workspace, built by catkin_make
# (Debian's package catkin), then run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
workspace=$(mktemp -d)
trap 'rm -rf "$workspace"' EXIT
mkdir "$workspace/src"
ln -s "$here/../.." "$workspace/src/coppice"
ln -s "$here"/workspace/* "$workspace/src/"
catkin_make -C "$workspace" -DPYTHON_EXECUTABLE=/usr/bin/python3 > "$workspace/log" 2>&1 ||
  { tail -30 "$workspace/log"; exit 1; }
said=$("$(find "$workspace" -type f -name patrol_robot -perm -u+x)" "$workspace/src/patrol_robot/trees/patrol.xml")
[ "$said" = $'all is well\nall is well' ] || { echo "it said: $said"; exit 1; }
echo "the workspace is built, and its robot runs"
