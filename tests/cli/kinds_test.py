#!/usr/bin/env python3
"""Kinds of measurement from outside: a case with picks that are known, and every figure and budget recomputed here.

kinds_test.py VESTIGE_CLI
"""
import csv
import hashlib
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]


def cli(*arguments):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, env=environment)


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def circle_through(points):
    """Centre and radius by three points, written apart from the program."""
    (ax, ay, _), (bx, by, _), (cx, cy, _) = points
    d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
    ux = ((ax**2 + ay**2) * (by - cy) + (bx**2 + by**2) * (cy - ay) + (cx**2 + cy**2) * (ay - by)) / d
    uy = ((ax**2 + ay**2) * (cx - bx) + (bx**2 + by**2) * (ax - cx) + (cx**2 + cy**2) * (bx - ax)) / d
    return math.hypot(ax - ux, ay - uy)


class Kinds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        source = random.Random(5)
        with open(cls.folder / "scan.xyz", "w") as stream:
            for _ in range(20000):
                x, y = source.uniform(-10, 10), source.uniform(-10, 10)
                stream.write(f"{x:.4f} {y:.4f} {source.gauss(0.3, 0.005):.4f}\n")
        near = lambda points: [[[c + source.gauss(0, 0.004) for c in p] for p in points] for _ in range(3)]
        cls.arc = near([[30 * math.sin(a), 30 * math.cos(a) - 30, 0] for a in (-0.25, 0, 0.25)])
        cls.skid = near([[-5, 0, 0], [0, 1, 0], [4, 1, 0.1]])
        cls.crush = near([[0, 0, 0.5], [1.8, 0, 0.5], *[[0.36 * i, 0.1 + 0.05 * i, 0.5] for i in range(6)]])
        cls.outline = [[[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]] * 2
        cls.bar = near([[0, 0, 0], [2, 0, 0]])
        cls.case = {
            "vestige": 1, "name": "Kinds",
            "layers": [{"id": "scan", "role": "aerial", "path": "scan.xyz", "unit": "m"}],
            "measurements": [
                {"object": "Yaw", "kind": "arc", "settings": {"drag_factor": 0.7}, "paths": {"scan": cls.arc}},
                {"object": "Skid", "kind": "polyline", "tape_m": 9, "paths": {"scan": cls.skid}},
                {"object": "Front", "kind": "crush", "paths": {"scan": cls.crush}},
                {"object": "Heap", "kind": "volume", "settings": {"level_base": 1}, "paths": {"scan": cls.outline}},
                {"object": "Bar", "tape_m": 2, "check_tolerance_m": 0.02, "picks": {"scan": cls.bar}},
            ]}
        cls.out = cls.run_case(cls.case, "out")
        cls.figures = {(r["object"], r["quantity"]): r for r in rows_of(cls.out / "quantities.csv")}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def run_case(cls, case, name):
        file = cls.folder / f"{name}.json"
        file.write_text(json.dumps(case))
        cls.done = cli("reconstruct", file, "--out", cls.folder / name, "--json")
        if cls.done.returncode != 0:
            raise AssertionError(cls.done.stderr)
        cls.told = json.loads(cls.done.stdout)
        return cls.folder / name

    def mean(self, name, quantity):
        return float(self.figures[name, quantity]["mean"])

    def test_figures_recomputed_from_the_picks(self):
        self.assertAlmostEqual(self.mean("Yaw", "radius_fit"), statistics.mean(map(circle_through, self.arc)), 6)
        speed = statistics.mean(3.6 * math.sqrt(9.80665 * 0.7 * circle_through(arc)) for arc in self.arc)
        self.assertAlmostEqual(self.mean("Yaw", "speed_fit"), speed, 6)
        length = statistics.mean(math.dist(p[0], p[1]) + math.dist(p[1], p[2]) for p in self.skid)
        self.assertAlmostEqual(self.mean("Skid", "length"), length, 9)
        self.assertAlmostEqual(self.mean("Front", "c4"), 0.25, 1)
        self.assertAlmostEqual(self.mean("Heap", "volume"), 16 * 0.3, 1)

    def test_lengths_of_other_kinds_are_rows_with_a_relative_error(self):
        rows = {r["object"]: r for r in rows_of(self.out / "measurements.csv")}
        self.assertEqual(list(rows["Skid"])[-4:], ["kind", "horizontal_m", "vertical_m", "small"])
        self.assertEqual(rows["Skid"]["kind"], "polyline")
        self.assertAlmostEqual(float(rows["Skid"]["re"]), self.mean("Skid", "length") / 9 - 1, 12)
        self.assertNotIn("Heap", rows)
        accuracy = rows_of(self.out / "accuracy.csv")[0]
        self.assertEqual(accuracy["n"], "2")

    def test_budgets_add_up(self):
        lines = rows_of(self.out / "uncertainty.csv")
        for (name, quantity), row in self.figures.items():
            mine = [r for r in lines if r["object"] == name and r["quantity"] == quantity]
            parts = [float(r["contribution"]) for r in mine]
            u = math.sqrt(sum(p * p for p in parts))
            if row["standard_uncertainty"]:
                self.assertAlmostEqual(float(row["standard_uncertainty"]), u, 9, (name, quantity))
            if u > 0:
                self.assertAlmostEqual(sum(float(r["share"]) for r in mine), 1, 9, (name, quantity))
            for r in mine:
                self.assertAlmostEqual(float(r["contribution"]),
                                       float(r["standard_uncertainty"]) * abs(float(r["sensitivity"])), 9)

    def test_outputs_are_hashed(self):
        manifest = (self.out / "manifest.json").read_text()
        for name in ("quantities.csv", "uncertainty.csv"):
            self.assertIn(hashlib.sha256((self.out / name).read_bytes()).hexdigest(), manifest)

    def test_verified_only_by_a_known_distance_that_agrees(self):
        case = json.loads(json.dumps(self.case))
        self.run_case(case, "passed")
        self.assertEqual(self.told["checks"]["verification"], "verified")
        case["measurements"][-1]["tape_m"] = 2.5
        self.run_case(case, "failed")
        self.assertEqual(self.told["checks"]["verification"], "failed")
        self.assertEqual(self.told["checks"]["known_distances"][0]["verdict"], "failed")
        self.assertIn("WARNING: known distance failed: Bar by lidar", self.done.stderr)
        self.assertTrue(any("known distance failed" in w for w in self.told["warnings"]))
        del case["measurements"][-1]["check_tolerance_m"]
        self.run_case(case, "open")
        self.assertEqual(self.told["checks"], {"verification": "not verified", "known_distances": []})


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)
