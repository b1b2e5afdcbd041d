#!/bin/sh
# make_examples.sh [options of ./Project]: renders Documentation/examples/*.lua into Documentation/images/language;
# run it in the root. Without options the estimated error of each picture is 0.003.
set -e
project=${PROJECT:-./Project}
images=Documentation/images/language
[ $# -gt 0 ] || set -- --error 0.003
mkdir -p $images
for script in Documentation/examples/*.lua; do
    name=$(basename "$script" .lua)
    [ "$name" = stage ] && continue
    # options.lua sets its own number of samples.
    if [ "$name" = options ]; then
        "$project" "$script" -q -o "$images/$name.png"
    else
        "$project" "$script" -q -o "$images/$name.png" "$@"
    fi
done
