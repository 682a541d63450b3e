#!/usr/bin/env python3
"""`vestige-cli accuracy` from outside, on the published tables.

accuracy_test.py VESTIGE_CLI
"""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLI = sys.argv[1]
ORACLES = Path(__file__).resolve().parent.parent / "data" / "oracles"


def cli(*arguments, code=0):
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=120, env=environment)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


class Accuracy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_json_has_the_published_values(self):
        expected = {
            "table5.csv": {
                "photogrammetry": (11, 0.0466, ["Right rear-view mirror of the black vehicle"]),
                "lidar": (11, 0.0427, ["Right rear-view mirror of the white vehicle",
                                       "Right rear-view mirror of the black vehicle"])},
            "table6.csv": {"photogrammetry": (10, 0.0581, []), "lidar": (12, 0.0451, ["Tripod length"])}}
        for table, methods in expected.items():
            told = json.loads(cli("accuracy", ORACLES / table, "--json").stdout)
            self.assertEqual([method["name"] for method in told["methods"]], list(methods))
            for method in told["methods"]:
                n, rmse, excluded = methods[method["name"]]
                self.assertEqual(method["n"], n)
                self.assertEqual(round(method["rmse"], 4), rmse)
                self.assertEqual(method["excluded"], excluded)
                self.assertEqual([o["object"] for o in method["objects"] if o["excluded"]], excluded)
                measured = [o for o in method["objects"] if o["measured_m"] is not None]
                self.assertEqual(len(measured), n)
                for item in method["objects"]:
                    if item["measured_m"] is None:
                        self.assertIsNone(item["re"])
                    else:
                        self.assertAlmostEqual(item["re"], item["measured_m"] / item["tape_m"] - 1, places=12)

    def test_csv_has_a_row_per_method_that_reads_back_exactly(self):
        out = self.folder / "made" / "accuracy.csv"
        told = json.loads(cli("accuracy", ORACLES / "table5.csv", "--out", out, "--json").stdout)
        with out.open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["method", "n", "sd", "rmse", "rmse_all", "rmse_abs_m", "excluded",
                                         "rmse_large", "small"])
        self.assertEqual(float(rows[1]["rmse"]), told["methods"][1]["rmse"])
        self.assertEqual(rows[1]["excluded"].split(";"), told["methods"][1]["excluded"])
        self.assertEqual(round(float(rows[1]["rmse_abs_m"]), 4), 0.0355)

    def test_pdf_without_a_display(self):
        out = self.folder / "accuracy.pdf"
        cli("accuracy", ORACLES / "table6.csv", "--pdf", out)
        text = subprocess.run(["pdftotext", "-layout", out, "-"], capture_output=True, text=True, check=True).stdout
        self.assertIn("Tripod length", text)
        self.assertIn("4.51", text.replace(" ", ""))  # kerned digits come apart

    def test_language_is_of_the_report_alone(self):
        table = ORACLES / "table5.csv"
        for language in ("en", "zh_CN"):
            cli("accuracy", table, "--language", language, "--out", self.folder / f"{language}.csv",
                "--pdf", self.folder / f"{language}.pdf")
        self.assertEqual((self.folder / "en.csv").read_bytes(), (self.folder / "zh_CN.csv").read_bytes())
        pdf = self.folder / "zh_CN.pdf"
        text = subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout
        for part in ("准确度报告", "相对于卷尺的准确度", "激光扫描", "4.27", "第 1 页"):
            self.assertIn(part, text)
        with table.open(newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                for word in re.split(r"[\s-]", row["object"]):
                    text = text.replace(word, "")
        same = {"RMSE", "Vestige", "UTC", "SD", "RE"}
        self.assertEqual(set(re.findall("[A-Za-z]{2,}", text)) - same - {"mm", "table", "csv"}, set())
        self.assertIn("无法打开文件进行读取", cli("accuracy", self.folder / "absent.csv", "--language", "zh_CN", code=3).stderr)
        cli("accuracy", table, "--language", "de", code=2)

    def test_words_for_people(self):
        told = cli("accuracy", ORACLES / "table6.csv").stdout
        self.assertIn("lidar: 12 objects", told)
        self.assertIn("RMSE 4.51 %", told)
        self.assertIn("excluded: Tripod length", told)

    def test_exit_codes(self):
        cli("accuracy", code=2)
        self.assertIn("absent.csv", cli("accuracy", self.folder / "absent.csv", code=3).stderr)
        bad = self.folder / "bad.csv"
        bad.write_text("object,tape_m,lidar_m\nbox,0.75,wide\n")
        self.assertIn("bad.csv:2", cli("accuracy", bad, code=3).stderr)
        (self.folder / "file").write_text("in the way")
        csv_out = self.folder / "out.csv"
        cli("accuracy", ORACLES / "table5.csv", "--out", csv_out, "--pdf", self.folder / "file" / "a.pdf", code=5)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["bad.csv", "file"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
