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

# Settings without those that later ones replace: the same for the same run.
settled() {
  for set; do echo "$set"; done | awk -F= '{ if (!($1 in value)) key[++n] = $1; value[$1] = $0 }
    END { for (i = 1; i <= n; i++) print value[key[i]] }'
}

# finer KEY=VALUE...: $b becomes the name of the run with these settings, which many cases may share.
finer() {
  b=finer$(settled "$@" | LC_ALL=C sort | cksum | tr ' ' _)
  [ ! -f "$b.code" ] || return 0
  # shellcheck disable=SC2046
  run "part$id" $(settled "$@")
  find "part$id" -type f ! -name summary.json -delete 2>/dev/null || true
  rm -rf "$b"
  [ ! -d "part$id" ] || mv "part$id" "$b"
  mv "part$id.said" "$b.said"
  mv "part$id.code" "$b.code"
}

# judge WORKER: cases that no other has claimed
judge() {
  set -f # the values of settings are no patterns
  awk '{ print NR " | " $0 }' cases.txt |
    while IFS='|' read -r id group expected bounds sets finer; do
      id=$(echo $id) b=none
      mkdir "claim$id" 2>/dev/null || continue
      # shellcheck disable=SC2086
      run "case$id" $sets
      case $expected in
      # shellcheck disable=SC2086
      *right* | *sound*) finer $sets $finer ;;
      esac
      awk -v id="$id" -v group="$group" -v expected="$expected" -v bounds="$bounds" -v sets="$sets" \
        -v a="case$id" -v b="$b" -f "$here/judge.awk" >>"verdicts.$1"
      rm -rf "case$id" "case$id.said" "case$id.code"
    done
}

LIMITS=$(limits) sh "$here/cases.sh" "$which" | grep -E "^(${GROUPS_OF_CASES:-.*}) " >cases.txt
workers=${WORKERS:-$(nproc)}
for worker in $(seq "$workers"); do
  judge "$worker" &
done
wait
sort -n verdicts.[0-9]* >verdicts
[ "$(wc -l <verdicts)" = "$(wc -l <cases.txt)" ] || {
  echo "FAILED: $(wc -l <verdicts) verdicts on $(wc -l <cases.txt) cases" >&2
  exit 1
}
if [ -n "$page" ]; then
  awk -F' \\| ' -v version="$("$capsella" --version)" -f "$here/page.awk" verdicts >"$page"
  [ -z "$python" ] || "$python" "$here/growth.py" "$capsella" "$here/base.yaml" . >>"$page"
fi
awk -F' \\| ' -f "$here/table.awk" verdicts
