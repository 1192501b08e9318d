#!/bin/sh
# fetch_headers.sh DEST: ESyS-Particle's headers, which Debian's package leaves out, from the source
# archive of the installed version, from where the package came. Done already, it does nothing.
set -eu

dest=${1:?usage: fetch_headers.sh DEST}
known="2.3.5+dfsg2 ea2746adc860ee7febd410c5eaf97052ee8fbfd2577ed0eaa1ab2c45c297e585"
version=$(dpkg-query -W -f '${source:Upstream-Version}' esys-particle 2>/dev/null) || {
  echo "fetch_headers.sh: package esys-particle is not installed" >&2
  exit 1
}
if [ "$(cat "$dest/.version" 2>/dev/null)" = "$version" ]; then exit 0; fi
if [ "$version" != "${known% *}" ]; then
  echo "fetch_headers.sh: esys-particle is $version, known is ${known% *}" >&2
  exit 1
fi

archive=esys-particle_$version.orig.tar.xz
site=$(apt-cache policy esys-particle | awk '$2 ~ /^http/ {print $2; exit}')
mkdir -p "$dest"
work=$(mktemp -d "$dest/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT INT TERM
/usr/lib/apt/apt-helper download-file "${site:-http://deb.debian.org/debian}/pool/main/e/esys-particle/$archive" \
  "$work/$archive" "SHA256:${known#* }" >/dev/null
tar -xf "$work/$archive" -C "$dest" --strip-components=1 --wildcards '*.h' '*.hpp'
echo "$version" >"$dest/.version"
