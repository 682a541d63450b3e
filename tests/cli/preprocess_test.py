#!/usr/bin/env python3
"""`vestige-cli preprocess` from outside.

preprocess_test.py VESTIGE_CLI
"""
import json
import math
import random
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]


def cli(*arguments, code=0):
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=120)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


def points_of(path):
    """x, y and z of a text cloud with or without a header."""
    points = []
    for line in path.read_text().splitlines():
        try:
            points.append(tuple(float(cell) for cell in line.replace(",", " ").split()[:3]))
        except ValueError:
            pass
    return points


def write_las_in_feet(path, points):
    """LAS 1.2, point format 0, steps of 0.001 ft, with GeoTIFF keys that name the international foot."""
    keys = struct.pack("<12H", 1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9002)
    record = struct.pack("<H16sHH32s", 0, b"LASF_Projection", 34735, len(keys), b"") + keys
    rows = [tuple(round(value / 1e-3) for value in point) for point in points]
    ends = [value * 1e-3 for axis in range(3) for value in (max(r[axis] for r in rows), min(r[axis] for r in rows))]
    header = struct.pack("<4sHHIHH8sBB32s32sHHHIIBHI5I12d", b"LASF", 0, 0, 0, 0, 0, b"", 1, 2, b"", b"", 1, 2026, 227,
                         227 + len(record), 1, 0, 20, len(rows), len(rows), 0, 0, 0, 0, *[1e-3] * 3, *[0] * 3, *ends)
    path.write_bytes(header + record + b"".join(struct.pack("<3i8x", *row) for row in rows))


def info(path):
    return json.loads(cli("--json", "info", path).stdout)["files"][0]


class Preprocess(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.input = self.folder / "in.xyz"
        chance = random.Random(1)
        # A rough floor at UTM coordinates, 10 x 10 m, and one point high above it.
        self.points = [(483400 + chance.uniform(0, 10), 4375661 + chance.uniform(0, 10), 35 + chance.gauss(0, 0.02))
                       for _ in range(20000)] + [(483405.0, 4375666.0, 60.0)]
        self.input.write_text("".join(f"{x:.4f} {y:.4f} {z:.4f}\n" for x, y, z in self.points))

    def test_thins_to_one_point_a_voxel_and_says_what_it_did(self):
        out = self.folder / "out.xyz"
        done = cli("--json", "preprocess", self.input, out, "--filter", "none", "--voxel", "0.5", "--outliers", "ror")
        told = json.loads(done.stdout)
        voxels = {tuple(math.floor(c / 0.5) for c in p) for p in points_of(self.input)[:-1]}
        self.assertEqual(told["input_points"], 20001)
        self.assertEqual(told["output_points"], len(voxels))
        self.assertEqual({tuple(math.floor(c / 0.5) for c in p) for p in points_of(out)}, voxels)
        self.assertEqual(told["parameters"]["voxel_m"], 0.5)
        self.assertAlmostEqual(told["parameters"]["radius_m"], 3 * 0.92 * math.sqrt(100 / 20000), delta=0.03)
        self.assertGreater(told["seconds"], 0)

    def test_the_default_filter_reduces_noise(self):
        out = self.folder / "out.xyz"
        cli("preprocess", self.input, out, "--radius", "0.3")
        heights = [z - 35 for _, _, z in points_of(out)[:-1]]
        self.assertEqual(len(heights), 20000)
        self.assertLess(math.sqrt(sum(z * z for z in heights) / len(heights)), 0.25 * 0.02)

    def test_nothing_asked_changes_nothing(self):
        out = self.folder / "out.xyz"
        told = json.loads(cli("--json", "preprocess", self.input, out, "--filter", "none").stdout)
        self.assertIsNone(told["parameters"]["radius_m"])
        self.assertIsNone(told["parameters"]["voxel_m"])
        for before, after in zip(points_of(self.input), points_of(out), strict=True):
            self.assertLess(max(abs(a - b) for a, b in zip(before, after)), 1e-4)

    def test_same_bytes_for_any_number_of_threads(self):
        results = []
        for threads in (1, 2, 7):
            out = self.folder / f"out{threads}.ply"
            cli("preprocess", self.input, out, "--outliers", "sor", "--voxel", "0.1", "--threads", threads)
            results.append(out.read_bytes())
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])

    def test_lengths_are_metres_for_millimetres_too(self):
        scan = self.folder / "scan.xyz"
        scan.write_text("".join(f"{1000 * (x - 483400):.1f} {1000 * (y - 4375661):.1f} 0\n" for x, y, _ in self.points))
        told = json.loads(cli("--json", "preprocess", scan, self.folder / "o.xyz", "--filter", "none", "--voxel", "1",
                              "--unit", "mm").stdout)
        self.assertEqual(told["output_points"], 100)

    def test_formats_that_fix_metres_are_given_metres(self):
        rows = [(x, y, z) for x in range(0, 40) for y in range(0, 30) for z in (3, 7)]
        feet, scan = self.folder / "feet.las", self.folder / "scan.xyz"
        write_las_in_feet(feet, rows)
        scan.write_text("".join(f"{x} {y} {z}\n" for x, y, z in rows))
        for source, options, scale in ((feet, (), 0.3048), (scan, ("--unit", "mm"), 0.001), (feet, ("--unit", "m"), 1),
                                       (feet, ("--unit", "in"), 0.0254), (scan, (), 1)):
            for name in ("out.e57", "out.glb"):
                out = self.folder / name
                done = cli("--json", "preprocess", source, out, "--filter", "none", *options)
                self.assertEqual(json.loads(done.stdout)["output_points"], len(rows))
                self.assertEqual("holds metres" in done.stderr, scale != 1, done.stderr)
                told = info(out)
                self.assertEqual(told["metres_per_unit"], 1)
                self.assertFalse(told["crs"], "of the file in feet")
                for found, truth in zip(told["bounds"]["min"] + told["bounds"]["max"], (0, 0, 3, 39, 29, 7), strict=True):
                    self.assertAlmostEqual(found, truth * scale, delta=1e-5)
        # Any other keeps the unit of the file, and what the file says of it.
        cli("preprocess", feet, self.folder / "out.las", "--filter", "none")
        told = info(self.folder / "out.las")
        self.assertEqual((told["metres_per_unit"], told["bounds"]["max"]), (0.3048, [39, 29, 7]))

    def test_scanners_stay_where_they_were_in_another_unit(self):
        scan, out = self.folder / "scan.ptx", self.folder / "scan.e57"
        scan.write_text("2\n1\n1000 2000 3000\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1000 2000 3000 1\n"
                        "100 0 0 0.5\n0 200 0 0.5\n")
        cli("preprocess", scan, out, "--filter", "none", "--unit", "mm")
        told = info(out)
        self.assertEqual([told["scans"][0]["pose"][i] for i in (3, 7, 11)], [1, 2, 3])
        for found, truth in zip(told["bounds"]["min"] + told["bounds"]["max"], (1, 2, 3, 1.1, 2.2, 3), strict=True):
            self.assertAlmostEqual(found, truth, delta=1e-6)

    def test_a_mesh_is_taken_by_its_vertices(self):
        mesh = self.folder / "mesh.ply"
        mesh.write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        out = self.folder / "out.xyz"
        done = cli("preprocess", mesh, out, "--filter", "none")
        self.assertIn("mesh", done.stderr)
        self.assertEqual(points_of(out), [(0, 0, 0), (1, 0, 0), (0, 1, 0)])

    def test_wrong_requests_and_files_have_their_codes(self):
        out = self.folder / "out.ply"
        out.write_text("what stood here")
        for arguments in (["--filter", "blur"], ["--voxel", "-1"], ["--radius", "wide"], ["--outliers", "all"],
                          ["--voxel", "1e-6"]):
            self.assertTrue(cli("preprocess", self.input, out, *arguments, code=2).stderr)
        cli("preprocess", self.input, self.folder / "out.unknown", code=2)
        cli("preprocess", self.input, code=2)
        self.assertIn("absent.ply", cli("preprocess", self.folder / "absent.ply", out, code=3).stderr)
        self.assertIn("in.xyz", cli("preprocess", self.input, self.input / "below.ply", code=5).stderr)
        self.assertEqual(out.read_text(), "what stood here")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
