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
    commands=$("$bin/vestige-cli" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\).*/\1/p')
    for command in $commands; do
        if [ "$1" = "$command" ]; then exec "$bin/vestige-cli" "$@"; fi
    done
    exec "$bin/vestige" "$@"
fi

# The sample case is the scene under trees, with handheld scans; the open road lies beside it.
if [ ! -e "$sample/.complete" ]; then
    echo "making the sample case in build/sample (some minutes)" >&2
    rm -rf "$sample"
    "$bin/vestige-cli" simulate bicycle --out "$sample"
    "$bin/vestige-cli" simulate two-cars --out "$sample/two-cars"
    touch "$sample/.complete"
fi

if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
    exec "$bin/vestige" "$sample/case.json"
fi
"$bin/vestige-cli" reconstruct "$sample/case.json" --out "$here/out/sample"
"$bin/vestige-cli" reconstruct "$sample/two-cars/case.json" --out "$here/out/sample/two-cars"
echo "the reports are out/sample/report.pdf and out/sample/two-cars/report.pdf" >&2
