#!/bin/sh
# try_package.sh: makes the Debian package, installs it into a clean Debian 12 and tries it there, first
# without what it recommends, then with it, and removes it again. Needs root, debootstrap, dpkg-dev and
# the network; takes minutes. MIRROR names another mirror than debootstrap's own.
set -eu
cd "$(dirname "$0")/../.."
[ "$(id -u)" -eq 0 ] || { echo "try_package.sh: needs root, for chroot" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
clean=$work/debian

# inside COMMAND...: in the clean system.
inside() { chroot "$clean" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
# check SENTENCE COMMAND...; what the last one said is in $work/output.
check() {
    sentence=$1
    shift
    if "$@" > "$work/now" 2>&1; then
        mv "$work/now" "$work/output"
        echo "ok: $sentence"
    else
        cat "$work/now" >&2
        echo "FAILED: $sentence" >&2
        exit 1
    fi
}
refuses() { ! "$@"; }

package=$(sh tools/make_deb.sh "$work/package" | tail -n 1)
dpkg-deb --field "$package" Package Version Depends Recommends
debootstrap --variant=minbase bookworm "$clean" ${MIRROR:+"$MIRROR"} > "$work/debootstrap.log" 2>&1 ||
    { tail "$work/debootstrap.log" >&2; exit 1; }
cp "$package" "$clean/tmp/project.deb"

inside apt-get install -y -q --no-install-recommends /tmp/project.deb > "$work/apt.log" 2>&1 ||
    { tail "$work/apt.log" >&2; exit 1; }
scene=/usr/share/project/scenes/first_light.lua
small="-q --size 64x48 --spp 4"
# shellcheck disable=SC2086 # options are words
check "renders a PNG" inside Project $scene $small -o /tmp/a.png
# A PFM does not say where its scene lay.
# shellcheck disable=SC2086
check "renders a PFM" inside Project $scene $small -o /tmp/a.pfm
# shellcheck disable=SC2086
check "renders with this build" ./Project scenes/first_light.lua $small -o "$work/b.pfm"
check "both are the same bytes" cmp "$work/b.pfm" "$clean/tmp/a.pfm"
# shellcheck disable=SC2086
check "a scene with meshes and images finds them" \
    inside Project /usr/share/project/scenes/bump_map.lua $small -o /tmp/c.png
# shellcheck disable=SC2086
check "refuses an EXR without OpenImageIO" refuses inside Project $scene $small -o /tmp/a.exr
check "and says what to install" grep -q "install libopenimageio" "$work/output"
./Project --print man > "$work/Project.1"
check "has its manual page" sh -c "zcat '$clean/usr/share/man/man1/Project.1.gz' | cmp - '$work/Project.1'"
for completion in bash-completion/completions/Project zsh/vendor-completions/_Project; do
    check "completes by $completion" test -s "$clean/usr/share/$completion"
done

recommended=$(dpkg-deb --field "$package" Recommends | tr ',' '\n' | sed 's/^ *//; s/ .*//')
# shellcheck disable=SC2086 # a list of words
inside apt-get install -y -q --no-install-recommends $recommended > "$work/apt.log" 2>&1 ||
    { tail "$work/apt.log" >&2; exit 1; }
# shellcheck disable=SC2086
check "writes an EXR with OpenImageIO" inside Project $scene $small -o /tmp/a.exr
check "the EXR has what the PFM has" inside Project compare /tmp/a.exr /tmp/a.pfm --tolerance 0
check "serves a preview" inside sh -c "timeout -s INT 3 Project $scene $small --preview --preview-port 0; test \$? = 124"
check "and says where" grep -q "Preview: http://127.0.0.1:" "$work/output"

check "is removed" inside apt-get remove -y -q project
check "leaves nothing behind" test ! -e "$clean/usr/share/project" -a ! -e "$clean/usr/lib/project"
echo "the package works in a clean Debian 12"
