#!/bin/sh
# make_gallery.sh [options of ./Project]: renders every scene into Documentation/images; run it in the root.
# Without options the estimated error of each picture is 0.005.
set -e
project=${PROJECT:-./Project}
images=Documentation/images
[ $# -gt 0 ] || set -- --error 0.005
mkdir -p $images
for scene in scenes/*.lua; do
    name=$(basename "$scene" .lua)
    size=448x252
    [ "$name" = first_light ] && size=800x450
    [ "$name" = room ] && size=1280x720
    "$project" "$scene" -q --size $size -o "$images/$name.png" "$@"
done
for scene in scenes/objectives/*.lua; do
    name=$(basename "$scene" .lua)
    "$project" "$scene" -q --size 448x252 -o "$images/objective_$name.png" "$@"
    [ "$name" = multithreading ] || "$project" "$scene" -q --size 448x252 -D without=true -o "$images/objective_${name}_without.png" "$@"
done
# Scenes of the older form say their own sizes, and may hold several pictures; readobj.lua is a module.
for scene in scenes/a4/*.lua; do
    name=$(basename "$scene" .lua)
    [ "$name" = readobj ] || "$project" "$scene" -q -o "$images/a4_${name}_#.png" "$@"
done
