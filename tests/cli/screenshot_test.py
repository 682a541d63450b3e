#!/usr/bin/env python3
"""`vestige-cli screenshot` from outside, with no display.

screenshot_test.py VESTIGE_CLI
"""
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from png import picture

CLI = sys.argv[1]
ENVIRONMENT = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}


def cli(*arguments, code=0):
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=120, env=ENVIRONMENT)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: exit {done.returncode}, expected {code}\n{done.stdout}\n{done.stderr}")
    return done


def bright(rows):
    return sum(max(pixel) > 90 for row in rows for pixel in row)


class Screenshot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        chance = random.Random(1)
        self.site = self.folder / "site.xyz"
        self.site.write_text("".join(
            f"{483400 + chance.uniform(0, 10):.4f} {4375661 + chance.uniform(0, 10):.4f} {35 + chance.gauss(0, .02):.4f}\n"
            for _ in range(20000)))
        self.box = self.folder / "box.xyz"
        self.box.write_text("".join(
            f"{483404 + chance.uniform(0, 1):.4f} {4375665 + chance.uniform(0, 1):.4f} {36 + chance.gauss(0, .02):.4f}\n"
            for _ in range(2000)))

    def test_draws_files_of_the_size_asked_for(self):
        out = self.folder / "new" / "p.png"
        done = cli("--json", "screenshot", self.site, self.box, "--out", out, "--size", "320x200", "--view", "top")
        told = json.loads(done.stdout)
        self.assertEqual((told["width"], told["height"]), (320, 200))
        self.assertEqual([layer["points"] for layer in told["layers"]], [20000, 2000])
        width, height, rows = picture(out)
        self.assertEqual((width, height), (320, 200))
        self.assertGreater(bright(rows), 0.2 * width * height)

    def test_the_same_bytes_again_and_for_any_threads(self):
        files = []
        for threads in (1, 1, 3):
            files.append(self.folder / f"{len(files)}.png")
            cli("--threads", threads, "screenshot", self.site, self.box, "--out", files[-1], "--size", "320x200")
        self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
        self.assertEqual(files[0].read_bytes(), files[2].read_bytes())

    def test_views_and_overlays_differ(self):
        seen = set()
        for options in ([], ["--view", "iso"], ["--view", "front"], ["--view", "left"], ["--view", "top"],
                        ["--view", "back"], ["--view", "right"], ["--view", "bottom"],
                        ["--overlay", "registration"], ["--overlay", "residual"], ["--overlay", "source"]):
            out = self.folder / "p.png"
            cli("screenshot", self.site, self.box, "--out", out, "--size", "200x120", *options)
            seen.add(out.read_bytes())
        self.assertEqual(len(seen), 11)

    def test_registration_tints_the_source_orange(self):
        out = self.folder / "p.png"
        cli("screenshot", self.site, self.box, "--out", out, "--size", "320x200", "--view", "top",
            "--overlay", "registration")
        _, _, rows = picture(out)
        orange = sum(r > 150 and r > b + 80 for row in rows for r, g, b in row)
        bluish = sum(b > 90 and b > r + 20 for row in rows for r, g, b in row)
        self.assertGreater(orange, 50)
        self.assertGreater(bluish, 50)

    def test_a_case(self):
        (self.folder / "case.json").write_text(json.dumps({
            "vestige": 1, "name": "Two clouds",
            "layers": [{"id": "aerial", "role": "aerial", "path": "site.xyz", "unit": "m"}],
            "registration": {"target": "aerial"},
            "measurements": [{"object": "Width of the site", "tape_m": 10.0, "picks": {"aerial": [
                [[483400.1, 4375666, 35], [483409.9, 4375666, 35]]]}}]}))
        out = self.folder / "p.png"
        cli("screenshot", self.folder / "case.json", "--out", out, "--size", "600x400", "--view", "top")
        _, _, rows = picture(out)
        longest = max(sum(min(pixel) > 200 for pixel in row) for row in rows[180:221])
        self.assertGreater(longest, 200, "the measured line is drawn")

    def test_a_tileset_is_shown_as_a_cloud(self):
        chance = random.Random(3)
        table = b'{"POINTS_LENGTH":5000,"POSITION":{"byteOffset":0},"CONSTANT_RGBA":[250,250,250,255]}'.ljust(92)
        points = struct.pack("<15000f", *(chance.uniform(0, 10) for _ in range(15000)))
        head = struct.pack("<4s6I", b"pnts", 1, 28 + len(table) + len(points), len(table), len(points), 0, 0)
        (self.folder / "a.pnts").write_bytes(head + table + points)
        tileset = self.folder / "tileset.json"
        tileset.write_text(json.dumps({"asset": {"version": "1.0"}, "geometricError": 1,
                                       "root": {"refine": "ADD", "content": {"uri": "a.pnts"}}}))
        out = self.folder / "p.png"
        done = cli("--json", "screenshot", tileset, "--out", out, "--size", "320x200")
        self.assertEqual([layer["points"] for layer in json.loads(done.stdout)["layers"]], [5000])
        cli("screenshot", tileset, "--out", out, "--size", "1200x800", "--window")
        width, height, rows = picture(out)
        self.assertGreater(bright(rows), 0.005 * width * height)

    def test_a_case_shows_its_scans_registered(self):
        """A scan in its own frame, millimetres, must not move the picture away from the site."""
        chance = random.Random(2)
        corner = [(u, v, w) for u, v, w in ((chance.random(), chance.random(), chance.random()) for _ in range(6000))]
        # Three walls of a corner, 4 m long; the same for both, with noise of their own.
        walls = [((4 * u, 4 * v, 0), (4 * u, 0, 4 * v), (0, 4 * u, 4 * v))[int(3 * w)] for u, v, w in corner]
        noise = lambda: chance.gauss(0, 0.005)
        (self.folder / "room.xyz").write_text("".join(
            f"{483400 + x + noise():.4f} {4375661 + y + noise():.4f} {35 + z + noise():.4f}\n" for x, y, z in walls))
        (self.folder / "scan.xyz").write_text("".join(
            f"{1000 * (x + noise()):.2f} {1000 * (y + noise()):.2f} {1000 * (z + noise()):.2f}\n" for x, y, z in walls))
        pose = [1, 0, 0, 483400.03, 0, 1, 0, 4375661.02, 0, 0, 1, 35.02, 0, 0, 0, 1]
        (self.folder / "case.json").write_text(json.dumps({
            "vestige": 1, "name": "Corner",
            "layers": [{"id": "aerial", "role": "aerial", "path": "room.xyz", "unit": "m"},
                       {"id": "scan", "role": "handheld", "path": "scan.xyz", "unit": "mm",
                        "init": {"pose": pose, "scale": 0.001}}],
            "registration": {"target": "aerial"}}))
        out = self.folder / "p.png"
        done = cli("--json", "screenshot", self.folder / "case.json", "--out", out, "--size", "320x200")
        self.assertEqual(len(json.loads(done.stdout)["layers"]), 2)
        width, height, rows = picture(out)
        self.assertGreater(bright(rows), 0.1 * width * height)

    def test_the_whole_window(self):
        out = self.folder / "w.png"
        cli("screenshot", self.site, self.box, "--out", out, "--size", "1200x800", "--window")
        width, height, rows = picture(out)
        self.assertEqual((width, height), (1200, 800))
        self.assertGreater(bright(rows), 0.02 * width * height)
        cli("screenshot", self.folder / "none.las", "--out", self.folder / "n.png", "--window", code=3)
        cli("screenshot", self.site, "--out", self.site / "w.png", "--window", code=5)

    def test_what_the_window_would_not_show_is_refused(self):
        for own in (["--section", "0,0,0,1,1,1"], ["--scale", "100", "--view", "top"], ["--color", "height"]):
            cli("screenshot", self.site, "--out", self.folder / "n.png", "--window", *own, code=2)

    def block(self):
        """Corners of a box of 4 x 2 x 1 m, in a colour that nothing else has, and grey points between them."""
        corners = [(483404 + x, 4375665 + y, 35 + z) for x in (0, 4) for y in (0, 2) for z in (0, 1)]
        chance = random.Random(5)
        grey = [(483404 + chance.uniform(.3, 3.7), 4375665 + chance.uniform(.3, 1.7), 35 + chance.uniform(.3, .7))
                for _ in range(500)]
        ply = self.folder / "block.ply"
        ply.write_text("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
                       "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "end_header\n" % (len(corners) + len(grey))
                       + "".join(f"{x} {y} {z} 255 0 255\n" for x, y, z in corners)
                       + "".join(f"{x:.4f} {y:.4f} {z:.4f} 90 90 90\n" for x, y, z in grey))
        return ply

    def spots(self, rows):
        """Middles of the four spots of that colour, which lie in the four quarters of the picture."""
        found = {}
        for y, row in enumerate(rows):
            for x, (r, g, b) in enumerate(row):
                if r > 120 and b > 120 and g < 60:
                    spot = found.setdefault((x > len(row) / 2, y > len(rows) / 2), [])
                    spot.append((x + .5, y + .5))
        self.assertEqual(len(found), 4)
        middle = lambda spot: tuple(sum(part) / len(spot) for part in zip(*spot))
        return {place: middle(spot) for place, spot in found.items()}

    def test_a_picture_to_scale_measures_what_the_scene_does(self):
        block, out = self.block(), self.folder / "scale.png"
        for view, scale, dpi, across, down in (("top", 100, 300, 4, 2), ("front", 50, 200, 4, 1), ("left", 25, 150, 2, 1)):
            done = cli("--json", "screenshot", block, "--out", out, "--view", view, "--scale", scale, "--dpi", dpi,
                       "--size", "900x700", "--color", "rgb")
            metre = dpi / .0254 / scale
            told = json.loads(done.stdout)
            self.assertEqual((told["width"], told["height"], told["scale"], told["dpi"]), (900, 700, scale, dpi))
            self.assertAlmostEqual(told["pixels_per_m"], metre)
            width, height, rows = picture(out)
            self.assertEqual((width, height), (900, 700))
            spots = self.spots(rows)
            for low in (False, True):
                self.assertAlmostEqual(spots[True, low][0] - spots[False, low][0], across * metre, delta=1)
            for right in (False, True):
                self.assertAlmostEqual(spots[right, True][1] - spots[right, False][1], down * metre, delta=1)
            data = out.read_bytes()
            place = data.index(b"pHYs") + 4
            dots = round(dpi / .0254)
            self.assertEqual(struct.unpack(">IIB", data[place:place + 9]), (dots, dots, 1))

    def test_a_picture_to_scale_holds_all_there_is(self):
        out = self.folder / "scale.png"
        cli("screenshot", self.block(), "--out", out, "--view", "top", "--scale", 100, "--color", "rgb")
        width, height, rows = picture(out)
        metre, margin = 300 / .0254 / 100, 2 * .01 * 300 / .0254
        self.assertAlmostEqual(width, 4 * metre + margin, delta=8)
        self.assertAlmostEqual(height, 2 * metre + margin, delta=8)
        spots = self.spots(rows)
        self.assertAlmostEqual(spots[True, True][0] - spots[False, True][0], 4 * metre, delta=1)
        done = cli("screenshot", self.block(), "--out", out, "--scale", 100, code=2)
        self.assertIn("perspective has no scale", done.stderr)

    def test_a_large_picture_is_drawn_in_parts(self):
        out = self.folder / "large.png"
        cli("screenshot", self.block(), "--out", out, "--view", "top", "--size", "5000x300", "--color", "rgb",
            "--point-size", 3)
        width, height, rows = picture(out)
        self.assertEqual((width, height), (5000, 300))
        self.spots(rows)

    def test_a_section_shows_only_what_lies_in_it(self):
        out = self.folder / "p.png"
        cli("screenshot", self.block(), "--out", out, "--view", "top", "--size", "600x400", "--color", "rgb",
            "--section", "483403,4375664,34,483407,4375668,37")
        _, _, rows = picture(out)
        found = [(x, y) for y, row in enumerate(rows) for x, (r, g, b) in enumerate(row) if r > 120 and b > 120 and g < 60]
        self.assertTrue(found)
        self.assertTrue(all(x < 300 for x, y in found), "the corners with the larger x are cut away")

    def test_a_section_can_be_inverted(self):
        out = self.folder / "p.png"
        for inverted in (False, True):
            cli("screenshot", self.block(), "--out", out, "--view", "top", "--size", "600x400", "--color", "rgb",
                "--section", "483403,4375664,34,483406,4375668,37", *(["--section-invert"] if inverted else []))
            _, _, rows = picture(out)
            found = [x for row in rows for x, (r, g, b) in enumerate(row) if r > 120 and b > 120 and g < 60]
            self.assertTrue(found)
            # The corners left stand at the outer end of the half that is left.
            self.assertTrue(all((x > 300) == inverted for x in found))
        done = cli("screenshot", self.block(), "--out", out, "--section-invert", code=2)
        self.assertIn("no section to invert", done.stderr)

    def test_colours_by_class_and_range(self):
        plain, out = self.folder / "a.png", self.folder / "b.png"
        cli("screenshot", self.site, "--out", plain, "--size", "320x200", "--view", "top")
        seen = {plain.read_bytes()}
        for options in (["--map", "viridis"], ["--range", "30,40"], ["--grid"], ["--north"], ["--color", "class"],
                        ["--transparent"]):
            cli("screenshot", self.site, "--out", out, "--size", "320x200", "--view", "top", *options)
            seen.add(out.read_bytes())
        self.assertEqual(len(seen), 7)

    def test_a_saved_view_of_the_case(self):
        site = {"position": [483405, 4375666, 60], "focal_point": [483405, 4375666, 35], "view_up": [0, 1, 0],
                "parallel": True, "half_height_m": 3, "width_px": 600, "height_px": 400}
        (self.folder / "case.json").write_text(json.dumps({
            "vestige": 1, "name": "Two clouds",
            "layers": [{"id": "aerial", "role": "aerial", "path": "site.xyz", "unit": "m"}],
            "saved_views": [{"name": "The middle", "camera": site, "scale": 50}]}))
        out = self.folder / "p.png"
        done = cli("--json", "screenshot", self.folder / "case.json", "--out", out, "--saved-view", "The middle",
                   "--size", "600x400")
        told = json.loads(done.stdout)
        self.assertEqual((told["scale"], told["dpi"], told["saved_view"]), (50, 300, "The middle"))
        done = cli("screenshot", self.folder / "case.json", "--out", out, "--saved-view", "Another", code=2)
        self.assertIn("The middle", done.stderr)

    def test_a_wrong_command_line_is_2(self):
        out = self.folder / "p.png"
        for options in (["--scale", "-1"], ["--dpi", "3"], ["--section", "0,0,0,1,1"], ["--range", "2,1"],
                        ["--section", "0,0,0,0,1,1"], ["--map", "jet"], ["--saved-view", "x"]):
            cli("screenshot", self.site, "--out", out, *options, code=2)
        for options in (["--size", "12"], ["--size", "0x0"], ["--view", "below"], ["--overlay", "some"]):
            cli("screenshot", self.site, "--out", out, *options, code=2)
        cli("screenshot", self.site, code=2)
        self.assertFalse(out.exists())

    def test_a_missing_input_is_3_and_is_named(self):
        done = cli("screenshot", self.folder / "none.las", "--out", self.folder / "p.png", code=3)
        self.assertIn("none.las", done.stderr)
        self.assertFalse((self.folder / "p.png").exists())

    def test_an_unwritable_output_is_5_and_leaves_what_was_there(self):
        before = self.site.read_bytes()
        cli("screenshot", self.site, "--out", self.site / "p.png", "--size", "64x64", code=5)
        self.assertEqual(self.site.read_bytes(), before)
        self.assertEqual({file.name for file in self.folder.iterdir()}, {"site.xyz", "box.xyz"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
