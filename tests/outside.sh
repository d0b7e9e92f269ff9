#!/usr/bin/env bash
# outside.sh BUILD: installs what was built there into a folder of its own, moves that elsewhere, and has examples/library
# find it from outside, by CMake and by pkg-config; the installed program runs a scene, too.
set -euo pipefail
build=$1 source=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset PANTIN_HOME

cmake --install "$build" --prefix "$folder/first" >/dev/null
mv "$folder/first" "$folder/prefix"

cmake -S "$source/examples/library" -B "$folder/cmake" -DCMAKE_PREFIX_PATH="$folder/prefix" \
  -DCMAKE_CXX_COMPILER="${CXX:-c++}" -DCMAKE_CXX_FLAGS="-Wall -Werror" >/dev/null
cmake --build "$folder/cmake" -j 2
ctest --test-dir "$folder/cmake" --output-on-failure

export PKG_CONFIG_PATH; PKG_CONFIG_PATH=$(dirname "$(find "$folder/prefix" -name pantin.pc)")
home=$(pkg-config --variable=home pantin-lua)
for example in hang open; do
  package=$([ $example = open ] && echo pantin-lua || echo pantin)
  "${CXX:-c++}" -Wall -Werror "$source/examples/library/$example.cpp" -o "$folder/$example" $(pkg-config --cflags --libs $package)
  by_cmake=$("$folder/cmake/$example" "$home/scripts/scenes/chain.lua" "$home")
  by_pkg_config=$("$folder/$example" "$home/scripts/scenes/chain.lua" "$home")
  echo "$by_pkg_config"
  [ "$by_pkg_config" = "$by_cmake" ]
done

cd "$folder"
for scene in walker pinball; do prefix/bin/pantin run $scene --until 0.1; done
