#!/bin/sh
# docs/embedding.md, followed to the letter in an empty prefix: a program in C by pkg-config, by CMake and with
# the static library, and one in Python; all find the installed laws from any folder.
. "$(dirname "$0")/common.sh"

command -v python3 >/dev/null 2>&1 || { echo "skipped: no python3" && exit 77; }
if grep -qE '__(asan|tsan|gcov)_init' "$capsella"; then
  echo "skipped: what is built with sanitizers or for coverage needs a program that is, too" && exit 77
fi
prefix="$work/prefix"
cmake --install "$(dirname "$capsella")" --prefix "$prefix" >install.log || fail "cmake --install: $(cat install.log)"
unset MLAW_PLUGIN_PATH LD_LIBRARY_PATH CPATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name capsella.pc)")
export PKG_CONFIG_PATH CMAKE_PREFIX_PATH="$prefix" OMP_WAIT_POLICY=passive OPENBLAS_NUM_THREADS=1

follow docs/embedding.md 70 4

grep '^d = ' output | sort | uniq -c | grep -q '^ *3 ' || fail "the three programs are not one computation: $(cat output)"
ldd empty/shear | grep -q "$prefix/lib.*/libcapsella.so.1 " || fail "another library: $(ldd empty/shear)"
if ldd empty/shear_static | grep -q libcapsella; then fail "the static program needs the shared library"; fi

# The program itself computes the same.
sed -n 's/^.*"\(.*\)\\n".*$/\1/p' empty/shear.c | sed '/^schema/,/^time/!d' >scene.yaml
"$capsella" run scene.yaml --quiet --set output.report=false -o run
[ "$(number run/summary.json status)" = end ] || fail "the scene of the page does not run"
grep -qxF "t = 3.00  D12 = $(printf %.3f "$(number run/summary.json D12)")" output || fail "D12 is not that of the program"

# A mistake is told, and a header of C is one of C++.
if (cd empty && ./shear fast) >log 2>&1; then fail "a capillary number that is none is taken"; fi
grep -q 'shear: .*flow.capillary_number=fast' log || fail "the mistake is not told: $(cat log)"
if command -v c++ >/dev/null 2>&1; then
  echo '#include <capsella.h>
int main() { return capsella_version()[0] == 0; }' >version.cc
  # shellcheck disable=SC2046
  c++ -std=c++11 -Wall -Wextra -Werror -pedantic version.cc -o version $(pkg-config --cflags --libs capsella) ||
    fail "the header is not one of C++"
fi
