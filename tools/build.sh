#!/bin/sh
# build.sh [CONFIG [TARGET...]]: sets up, then builds; CONFIG is release, debug, sanitize or threads.
set -eu
cd "$(dirname "$0")/.."
sh tools/setup.sh
config=${1:-release}
[ $# -eq 0 ] || shift
premake4 gmake >/dev/null
make -s -j"$(nproc)" config="$config" "$@"
