#!/bin/sh
# test.sh: sets up, builds, and runs all tests; the last line counts what passed and what failed.
# test.sh --quick leaves out the sanitizer builds.
set -u
cd "$(dirname "$0")/.." || exit 1
passed=0
failed=0
names=

# check NAME COMMAND...: runs one suite and counts it.
check() {
    name=$1
    began=$(date +%s)
    shift
    echo "== $name"
    if "$@"; then
        passed=$((passed + 1))
        echo "$(($(date +%s) - began)) s: $name"
    else
        failed=$((failed + 1))
        names="$names; $name"
        echo "FAILED: $name"
    fi
}

# sanitized COMMAND...: sanitizers stop at the first report. The leak checker takes what lies before a
# loaded library's thread-local memory for its size, and may crash, unless it leaves that memory alone.
sanitized() {
    ASAN_OPTIONS=abort_on_error=0:detect_leaks=1:intercept_tls_get_addr=0 \
        UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS=halt_on_error=1 "$@"
}

sh tools/setup.sh || exit 1
check "build (release)" sh tools/build.sh release
check "include rules" lua5.3 tests/architecture/include_rules.lua
check "sealed kernels" sh tests/architecture/sealed_kernels.sh
check "unit and analytic tests" tools/unit_tests.sh build/release/tests
check "certified ray cases" python3 tests/vectors/check.py build/intersect
check "the program from outside" python3 tests/end_to_end/run.py ./Project
check "bad input and faults" python3 tests/faults/run.py ./Project
check "failing allocations" python3 tests/faults/allocations.py ./Project --step 7
check "golden images" ./Project golden tests/golden --report build/golden_report
check "planted faults" python3 tests/golden/planted_faults.py ./Project
check "stress, 30 seconds of fresh cases" python3 tests/stress/run.py --seconds 30
check "soak, random scenes" python3 tests/stress/soak.py --scenes 40
check "killed renders" python3 tests/stress/resume_kills.py --kills 8
if [ "${1:-}" != --quick ]; then
    check "build (address and undefined behaviour sanitizers)" \
        sh tools/build.sh sanitize tests Project rt_oiio rt_preview
    # Statistics of many pictures execute what single ones do.
    check "unit and analytic tests, sanitized" sanitized tools/unit_tests.sh build/sanitize/tests \
        "--test-case-exclude=unbiased:*,*keep their error*"
    check "the program from outside, sanitized" \
        sanitized python3 tests/end_to_end/run.py build/sanitize/Project
    check "bad input and faults, sanitized" \
        sanitized python3 tests/faults/run.py build/sanitize/Project
    check "soak, sanitized" python3 tests/stress/soak.py --scenes 10 --project build/sanitize/Project
    check "build (thread sanitizer)" sh tools/build.sh threads Project
    check "rendering, thread-sanitized" sanitized python3 tests/end_to_end/run.py \
        build/threads/Project --only threads
    check "killed renders, thread-sanitized" sanitized python3 tests/stress/resume_kills.py \
        --kills 4 --size 60x45 --project build/threads/Project
fi
echo "$passed passed, $failed failed$names"
[ "$failed" -eq 0 ]
