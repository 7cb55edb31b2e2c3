#!/bin/sh
# docs/writing-a-law.md, followed to the letter in an empty folder: its commands run, its files are written, and each
# line of output that it shows is there.
. "$(dirname "$0")/common.sh"

page="$root/docs/writing-a-law.md"
command -v c++ >/dev/null 2>&1 || { echo "skipped: the page needs a C++ compiler" && exit 77; }

# ```sh: commands.  ```c FILE: that file.
awk '
  /^```sh$/ { mode = "sh"; next }
  /^```c / { mode = "c"; print "cat >" $2 " <<\"END_OF_FILE\""; next }
  /^```/ { if (mode == "c") print "END_OF_FILE"; mode = ""; next }
  mode != "" { print }' "$page" >commands
[ "$(wc -l <commands)" -gt 80 ] || fail "the page has lost its commands"
awk '/^```text$/ { shown = 1; next } /^```/ { shown = 0 } shown { print }' "$page" >shown
[ "$(wc -l <shown)" -ge 8 ] || fail "the page has lost its output"

mkdir empty
code=0
(cd empty && PATH="$(dirname "$capsella"):$PATH" MLAW_PLUGIN_PATH='' sh -eu ../commands) >output 2>&1 || code=$?
[ "$code" = 0 ] || fail "exit code $code: $(tail -n 20 output)"
while IFS= read -r line; do
  grep -qF "$line" output || fail "the page shows a line that does not come: $line"
done <shown
grep -q '</svg>' empty/soft.svg || fail "no chart of the law"
for picture in tear soft; do
  grep -q '</svg>' "empty/results/$picture/capsule.svg" || fail "no picture of $picture"
  [ "$(number "empty/results/$picture/summary.json" status)" = ruptured ] || fail "no rupture of $picture"
done
