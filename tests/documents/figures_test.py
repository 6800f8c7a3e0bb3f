#!/usr/bin/env python3
"""Figures of docs/theory: each page has one, and the committed files are what the scripts of docs/figures write.

usage: figures_test.py
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as tree

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs/figures"
IMAGE = re.compile(r"^!\[([^\]\n]+)\]\(([^)\s]+)\)$", re.M)


def images(page):
    return IMAGE.findall(page.read_text(encoding="utf-8"))


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        folder = pathlib.Path(cls.directory.name)
        for script in FIGURES.glob("*.py"):
            shutil.copy(script, folder)
        for script in sorted(folder.glob("theory_*.py")):  # each writes beside itself
            subprocess.run([sys.executable, "-B", str(script)], check=True)
        cls.written = {path.name: path.read_bytes() for path in folder.glob("*.svg")}

    def test_committed_files_are_what_the_scripts_write(self):
        committed = {path.name: path.read_bytes() for path in FIGURES.glob("*.svg")}
        self.assertEqual(sorted(committed), sorted(self.written))
        for name, content in committed.items():
            with self.subTest(figure=name):
                self.assertTrue(content == self.written[name], "run the scripts of docs/figures again")

    def test_figures_are_small_and_readable(self):
        for name, content in self.written.items():
            with self.subTest(figure=name):
                self.assertLess(len(content), 8192)
                drawing = tree.fromstring(content)
                self.assertEqual(drawing.get("width"), "640")
                self.assertTrue(drawing.find("{*}title").text)
                height = float(drawing.get("height"))
                for text in drawing.iter("{http://www.w3.org/2000/svg}text"):
                    self.assertGreaterEqual(float(text.get("font-size", "14")), 13)
                    self.assertTrue(0 <= float(text.get("x")) <= 640 and 0 < float(text.get("y")) < height, text.get("y"))
                    self.assertTrue("".join(text.itertext()).strip())

    def test_each_page_has_a_figure(self):
        for page in sorted((ROOT / "docs/theory").glob("*.md")):
            with self.subTest(page=page.name):
                self.assertTrue(images(page))
                for caption, target in images(page):
                    self.assertTrue((page.parent / target).is_file(), target)
                    self.assertGreater(len(caption.split()), 4)

    def test_each_figure_is_on_a_page(self):
        shown = {(page.parent / target).resolve().name for page in (ROOT / "docs").rglob("*.md") for _, target in images(page)}
        self.assertEqual(set(self.written) - shown, set())


if __name__ == "__main__":
    unittest.main()
