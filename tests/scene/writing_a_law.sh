#!/bin/sh
# docs/writing-a-law.md, followed to the letter: its law is written, checked, drawn, and ruptures a capsule.
. "$(dirname "$0")/common.sh"

command -v c++ >/dev/null 2>&1 || { echo "skipped: the page needs a C++ compiler" && exit 77; }
follow docs/writing-a-law.md 80 8
grep -q '</svg>' empty/soft.svg || fail "no chart of the law"
for picture in tear soft; do
  grep -q '</svg>' "empty/results/$picture/capsule.svg" || fail "no picture of $picture"
  [ "$(number "empty/results/$picture/summary.json" status)" = ruptured ] || fail "no rupture of $picture"
done
