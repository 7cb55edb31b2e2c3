#!/bin/sh
# Each package that cpack makes holds a program that finds its laws and runs, its man pages and its completions:
#   package.sh BUILD-FOLDER SOURCE-FOLDER
set -eu
build=$1 root=$2 packages=$1/packages
unset MLAW_PLUGIN_PATH

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# complete PREFIX: all that is needed lies below it
complete() {
  for file in bin/capsella share/man/man1/capsella-run.1 share/bash-completion/completions/capsella \
    share/zsh/site-functions/_capsella share/capsella/schema/scene.schema.json include/mlaw/mlaw.h \
    include/capsella.h share/doc/capsella/LICENSE share/doc/capsella/NOTICE; do
    [ -f "$1/$file" ] || [ -f "$1/$file.gz" ] || fail "$file is missing below $1"
  done
  for file in libcapsella.so.1 libcapsella.a pkgconfig/capsella.pc cmake/Capsella/CapsellaConfig.cmake; do
    [ -n "$(find "$1" -path "*/$file")" ] || fail "$file is missing below $1"
  done
  "$1/bin/capsella" laws list >"$packages/laws.txt"
  grep -q "$1/lib.*/capsella/plugins/marigo.so" "$packages/laws.txt" ||
    fail "the laws below $1 are not found: $(cat "$packages/laws.txt")"
  "$1/bin/capsella" run "$root/configs/shear_quick.yaml" --quiet --set time.end=0.2 -o "$packages/results"
  grep -q '"status": "end"' "$packages/results/summary.json" || fail "no run with $1/bin/capsella"
}

rm -rf "$packages"
(cd "$build" && cpack >cpack.log 2>&1) || fail "cpack: $(cat "$build/cpack.log")"

mkdir "$packages/archive"
tar -xzf "$packages"/*.tar.gz -C "$packages/archive" --strip-components=1
complete "$packages/archive"

mkdir "$packages/debian"
dpkg-deb -x "$packages"/*.deb "$packages/debian"
complete "$packages/debian/usr"
for library in libc6 libyaml-0-2 libhdf5 libgomp1; do
  dpkg-deb -f "$packages"/*.deb Depends | grep -q "$library" || fail "the Debian package does not ask for $library"
done
dpkg-deb -I "$packages"/*.deb | grep -q shlibs || fail "the Debian package does not tell of its shared library"
if command -v lintian >/dev/null 2>&1; then lintian "$packages"/*.deb || true; fi
ls -l "$packages"/*.deb "$packages"/*.tar.gz
