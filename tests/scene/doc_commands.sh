#!/bin/sh
# Every command of the program that a page mentions, in a block or within a line, is one that there is: its options stand
# in its help, and the scenes and studies of configs/ that it names are there.  (Blocks of `sh` are run by other tests.)
. "$(dirname "$0")/common.sh"

# Lines "PAGE: COMMAND", with ./run and capsella in front taken off.
(cd "$root" && find README.md docs web -name node_modules -prune -o -name '*.md' -print) | while read -r page; do
  awk -v page="$page" '
    function take(text) {
      if (sub(/^(\$ )?(\.\/run|capsella|mpirun .*capsella) +/, "", text)) print page ": " text
    }
    /^```/ { fenced = !fenced; next }
    fenced { take($0); next }
    { n = split($0, part, "`"); for (k = 2; k <= n; k += 2) take(part[k]) }' "$root/$page"
done >commands
[ "$(wc -l <commands)" -ge 40 ] || fail "the pages have lost their commands: $(wc -l <commands)"

while IFS= read -r line; do
  page=${line%%: *}
  # shellcheck disable=SC2086
  set -f && set -- ${line#*: } && set +f
  case $1 in
    -*) name='' ;;
    *.yaml | */*) name=run ;;
    laws | help) name="$1 ${2:-}" ;;
    *) name=$1 ;;
  esac
  case $name in "laws "[a-z]*) ;; "laws "* | "help "*) name=${name%% *} ;; esac
  # shellcheck disable=SC2086
  "$capsella" ${name:+help} ${name:---help} >help.txt 2>&1 || fail "$page: no command '$name': $line"
  for word in "$@"; do
    case $word in
      --[a-z]* | -[a-z])
        grep -qE -- "(^|[ [])$word( |\$|,|\])" help.txt || fail "$page: '$name' has no option $word: $line" ;;
      configs/*.yaml) [ -f "$root/$word" ] || fail "$page: there is no $word: $line" ;;
    esac
  done
done <commands
