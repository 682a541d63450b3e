#!/usr/bin/env bash
# Installs what is missing, builds and runs every test; ends with ctest's closing lines.
set -euo pipefail
cd "$(dirname "$0")"
packaging/install.sh
packaging/build.sh release
if command -v clang++-14 >/dev/null; then packaging/build.sh fuzz fuzz_targets; fi
exec ctest --test-dir build/release --output-on-failure --no-label-summary "$@"
