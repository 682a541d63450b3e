#!/usr/bin/env python3
"""Pictures against those that were looked at and kept, one line each.

baselines_test.py VESTIGE_CLI            compares
baselines_test.py VESTIGE_CLI --update   draws them anew: look at each before it is kept
"""
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from png import picture

CLI = sys.argv[1]
KEPT = Path(__file__).resolve().parent.parent / "data" / "pictures"
# Share of full brightness by which pixels may differ on average: letters and edges of another Mesa or font.
TOLERANCE = 0.02

PICTURES = {
    "perspective": [],
    "top": ["--view", "top"],
    "front": ["--view", "front"],
    "right": ["--view", "right"],
    "iso-light": ["--view", "iso", "--theme", "light"],
    "height-viridis": ["--color", "height", "--map", "viridis"],
    "height-range": ["--color", "height", "--range", "10,11"],
    "intensity": ["--color", "intensity"],
    "layers": ["--color", "source"],
    "grid-north": ["--view", "top", "--grid", "--north"],
    "section": ["--section", "2,2,9,6,6,12,30"],
    "section-inside-away": ["--section", "2,2,9,6,6,12", "--section-invert"],
    "scale": ["--view", "top", "--scale", "50", "--dpi", "72"],
    "near-larger": ["--size-by-distance", "--point-size", "3"],
    "tinted": ["--overlay", "registration"],
}


def write_scene(folder):
    """A road with a mark of another brightness, and a box that stands on it: no chance in it."""
    road = [(0.08 * i, 0.08 * j, 10 + 0.02 * math.sin(0.3 * i), 200 if 40 < i < 46 else 60)
            for i in range(120) for j in range(90)]
    faces = [(u, v) for u in range(40) for v in range(30)]
    box = ([(3 + 0.05 * u, 3, 10 + 0.05 * v, 120) for u, v in faces] +
           [(3, 3 + 0.05 * u, 10 + 0.05 * v, 140) for u, v in faces] +
           [(3 + 0.05 * u, 3 + 0.05 * v, 11.5, 160) for u in range(40) for v in range(40)])
    files = []
    for name, points in (("road", road), ("box", box)):
        files.append(folder / f"{name}.csv")
        files[-1].write_text("x,y,z,intensity\n" + "".join("%.4f,%.4f,%.4f,%d\n" % point for point in points))
    return files


def draw(files, out, options):
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    size = [] if "--scale" in options else ["--size", "320x220"]
    done = subprocess.run([CLI, "--quiet", "screenshot", *map(str, files), "--out", str(out), *size, *options],
                          capture_output=True, text=True, timeout=120, env=environment)
    if done.returncode != 0:
        raise AssertionError(f"{options}: exit {done.returncode}\n{done.stderr}")


class Baselines(unittest.TestCase):
    def test_pictures_are_as_they_were_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            files = write_scene(Path(folder))
            for name, options in PICTURES.items():
                with self.subTest(name):
                    out = Path(folder) / f"{name}.png"
                    draw(files, out, options)
                    width, height, rows = picture(out)
                    kept_width, kept_height, kept = picture(KEPT / f"{name}.png")
                    self.assertEqual((width, height), (kept_width, kept_height))
                    apart = sum(abs(a - b) for row, other in zip(rows, kept) for one, two in zip(row, other)
                                for a, b in zip(one, two))
                    self.assertLess(apart / (3 * 255 * width * height), TOLERANCE)

    def test_every_picture_differs_from_every_other(self):
        kept = {name: (KEPT / f"{name}.png").read_bytes() for name in PICTURES}
        self.assertEqual(len(set(kept.values())), len(kept), "a picture that shows nothing of its own proves nothing")


if __name__ == "__main__":
    if "--update" in sys.argv:
        KEPT.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as place:
            scene = write_scene(Path(place))
            for title, wanted in PICTURES.items():
                draw(scene, KEPT / f"{title}.png", wanted)
    else:
        unittest.main(argv=sys.argv[:1])
