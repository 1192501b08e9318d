#!/bin/sh
# fetch_headers.sh DEST: OpenFOAM's headers, which Debian's binary packages leave out, from the source
# package of the installed version. Leaves DEST/src (and the solver fragments); done already, it does
# nothing. Uses a private sources list and package state: the system's lists stay untouched.
set -eu

dest=${1:?usage: fetch_headers.sh DEST}
version=$(dpkg-query -W -f '${source:Version}' openfoam 2>/dev/null) || {
  echo "fetch_headers.sh: package openfoam is not installed" >&2
  exit 1
}
if [ "$(cat "$dest/.version" 2>/dev/null)" = "$version" ]; then exit 0; fi

mkdir -p "$dest"
dest=$(cd "$dest" && pwd)
work=$(mktemp -d "$dest/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT INT TERM
mkdir -p "$work/lists/partial" "$work/archives/partial" "$work/none"

# Where the installed package comes from, as "URI SUITE COMPONENT" lines.
origins() {
  apt-cache "$@" policy openfoam | awk '$3 ~ /\// && $5 == "Packages" {split($3, a, "/"); print $2, a[1], a[2]}' | sort -u
}
found=$(origins)
if [ -z "$found" ]; then  # the system's package lists are absent: private ones then
  apt-get -qq -o Dir::State::lists="$work/lists" update
  found=$(origins -o Dir::State::lists="$work/lists")
fi
[ -n "$found" ] || { echo "fetch_headers.sh: apt knows no source of package openfoam" >&2; exit 1; }

keyring=/usr/share/keyrings/debian-archive-keyring.gpg
signed=; [ -e "$keyring" ] && signed="[signed-by=$keyring] "
echo "$found" | sed "s|^|deb-src $signed|" >"$work/sources.list"
private="-o Dir::Etc::sourcelist=$work/sources.list -o Dir::Etc::sourceparts=$work/none
  -o Dir::State::lists=$work/lists -o APT::Sandbox::User=root -o pkgCacheFile= -o srcPkgCacheFile="
# shellcheck disable=SC2086
apt-get -qq $private update
# shellcheck disable=SC2086
(cd "$work" && apt-get -qq $private source --download-only "openfoam=$version")

# Only what the build includes: headers and the bodies of templates.
rm -rf "$dest/src"
tar -xf "$work"/openfoam_*.orig.tar.* -C "$dest" --strip-components=1 --wildcards --exclude='*/wmake' \
  '*/src/*.[CHch]'
echo "$version" >"$dest/.version"
