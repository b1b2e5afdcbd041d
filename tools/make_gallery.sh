#!/bin/sh
# make_gallery.sh [NAME...]: renders every scene, or the named pictures again, and writes Documentation/gallery.html.
# Needs python3-pil.
set -e
cd "$(dirname "$0")/.."
exec "${PYTHON:-/usr/bin/python3}" tools/make_gallery.py "$@"
