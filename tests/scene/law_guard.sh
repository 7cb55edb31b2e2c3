#!/bin/sh
# A law that crashes or hangs in the middle of a run is named, with time and element, and what was written is whole.
. "$(dirname "$0")/common.sh"
broken=$(dirname "$capsella")/tests/broken
if grep -q __tsan_init "$capsella"; then
  echo "skipped: the thread sanitizer holds signals back while a law hangs" && exit 77
fi

set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet --law-timeout 2 --set capsule.mesh.subdivisions=1 \
  --set membrane.damage= --set membrane.check_laws=false --set output.snapshot_every=0.05 --set time.end=0.3 --set output.report=false

# bad LAW WORDS: the law named, the run gone on with a sound one
bad() {
  law=$1 words=$2
  shift 2
  code=0
  "$@" -o "$law" --set "membrane.law=$broken/turns_bad.so#turns_bad.$law" 2>message || code=$?
  [ $code = 1 ] || fail "$law: exit code $code ($(cat message))"
  grep -Eq "law turns_bad.$law $words at t = 0\.[0-9]*, element [0-9]+" message || fail "$law: $(cat message)"
  ls "$law"/snapshot_*.vtkhdf >/dev/null || fail "$law: no snapshot"
  "$@" -o "$law" --resume 2>message || fail "$law: not resumed: $(cat message)"
  grep -q 'resumed at t = 0.' "$law/log.txt" || fail "$law: begun anew: $(cat "$law/log.txt")"
}
if grep -q __asan_init "$capsella"; then
  echo "a crash is not tested: a sanitizer ends a process in its own way"
else
  bad crashing 'crashed \(signal [0-9]+\)' "$@"
fi
bad hanging 'has not come back for 2 s' "$@"

code=0
"$capsella" run "$root/configs/shear_quick.yaml" --law-timeout soon 2>message || code=$?
[ $code = 2 ] && grep -q 'law-timeout needs' message || fail "a bad --law-timeout: $code $(cat message)"
