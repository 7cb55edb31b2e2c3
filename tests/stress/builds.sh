#!/bin/sh
# How far results move with compiler and instruction set:  builds.sh FOLDER [SCENE.yaml]...
# Builds the program anew for each line below and runs the scenes (the quick and the reference one, when none is named).
# Prints the largest distance of each build from the first: of a column of history.csv, over the column's largest size, and
# of the times of damage and rupture.  Where gcc makes one copy of the hot loops for each instruction set and the machine
# chooses (base/vector_clones.h), `one copy` says that there is only that of the flags.
set -eu
folder=$1
shift
root=$(cd "$(dirname "$0")/../.." && pwd)
[ $# -gt 0 ] || set -- "$root/configs/shear_quick.yaml" "$root/configs/shear_reference.yaml"
mkdir -p "$folder"
cd "$folder"

# NAME COMPILER FLAGS
builds() {
  cat <<END
gcc gcc -O3
gcc_again gcc -O3
gcc_v2 gcc -march=x86-64-v2 -U__gnu_linux__
gcc_v3 gcc -march=x86-64-v3 -U__gnu_linux__
gcc_native gcc -march=native -U__gnu_linux__
clang clang -O3
clang_v3 clang -march=x86-64-v3
clang_native clang -march=native
END
}

builds | while read -r name compiler flags; do
  [ -x "$name/capsella" ] || {
    cmake -S "$root" -B "$name" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DCMAKE_C_COMPILER="$compiler" \
      -DCMAKE_C_FLAGS="$flags"
    cmake --build "$name" --target capsella --parallel
  } >"$name.log" 2>&1 </dev/null || { echo "$name: not built, see $PWD/$name.log"; continue; }
  for scene; do
    short=$(basename "$scene" .yaml)
    "$name/capsella" run "$scene" --quiet --threads 1 -o "runs/$short/$name" --set output.snapshot_every=0 \
      --set output.report=false </dev/null
    awk -F, -v name="$name" -v short="$short" '
      function size(x) { return x < 0 ? -x : x }
      FNR == 1 { n = split($0, column, ","); next }
      NR == FNR { for (i = 1; i <= n; i++) { first[FNR, i] = $i; if ($i != "nan" && size($i) > largest[i]) largest[i] = size($i) }; rows = FNR; next }
      { for (i = 1; i <= n; i++) if ($i != "nan" && largest[i] > 0) { far = size($i - first[FNR, i]) / largest[i]; if (far > most[i]) most[i] = far } }
      END {
        printf "%-16s %-13s %s rows", short, name, FNR == rows ? "same" : "OTHER"
        for (i = 1; i <= n; i++) if (column[i] ~ /^(D12|d_max|Y_max|T2_min|steps?|evaluations)$/) printf "  %s %.1e", column[i], most[i]
        print ""
      }' "runs/$short/gcc/history.csv" "runs/$short/$name/history.csv"
    grep -h '^  "t_[cl]"' "runs/$short/$name/summary.json" | tr -d '\n,'
    echo
  done
done
