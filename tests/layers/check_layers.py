#!/usr/bin/env python3
"""Holds the tree against the rules that a reader relies on: arrows between rooms, foreign headers, file sizes, words.

check_layers.py ROOT      exit 1 and a line per offence
"""
import re
import statistics
import sys
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
FORBIDDEN_HEADERS = ("QtWidgets", "opencv2/opencv.hpp", "pcl/visualization/pcl_visualizer.h")
# word: the folder that may have it none the less (a benchmark compares with PCL compiled anew, apart from our code)
FORBIDDEN_WORDS = {"DISABLED_": None, "PCL_NO_PRECOMPILE": "tests/bench/peers"}


def table(path):
    rows = {}
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            name, _, rest = line.rpartition(": ") if ": " in line else (line.rstrip(":"), "", "")
            rows[name.rstrip(":")] = rest.split()
    return rows


def room_of(relative):
    parts = relative.parts
    return "/".join(parts[:2]) if parts[0] in ("core", "ui", "app") and len(parts) > 2 else None


def check_arrows(relative, text, arrows):
    room = room_of(relative)
    if room is None:
        return
    if room not in arrows:
        yield f"{relative}: the room {room} is not in tests/layers/arrows.txt"
        return
    for quoted, _ in INCLUDE.findall(text):
        if not quoted.startswith(("core/", "ui/", "app/", "tests/")):
            continue
        seen = "/".join(quoted.split("/")[:2])
        allowed = seen == room or seen in arrows[room] or seen.split("/")[0] + "/*" in arrows[room]
        if not allowed:
            yield f"{relative}: includes {quoted}, but {room} may not see {seen}"


def check_foreign(relative, text, foreign):
    for _, header in INCLUDE.findall(text):
        if header in FORBIDDEN_HEADERS:
            yield f"{relative}: <{header}> costs every build seconds; include what is used"
        for pattern, folders in foreign.items():
            if re.search(pattern, header) and not any(relative.is_relative_to(folder) for folder in folders):
                yield f"{relative}: <{header}> belongs in {' or '.join(folders)} only"
    if relative.parts[0] == "core" and relative.suffix == ".h":
        for _, header in INCLUDE.findall(text):
            if "/" in header and not header.startswith(("Eigen/", "tl/", "nlohmann/json_fwd")):
                yield f"{relative}: <{header}> in a header of core; only std, Eigen and own types stand there"


def check_words(relative, text):
    for word, folder in FORBIDDEN_WORDS.items():
        if word in text and not (folder and relative.is_relative_to(folder)):
            yield f"{relative}: contains {word}"


def check_sizes(sizes):
    ordered = sorted(sizes.values())
    for relative, lines in sizes.items():
        if lines > 600:
            yield f"{relative}: {lines} lines; no file has over 600"
    if ordered and statistics.median(ordered) > 110:
        yield f"the median file has {statistics.median(ordered)} lines; at most 110"
    if ordered and ordered[int(0.9 * (len(ordered) - 1))] > 350:
        yield f"nine in ten files should have at most 350 lines, not {ordered[int(0.9 * (len(ordered) - 1))]}"


def main(root):
    arrows = table(root / "tests/layers/arrows.txt")
    foreign = table(root / "tests/layers/foreign.txt")
    offences, sizes = [], {}
    for top in ("core", "ui", "app", "tests"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            relative = path.relative_to(root)
            text = path.read_text(encoding="utf-8")
            sizes[relative] = text.count("\n")
            offences += check_arrows(relative, text, arrows)
            offences += check_foreign(relative, text, foreign)
            offences += check_words(relative, text)
    offences += check_sizes(sizes)
    main_window = root / "ui/shell/MainWindow.cpp"
    if main_window.exists() and main_window.read_text().count("\n") > 350:
        offences.append("ui/shell/MainWindow.cpp: over 350 lines; it only assembles")
    print("\n".join(offences) if offences else f"{len(sizes)} files keep the rules")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
