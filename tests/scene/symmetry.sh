#!/bin/sh
# A run on one node of each orbit is the run on all of them: to round-off, or where the coarse rule sums inner
# stages, to the single precision of that.
. "$(dirname "$0")/common.sh"

# apart KEY BOUND: the summaries of both runs agree in a figure.
apart() {
  a=$(number used/summary.json "$1")
  b=$(number off/summary.json "$1")
  awk -v a="$a" -v b="$b" -v bound="$2" -v key="$1" 'BEGIN {
    d = a > b ? a - b : b - a
    printf "%s: %g, apart by %.1e\n", key, a, d
    exit !(a != 0 && d <= bound) }' || fail "$1 is $a with symmetry and $b without: more than $2 apart"
}

# compare BOUND_OF_D12 BOUND_OF_D_MAX SETS...
compare() {
  shape=$1
  damage=$2
  shift 2
  for symmetry in auto off; do
    folder=$([ $symmetry = auto ] && echo used || echo off)
    rm -rf "$folder"
    "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o "$folder" --set symmetry=$symmetry "$@"
  done
  grep -q 'images of the others under 4 symmetries' used/summary.json || fail "no symmetry was used"
  grep -q 'images of the others' off/summary.json && fail "symmetry was used where it is off"
  [ "$(number used/summary.json evaluations)" = "$(number off/summary.json evaluations)" ] ||
    fail "other steps or stages with symmetry than without"
  apart D12 "$shape"
  apart beta "$shape"
  apart d_max "$damage"
}

compare 1e-12 1e-12 --set fluid.coarse_stages=false
compare 3e-8 3e-7
compare 1e-12 1e-12 --set time.integrator=rk2 --set time.end=0.5 --set membrane.damage.parameters.Y_D=0.001
# The roots of the icosahedron, of four elements each, are no images of each other.
compare 1e-12 1e-12 --set capsule.mesh.subdivisions=0 --set fluid.coarse_stages=false --set time.end=0.5 \
  --set membrane.damage.parameters.Y_D=0.001

# A start that was shaken has no symmetry, and none is used.
"$capsella" run "$root/configs/shear_quick.yaml" --quiet -o shaken --set start.noise=1e-3 --set time.end=0.05 \
  --set capsule.mesh.subdivisions=1 --set output.report=false
if grep -q 'images of the others' shaken/summary.json; then fail "symmetry was used for a start that has none"; fi
