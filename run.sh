#!/usr/bin/env bash
# Installs what is missing, builds, makes the sample case, and opens it (with a display) or reconstructs it (without).
# With arguments: passes them to vestige-cli if the first is one of its commands, else to vestige.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
"$here/packaging/install.sh"
"$here/packaging/build.sh" release
bin=$here/build/release/bin
sample=$here/build/sample

if [ $# -gt 0 ]; then
    if [[ $1 == -* ]] || "$bin/vestige-cli" --help | grep -qE "^  $1( |$)"; then
        if [[ $1 != -* ]]; then exec "$bin/vestige-cli" "$@"; fi
    fi
    exec "$bin/vestige" "$@"
fi

if [ ! -e "$sample/.complete" ]; then
    echo "making the sample case in build/sample (a few minutes)" >&2
    rm -rf "$sample"
    "$bin/vestige-cli" simulate two-cars --out "$sample/two-cars"
    "$bin/vestige-cli" simulate bicycle --out "$sample/bicycle"
    touch "$sample/.complete"
fi

if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
    exec "$bin/vestige" "$sample/bicycle/case.json"
fi
for scene in two-cars bicycle; do
    "$bin/vestige-cli" reconstruct "$sample/$scene/case.json" --out "$here/out/sample/$scene"
done
