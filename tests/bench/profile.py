#!/usr/bin/env python3
"""A Markdown table of the functions that take most of a recording's time.

profile.py PERF_DATA [PERCENT]      reads `perf report`; PERCENT is the least share shown (3)
"""
import re
import subprocess
import sys

LINE = re.compile(r"^\s*([0-9.]+)%\s+\[(.)\]\s+(.*?)\s*$")


def shorten(name):
    name = re.sub(r"\(anonymous namespace\)::|vestige::", "", name)
    if found := re.search(r"(\w+)(?:<[^()]*>)?\([^()]*\)(?: const)?::\{lambda\([^()]*\)#(\d+)\}", name):
        return f"{found[1]}, parallel part {found[2]}"
    return name if len(name) <= 90 else name[:87] + "..."


def main(data, least):
    report = subprocess.run(["perf", "report", "-i", data, "--stdio", "--no-children", "-F", "overhead,sym", "-g", "none"],
                            capture_output=True, text=True, check=True).stdout
    shares = {}
    for line in report.splitlines():
        if found := LINE.match(line):
            name = "the kernel (page faults, waits)" if found[2] == "k" else f"`{shorten(found[3])}`"
            shares[name] = shares.get(name, 0) + float(found[1])
    print("| share | function |\n|---|---|")
    for name, share in sorted(shares.items(), key=lambda item: -item[1]):
        if share >= least:
            print(f"| {share:.0f} % | {name} |")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 3)
