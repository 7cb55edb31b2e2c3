#!/bin/sh
# The number of threads changes nothing but the time it takes.
. "$(dirname "$0")/common.sh"

for threads in 1 2; do
  "$capsella" run "$root/configs/shear_quick.yaml" --quiet --threads $threads --set time.end=0.4 -o "threads$threads"
done
same threads1/history.csv threads2/history.csv "histories of one and two threads"
