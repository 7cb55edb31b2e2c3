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
