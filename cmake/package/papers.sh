#!/usr/bin/env bash
# papers.sh SHARE PACKAGE MAINTAINER: what Debian wants to find of a package below SHARE/doc: its
# copyright, and its changes, which are those of CHANGELOG.md.
set -euo pipefail
doc=$1/doc/$2 package=$2 maintainer=$3
here=$(cd "$(dirname "$0")" && pwd)

# CHANGELOG.md in Debian's form: "## 0.1.0 (2026-11-25)", then items that begin with a dash.
changes() {
  local line version= date= item=
  while IFS= read -r line; do
    if [[ $line =~ ^##\ ([0-9.]+)\ \((.*)\)$ ]]; then
      [ -z "$version" ] || { end_item; finish "$date"; }
      version=${BASH_REMATCH[1]} date=${BASH_REMATCH[2]}
      printf '%s (%s) unstable; urgency=medium\n\n' "$package" "$version"
    elif [[ $line == '- '* ]]; then
      end_item
      item=${line#- }
    elif [[ $line == '  '* ]]; then
      item+=" ${line#  }"
    fi
  done < "$here/../../CHANGELOG.md"
  end_item
  finish "$date"
}
end_item() {
  [ -z "$item" ] || { fold -s -w 74 <<< "$item" | sed '1s/^/  * /; 1!s/^/    /; s/ *$//'; }
  item=
}
finish() { printf '\n -- %s  %s\n\n' "$maintainer" "$(LC_ALL=C date -u -R -d "$1")"; }

mkdir -p "$doc"
changes | gzip -9n > "$doc/changelog.gz"
cat > "$doc/copyright" << TEXT
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: coppice

Files: *
Copyright: 2026 The Coppice authors
License: Apache-2.0
 On Debian systems, the text of the Apache License 2.0 is in
 /usr/share/common-licenses/Apache-2.0.
TEXT
