#!/bin/sh
# Wrong input ends with exit code 2 (or 1 where a file is at fault) and a message that names the place and what to do.
. "$(dirname "$0")/common.sh"

good="$root/configs/shear_quick.yaml"

# refused EXIT PATTERN ARGUMENTS...: the program must end with EXIT and print a line that matches PATTERN.
refused() {
  expected=$1 pattern=$2
  shift 2
  code=0
  "$capsella" run "$@" -o out --quiet 2>message || code=$?
  [ "$code" = "$expected" ] || fail "exit code $code, expected $expected: $* ($(cat message))"
  grep -Eq "$pattern" message || fail "no match for '$pattern' in: $(cat message)"
}

# edited SED-SCRIPT: the good scene, changed
edited() {
  sed "$1" "$good" >scene.yaml
  cmp -s "$good" scene.yaml && fail "the edit '$1' changes nothing"
  return 0
}

edited 's/capillary_number/capilary_number/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*capilary_number.*did you mean `flow.capillary_number`' scene.yaml

edited 's/^accuracy: draft/accuracy: draft\naccuracy: fine/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*accuracy' scene.yaml

edited 's/subdivisions: 2/subdivisions: two/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*expected.*two' scene.yaml

edited 's/subdivisions: 2/subdivisions: 9/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*expected.*7.*9' scene.yaml

refused 2 '^nowhere.yaml: .*No such file' nowhere.yaml

edited 's/law: marigo/law: marigoo/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*marigoo.*did you mean `marigo`' scene.yaml

edited "s|law: marigo|law: $(dirname "$capsella")/tests/broken/wrong_major.so|"
refused 2 '^scene.yaml:[0-9]+:[0-9]+: ' scene.yaml
grep -Eq 'ABI 2' message || fail "the foreign ABI is not named: $(cat message)"

edited 's/Y_D: 0.2/Y_D: -0.2/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: parameter Y_D of law marigo: expected at least 0, found -0.2' scene.yaml

edited 's/Y_D: 0.2/Y_d: 0.2/'
refused 2 '^scene.yaml:[0-9]+:[0-9]+: .*Y_d.*did you mean `Y_D`' scene.yaml

edited 's/^  end: 2/  end: 2\n  integrator: rk2\n  step: 0.1/'
refused 2 'step.*0.1.*stability limit' scene.yaml

# A step that the user lets pass, and a stable one that is far too long: marked wherever the results are.
"$capsella" run scene.yaml -o unstable --quiet --set time.allow_unstable=true --set time.end=0.3 || true
grep -q 'warning: .*beyond the stability limit' unstable/log.txt || fail "unstable steps: $(cat unstable/log.txt)"
[ "$(number unstable/summary.json unstable_steps)" -gt 0 ] || fail "unstable steps are not counted"
"$capsella" run scene.yaml -o coarse --quiet --set time.integrator=rkc2 --set time.step=0.5
grep -q 'warning: the error of the fixed steps' coarse/log.txt || fail "a step far too long: $(cat coarse/log.txt)"
[ "$(number coarse/summary.json unstable_steps)" = 0 ] || fail "stable steps are counted as unstable"

refused 2 'stop.steady.*expected `output.history_every` above 0' "$good" --set stop.steady=0.01 --set output.history_every=0

# What is printed and does not arrive is a failure.
if [ -c /dev/full ]; then
  code=0
  "$capsella" manual >/dev/full 2>message || code=$?
  [ "$code" = 1 ] && grep -q 'standard output' message || fail "a full standard output: $code $(cat message)"
fi

# A folder that cannot be made: a file is in the way.
touch taken
code=0
"$capsella" run "$good" -o taken --quiet 2>message || code=$?
[ "$code" = 1 ] && grep -q taken message || fail "a folder that cannot be made: $code $(cat message)"

# No snapshot is whole: a resume is refused, and nothing is touched.
"$capsella" run "$good" -o cut --quiet --set time.end=0.1 --set output.snapshot_every=0
for snapshot in cut/snapshot_*.vtkhdf; do
  head -c 5000 "$snapshot" >part && mv part "$snapshot"
done
code=0
"$capsella" run "$good" -o cut --quiet --resume 2>message || code=$?
[ "$code" = 1 ] || fail "a resume from a cut-off snapshot: exit code $code"
grep -q 'none of its snapshots is whole.*without --resume' message || fail "cut-off snapshot: $(cat message)"
grep -q 'snapshot_000000.vtkhdf' message || fail "the damaged snapshot is not named: $(cat message)"
[ -f cut/snapshot_000000.vtkhdf ] || fail "the damaged snapshot is gone"

# The source of a law in the place of its .so.
touch law.c
edited 's|law: marigo|law: ./law.c|'
refused 2 '^scene.yaml:10:10: .*damage law' scene.yaml
grep -q '^  ./law.c: is a source; what a scene names is the .so' message || fail "a source: $(cat message)"

# What YAML refuses, with what it mostly means.
edited 's/^  kind: simple_shear/\tkind: simple_shear/'
refused 2 '^scene.yaml:13:1: .*a tab\? indent with blanks' scene.yaml
edited 's/capillary_number: 0.7/capillary_number:0.7/'
refused 2 '^scene.yaml:15:1: .*from line 14.*blank behind the colon' scene.yaml
edited 's/law: marigo/law marigo/'
refused 2 '^scene.yaml:11:15: .*a line above without its colon' scene.yaml
edited 's/{Y_D: 0.2, Y_C: 2.0}/{Y_D: 0.2 Y_C: 2.0}/'
refused 2 '^scene.yaml:11:30: .*commas between' scene.yaml

# A symbol in the place of its key, and files and commands taken for others.
edited 's/capillary_number:/Ca:/'
refused 2 '^scene.yaml:14:3: .*`flow.Ca` \(did you mean `flow.capillary_number`' scene.yaml
refused 2 '^.*fig16.yaml:4:1: expected a scene, found a study; `capsella study` runs it' "$root/configs/paper/fig16.yaml"
code=0
"$capsella" study "$good" 2>message || code=$?
[ "$code" = 2 ] && grep -q 'expected a study, found a scene; `capsella run` runs it' message ||
  fail "a scene taken for a study: $code $(cat message)"
code=0
"$capsella" "$good" 2>message || code=$?
[ "$code" = 2 ] && grep -q "'capsella run $good' runs a scene" message || fail "a scene as command: $code $(cat message)"

# Unknown option, subcommand, and a --set that is no KEY=VALUE.
refused 2 'usage:' "$good" --fast
refused 2 'set' "$good" --set nonsense
code=0
"$capsella" rum 2>message || code=$?
[ "$code" = 2 ] && grep -q "did you mean 'run'" message || fail "misspelt subcommand: $code $(cat message)"
