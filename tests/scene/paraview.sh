#!/bin/sh
# docs/paraview.md, followed to the letter: ParaView reads both kinds of series, finds what the run wrote, and draws it.
. "$(dirname "$0")/common.sh"

skip() {
  echo "skipped: $1" && exit 77
}
command -v pvpython >/dev/null 2>&1 || skip "ParaView is not installed"
pvpython -c 'import paraview.simple' >/dev/null 2>&1 || skip "pvpython has no paraview.simple"
# Without a display, a virtual one; it writes its number when it listens.  ParaView opens and closes it more than once,
# and without -noreset the server would start anew each time, at which the next opening may fail.
if [ -z "${DISPLAY:-}" ]; then
  command -v Xvfb >/dev/null 2>&1 || skip "neither a display nor Xvfb"
  Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp -noreset >display 2>/dev/null &
  server=$!
  trap 'kill $server 2>/dev/null || true' EXIT
  while [ ! -s display ] && kill -0 $server 2>/dev/null; do sleep 0.1; done
  [ -s display ] || skip "Xvfb does not start"
  DISPLAY=:$(cat display)
  export DISPLAY
fi

follow docs/paraview.md 30 6
results=empty/results/small
for words in points:nodes cells:elements; do
  [ "$(grep -c "\b$(number $results/summary.json "${words#*:}") ${words%:*}, " output)" = 2 ] || fail "${words%:*}: $(cat output)"
done
# The largest nodal damage is that of the run, up to what is lost from integration points to nodes
# and to the four digits printed.
awk -v d="$(number $results/summary.json d_max)" '
  /^largest damage/ { found++; if (!($3 <= d + 0.00005 && $3 > 0.9 * d)) exit 1 }
  END { exit found != 2 }' output || fail "largest damage: $(cat output)"
# The pictures show the damaged place, and it alone, in yellow, the end of the colours; the bar of colours, at the right, is left out.
cat >look.py <<'END'
import sys
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.util.numpy_support import vtk_to_numpy
for name in sys.argv[1:]:
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    red, green, blue = pixels.reshape(height, width, -1)[:, : width * 4 // 5, :3].astype(int).transpose(2, 0, 1)
    yellow = ((red > 2 * blue + 40) & (green > 2 * blue + 40)).sum()
    drawn = ((red < 200) | (blue < 200)).sum()
    print(name, yellow, "yellow of", drawn, "drawn of", red.size)
    assert 500 < yellow < 0.5 * drawn and drawn > 50000
END
pvpython look.py empty/small.png empty/rest.png >seen 2>&1 || fail "pictures: $(cat seen)"
! cmp -s empty/small.png empty/rest.png || fail "the sphere at rest looks like the capsule"
