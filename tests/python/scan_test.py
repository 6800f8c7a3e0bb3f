"""kovacic.scan: the matrix of one process bit by bit, whatever is killed on the way, here and on workers of Dask."""

import importlib.util
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import kovacic

SCENE = """
[[scene]]
name = "%s"
section = "x"
levels = { H = "1/8" }
plot = ["y", "v"]
crossings = 20
%s
"""
FILE = """format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["b"]
hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - b/3*y^3"
""" + SCENE % ("plane", 'set = { b = 1 }\nscan = { of = "megno", over = { y = ["-1/2", "7/10", 150], v = ["-1/2", "1/2", 130] } }') \
    + SCENE % ("line", 'seeds = [["1/10", 0]]\nscan = { of = "time", over = { b = ["1/2", 1, 9000] } }') \
    + SCENE % ("points", 'set = { b = 1 }\nseeds = [["1/10", 0]]')
CALLED = "import sys, kovacic; kovacic.scan(sys.argv[1], scene='plane', out=sys.argv[2], jobs=2, parts=4)"


class Scan(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "scenes.toml"
        self.file.write_text(FILE, encoding="utf-8")
        self.out = self.folder / "out"

    def serial(self, scene):
        subprocess.run([kovacic._map._command(), "section", self.file, "--scene", scene, "-o", self.folder / "serial",
                        "--pictures", "none", "-q"], check=True)
        return (self.folder / "serial" / f"{scene}.npy").read_bytes()

    def left(self):
        return sorted(file.name for file in self.out.iterdir() if file.suffix != ".gp")

    def test_any_number_of_parts(self):
        whole = self.serial("line")
        for parts in (1, 2, 3, 7):
            scan = kovacic.scan(self.file, scene="line", out=self.out, jobs=2, parts=parts)
            self.assertEqual(scan.path.read_bytes(), whole)
            self.assertEqual(self.left(), ["line.npy", "line.scan.json"])
        self.assertEqual(scan.shape, (9000,))

    def test_nothing_is_left_without_out(self):
        scan = kovacic.scan(self.file, scene="plane", jobs=2)
        self.assertEqual(scan.shape, (130, 150))
        self.assertFalse(scan.path.exists())
        self.assertEqual(len(memoryview(scan.values).tobytes()), 8 * 130 * 150)

    def test_what_is_refused(self):
        for wrong in (0.5, "[system]\n"):
            with self.assertRaises(kovacic.WrongType):
                kovacic.scan(wrong)
        for parts in (0, 1.5):
            with self.assertRaises(kovacic.InvalidArgument):
                kovacic.scan(self.file, scene="line", parts=parts)
        for scene in ("points", "nowhere"):
            with self.assertRaises(kovacic.Error):
                kovacic.scan(self.file, scene=scene, parts=1)

    def test_which_scan(self):
        with self.assertRaisesRegex(kovacic.InvalidArgument, "2 scans: scene=... is one of plane, line"):
            kovacic.scan(self.file)
        text = self.file.read_text(encoding="utf-8")
        one = self.file.with_name("one.toml")
        one.write_text(text.replace('scan = { of = "megno"', 'seeds = [["1/10", 0]]\n# { of = "megno"'), encoding="utf-8")
        self.assertEqual(kovacic.scan(one, jobs=2).shape, (9000,))

    def test_another_scan_in_the_way(self):
        self.out.mkdir()
        (self.out / "line.1-of-2.scan-part").write_text("kovacic-scan/1\n3\nabc", encoding="utf-8")
        with self.assertRaisesRegex(kovacic.Error, "another scan"):
            kovacic.scan(self.file, scene="line", out=self.out, parts=2)

    def test_killed_and_called_again(self):
        run = subprocess.Popen([sys.executable, "-c", CALLED, self.file, self.out])
        while run.poll() is None and not (self.out.exists() and list(self.out.glob("plane.*.scan-part"))):
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        for part in self.out.glob("plane.*.scan-part"):  # a block that a kill has cut off
            part.write_bytes(part.read_bytes()[:-100])
        kovacic.scan(self.file, scene="plane", out=self.out, jobs=2, parts=4)
        self.assertEqual((self.out / "plane.npy").read_bytes(), self.serial("plane"))

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "needs python3-distributed")
    def test_dask_with_a_worker_killed(self):
        from dask.distributed import Client, LocalCluster
        with LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, \
                Client(cluster) as client:
            victim = client.submit(os.getpid, workers=list(client.scheduler_info()["workers"])[:1], pure=False).result()

            def kill():
                while not list(self.out.glob("*.scan-part")):
                    time.sleep(0.005)
                os.kill(victim, signal.SIGKILL)
            killer = threading.Thread(target=kill, daemon=True)
            killer.start()
            scan = kovacic.scan(self.file, scene="plane", out=self.out, client=client, parts=5)
            killer.join(60)
        self.assertEqual(scan.path.read_bytes(), self.serial("plane"))
        self.assertEqual(self.left(), ["plane.npy", "plane.scan.json"])


if __name__ == "__main__":
    unittest.main()
