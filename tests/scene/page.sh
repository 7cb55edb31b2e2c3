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
