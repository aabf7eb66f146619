#!/usr/bin/env bash
# told.sh SHARE PROGRAMS NAME...: what the built programs tell of themselves, for an installation
# whose data lie in SHARE. NAME coppice: pages of `man` for `coppice` and its verbs, and what bash
# completes; any other: the page of coppice-NAME, if that program is built.
set -euo pipefail
man=$1/man/man1 completions=$1/bash-completion/completions programs=$2
shift 2
here=$(mktemp -d)
trap 'rm -r "$here"' EXIT
version=$("$programs/coppice" --version)

# page NAME COMMAND...: the page of man that its --help makes.
page() {
  local name=$1
  shift
  printf '#!/bin/sh\nexec %s --help | sed "1s/usage:/Usage:/"\n' "$*" > "$here/$name"
  chmod +x "$here/$name"
  help2man --no-info --name "${summary:-$name}" --version-string "${version#coppice }" \
    --manual Coppice --source Coppice "$here/$name" | sed 's/^\.TH \(\S*\) "1" "[^"]*"/.TH \1 "1" ""/' |
    gzip -9n > "$man/$name.1.gz"
}

mkdir -p "$man"
for name; do
  if [ "$name" = coppice ]; then
    mkdir -p "$completions"
    "$programs/coppice" completion bash > "$completions/coppice"
    summary="behaviour trees for robots" page coppice "$programs/coppice"
    "$programs/coppice" --help | sed -n 's/^  \([a-z]*\)  *\(.*\)/\1 \2/p' |
      while read -r verb summary; do
        [ -e "$programs/coppice-$verb" ] || page "coppice-$verb" "$programs/coppice" "$verb"
      done
  elif [ -x "$programs/coppice-$name" ]; then
    summary=$("$programs/coppice" --help | sed -n "s/^  $name  *//p")
    page "coppice-$name" "$programs/coppice-$name"
  fi
done
