#!/usr/bin/env python3
"""Times readers on the same files, round after round, and prints a table of them.

loading.py BIN FILE... [--rounds N]     BIN: the folder of load_one, load_pcl, load_open3d. CloudCompare is taken from the PATH;
its time is that of the whole program less what it takes on a cloud of eight points, for it tells no other.
"""
import argparse
import os
import re
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

LINE = re.compile(r"([0-9.e+-]+) s, (\d+)(?:, peak (\d+) MiB)?")


def timed(command):
    """(seconds, points, MiB) as the program tells them; None where it cannot read the file."""
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    found = LINE.search(run.stdout)
    if run.returncode != 0 or not found:
        return None
    return float(found[1]), int(found[2]), int(found[3]) if found[3] else None


def cloud_compare(program, file):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    begin = time.perf_counter()
    run = subprocess.run(["/usr/bin/env", "time", "-f", "%M", program, "-SILENT", "-AUTO_SAVE", "OFF", "-O", "-GLOBAL_SHIFT", "AUTO",
                          str(file)], env=environment, capture_output=True, text=True, check=False)
    seconds = time.perf_counter() - begin
    if "[Load]" in run.stdout + run.stderr:  # what it says of files it has no reader for
        return None
    memory = re.search(r"(\d+)\s*$", run.stderr)
    return seconds, 0, int(memory[1]) // 1024 if memory else None


def peers(binaries, file):
    ours = binaries / "load_one"
    kind = file.suffix
    yield "plain read()", lambda: timed([ours, "read", file])
    yield "Vestige, drawn attributes", lambda: timed([ours, "ours", file])
    yield "Vestige, all attributes", lambda: timed([ours, "ours-all", file])
    yield "Vestige with its index", lambda: timed([ours, "index", file])
    if kind in (".las", ".laz"):
        yield "Vestige, first picture", lambda: timed([ours, "preview", file])
    if kind == ".laz":
        yield "LASzip, one thread", lambda: timed([ours, "laszip", file])
    if kind in (".ply", ".pcd"):
        if (binaries / "load_pcl").exists():
            yield "PCL", lambda: timed([binaries / "load_pcl", file])
        if (binaries / "load_open3d").exists():
            yield "Open3D", lambda: timed([binaries / "load_open3d", file])
    program = shutil.which("CloudCompare") or shutil.which("cloudcompare.CloudCompare")
    if program and kind != ".pcd":
        tiny = Path(tempfile.gettempdir()) / "eight.xyz"
        tiny.write_text("".join(f"{i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8)))

        def compare():
            empty = cloud_compare(program, tiny)[0]
            result = cloud_compare(program, file)
            return result and (result[0] - empty, *result[1:])

        yield "CloudCompare", compare


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binaries", type=Path)
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--rounds", type=int, default=3)
    wanted = parser.parse_args()
    print("| file | reader | median s | least s | times Vestige: median | peak MiB |\n|---|---|---|---|---|---|")
    for file in wanted.files:
        contestants = list(peers(wanted.binaries.resolve(), file.resolve()))
        with open(file, "rb") as content:  # the file is in the system's memory for everyone
            while content.read(1 << 24):
                pass
        results = {name: [] for name, _ in contestants}
        for _ in range(wanted.rounds):
            for name, run in contestants:
                result = run()
                if result:
                    results[name].append(result)
        ours = statistics.median(r[0] for r in results["Vestige, drawn attributes"])
        size = file.stat().st_size / 1e6
        for name, rounds in results.items():
            if not rounds:
                print(f"| {file.name}, {size:.0f} MB | {name} | cannot read it | | | |")
                continue
            median = statistics.median(r[0] for r in rounds)
            memory = max((r[2] or 0) for r in rounds) or ""
            print(f"| {file.name}, {size:.0f} MB | {name} | {median:.3f} | {min(r[0] for r in rounds):.3f} | {median / ours:.2f} | {memory} |",
                  flush=True)


if __name__ == "__main__":
    main()
