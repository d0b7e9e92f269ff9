#!/usr/bin/env bash
# fuzz.sh [SECONDS [TARGET…]]: feeds what reads foreign files (fuzz/targets) with what libFuzzer makes of good ones, so many
# seconds each; under sanitizers, built with clang. A find ends it, with the file that did it in build/fuzz/finds.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
shift || true
targets=("$@")
[ "${targets[*]}" ] || targets=($(ls tests/fuzz/targets | sed -n 's/\.cpp$//p'))
PANTIN_PRESET=fuzz ./pantin --help >/dev/null
cmake --build build/fuzz --target fuzz_targets >build/fuzz/targets.log || { cat build/fuzz/targets.log; exit 1; }
export PANTIN_HOME=$PWD
finds=$PWD/build/fuzz/finds
seeds=$(mktemp -d)
trap 'rm -rf "$seeds"' EXIT

mkdir -p "$finds" "$seeds"/{molecules,patterns,recordings,scenes,states,tables}
index=0
for ending in xyz sdf pdb cif obj; do
  for file in assets/*/*.$ending tests/fuzz/seeds/*.$ending; do
    [ ! -e "$file" ] || { printf "\\x0$index"; cat "$file"; } >"$seeds/molecules/$(basename "$file")"
  done
  index=$((index + 1))
done
cp scripts/scenes/*.lua tests/corpus/*.lua "$seeds/scenes"
cp tests/fuzz/seeds/*.csv "$seeds/tables"
cp tests/fuzz/seeds/*.jsonl "$seeds/recordings"
while read -r pattern subject; do
  printf '%s\0%s' "$pattern" "$subject" >"$seeds/patterns/$((index++))"
done <tests/fuzz/seeds/patterns.txt
for scene in chain coin gears; do
  build/fuzz/bin/pantin run $scene --until 0.05 --save-at 0.02 --save-to "$seeds/states/$scene" >/dev/null
done

for target in "${targets[@]}"; do
  echo "-- $target, $seconds s"
  mkdir -p "$seeds/new"
  "build/fuzz/bin/fuzz_$target" "$seeds/new" "$seeds/$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 \
    -max_len=20000 -artifact_prefix="$finds/$target-" -verbosity=0 -print_final_stats=1 2>"$seeds/log" || { cat "$seeds/log"; exit 1; }
  grep -E "number_of_executed_units|new_units_added|slowest_unit" "$seeds/log"
  rm -r "$seeds/new"
done
