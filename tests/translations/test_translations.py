#!/usr/bin/env python3
"""The tools of the translations: what they find in C++, and what they refuse.

test_translations.py FOLDER      of the tools
"""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, sys.argv.pop(1))

import check
import core_catalogue
import core_strings
import cpp_source
import ts_file


def texts(source):
    return [template.text for template in cpp_source.templates(source)]


class Templates(unittest.TestCase):
    def test_joins_adjacent_literals(self):
        self.assertEqual(texts('return fail(code, "one "\n    "sentence");'), ["one sentence"])

    def test_makes_places_of_what_is_joined(self):
        self.assertEqual(texts('auto t = "only " + percent(x) + " of " + name;'), ["only %1 of %2"])

    def test_reads_both_branches_of_a_conditional(self):
        source = 'f("a " + name + (n == 1 ? " was" : " were") + " found");'
        self.assertEqual(texts(source), ["a %1 was found", "a %1 were found"])

    def test_reads_conditions_and_comparisons_as_no_text(self):
        self.assertEqual(texts('if (key == "unit") x = a < b ? "less" : "more";'), ["unit", "less", "more"])

    def test_leaves_comments_and_directives_out(self):
        self.assertEqual(texts('#include "core/a.h"\n// "no"\n/* "no" */ f("yes"); // "no"'), ["yes"])

    def test_reads_escapes(self):
        self.assertEqual(texts(r'f("\u201ca\u201d \"b\"\n", "\xc2\xb0");'), ['\u201ca\u201d "b"\n', "\u00b0"])

    def test_does_not_trip_over_characters_and_separators(self):
        self.assertEqual(texts("f('\"', 1'000'000, \"after\");"), ["after"])

    def test_names_the_call(self):
        self.assertEqual([t.call for t in cpp_source.templates('say("a"); x.message("b");')], ["say", "message"])


class Collection(unittest.TestCase):
    def collected(self, path, source):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / path
            file.parent.mkdir(parents=True)
            file.write_text(source, encoding="utf-8")
            found = core_strings.collect(Path(folder))
        return {text for text, room in found.items() if room not in ("words", "vocabulary")}

    def test_takes_sentences_of_core_and_not_keys_or_queries(self):
        source = 'fail(code, "the file is gone", "layer", "see there"); json["rmse_m"]; run("SELECT a FROM b");'
        self.assertEqual(self.collected("core/io/A.cpp", source), {"the file is gone", "see there"})

    def test_takes_labels_and_choices_of_parameters(self):
        source = 'const ParameterTable& t() { static T t{{"voxel_m", "Voxel", {"none", "mean"}, "A help."}}; }'
        self.assertEqual(self.collected("core/filters/A.cpp", source), {"Voxel", "A help.", "none", "mean"})

    def test_takes_texts_of_actions(self):
        source = 'const ActionSpec a[] = {{"file.new", "&File", "&New", "Begin.", "new", "Ctrl+N", always}};'
        self.assertEqual(self.collected("ui/actions/A.cpp", source), {"&File", "&New", "Begin."})


class Refusals(unittest.TestCase):
    def refused(self, source, translation):
        return list(check.offences("x", source, translation))

    def test_accepts_a_translation(self):
        self.assertEqual(self.refused("&Open %1 of %2", "打开 %2 之 %1(&O)"), [])
        self.assertEqual(self.refused("%1 mm", "%1 mm"), [])

    def test_refuses_what_is_missing_or_the_same(self):
        self.assertTrue(self.refused("A word", ""))
        self.assertTrue(self.refused("A word", "A word"))

    def test_refuses_other_places_mnemonics_and_tags(self):
        self.assertTrue(self.refused("%1 of %2", "%1 之 %1"))
        self.assertTrue(self.refused("&Open", "打开"))
        self.assertTrue(self.refused("<b>Open</b>", "打开"))

    def test_tells_what_the_tree_does_not_say_any_more(self):
        lines = list(check.compare("x", {("a", "new")}, [("a", "old", "旧", "")]))
        self.assertEqual(len(lines), 2)


class Files(unittest.TestCase):
    def test_writes_what_it_reads(self):
        rows = [("b", 'say "<%1>" & more\nlines', "说“<%1>”"), ("a", "x", "")]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.ts"
            ts_file.write(path, rows, "zh_CN")
            self.assertEqual([row[:3] for row in ts_file.read(path)], sorted(rows))
            out = Path(folder) / "generated/a.cpp"
            core_catalogue.compile_to(path, out)
            self.assertIn('{"say \\"<%1>\\" & more\\nlines", "说“<%1>”"}', out.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
