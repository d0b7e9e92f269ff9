#!/usr/bin/env bash
# package.sh: makes the Debian packages and tries them unpacked elsewhere, with the program for any x86-64 and with the wide
# one that it becomes.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset PANTIN_HOME

cmake --preset package >/dev/null
cmake --build --preset package
(cd build/package && rm -f ./*.deb && cpack >/dev/null)
for deb in build/package/*.deb; do
  ls -l "$deb"
  dpkg-deb --field "$deb" Package Depends Recommends
  dpkg-deb --extract "$deb" "$folder"
  ! command -v lintian >/dev/null || lintian --fail-on error "$deb"
done

hash_of_run() { (cd / && "$folder/usr/bin/pantin" run chain --until 1) | sed -n 's/.*hash //p'; }
wide=$(hash_of_run)
rm "$folder"/usr/libexec/pantin/x86-64-v3/pantin
plain=$(hash_of_run)
echo "hash of the wide program: $wide, of the other: $plain"
[ "$wide" ] && [ "$wide" = "$plain" ]
