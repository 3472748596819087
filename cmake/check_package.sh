#!/usr/bin/env bash
# Installs a build into an empty prefix, and builds and runs examples/embed against it.
# usage: check_package.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$2" --prefix "$folder/prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }
"$folder"/prefix/bin/swarf --version
cp -r "$1/examples/embed" "$folder/embed" # so that nothing of the sources beside it is found
cmake -G Ninja -S "$folder/embed" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/prefix" >"$folder/log" 2>&1 ||
  { cat "$folder/log"; exit 1; }
cmake --build "$folder/build" --parallel 2
"$folder/build/struck_bar" "$folder/embed/method.toml"
