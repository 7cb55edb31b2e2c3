#!/bin/sh
# Critical values: they depend neither on jobs nor on kills, and runs on both sides of them say the same.
. "$(dirname "$0")/common.sh"

cat >study.yaml <<END
schema: 1
study: threshold
scene:
  schema: 1
  capsule: {mesh: {subdivisions: 1}}
  membrane: {law: neo_hookean, parameters: {G_s: 1}, damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2}}}
  flow: {kind: simple_shear}
  time: {end: 30}
  accuracy: draft
find: [Ca_c, Ca_l, {name: onset, when: d_max, above: 0}]
bracket: [0.2, 1.2]
tolerance: 0.04
vary: {membrane.damage.parameters.Y_D: {from: 0.2, to: 0.4, count: 3}}
END
set -- "$capsella" study study.yaml --quiet

# cell ROW COLUMN of a table.csv
cell() {
  sed -n "$(($2 + 1))p" "$1" | cut -d, -f"$3"
}
# within A B DISTANCE
within() {
  awk -v a="$1" -v b="$2" -v most="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(a != "" && b != "" && d <= most) }'
}

"$@" -o one --jobs 1
"$@" -o two --jobs 4
same one/table.csv two/table.csv "the table with other jobs"
[ "$(number one/summary.json runs_saved)" -gt 10 ] || fail "runs saved: $(cat one/summary.json)"

# Ca_c of the elastic runs is where damaged runs begin to be damaged.
for row in 1 2 3; do
  within "$(cell one/table.csv $row 2)" "$(cell one/table.csv $row 14)" 0.021 ||
    fail "Ca_c from elastic and from damaged runs: $(cat one/table.csv)"
done
# It rises with Y_D, as does Ca_l.
awk -F, 'NR > 1 { if (!($2 > c && $8 > l && $2 < $8)) exit 1; c = $2; l = $8 }' one/table.csv ||
  fail "order of the values: $(cat one/table.csv)"

# The run above the limit ruptures, the one below does not.
for side in 9 10; do
  "$capsella" run two/scene.yaml --quiet -o side$side --set membrane.damage.parameters.Y_D=0.3 \
    --set flow.capillary_number="$(cell two/table.csv 2 $side)"
done
[ "$(number side9/summary.json status)" != ruptured ] || fail "below: $(cat side9/summary.json)"
[ "$(number side10/summary.json status)" = ruptured ] || fail "above: $(cat side10/summary.json)"

# Killed again and again, it ends with the same table.
count=0
"$@" -o killed --jobs 2 &
process=$!
while sleep 0.2$count && [ $count -lt 6 ] && kill -9 $process 2>/dev/null; do
  wait $process 2>/dev/null || true
  "$@" -o killed --jobs 2 --resume &
  process=$!
  count=$((count + 1))
done
wait $process
[ $count -gt 2 ] || fail "the study was over before it could be killed twice"
same one/table.csv killed/table.csv "the table after $count kills"

# Spread over the ranks of an MPI job, it ends with the same table too.  Open MPI itself leaks.
export ASAN_OPTIONS=detect_leaks=0
if ! mpirun --version 2>&1 | grep -q 'Open MPI'; then
  echo "skipped: the mpirun of Open MPI is not installed"
elif mpirun --allow-run-as-root --oversubscribe -n 2 "$@" -o ranks 2>message; then
  same one/table.csv ranks/table.csv "the table under MPI"
  [ "$(sed -n 's/^    "jobs": \([0-9]*\),$/\1/p' ranks/summary.json)" = 2 ] || fail "ranks: $(cat ranks/summary.json)"
elif grep -q 'built without MPI' message; then
  echo "skipped: the program was built without MPI"
else
  fail "under MPI: $(cat message)"
fi

unset ASAN_OPTIONS

# Without a value inside the bracket a row says so.
sed 's/bracket: .*/bracket: [0.2, 0.25]/; s/find: .*/find: [Ca_c, Ca_l]/' study.yaml >outside.yaml
"$capsella" study outside.yaml -o outside >told.txt 2>/dev/null
grep -q 'damage does not begin inside the bracket' outside/table.csv || fail "$(cat outside/table.csv)"
grep -q 'the condition holds nowhere in the bracket' outside/table.csv || fail "$(cat outside/table.csv)"
for target in Ca_c Ca_l; do
  grep -q "^$target: none found" told.txt || fail "the terminal is not told of $target: $(cat told.txt)"
done

# wrong EDIT WORDS
wrong() {
  sed "$1" study.yaml >wrong.yaml
  code=0
  "$capsella" study wrong.yaml -o wrong 2>message || code=$?
  [ $code = 2 ] && grep -qF "$2" message || fail "$1: $code, $(cat message)"
}
wrong 's/\[Ca_c,/[Ca_x,/' '10:8: expected `Ca_c` or `Ca_l` for `find`, found `Ca_x` (did you mean `Ca_c`?)'
wrong 's/, above: 0}/}/' 'expected the key `above`'
wrong 's/tolerance: 0.04/tolerance: 2/' '12:12: expected a number above 0 and below the length of the bracket'
wrong 's/\[0.2, 1.2\]/[1.2, 0.2]/' '11:10: expected 0 < low < high'
wrong 's/tolerance/tolerence/' '12:1: expected a known key, found `tolerence` (did you mean `tolerance`?)'
wrong 's/name: onset,/name: onset, key: flow.speed,/' 'expected a known key, found `flow.speed`'
[ ! -e wrong ] || fail "wrong input has left a folder"
