#!/usr/bin/env python3
"""Holds the translations against the tree.

check.py ROOT      exit 1 and a line per offence: a text without a translation, one that the tree does not have any more,
                   places or a mnemonic that do not fit
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import core_strings
import ts_file

HERE = Path(__file__).resolve().parent
PLACE = re.compile(r"%(?:L?\d+|n)")
MNEMONIC = re.compile(r"&(?=[^&\s])")
TAG = re.compile(r"<[^>]+>")
TROUBLE = re.compile(r"lacks Q_OBJECT|Unterminated|Unbalanced|unknown namespace")
CHINESE = re.compile(r"[\u3400-\u9fff]")
#: Of a translation without a Chinese character: figures, units, names and abbreviations alone.
ABBREVIATION = re.compile(r"^(?:[^A-Za-z]|\b(?:RGB|RMS|RMSE|RPE|RE|SD|ICP|NDT|SHA|mm|cm|km|min|Vestige|English|UTC|WGS|deg)\b|\b[A-Za-z]\b)*$")


def placed(text):
    return sorted(PLACE.findall(text))


def offences(name, source, translation):
    if not translation.strip():
        yield f"{name}: no translation of: {source!r}"
        return
    if placed(source) != placed(translation):
        yield f"{name}: other places than in {source!r}: {translation!r}"
    if len(MNEMONIC.findall(source)) != len(MNEMONIC.findall(translation)) and "&nbsp;" not in source:
        yield f"{name}: another mnemonic than in {source!r}: {translation!r}"
    if sorted(TAG.findall(source)) != sorted(TAG.findall(translation)):
        yield f"{name}: other tags than in {source!r}: {translation!r}"
    if not CHINESE.search(translation) and not ABBREVIATION.match(PLACE.sub("", translation)) and source == translation:
        yield f"{name}: not translated: {source!r}"


def window_texts(root):
    """{(context, source)} of the window's sources as lupdate finds them, and what it did not understand."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / "fresh.ts"
        command = ["lupdate", "-silent", "-no-obsolete", "-locations", "none", "-extensions", "cpp,h", "-I", root]
        command += [root / "ui", root / "app/workstation", "-ts", fresh]
        ran = subprocess.run(command, check=True, capture_output=True, text=True)
        # Their texts would be looked up in another context than lupdate notes, or not be seen at all.
        troubles = [line for line in (ran.stdout + ran.stderr).splitlines() if TROUBLE.search(line)]
        return {(context, source) for context, source, _, _ in ts_file.read(fresh)}, troubles


def compare(name, wanted, rows):
    held = {(context, source) for context, source, _, _ in rows}
    for _, source in sorted(wanted - held):
        yield f"{name}: missing, run update.sh: {source!r}"
    for _, source in sorted(held - wanted):
        yield f"{name}: the tree does not say any more, run update.sh: {source!r}"
    for _, source, translation, kind in rows:
        if kind == "unfinished" and translation:
            yield f"{name}: marked as unfinished: {source!r}"
        yield from offences(name, source, translation)


def main(root):
    window, troubles = window_texts(root)
    core = {(room, text) for text, room in core_strings.collect(root).items()}
    found = [
        *compare("core_zh_CN.ts", core, ts_file.read(HERE / "core_zh_CN.ts")),
        *(f"lupdate: {line}" for line in troubles),
        *compare("vestige_zh_CN.ts", window, ts_file.read(HERE / "vestige_zh_CN.ts")),
    ]
    for line in found:
        print(line)
    print(f"{len(core)} texts of core, {len(found)} to mend", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
