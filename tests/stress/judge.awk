# One case: how it ended, how far it is from the finer computation, and whether that may be.  Prints
#   ID | GROUP | good or BAD | outcome | difference of D12 | of d_max | of t_l | energy | volume | why | settings | D12 | d_max
function trim(text) { gsub(/^ +| +$/, "", text); return text }
function number(text) { return text == "" || text == "null" ? "" : text + 0 }
function apart(x, y) { return x > y ? x - y : y - x }

# What the program said, on one line, and its exit code.
function heard(name,   line) {
  said[name] = ""
  while ((getline line < (name ".said")) > 0) said[name] = said[name] (said[name] == "" ? "" : " ") line
  getline code[name] < (name ".code")
  close(name ".said"); close(name ".code")
}

# Top-level keys of the summary; nothing when there is none.
function read_summary(name,   line, key) {
  while ((getline line < (name "/summary.json")) > 0)
    if (match(line, /^  "[A-Za-z0-9_]+": /)) {
      key = substr(line, 4, RLENGTH - 6)
      sub(/^[^:]*: */, "", line); gsub(/[",]/, "", line)
      value[name, key] = line
    }
  close(name "/summary.json")
}

# Rows of the history hold numbers; only the angle beta has no value where the capsule is round.
function is_finite(name,   line, n, cell, i, head) {
  if ((getline line < (name "/history.csv")) <= 0) return 1
  split(line, head, ",")
  while ((getline line < (name "/history.csv")) > 0) {
    n = split(line, cell, ",")
    for (i = 1; i <= n; i++) if (cell[i] ~ /nan|inf/ && head[i] != "beta") { close(name "/history.csv"); return 0 }
  }
  close(name "/history.csv")
  return 1
}

function cause(text) {
  if (text ~ /is inverted/) return "inverted"
  if (text ~ /has collapsed/) return "collapsed"
  if (text ~ /the membrane (touches|crosses) itself/) return "contact"
  if (text ~ /stability limit/) return "unstable step"
  if (text ~ /times the tolerance/) return "error of the step"
  if (text ~ /law [a-z_]+: /) return "law"
  if (text ~ /conjugate gradients/) return "mass solver"
  return ""
}

# How a run ended: end, ruptured, stopped (with its cause), refused; or what must not be.
function outcome_of(name) {
  if (code[name] == 124 || code[name] == 137 || code[name] == 152) return "HANG" # out of time, or of processor time
  if (code[name] > 2) return "CRASH"
  if (code[name] == 2) return "refused"
  if (code[name] == 1) {
    if (value[name, "status"] != "failed") return "NO SUMMARY"
    return cause(said[name]) != "" ? "stopped: " cause(said[name]) : "NO CAUSE"
  }
  return value[name, "status"]
}

function blame(text) { if (why == "") why = text }

# Of two computed numbers: their difference, held against the bound unless that is `-`.
function compare(key, bound,   x, y) {
  x = number(value[a, key]); y = number(value[b, key])
  if (x == "" || y == "") return ""
  if (bound != "-" && apart(x, y) > bound + 0) blame(key " " x " for " y)
  return apart(x, y)
}

BEGIN {
  group = trim(group); expected = trim(expected); sets = trim(sets)
  split(trim(bounds), bound, " ")
  heard(a); read_summary(a)
  outcome = outcome_of(a)
  if (outcome ~ /^[A-Z]/) blame(said[a])
  if (!is_finite(a)) blame("not finite")
  if (number(value[a, "volume_error_max"]) != "" && value[a, "volume_error_max"] + 0 > 1e-9) blame("volume")
  if (number(value[a, "d_max"]) != "" && value[a, "d_max"] + 0 > 1) blame("d beyond 1")
  done = outcome == "end" || outcome == "ruptured"

  if (expected ~ /^refused/) {
    if (outcome != "refused" || index(said[a], substr(expected, 9)) == 0) blame("not refused: " said[a])
  } else if (expected ~ /^said/) {
    found = 0
    while ((getline line < (a "/log.txt")) > 0) if (index(line, substr(expected, 6))) found = 1
    if (!found) blame("not said: " substr(expected, 6))
  } else {
    if (expected == "right" && !done) blame(outcome " " said[a])
    if (outcome == "refused") blame(said[a])
    if (done && bound[4] != "-" && value[a, "energy_error_max"] + 0 > bound[4] + 0) blame("energy")
    heard(b); read_summary(b)
    finer = outcome_of(b)
    if (finer ~ /^[A-Z]/) blame("finer: " said[b])
    if (done && (finer == "end" || finer == "ruptured")) {
      if (outcome == "ruptured" && finer == "ruptured") {
        dt = number(value[a, "t_l"]) == "" ? "" : apart(value[a, "t_l"], value[b, "t_l"]) / value[b, "t_l"]
        if (bound[3] != "-" && dt > bound[3] + 0) blame("t_l " value[a, "t_l"] " for " value[b, "t_l"])
      } else if (outcome == finer) {
        dD = compare("D12", bound[1])
        dd = compare("d_max", bound[2])
      } else {
        # One ruptures, the other has just not: by the last moment, or by a hair of damage.
        last = outcome == "ruptured" ? b : a
        if (value[last, "d_max"] + 0 < 0.97) blame("FALSE RUPTURE? " outcome " for " finer ", d_max " value[last, "d_max"])
      }
    }
  }
  printf "%s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s\n", id, group, why == "" ? "good" : "BAD", outcome,
    dD, dd, dt, number(value[a, "energy_error_max"]), number(value[a, "volume_error_max"]), why, sets,
    value[a, "D12"], value[a, "d_max"]
}
