#!/bin/sh
# Flat discs, emptier than the sphere at rest, whose faces come nearer to each other than the mesh resolves: told once,
# and the end of a run where they touch or cross.
. "$(dirname "$0")/common.sh"

run() { # FOLDER [OPTIONS]
  out=$1
  shift
  "$capsella" run "$root/tests/stress/base.yaml" --quiet -o "$out" --set capsule.mesh.subdivisions=2 \
    --set start.axes=[1.2,1.2,0.1] --set 'flow.strength=[[0,0]]' "$@" 2>/dev/null
}
warned() { # FOLDER: once, and with the thinnest film in the summary
  [ "$(grep -c 'warning: .*two parts of the membrane are' "$1/log.txt")" = 1 ] || fail "$1: $(cat "$1/log.txt")"
  awk -v film="$(number "$1/summary.json" film_min)" 'BEGIN { exit !(film > 0.02 && film < 0.5) }' ||
    fail "$1: film_min is $(number "$1/summary.json" film_min)"
}
ends_by() { # FOLDER WORDS
  [ "$(number "$1/summary.json" status)" = failed ] || fail "$1: $(number "$1/summary.json" status)"
  grep -q "$2 at t = .*expected a film between its two parts" "$1/log.txt" || fail "$1: $(cat "$1/log.txt")"
}

# Without a flow the faces stay apart.
run still --set time.end=0.1
warned still
grep -q "rough on the scale of the mesh, by .* of an edge at t = " still/log.txt || fail "still: $(cat still/log.txt)"
[ "$(number still/summary.json status)" = end ] || fail "still: $(cat still/log.txt)"

# Goes on after a restart without telling again what was told.
run halves --set time.end=0.05 --set output.snapshot_every=0.05
run halves --set time.end=0.1 --set output.snapshot_every=0.05 --resume
warned halves

# A flow that presses the disc together.
run pressed --set flow.kind=uniaxial_extension --set 'flow.strength=[[0,-1]]' --set flow.capillary_number=1 && fail "pressed ended well"
warned pressed
ends_by pressed 'the membrane \(touches\|crosses\) itself'

# The direct quadrature does not see a film as thin as this: it lets the faces through each other, and says before that
# it does not resolve it.  The fast one keeps them apart.
run through --set start.axes=[1.2,1.2,0.05] --set fluid.method=direct --set time.end=0.6 && fail "through ended well"
warned through
grep -q 'nor does `fluid.method: direct`' through/log.txt || fail "through: $(cat through/log.txt)"
ends_by through 'the membrane \(crosses\|touches\) itself'
run apart --set start.axes=[1.2,1.2,0.05] --set time.end=0.6
warned apart

# A capsule that is as usual, and an inflation, have nothing to tell.
run usual --set start.axes=[1,1,1] --set 'flow.strength=[[0,1]]' --set time.end=1
[ "$(number usual/summary.json film_min)" = null ] || fail "usual: $(number usual/summary.json film_min)"
grep -q warning usual/log.txt && fail "usual: $(cat usual/log.txt)"
exit 0
