#!/usr/bin/env python3
"""core's catalogue of translations.

core_catalogue.py update ROOT          the texts of the tree into core_zh_CN.ts; translations stay, what is gone goes
core_catalogue.py compile TS OUT.cpp   the catalogue as C++ (at every build)
"""
import sys
from pathlib import Path

import core_strings
import ts_file

HERE = Path(__file__).resolve().parent


def update(root):
    path = HERE / "core_zh_CN.ts"
    known = {source: translation for _, source, translation, _ in ts_file.read(path)}
    rows = [(room, text, known.get(text, "")) for text, room in core_strings.collect(root).items()]
    ts_file.write(path, rows, "zh_CN")


def literal(text):
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def compile_to(ts, out):
    rows = sorted(
        (source.encode(), source, translation, context == "vocabulary")
        for context, source, translation, _ in ts_file.read(ts)
        if translation
    )
    lines = [
        "// Made from resources/translations at build time.",
        '#include "core/base/Catalogue.h"',
        "",
        "namespace vestige {",
        "namespace {",
        "",
        "constexpr CatalogueEntry kChinese[] = {",
        *(
            f"    {{{literal(source)}, {literal(translation)}{', true' if closed else ''}}},"
            for _, source, translation, closed in rows
        ),
        "    {},",
        "};",
        "",
        "}  // namespace",
        "",
        "std::span<const CatalogueEntry> catalogue(Language language) {",
        f"    if (language == Language::simplifiedChinese) return {{kChinese, {len(rows)}}};",
        "    return {};",
        "}",
        "",
        "}  // namespace vestige",
    ]
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "update":
        update(Path(sys.argv[2]).resolve())
    elif len(sys.argv) == 4 and sys.argv[1] == "compile":
        compile_to(Path(sys.argv[2]), Path(sys.argv[3]))
    else:
        sys.exit(__doc__)
