#!/bin/sh
# docs/python.md, followed to the letter: its lines read a run with numpy and h5py, and draw it with matplotlib.
. "$(dirname "$0")/common.sh"

mkdir bin
for python in python3 /usr/bin/python3; do
  path=$(command -v $python) && "$path" -c 'import numpy, h5py, matplotlib' 2>/dev/null && ln -sf "$path" bin/python3 && break
done
[ -e bin/python3 ] || { echo "skipped: no python3 with numpy, h5py and matplotlib" && exit 77; }

follow docs/python.md 30 1 "$PWD/bin"
summary=empty/results/small/summary.json
grep -qx "D12 = $(printf %.3f "$(number $summary D12)") at t = 3" output || fail "D12 is not that of the summary: $(cat output)"
grep -q "^$(number $summary nodes) nodes, $(number $summary elements) elements" output || fail "the grid is not that of the summary"
awk '/^damage/ { found = 1; y = $6 + 0; if (y < 0) y = -y; exit !($2 > 0.1 && y > 1) } END { exit !found }' output ||
  fail "the largest damage is not on the vorticity axis: $(cat output)"
[ "$(head -c 4 empty/curves.png | tail -c 3)" = PNG ] || fail "no picture"
