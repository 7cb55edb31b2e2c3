#!/bin/sh
# Studies: the table depends neither on jobs nor on kills; nothing is repeated; a failed case is a row.
. "$(dirname "$0")/common.sh"

cat >sweep.yaml <<END
schema: 1
study: sweep
scene: $root/configs/shear_quick.yaml
vary:
  flow.capillary_number: [0.5, 4.0]
  membrane.damage.parameters.Y_D: {from: 0.1, to: 0.2, count: 2}
END
# "$@" -o FOLDER is the study of this test: four short runs, of which two break.
set -- "$capsella" study sweep.yaml --quiet --set capsule.mesh.subdivisions=1 --set time.end=3 \
  --set membrane.damage.parameters.Y_C=0.5

"$@" -o one --jobs 1
"$@" -o two --jobs 3
same one/table.csv two/table.csv "the table with other jobs"
[ "$(wc -l <one/table.csv)" = 5 ] || fail "rows: $(cat one/table.csv)"
grep -q '^4.0,0.1,"capillary_number=4.0,Y_D=0.1",ruptured,' one/table.csv || fail "no rupture: $(cat one/table.csv)"
[ -f one/cases/capillary_number=0.5,Y_D=0.1/history.csv ] || fail "a case has no history"
[ -f one/report.html ] || fail "a study leaves no page"
[ ! -e one/cases/capillary_number=0.5,Y_D=0.1/report.html ] || fail "a case leaves a page of its own"
cp one/report.html page.html
"$capsella" report one
same one/report.html page.html "report makes another page than the study"

# The runs of a study are those of the same settings.
"$capsella" run "$root/configs/shear_quick.yaml" --quiet -o alone --set capsule.mesh.subdivisions=1 --set time.end=3 \
  --set membrane.damage.parameters.Y_C=0.5 --set output.snapshot_every=0 --set flow.capillary_number=0.5 --set membrane.damage.parameters.Y_D=0.2 --threads 1
same alone/history.csv one/cases/capillary_number=0.5,Y_D=0.2/history.csv "a case and the run of its settings"

# Known cases are taken over, and only new ones are run.
cp one/journal.txt before
"$@" -o one --resume
same one/journal.txt before "the journal of a study that had nothing to do"
same one/table.csv two/table.csv "the table that had nothing to do"

# Killed again and again, a little later each time, it ends with the same table.
count=1
"$@" -o killed --jobs 2 &
process=$!
while sleep 0.0$count && [ $count -lt 9 ] && kill -9 $process 2>/dev/null; do
  wait $process 2>/dev/null || true
  "$@" -o killed --jobs 2 --resume &
  process=$!
  count=$((count + 1))
done
wait $process
[ $count -gt 1 ] || fail "the study was over before it could be killed"
same one/table.csv killed/table.csv "the table after $count kills"

# Parts make up the whole, as do the tasks of an array of Slurm.
cat >three.yaml <<END
schema: 1
study: sweep
scene:
  schema: 1
  capsule: {mesh: {subdivisions: 0}}
  membrane: {law: neo_hookean}
  flow: {kind: simple_shear}
  time: {end: 0.2}
vary:
  flow.capillary_number: [0.5, 4.0, 0.3]
  capsule.mesh.rotation.angle: [0, 0.1]
END
"$capsella" study three.yaml --quiet -o whole
for part in 1 2; do "$capsella" study three.yaml --quiet -o parts --part $part/2; done
awk 'NR == 1 || FNR > 1' parts/part_*/table.csv >joined.csv
same joined.csv whole/table.csv "the tables of the parts"
[ "$(wc -l <parts/part_1/table.csv)" = 3 ] && [ "$(wc -l <parts/part_2/table.csv)" = 5 ] || fail "share of the parts"
for task in 1 2 3; do
  SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=2 PATH="$(dirname "$capsella"):$PATH" \
    sh "$root/configs/studies/slurm_array.sh" three.yaml array
done
awk 'NR == 1 || FNR > 1' array/part_*/table.csv >joined.csv
same joined.csv whole/table.csv "the tables of the tasks"
for wrong in 4/3 0/3 1 x/2 1/4; do
  code=0
  "$capsella" study three.yaml --part $wrong -o wrong 2>message || code=$?
  [ $code = 2 ] && [ ! -e wrong ] || fail "--part $wrong: $code, $(cat message)"
done
grep -q 'at most 3 parts.*flow.capillary_number' message || fail "$(cat message)"

# Interrupted, it says so and can go on.
"$@" -o stopped --jobs 2 &
process=$!
while ! grep -q done stopped/journal.txt 2>/dev/null && kill -0 $process 2>/dev/null; do sleep 0.01; done
kill -INT $process 2>/dev/null || kill -TERM $process
code=0
wait $process || code=$?
[ $code = 0 ] || fail "an interrupted study ends with exit code $code"
grep -q '"status": "interrupted"' stopped/summary.json || fail "$(cat stopped/summary.json)"
"$@" -o stopped --resume
same one/table.csv stopped/table.csv "the table after an interrupt"

# A case that fails is a row with its reason, and the rest is done.
cat >failing.yaml <<END
schema: 1
study: sweep
scene: $root/configs/shear_quick.yaml
vary: {time.step: [auto, 5], name: [a, b]}
END
"$capsella" study failing.yaml --quiet -o failing --set time.integrator=rk2 --set capsule.mesh.subdivisions=1 --set time.end=0.2
[ "$(grep -c ',end,' failing/table.csv)" = 2 ] || fail "$(cat failing/table.csv)"
[ "$(grep -c ',failed,.*stability' failing/table.csv)" = 2 ] || fail "$(cat failing/table.csv)"
[ "$(number failing/summary.json failed)" = 2 ] || fail "$(cat failing/summary.json)"
cp failing/journal.txt before
"$capsella" study failing.yaml --quiet -o failing --set time.integrator=rk2 --set capsule.mesh.subdivisions=1 --set time.end=0.2 --resume
same failing/journal.txt before "failed cases were repeated"

# Wrong input is told before anything is touched.
code=0
"$@" -o one --set flow.kind=none 2>message || code=$?
[ $code = 2 ] || fail "exit code $code"
same one/table.csv two/table.csv "the table after wrong input"
