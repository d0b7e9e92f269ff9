#!/usr/bin/env bash
# tidy.sh: what clang-tidy says (.clang-tidy) of the engine and the bindings, as they are compiled for sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."
PANTIN_PRESET=asan ./pantin --help >/dev/null
sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/asan/compile_commands.json |
  grep -vE '/(tests|examples)/|cmake_pch|player/main.cpp' |
  xargs -P "$(nproc)" -n 1 clang-tidy -p build/asan --quiet 2>/dev/null
