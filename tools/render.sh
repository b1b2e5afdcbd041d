#!/bin/sh
# render.sh [ARGUMENTS OF Project...]: sets up, builds, and renders; no argument renders project.lua.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
sh "$here/tools/build.sh" release Project rt_oiio rt_preview
[ $# -gt 0 ] || cd "$here"
exec "$here/Project" "$@"
