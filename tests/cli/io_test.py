"""vestige-cli info and convert from outside: exit codes, JSON, sentences. Usage: io_test.py VESTIGE_CLI"""
import hashlib
import json
import os
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

    def test_a_part_of_a_file_is_converted(self):
        every = self.path / "every.csv"
        done = run("--json", "convert", "--every", "2", self.cloud, every)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["points"], 1)
        boxed = self.path / "boxed.csv"
        done = run("convert", "--box", "576662,5188115,0,576663,5188116,1000", self.cloud, boxed)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(boxed.read_text().splitlines()), 2)
        self.assertIn("576662.9701", boxed.read_text())
        for wrong in ("1,2,3", "1,2,3,0,5,6", "1,2,3,4,5,x"):
            self.assertEqual(run("convert", "--box", wrong, self.cloud, boxed).returncode, 2, wrong)
        self.assertEqual(run("convert", "--every", "0", self.cloud, boxed).returncode, 2)

    def test_what_does_not_fit_into_memory_is_refused_with_what_would(self):
        vast = self.path / "vast.las"
        self.assertEqual(run("convert", self.cloud, vast).returncode, 0)
        record = int.from_bytes(vast.read_bytes()[105:107], "little")
        start = int.from_bytes(vast.read_bytes()[96:100], "little")
        points = 50_000_000_000
        with open(vast, "r+b") as stream:
            stream.seek(247)
            stream.write(points.to_bytes(8, "little"))
            stream.truncate(start + points * record)
        for command in (["convert", vast, self.path / "out.ply"], ["screenshot", vast, "--out", self.path / "out.png"],
                        ["preprocess", vast, self.path / "out.las"]):
            done = run(*command)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("50 000 000 000 points need", done.stderr)
            self.assertIn("--every ", done.stderr)
            self.assertIn("--box ", done.stderr)
            self.assertFalse(pathlib.Path(command[-1]).exists())

    def test_a_cut_file_is_refused_and_its_whole_part_is_read_where_that_is_asked(self):
        cut = self.path / "cut.ply"
        self.assertEqual(run("convert", self.cloud, cut).returncode, 0)
        cut.write_bytes(cut.read_bytes()[:-3])
        refused = run("convert", cut, self.path / "a.las")
        self.assertEqual(refused.returncode, 3)
        self.assertIn(f"{cut}, byte ", refused.stderr)
        self.assertIn("the first 1 of 2 points are whole and can be read where damage is allowed (--salvage",
                      refused.stderr)
        self.assertFalse((self.path / "a.las").exists())
        done = run("convert", "--json", "--salvage", cut, self.path / "a.las")
        self.assertEqual(done.returncode, 0, done.stderr)
        answer = json.loads(done.stdout)
        self.assertEqual(answer["points"], 1)
        self.assertIn("the file is damaged, byte ", answer["warnings"][0])
        self.assertIn("the file is damaged, byte ", done.stderr)
        done = run("preprocess", "--salvage", cut, self.path / "b.las")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the file is damaged", done.stderr)

    def test_half_a_file_gives_half_its_points_where_that_is_asked(self):
        rows = [f"{i % 50},{i // 50},{i % 7},{i % 256},{i % 256},3" for i in range(2000)]
        self.cloud.write_text("x,y,z,red,green,blue\n" + "\n".join(rows) + "\n")
        for name in ("half.las", "half.ply", "half.pcd"):
            half, out = self.path / name, self.path / "out.csv"
            self.assertEqual(run("convert", self.cloud, half).returncode, 0)
            half.write_bytes(half.read_bytes()[:half.stat().st_size // 2])
            refused = run("convert", half, out)
            self.assertEqual(refused.returncode, 3, name)
            self.assertIn("--salvage", refused.stderr, name)
            done = run("convert", "--json", "--salvage", half, out)
            self.assertEqual(done.returncode, 0, done.stderr)
            points = json.loads(done.stdout)["points"]
            self.assertGreater(points, 800, name)
            self.assertLess(points, 1001, name)
            self.assertEqual(len(out.read_text().splitlines()), points + 1)
            out.unlink()

    def test_an_input_is_never_replaced(self):
        before = self.cloud.read_bytes()
        link, hard = self.path / "link.csv", self.path / "hard.csv"
        link.symlink_to(self.cloud)
        os.link(self.cloud, hard)
        for name in (self.cloud, link, hard, self.path / "." / "cloud.csv"):
            for command in (["convert", self.cloud, name], ["preprocess", self.cloud, name],
                            ["register", self.cloud, self.cloud, "--pose-out", name],
                            ["register", self.cloud, self.cloud, "--pose-out", self.path / "p.json", "--aligned", name],
                            ["accuracy", self.cloud, "--out", name]):
                done = run(*command)
                self.assertEqual(done.returncode, 2, command)
                self.assertIn("the output would replace an input", done.stderr)
        self.assertEqual(self.cloud.read_bytes(), before)
        done = run("screenshot", self.cloud, "--out", self.path / "picture.jpg")
        self.assertEqual(done.returncode, 2)

    def test_what_the_output_does_not_hold_is_told(self):
        fine, mesh = self.path / "fine.las", self.path / "mesh.ply"
        self.cloud.write_text("x,y,z\n0,0,0\n100,100,1\n")
        self.assertEqual(run("convert", self.cloud, self.path / "a.las").returncode, 0)
        done = run("convert", self.path / "a.las", fine, "--scale", "1e-9", "--offset", "1e9,0,0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("those of --scale do not fit", done.stderr)
        self.assertIn("--offset does not fit", done.stderr)
        self.assertNotIn("warning", run("convert", self.path / "a.las", fine, "--scale", "0.001").stderr)
        done = run("convert", self.path / "a.las", self.path / "a.ply", "--scale", "0.001")
        self.assertIn("--scale means nothing in its format", done.stderr)
        mesh.write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assertIn("1 triangle is left out", run("convert", mesh, self.path / "m.las").stderr)
        done = run("--json", "convert", "--box", "200,0,0,201,1,1", self.cloud, self.path / "none.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the box holds no point of it", json.loads(done.stdout)["warnings"][0])

    def test_hostile_files_end_with_a_sentence(self):
        head = b"ply\nformat ascii 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n"
        hostile = {
            "count.ply": head % b"99999999999999999" + b"end_header\n1 2 3\n",
            "number.ply": head % b"1" + b"end_header\n1 2 1e999\n",
            "infinite.xyz": b"1 2 3\n1 inf 3\n",
            "far.xyz": b"1 2 3e17\n",
            "name.csv": b"x,y,\x1b[31m\xff\n1,2,3\n",
            "huge.stl": b" " * 80 + b"\xff\xff\xff\xff" + b"1234",
            "zero.las": b"LASF" + bytes(400),
            "empty.laz": b"",
            "nothing.e57x": b"\0" * 5000,
        }
        for name, content in hostile.items():
            file = self.path / name
            file.write_bytes(content)
            for verb in (["info", file], ["convert", file, self.path / "out.las"]):
                done = subprocess.run([CLI, *map(str, verb)], capture_output=True, timeout=20)
                self.assertEqual(done.returncode, 3, (name, done.stderr))
                told = done.stderr.decode("utf-8")
                self.assertIn(str(file), told)
                self.assertNotIn("\x1b", told)
                self.assertRegex(told, "expected|readable")
            self.assertFalse((self.path / "out.las").exists())

    def test_scale_and_offset_stay_unless_others_are_asked_for(self):
        las = self.path / "a.las"
        done = run("convert", self.cloud, las, "--scale", "0.01", "--offset", "1000,2000,0")
        self.assertEqual(done.returncode, 0, done.stderr)
        (info,) = json.loads(run("--json", "info", las).stdout)["files"]
        self.assertEqual((info["scale"], info["offset"]), ([0.01] * 3, [1000, 2000, 0]))
        again = self.path / "b.laz"
        self.assertEqual(run("convert", las, again).returncode, 0)
        (kept,) = json.loads(run("--json", "info", again).stdout)["files"]
        self.assertEqual((kept["scale"], kept["offset"]), (info["scale"], info["offset"]))
        self.assertEqual(kept["bounds"], info["bounds"])

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

    def test_info_quick_tells_the_head_alone(self):
        scan = self.path / "scan.pcd"
        run("convert", self.cloud, scan)
        (info,) = json.loads(run("--json", "info", "--quick", scan).stdout)["files"]
        self.assertEqual((info["points"], info["attributes"]), (2, ["intensity", "color"]))
        self.assertEqual((info["sha256"], info["bounds"]), (None, None))
        # A text has no head: the rows may even be broken.
        broken = self.path / "broken.xyz"
        broken.write_text("1 2 3\n4 5\n")
        done = run("--json", "info", "--quick", broken)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["files"][0]["points"], 0)

    def test_info_tells_scans_and_units(self):
        scans = self.path / "scans.ptx"
        header = "0 0 2\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 2 1\n"
        scans.write_text("1\n2\n" + header + "1 2 3 0.5\n0 0 0 0.5\n1\n1\n" + header + "4 5 6 1\n")
        (info,) = json.loads(run("--json", "info", scans).stdout)["files"]
        self.assertEqual([scan["points"] for scan in info["scans"]], [1, 1])
        self.assertEqual(info["scans"][0]["pose"][11], 2)
        self.assertEqual((info["images"], info["damage"], info["metres_per_unit"], info["unit"]),
                         ([], None, None, None))
        self.assertIn("scan 2: 1 points", run("info", scans).stdout)
        flight = self.path / "a.sbet"
        flight.write_bytes(struct.pack("<17d", 100, 0.9, 0.2, 50, *[0] * 13) * 3)
        (info,) = json.loads(run("--json", "info", flight).stdout)["files"]
        self.assertEqual((info["points"], info["metres_per_unit"], info["unit"]), (3, 1, "m"))

    def test_einscan_markers_are_3_with_advice(self):
        markers = self.path / "markers.p3"
        markers.write_bytes(b"\x00\x01\x02")
        for arguments in (["info"], ["info", "--quick"]):
            done = run(*arguments, markers)
            self.assertEqual(done.returncode, 3)
            self.assertIn("ASC, PLY, OBJ or STL", done.stderr)

    def test_any_name_and_a_decimal_comma(self):
        environment = dict(os.environ, LC_ALL="de_DE.UTF-8", LOCPATH=str(self.path / "locales"))
        (self.path / "locales").mkdir()
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", self.path / "locales" / "de_DE.UTF-8"],
                       capture_output=True, check=False)
        truth = json.loads(run("--json", "info", self.cloud).stdout)["files"][0]
        for name in ("Straße Zürich.csv".encode(), "現場 測量.csv".encode(), b"caf\xe9.csv"):
            source = os.path.join(os.fsencode(self.path), name)
            target = source[:-4] + b".ply"
            with open(source, "wb") as file:
                file.write(self.cloud.read_bytes())
            done = subprocess.run([CLI, "convert", source, target], capture_output=True, env=environment, timeout=60)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = subprocess.run([CLI, "--json", "info", target], capture_output=True, env=environment, timeout=60)
            self.assertEqual(done.returncode, 0, done.stderr)
            (info,) = json.loads(done.stdout.decode())["files"]
            self.assertEqual(info["bounds"], truth["bounds"])


if __name__ == "__main__":
    unittest.main()
