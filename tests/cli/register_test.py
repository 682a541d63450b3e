#!/usr/bin/env python3
"""`vestige-cli register` from outside, on clouds whose pose is known.

register_test.py VESTIGE_CLI
"""
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]
ANGLE = math.radians(4)
SHIFT = (0.25, -0.15, 0.05)
KEYS = {"method", "converged", "iterations", "seconds", "pose", "scale", "rmse_m", "overlap", "voxel_schedule_m"}


def run(*arguments):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=200, env=environment)


def cli(*arguments, code=0):
    done = run(*arguments)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


def yard(seed, count=12000):
    """Points on a floor of 12 x 10 m, two walls, three boxes of different size and a slope; 3 mm of noise."""
    chance = random.Random(seed)
    points = []

    def face(corner, a, b, share):
        for _ in range(int(count * share)):
            u, v = chance.random(), chance.random()
            points.append(tuple(corner[i] + u * a[i] + v * b[i] + chance.gauss(0, 0.003) for i in range(3)))

    face((-6, -5, 0), (12, 0, 0), (0, 10, 0), 0.35)
    face((-6, 5, 0), (12, 0, 0), (0, 0, 3), 0.15)
    face((6, -5, 0), (0, 10, 0), (0, 0, 2.5), 0.15)
    face((-6, -5, 0), (3, 0, 1), (0, 4, 0), 0.05)
    for x, y, w, d, h in ((-3, 1, 1.6, 0.9, 1.1), (1.5, -2.5, 4.2, 1.8, 1.4), (3.5, 2.5, 0.7, 0.7, 2.0)):
        face((x, y, h), (w, 0, 0), (0, d, 0), 0.02)
        face((x, y, 0), (w, 0, 0), (0, 0, h), 0.03)
        face((x, y, 0), (0, d, 0), (0, 0, h), 0.02)
        face((x + w, y, 0), (0, d, 0), (0, 0, h), 0.02)
    return points


def to_source(point):
    """The inverse of the true pose: rotation about z by ANGLE, then SHIFT."""
    x, y, z = (point[i] - SHIFT[i] for i in range(3))
    return (math.cos(ANGLE) * x + math.sin(ANGLE) * y, -math.sin(ANGLE) * x + math.cos(ANGLE) * y, z)


def write(path, points, scale=1):
    path.write_text("".join(f"{x * scale:.5f} {y * scale:.5f} {z * scale:.5f}\n" for x, y, z in points))


def write_las(path, points, metres_per_unit, unit):
    """LAS 1.2, point format 0, with GeoTIFF keys that name the unit by its EPSG code."""
    keys = struct.pack("<12H", 1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, unit)
    record = struct.pack("<H16sHH32s", 0, b"LASF_Projection", 34735, len(keys), b"") + keys
    rows = [tuple(round(value / metres_per_unit / 1e-4) for value in point) for point in points]
    ends = [value * 1e-4 for axis in range(3) for value in (max(r[axis] for r in rows), min(r[axis] for r in rows))]
    header = struct.pack("<4sHHIHH8sBB32s32sHHHIIBHI5I12d", b"LASF", 0, 0, 0, 0, 0, b"", 1, 2, b"", b"", 1, 2026, 227,
                         227 + len(record), 1, 0, 20, len(rows), len(rows), 0, 0, 0, 0, *[1e-4] * 3, *[0] * 3, *ends)
    path.write_bytes(header + record + b"".join(struct.pack("<3i8x", *row) for row in rows))


def points_of(path):
    found = []
    for line in path.read_text().splitlines():
        try:
            found.append(tuple(float(cell) for cell in line.split()[:3]))
        except ValueError:
            pass
    return found


class Register(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.target = Path(cls.made.name) / "target.xyz"
        cls.source = Path(cls.made.name) / "source.xyz"
        cls.source_points = [to_source(point) for point in yard(2)]
        write(cls.target, yard(1))
        write(cls.source, cls.source_points)

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.pose = self.folder / "pose.json"

    def expect_truth(self, pose, metres, degrees):
        self.assertEqual(len(pose), 16)
        self.assertEqual(pose[12:], [0, 0, 0, 1])
        for i in range(3):
            self.assertAlmostEqual(pose[4 * i + 3], SHIFT[i], delta=metres)
            for k in range(3):
                dot = sum(pose[4 * row + i] * pose[4 * row + k] for row in range(3))
                self.assertAlmostEqual(dot, float(i == k), places=9)
        self.assertAlmostEqual(math.atan2(pose[4], pose[0]), ANGLE, delta=math.radians(degrees))

    def test_finds_the_pose_and_writes_it(self):
        aligned = self.folder / "aligned.xyz"
        told = json.loads(cli("register", self.target, self.source, "--pose-out", self.pose, "--aligned", aligned,
                              "--json").stdout)
        self.assertLessEqual(KEYS, set(told))
        self.assertEqual(told["method"], "improved-ndt")
        self.assertEqual(told["scale"], 1)
        self.assertGreater(told["overlap"], 0.6)
        self.assertIn(told["verdict"], ("accepted", "doubtful"))
        self.assertEqual(told["voxel_schedule_m"][0], max(told["voxel_schedule_m"]))
        self.assertEqual(told["voxel_schedule_m"][-1], min(told["voxel_schedule_m"]))
        self.expect_truth(told["pose"], 0.01, 0.1)
        file = json.loads(self.pose.read_text())
        self.assertEqual(set(file), {"pose", "scale"})
        self.assertEqual((file["pose"], file["scale"]), (told["pose"], told["scale"]))
        moved = points_of(aligned)
        self.assertEqual(len(moved), len(self.source_points))
        pose = told["pose"]
        for before, after in list(zip(self.source_points, moved))[::97]:
            for i in range(3):
                there = sum(pose[4 * i + k] * before[k] for k in range(3)) + pose[4 * i + 3]
                self.assertAlmostEqual(after[i], there, delta=2e-4)

    def test_the_scanner_goes_where_its_points_go(self):
        # A scanner at (2, 1, 1.5) that is turned by 90 degrees; file = (2 - y, 1 + x, 1.5 + z), in millimetres.
        at = (2, 1, 1.5)
        scan, aligned = self.folder / "scan.ptx", self.folder / "aligned.e57"
        rows = [f"{len(self.source_points)}\n1", " ".join(str(1000 * v) for v in at), "0 1 0", "-1 0 0", "0 0 1",
                "0 1 0 0", "-1 0 0 0", "0 0 1 0", " ".join(str(1000 * v) for v in at) + " 1"]
        for x, y, z in self.source_points:
            rows.append(f"{1000 * (y - at[1]):.3f} {1000 * (at[0] - x):.3f} {1000 * (z - at[2]):.3f} 0.5")
        scan.write_text("\n".join(rows) + "\n")
        told = json.loads(cli("register", self.target, scan, "--unit", "mm", "--pose-out", self.pose, "--aligned",
                              aligned, "--json").stdout)
        self.expect_truth(told["pose"], 0.01, 0.1)
        file = json.loads(cli("info", "--json", aligned).stdout)["files"][0]
        pose = told["pose"]
        scanner = file["scans"][0]["pose"]
        for i in range(3):
            there = sum(pose[4 * i + k] * at[k] for k in range(3)) + pose[4 * i + 3]
            self.assertAlmostEqual(scanner[4 * i + 3], there, delta=1e-9)
            # Its own x axis is the source's y axis.
            self.assertAlmostEqual(scanner[4 * i], pose[4 * i + 1], delta=1e-9)
        self.assertLess(max(map(abs, file["bounds"]["min"] + file["bounds"]["max"])), 7)

    def test_every_method_and_preset(self):
        for options, method in ((["--method", "ndt"], "ndt"), (["--method", "icp"], "icp"),
                                (["--preset", "paper"], "improved-ndt")):
            done = run("register", self.target, self.source, "--pose-out", self.pose, "--json", *options)
            # The coarser methods may be refused; what they found is told all the same.
            self.assertIn(done.returncode, (0, 4), done.stderr)
            told = json.loads(done.stdout)
            self.assertEqual(told["method"], method)
            self.assertEqual(told["verdict"] in ("accepted", "doubtful"), done.returncode == 0)
            self.assertEqual(self.pose.exists(), done.returncode == 0)
            if done.returncode == 0:
                self.expect_truth(told["pose"], 0.05, 0.5)
            self.pose.unlink(missing_ok=True)

    def test_is_the_same_for_any_number_of_threads(self):
        written = []
        for threads in (1, 2, 5):
            cli("register", self.target, self.source, "--pose-out", self.pose, "--threads", threads)
            written.append(self.pose.read_bytes())
        self.assertEqual(written[0], written[1])
        self.assertEqual(written[0], written[2])

    def test_starts_from_a_pose_file_that_it_wrote(self):
        cli("register", self.target, self.source, "--pose-out", self.pose)
        told = json.loads(cli("register", self.target, self.source, "--init", self.pose, "--pose-out",
                              self.folder / "again.json", "--json").stdout)
        self.expect_truth(told["pose"], 0.01, 0.1)

    def test_starts_from_picked_pairs_in_millimetres(self):
        source, picks = self.folder / "source_mm.xyz", self.folder / "picks.csv"
        write(source, self.source_points, 1000)
        rows = ["tx,ty,tz,sx,sy,sz"]
        for point in ((-3, 1, 1.1), (5.7, -2.5, 1.4), (3.5, 2.5, 2.0), (-6, 5, 3)):
            rows.append(",".join(f"{value:.3f}" for value in (*point, *(1000 * c for c in to_source(point)))))
        picks.write_text("\n".join(rows) + "\n")
        told = json.loads(cli("register", self.target, source, "--init", picks, "--pose-out", self.pose, "--json").stdout)
        self.assertEqual(told["scale"], 0.001)
        self.expect_truth(told["pose"], 0.01, 0.1)
        self.assertEqual(json.loads(self.pose.read_text())["scale"], 0.001)

    def test_a_las_file_in_feet_is_taken_at_its_word(self):
        target, source = self.folder / "target_ftUS.las", self.folder / "source_ft.las"
        us_foot = 1200 / 3937
        write_las(source, self.source_points, 0.3048, 9002)
        write_las(target, points_of(self.target), us_foot, 9003)
        aligned = self.folder / "aligned.xyz"
        done = cli("register", target, source, "--pose-out", self.pose, "--aligned", aligned, "--json")
        told = json.loads(done.stdout)
        self.assertEqual(told["scale"], 0.3048)
        self.expect_truth(told["pose"], 0.01, 0.1)
        self.assertIn("into its frame in metres", done.stderr)
        # In metres, in the target's frame.
        self.assertLess(max(abs(x) for x, _, _ in points_of(aligned)), 7)
        # The user's word counts more.
        done = run("register", target, source, "--unit", "m", "--pose-out", self.pose, "--json")
        self.assertEqual(done.returncode, 4)

    def test_a_unit_that_has_no_name_is_taken_at_its_word_too(self):
        clarkes_foot = 0.3047972654
        source = self.folder / "source_clarke.las"
        write_las(source, self.source_points, clarkes_foot, 9005)
        for init in ("identity", "auto"):
            done = cli("register", self.target, source, "--init", init, "--pose-out", self.pose, "--json")
            told = json.loads(done.stdout)
            self.assertEqual(told["scale"], clarkes_foot)
            self.expect_truth(told["pose"], 0.01, 0.1)
            self.assertIn("units of 0.3047972654 m", done.stderr)

    def test_a_wrong_command_line_is_2(self):
        cli("register", self.target, self.source, code=2)
        for wrong in (["--method", "guess"], ["--voxel", "0"], ["--unit", "yd"], ["--aligned", self.folder / "a.bmp"],
                      ["--unknown"]):
            cli("register", self.target, self.source, "--pose-out", self.pose, *wrong, code=2)
        self.assertFalse(self.pose.exists())

    def test_a_broken_input_is_3_and_named(self):
        absent, bad = self.folder / "absent.xyz", self.folder / "bad.xyz"
        bad.write_text("1 2 3\n4 5 six\n")
        pose = self.folder / "first.json"
        pose.write_text('{"pose": [1, 0], "scale": 1}')
        picks = self.folder / "picks.csv"
        picks.write_text("tx,ty,tz,sx,sy,sz\n1,2,3,4,5\n")
        for arguments, name in (((absent, self.source), absent), ((self.target, absent), absent),
                                ((self.target, bad), bad), ((self.target, self.source, "--init", pose), pose),
                                ((self.target, self.source, "--init", picks), picks)):
            told = cli("register", *arguments, "--pose-out", self.pose, code=3).stderr
            self.assertIn(name.name, told)
        self.assertFalse(self.pose.exists())

    def test_clouds_that_do_not_meet_are_4_and_nothing_is_written(self):
        source, aligned = self.folder / "far.xyz", self.folder / "aligned.xyz"
        write(source, [(x + 300, y, z) for x, y, z in self.source_points])
        aligned.write_text("what stood there")
        done = cli("register", self.target, source, "--pose-out", self.pose, "--aligned", aligned, "--json", code=4)
        self.assertFalse(self.pose.exists())
        self.assertEqual(aligned.read_text(), "what stood there")
        self.assertIn("vestige-cli:", done.stderr)
        told = json.loads(done.stdout)
        self.assertEqual(told["verdict"], "failed")
        self.assertTrue(told["reasons"])

    def test_an_output_that_cannot_be_written_is_5_and_leaves_nothing(self):
        (self.folder / "file").write_text("in the way")
        inside = self.folder / "file" / "out"
        cli("register", self.target, self.source, "--pose-out", inside.with_suffix(".json"), code=5)
        cli("register", self.target, self.source, "--pose-out", self.pose, "--aligned", inside.with_suffix(".xyz"), code=5)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["file"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
