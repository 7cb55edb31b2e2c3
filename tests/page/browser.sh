#!/bin/sh
# report.html of runs and of a study in a real browser: it loads without a message on the console, its slider, colours
# and views change the picture, and the numbers it shows are those of summary.json.  Skipped (77) where there is no Chromium.
. "$(dirname "$0")/../scene/common.sh"

for name in chromium chromium-browser google-chrome; do
  browser=$(command -v $name) && break
done
[ -n "$browser" ] || {
  echo "skipped: no Chromium to open the page with"
  exit 77
}

# page_with DIR PROBE: the page of DIR with a probe at its end, which leaves its findings in the page.
page_with() {
  {
    sed '/<\/head>/i <script>var messages = []; addEventListener("error", e => messages.push(e.message));</script>' \
      "$1/report.html" | sed '/^<\/body>/,$d'
    printf '<script type="application/json" id="expected">'
    cat "$1/summary.json"
    printf '</script>\n<script>'
    cat "$here/probe.js" "$here/$2"
    printf '</script>\n</body>\n</html>\n'
  } >"$1/probed.html"
}

# opens DIR PROBE: opens the probed page; its findings must end in "passed", and the console must stay empty.
opens() {
  page_with "$1" "$2"
  timeout 100 "$browser" --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --user-data-dir="$work/profile" --window-size=760,700 --timeout=90000 --enable-logging=stderr \
    --dump-dom "file://$work/$1/probed.html" >"$1/dom.html" 2>"$1/browser.log" || fail "the browser on $1"
  sed -n '/<pre id="findings">/,/<\/pre>/p' "$1/dom.html" | sed 's/<[^>]*>//g' >"$1/findings.txt"
  ! grep -q 'INFO:CONSOLE\|ERROR:CONSOLE\|WARNING:CONSOLE' "$1/browser.log" ||
    fail "$1: on the console: $(grep CONSOLE "$1/browser.log")"
  grep -q '^passed$' "$1/findings.txt" || fail "$1: $(cat "$1/findings.txt")"
}

"$capsella" run "$root/configs/shear_reference.yaml" --quiet -o sheared --set capsule.mesh.subdivisions=2 \
  --set time.end=1.5 --set output.snapshot_every=0.25 \
  --set 'observe.criteria=[{law: rankine, parameters: {T_D: 0.1, T_C: 0.9}}, {law: marigo, parameters: {Y_D: 0.01, Y_C: 2}}]'
opens sheared probe_run.js
"$capsella" run "$root/configs/inflation_monotone.yaml" --quiet -o inflated --set capsule.mesh.subdivisions=1
opens inflated probe_run.js

cat >study.yaml <<END
schema: 1
study: sweep
name: swept
scene: $root/configs/shear_quick.yaml
vary:
  membrane.damage.parameters.Y_D: [0.1, 0.2]
  flow.capillary_number: [0.1, 0.5, 4.0]
END
"$capsella" study study.yaml --quiet -o swept --set capsule.mesh.subdivisions=1 --set time.end=3 \
  --set membrane.damage.parameters.Y_C=0.5
opens swept probe_study.js
