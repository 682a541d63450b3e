"""vestige-cli info and convert from outside: exit codes, JSON, sentences. Usage: io_test.py VESTIGE_CLI"""
import hashlib
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

CLI = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=60)


class IoCli(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.cloud = self.path / "cloud.csv"
        self.cloud.write_text("x,y,z,intensity,red,green,blue\n576661.9701,5188114.0602,156.06,5,255,0,1\n"
                              "576662.9701,5188115.0602,157.06,6,0,1,2\n")

    def test_info_prints_one_json_object(self):
        done = run("--json", "info", self.cloud)
        self.assertEqual(done.returncode, 0, done.stderr)
        (info,) = json.loads(done.stdout)["files"]
        self.assertEqual((info["format"], info["points"], info["triangles"]), ("text", 2, 0))
        self.assertAlmostEqual(info["bounds"]["min"][0], 576661.9701, places=6)
        self.assertEqual(info["sha256"], hashlib.sha256(self.cloud.read_bytes()).hexdigest())
        self.assertEqual(info["attributes"], ["intensity", "color"])
        self.assertIsNone(info["scale"])

    def test_info_answers_3_when_any_file_fails_and_tells_of_the_others(self):
        broken = self.path / "broken.xyz"
        broken.write_text("1 2 3\n4 5\n")
        done = run("info", "--json", broken, self.cloud)
        self.assertEqual(done.returncode, 3)
        self.assertIn(f"{broken}, line 2", done.stderr)
        self.assertEqual(len(json.loads(done.stdout)["files"]), 1)
        self.assertEqual(run("info", self.path / "missing.las").returncode, 3)

    def test_convert_there_and_back_keeps_coordinates(self):
        source = self.cloud
        for name in ("a.las", "b.laz", "c.ply", "d.pcd", "e.xyz", "f.csv"):
            done = run("convert", source, self.path / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            source = self.path / name
        rows = [list(map(float, line.split(","))) for line in source.read_text().splitlines()[1:]]
        for row, truth in zip(rows, ([576661.9701, 5188114.0602, 156.06, 5, 255, 0, 1],
                                     [576662.9701, 5188115.0602, 157.06, 6, 0, 1, 2])):
            for value, expected in zip(row, truth):
                self.assertAlmostEqual(value, expected, delta=1e-4)

    def test_a_tileset_is_a_cloud(self):
        table = b'{"POINTS_LENGTH":2,"POSITION":{"byteOffset":0}}'.ljust(52)
        points = struct.pack("<6f", 0, 0, 0, 1, 2, 3)
        head = struct.pack("<4s6I", b"pnts", 1, 28 + len(table) + len(points), len(table), len(points), 0, 0)
        (self.path / "a.pnts").write_bytes(head + table + points)
        tileset = self.path / "tileset.json"
        tileset.write_text(json.dumps({"asset": {"version": "1.0"}, "root": {
            "refine": "ADD", "content": {"uri": "a.pnts"},
            "transform": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4000000.0625, 5, 6, 1]}}))
        (info,) = json.loads(run("--json", "info", tileset).stdout)["files"]
        self.assertEqual((info["format"], info["points"]), ("3D Tiles", 2))
        done = run("convert", tileset, self.path / "a.xyz")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [list(map(float, line.split()[:3])) for line in (self.path / "a.xyz").read_text().splitlines()[1:]]
        self.assertEqual(rows, [[4000000.0625, 5, 6], [4000001.0625, 7, 9]])
        (self.path / "case.json").write_text('{"vestige":1,"layers":[]}')
        done = run("info", self.path / "case.json")
        self.assertEqual(done.returncode, 3)
        self.assertIn("a Vestige case", done.stderr)

    def test_convert_names_what_is_wrong(self):
        self.assertEqual(run("convert", self.cloud, self.path / "a.stl").returncode, 2)
        self.assertEqual(run("convert", self.cloud).returncode, 2)
        self.assertEqual(run("convert", self.path / "missing.ply", self.path / "a.las").returncode, 3)
        done = run("convert", self.cloud, "/proc/nowhere/a.las")
        self.assertEqual(done.returncode, 5)
        self.assertIn("/proc/nowhere/a.las", done.stderr)
        self.assertEqual([entry.name for entry in self.path.iterdir()], ["cloud.csv"])


if __name__ == "__main__":
    unittest.main()
