#!/bin/sh
# A run that is killed or interrupted goes on from its newest snapshot to the same bits.
. "$(dirname "$0")/common.sh"

# "$@" -o FOLDER is the run of this test: with a law of the membrane and with laws that look on, one of which
# finds rupture on the way.
set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet --threads 1 \
  --set output.snapshot_every=0.1 --set time.end=0.6 --set "observe.criteria=[
    {law: marigo, parameters: {Y_D: 0.001, Y_C: 0.02}}, {law: creep, parameters: {T_R: 0.5, tau: 1}}]"

"$@" -o whole
grep -q '"status": "end"' whole/summary.json || fail "the uninterrupted run did not end"

# Killed once its third snapshot is there, and again a little later.
"$@" -o killed &
process=$!
while [ ! -f killed/snapshot_000002.vtkhdf ] && kill -0 $process 2>/dev/null; do sleep 0.01; done
kill -9 $process 2>/dev/null || true
wait $process 2>/dev/null || true
[ -f killed/summary.json ] && fail "the run was over before it could be killed"
"$@" -o killed --resume &
process=$!
while [ ! -f killed/snapshot_000004.vtkhdf ] && kill -0 $process 2>/dev/null; do sleep 0.01; done
kill -9 $process 2>/dev/null || true
wait $process 2>/dev/null || true
"$@" -o killed --resume
grep -q 'resumed' killed/log.txt || fail "the run was not resumed"
same whole/history.csv killed/history.csv "history after two kills"
without_cost whole/summary.json >a
without_cost killed/summary.json >b
same a b "summary after two kills"
same whole/criteria.csv killed/criteria.csv "criteria after two kills"
grep -q '^marigo,marigo,ruptured,' whole/criteria.csv || fail "no rupture to keep: $(cat whole/criteria.csv)"

# Interrupted: stops by itself with a snapshot, exit code 0, status interrupted.
"$@" -o stopped &
process=$!
while [ ! -f stopped/snapshot_000001.vtkhdf ] && kill -0 $process 2>/dev/null; do sleep 0.01; done
kill -INT $process 2>/dev/null || kill -TERM $process
code=0
wait $process || code=$?
[ $code = 0 ] || fail "an interrupted run ends with exit code $code"
grep -q '"status": "interrupted"' stopped/summary.json || fail "status: $(cat stopped/summary.json)"
"$@" -o stopped --resume
same whole/history.csv stopped/history.csv "history after an interrupt"
without_cost stopped/summary.json >b
same a b "summary after an interrupt"

# A run that has ended goes on to a later end, as if it had been the end from the start.
"$@" -o longer --set time.end=0.4
"$@" -o longer --resume
same whole/history.csv longer/history.csv "history after a later end"
without_cost longer/summary.json >b
same a b "summary after a later end"

# From the very first snapshot, with the same counts of evaluations.
cp -r whole anew
rm anew/summary.json anew/snapshot_00000[1-9].vtkhdf
"$@" -o anew --resume
grep -q 'resumed' anew/log.txt || fail "the run was not resumed from its first snapshot"
[ "$(number anew/summary.json stage_evaluations)" -gt 0 ] || fail "no stage was summed by the coarse rule"
same whole/history.csv anew/history.csv "history from the first snapshot on"
without_cost anew/summary.json >b
same a b "summary from the first snapshot on"

# With other intervals the rows and snapshots that follow are those of the new intervals.
"$@" -o intervals --set time.end=0.3
"$@" -o intervals --resume --set output.history_every=0.05 --set output.snapshot_every=0.04
times=$(sed 1d intervals/history.csv | cut -d, -f1 | tr '\n' ' ')
[ "$times" = "0 0.1 0.2 0.3 0.35 0.4 0.45 0.5 0.55 0.6 " ] || fail "rows after other intervals: $times"

# A non-local drive of damage is taken up as well.
for folder in all part; do
  end=0.6
  [ $folder = part ] && end=0.3
  "$@" -o nonlocal_$folder --set membrane.damage.nonlocal.length=0.3 --set time.end=$end \
    --set membrane.damage.parameters.Y_D=0.001
done
"$@" -o nonlocal_part --resume --set membrane.damage.nonlocal.length=0.3 --set membrane.damage.parameters.Y_D=0.001
same nonlocal_all/history.csv nonlocal_part/history.csv "history with a non-local drive"

# A run that has ended by rupture stays there.
set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o ruptured --set capsule.mesh.subdivisions=1 \
  --set flow.capillary_number=2 --set time.end=4
"$@"
cp ruptured/history.csv once.csv
"$@" --resume
[ "$(number ruptured/summary.json status)" = ruptured ] || fail "status: $(cat ruptured/summary.json)"
same ruptured/history.csv once.csv "history of a ruptured run that is resumed"

# Neither gets another snapshot of the same time.
before=$(ls ruptured whole)
"$@" --resume
"$capsella" run whole/resolved.yaml --quiet -o whole --resume
[ "$(ls ruptured whole)" = "$before" ] || fail "files after resuming what is over: $(ls ruptured whole)"

# A run that is refused leaves the folder as it was, its log apart: there a line is added.
cp whole/log.txt log.before
code=0
"$capsella" run "$root/configs/shear_quick.yaml" --quiet -o whole --set membrane.law=no_such_law 2>message || code=$?
[ $code = 2 ] || fail "a law that is not there: exit code $code"
[ "$(ls ruptured whole)" = "$before" ] || fail "files after a refusal: $(ls whole)"
head -c "$(wc -c <log.before)" whole/log.txt | cmp -s - log.before || fail "the log of the earlier run is gone"

# Two runs in one folder would spoil each other's results.
set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o shared --threads 1
"$@" --set time.end=100 &
process=$!
while [ ! -f shared/snapshot_000000.vtkhdf ] && kill -0 $process 2>/dev/null; do sleep 0.01; done
code=0
"$@" 2>message || code=$?
kill -9 $process 2>/dev/null || true
wait $process 2>/dev/null || true
[ $code = 1 ] && grep -q 'another run' message || fail "a second run in a folder: $code $(cat message)"

# A folder that is not there, is empty, or has rows but no snapshot: the run starts anew, and says so on the terminal.
loud() { "$capsella" run "$root/configs/shear_quick.yaml" --threads 1 --set time.end=0.02 --set output.report=false "$@" 2>said; }
loud -o begun
mkdir empty
mkdir rows && cp begun/history.csv begun/resolved.yaml rows
for folder in missing empty rows; do
  loud -o $folder --resume || fail "$folder: $(cat said)"
  grep -q "^warning: $folder holds no snapshot to resume from: the run starts anew$" said || fail "$folder: said $(cat said)"
  same begun/history.csv $folder/history.csv "history of a run that had nothing to resume from"
done
loud -o begun --resume
! grep -q 'starts anew' said || fail "a run that goes on says that it starts anew"
