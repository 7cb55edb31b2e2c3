#!/bin/sh
# Runs the stress matrix and judges every case:  stress.sh CAPSELLA FOLDER quick|full [PAGE.md]
# With GROUPS_OF_CASES in the environment, a regular expression, only those groups of cases; WORKERS: runs side by side.
# A case and the finer computation that it is compared with are two runs of the program, each with a limit of time.
# Prints the table of outcomes; fails when a case ends otherwise than it may.  PAGE.md receives the table as a page.
# Growth of noise is measured where there is a python3 with h5py.
set -eu
capsella=$1 folder=$2 which=$3 page=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
cpu_seconds=300 seconds=3000 # for one run: a hang, also on a machine that has other things to do
python=
for candidate in python3 /usr/bin/python3; do
  "$candidate" -c 'import h5py' 2>/dev/null && python=$candidate && break
done
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_WAIT_POLICY=passive OPENBLAS_NUM_THREADS=1

# run NAME KEY=VALUE...: exit code in NAME.code, messages in NAME.said
run() {
  name=$1
  shift
  for set; do
    shift
    set -- "$@" --set "$(printf '%s' "$set" | tr '~' ' ')"
  done
  code=0
  (ulimit -t "$cpu_seconds" && exec timeout "$seconds" "$capsella" run "$here/base.yaml" --quiet --threads 1 -o "$name" "$@" >"$name.said" 2>&1 </dev/null) || code=$?
  echo $code >"$name.code"
}

# "CA:SUBDIVISIONS:LIMIT" of rk2: the limit of a step at rest, below the estimate 2/rho by the margin for its error
limits() {
  for Ca in 0.05 0.3 0.7 1.5; do for n in 1 2; do
    run limit time.integrator=rk2 time.end=1e-6 flow.capillary_number=$Ca capsule.mesh.subdivisions=$n
    limit=$(sed -n 's/.*stable up to \(.*\)/\1/p' limit/log.txt)
    rm -rf limit
    echo "$Ca:$n:$(awk -v l="$limit" 'BEGIN { print l / 1.08 }')"
  done; done
}

# judge FIRST EVERY: the cases of one worker
judge() {
  set -f # the values of settings are no patterns
  awk -v first="$1" -v every="$2" 'NR % every == first { print NR " | " $0 }' cases.txt |
    while IFS='|' read -r id group expected bounds sets finer; do
      a="case$(echo $id)" b="finer$(echo $id)"
      # shellcheck disable=SC2086
      run "$a" $sets
      case $expected in
      *right* | *sound*)
        # shellcheck disable=SC2086
        run "$b" $sets $finer
        ;;
      esac
      awk -v id="$(echo $id)" -v group="$group" -v expected="$expected" -v bounds="$bounds" -v sets="$sets" \
        -v a="$a" -v b="$b" -f "$here/judge.awk" >>"verdicts.$1"
      rm -rf "$a" "$b" "$a.said" "$b.said" "$a.code" "$b.code"
    done
}

LIMITS=$(limits) sh "$here/cases.sh" "$which" | grep -E "^(${GROUPS_OF_CASES:-.*}) " >cases.txt
workers=${WORKERS:-$(nproc)}
for worker in $(seq 0 $((workers - 1))); do
  judge "$worker" "$workers" &
done
wait
cat verdicts.* >verdicts
[ "$(wc -l <verdicts)" = "$(wc -l <cases.txt)" ] || {
  echo "FAILED: $(wc -l <verdicts) verdicts on $(wc -l <cases.txt) cases" >&2
  exit 1
}
if [ -n "$page" ]; then
  awk -F' \\| ' -v version="$("$capsella" --version)" -f "$here/page.awk" verdicts >"$page"
  [ -z "$python" ] || "$python" "$here/growth.py" "$capsella" "$here/base.yaml" . >>"$page"
fi
awk -F' \\| ' -f "$here/table.awk" verdicts
