#!/usr/bin/env bash
# coverage.sh: which part of the lines of each room the quick tests come by; built with clang. Whether they pass is not asked:
# a few cannot where what they start must write a profile, too.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$PWD/build/coverage
export PANTIN_PRESET=coverage PANTIN_HOME=$PWD
./pantin --help >/dev/null
cmake --build "$build" --target pantin_tests >"$build/tests.log" || { cat "$build/tests.log"; exit 1; }
rm -f "$build"/*.profraw
export LLVM_PROFILE_FILE=$build/%8m.profraw
"$build/bin/pantin_tests" "~[window]~[slow]~[minute]" | tail -3 || true
"$build/bin/pantin" test tests/scenes | tail -1 || true
llvm-profdata merge --failure-mode=all "$build"/*.profraw -o "$build/all.profdata" 2>"$build/merge.log" || { cat "$build/merge.log"; exit 1; }
llvm-cov export -summary-only -instr-profile "$build/all.profdata" "$build/bin/pantin_tests" -object "$build/bin/pantin" |
  python3 -c '
import collections, json, sys
rooms = collections.defaultdict(lambda: [0, 0])
for file in json.load(sys.stdin)["data"][0]["files"]:
    parts = file["filename"].partition(sys.argv[1] + "/")[2].split("/")
    lines = file["summary"]["lines"]
    for room in {parts[0], "/".join(parts[:2])} if parts[0] in ("engine", "bindings") else {}:
        rooms[room][0] += lines["covered"]
        rooms[room][1] += lines["count"]
for room, (covered, count) in sorted(rooms.items()):
    print(f"{room:24} {100 * covered / count:5.1f} % of {count} lines")
' "$PWD"
