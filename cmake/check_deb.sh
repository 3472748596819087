#!/usr/bin/env bash
# Makes the Debian package, looks at what it says of itself, and runs the program from the unpacked tree.
# usage: check_deb.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
command -v dpkg-deb >/dev/null || { echo "skipped: no dpkg-deb"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
rm -f "$2"/swarf_*.deb
cmake --build "$2" --target deb
packages=("$2"/swarf_*.deb)
dpkg-deb -I "${packages[0]}"
depends=$(dpkg-deb -f "${packages[0]}" Depends)
for package in ${depends//,/}; do # each is one that this Debian has
  dpkg-query -W "$package" >/dev/null
done
dpkg-deb -x "${packages[0]}" "$folder"

program=("$folder/usr/bin/swarf")
if [ -e "$folder/usr/lib/swarf/loader" ]; then # its own runtime, which is not installed: start it by hand
  readelf -l "${program[0]}" | grep -q '/usr/lib/swarf/loader'
  program=("$folder/usr/lib/swarf/loader" --library-path "$folder/usr/lib/swarf" "${program[@]}")
  [ -z "$("${program[0]}" --list "${program[@]:1}" | grep -E 'not found|kokkos' | grep -v "$folder")" ]
  export GOMP_SPINCOUNT=1000 # or the program would start its loader again, without itself
fi
"${program[@]}" --version
cd "$folder"
"${program[@]}" check usr/share/swarf/inputs/micro_milling_quick.toml
"${program[@]}" run "$1/examples/embed/method.toml" --no-pictures
[ -s results/method/history.csv ]
