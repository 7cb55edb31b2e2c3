#!/bin/sh
# docs/broken-laws.md is what `laws check` says of the plugins of tests/broken, and a run refuses each of them.
. "$(dirname "$0")/common.sh"
if grep -q "__[at]san_init" "$capsella"; then
  echo "skipped: a sanitizer ends a process in its own way" && exit 77
fi

fixtures=$(dirname "$capsella")/tests/broken

# "FIXTURE GROUP/TEST", from the table of tests/unit/test_conformance.c
sed -n 's/^ *{"\([a-z_]*\)", "\([a-z]*\/[A-Za-z0-9-]*\)".*/\1 \2/p' "$root/tests/unit/test_conformance.c" >faults
[ "$(wc -l <faults)" -ge 30 ] || fail "the table of faults is not found"

# refuses FIXTURE: a run ends at once with exit code 2 and names the file, a test that fails, and, where it is known, the law
refuses() {
  code=0
  "$capsella" run "$root/configs/inflation_monotone.yaml" --quiet -o "run_$1" --set "membrane.law=$fixtures/$1.so" \
    2>"$1.message" || code=$?
  [ "$code" = 2 ] || fail "a run with $1: exit code $code: $(cat "$1.message")"
  grep -q "$fixtures/$1.so: \([A-Za-z_ ]*: \)\{0,1\}[a-z]*/[A-Za-z0-9-]* \(failed\|crashed\|timed out\): ." "$1.message" ||
    fail "a run with $1 does not name file, law and test: $(cat "$1.message")"
}
refuses endless & # waits for the time limit

cat >page.md <<'END'
# Broken laws

Written by `tests/scene/broken_laws.sh`: plugins with one fault each, the conformance test made for it, and what `capsella laws check` says.
A run refuses each of them before it starts (exit code 2) with a message that names the file, the law, the test and its words; `membrane.check_laws: false` in a scene runs a law all the same.
Laws that come with the program are not checked again.

| plugin of `tests/broken` | its fault | test | what `laws check` says |
|---|---|---|---|
END
while read -r fixture test; do
  code=0
  "$capsella" laws check "$fixtures/$fixture.so" --only "^$test\$" --time-limit 0.5 >report || code=$?
  [ "$code" = 1 ] || fail "laws check of $fixture: exit code $code: $(cat report)"
  text=$(grep "$test" report | sed 's/^\(failed\|crashed\|timed out\) *[^ ]* *//; s/^: //')
  about=$(sed -n '1s/^\/\* \(.*\)[.] \*\/$/\1/p' "$root/tests/broken/$fixture.c")
  [ -n "$about" ] || about=$(sed -n '1s/^\/\* //p' "$root/tests/broken/$fixture.c")
  echo "| \`$fixture\` | $about | \`$test\` | $text |" >>page.md
done <faults
for fixture in $(cut -d ' ' -f 1 faults | sort -u); do
  [ "$fixture" = endless ] || refuses "$fixture"
done
wait $! || fail "a run with endless is not refused: $(cat endless.message)"
grep -q 'endless: contract/no-hole timed out: no answer within 10 s' endless.message || fail "$(cat endless.message)"

# Digits depend on compiler and machine.
for page in page.md "$root/docs/broken-laws.md"; do
  sed 's/-\{0,1\}[0-9][0-9.]*\(e[-+][0-9]*\)\{0,1\}/0/g' "$page" >"$(basename "$page").masked"
done
cmp -s page.md.masked broken-laws.md.masked || fail "docs/broken-laws.md is out of date: it is $work/page.md"

# A law that fails a test may be run, for those who insist; one that is sound is not asked twice.
"$capsella" run "$root/configs/inflation_monotone.yaml" --quiet -o insists --set capsule.mesh.subdivisions=1 \
  --set membrane.check_laws=false --set "membrane.law=$fixtures/allocates.so" || fail "check_laws: false refuses"
