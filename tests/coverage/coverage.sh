#!/bin/sh
# What the tests reached, from the counts of a build with gcov:  coverage.sh BUILD SOURCE
# Prints line coverage of core/ by room and the messages that no test has produced; writes BUILD/coverage/lines (by
# file) and BUILD/coverage/unreached (every line that did not run).  Fails below 90 % of lines, and for a message that no
# test has produced and that messages.txt does not give a reason for.
set -eu
build=$1 source=$2
here=$(cd "$(dirname "$0")" && pwd)
out=$build/coverage
rm -rf "$out"
mkdir -p "$out"
find "$build/core" -name '*.gcno' >"$out/objects"
# shellcheck disable=SC2046
gcov --stdout --branch-probabilities $(sed 's/gcno$/gcda/' "$out/objects") 2>"$out/gcov.log" |
  awk -v source="$source/" -v out="$out" -v reasons="$here/messages.txt" -f "$here/coverage.awk"
