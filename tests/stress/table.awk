# The table of outcomes from verdicts; fails when a case is bad.
function largest(array, key, x) { if (x != "" && (!(key in array) || x + 0 > array[key])) array[key] = x + 0 }
{
  if (!($2 in cases)) order[++groups] = $2
  cases[$2]++
  kind = $4 ~ /^stopped/ ? "stopped" : $4
  count[$2, kind]++
  if ($3 == "BAD") { bad[$2]++; all_bad++; print "BAD: case " $1 " (" $2 ", " $4 "): " $10 "  [" $11 "]" }
  else {
    largest(D12, $2, $5); largest(d, $2, $6); largest(t, $2, $7); 
  }
  largest(volume, $2, $9); largest(energy, $2, $8)
}
function figure(array, key) { return key in array ? sprintf("%.1e", array[key]) : "-" }
END {
  printf "%-11s %6s %6s %9s %8s %8s %4s  %8s %8s %8s %8s %8s\n", "group", "cases", "end", "ruptured", "stopped", "refused",
    "bad", "D12", "d_max", "t_l", "energy", "volume"
  for (i = 1; i <= groups; i++) {
    g = order[i]
    printf "%-11s %6d %6d %9d %8d %8d %4d  %8s %8s %8s %8s %8s\n", g, cases[g], count[g, "end"], count[g, "ruptured"],
      count[g, "stopped"], count[g, "refused"], bad[g], figure(D12, g), figure(d, g), figure(t, g), figure(energy, g),
      figure(volume, g)
  }
  printf "%d cases, %d bad\n", NR, all_bad
  exit all_bad > 0 || NR == 0
}
