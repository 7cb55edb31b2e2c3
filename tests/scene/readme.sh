#!/bin/sh
# The commands of README.md, followed to the letter in a folder with the scenes, where ./run is the program under test.
. "$(dirname "$0")/common.sh"

mkdir empty
ln -s "$root/configs" empty/configs
sed "s|^\"\$root/.ci/build\" capsella\$|:|; s|^capsella=.*|capsella='$capsella'|" "$root/run" >empty/run
chmod +x empty/run

follow README.md 5 0
for results in skalak compare_criteria; do
  [ -s empty/results/$results/report.html ] || fail "no page of $results"
done
[ -s empty/tear/tear.so ] || fail "no law"
