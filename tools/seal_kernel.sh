#!/bin/sh
# seal_kernel.sh LIBRARY ENTRY OBJECT...: joins the objects into one and hides every symbol but
# ENTRY, so that code compiled for one instruction set cannot be linked into another's place.
set -eu
library=$1
entry=$2
shift 2
joined=${library%.a}.o
ld -r --force-group-allocation -o "$joined" "$@"
objcopy --keep-global-symbol="$entry" "$joined"
nm "$joined" | grep -q " T $entry\$" || { echo "seal_kernel.sh: $entry is missing" >&2; exit 1; }
rm -f "$library"
ar rcs "$library" "$joined"
