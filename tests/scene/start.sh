#!/bin/sh
# Flows that change in time, and capsules that do not start as the sphere at rest.
. "$(dirname "$0")/common.sh"

# run FOLDER SETS...: an elastic capsule of 80 elements
run() {
  folder=$1
  shift
  "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o "$folder" --set membrane.damage= \
    --set capsule.mesh.subdivisions=1 --set time.end=6 --set output.report=false "$@"
}

# near FOLDER KEY VALUE BOUND
near() {
  x=$(number "$1/summary.json" "$2")
  awk -v x="$x" -v y="$3" -v bound="$4" 'BEGIN { d = x > y ? x - y : y - x; exit !(x != "" && d <= bound) }' ||
    fail "$1: $2 is $x, not $3 to $4"
}

# Without flow any capsule becomes a sphere of its own volume: (4/3 0.9 1)^(1/3) = 1.2^(1/3).  Its diameter is that of
# the inertia of a polyhedron of 80 elements.
run relaxed --set flow.strength='[[0, 0]]' --set 'start.axes=[1.3333333333333333, 0.9, 1]' --set time.end=20
for axis in L1 L2 L3; do near relaxed $axis 2.1253 2e-3; done
near relaxed volume_error 0 1e-12

# A flow that is switched off lets the capsule come back; one that oscillates fast leaves it where it is, to the shear
# that a quarter of a period brings.
run switched --set 'flow.strength=[[0, 1], [1, 1], [1.01, 0]]' --set time.end=20
near switched D12 0 1e-3
run oscillating --set flow.period=0.5
near oscillating D12 0 0.05

run plain
# Steps end where the strength has a corner.
grep -q '^1,' switched/history.csv || fail "no row at t = 1"

# Noise and an irregular mesh are the same for the same seed, and leave no symmetry to use.
run noise --set start.noise=1e-3
run again --set start.noise=1e-3
run other --set start.noise=1e-3 --set start.seed=2
run jitter --set capsule.mesh.jitter=0.2
same noise/history.csv again/history.csv "the same noise"
cmp -s noise/history.csv other/history.csv && fail "another seed gives the same noise"
grep -q 'images of the others' plain/summary.json || fail "the sphere has lost its symmetries"
for folder in noise jitter; do
  grep -q 'images of the others' $folder/summary.json && fail "$folder: symmetries that are not there"
  near $folder D12 "$(number plain/summary.json D12)" 0.01
done

# What is damaged from the start is so at t = 0, costs the flow nothing, and is no growth of the first step.  The sphere stays as it is, so that
# Y = (2 1.3^2 + 1.3^-4 - 3)/2 = 0.3650639 (paper eq. 4.2), with Y_D = 0.2 and Y_C = 2.
"$capsella" run "$root/configs/shear_quick.yaml" --quiet -o damaged --set 'start.axes=[1.3, 1.3, 1.3]' \
  --set time.end=0.1 --set flow.strength='[[0, 0]]' --set output.report=false
near damaged t_c 0 1e-6
near damaged d_max 0.08253195 1e-4 # the polyhedron settles
[ "$(sed -n 2p damaged/history.csv | cut -d, -f16)" = 0 ] || fail "energy spent before the first step"
