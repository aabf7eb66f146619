#!/usr/bin/env bash
# header_weight_test.sh COMPILER SOURCE_FOLDER: who includes the engine pays, in preprocessed
# lines, at most 1.5 times what the standard headers in it cost alone; nothing else is in it.
set -euo pipefail
compiler=$1
cd "$2"

face='#include "bt_core/engine/executor.h"
#include "bt_core/engine/registry.h"'
compile() { "$compiler" -std=c++17 -I. -x c++ "$@" -; }

headers=$(compile -MM <<< "$face" | tr -s ' \\' '\n' | grep '^bt_core/')
standard=$(grep -h '^#include <' $headers | sort -u)
if grep -E '<(iostream|sstream|fstream|regex|filesystem|thread|future|.*\..*)>' <<< "$standard"; then
  echo "too heavy for the engine's face"
  exit 1
fi
whole=$(compile -E <<< "$face" | wc -l)
alone=$(compile -E <<< "$standard" | wc -l)
echo "$whole lines with $(wc -w <<< "$headers") headers of the engine, $alone of the standard library alone"
[ "$alone" -gt 1000 ]
[ $((whole * 2)) -le $((alone * 3)) ]
