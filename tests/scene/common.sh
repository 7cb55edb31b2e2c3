# Shared by the scene tests: each is called with the program and a folder of its own to work in.
set -eu
capsella=$1
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$2
rm -rf "$work"
mkdir -p "$work"
cd "$work"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# number FILE KEY: the value of a top-level key of a summary.json
number() {
  sed -n "s/^  \"$2\": *\"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\$/\1/p" "$1"
}

# A summary without its cost in seconds.
without_cost() {
  grep -v -e wall_seconds -e '"threads"' "$1"
}

same() {
  cmp -s "$1" "$2" || fail "$1 and $2 differ: $3"
}

# follow PAGE FEWEST_LINES FEWEST_SHOWN [FOLDER]...: does what a page says, to the letter, in the folder
# `empty` (which may hold what the page takes for granted) with the program on the PATH (and the FOLDERs before it).  ```sh: commands that are run; ```LANGUAGE FILE: that
# file is written; ```text: each line is in the output.  A page that has lost its commands or its output fails.
follow() {
  page="$root/$1" fewest=$2 fewest_shown=$3
  shift 3
  path=$(printf '%s:' "$@" "$(dirname "$capsella")")
  awk '
    /^```sh$/ { mode = "sh"; next }
    /^```[a-z]+ [^ ]+$/ { mode = "file"; print "cat >" $2 " <<\"END_OF_FILE\""; next }
    /^```/ { if (mode == "file") print "END_OF_FILE"; mode = ""; next }
    mode != "" { print }' "$page" >commands
  [ "$(wc -l <commands)" -ge "$fewest" ] || fail "the page has lost its commands"
  awk '/^```text$/ { shown = 1; next } /^```/ { shown = 0 } shown { print }' "$page" >shown
  [ "$(wc -l <shown)" -ge "$fewest_shown" ] || fail "the page has lost its output"
  mkdir -p empty
  code=0
  (cd empty && PATH="$path$PATH" MLAW_PLUGIN_PATH='' sh -eu ../commands) >output 2>&1 || code=$?
  [ "$code" = 0 ] || fail "exit code $code: $(tail -n 20 output)"
  while IFS= read -r line; do
    grep -qF -- "$line" output || fail "the page shows a line that does not come: $line"
  done <shown
}
