#!/bin/sh
# Runs the scenes of cases.txt and holds their summaries against published and independent values.
#   validate.sh CAPSELLA FOLDER quick|full
# Prints one line per value; fails when one is off by more than its tolerance.
set -eu
capsella=$1 folder=$2 which=$3
here=$(cd "$(dirname "$0")" && pwd)
scene="$here/../../configs/shear_reference.yaml"
rm -rf "$folder"
mkdir -p "$folder"

while read -r kind name options; do
  case $kind in
  quick) ;;
  full) [ "$which" = full ] || continue ;;
  *) continue ;;
  esac
  # shellcheck disable=SC2086
  "$capsella" run "$scene" --quiet -o "$folder/$name" $(printf ' --set %s' $options)
done <"$here/cases.txt"

awk -v folder="$folder" '
  function value(name, key,   file, line, found, parts) {
    file = folder "/" name "/summary.json"
    found = "missing"
    while ((getline line < file) > 0)
      if (line ~ "^ *\"" key "\":") {
        sub(/^[^:]*: */, "", line)
        gsub(/[",]/, "", line)
        found = line
      }
    close(file)
    return found
  }
  $1 == "value" {
    name = $2; key = $3; expected = $4; tolerance = $5
    if ((getline line < (folder "/" name "/summary.json")) <= 0) next # not among the cases run
    close(folder "/" name "/summary.json")
    found = value(name, key)
    if (tolerance == "is") good = (found == expected)
    else good = (found != "missing" && found != "null" && found - expected <= tolerance && expected - found <= tolerance)
    printf "%s %-16s %-24s %-22s expected %s +- %s\n", good ? "ok    " : "FAILED", name, key, found, expected, tolerance
    values++
    if (!good) failures++
  }
  END {
    printf "%d values, %d off\n", values, failures
    exit failures > 0 || values == 0
  }' "$here/cases.txt"
