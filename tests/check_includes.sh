#!/bin/sh
# Fails on an #include that goes upward through the levels of docs/architecture.md, on a plugin that includes more than
# the SDK and the C library, on two source files with one name, and on a second file that names LAPACK or UMFPACK.
root=${1:-.}
cd "$root" || exit 2
awk '
  function level(room) {
    if (room == "mlaw") return 0
    if (room == "base") return 1
    if (room ~ /^(config|mesh|linalg)$/) return 2
    if (room == "laws") return 3
    if (room ~ /^(membrane|fluid)$/) return 4
    if (room ~ /^(coupling|observe)$/) return 5
    if (room == "run") return 6
    if (room ~ /^(study|benchmark|api)$/) return 7
    if (room == "app") return 8
    return -1
  }
  /^[ \t]*#[ \t]*include[ \t]*["<]/ {
    target = $0
    sub(/^[ \t]*#[ \t]*include[ \t]*["<]/, "", target)
    sub(/[">].*/, "", target)
    split(FILENAME, own, "/")
    if (own[1] == "plugins") {
      if (target !~ /^(mlaw\/(mlaw|brief)\.h|math\.h|stddef\.h|stdint\.h|float\.h|string\.h)$/) {
        printf "%s:%d: a plugin may include mlaw/mlaw.h, mlaw/brief.h and the C library only, not %s\n", FILENAME, FNR, target
        bad = 1
      }
      next
    }
    if (split(target, part, "/") < 2) next
    here = level(own[2] == "sdk" ? "mlaw" : own[2]); there = level(part[1])
    if (there < 0) next
    included++
    if (there > here) {
      printf "%s:%d: level %d includes %s of level %d\n", FILENAME, FNR, here, target, there
      bad = 1
    }
  }
  END {
    if (included < 10) { print "the walk found only " included + 0 " includes: is this the right folder?"; bad = 1 }
    exit bad
  }' $(find core plugins -name '*.[ch]') || status=1

twice=$(find core -name '*.c' | sed 's|.*/||' | sort | uniq -d)
[ -z "$twice" ] || { echo "file names used twice: $twice"; status=1; }

files=$(grep -lE '# *include *<umfpack' -r core | wc -l)
[ "$files" -le 1 ] || { echo "$files files include umfpack.h; one may"; status=1; }
files=$(grep -lE '\bdsyev_' -r core --include='*.c' | wc -l)
[ "$files" -le 1 ] || { echo "$files files name LAPACK; one may"; status=1; }
exit ${status:-0}
