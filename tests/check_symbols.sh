#!/bin/sh
# The shared and the static library define exactly the functions that capsella.h declares, the shared one with
# versions, its own name, and no library that its engine does not need:
#   check_symbols.sh FOLDER-OF-THE-LIBRARIES capsella.h
set -eu
folder=$1 header=$2
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
command -v nm >/dev/null 2>&1 && command -v readelf >/dev/null 2>&1 || { echo "skipped: no nm and readelf" && exit 77; }

declared=$(grep -oE '^CAPSELLA_API .*' "$header" | grep -oE 'capsella_[a-z_]+\(' | tr -d '(' | sort)
[ "$(echo "$declared" | wc -l)" -ge 15 ] || fail "the header has lost its functions: $declared"

versioned=$(nm -D --defined-only "$folder/libcapsella.so" | awk '$2 != "A" { print $3 }' | sort)
[ "$(echo "$versioned" | sed 's/@@CAPSELLA_1[.][0-9]*$//')" = "$declared" ] ||
  fail "libcapsella.so exports $versioned"
[ "$(echo "$versioned" | grep -c '@@CAPSELLA_1[.]')" = "$(echo "$declared" | wc -l)" ] || fail "without version: $versioned"
[ "$(nm -g --defined-only "$folder/libcapsella.a" | awk 'NF == 3 { print $3 }' | sort)" = "$declared" ] ||
  fail "libcapsella.a defines more or less: $(nm -g --defined-only "$folder/libcapsella.a")"

dynamic=$(readelf -d "$folder/libcapsella.so")
echo "$dynamic" | grep -q 'SONAME.*\[libcapsella[.]so[.]1\]' || fail "another SONAME: $dynamic"
if echo "$dynamic" | grep -E 'NEEDED.*(hdf5|mpi)'; then fail "it needs what it does not use"; fi
if echo "$dynamic" | grep -q TEXTREL; then fail "its code is not shared between processes"; fi
