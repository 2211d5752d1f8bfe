"""Plants each forbidden arrow in a copy of the sources and expects check_arrows.py to name it, and nothing else.

usage: check_arrows_test.py ROOT
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).with_name("check_arrows.py")
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
LAYERS = ["model", "nmm", "dda", "coupling", "io", "app"]
# Written out, not taken from the checker, so that a mistake in its table is detected.
FORBIDDEN = {
    "model": ["nmm", "dda", "coupling", "io", "app", "tests"],
    "nmm": ["dda", "coupling", "io", "app", "tests"],
    "dda": ["nmm", "coupling", "io", "app", "tests"],
    "coupling": ["io", "app", "tests"],
    "io": ["nmm", "dda", "app", "tests"],
    "app": ["tests"],
}
FORBIDDEN_INSIDE = {
    "io/text": ["io/case", "io/results", "io/pictures", "io/checkpoint", "io/live", "io/watch"],
    "io/drawing": ["io/case", "io/results", "io/pictures"],
    "io/case": ["io/results", "io/pictures", "io/checkpoint", "io/live", "io/watch"],
    "io/results": ["io/case", "io/pictures", "io/checkpoint", "io/live", "io/watch"],
    "io/pictures": ["io/case", "io/checkpoint", "io/live", "io/watch", "io/report", "io/serve"],
    "io/checkpoint": ["io/case", "io/pictures", "io/live", "io/watch"],
    "io/live": ["io/case", "io/pictures", "io/checkpoint", "io/watch"],
    "io/watch": ["io/case", "io/pictures", "io/checkpoint"],
    "io/report": ["io/case", "io/checkpoint", "io/live", "io/serve", "io/watch"],
    "io/serve": ["io/case", "io/checkpoint", "io/pictures", "io/watch"],
    "io/viewer": ["io/report", "io/results", "io/pictures", "io/serve"],
}


class CheckArrows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for layer in LAYERS:
            shutil.copytree(ROOT / layer, self.root / layer,
                            ignore=lambda where, names: [n for n in names if (pathlib.Path(where) / n).is_file() and
                                                         not n.endswith((".h", ".hpp", ".cpp", ".txt"))])

    def check(self):
        done = subprocess.run([sys.executable, CHECK, self.root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()[:-1]

    def test_sources_as_they_are_pass(self):
        self.assertEqual(self.check(), (0, []))

    def test_forbidden_include_is_named(self):
        for layer, targets in FORBIDDEN.items():
            with self.subTest(layer=layer):
                planted = self.root / layer / "deep" / "planted.h"
                planted.parent.mkdir(exist_ok=True)
                planted.write_text("#pragma once\n" + "".join(f'#include "{t}/some.h"\n  #  include <{t}/some.h>  // why\n'
                                                              for t in targets))
                code, lines = self.check()
                shutil.rmtree(planted.parent)
                self.assertEqual(lines, [f"{layer}/deep/planted.h:{line}: {layer} may not include {t}/some.h"
                                         for i, t in enumerate(targets) for line in (2 * i + 2, 2 * i + 3)])
                self.assertEqual(code, 1)

    def test_forbidden_include_inside_io_is_named(self):
        expected = []
        for folder, targets in sorted(FORBIDDEN_INSIDE.items()):
            (self.root / folder / "planted.cpp").write_text("".join(f'#include "{t}/some.h"\n' for t in targets))
            expected += [f"{folder}/planted.cpp:{i}: {folder} may not include {t}/some.h" for i, t in enumerate(targets, 1)]
        self.assertEqual(self.check(), (1, expected))

    def test_every_folder_of_io_has_its_rule(self):
        folders = {f"io/{p.parent.name}" for p in (self.root / "io").glob("*/*") if p.suffix in {".h", ".cpp"}}
        self.assertEqual(folders, set(FORBIDDEN_INSIDE))

    def test_missing_definition_of_eigen_is_named(self):
        planted = self.root / "nmm/planted.cpp"
        planted.write_text("#include <Eigen/Core>\nEigen::Matrix2d of(Eigen::Matrix2d m) { return m.inverse(); }\n")
        self.assertEqual(self.check(), (1, ["nmm/planted.cpp: calls inverse() or determinant() and does not include <Eigen/LU>"]))
        planted.write_text(planted.read_text().replace("Core", "LU"))
        self.assertEqual(self.check(), (0, []))

    def test_include_by_relative_path_is_named(self):
        (self.root / "nmm/target.h").write_text("")
        (self.root / "dda/planted.cpp").write_text('#include "../nmm/target.h"\n')
        code, lines = self.check()
        self.assertEqual(lines, ["dda/planted.cpp:1: dda may not include ../nmm/target.h"])
        self.assertEqual(code, 1)

    def test_forbidden_link_is_named(self):
        for layer, word in [("nmm", "scree::dda"), ("dda", "scree_nmm"), ("nmm", "scree::coupling"),
                            ("dda", "spdlog::spdlog"), ("model", "scree::nmm"), ("coupling", "scree::io")]:
            with self.subTest(layer=layer, word=word):
                lists = self.root / layer / "CMakeLists.txt"
                before = lists.read_text()
                lists.write_text(before + f"target_link_libraries(scree_{layer}\n  PRIVATE {word})\n")
                code, lines = self.check()
                lists.write_text(before)
                self.assertEqual(lines, [f"{layer}/CMakeLists.txt: {layer} may not link {word}"])
                self.assertEqual(code, 1)

    def test_include_from_a_room_above_is_named(self):
        for here, there in [("coupling/bodies", "coupling/stages"), ("coupling/contact/law", "coupling/contact/table"),
                            ("coupling/linear", "coupling/bodies"), ("coupling/contact/audit", "coupling/contact"),
                            ("coupling/integrate", "coupling/stages"), ("coupling/contact", "coupling/integrate")]:
            with self.subTest(here=here, there=there):
                planted = self.root / here / "planted.h"
                planted.write_text(f'#include "{there}/some.h"\n')
                code, lines = self.check()
                planted.unlink()
                self.assertEqual(lines[0], f"{here}/planted.h:1: {here} may not include from {there}")
                self.assertEqual(code, 1)

    def test_room_without_a_place_is_named(self):
        (self.root / "coupling/attic").mkdir()
        (self.root / "coupling/attic/planted.h").write_text('#include "coupling/bodies/setup.h"\n')
        code, lines = self.check()
        self.assertEqual(lines, ["coupling/attic/planted.h:1: coupling/attic has no place in ROOMS of check_arrows.py"])
        self.assertEqual(code, 1)

    def test_circle_of_folders_is_named(self):
        for here, there in [("io/one", "io/two"), ("io/two", "io/three"), ("io/three", "io/one")]:
            (self.root / here).mkdir()
            (self.root / here / "planted.h").write_text(f'#include "{there}/planted.h"\n')
        code, lines = self.check()
        self.assertEqual(lines, ["folders that include each other: io/one, io/three, io/two"])
        self.assertEqual(code, 1)

    def test_empty_tree_is_an_error(self):
        for layer in LAYERS:
            shutil.rmtree(self.root / layer)
        self.assertEqual(self.check()[0], 2)


if __name__ == "__main__":
    unittest.main()
