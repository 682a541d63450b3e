#!/usr/bin/env python3
"""Puts a table into a page between its marks.

insert.py PAGE NAME FILE     what stands between <!-- NAME --> and <!-- end NAME --> becomes FILE's text
"""
import sys
from pathlib import Path


def main(page, name, file):
    text = Path(page).read_text(encoding="utf-8")
    begin, end = f"<!-- {name} -->\n", f"<!-- end {name} -->\n"
    if begin not in text or end not in text.split(begin, 1)[1]:
        return f"{page}: no marks {begin.strip()} and {end.strip()}"
    before, rest = text.split(begin, 1)
    after = rest.split(end, 1)[1]
    Path(page).write_text(before + begin + "\n" + Path(file).read_text(encoding="utf-8").strip() + "\n\n" + end + after,
                          encoding="utf-8")
    return None


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
