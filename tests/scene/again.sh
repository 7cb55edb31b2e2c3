#!/bin/sh
# A run into the folder of an earlier, longer one leaves what a run into an empty folder leaves.
. "$(dirname "$0")/common.sh"

# ends TIME FOLDER
ends() {
  "$capsella" run "$root/configs/shear_quick.yaml" --quiet -o "$2" --set output.snapshot_every=0.1 --set "time.end=$1"
}

ends 0.3 again
"$capsella" report again >message
ends 0.1 again
ends 0.1 once
[ "$(ls again)" = "$(ls once)" ] || fail "files of the earlier run are left: $(ls again)"
same again/history.csv once/history.csv "history of a second run in one folder"
same again/series.xdmf once/series.xdmf "series of a second run in one folder"

# Nor does it matter to the results whether anybody listens.
"$capsella" run "$root/configs/shear_quick.yaml" -o unheard --set output.snapshot_every=0.1 --set time.end=0.1 \
  <&- >&- 2>&-
same unheard/history.csv once/history.csv "history with the standard streams closed"
