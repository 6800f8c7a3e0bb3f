#!/usr/bin/env python3
"""The page of a scene: it needs no network, texts stay texts, and in a browser it moves, zooms and knows its orbits.

usage: section_page_test.py PROGRAM     (the browser part: if chromium is installed)
"""

import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SCENE = """
[system]
kind = "vector-field"
coordinates = ["x", "y"]
[system.field]
x = "y"
y = "-x"
[scene]
title = "1 < 2 & </script><script>document.title = 3</script>"
section = "y"
direction = "both"
plot = ["x", "y"]
states = [[1, 0], [2, 0], [3, 0]]
crossings = 6
"""

# What a user does; the answers go into the page.
ACTIONS = """
<script>
const told = [], tell = x => told.push(x);
const at = (type, x, y, more) => {
  const box = canvas.getBoundingClientRect(), kind = type === "wheel" ? WheelEvent : PointerEvent;
  canvas.dispatchEvent(new kind(type, { clientX: box.left + x, clientY: box.top + y, bubbles: true, cancelable: true,
                                        pointerId: 1, ...more }));
};
const said = () => document.getElementById("said").textContent;
const painted = () => {
  const data = pen.getImageData(0, 0, canvas.width, canvas.height).data;
  let n = 0;
  for (let i = 3; i < data.length; i += 4) n += data[i] > 0;
  return n;
};
tell(painted() > 500);
const whole = { ...view };
const click = (x, y) => { at("pointerdown", x, y); at("pointerup", x, y); };
click(toX(2), toY(0));
tell(said());
tell(chosen);
click(toX(2.5), toY(0) + 100);
tell(said() === "" && chosen === -1);
const before = fromX(300);
at("wheel", 300, 200, { deltaY: -200 });
tell(Math.abs(fromX(300) - before) < 0.02 && view.x1 - view.x0 < 0.8 * (whole.x1 - whole.x0));
const left = view.x0;
at("pointerdown", 300, 200);
at("pointermove", 350, 200);
at("pointerup", 350, 200);
tell(view.x0 < left && chosen === -1);
canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "0" }));
tell(Math.abs(view.x0 - whole.x0) < 1e-12);
const out = document.createElement("pre");
out.id = "told";
out.textContent = JSON.stringify(told);
document.body.append(out);
</script>
"""


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.place = pathlib.Path(cls.folder.name)
        (cls.place / "circles.toml").write_text(SCENE)
        subprocess.run([PROGRAM, "section", "circles.toml", "--pictures", "html", "-q"], cwd=cls.place, check=True)
        cls.text = (cls.place / "circles.html").read_text()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_no_network(self):
        self.assertIsNone(re.search(r"https?:|src=|href=|@import|url\(", self.text))
        self.assertIn("default-src 'none'", self.text)

    def test_texts_are_texts(self):
        self.assertEqual(self.text.count("</script>"), 1)
        scene = json.loads(re.search(r"const scene = (\{.*?\});\n", self.text, re.S).group(1))
        self.assertIn("</script>", scene["title"])
        self.assertEqual([len(o["points"]) for o in scene["orbits"]], [12, 12, 12])

    @unittest.skipUnless(shutil.which("chromium"), "no chromium")
    def test_in_a_browser(self):
        page = self.place / "acted.html"
        page.write_text(self.text.replace("</body>", ACTIONS + "</body>"))
        dom = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--window-size=900,800",
             f"--user-data-dir={self.place / 'profile'}", "--dump-dom", page.as_uri()],
            capture_output=True, text=True, timeout=240, check=True).stdout
        found = re.search(r'<pre id="told">(.*?)</pre>', dom, re.S)
        self.assertIsNotNone(found, "the page's script failed")
        told = json.loads(html.unescape(found.group(1)))
        self.assertTrue(told[0], "something is drawn")
        self.assertTrue(told[1].startswith("orbit 1 from (2, 0): 6 crossings"), told[1])
        self.assertEqual(told[2:], [1, True, True, True, True])
        self.assertIn("1 &lt; 2 &amp; &lt;/script&gt;", dom)


unittest.main()
