#!/bin/sh
# web/report_page.html is what web/build.mjs makes of web/src today.  Skipped (77) without node and npm, or where the
# locked packages cannot be had.
. "$(dirname "$0")/../scene/common.sh"

command -v node >/dev/null && command -v npm >/dev/null || {
  echo "skipped: no npm to rebuild the page with"
  exit 77
}
cp -r "$root/web/src" "$root/web/build.mjs" "$root/web/package.json" "$root/web/package-lock.json" .
npm ci --ignore-scripts --no-audit --no-fund --prefer-offline >npm.log 2>&1 || {
  echo "skipped: the packages of web/package-lock.json cannot be had here"
  exit 77
}
node build.mjs rebuilt.html
same rebuilt.html "$root/web/report_page.html" "the page is not that of its sources; run npm ci && npm run build in web/"
for package in three uplot; do
  grep -qF "$(sed -n 's/^Copyright/&/p' "node_modules/$package/LICENSE")" "$root/NOTICE" || fail "NOTICE lacks $package"
done
