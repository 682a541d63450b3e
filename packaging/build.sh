#!/usr/bin/env bash
# Configures where needed and builds a preset (default: release). Output on stderr, so that callers own stdout.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ -e "build/$preset/build.ninja" ] || cmake --preset "$preset" >&2
cmake --build "build/$preset" -- -j "$(nproc)" >&2
