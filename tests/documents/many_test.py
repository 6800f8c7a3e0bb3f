#!/usr/bin/env python3
"""docs/guide/many-equations.md does what it says: its own commands, with several workers of which one is killed on the way.

usage: many_test.py PROGRAM        (Dask: tests/python/map_test.py)
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PAGE = (pathlib.Path(__file__).resolve().parents[2] / "docs/guide/many-equations.md").read_text(encoding="utf-8")
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
SCRIPTS = dict(zip(("parallel", "slurm", "scan parallel", "scan slurm"), re.findall(r"^```sh\n(.*?)^```", PAGE, re.M | re.S)))
PLANE = """format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"
[scene]
section = "x"
levels = { H = "1/8" }
plot = ["y", "v"]
crossings = 25
scan = { of = "megno", over = { y = ["-1/2", "7/10", 230], v = ["-1/2", "1/2", 220] } }
"""
QUESTIONS = "".join(f'{{"id": {n}, "r": "{n + 1}/z - 3/(16*z^2) + (z^{n % 5} - {n % 7})^2"}}\n' for n in range(330))


class Many(unittest.TestCase):
    pieces = "part-*.out"  # what a kill waits for

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        (self.folder / "bin").mkdir()
        os.symlink(PROGRAM, self.folder / "bin/kovacic")
        (self.folder / "equations.jsonl").write_text(QUESTIONS, encoding="utf-8")
        self.killed = None

    def environment(self, **more):
        return dict(os.environ, PATH=f"{self.folder}/bin:{os.environ['PATH']}", **more)

    def shell(self, script, **more):
        return subprocess.run(["sh", "-c", script], cwd=self.folder, env=self.environment(**more), capture_output=True, encoding="utf-8")

    def serial(self):
        self.shell("kovacic solve --batch equations.jsonl -o serial.jsonl --no-times --jobs 1")
        return (self.folder / "serial.jsonl").read_bytes()

    def workers(self):
        """The processes of the command that were started here and not by one another."""
        found = {}
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(entry / "cwd") == str(self.folder) and (entry / "comm").read_text().strip() == "kovacic":
                    found[int(entry.name)] = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except OSError:
                pass
        return [pid for pid, parent in found.items() if parent not in found]

    def kill_one(self):
        """As soon as a piece has some of its answers and not all."""
        end = time.monotonic() + 60
        while self.killed is None and time.monotonic() < end:
            pieces = [path for path in self.folder.glob(self.pieces) if path.stat().st_size > 0]
            workers = self.workers() if pieces else []
            if workers:
                os.kill(workers[0], signal.SIGKILL)
                self.killed = workers[0]
            time.sleep(0.002)

    def with_a_kill(self, run):
        killer = threading.Thread(target=self.kill_one)
        killer.start()
        run()
        killer.join()
        self.assertIsNotNone(self.killed, "nothing could be killed in time")

    @unittest.skipUnless(shutil.which("parallel"), "needs GNU parallel")
    def test_parallel(self):
        script = SCRIPTS["parallel"].replace("parallel ", "parallel --will-cite --jobs 3 ", 1)
        self.with_a_kill(lambda: self.shell(script))
        self.assertEqual((self.folder / "answers.jsonl").read_bytes(), self.serial())

    def test_slurm(self):
        """What Slurm does with the job array, done here: tasks at the same time, and one that fails is requeued."""
        (self.folder / "array.sh").write_text(SCRIPTS["slurm"], encoding="utf-8")
        self.shell(SCRIPTS["parallel"].split("\n")[0])
        count = len(list(self.folder.glob("part-*.jsonl")))
        self.assertGreater(count, 5)
        self.with_a_kill(lambda: self.array(range(count)))
        self.shell("cat part-*.out > answers.jsonl")
        self.assertEqual((self.folder / "answers.jsonl").read_bytes(), self.serial())

    def array(self, numbers):
        def task(number):
            return subprocess.Popen(["sh", "array.sh"], cwd=self.folder, env=self.environment(SLURM_ARRAY_TASK_ID=str(number)))

        queue, running = list(numbers), {}
        while queue or running:
            while queue and len(running) < 3:
                number = queue.pop(0)
                running[number] = task(number)
            for number in [n for n, p in running.items() if p.poll() is not None]:
                if running.pop(number).returncode in (-9, 137):
                    queue.append(number)
            time.sleep(0.005)


class Scan(Many):
    pieces = "scan/*.scan-part"

    def serial(self):
        self.shell("kovacic section plane.toml -o serial --pictures none -q")
        return (self.folder / "serial/plane.npy").read_bytes()

    def merged(self):
        self.shell(SCRIPTS["scan parallel"].split("\n")[1])
        self.assertEqual(list((self.folder / "scan").glob("*part*")), [])
        return (self.folder / "scan/plane.npy").read_bytes()

    @unittest.skipUnless(shutil.which("parallel"), "needs GNU parallel")
    def test_parallel(self):
        (self.folder / "plane.toml").write_text(PLANE, encoding="utf-8")
        script = SCRIPTS["scan parallel"].split("\n")[0].replace("parallel ", "parallel --will-cite --jobs 3 ", 1)
        self.with_a_kill(lambda: self.shell(script))
        self.assertEqual(self.merged(), self.serial())

    def test_slurm(self):
        (self.folder / "plane.toml").write_text(PLANE, encoding="utf-8")
        (self.folder / "array.sh").write_text(SCRIPTS["scan slurm"], encoding="utf-8")
        self.with_a_kill(lambda: self.array(range(1, 9)))
        self.assertEqual(self.merged(), self.serial())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
