#!/bin/sh
# A law that fails in a run leaves what it was handed, and `laws check --replay` tells what is wrong with its answer.
. "$(dirname "$0")/common.sh"
broken=$(dirname "$capsella")/tests/broken

# fails LAW OPTIONS...: an inflation with a broken law fails, and names the file of the batch
fails() {
  law=$1
  shift
  code=0
  "$capsella" run "$root/configs/inflation_monotone.yaml" --quiet -o "$law" --set capsule.mesh.subdivisions=1 \
    --set membrane.check_laws=false "$@" 2>message || code=$?
  [ "$code" = 1 ] || fail "$law: exit code $code"
  grep -q "laws check --replay $law/law_failure.yaml" message || fail "$law: the file is not named: $(cat message)"
}

# replayed EXIT WORDS FILE
replayed() {
  code=0
  "$capsella" laws check --replay "$3" >report 2>&1 || code=$?
  [ "$code" = "$1" ] || fail "replay of $3: exit code $code: $(cat report)"
  grep -q "$2" report || fail "replay of $3: no '$2' in $(cat report)"
}

fails nan_energy --set "membrane.law=$broken/nan_energy.so" --set membrane.damage=
replayed 1 'batch, point [0-9]*: phi_2 is not finite' nan_energy/law_failure.yaml
replayed 1 'alone, point [0-9]*: phi_2 is not finite' nan_energy/law_failure.yaml
grep -q 'the run said: law nan_energy: expected a finite dphi' report || fail "$(cat report)"

fails domain --set "membrane.law=$broken/domain.so" --set membrane.damage=
replayed 1 'the law refuses with status 1: I1 is beyond 1' domain/law_failure.yaml

# Of a membrane whose strength varies, each point has its own.
fails nan_damage --set "membrane.damage.law=$broken/nan_damage.so" \
  --set 'membrane.damage.parameters={Y_D: {uniform: {from: 0.1, to: 0.2}, seed: 1}}'
replayed 1 'zeta is not finite' nan_damage/law_failure.yaml

fails healing --set "membrane.damage.law=$broken/healing.so" --set 'membrane.damage.parameters={}'
replayed 1 'damage falls' healing/law_failure.yaml

# The same points are fine with another plugin of that name, whose law is sound.
sed "s|^file: .*|file: \"$(dirname "$capsella")/plugins/neo_hookean.so\"|; s/^law: .*/law: \"neo_hookean\"/" \
  nan_energy/law_failure.yaml >sound.yaml
replayed 0 'the law answers every point' sound.yaml
grep -q 'the plugin has changed since' report || fail "$(cat report)"

sed '/^inputs/,$d' nan_energy/law_failure.yaml >cut.yaml
replayed 2 'expected a list under `inputs`' cut.yaml
replayed 2 'nowhere.yaml' nowhere.yaml
replayed 2 'expected the file of a law that failed' "$root/configs/shear_quick.yaml"

# A run into the same folder that does not fail leaves no such file.
"$capsella" run "$root/configs/inflation_monotone.yaml" --quiet -o nan_energy --set capsule.mesh.subdivisions=1
[ -f nan_energy/law_failure.yaml ] && fail "the batch of an earlier run is left"

# A law that stops the run may be asked again in this process.
"$capsella" laws check "$broken/nan_energy.so" --in-process --only energy/ >report && fail "nan_energy passes"
grep -q 'failed  .*energy/' report || fail "$(cat report)"
