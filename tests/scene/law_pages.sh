#!/bin/sh
# docs/laws is what the program prints of the laws that ship.
. "$(dirname "$0")/common.sh"

pages="$root/docs/laws"
export MLAW_PLUGIN_PATH=
laws=$("$capsella" laws list | awk '{ print $2 }')
[ "$(echo "$laws" | wc -l)" -ge 20 ] || fail "expected the laws that ship, found: $laws"

# compare FILE ARGUMENTS...: the page is what `capsella laws ARGUMENTS` prints
compare() {
  page=$1
  shift
  "$capsella" laws "$@" >"$page"
  cmp -s "$page" "$pages/$page" ||
    fail "docs/laws/$page is out of date: run \`capsella laws $* >docs/laws/$page\`"
}

compare README.md list --markdown
for law in $laws; do
  compare "$law.md" show "$law" --markdown
  grep -q '^    ' "$law.md" || fail "$law says no equation"
  grep -qi 'dissipation' "$law.md" || fail "$law does not say whether it dissipates"
done
for page in "$pages"/*.md; do
  [ -f "$(basename "$page")" ] || fail "$page is of no law"
done
