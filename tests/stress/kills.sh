#!/bin/sh
# Kills runs at random moments and resumes each to its end:  kills.sh CAPSELLA FOLDER KILLS [SEED]
# Rows, criteria, summary and every snapshot must be those of a run that nobody killed, bit for bit, but for the seconds
# that it took: those stand in the summary and in the last snapshot.  Every third run is killed once more on its way back.
# Prints where the kills fell.
set -eu
capsella=$1 folder=$2 kills=$3 seed=${4:-1}
root=$(cd "$(dirname "$0")/../.." && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

run() { # FOLDER [OPTIONS]
  out=$1
  shift
  exec "$capsella" run "$root/configs/shear_quick.yaml" --quiet --threads 1 -o "$out" "$@" \
    --set capsule.mesh.subdivisions=1 --set output.snapshot_every=0.02 --set time.end=1 \
    --set "observe.criteria=[{law: marigo, parameters: {Y_D: 0.001, Y_C: 0.02}}]"
}
# Whether two snapshots differ in more than the seal at their start and one number of eight bytes.
differ() {
  cmp -l "$1" "$2" | awk '$1 > 512 { if (!first) first = $1; last = $1 } END { exit !(last - first >= 8) }' ||
    [ "$(wc -c <"$1")" != "$(wc -c <"$2")" ]
}
without_cost() { grep -v -e wall_seconds -e '"threads"' "$1/summary.json"; }

# killed_after SECONDS COMMAND...: whether the kill came before the end
killed_after() {
  seconds=$1
  shift
  "$@" &
  process=$!
  sleep "$seconds"
  kill -9 $process 2>/dev/null || true
  code=0
  wait $process 2>/dev/null || code=$?
  [ $code = 137 ]
}

(run whole)
without_cost whole >whole.summary
start=$(date +%s.%N)
(run timed)
span=$(echo "$start $(date +%s.%N)" | awk '{ print $2 - $1 }')
echo "seed $seed; a run takes $span s"

done=0 tried=0 same=0
while [ $done -lt "$kills" ]; do
  tried=$((tried + 1))
  rm -rf killed
  moment=$(awk -v seed="$seed" -v n=$tried -v span="$span" 'BEGIN { srand(1000 * seed + n); rand(); print rand() * span }')
  killed_after "$moment" run killed || continue # it was over before
  done=$((done + 1))
  reached=$(ls killed/snapshot_*.vtkhdf 2>/dev/null | wc -l)
  [ $((done % 3)) != 0 ] || killed_after "$moment" run killed --resume || true
  (run killed --resume) || { echo "kill $done at $moment s: not resumed"; continue; }
  differs=
  for file in history.csv criteria.csv $(cd whole && ls snapshot_*); do
    cmp -s whole/"$file" killed/"$file" && continue
    [ "$file" = snapshot_000050.vtkhdf ] && ! differ whole/"$file" killed/"$file" || differs="$differs $file"
  done
  without_cost killed | cmp -s - whole.summary || differs="$differs summary.json"
  [ "$(cd whole && ls)" = "$(cd killed && ls)" ] || differs="$differs (other files)"
  if [ -z "$differs" ]; then
    same=$((same + 1))
    echo "$moment $reached" >>moments
  else
    echo "kill $done at $moment s, after $reached snapshots: other$differs"
    cp -r killed "differs_$done"
  fi
done
touch moments
sort -n moments | awk '{ snapshots[int($2 / 10)]++ } END { for (k = 0; k <= 5; k++) printf "killed after %d to %d of 51 snapshots: %d\n", 10 * k, 10 * k + 9, snapshots[k] }'
echo "$done kills, $same resumed to the same bits"
[ "$same" = "$kills" ]
