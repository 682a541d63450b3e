#!/usr/bin/env python3
"""The checker itself: a tree that keeps the rules passes, and each kind of offence is found."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent


class Checker(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        (self.root / "tests/layers").mkdir(parents=True)
        for name in ("arrows.txt", "foreign.txt"):
            shutil.copy(HERE / name, self.root / "tests/layers" / name)
        self.write("core/base/A.h", "#include <vector>\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_check(self):
        done = subprocess.run([sys.executable, HERE / "check_layers.py", self.root], capture_output=True, text=True)
        return done.returncode, done.stdout

    def assert_offence(self, name, text, words):
        self.write(name, text)
        code, output = self.run_check()
        self.assertEqual(code, 1, output)
        self.assertIn(words, output)

    def test_clean_tree_passes(self):
        self.write("core/io/B.cpp", '#include "core/base/A.h"\n#include <laszip/laszip_api.h>\n')
        self.assertEqual(self.run_check()[0], 0)

    def test_qt_in_core(self):
        self.assert_offence("core/io/B.cpp", "#include <QString>\n", "<QString>")

    def test_vtk_in_core(self):
        self.assert_offence("core/geometry/B.cpp", "#include <vtkPoints.h>\n", "<vtkPoints.h>")

    def test_vtk_in_another_ui_room(self):
        self.assert_offence("ui/panels/B.cpp", "#include <vtkPoints.h>\n", "<vtkPoints.h>")

    def test_arrow_that_its_row_does_not_name(self):
        self.assert_offence("core/io/B.cpp", '#include "core/filters/F.h"\n', "may not see core/filters")

    def test_core_sees_ui(self):
        self.assert_offence("core/pipeline/B.cpp", '#include "ui/view/SceneView.h"\n', "may not see ui/view")

    def test_room_without_a_row(self):
        self.assert_offence("core/magic/B.cpp", "", "not in tests/layers/arrows.txt")

    def test_file_too_long(self):
        self.assert_offence("core/base/B.cpp", "\n" * 601, "601 lines")

    def test_word_that_only_the_peers_may_have(self):
        self.write("tests/bench/peers/B.cpp", "#ifndef PCL_NO_PRECOMPILE\n")
        self.assertEqual(self.run_check()[0], 0)
        self.assert_offence("tests/bench/C.cpp", "#define PCL_NO_PRECOMPILE\n", "contains PCL_NO_PRECOMPILE")


if __name__ == "__main__":
    unittest.main()
