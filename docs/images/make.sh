#!/bin/sh
# Draws the pictures of README.md anew, with rsvg-convert (librsvg2-bin) and Chromium:  docs/images/make.sh FOLDER
# FOLDER receives the results, of some minutes; a study that is there already goes on.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
cd "$1"

# page RESULTS NAME WIDTH HEIGHT THEME: the upper part of report.html
page() {
  chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
    --user-data-dir="$PWD/profile" --window-size="$3,$4" --virtual-time-budget=8000 \
    --screenshot="$root/docs/images/$2.png" "file://$PWD/$1/report.html#theme=$5" 2>/dev/null
}

"$root/run" "$root/configs/shear_reference.yaml" --quiet -o reference
"$root/run" "$root/configs/shear_reference.yaml" --quiet -o rupture --set flow.capillary_number=0.8
"$root/run" study "$root/configs/paper/fig16.yaml" --quiet --resume -o phases --set capsule.mesh.subdivisions=2
"$root/run" study "$root/configs/studies/compare_criteria.yaml" --quiet --resume -o criteria
for results in reference rupture; do
  "$root/run" report $results
  rsvg-convert "$results/capsule.svg" -o "$root/docs/images/shear_$results.png"
done
page reference page_reference 1280 1050 light
page rupture page_rupture 1280 1050 dark
page phases page_phases 1000 820 light
page criteria page_criteria 1280 1050 light
