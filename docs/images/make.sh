#!/usr/bin/env bash
# Makes the pictures of the tutorial and of README anew, from the sample case: docs/images/make.sh [CASE]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
case=${1:-$root/build/sample/case.json}
hand=$(dirname "$case")/case-hand.json
# Settings of nobody: no recent files, dark, English.
XDG_CONFIG_HOME=$(mktemp -d)
export XDG_CONFIG_HOME
trap 'rm -rf "$hand" "$XDG_CONFIG_HOME"' EXIT
# The handheld scan alone, as the tutorial asks for.
python3 - "$case" "$hand" <<'PYTHON'
import json, sys
case = json.load(open(sys.argv[1]))
for layer in case["layers"]:
    layer["visible"] = layer["role"] == "handheld"
json.dump(case, open(sys.argv[2], "w"))
PYTHON
window() { "$root/build/release/bin/vestige-cli" --quiet screenshot --window --size 1400x875 --out "$here/$1.png" "${@:2}"; }
window tutorial-start
window tutorial-align "$case" --action register.run --action view.panel-align
window tutorial-clean "$case" --action register.run --action clean.objects --action view.panel-clean
window tutorial-measure "$hand" --action register.run --object "Right door handle" --action view.panel-measure --action view.object --action tool.distance
window tutorial-report "$case" --action register.run --action view.panel-report
window window "$case" --action register.run --action view.panel-measure
