#!/bin/sh
# unit_tests.sh TESTS: runs the unit tests of a build, a chunk of them on each core at a time.
set -eu
chunk=25
count=$("$1" --count | sed -n 's/.*unskipped test cases passing the current filters: *//p')
[ "$count" -gt 0 ]
seq 1 "$chunk" "$count" | xargs -P "$(nproc)" -I FIRST sh -c \
    '"$0" --minimal --first=FIRST --last=$((FIRST + $1 - 1)) || exit 1' "$1" "$chunk"
echo "$count test cases passed"
