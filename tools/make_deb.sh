#!/bin/sh
# make_deb.sh [FOLDER]: builds and makes a Debian package in FOLDER (build/package). Needs dpkg-dev.
# OpenImageIO and libmicrohttpd are recommended: without them the program renders PNG and PFM, and
# says what to install for the rest.
set -eu
cd "$(dirname "$0")/.."
folder=${1:-build/package}
root=$folder/root
command -v dpkg-shlibdeps > /dev/null || { echo "make_deb.sh: dpkg-dev is missing" >&2; exit 1; }
sh tools/build.sh release Project rt_oiio rt_preview

rm -rf "$root" "$folder/debian"
mkdir -p "$folder/debian" "$root/DEBIAN"
PREFIX=/usr DESTDIR=$(realpath "$root") ZSH_FOLDER=share/zsh/vendor-completions sh tools/install.sh install
gzip -9n "$root/usr/share/man/man1/Project.1"

# dpkg-shlibdeps wants to stand beside a debian/control.
printf 'Source: project\n\nPackage: project\nArchitecture: any\n' > "$folder/debian/control"
libraries=$(cd "$folder" && dpkg-shlibdeps -O --ignore-missing-info -dDepends -eroot/usr/bin/Project \
    -dRecommends -eroot/usr/lib/project/librt_oiio.so -eroot/usr/lib/project/librt_preview.so 2> /dev/null)
# of KIND: the packages, as dpkg-shlibdeps lists them.
of() { echo "$libraries" | sed -n "s/^shlibs:$1=//p"; }

version=$(./Project --version | cut -d' ' -f2)
architecture=$(dpkg --print-architecture)
cat > "$root/DEBIAN/control" << CONTROL
Package: project
Version: $version
Architecture: $architecture
Maintainer: ${DEBFULLNAME:-Project} <${DEBEMAIL:-project@localhost}>
Installed-Size: $(du -sk "$root/usr" | cut -f1)
Depends: $(of Depends)
Recommends: $(of Recommends)
Section: graphics
Priority: optional
Description: ray tracer with a Lua scene language
 Renders scenes that are written in Lua, as exact as asked for, and says how
 exact the picture is. The same bytes for any number of threads.
CONTROL
(cd "$root" && find usr -type f -print0 | sort -z | xargs -0 md5sum > DEBIAN/md5sums)

# The time of the last commit, so that the same source is the same package.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || date +%s)}
export SOURCE_DATE_EPOCH
find "$root" -exec touch -hcd "@$SOURCE_DATE_EPOCH" {} +
package=$folder/project_${version}_$architecture.deb
dpkg-deb --root-owner-group --build "$root" "$package" > /dev/null
rm -rf "$root" "$folder/debian"
echo "$package"
