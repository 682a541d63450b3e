#!/usr/bin/env python3
"""`vestige-cli evaluate` from outside, on a small pavilion that `simulate` makes.

evaluate_test.py VESTIGE_CLI
"""
import csv
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]
SCANS = 4


def cli(*arguments, code=0):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=280, env=environment)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


def rows_of(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def matrices(path):
    """The poses of an ASL file as lists of 16."""
    return [[float(row[f"T{i // 4}{i % 4}"]) for i in range(16)] for row in rows_of(path)]


def rms(values):
    values = list(values)
    return math.sqrt(sum(value * value for value in values) / len(values))


class Evaluate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.asl = Path(cls.made.name) / "pavilion"
        told = json.loads(cli("simulate", "pavilion", "--out", cls.asl, "--scans", SCANS, "--beams", 6000, "--json").stdout)
        cls.points = told["points"]
        cls.truth = cls.asl / "pose_scanner_leica.csv"

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def broken(self):
        """A copy of the sequence to spoil."""
        copy = self.folder / "copy"
        shutil.copytree(self.asl, copy)
        return copy, copy / "pose_scanner_leica.csv"

    def refused(self, folder, truth):
        out = self.folder / "refused.csv"
        told = cli("evaluate", folder, "--truth", truth, "--out", out, code=3).stderr
        self.assertFalse(out.exists())
        return told

    def test_simulated_layout(self):
        names = sorted(path.name for path in self.asl.iterdir())
        self.assertEqual(names, [f"Hokuyo_{i}.csv" for i in range(SCANS)] + ["pose_scanner_leica.csv"])
        with (self.asl / "Hokuyo_2.csv").open() as file:
            self.assertEqual(file.readline().strip(), "Time_in_sec,x,y,z,Intensities,2DscanId,PointId")
            self.assertEqual(sum(1 for _ in file), self.points[2])
        poses = matrices(self.truth)
        self.assertEqual(len(poses), SCANS)
        for before, after in zip(poses, poses[1:]):
            step = math.dist((before[3], before[7], before[11]), (after[3], after[7], after[11]))
            self.assertTrue(0.4 < step < 0.8, step)

    def test_every_combination_has_a_row_that_agrees_with_its_pairs(self):
        out, pairs = self.folder / "rpe.csv", self.folder / "pairs.csv"
        told = json.loads(cli("evaluate", self.asl, "--truth", self.truth, "--out", out, "--pairs", pairs, "--method",
                              "improved-ndt", "--method", "icp", "--voxel", "1.0", "--voxel", "auto", "--filter", "none",
                              "--filter", "gaussian", "--json").stdout)
        rows = rows_of(out)
        self.assertEqual(len(rows), 8)
        self.assertEqual({(row["method"], row["voxel_m"], row["filter"]) for row in rows},
                         {(method, voxel, name) for method in ("improved-ndt", "icp") for voxel in ("1", "")
                          for name in ("none", "gaussian")})
        self.assertEqual(len(told["rows"]), 8)
        self.assertEqual(told["clouds"], SCANS)
        self.assertEqual(told["points"], sum(self.points))
        singles = rows_of(pairs)
        self.assertEqual(len(singles), 8 * (SCANS - 1))
        poses = matrices(self.truth)
        for row, said in zip(rows, told["rows"]):
            self.assertEqual(float(row["rpe_m"]), said["rpe_m"])
            self.assertEqual(row["voxel_m"], "" if said["voxel_m"] is None else "1")
            mine = [one for one in singles if all(one[key] == row[key] for key in ("method", "voxel_m", "filter"))]
            self.assertAlmostEqual(rms(float(one["error_m"]) for one in mine), float(row["rpe_m"]), places=12)
            self.assertAlmostEqual(rms(float(one["error_deg"]) for one in mine), float(row["rpe_deg"]), places=9)
            self.assertAlmostEqual(sum(float(one["seconds"]) for one in mine), float(row["seconds"]), places=6)
            self.assertEqual(int(row["failed"]), sum(one["verdict"] in ("failed", "ambiguous") for one in mine))
            for i, one in enumerate(mine):
                step = math.dist(poses[i][3:12:4], poses[i + 1][3:12:4])
                self.assertAlmostEqual(float(one["moved_m"]), step, places=9)
        best = [row for row in rows if row["method"] == "improved-ndt" and row["voxel_m"] == ""]
        for row in best:  # 6000 beams show little; a step is half a metre
            self.assertLess(float(row["rpe_m"]), 0.1)

    def test_the_same_clouds_in_other_layouts_give_the_same_errors(self):
        common = ["--voxel", "1.0", "--out", self.folder / "rpe.csv", "--json"]
        own = json.loads(cli("evaluate", self.asl, "--truth", self.truth, *common).stdout)["rows"][0]
        world = self.folder / "world"
        cli("simulate", "pavilion", "--out", world, "--scans", SCANS, "--beams", 6000, "--frame", "world")
        self.assertTrue((world / "PointCloud0.csv").exists())
        there = json.loads(cli("evaluate", world, "--truth", world / "pose_scanner_leica.csv", *common).stdout)["rows"][0]
        self.assertAlmostEqual(there["rpe_m"], own["rpe_m"], delta=0.002)
        generic = self.folder / "generic"
        lines = []
        for i, pose in enumerate(matrices(self.truth)):
            cli("convert", self.asl / f"Hokuyo_{i}.csv", generic / f"cloud{i + 8}.ply")
            w = math.sqrt(max(0, 1 + pose[0] + pose[5] + pose[10])) / 2
            q = ((pose[9] - pose[6]) / (4 * w), (pose[2] - pose[8]) / (4 * w), (pose[4] - pose[1]) / (4 * w), w)
            lines.append(" ".join(repr(value) for value in (float(i), pose[3], pose[7], pose[11], *q)))
        (generic / "poses.txt").write_text("# t x y z qx qy qz qw\n" + "\n".join(lines) + "\n")
        again = json.loads(cli("evaluate", generic, "--truth", generic / "poses.txt", *common).stdout)["rows"][0]
        self.assertAlmostEqual(again["rpe_m"], own["rpe_m"], delta=1e-4)

    def test_errors_do_not_depend_on_threads(self):
        told = [json.loads(cli("evaluate", self.asl, "--truth", self.truth, "--voxel", "1.0", "--filter", "median", "--out",
                               self.folder / "rpe.csv", "--threads", threads, "--json").stdout)["rows"][0]
                for threads in (1, 2)]
        for key in ("rpe_m", "rpe_deg", "rpe_max_m"):
            self.assertEqual(told[0][key], told[1][key])

    def test_poses_further_apart(self):
        told = json.loads(cli("evaluate", self.asl, "--truth", self.truth, "--voxel", "1.0", "--delta", 3, "--out",
                              self.folder / "rpe.csv", "--json").stdout)["rows"][0]
        self.assertEqual((told["pairs"], told["delta"]), (1, 3))
        self.assertEqual(told["rpe_m"], told["rpe_max_m"])
        cli("evaluate", self.asl, "--truth", self.truth, "--delta", SCANS, "--out", self.folder / "a.csv", code=2)

    def test_published_tables_and_pictures_without_a_display(self):
        pair = self.folder / "pair"
        pair.mkdir()
        for name in ("Hokuyo_0.csv", "Hokuyo_1.csv"):
            shutil.copy(self.asl / name, pair)
        (pair / "poses.csv").write_text("".join(self.truth.read_text().splitlines(keepends=True)[:3]))
        out, pdf, chart = self.folder / "rpe.csv", self.folder / "report.pdf", self.folder / "chart.svg"
        told = cli("evaluate", pair, "--truth", pair / "poses.csv", "--table", 2, "--table", 3, "--out", out, "--pdf", pdf,
                   "--chart", chart).stdout
        self.assertIn("of 6 sizes", told)
        rows = rows_of(out)
        self.assertEqual(len(rows), 12 + 9)
        text = subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout
        plain = " ".join(text.split())
        for words in ("Table 2", "Table 3", "classic NDT", "improved NDT, gaussian", "published"):
            self.assertIn(words, plain)
        for published in ("0.67", "0.36", "0.51"):
            self.assertIn(published, text.replace(" ", ""))
        self.assertIn("<svg", chart.read_text())
        png = self.folder / "chart.png"
        cli("evaluate", pair, "--truth", pair / "poses.csv", "--voxel", "1.0", "--out", out, "--chart", png)
        self.assertEqual(png.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_broken_sequences_are_refused_with_a_sentence(self):
        copy, truth = self.broken()
        whole = truth.read_text()
        lines = whole.splitlines(keepends=True)
        truth.write_text("".join(lines[:-1]))
        self.assertIn(f"{SCANS - 1} poses for {SCANS} clouds", self.refused(copy, truth))
        truth.write_text(whole.replace("T21", "S21", 1))
        self.assertIn("T21", self.refused(copy, truth))
        cells = lines[2].split(",")
        truth.write_text("".join([*lines[:2], ",".join([*cells[:4], "nan", *cells[5:]]), *lines[3:]]))
        self.assertIn("line 3", self.refused(copy, truth))
        truth.write_text("")
        self.assertIn("pose", self.refused(copy, truth))
        truth.write_text(whole)
        cloud = copy / "Hokuyo_1.csv"
        points = cloud.read_text().splitlines(keepends=True)
        cloud.write_text("".join(line.split(",", 1)[0] + "," + line.split(",", 2)[2] for line in points))  # no x
        self.assertIn("Hokuyo_1.csv", self.refused(copy, truth))
        cloud.write_text("".join([*points[:5], points[5].replace(points[5].split(",")[1], "nan", 1), *points[6:]]))
        self.assertIn("Hokuyo_1.csv", self.refused(copy, truth))
        cloud.write_text(points[0])
        self.assertIn("Hokuyo_1.csv", self.refused(copy, truth))
        cloud.unlink()
        self.assertIn(f"{SCANS} poses for {SCANS - 1} clouds", self.refused(copy, truth))
        self.assertIn("absent", self.refused(self.folder / "absent", truth))
        self.assertIn("absent.csv", self.refused(copy, self.folder / "absent.csv"))

    def test_exit_codes(self):
        out = self.folder / "rpe.csv"
        cli("evaluate", self.asl, code=2)
        for wrong in (["--method", "guess"], ["--voxel", "-1"], ["--filter", "blur"], ["--table", "4"], ["--chart", "a.bmp"],
                      ["--frame", "moon"], ["--delta", "0"]):
            cli("evaluate", self.asl, "--truth", self.truth, "--out", out, *wrong, code=2)
        (self.folder / "file").write_text("in the way")
        cli("evaluate", self.asl, "--truth", self.truth, "--voxel", "1.0", "--out", out, "--pairs",
            self.folder / "file" / "pairs.csv", code=5)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["file"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
