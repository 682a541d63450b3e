#!/usr/bin/env bash
# Installs what packaging/packages.txt lists and this machine lacks, and LASzip (build/laszip). Quick when all is there.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t wanted < <(grep -Ev '^\s*(#|$)' packaging/packages.txt)
missing=()
for package in "${wanted[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done

as_root=()
if [ "$(id -u)" != 0 ]; then as_root=(sudo); fi
if [ ${#missing[@]} -gt 0 ]; then
    echo "installing: ${missing[*]}" >&2
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" >&2
fi

if [ ! -e build/laszip/.complete ] && ! dpkg-query -W -f '${Status}' liblaszip-dev 2>/dev/null | grep -q 'ok installed'; then
    # Lists may be gone (container images delete them); they name the archive that LASzip is fetched from.
    if [ -z "$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)" ] ||
        ! ls /var/lib/apt/lists/*Packages* >/dev/null 2>&1; then
        "${as_root[@]}" apt-get update -qq
    fi
    "${as_root[@]}" apt-get install -y --only-upgrade debian-archive-keyring >&2 || true
    packaging/fetch-laszip.sh build/laszip
fi
