#!/bin/sh
# Help, man pages, completions and JSON Schemas: they are there for every command and key, they agree, and what else is
# installed to read them (man, jsonschema of Python) finds nothing wrong.
. "$(dirname "$0")/common.sh"

commands="run study laws report bench manual help"
laws="list show plot check new"

# ---- Help ----

# has_help WORDS...: the same text in both ways, with usage and an example whose options are options of the command
has_help() {
  "$capsella" help "$@" >help.txt || fail "capsella help $*"
  "$capsella" "$@" --help >other.txt || fail "capsella $* --help"
  same help.txt other.txt "the help of $*"
  grep -q "^usage: capsella $*" help.txt || fail "no usage in the help of $*"
  grep -q "^Examples:" help.txt || fail "no example in the help of $*"
  [ "$*" != laws ] || return 0 # its examples are those of its commands
  sed -n '/^Examples:/,$s/^  \([^ ].*\)/\1/p' help.txt | grep "capsella $*" | tr ' ' '\n' | grep '^-' >used || true
  while read -r option; do
    grep -Eq "^  $option( |\$)" help.txt || fail "the help of $* has an example with $option, which it does not explain"
  done <used
}
for command in $commands; do
  has_help "$command"
  "$capsella" --help | grep -q "^  $command  *[a-z]" || fail "$command is not in the help of the program"
done
for command in $laws; do
  has_help laws "$command"
  "$capsella" laws --help | grep -q "^  $command  *[a-z]" || fail "$command is not in the help of laws"
done

# suggests NAME ARGUMENTS...: the call is refused, and NAME is offered
suggests() {
  name=$1
  shift
  code=0
  "$capsella" "$@" >/dev/null 2>message || code=$?
  [ "$code" = 2 ] || fail "exit code $code: $*"
  grep -q "did you mean '$name'" message || fail "'$name' is not offered for $*: $(cat message)"
}
suggests study studdy
suggests report help reprot
suggests check laws chekc
suggests --resume run scene.yaml --resum
suggests --jobs study study.yaml --job 2
suggests --full bench --ful
suggests --markdown laws list --markdwn
suggests --in-process laws check file.so --inprocess
suggests --json-schema manual --json-shema scene

# ---- Files ----

"$capsella" manual --files share
for command in $commands $(printf 'laws-%s ' $laws); do
  [ -s "share/man/man1/capsella-$command.1" ] || fail "no man page of $command"
done
if command -v man >/dev/null 2>&1; then
  for page in share/man/man1/*.1; do
    LC_ALL=C.UTF-8 man --warnings=w -l "$page" >page.txt 2>warnings.txt || fail "man refuses $page"
    [ ! -s warnings.txt ] || fail "$page: $(cat warnings.txt)"
    grep -q EXAMPLES page.txt || fail "$page has no examples"
  done
else
  echo "no man: the man pages are written, not read"
fi

# ---- Completion ----

mkdir "a folder"
touch scene.yaml study.yml law.so
cat >complete.bash <<'END'
# complete.bash SCRIPT WORDS...: what is offered for the last word
source "$1"
shift
complete -p capsella >/dev/null || exit 1
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_capsella
printf '%s\n' "${COMPREPLY[@]}"
END
# offers WORD ARGUMENTS...: the word is among what bash offers
offers() {
  word=$1
  shift
  bash complete.bash share/bash-completion/completions/capsella "$capsella" "$@" >offered
  grep -qxF -- "$word" offered || fail "bash does not offer '$word' for '$*', but: $(cat offered)"
}
# only COUNT ARGUMENTS...: so many lines are offered
only() {
  count=$1
  shift
  bash complete.bash share/bash-completion/completions/capsella "$capsella" "$@" >offered
  [ "$(grep -c . offered)" = "$count" ] || fail "bash offers for '$*', expected $count: $(cat offered)"
}
if command -v bash >/dev/null 2>&1; then
  for command in $commands; do offers "$command" ''; done
  for command in $laws; do offers "$command" laws ''; done
  offers run ru
  offers scene.yaml run ''
  offers study.yml study s
  only 1 run scene.
  offers --resume run scene.yaml --res
  offers 'a folder' run scene.yaml -o 'a'
  offers flow.capillary_number= run --set flow.cap
  only 0 run --set flow.capillary_number = ''
  offers scene.yaml run --set flow.capillary_number = 0.7 sc
  offers marigo laws show ma
  offers ./law.so laws show ./law
  offers damage-general laws new x --kind damage-
  offers scene manual --json-schema ''
  offers check help laws ch
else
  echo "no bash: its completion is not tested"
fi
if command -v zsh >/dev/null 2>&1; then
  zsh -n share/zsh/site-functions/_capsella || fail "zsh does not read its completion"
  # shellcheck disable=SC2016
  zsh -f -c 'fpath=(share/zsh/site-functions $fpath); autoload -Uz compinit; compinit -u -D; print $_comps[capsella]' |
    grep -qx _capsella || fail "zsh does not take its completion for that of capsella"
else
  echo "no zsh: its completion is not tested"
fi

# ---- JSON Schemas ----

"$capsella" manual --json-schema scene >scene.schema.json
"$capsella" manual --json-schema study >study.schema.json
same scene.schema.json share/capsella/schema/scene.schema.json "two ways to the schema of scenes"
"$capsella" manual | sed -n '/^## Parameters/q; s/^| `\([a-z_.]*\)` .*/\1/p' | sed 's/.*\.//' | sort -u >keys
[ "$(wc -l <keys)" -gt 30 ] || fail "the manual has few keys: $(cat keys)"
while read -r key; do
  grep -q "^ *\"$key\": {" scene.schema.json || fail "the schema of scenes lacks the key $key"
done <keys
! grep '": true' study.schema.json | grep -v -e additionalProperties -e '"default"' -e '"\(schema\|name\|scene\|vary\)"' >shapeless ||
  fail "keys of studies without a shape in core/study/json_schema.c: $(cat shapeless)"
if python3 -c 'import jsonschema, yaml' 2>/dev/null; then
  python3 "$here/schema_check.py" scene.schema.json study.schema.json "$root/configs" "$capsella" ||
    fail "a configuration does not fit its schema"
else
  echo "no jsonschema and yaml of Python: that the configurations fit is not tested"
fi

# ---- A dry run ----

quick="$root/configs/shear_quick.yaml"
mkdir empty
cd empty
"$capsella" run "$quick" --dry-run >dry.txt || fail "a dry run of $quick"
[ "$(ls)" = dry.txt ] || fail "a dry run wrote $(ls)"
grep -q '^mesh     320 elements, 642 nodes$' dry.txt || fail "no mesh in $(cat dry.txt)"
grep -q '^folder   results/shear_quick will be made$' dry.txt || fail "no folder in $(cat dry.txt)"

# So short a run is taken to its end, and its cost is that of the run itself.
"$capsella" run "$quick" --quiet -o run
expected="about $(number run/summary.json steps) steps, $(number run/summary.json evaluations) evaluations"
grep -q "^cost     $expected" dry.txt || fail "expected $expected in $(cat dry.txt)"
"$capsella" run "$quick" --dry-run --set output.snapshot_every=0 -o other >dry.txt
grep -q "1 snapshots" dry.txt || fail "no count of snapshots in $(cat dry.txt)"

# What is there already stays, to the last byte; and the table tells what will become of it.
cksum run/* >before
"$capsella" run "$quick" --dry-run -o run >dry.txt
grep -q '^folder   run holds results, which the run REPLACES$' dry.txt || fail "results are there: $(cat dry.txt)"
"$capsella" run "$quick" --dry-run --resume -o run --set time.end=2.5 >dry.txt
grep -q '^folder   run holds the snapshot to go on from$' dry.txt || fail "a snapshot is there: $(cat dry.txt)"
"$capsella" run "$quick" --dry-run --resume -o run >dry.txt
grep -q '^cost     none' dry.txt || fail "the run is at its end: $(cat dry.txt)"
cksum run/* >after
same before after "a dry run changed the folder"

# refused EXIT PATTERN ARGUMENTS...
refused() {
  expected=$1 pattern=$2
  shift 2
  code=0
  "$capsella" run --dry-run "$@" >/dev/null 2>message || code=$?
  [ "$code" = "$expected" ] || fail "exit code $code, expected $expected: $* ($(cat message))"
  grep -q "$pattern" message || fail "no match for '$pattern' in: $(cat message)"
}
refused 2 'step.*stability limit' "$quick" --set time.integrator=rk2 --set time.step=0.1
refused 2 'marigoo.*did you mean `marigo`' "$quick" --set membrane.damage.law=marigoo
refused 2 'parameter Y_D of law marigo: expected' "$quick" --set membrane.damage.parameters.Y_D=-1
refused 1 'dry.txt: results cannot be written there: it is not a folder' "$quick" -o dry.txt
refused 1 'dry.txt/inner: results cannot be written there' "$quick" -o dry.txt/inner
if [ "$(id -u)" -ne 0 ]; then
  mkdir -m 500 closed
  refused 1 'closed: results cannot be written there' "$quick" -o closed/inner
fi
