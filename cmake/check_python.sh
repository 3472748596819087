#!/usr/bin/env bash
# The tests of python/swarf.   usage: check_python.sh SOURCE_DIR
set -euo pipefail
cd "$1"
for python in python3 /usr/bin/python3; do # Debian's packages are seen by Debian's Python only
  if "$python" -c 'import h5py, matplotlib, pytest, scipy, tomli_w' 2>/dev/null; then
    exec "$python" -m pytest -q -p no:cacheprovider python/tests
  fi
done
echo "no Python with h5py, matplotlib, pytest, scipy and tomli_w: scripts/test installs them"
exit 77
