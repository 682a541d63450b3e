#!/usr/bin/env python3
"""The main job from outside, as a user runs it: simulate, reconstruct, and every promise of the output recomputed here.

main_job_test.py VESTIGE_CLI [SECONDS]
"""
import csv
import hashlib
import json
import math
import os
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]
SECONDS = sys.argv[2] if len(sys.argv) > 2 else "12"
STABLE = ("fused.las", "registration.json", "measurements.csv", "accuracy.csv", "quantities.csv", "uncertainty.csv")
REAL = [f"measured_{i}_m" for i in (1, 2, 3)]


def cli(*arguments, code=0, **options):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, env=environment, **options)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


def number(text):
    return float(text) if text else None


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def expected_accuracy(rows):
    """METHOD section 5 again, written apart from the program."""
    errors = {r["object"]: (float(r["measured_mean_m"]) - float(r["tape_m"])) / float(r["tape_m"])
              for r in rows if r["measured_mean_m"] and r["tape_m"]}
    if not errors:
        return None
    values = list(errors.values())
    excluded = []
    if len(values) >= 3:
        limit = 2 * statistics.stdev(values)
        excluded = [name for name, re in errors.items() if abs(re) > limit]
        if 2 * len(excluded) >= len(values):
            excluded = []
    rms = lambda numbers: math.sqrt(sum(x * x for x in numbers) / len(numbers))
    return {
        "n": len(values),
        "excluded": excluded,
        "rmse": rms([re for name, re in errors.items() if name not in excluded]),
        "rmse_all": rms(values),
        "rmse_abs_m": rms([float(r["measured_mean_m"]) - float(r["tape_m"])
                           for r in rows if r["measured_mean_m"] and r["tape_m"]]),
    }


class MainJob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="vestige-main-job-"))
        cls.sample = cls.folder / "sample"
        cli("simulate", "bicycle", "--out", cls.sample, "--seconds", SECONDS, "--quiet")
        cls.case = cls.sample / "case.json"
        cls.out = cls.folder / "out"
        cls.json = json.loads(cli("reconstruct", cls.case, "--out", cls.out, "--json").stdout)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_everything_the_contract_lists_is_there(self):
        for name in (*STABLE, "report.pdf", "manifest.json"):
            self.assertTrue((self.out / name).is_file(), name)
        pictures = sorted((self.out / "screenshots").glob("*.png"))
        self.assertGreaterEqual(len(pictures), 3)
        for picture in pictures:
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_hashes_are_those_of_the_files(self):
        for output in self.json["outputs"]:
            self.assertEqual(hashlib.sha256((self.out / output["path"]).read_bytes()).hexdigest(), output["sha256"])
        text = (self.out / "manifest.json").read_text()
        for layer in json.loads(self.case.read_text())["layers"]:
            self.assertIn(hashlib.sha256((self.sample / layer["path"]).read_bytes()).hexdigest(), text)
        for name in (*STABLE, "report.pdf"):
            self.assertIn(hashlib.sha256((self.out / name).read_bytes()).hexdigest(), text)

    def test_second_run_with_other_threads_is_byte_identical(self):
        for threads in (1, 2, 7):
            again = self.folder / f"again-{threads}"
            cli("--threads", threads, "reconstruct", self.case, "--out", again, "--quiet")
            for name in STABLE:
                self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), f"{name}, {threads}")
            for picture in (self.out / "screenshots").glob("*.png"):
                self.assertEqual(picture.read_bytes(), (again / "screenshots" / picture.name).read_bytes(), picture.name)

    def test_csv_recomputed(self):
        rows = rows_of(self.out / "measurements.csv")
        accuracy = {r["method"]: r for r in rows_of(self.out / "accuracy.csv")}
        for row in rows:
            repeats = [number(row[column]) for column in REAL if row[column]]
            if not repeats:
                self.assertEqual(row["re"], "")
                continue
            mean = number(row["measured_mean_m"])
            self.assertAlmostEqual(mean, statistics.mean(repeats), 12)
            if len(repeats) > 1:
                self.assertAlmostEqual(number(row["repeat_sd_m"]), statistics.stdev(repeats), 12)
                self.assertGreater(len(set(repeats)), 1, f"the repeats of {row['object']} do not differ")
            self.assertAlmostEqual(number(row["re"]), (mean - number(row["tape_m"])) / number(row["tape_m"]), 12)
        for method, found in accuracy.items():
            mine = [r for r in rows if r["method"] == method]
            expected = expected_accuracy(mine)
            if expected is None:
                continue
            self.assertEqual(int(found["n"]), expected["n"])
            self.assertEqual([name for name in found["excluded"].split(";") if name], expected["excluded"])
            self.assertEqual([r["object"] for r in mine if r["excluded"] == "true"], expected["excluded"])
            for key in ("rmse", "rmse_all", "rmse_abs_m"):
                self.assertAlmostEqual(number(found[key]), expected[key], 12)

    def test_handheld_makes_the_hidden_objects_measurable(self):
        without = self.folder / "without"
        cli("reconstruct", self.sample / "case-without-handheld.json", "--out", without, "--quiet")
        lidar = lambda folder: {r["object"]: r for r in rows_of(folder / "measurements.csv") if r["method"] == "lidar"}
        full, reduced = lidar(self.out), lidar(without)
        hidden = [name for name, row in reduced.items()
                  if not row["measured_mean_m"] and full[name]["measured_mean_m"]]
        self.assertIn("Right rearview mirror", hidden)
        self.assertIn("Right door handle", hidden)
        for name in hidden:
            self.assertLess(abs(float(full[name]["re"])), 0.01, name)

    def test_registration_against_the_truth(self):
        truth = (self.sample / "truth.json").read_text()
        self.assertIn("pose", truth)
        truth = json.loads(truth)
        for result in json.loads((self.out / "registration.json").read_text()):
            self.assertNotIn("seconds", result)
            known = truth["layers"][result["layer"]]
            pose, exact = result["pose"], known["pose"]
            self.assertEqual(result["scale"], 0.001)
            moved = math.dist([pose[3], pose[7], pose[11]], [exact[3], exact[7], exact[11]])
            trace = sum(pose[4 * r + k] * exact[4 * r + k] for r in range(3) for k in range(3))
            angle = math.degrees(math.acos(min(1.0, (trace - 1) / 2)))
            self.assertLess(moved, 0.05, result["layer"])
            self.assertLess(angle, 2.0, result["layer"])  # a third of a circle of flight shows little of the car

    def test_fused_cloud_names_its_layers(self):
        head = (self.out / "fused.las").read_bytes()[:375]
        self.assertEqual(head[:4], b"LASF")
        self.assertEqual((head[24], head[25]), (1, 4))
        count = struct.unpack_from("<Q", head, 247)[0]
        info = json.loads(cli("info", self.out / "fused.las", "--json").stdout)["files"][0]
        self.assertEqual(info["points"], count)

    def test_report_is_a4_with_embedded_fonts(self):
        for tool in ("pdfinfo", "pdffonts"):
            if shutil.which(tool) is None:
                self.skipTest(f"{tool} is not installed")
        info = subprocess.run(["pdfinfo", self.out / "report.pdf"], capture_output=True, text=True, check=True).stdout
        self.assertIn("A4", info)
        fonts = subprocess.run(["pdffonts", self.out / "report.pdf"], capture_output=True, text=True, check=True).stdout
        for line in fonts.splitlines()[2:]:
            self.assertIn(" yes ", line[40:])

    def test_failure_leaves_what_was_there(self):
        before = {p: p.read_bytes() for p in self.out.rglob("*") if p.is_file() and p.name != "fused.las"}
        broken = self.folder / "broken"
        shutil.copytree(self.sample, broken)
        first = json.loads(self.case.read_text())["layers"][0]["path"]
        (broken / first).write_bytes((broken / first).read_bytes()[:1000])
        done = cli("reconstruct", broken / "case.json", "--out", self.out, code=3)
        self.assertIn(first, done.stderr)
        after = {p: p.read_bytes() for p in self.out.rglob("*") if p.is_file() and p.name != "fused.las"}
        self.assertEqual(before, after)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
