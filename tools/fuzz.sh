#!/bin/sh
# fuzz.sh TARGET SECONDS [CORPUS]: runs libFuzzer on one of obj, image, scene, script, options, under
# AddressSanitizer and UndefinedBehaviorSanitizer; needs clang. What it finds stays in CORPUS, a folder
# (build/fuzz-corpus/TARGET); an input that crashes is kept beside that as crash-*.
# fuzz.sh build: builds all of them.
set -eu
cd "$(dirname "$0")/.."
build() {
    premake4 --fuzz gmake >/dev/null
    status=0
    make -s -j"$(nproc)" CXX="${CXX:-clang++}" config=sanitize "$@" || status=$?
    premake4 gmake >/dev/null
    return $status
}
if [ "${1:-}" = build ]; then
    build fuzz_obj fuzz_image fuzz_scene fuzz_script fuzz_options
    exit
fi
target=$1
seconds=$2
corpus=${3:-build/fuzz-corpus/$target}
program=build/fuzz-sanitize/fuzz_$target
[ -x "$program" ] || build "fuzz_$target"
mkdir -p "$corpus"
# Inputs go through files: in memory they go through a hundred times as fast.
[ ! -w /dev/shm ] || export TMPDIR="${TMPDIR:-/dev/shm}"
dictionary=""
[ ! -f "tests/fuzz/$target.dict" ] || dictionary="-dict=tests/fuzz/$target.dict"
# shellcheck disable=SC2086 # no option where there is no dictionary
exec "$program" $dictionary -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=4096 \
    -print_final_stats=1 -artifact_prefix="$(dirname "$corpus")/$target-" "$corpus" "tests/fuzz/corpus/$target"
