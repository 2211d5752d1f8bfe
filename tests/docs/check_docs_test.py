"""Plants each fault in a copy of the sources and docs and expects check_docs.py to name it, and nothing else.

usage: check_docs_test.py ROOT
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).with_name("check_docs.py")
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
PAGE = "docs/theory/planted.md"


class CheckDocs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name) / "copy"

        def copy(file, to):
            if file.endswith(".md"):
                shutil.copyfile(file, to)
            else:
                pathlib.Path(to).touch()  # only its existence matters
        cited = "\n".join(page.read_text(encoding="utf-8") for page in (ROOT / "docs").rglob("*.md"))

        def left_out(where, names):
            if pathlib.Path(where) == ROOT:
                return [name for name in names if name.startswith(("build", ".")) or name in {"out", "runs"}]
            return [name for name in names if name.endswith((".h", ".cpp")) and name not in cited]
        shutil.copytree(ROOT, cls.root, copy_function=copy, ignore=left_out)

    def check(self, root=None):
        done = subprocess.run([sys.executable, "-B", CHECK, root or self.root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.splitlines()[:-1]

    def planted(self, name, text):
        """Faults reported for a file that contains this text."""
        path = self.root / name
        self.assertFalse(path.exists())
        path.write_text(text, encoding="utf-8")
        try:
            return self.check()
        finally:
            path.unlink()

    def test_sources_as_they_are_pass(self):
        self.assertEqual(self.check(ROOT), (0, []))
        self.assertEqual(self.check(), (0, []))

    def expect_in_source(self, comment, *faults):
        lines = comment.splitlines()
        code, found = self.planted("nmm/planted.h", "#pragma once\n" + comment + "\nstruct Planted {};\n")
        self.assertEqual(found, [f"nmm/planted.h:{fault}" for fault in faults], lines)
        self.assertEqual(code, 1 if faults else 0)

    def test_source_with_key_or_section_passes(self):
        self.expect_in_source("/// @source [Qu2013] eq. 7.56; [FIPS180-4] section 6.2")
        self.expect_in_source('/// @pre x > 0     @source docs/theory/dda.md, "Affine form"')
        self.expect_in_source("/// @source snap rounding of lines,\n///         as in [Hobby1999]")

    def test_unknown_key_is_named(self):
        self.expect_in_source("/// @source [Nobody1999] eq. 3", "2: docs/bibliography.md has no [Nobody1999]")
        self.expect_in_source("/// @source [Qu2013] 3.1; two lines,\n///         the second with [Nobody1999]",
                              "2: docs/bibliography.md has no [Nobody1999]")

    def test_source_without_key_is_named(self):
        self.expect_in_source("/// @source Shi 1988", "2: @source names no key of docs/bibliography.md and no section of docs/theory: Shi 1988")

    def test_document_outside_is_named(self):
        self.expect_in_source("/// @source thesis 3.2; [Qu2013] 3.2", "2: 'thesis' in a @source: name the key")

    def test_dead_section_is_named(self):
        self.expect_in_source('/// @source docs/theory/dda.md, "No such section"', '2: docs/theory/dda.md has no section "No such section"')
        self.expect_in_source("/// @source docs/theory/dda.md", "2: no section of docs/theory/dda.md is named")

    def test_page_that_is_not_there_is_named(self):
        self.expect_in_source("int x;  // see contact.md, 3", "2: no page contact.md")
        self.expect_in_source('/// @source docs/theory/none.md, "Ties"', "2: no file docs/theory/none.md", "2: no page docs/theory/none.md")

    def expect_in_page(self, line, *faults):
        code, found = self.planted(PAGE, f"# Planted\n\n{line}\n\n## Here it is\n")
        self.assertEqual(found, [f"{PAGE}:3: {fault}" for fault in faults], line)
        self.assertEqual(code, 1 if faults else 0)

    def test_links_that_lead_somewhere_pass(self):
        self.expect_in_page("[a](dda.md#affine-form), [b](#here-it-is), [c](../../README.md), [d](https://example.org/x), [Qu2013], `nmm/ties.cpp`")
        self.expect_in_page("`[a](dead.md)` is code, and so is `build/none`")

    def test_dead_link_is_named(self):
        self.expect_in_page("[a](none.md)", "no file none.md")
        self.expect_in_page("![a picture](../images/none.png)", "no file ../images/none.png")
        self.expect_in_page("[key]: none.md", "no file none.md")

    def test_dead_anchor_is_named(self):
        self.expect_in_page("[a](dda.md#no-such-section)", "no anchor dda.md#no-such-section")
        self.expect_in_page("[a](#nowhere)", "no anchor #nowhere")

    def test_path_that_is_not_there_is_named(self):
        self.expect_in_page("held by `nmm/none.h`", "no file nmm/none.h")

    def test_unknown_key_on_a_page_is_named(self):
        self.expect_in_page("after [Nobody1999] eq. 3", "docs/bibliography.md has no [Nobody1999]")

    def test_readme_is_read(self):
        path = self.root / "README.md"
        before = path.read_text(encoding="utf-8")
        path.write_text("[a](docs/none.md)\n" + before, encoding="utf-8")
        code, lines = self.check()
        path.write_text(before, encoding="utf-8")
        self.assertEqual((code, lines), (1, ["README.md:1: no file docs/none.md"]))

    def test_empty_tree_is_an_error(self):
        with tempfile.TemporaryDirectory() as empty:
            done = subprocess.run([sys.executable, "-B", CHECK, empty], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
