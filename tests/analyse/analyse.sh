#!/bin/sh
# Static analysis of core/ and plugins/:  analyse.sh BUILD SOURCE
# clang-tidy by the profile in .clang-tidy, cppcheck by cppcheck.txt.  Prints what they find and fails for it.
set -eu
build=$1 source=$2
cmake -S "$source" -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBUILD_TESTING=OFF \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
cd "$source"
code=0
echo "clang-tidy"
find core plugins/constitutive plugins/damage -name '*.c' | sort |
  xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p "$build" 2>"$build/clang-tidy.log" || code=1
echo "cppcheck"
cppcheck --quiet --error-exitcode=1 --enable=warning,portability,performance --std=c11 --template=gcc \
  --suppressions-list=tests/analyse/cppcheck.txt --suppress=missingIncludeSystem -I core -I core/sdk \
  -D_POSIX_C_SOURCE=200809L -DCAPSELLA_VERSION='"0"' -DCAPSELLA_UMFPACK -D__GNUC__ core plugins || code=1
exit $code
