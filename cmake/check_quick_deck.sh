#!/usr/bin/env bash
# Runs a deck in an empty folder and looks for everything that a run promises.   usage: check_quick_deck.sh SWARF DECK
set -euo pipefail
name=$(basename "$2" .toml)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

"$1" run "$2"

fail() { echo "FAILED: $*"; find . -type f; exit 1; }
cd "results/$name"
for file in history.csv results.h5 summary.json; do
  [ -s "$file" ] || fail "no $file"
done
[ "$(wc -l <history.csv)" -gt 20 ] || fail "history.csv has too few samples"
! grep -qiE '(^|,)[-+]?(nan|inf)' history.csv || fail "history.csv holds a non-finite number"
for kind in pvd vtu png toml; do
  [ -n "$(find . -name "*.$kind" -size +0 -print -quit)" ] || fail "no .$kind file"
done
for frame in $(grep -oE 'file="[^"]+"' -- *.pvd | cut -d '"' -f 2); do
  [ -s "$frame" ] || fail "the .pvd names $frame, which is not there"
done
[ -z "$(find . -name '*.png' -size -4)" ] || fail "a picture is nearly empty"
echo "all results are there"
