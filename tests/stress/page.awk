# docs/stability.md from verdicts:  awk -F' \\| ' -v version=... -f page.awk VERDICTS
function setting(key, missing,   n, part, i) { # of this case; later ones win
  n = split($11, part, " ")
  for (i = n; i > 0; i--) if (index(part[i], key "=") == 1) return substr(part[i], length(key) + 2)
  return missing
}
function largest(array, key, x) { if (x != "" && (!(key in array) || x + 0 > array[key])) array[key] = x + 0 }
function figure(array, key) { return key in array ? sprintf("%.1e", array[key]) : "" }
# Largest difference of D12 of the cases with a name, in the order in which names come.
function spread(name) { largest(D12, name, $5); if (!spreads[name]++) named[++n_named] = name }
# From the smallest to the largest value of the cases with a name.
function range(name, x) {
  if (!(name in most) || x > most[name]) most[name] = x
  if (!(name in fewest) || x < fewest[name]) fewest[name] = x
}

{
  g = $2
  if (!(g in cases)) group[++groups] = g
  cases[g]++
  kind = $4 ~ /^stopped/ ? "stopped" : $4
  count[g, kind]++
  if ($4 ~ /^stopped/) { c = substr($4, 10); if (!(c in causes)) cause[++n_causes] = c; causes[c]++; by_cause[g, c]++ }
  if ($3 == "BAD") bad++
  largest(D12, g, $5); largest(d, g, $6); largest(t, g, $7); largest(energy, g, $8); largest(volume, g, $9)
  if (g !~ /tolerance|step|unstable/) largest(energy, "standard", $8)
  if ($5 != "" || $7 != "") compared++
  total[kind]++

  if (g == "tolerance") {
    k = setting("time.integrator") " " setting("time.tolerance")
    if (!(k in seen)) tolerance[++n_tolerances] = k
    seen[k] = 1
    largest(D12, k, $5); largest(d, k, $6); largest(energy, k, $8); largest(t, k, $7)
  }
  if (g == "rotated") spread("turned " setting("capsule.mesh.subdivisions", 1) " " setting("time.end") " " setting("start.axes", "no"))
  if (g == "turned") {
    k = "steady " setting("flow.capillary_number") " " setting("time.end") " " (setting("membrane.damage.law") == "" ? "no" : "yes")
    spread(k); range(k, $12 + 0); range(k " d_max", $13 + 0)
  }
  if (g == "jittered") spread("jittered " setting("capsule.mesh.subdivisions", 1) " " setting("capsule.mesh.jitter"))
  if (g == "noise") spread("noise " setting("start.noise"))
  if (g == "long") long[++n_long] = "| " setting("flow.capillary_number") " | " (setting("membrane.damage.law") == "" ? "no" : "yes") \
    " | " sprintf("%.1e | %.1e | %.1e", $5, $8, $9) " |"
  if ((g == "step" || g == "unstable") && setting("time.integrator") == "rk2") {
    k = setting("flow.capillary_number") " " setting("capsule.mesh.subdivisions", 1)
    step[++n_steps] = setting("time.step"); place[n_steps] = k; how[n_steps] = g == "unstable" ? "allowed: " $4 : $4
    if (g == "step" && $4 == "refused" && (!(k in least) || step[n_steps] + 0 < least[k])) least[k] = step[n_steps] + 0
  }
}

END {
  print "# Stability\n"
  print "Written by `cmake --build build/release --target stress` (" version "): " NR " cases, each held against a finer"
  print "computation where it can be, and against what must always hold: a volume that stays within 1e-9, damage of at"
  print "most 1, numbers that are finite, an end within the time limit.\n"
  printf "**%d cases: %d ended, %d ruptured, %d stopped with a named cause, %d were refused; %d wrong.**\n", NR,
    total["end"], total["ruptured"], total["stopped"], total["refused"], bad
  print compared " were compared with a finer computation, whether they rupture included: no false rupture, crash, hang or value"
  print "that is not finite.  `tests/stress/cases.sh` states the cases and the bounds, `judge.awk` the rules."
  print "At the standard tolerance the energy balance leaves over at most " figure(energy, "standard") " of the largest energy so far"
  print "([what it sees](decisions/energy.md), and what it does not).\n"
  print "## Outcomes\n"
  print "Largest differences from the finer computation; energy: largest residual of the balance, relative to the largest energy.\n"
  print "| group | cases | end | ruptured | stopped | refused | D12 | d_max | t_l, relative | energy | volume |"
  print "|---|---|---|---|---|---|---|---|---|---|---|"
  for (i = 1; i <= groups; i++) {
    g = group[i]
    printf "| %s | %d | %d | %d | %d | %d | %s | %s | %s | %s | %s |\n", g, cases[g], count[g, "end"], count[g, "ruptured"],
      count[g, "stopped"], count[g, "refused"], figure(D12, g), figure(d, g), figure(t, g), figure(energy, g), figure(volume, g)
  }
  print "\n| group | what is varied |\n|---|---|"
  print "| elastic | nine laws, Ca from 1e-3 to 10 |"
  print "| quartic | the nine laws and three damage laws with quartic interpolation; one to t = 200 |"
  print "| damage | fifteen laws on two membranes, Ca from 0.2 to 1.5 |"
  print "| tolerance | 1e-2 to 1e-6, all integrators |"
  print "| jittered | irregular meshes, against the regular one |"
  print "| noise | noise of 1e-12 to 1e-3 at the start, against none |"
  print "| changing | flows that oscillate, come up, stop, turn round and beat |"
  print "| start | inflated, deflated and ellipsoidal starts, with flow and without |"
  print "| slender | discs and rods at the start, with elements up to 51 times as long as wide |"
  print "| step, unstable | fixed steps of 0.1 to 3 times the limit; `unstable` with `time.allow_unstable` |"
  print "| brittle | marigo with Y_C from 1 to 0, in shear, planar flow and inflation |"
  print "| capped | d_max from 0.9 to 1, Ca from 0.8 to 3; past rupture, drawn out in planar flow to 15 times the length at rest |"
  print "| extension | planar and uniaxial, up to far above the critical Ca |"
  print "| rotated | meshes turned at random, against the one that is not |"
  print "| turned | the same, on 1280 elements, of capsules that have become steady |"
  print "| linear | random linear flows |"
  print "| inflation | every elastic law with every damage law, inflated, deflated and inflated again |"
  print "| equivalent | other solvers, quadratures, symmetry off: the same result |"
  print "| scatter | strength that differs from element to element |"
  print "| long | to t = 200 |"
  print "| large | 1280 and 5120 elements |"

  print "\n## Why runs stop\n\n| cause | cases | groups |\n|---|---|---|"
  for (i = 1; i <= n_causes; i++) {
    printf "| %s | %d |", cause[i], causes[cause[i]]
    for (j = 1; j <= groups; j++) if (by_cause[group[j], cause[i]]) printf " %s", group[j]
    print " |"
  }
  print "\nAn element that is inverted or has collapsed is where a coarse mesh ends: the capsule is drawn out, softened to"
  print "nearly nothing or wrinkled below what 80 or 320 elements can show.  The last good state is on disk."

  print "\n## Tolerance\n\n| integrator, tolerance | D12 | d_max | t_l, relative | energy |\n|---|---|---|---|---|"
  for (i = 1; i <= n_tolerances; i++) {
    k = tolerance[i]
    printf "| %s | %s | %s | %s | %s |\n", k, figure(D12, k), figure(d, k), figure(t, k), figure(energy, k)
  }

  print "\n## Fixed steps of rk2 against the limit 2 / (spectral radius)\n"
  print "The limit is that of the capsule at rest.  The radius grows as the capsule stretches: a step just below the limit"
  print "is stopped when it comes to be beyond it.  Beyond, a step is refused unless `time.allow_unstable` lets it pass;"
  print "log, terminal and `unstable_steps` in the summary then say so.\n"
  for (i = 1; i <= n_steps; i++) {
    if (!least[place[i]]) continue
    x = step[i] / least[place[i]] * 1.05
    key = x < 0.15 ? "0.1" : x < 0.3 ? "0.2" : x < 0.65 ? "0.5" : x < 0.88 ? "0.8" : x < 1 ? "0.95" : x < 1.2 ? "1.05" : x < 1.75 ? "1.5" : x < 2.5 ? "2" : "3"
    tally[key " | " how[i]]++
  }
  print "| step / limit | outcome | cases |\n|---|---|---|"
  split("0.1 0.2 0.5 0.8 0.95 1.05 1.5 2 3", keys, " ")
  for (i = 1; i <= 9; i++) {
    n = 0
    for (k in tally) if (index(k, keys[i] " | ") == 1) row[++n] = "| " k " | " tally[k] " |"
    for (a = 1; a <= n; a++) for (b = a + 1; b <= n; b++) if (row[b] < row[a]) { s = row[a]; row[a] = row[b]; row[b] = s }
    for (a = 1; a <= n; a++) print row[a]
  }

  print "\n## Turned and irregular meshes\n\nLargest difference of D12 from the mesh that is neither (Ca 0.5, inflated: 0.3)."
  print "Where the membrane is compressed, wrinkles of the size of the elements grow from the error of the mesh, since nothing"
  print "else holds them in a membrane without bending stiffness: the finer the mesh, the faster, whatever the time step and"
  print "the quadrature.  A capsule that starts inflated by 10 % is tense everywhere, and has none.\n"
  print "| elements | inflated by | t | meshes | D12 |\n|---|---|---|---|---|"
  for (i = 1; i <= n_named; i++) {
    split(named[i], part, " ")
    if (part[1] != "turned") continue
    percent = part[4] == "no" ? "0" : (substr(part[4], 2) - 1) * 100
    printf "| %d | %d %% | %s | %d | %s |\n", 20 * 4 ^ part[2], percent, part[3], spreads[named[i]], figure(D12, named[i])
  }
  print "\nOnce the capsule is steady the wrinkles of the way there are gone, and how the mesh lies does not matter to its shape;"
  print "damage, which keeps the worst that a point has seen, remembers them (1280 elements, meshes turned at random).\n"
  print "| Ca | damage | t | meshes | largest less smallest D12 | d_max |\n|---|---|---|---|---|---|"
  for (i = 1; i <= n_named; i++) {
    split(named[i], part, " ")
    k = named[i]
    if (part[1] != "steady") continue
    printf "| %s | %s | %s | %d | %.1e | %s |\n", part[2], part[4], part[3], spreads[k], most[k] - fewest[k],
      part[4] == "no" ? "" : sprintf("%.4f to %.4f", fewest[k " d_max"], most[k " d_max"])
  }
  print "\nCorners shifted at random by up to a share of the edge, t = 2: the error of the mesh, 1.5e-3 on 80 elements.\n"
  print "| elements | share | meshes | D12 |\n|---|---|---|---|"
  for (i = 1; i <= n_named; i++) {
    split(named[i], part, " ")
    if (part[1] == "jittered") printf "| %d | %s | %d | %s |\n", 20 * 4 ^ part[2], part[3], spreads[named[i]], figure(D12, named[i])
  }
  print "\n## Noise\n\nLargest difference of D12 at t = 2 from the capsule that starts without it, Ca from 0.1 to 1, 80 and 320 elements.\n"
  print "| noise | cases | D12 |\n|---|---|---|"
  for (i = 1; i <= n_named; i++) {
    split(named[i], part, " ")
    if (part[1] == "noise") printf "| %s | %d | %s |\n", part[2], spreads[named[i]], figure(D12, named[i])
  }

  print "\n## Limits\n"
  print "- Deflated starts are compressed all over and wrinkle at once: D12 is good to 1e-2 only, and at half the radius"
  print "  elements fold.  Discs 27 times as wide as thick fold on 80 elements, those 50 times as wide on 320."
  print "- Fixed steps of rkc2 are stable at any length; those whose error is far above `time.tolerance` are warned of."
  print "- Where two parts of the membrane come nearer to each other than half the width of an element, the flow between them is"
  print "  that of the mesh; the log says so, and `film_min` in the summary.  A membrane that touches or crosses itself ends the"
  print "  run ([contact](decisions/contact.md))."
  print "- Past rupture, and at d_max near 1, a softened element may fold: the run stops and says so."
  print "\n## To t = 200\n\n320 elements.\n\n| Ca | damage | D12 | energy | volume |\n|---|---|---|---|---|"
  for (i = 1; i <= n_long; i++) print long[i]
}
