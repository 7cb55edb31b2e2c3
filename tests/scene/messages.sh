#!/bin/sh
# Messages for what goes wrong around a run and in few other tests: each is produced here on purpose.
. "$(dirname "$0")/common.sh"
broken=$(dirname "$capsella")/tests/broken

# says CODE WORDS COMMAND...
says() {
  expected=$1 words=$2 code=0
  shift 2
  "$@" >message 2>&1 </dev/null || code=$?
  [ $code = "$expected" ] || fail "exit code $code instead of $expected: $(cat message)"
  grep -q -e "$words" message || fail "no '$words' in: $(cat message)"
}
run() { # FOLDER [OPTIONS]
  out=$1
  shift
  "$capsella" run "$root/configs/shear_quick.yaml" --quiet --threads 1 -o "$out" --set capsule.mesh.subdivisions=0 \
    --set time.end=0.2 --set membrane.check_laws=false "$@"
}

# A study none of whose cases can be computed.
cat >study.yaml <<END
schema: 1
study: sweep
scene: $root/configs/inflation_monotone.yaml
vary: {membrane.law: [$broken/nan_energy.so], membrane.check_laws: [false]}
END
says 1 'all cases failed: see out/table.csv' "$capsella" study study.yaml --quiet --jobs 1 -o out \
  --set capsule.mesh.subdivisions=0

# What stands in the way of results.
mkdir -p blocked/snapshot_000000.vtkhdf/full paged/report.html/full
says 1 'blocked/snapshot_000000.vtkhdf: the file of an earlier run cannot be removed: ' run blocked
says 1 'paged/report.html: the file of an earlier run cannot be removed: ' run paged

# A run whose snapshots are gone.
run bare
rm bare/snapshot_*
says 2 'bare: expected a snapshot of a run, found none that is whole' "$capsella" report bare

# A criterion whose law fails is named.
says 1 'criterion nan_damage: .*law .*nan_damage' run failing --set "observe.criteria=[{law: $broken/nan_damage.so, name: nan_damage}]"
