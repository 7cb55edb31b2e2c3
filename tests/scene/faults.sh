#!/bin/sh
# What may go wrong around a run: full disks, read-only folders, damaged snapshots.  The run ends with the reason or
# goes on from what is whole, and what was written before stays whole.
. "$(dirname "$0")/common.sh"

set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet --threads 1 --set capsule.mesh.subdivisions=1 \
  --set output.snapshot_every=0.1 --set time.end=0.5 --set output.report=false

"$@" -o whole

# Damage to the newest snapshot: cut off, one bit turned, emptied.  The one before is used, and the damage is told.
newest=snapshot_000005.vtkhdf
damage() { # NAME COMMAND...: what COMMAND makes of the newest snapshot takes its place
  cp -r whole "$1"
  name=$1
  shift
  "$@" <whole/$newest >"$name/$newest"
  cmp -s whole/$newest "$name/$newest" && fail "$name: nothing is damaged"
  return 0
}
turn_bit() { # PLACE: one bit of that byte
  dd bs=1 count="$1" 2>/dev/null
  byte=$(dd bs=1 count=1 2>/dev/null | od -An -to1)
  # shellcheck disable=SC2059
  printf "\\$(printf %03o $((0${byte# } ^ 1)))"
  cat
}
without_cost whole/summary.json >a
damage cut head -c 9999
damage empty head -c 0
for place in 10 40 700 30000; do damage "bit_$place" turn_bit $place; done
for name in cut empty bit_10 bit_40 bit_700 bit_30000; do
  "$@" -o "$name" --resume
  grep -q "warning: .*$newest" "$name/log.txt" || fail "$name: the damage is not told: $(cat "$name/log.txt")"
  grep -q 'resumed at t = 0.4' "$name/log.txt" || fail "$name: not resumed from the one before"
  same whole/history.csv "$name/history.csv" "history after a damaged snapshot ($name)"
  without_cost "$name/summary.json" >b
  same a b "summary after a damaged snapshot ($name)"
done

# A folder that cannot be written into, and one that fills up.  Both need a file system of their own.
mounted=""
trap 'for folder in $mounted; do umount "$folder"; done' EXIT
mount_small() { # NAME OPTIONS
  mkdir -p "$1"
  mount -t tmpfs -o "$2" capsella-test "$1" 2>/dev/null || return 1
  mounted="$mounted $work/$1"
}
if ! mount_small full size=300k; then
  echo "full and read-only folders are not tested: this user cannot mount"
  exit 0
fi

code=0
"$@" -o full 2>message || code=$?
[ $code = 1 ] || fail "a full disk: exit code $code ($(cat message))"
grep -q 'No space left' message || fail "a full disk is not told: $(cat message)"
ls full/snapshot_*.vtkhdf >/dev/null || fail "no snapshot on the full disk"
mkdir roomy
cp -r full/. roomy
"$@" -o roomy --resume
same whole/history.csv roomy/history.csv "history of a run that met a full disk and went on elsewhere"

mount_small fixed size=300k,ro || fail "a second mount"
code=0
"$@" -o fixed 2>message || code=$?
[ $code = 1 ] && grep -q 'fixed.*Read-only' message || fail "a read-only folder: $code $(cat message)"
