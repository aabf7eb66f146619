#!/usr/bin/env bash
# Writes the table of docs/faults.md from the report of the fault tests (build/tests/system/faults.tsv); of each fault
# the newest line counts.
set -euo pipefail
cd "$(dirname "$0")/../.."
report=${1:-build/tests/system/faults.tsv}
table=$(awk -F'\t' '
  { gsub(/\/[^ ]*\/tests\/system\//, "", $3) }
  !($1 in line) { order[++count] = $1 }
  { line[$1] = "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " | " $6 " | " $7 " | " $8 " |" }
  END {
    print "| fault | injected | seen by | detected after | at most | recovery | person asked | nominal after |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= count; ++i) print line[order[i]]
  }' "$report")
awk -v table="$table" '
  /<!-- table -->/ { print; print table; skip = 1 }
  /<!-- end of table -->/ { skip = 0 }
  !skip || /<!-- end/ { if (!/<!-- table -->/) print }' docs/faults.md > docs/faults.md.new
mv docs/faults.md.new docs/faults.md
