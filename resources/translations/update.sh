#!/usr/bin/env bash
# Brings the translations up to the tree: new texts in (without a translation), texts that are gone out; then lists what is
# not translated. Fill the empty <translation> elements by hand or with Qt Linguist and run it again.
#
# resources/translations/update.sh
set -euo pipefail
cd "$(dirname "$0")"
root=$(cd ../.. && pwd)

# Without places in the source: they would change with every edit of a file.
lupdate -silent -no-obsolete -locations none -extensions cpp,h -I "$root" "$root/ui" "$root/app/workstation" -ts vestige_zh_CN.ts
python3 core_catalogue.py update "$root"
python3 check.py "$root"
