#!/bin/sh
# unit_tests.sh TESTS [FILTER...]: runs the unit tests of a build, or those that doctest's options leave, a chunk of
# them on each core at a time; prints the output of the chunks that failed, and then, as the last lines, what failed
# in them.
set -eu
chunk=25
tests=$1
shift
count=$("$tests" "$@" --count | sed -n 's/.*unskipped test cases passing the current filters: *//p')
[ "$count" -gt 0 ]
outputs=$(mktemp -d)
trap 'rm -rf "$outputs"' EXIT
# shellcheck disable=SC2016 # the inner shell expands its own arguments
seq 1 "$chunk" "$count" | xargs -P "$(nproc)" -I FIRST sh -c \
    'tests=$0 outputs=$1 last=$((FIRST + $2 - 1)) && shift 2 &&
     "$tests" "$@" --minimal --first=FIRST --last=$last >"$outputs/FIRST" 2>&1 && rm "$outputs/FIRST"' \
    "$tests" "$outputs" "$chunk" "$@" || {
    cat "$outputs"/*
    echo "== what failed"
    grep -hE -A 3 'ERROR|Sanitizer|runtime error' "$outputs"/* | tail -n 60
    exit 1
}
echo "$count test cases passed"
