#!/bin/sh
# Installs what building and testing need from Debian's packages. Does nothing where all is there;
# says what it will do before it does it; works as root and through sudo.
set -eu

needed="g++ make premake4 liblua5.3-dev lua5.3 libglm-dev liblodepng-dev libopenimageio-dev zlib1g-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev doctest-dev python3 ninja-build
  libmicrohttpd-dev"

missing=""
for package in $needed; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "Installing from Debian:$missing"
as_root=""
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "These packages are missing, and there is no sudo to install them with:$missing" >&2
        exit 1
    }
    as_root=sudo
fi
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -q
# shellcheck disable=SC2086 # a list of words
$as_root apt-get install -y -q --no-install-recommends $missing
