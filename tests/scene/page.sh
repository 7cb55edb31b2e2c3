#!/bin/sh
# Every run leaves its page, small enough to send; `report` makes the same page again; output.report: false leaves none.
. "$(dirname "$0")/common.sh"
quick="$root/configs/shear_quick.yaml"

"$capsella" run "$quick" --quiet -o shown --set time.end=0.1
[ -f shown/report.html ] || fail "a run leaves no report.html"
[ "$(wc -c <shown/report.html)" -lt 8000000 ] || fail "report.html has $(wc -c <shown/report.html) bytes"
cp shown/report.html first.html
"$capsella" report shown >written.txt
grep -qx 'shown/report.html' written.txt || fail "report does not name the page: $(cat written.txt)"
same shown/report.html first.html "report makes another page than the run"

"$capsella" run "$quick" --quiet -o shown --set time.end=0.1 --set output.report=false
[ ! -e shown/report.html ] || fail "output.report=false leaves a page, or that of an earlier run"
grep -q '^  report: false$' shown/resolved.yaml || fail "output.report is not in resolved.yaml"

# Pictures for papers: the place of first rupture is marked in all three views, at any time and in any field.
"$capsella" run "$quick" --quiet -o torn --set flow.capillary_number=2 --set membrane.damage.parameters.Y_C=0.4 \
  --set capsule.mesh.subdivisions=1
[ "$(number torn/summary.json status)" = ruptured ] || fail "the capsule is whole: $(number torn/summary.json status)"
# drawn FIELD VIEW: what the picture says
drawn() {
  for text in "$1" "$2, along the vorticity axis" "$2, along the velocity gradient" "at rest, along the vorticity axis"; do
    grep -q ">$text</text>" torn/capsule.svg || fail "the picture lacks '$text'"
  done
  [ "$(grep -c '>first rupture</text>' torn/capsule.svg)" = 3 ] || fail "the place of rupture is not marked in all views"
}
"$capsella" report torn >written.txt
drawn 'damage d' "t = $(number torn/summary.json t | awk '{ printf "%.4g", $1 }')"
[ "$(grep -c '<svg.* class="chart"' torn/curves.svg)" = 6 ] || fail "the curves are not six charts"
! grep -q 'nan\|inf' torn/capsule.svg torn/curves.svg || fail "a picture with numbers that are none"
"$capsella" report torn --color T1 --time 0.1
drawn 'larger tension T1 / G_s' 't = 0'

# refused PATTERN ARGUMENTS...
refused() {
  pattern=$1 code=0
  shift
  "$capsella" report "$@" 2>message || code=$?
  [ "$code" = 2 ] && grep -q "$pattern" message || fail "report $*: $code $(cat message)"
}
refused 'nowhere: expected the folder of a run or of a study; there is none' nowhere
refused 'it is a file' torn/summary.json
refused 'expected one of the fields .*T1.*, found `t`' torn --color t
refused '[-]-time needs a number' torn --time soon
refused '[-]-time needs a number' torn --time ''
