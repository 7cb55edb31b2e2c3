#!/bin/sh
# Parameters that vary over the membrane, in whole runs.
. "$(dirname "$0")/common.sh"

Y_C=membrane.damage.parameters.Y_C

# runs FOLDER OPTIONS...: the quick case, coarser
runs() {
  folder=$1
  shift
  "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o "$folder" --set capsule.mesh.subdivisions=1 \
    --set output.snapshot_every=0.2 "$@" || fail "$folder"
}

# A field of equal values is a number, to the last bit, and keeps all symmetries.
yes 2.0 | head -n 80 >equal.txt
runs number --set time.end=1.4
runs equal --set "$Y_C={file: $PWD/equal.txt}" --set time.end=1.4
same number/history.csv equal/history.csv "a field of equal values"
grep -q 'symmetries of mesh and flow' equal/summary.json && fail "a field of equal values breaks symmetries"

# Scatter: the same numbers for the same seed, from the resolved scene, and after a kill; others for another seed.
scatter() { echo "$Y_C={weibull: {mean: 2.0, modulus: 4}, seed: $1, correlation: 0.3}"; }
runs scatter --set "$(scatter 7)" --set time.end=1.4
grep -q '3 of 4 symmetries of mesh and flow: the values of Y_C of law marigo' scatter/summary.json ||
  fail "the summary does not say that the symmetry is gone"
grep -q 'Y_C of law marigo varies from' scatter/log.txt || fail "the log does not tell the range of the field"
grep -q 'Name="damage_Y_C" AttributeType="Scalar" Center="Cell"' scatter/series.xdmf || fail "no cell data in the series"
"$capsella" run scatter/resolved.yaml --quiet -o again
same scatter/history.csv again/history.csv "the same seed gives other numbers"
runs other --set "$(scatter 8)" --set time.end=1.4
cmp -s scatter/history.csv other/history.csv && fail "another seed gives the same numbers"
runs resumed --set "$(scatter 7)" --set time.end=0.6
runs resumed --set "$(scatter 7)" --set time.end=1.4 --resume
same scatter/history.csv resumed/history.csv "history of a resumed run with scatter"

# A law that only looks on may have a strength that scatters, too; the resolved scene judges the same.
runs watched --set time.end=1.4 --set "observe.criteria=[{law: marigo, parameters: {Y_D: 0.2, ${Y_C##*.}: \
  {normal: {mean: 2.0, deviation: 0.3}, seed: 3}}}]"
grep -q '3 of 4 symmetries of mesh and flow: the values of Y_C' watched/summary.json || fail "criterion with scatter"
"$capsella" run watched/resolved.yaml --quiet -o watched-again
same watched/criteria.csv watched-again/criteria.csv "criterion with scatter from the resolved scene"

# The number of threads changes nothing.
runs one --set "$(scatter 7)" --set time.end=0.6 --threads 1
runs two --set "$(scatter 7)" --set time.end=0.6 --threads 2
same one/history.csv two/history.csv "histories of one and two threads with scatter"

# A weak spot ruptures where it is: at a point of an element (of size 0.28) whose centre lies in it.
runs spot --set "$Y_C={around: [0.6, 0.8, 0], radius: 0.3, inside: 0.1, outside: 20}" --set time.end=4 \
  --set capsule.mesh.subdivisions=2
[ "$(number spot/summary.json status)" = ruptured ] || fail "the weak spot does not rupture"
grep -A 1 '"rupture": {' spot/summary.json | sed -n 's/.*\[\(.*\)\].*/\1/p' | tr -d , >X
awk '{ exit !(($1 - 0.6)^2 + ($2 - 0.8)^2 + $3^2 < (0.3 + 0.2)^2) }' X || fail "rupture away from the weak spot: $(cat X)"

# A file that has changed since is not taken for the one of the resolved scene.
yes 1.0 | head -n 80 >equal.txt
code=0
"$capsella" run equal/resolved.yaml --quiet -o changed 2>message || code=$?
[ "$code" = 2 ] && grep -q 'expected the content with hash' message || fail "a changed file: $code $(cat message)"
