#!/usr/bin/env bash
# Runs a program of the desktop on an X server of its own, drawn by software. Skipped (exit 77) where Xvfb is missing.
# Usage: desktop_xvfb.sh PROGRAM [ARGUMENT...]
set -euo pipefail
if ! command -v xvfb-run >/dev/null || ! command -v Xvfb >/dev/null; then
    echo "skipped: Xvfb is not installed"
    exit 77
fi
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
unset WAYLAND_DISPLAY
exec xvfb-run --auto-servernum --server-args="-screen 0 1600x1000x24 +extension GLX" "$@"
