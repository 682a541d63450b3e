"""vestige-cli killed with SIGKILL at random moments: outputs are the old or the new, whole. Also evidence that has
changed, and unsaved edits of a store. Usage: killed_test.py VESTIGE_CLI [KILLS]"""
import hashlib
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

CLI = sys.argv[1]
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 12
sys.argv[1:] = []


def run(*arguments):
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def killed_after(seconds, *arguments):
    """Exit status; negative when it was killed."""
    with subprocess.Popen([CLI, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as job:
        try:
            return job.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            job.send_signal(signal.SIGKILL)
            return job.wait()


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def cloud(path, count, step):
    path.write_text("".join(f"{i % 100 * step} {i // 100 * step} {(i * 7 % 13) * 0.01}\n" for i in range(count)))


class Killed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.random = random.Random(20261127)

    def timed(self, *arguments):
        begin = time.monotonic()
        done = run(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return time.monotonic() - begin

    def test_convert_leaves_the_old_or_the_new_file(self):
        out = self.path / "out.laz"
        wanted = {}
        for name, step in (("a", 0.25), ("b", 0.5)):
            cloud(self.path / f"{name}.xyz", 60000, step)
            seconds = self.timed("convert", self.path / f"{name}.xyz", out)
            wanted[name] = digest(out)
        for i in range(KILLS):
            killed_after(self.random.uniform(0, 1.1 * seconds), "convert", self.path / f"{'ab'[i % 2]}.xyz", out)
            self.assertIn(digest(out), wanted.values())
        self.timed("convert", self.path / "a.xyz", out)
        self.assertEqual(digest(out), wanted["a"])
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["a.xyz", "b.xyz", "out.laz"])

    def case(self, name, step, **layer):
        cloud(self.path / f"{name}.xyz", 2000, step)
        file = self.path / f"{name}.json"
        file.write_text(json.dumps({
            "vestige": 1, "name": name, "preprocess": {"filter": "none", "voxel_m": 0.2},
            "layers": [{"id": "aerial", "role": "aerial", "path": f"{name}.xyz", "unit": "m", **layer}],
            "measurements": [{"object": "side", "tape_m": 1.0,
                              "picks": {"aerial": [[[0, 0, 0], [step, 0, 0]]] * 3}}]}))
        return file

    def whole(self, out):
        """The manifest's hashes are those of the files, and there are no others."""
        manifest = json.loads((out / "manifest.json").read_text())
        for entry in manifest["outputs"]:
            if entry["path"] != "manifest.json":
                self.assertEqual(digest(out / entry["path"]), entry["sha256"], entry["path"])
        return manifest["case"]["name"]

    def test_reconstruct_leaves_the_old_or_the_new_folder(self):
        out = self.path / "out"
        cases = [self.case("a", 0.25), self.case("b", 0.5)]
        seconds = [self.timed("reconstruct", case, "--out", out) for case in cases][-1]
        self.assertEqual(self.whole(out), "b")
        for i in range(max(3, KILLS // 3)):
            # Mostly at the end, where files are put in place.
            late = self.random.uniform(0.8, 1.05) if i % 3 else self.random.uniform(0, 1)
            killed_after(late * seconds, "reconstruct", cases[i % 2], "--out", out)
            self.assertIn(self.whole(out), ("a", "b"))
        self.timed("reconstruct", cases[0], "--out", out)
        self.assertEqual(self.whole(out), "a")
        self.assertEqual([p.name for p in self.path.iterdir() if p.name.startswith(".")], [])

    def test_reconstruct_tells_that_evidence_has_changed(self):
        case = self.case("a", 0.25)
        found = digest(self.path / "a.xyz")
        expected = "0" * 63 + "1"
        case = self.case("a", 0.25, sha256=expected, bytes=17, modified="2026-11-27T03:00:00Z")
        done = run("--json", "reconstruct", case, "--out", self.path / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in (done.stderr, "\n".join(json.loads(done.stdout)["warnings"])):
            for word in ("layer 'aerial'", str(self.path / "a.xyz"), expected, found, "2026-11-27T03:00:00Z"):
                self.assertIn(word, words)
        (layer,) = json.loads(done.stdout)["layers"]
        self.assertEqual((layer["changed"], layer["sha256_expected"], layer["sha256"]), (True, expected, found))
        done = run("--json", "reconstruct", self.case("a", 0.25, sha256=found), "--out", self.path / "out")
        (layer,) = json.loads(done.stdout)["layers"]
        self.assertFalse(layer["changed"])
        done = run("reconstruct", self.case("a", 0.25, sha256="beef"), "--out", self.path / "out")
        self.assertEqual(done.returncode, 3)
        self.assertIn("layers[0].sha256", done.stderr)


if __name__ == "__main__":
    unittest.main()
