"""kovacic.map: the answers in order, whatever is killed on the way, here and on workers of Dask."""

import importlib.util
import json
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

QUESTIONS = [{"id": n, "r": f"z^2 + {n}" if n % 3 else f"{n + 1}/z - 3/(16*z^2)"} for n in range(48)]
RESUMED = """
import json, pathlib, sys, kovacic
kovacic.map(pathlib.Path(sys.argv[1]), out=sys.argv[2], jobs=2, chunk=2)
"""


class Map(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.questions = self.folder / "questions.jsonl"
        self.questions.write_text("".join(json.dumps(q) + "\n" for q in QUESTIONS), encoding="utf-8")

    def serial(self):
        path = self.folder / "serial.jsonl"
        subprocess.run([kovacic._map._command(), "solve", "--batch", self.questions, "-o", path, "--no-times", "--jobs", "1"],
                       check=False)
        return path.read_bytes()

    def test_list(self):
        answers = kovacic.map(QUESTIONS[:5], chunk=2)
        self.assertEqual([a["id"] for a in answers], [0, 1, 2, 3, 4])
        self.assertEqual(answers[3]["group"]["type"], "Dinf")
        self.assertEqual(kovacic.map(["z", "1"])[0]["group"]["type"], "SL2")
        self.assertEqual(kovacic.map([]), [])

    def test_a_bad_line_is_an_answer(self):
        self.assertIn("error", kovacic.map(["z", "2(z"])[1])

    def test_what_is_refused(self):
        for wrong in ("z", {"r": "z"}):
            with self.assertRaises(kovacic.WrongType):
                kovacic.map(wrong)
        with self.assertRaises(kovacic.WrongType):
            kovacic.map([0.5])
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.map(["z"], chunk=0)
        with self.assertRaises(kovacic.Error):
            kovacic.map(["z"], options=["--no-such-flag"])

    def test_killed_and_called_again(self):
        out = self.folder / "answers.jsonl"
        run = subprocess.Popen([sys.executable, "-c", RESUMED, self.questions, out])
        parts = self.folder / "answers.jsonl.parts"
        while run.poll() is None and len(list(parts.glob("*.jsonl"))) < 3:
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        kept = {path.name: path.stat().st_mtime_ns for path in parts.glob("*.jsonl")} if parts.exists() else {}
        self.assertFalse(out.exists() and kept)
        kovacic.map(self.questions, out=out, jobs=2, chunk=2)
        self.assertEqual(out.read_bytes(), self.serial())
        self.assertFalse(parts.exists())

    def test_other_questions_are_asked_again(self):
        out = self.folder / "answers.jsonl"
        parts = self.folder / "answers.jsonl.parts"
        parts.mkdir()
        (parts / "000000-0123456789abcdef.jsonl").write_text("{}\n", encoding="utf-8")
        kovacic.map(QUESTIONS[:3], out=out)
        self.assertEqual([json.loads(line)["id"] for line in out.read_text(encoding="utf-8").splitlines()], [0, 1, 2])

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "needs python3-distributed")
    def test_dask_with_a_worker_killed(self):
        from dask.distributed import Client, LocalCluster
        out = self.folder / "answers.jsonl"
        with LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, \
                Client(cluster) as client:
            victim = client.submit(os.getpid, workers=list(client.scheduler_info()["workers"])[:1], pure=False).result()
            parts = self.folder / "answers.jsonl.parts"

            def kill():
                while len(list(parts.glob("*.jsonl"))) < 2:
                    time.sleep(0.005)
                os.kill(victim, signal.SIGKILL)
            killer = threading.Thread(target=kill, daemon=True)
            killer.start()
            kovacic.map(self.questions, client=client, out=out, chunk=2)
            killer.join(60)
        self.assertEqual(out.read_bytes(), self.serial())


if __name__ == "__main__":
    unittest.main()
