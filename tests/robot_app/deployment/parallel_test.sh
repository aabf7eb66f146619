#!/usr/bin/env bash
# parallel_test.sh DEPLOYMENT: GNU parallel spreads seeds over processes that share a folder, as
# docs/deployment.md shows it; each seed is what one process makes of it, and the report joins all.
set -euo pipefail
deployment=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

parallel --will-cite -j 4 "$deployment" run --days 1 --seeds {} --out "$folder/spread" \
  ::: 1 2 3 4 > "$folder/log" 2>&1
"$deployment" run --days 1 --seeds 1-4 --out "$folder/one" >> "$folder/log" 2>&1
for seed in 1 2 3 4; do
  for kind in spread one; do
    sed -E 's/"cpu_seconds":[^,}]*//' "$folder/$kind/ours/seed-000$seed.json" > "$folder/$kind.json"
  done
  cmp "$folder/spread.json" "$folder/one.json"
done
"$deployment" report "$folder/spread" >> "$folder/log" 2>&1
grep -q "ours (4)" "$folder/spread/report.md" || { cat "$folder/log"; exit 1; }
echo "four seeds of four processes"
