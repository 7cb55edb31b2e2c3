#!/bin/sh
# docs/tutorial.md, followed to the letter: its runs end as it says, and its numbers are those that it states.
. "$(dirname "$0")/common.sh"

follow docs/tutorial.md 50 13
cd empty/results
# between VALUE LOW HIGH NAME
between() {
  awk -v x="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(x != "" && x >= low && x <= high) }' || fail "$4: $1"
}
between "$(number first/summary.json t_c)" 1.085 1.095 "begin of damage"
[ "$(number first/summary.json t_l)" = null ] || fail "the first run ruptures"
[ "$(number elastic/summary.json d_max)" = 0 ] || fail "damage of the elastic run: $(number elastic/summary.json d_max)"
for run in skalak tension; do
  between "$(number $run/summary.json d_max)" 0.001 0.999 "damage of $run"
done
between "$(sed -n 2p limit/table.csv | cut -d, -f1)" 0.365 0.385 Ca_c
between "$(sed -n 2p limit/table.csv | cut -d, -f7)" 0.74 0.77 Ca_l
for map in sites_reference sites_capsule; do
  grep -q '</svg>' criteria/$map.svg || fail "no $map.svg"
done
for page in first limit sweep criteria; do
  [ -s $page/report.html ] || fail "no page of $page"
done
