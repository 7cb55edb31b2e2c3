#!/bin/sh
# An installed Capsella is complete: in an empty prefix it finds its laws, starts new ones in C and in C++, and
# these build with nothing but what pkg-config or CMake say of the prefix, pass their check, and run.
. "$(dirname "$0")/common.sh"

build=$(dirname "$capsella")
prefix="$work/a prefix"
cmake --install "$build" --prefix "$prefix" >install.log || fail "cmake --install: $(cat install.log)"
capsella="$prefix/bin/capsella"
unset MLAW_PLUGIN_PATH CMAKE_PREFIX_PATH CPATH
export PKG_CONFIG_PATH="$prefix/share/pkgconfig"

quietly() {
  "$@" >log 2>&1 || fail "$* $(cat log)"
}

"$capsella" laws list >list
grep -q "$prefix/lib.*/capsella/plugins/skalak.so" list || fail "the installed laws are not found: $(cat list)"
[ -f "$prefix/share/capsella/template/energy_law.c" ] || fail "the templates are not installed"
for file in man/man1/capsella-run.1 bash-completion/completions/capsella zsh/site-functions/_capsella \
  capsella/schema/scene.schema.json; do
  [ -f "$prefix/share/$file" ] || fail "$file is not installed"
done

pkg-config --exists 'mlaw >= 1.1' || fail "pkg-config does not know mlaw 1.1"
plugindir=$(pkg-config --variable=plugindir mlaw | sed 's/\\ / /g') # it writes blanks as a shell does
[ -f "$plugindir/skalak.so" ] || fail "plugindir of pkg-config holds no laws: $plugindir"

# check_both_ways FOLDER: without its own copy of the headers
check_both_ways() {
  rm -r "$1/mlaw"
  quietly make -C "$1" check MLAW="$(pkg-config --cflags mlaw)"
  if grep -q 'warning:' log; then fail "the compiler warns of a new law: $(cat log)"; fi
  quietly cmake -S "$1" -B "$1/build" -DCMAKE_PREFIX_PATH="$prefix"
  quietly cmake --build "$1/build"
  quietly ctest --test-dir "$1/build"
  grep -q '100% tests passed, 0 tests failed out of 1' log || fail "the check did not run: $(cat log)"
}

# ruptures FOLDER LAW: its scene runs to rupture
ruptures() {
  quietly make -C "$1" run
  [ "$(number "$1/results/$2/summary.json" status)" = ruptured ] || fail "no rupture: $(cat log)"
}

# A law that is installed is found by its id.
quietly "$capsella" laws new sheet --kind constitutive --name acme.sheet
check_both_ways sheet
cp sheet/sheet.so "$plugindir"
quietly "$capsella" laws show acme.sheet
ruptures sheet sheet

if command -v c++ >/dev/null 2>&1; then
  quietly "$capsella" laws new tear --kind damage --cxx
  check_both_ways tear
  ruptures tear tear
else
  echo "no C++ compiler: laws in C++ are not tested"
fi

# As it comes, with its own copy of the headers and no prefix.
quietly "$capsella" laws new slow --kind damage-general
quietly env PKG_CONFIG_PATH= make -C slow check
ruptures slow slow

# Fast-math is refused by name.
sed -i 's/^mlaw_add_plugin/set(CMAKE_C_FLAGS -Ofast)\n&/' slow/CMakeLists.txt
if cmake -S slow -B slow/build >log 2>&1; then fail "-Ofast is let through"; fi
grep -q 'must not be compiled with -Ofast' log || fail "-Ofast is not named: $(cat log)"
