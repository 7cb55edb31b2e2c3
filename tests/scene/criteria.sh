#!/bin/sh
# Criteria that look on change nothing, and the law of the membrane itself says what the membrane does.
. "$(dirname "$0")/common.sh"

set -- "$capsella" run "$root/configs/shear_quick.yaml" --quiet --set capsule.mesh.subdivisions=1 \
  --set flow.capillary_number=2 --set time.end=4
law='parameters: {Y_D: 0.2, Y_C: 2.0}'
"$@" -o alone
"$@" -o watched --set "observe.criteria=[{name: same, law: marigo, $law}, {law: thinning, parameters: {eta_D: 0.2, eta_C: 0.2}}]"
same alone/history.csv watched/history.csv "history with criteria that look on"
[ -e alone/criteria.csv ] && fail "a table of criteria where none is asked for"
[ "$(wc -l <watched/criteria.csv)" = 3 ] || fail "rows: $(cat watched/criteria.csv)"

# The membrane ruptures and the run stops there: events are found to 1e-6 of a step, a step is below 0.1.
cell() {
  grep '^same,marigo,ruptured,' watched/criteria.csv | cut -d, -f"$1"
}
near() {
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a - b < 1e-6 && b - a < 1e-6) }' || fail "$3: $1, $2"
}
near "$(number watched/summary.json t_c)" "$(cell 4)" t_c
near "$(number watched/summary.json t_l)" "$(cell 5)" t_l

# The last row is of that instant, and all that is lost until then is damage: no step goes on beyond it.
[ "$(number alone/summary.json status)" = ruptured ] || fail "status: $(number alone/summary.json status)"
last() { tail -n 1 alone/history.csv | cut -d, -f"$1"; }
[ "$(last 1)" = "$(number alone/summary.json t_l)" ] || fail "the last row is of t = $(last 1)"
awk -v e="$(last 17)" 'BEGIN { exit !(e != "" && e * e < 1e-3 * 1e-3) }' || fail "energy error at rupture: $(last 17)"
