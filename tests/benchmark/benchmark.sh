#!/bin/sh
# Measures this machine and writes docs/benchmarks.md with its pictures:  benchmark.sh CAPSELLA FOLDER
# A quarter of an hour, so a target of its own.  What must not get worse unseen, counts and errors without seconds, is
# asserted by unit.benchmark.
set -eu
capsella=$1 folder=$2
"$capsella" bench --full -o "$folder"
for part in "Run time against error" "What .accuracy. gives" "Single figures" "Against the paper" \
  "Cost of one velocity evaluation" "Growth of the cost" "Cost of a law" "Error of the single layer" "All points"; do
  grep -q "^## $part" "$folder/benchmarks.md" || {
    echo "benchmarks.md has no section '$part'" >&2
    exit 1
  }
done
