#!/usr/bin/env python3
"""`vestige-cli preprocess` from outside.

preprocess_test.py VESTIGE_CLI
"""
import json
import math
import random
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
