#!/usr/bin/env bash
# Builds the kernels and their unit tests as a preset says, in a build of their own, and runs them.
# usage: check_kernels.sh PRESET SOURCE_DIR BUILD_DIR
set -euo pipefail
cd "$2"
cmake --preset "$1" -B "$3" -DSWARF_UNITY_KERNELS=ON -DSWARF_PICTURES=OFF >"$3.log" || { cat "$3.log"; exit 1; }
cmake --build "$3" --target test_kernels --parallel 2
export OMP_WAIT_POLICY=passive GTEST_TOTAL_SHARDS=2
status=0 first=0
GTEST_SHARD_INDEX=1 "$3/tests/test_kernels" --gtest_brief=1 >"$3.other" 2>&1 &
GTEST_SHARD_INDEX=0 "$3/tests/test_kernels" --gtest_brief=1 || first=$?
wait $! || status=$?
cat "$3.other"
exit $((first | status))
