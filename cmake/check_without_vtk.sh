#!/usr/bin/env bash
# A swarf without VTK computes, and says what it cannot do and what to do about it.
# usage: check_without_vtk.sh SWARF_WITHOUT_VTK DECK
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$1" run "$2" --output out 2>errors
grep -q 'no frames for ParaView' errors
grep -q 'no pictures:.*SWARF_PICTURES=ON' errors
[ -s out/history.csv ] && [ -s out/results.h5 ] && [ ! -e out/frames.pvd ]
for command in plot render; do
  ! "$1" "$command" out 2>errors || { echo "$command does not fail"; exit 1; }
  grep 'SWARF_PICTURES=ON' errors
done
