#!/usr/bin/env bash
# Builds and runs the unit tests as preset dev says.   usage: check_sanitizers.sh SOURCE_DIR BUILD_DIR [LAUNCHER]
set -euo pipefail
cd "$1"
cmake --preset dev -B "$2" ${3:+-DCMAKE_CXX_COMPILER_LAUNCHER="$3"} >"$2.log" || { cat "$2.log"; exit 1; }
cmake --build "$2" --target test_kernels
ctest --test-dir "$2" -L unit --output-on-failure -j 2
