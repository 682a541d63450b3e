#!/usr/bin/env bash
# Puts LASzip (library and headers) where the build finds it. Debian 12 does not package it; the packages of the
# release after it run on Debian 12 unchanged, so they are unpacked into a private prefix and nothing of the system
# is touched. Usage: packaging/fetch-laszip.sh PREFIX
set -euo pipefail
prefix=$(realpath -m "$1")
stamp=$prefix/.complete
[ -e "$stamp" ] && exit 0
if dpkg -s liblaszip-dev >/dev/null 2>&1; then exit 0; fi
if apt-cache policy liblaszip-dev 2>/dev/null | grep -q 'Candidate: [0-9]'; then
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends liblaszip-dev && exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The archive that this machine itself uses for its own release.
mirror=$(apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    awk '$3 == "main" && $2 !~ /-(security|updates|backports)$/ && $2 ~ /^(bookworm|stable)$/ { print $1; exit }')
if [ -z "$mirror" ]; then
    echo "fetch-laszip: no Debian archive in this machine's apt configuration; run 'apt-get update' first" >&2
    exit 1
fi
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/etc" "$work/debs"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
echo "deb [signed-by=$keyring] $mirror trixie main" >"$work/etc/sources.list"
apt_private=(-o "Dir::Etc::sourcelist=$work/etc/sources.list" -o "Dir::Etc::sourceparts=/dev/null"
    -o "Dir::State::lists=$work/lists" -o "Dir::Cache=$work/cache" -o "APT::Sandbox::User=root")
apt-get "${apt_private[@]}" update -qq
(cd "$work/debs" && apt-get "${apt_private[@]}" download -qq liblaszip8/trixie liblaszip-dev/trixie)
rm -rf "$prefix"
mkdir -p "$prefix"
for deb in "$work"/debs/*.deb; do dpkg-deb -x "$deb" "$work/root"; done
triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
mkdir -p "$prefix/lib" "$prefix/include"
cp -a "$work/root/usr/include/laszip" "$prefix/include/"
cp -a "$work/root/usr/lib/$triplet/"liblaszip* "$prefix/lib/"
cp "$work/root/usr/share/doc/liblaszip8/copyright" "$prefix/LICENSE.laszip"
touch "$stamp"
