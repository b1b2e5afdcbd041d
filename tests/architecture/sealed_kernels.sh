#!/bin/sh
# Each instruction-set library may show the linker its entry and nothing else; a weak or unique symbol
# that slipped through could replace the same inline function in code for older processors.
set -eu
bad=0
for library in build/release/libkernel_*.a; do
    isa=${library##*libkernel_}
    isa=${isa%.a}
    visible=$(nm -g --defined-only "$library" | awk 'NF == 3 {print $3}')
    if [ "$visible" != "rtKernel_$isa" ]; then
        echo "$library shows more than rtKernel_$isa: $(echo "$visible" | head -5)" >&2
        bad=1
    fi
done
[ -n "${isa:-}" ] || { echo "no kernel libraries found" >&2; exit 1; }
echo "sealed kernels: $(ls build/release/libkernel_*.a | wc -l) libraries, violations: $bad"
exit $bad
