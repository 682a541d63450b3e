#!/usr/bin/env bash
# build.sh [PRESET [TARGET]]: configures where needed and builds (default: release, all). Output on stderr, so that callers own stdout.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ -e "build/$preset/build.ninja" ] || cmake --preset "$preset" >&2
cmake --build "build/$preset" ${2:+--target "$2"} -- -j "$(nproc)" >&2
