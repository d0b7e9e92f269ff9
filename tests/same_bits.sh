#!/usr/bin/env bash
# same_bits.sh: whether each shipped scene comes to the state that tests/golden/scene_hashes.txt has, to the bit; some of them also
# from another compiler, with sanitizers and little optimisation, and on a processor without the wider variants of the C library's
# functions. same_bits.sh --all: each from every build, with 1, 2 and 4 threads, with memory that is filled before it is used.
# PANTIN_RECORD=1 writes the record anew: for changes that are meant to change bits.
set -euo pipefail
cd "$(dirname "$0")/.."
all=${1:-}
record=tests/golden/scene_hashes.txt
export folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run_scene BUILD NARROW THREADS FILL SCENE: "SCENE HASH" into a file.
run_scene() {
  local tunables= environment=
  [ $2 = wide ] || tunables=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable
  local out="$folder/$1-$2-$3-$4-$5"
  GLIBC_TUNABLES=$tunables MALLOC_PERTURB_=$4 "build/$1/bin/pantin" run "scripts/scenes/$5.lua" --until 1 \
    --script-limit 0 --threads $3 --summary "$out.json" >/dev/null
  sed -n "s/.*\"hash\": *\"\{0,1\}\([0-9a-zA-Z]*\).*/$5 \1/p" "$out.json" >"$out"
}
export -f run_scene

builds=(release asan)
scenes=($(ls scripts/scenes | sed -n 's/\.lua$//p'))
some=(bridge buckyball chain cloth fire machines membrane tower)
variants=("release wide 1 0" "release narrow 1 0" "asan wide 1 0")
if [ "$all" ]; then
  builds+=(clang native package)
  some=("${scenes[@]}")
  fill=0
  for build in release clang native package; do
    for width in wide narrow; do
      for threads in 1 2 4; do variants+=("$build $width $threads $((fill = (fill + 37) % 256))"); done
    done
  done
  variants+=("asan wide 2 0")
fi

scenes_of() {
  [ "$1" = "release wide 1 0" ] && printf '%s\n' "${scenes[@]}" || printf '%s\n' "${some[@]}"
}

for build in "${builds[@]}"; do PANTIN_PRESET=$build ./pantin --help >/dev/null; done
for variant in "${variants[@]}"; do scenes_of "$variant" | sed "s/^/$variant /"; done |
  PANTIN_HOME=$PWD xargs -P "$(nproc)" -L 1 bash -c 'run_scene "$@" || exit 255' run_scene

hashes_of() {
  for scene in $(scenes_of "$1"); do grep . "$folder/${1// /-}-$scene" || echo "$scene none"; done | sort
}

[ -z "${PANTIN_RECORD:-}" ] || hashes_of "${variants[0]}" >"$record"
for variant in "${variants[@]}"; do
  differ=$(hashes_of "$variant" | grep -vxFf "$record" || true)
  echo "$variant: $(scenes_of "$variant" | wc -l) scenes${differ:+, of other bits: $differ}"
  [ -z "$differ" ] || failed=1
done
[ -z "${failed:-}" ]
