#!/bin/sh
# Every scene of the config folder runs (shortened where it is long), ends as it should, and reports no false rupture.
. "$(dirname "$0")/common.sh"

# ends STATUS SCENE OPTIONS...
ends() {
  status=$1 name=$2
  shift 2
  "$capsella" run "$root/configs/$name.yaml" --quiet -o "$name" "$@" || fail "$name"
  [ "$(number "$name/summary.json" status)" = "$status" ] || fail "$name: status $(number "$name/summary.json" status)"
  "$capsella" run "$name/resolved.yaml" --quiet -o "$name-again" || fail "resolved scene of $name"
  same "$name/history.csv" "$name-again/history.csv" "the resolved scene of $name gives other numbers"
}

ends ruptured inflation_monotone
ends ruptured inflation_cycles
ends end shear_quick --set time.end=0.3
ends end shear_reference --set time.end=0.02
ends end shear_skalak --set time.end=0.02
ends end shear_scatter --set time.end=0.02

# Nothing is left out: a scene that the list above forgets is a failure.
for scene in "$root"/configs/*.yaml; do
  [ -d "$(basename "$scene" .yaml)" ] || fail "configs/$(basename "$scene") is not run here"
done
