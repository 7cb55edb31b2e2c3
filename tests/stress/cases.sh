#!/bin/sh
# Prints the cases of the stress matrix, one a line:  cases.sh quick|full
# A `~` in a value stands for a space.
#   GROUP | EXPECTED | BOUNDS | KEY=VALUE... | KEY=VALUE... of the computation it is compared with
# EXPECTED: `right`: ends or ruptures; `sound`: that, or stops with a named cause; `refused TEXT`: exit code 2 and a
# message with TEXT; `said TEXT`: runs, and the log has TEXT.
# BOUNDS: allowed difference of D12, of d_max, of t_l/t_l, and of the energy balance; `-`: not compared.
set -eu
which=$1

# The rule of the bounds.  The step control holds the error of a step (root mean square over the nodes, in units of a)
# below the tolerance; some tens of steps fall into the time over which a capsule forgets, so shape follows to 30
# tolerances (3e-3 at the standard 1e-4).  Damage has a slope of 3 and more over deformation, and softening adds to it:
# 100 tolerances (1e-2).  Up to rupture it grows by 5 sqrt(tolerance) a step, and errs by the square of that: t_l is
# right to 100 tolerances (1 %).  The energy balance leaves over at most 10 tolerances (1e-3).
usual="3e-3 1e-2 0.01 1e-3"
finer="time.tolerance=1e-5"

line() { printf '%s | %s | %s | %s | %s\n' "$1" "$2" "$3" "$4" "$5"; }
damage() { # LAW NAME=VALUE...
  printf 'membrane.damage.law=%s' "$1"
  shift
  for parameter; do printf ' membrane.damage.parameters.%s' "$parameter"; done
}
mesh() { printf 'capsule.mesh.subdivisions=%s' "$1"; }

elastic_laws="evans_skalak fung gent hooke mooney_rivlin neo_hookean skalak st_venant_kirchhoff yeoh"
associated="marigo:Y_D=0.2:Y_C=2 power:Y_D=0.2:Y_C=2:m=2 exponential:Y_D=0.2:Y_C=1
  fibre_bundle:Y_D=0.2:Y_C=2 fibre_log_normal:Y_50=0.8:s=0.4 fibre_weibull:Y_0=0.8:m=3
  fibre_quartiles:Y_0=0.1:Y_25=0.4:Y_50=0.7:Y_75=1:Y_100=1.6"
others="rankine:T_D=0.5:T_C=2 max_stretch:L_D=1.2:L_C=0.8 max_shear:S_D=0.3:S_C=1 area_dilation:alpha_D=0.1:alpha_C=0.5
  thinning:eta_D=0.1:eta_C=0.5 creep:T_R=1:tau=2 delay:Y_D=0.2:Y_C=1:tau_c=0.5 fatigue:T_E=0.2:T_F=3"

elastic() { # law and capillary number; large deformation on coarse meshes may end in a folded element
  for law in $elastic_laws; do for Ca in 0.001 0.01 0.03 0.1 0.3 0.6 1 3 10; do
    line elastic sound "$usual" "membrane.law=$law flow.capillary_number=$Ca" "$finer"
  done; done
}

quartic() { # the same with tensions from four elements
  common=membrane.interpolation=quartic
  for law in $elastic_laws; do for Ca in 0.01 0.1 0.3 1 3 10; do
    line quartic sound "$usual" "$common membrane.law=$law flow.capillary_number=$Ca" "$finer"
  done; done
  for spec in marigo:Y_D=0.2:Y_C=2 rankine:T_D=0.5:T_C=2 creep:T_R=1:tau=2; do for Ca in 0.4 0.8 1.5; do for n in 1 2; do
    # shellcheck disable=SC2046
    line quartic sound "$usual" "$common $(damage $(echo "$spec" | tr : ' ')) flow.capillary_number=$Ca $(mesh $n) time.end=3" "$finer"
  done; done; done
  line quartic right "3e-3 - - 1e-3" "$common flow.capillary_number=0.6 $(mesh 2) time.end=200" "time.tolerance=3e-5"
}

damaging() {
  for spec in $associated $others; do for law in neo_hookean skalak; do for Ca in 0.2 0.4 0.6 0.8 1.5; do for n in 1 2; do
    case $n$law in 2skalak) continue ;; esac
    # shellcheck disable=SC2046
    line damage sound "$usual" \
      "membrane.law=$law $(damage $(echo "$spec" | tr : ' ')) flow.capillary_number=$Ca $(mesh $n) time.end=3" "$finer"
  done; done; done; done
}

tolerances() { # the bounds go with the tolerance
  for integrator in rk2 rkc2 rkc3; do for tolerance in 1e-2 1e-3 1e-4 1e-5 1e-6; do for Ca in 0.03 0.1 0.3 0.7 1.2; do
    case $tolerance in 1e-6) against=2e-7 ;; *) against=1e-6 ;; esac
    bounds=$(awk -v tol=$tolerance 'BEGIN { print 30 * tol + 1e-7, 100 * tol + 1e-6, 100 * tol, 10 * tol + 1e-6 }')
    line tolerance sound "$bounds" \
      "time.integrator=$integrator time.tolerance=$tolerance $(damage marigo Y_D=0.2 Y_C=2) flow.capillary_number=$Ca" \
      "time.integrator=rkc3 time.tolerance=$against"
  done; done; done
}

# steps CA SUBDIVISIONS LIMIT: LIMIT is that of rk2, 2 over the spectral radius, as the program tells it.
steps() {
  for factor in 0.1 0.2 0.5 0.8 0.95 1.05 1.5 2 3; do
    step=$(awk -v f=$factor -v l="$3" 'BEGIN { printf "%.6g", f * l }')
    set_step="time.integrator=rk2 time.step=$step flow.capillary_number=$1 $(mesh "$2") time.end=1"
    case $factor in # the radius grows as the capsule stretches: a step near the limit is stopped on the way
    0.*)
      case $factor in 0.[89]*) expected=sound ;; *) expected=right ;; esac
      line step $expected "3e-3 1e-2 0.02 -" "$set_step" "time.tolerance=1e-6 time.integrator=rkc2 time.step=auto"
      ;;
    *)
      line step "refused stability limit" "- - - -" "$set_step" ""
      line unstable "said were beyond the stability limit" "- - - -" "$set_step time.allow_unstable=true" ""
      ;;
    esac
  done
}

fixed_rkc2() { # stable at any length: what is too coarse must be told
  for Ca in 0.1 0.7; do for step in 0.01 0.03 0.1 0.3 1; do
    bounds="- - - -"
    case $step in
    0.01) expected=right bounds="3e-3 1e-2 0.02 -" ;;
    1) expected="said times time.tolerance" ;;
    *) expected=sound ;;
    esac
    line step "$expected" "$bounds" "time.step=$step flow.capillary_number=$Ca time.end=2" "time.tolerance=1e-6 time.step=auto"
  done; done
}

brittle() { # damage runs from 0 to 1 at once, or nearly so
  for flow in simple_shear planar_hyperbolic; do for Y_D in 0.1 0.3; do for Y_C in 1 0.1 0.01 1e-4 1e-8 0; do for Ca in 0.3 0.8; do for n in 1 2; do
    line brittle sound "- - 0.01 1e-3" \
      "flow.kind=$flow $(damage marigo Y_D=$Y_D Y_C=$Y_C) flow.capillary_number=$Ca $(mesh $n)" "$finer"
  done; done; done; done; done
  # An imposed radius: events are located to 1e-6 of a step, whatever the step.
  for Y_D in 0.05 0.1 0.2 0.3; do for Y_C in 1 0.1 0.01 1e-4 1e-8 0; do
    line brittle right "- 1e-9 1e-6 1e-3" "flow.kind=inflation flow.capillary_number= flow.path=[[0,0],[2,1]] $(damage marigo Y_D=$Y_D Y_C=$Y_C)" \
      "output.history_every=0.03 $(mesh 2)"
  done; done
}

# The two ends of the capsule may be ten times as far apart as at rest.
drawn_out() {
  for law in marigo:Y_D=0.2:Y_C=1 power:Y_D=0.2:Y_C=2:m=2; do for Ca in 0.3 0.8; do for n in 1 2; do
    # shellcheck disable=SC2046
    line capped sound "- - 0.01 1e-3" \
      "flow.kind=planar_hyperbolic $(damage $(echo "$law" | tr : ' ')) flow.capillary_number=$Ca $(mesh $n) stop.rupture=continue time.end=3" "$finer"
  done; done; done
}

capped() { # below 1 the membrane never ruptures; past rupture and at d near 1 the mesh may fold
  for d_max in 0.9 0.99 0.999 1; do for Ca in 0.8 1.5 3; do for n in 1 2; do for stop in stop continue; do
    line capped sound "- - 0.01 1e-3" \
      "$(damage marigo Y_D=0.2 Y_C=1) membrane.damage.d_max=$d_max flow.capillary_number=$Ca $(mesh $n) stop.rupture=$stop time.end=3.5" "$finer"
  done; done; done; done
}

extension() { # above the critical capillary number a capsule is drawn out without end
  for flow in planar_hyperbolic uniaxial_extension; do for law in neo_hookean skalak hooke gent yeoh; do for Ca in 0.05 0.2 0.5 1 3; do
    line extension sound "$usual" "flow.kind=$flow membrane.law=$law flow.capillary_number=$Ca time.end=3" "$finer"
  done; done; done
}

# numbers COUNT SEED: pseudo-random numbers in [-1, 1), the same every time
numbers() {
  awk -v n="$1" -v s="$2" 'BEGIN {
    for (i = -9; i <= n; i++) { s = (s * 16807 + 11) % 2147483647; if (i > 0) printf "%.5f ", s / 1073741823.5 - 1 }
  }'
}

# A mesh turned at random against the one that is not.  Without bending stiffness nothing but the mesh holds a membrane
# that is compressed: wrinkles of the size of the elements grow from the error of the mesh, faster on finer ones, and
# shapes agree as far as wrinkles matter to them.  Early, and where an inflated start keeps all of the membrane tense,
# they agree to 1e-6.
rotated() { # SUBDIVISIONS COUNT END [AXIS]
  case ${4:-}$3 in 0.3 | ?*1) bound=1e-6 ;; *) bound=1e-3 ;; esac
  case ${4:-} in '') start="flow.capillary_number=0.5" ;; *) start="flow.capillary_number=0.3 start.axes=[$4,$4,$4]" ;; esac
  for turn in $(seq "$2"); do
    # shellcheck disable=SC2046
    line rotated right "$bound - - 1e-3" "$start $(mesh "$1") time.end=$3 $(
      printf 'capsule.mesh.rotation.axis=[%s,%s,%s] capsule.mesh.rotation.angle=%s' $(numbers 4 "$1$turn"))" \
      "capsule.mesh.rotation.angle=0"
  done
}

# The same, of a capsule that has become steady, whose wrinkles on the way there are gone.
turned() { # COUNT SETTINGS
  for turn in $(seq "$1"); do
    # shellcheck disable=SC2046
    line turned right "1e-4 - - 1e-3" "$2 $(mesh 3) $(
      printf 'capsule.mesh.rotation.axis=[%s,%s,%s] capsule.mesh.rotation.angle=%s' $(numbers 4 "7$turn"))" \
      "capsule.mesh.rotation.angle=0"
  done
}

# An irregular mesh against the regular one: apart by the error of the mesh, 2e-3 of D12 on 80 elements (against 320),
# which falls as the third power of the size of the elements.
jittered() { # SUBDIVISIONS COUNT
  case $1 in 1) bound=4e-3 ;; 2) bound=1e-3 ;; esac
  for seed in $(seq "$2"); do for jitter in 0.05 0.15 0.3; do
    line jittered right "$bound - - 1e-3" \
      "flow.capillary_number=0.5 $(mesh "$1") capsule.mesh.jitter=$jitter capsule.mesh.seed=$seed" capsule.mesh.jitter=0
  done; done
}

noisy() { # shapes agree as far as the noise and the wrinkles that grow from it matter to them
  for amplitude in 1e-12 1e-10 1e-8 1e-6 1e-5 1e-4 1e-3; do for Ca in 0.1 0.3 0.6 1; do for n in 1 2; do
    line noise right "1e-3 - - 1e-3" "flow.capillary_number=$Ca $(mesh $n) start.noise=$amplitude" start.noise=0
  done; done
  line noise right "1e-3 1e-2 0.01 1e-3" "flow.capillary_number=0.7 $(damage marigo Y_D=0.2 Y_C=2) start.noise=$amplitude" start.noise=0
  done
}

changing() { # flows that oscillate, come up, stop, turn round and beat
  for Ca in 0.1 0.5 1.5; do
    for period in 0.1 1 2 5 20; do for flow in simple_shear planar_hyperbolic; do
      line changing sound "$usual" "flow.kind=$flow flow.capillary_number=$Ca flow.period=$period time.end=3" "$finer"
    done; done
    for strength in [[0,0],[2,1]] [[0,1],[1,1],[1.01,0]] [[0,1],[1,1],[1.01,-1]] [[0,1],[0.5,0],[1,1],[1.5,0],[2,1]] \
      [[0,1],[1,1],[1.0001,3],[1.5,3],[1.5001,0]]; do for flow in simple_shear uniaxial_extension; do
      line changing sound "$usual" "flow.kind=$flow flow.capillary_number=$Ca flow.strength=$strength time.end=3" "$finer"
    done; done
    line changing sound "$usual" "flow.capillary_number=$Ca flow.period=2 $(damage marigo Y_D=0.1 Y_C=1) time.end=3" "$finer"
    line changing sound "$usual" "flow.capillary_number=$Ca flow.strength=[[0,2],[1,2],[1.01,0]] $(damage marigo Y_D=0.1 Y_C=1) time.end=3" "$finer"
  done
}

# Starts: inflated, and ellipsoids, whose membrane is at rest as the sphere.  Deflated ones are compressed all over:
# they wrinkle at once and each run in its own way.
starting() {
  for axes in 1.05,1.05,1.05 1.3,1.3,1.3 2,2,2 2,1,0.5 1,2,0.5 1.5,1.5,0.45 0.9,0.9,0.9 0.7,0.7,0.7 0.5,0.5,0.5 1,1,0.2; do
    case $axes in 0.* | 1,1,*) bounds="- - - 1e-3" ;; *) bounds=$usual ;; esac
    for strength in 0 1; do for n in 1 2; do
      [ "$strength$n" != 02 ] || continue
      line start sound "$bounds" "start.axes=[$axes] flow.strength=[[0,$strength]] flow.capillary_number=0.3 $(mesh $n)" "$finer"
    done; done
    line start sound "- - 0.01 1e-3" "start.axes=[$axes] flow.capillary_number=0.5 $(damage marigo Y_D=0.2 Y_C=2)" "$finer"
  done
}

# Discs and rods of the volume of the sphere, whose elements are up to a^3 = 51 times as long as wide.
slender() {
  for a in 1.5 2 2.5 3 3.7; do for shape in disc rod; do for n in 1 2; do
    axes=$(awk -v a=$a -v shape=$shape 'BEGIN {
      if (shape == "disc") printf "%.6g,%.6g,%.6g", a, a, 1 / (a * a); else printf "%.6g,%.6g,%.6g", a * a, 1 / a, 1 / a }')
    line slender sound "1e-2 - - 1e-3" "start.axes=[$axes] flow.capillary_number=0.3 $(mesh $n) time.end=1" "$finer"
  done; done; done
}

gradients() { # any linear flow: the last number makes the trace 0
  for flow in $(seq "$1"); do
    gradient=$(numbers 8 "$flow" | awk '{ printf "[[%s,%s,%s],[%s,%s,%s],[%s,%s,%.5f]]", $1, $2, $3, $4, $5, $6, $7, $8, -$1 - $5 }')
    line linear sound "$usual" "flow.kind=linear flow.gradient=$gradient flow.capillary_number=0.3" "$finer"
  done
}

inflations() { # exact in space on every mesh but for round-off and the flux of the polyhedron
  for law in $elastic_laws; do for spec in $associated $others; do
    # shellcheck disable=SC2046
    line inflation sound "- 2e-2 0.02 1e-3" \
      "flow.kind=inflation flow.capillary_number= flow.path=[[0,0],[0.5,0.3],[1,0.1],[2,0.8]] membrane.law=$law $(damage $(echo "$spec" | tr : ' ')) $(mesh 0) output.history_every=0.02" \
      "output.history_every=0.005"
  done; done
}

equivalent() { # what changes the work must not change the result
  for Ca in 0.1 0.5 1; do
    common="$(damage marigo Y_D=0.2 Y_C=2) flow.capillary_number=$Ca $(mesh 2)"
    line equivalent sound "1e-6 1e-5 1e-4 1e-3" "$common" membrane.mass_solver=umfpack
    line equivalent sound "1e-6 1e-5 1e-4 1e-3" "$common" symmetry=off
    line equivalent sound "$usual" "$common" fluid.coarse_stages=false
    line equivalent sound "$usual" "$common" fluid.method=reference
    line equivalent sound "$usual" "$common" time.integrator=rk2
  done
}

scattered() { # strengths that differ from element to element
  for seed in $(seq "$1"); do
    line scatter sound "- - 0.03 1e-3" \
      "membrane.damage.law=marigo membrane.damage.parameters.Y_D=0.2 membrane.damage.parameters.Y_C={weibull:~{mean:~1,~modulus:~$((seed % 7 + 2))},~seed:~$seed} flow.capillary_number=0.8 time.end=3" "$finer"
  done
}

long() {
  for Ca in 0.3 0.6; do
    line long right "3e-3 - - 1e-3" "flow.capillary_number=$Ca $(mesh 2) time.end=200" "time.tolerance=3e-5"
    line long right "3e-3 1e-2 - 1e-3" "flow.capillary_number=$Ca $(damage marigo Y_D=0.2 Y_C=2) time.end=200" "time.tolerance=3e-5"
  done
}

large() { # finer meshes
  for Ca in 0.3 0.7 1; do
    line large right "$usual" "flow.capillary_number=$Ca $(damage marigo Y_D=0.2 Y_C=2) $(mesh 3)" "$finer"
  done
  line large right "$usual" "flow.capillary_number=0.7 $(mesh 4) time.end=1" "time.tolerance=3e-4"
}

# The limits of rk2 at rest come from the program: cases.sh is called with them in the environment as "CA:N:LIMIT ...".
{
  long
  large
  rotated 3 20 1
  rotated 3 20 1 1.1
  rotated 3 5 0.3
  rotated 1 20 2
  rotated 2 10 2
  turned 20 "flow.capillary_number=0.6 time.end=8"
  turned 20 "flow.capillary_number=0.7 $(damage marigo Y_D=0.2 Y_C=2) time.end=10"
  brittle
  capped
  drawn_out
  jittered 1 10
  jittered 2 5
  noisy
  changing
  starting
  slender
  damaging
  tolerances
  for entry in $LIMITS; do
    # shellcheck disable=SC2046
    steps $(echo "$entry" | tr : ' ')
  done
  fixed_rkc2
  elastic
  quartic
  extension
  gradients 40
  inflations
  equivalent
  scattered 20
} | if [ "$which" = quick ]; then awk '/subdivisions=[34]|end=200/ { next } NR % 25 == 7'; else cat; fi
