#!/bin/sh
# unit_tests.sh TESTS: runs the unit tests of a build, a chunk of them on each core at a time; prints the
# output of the chunks that failed, and then, as the last lines, what failed in them.
set -eu
chunk=25
count=$("$1" --count | sed -n 's/.*unskipped test cases passing the current filters: *//p')
[ "$count" -gt 0 ]
outputs=$(mktemp -d)
trap 'rm -rf "$outputs"' EXIT
# shellcheck disable=SC2016 # the inner shell expands its own arguments
seq 1 "$chunk" "$count" | xargs -P "$(nproc)" -I FIRST sh -c \
    '"$0" --minimal --first=FIRST --last=$((FIRST + $1 - 1)) >"$2/FIRST" 2>&1 && rm "$2/FIRST"' \
    "$1" "$chunk" "$outputs" || {
    cat "$outputs"/*
    echo "== what failed"
    grep -hE -A 3 'ERROR|Sanitizer|runtime error' "$outputs"/* | tail -n 60
    exit 1
}
echo "$count test cases passed"
