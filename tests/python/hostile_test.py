"""Wrong types, strange text, many threads, forks and Ctrl-C: one clear error, or the right answer."""

import decimal
import os
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from fractions import Fraction

import kovacic
from kovacic import Truth

SLOW = " + ".join(f"2/(z - {i})^2" for i in range(1, 600))  # 599 logarithms: a second


class WrongArguments(unittest.TestCase):
    def refused(self, error, call, *args, **keywords):
        with self.assertRaises(error) as caught:
            call(*args, **keywords)
        self.assertIsInstance(caught.exception, kovacic.Error)
        return str(caught.exception)

    def test_types(self):
        for value in (0.5, 1e300, float("nan"), 1j, True, b"z", [], {}, object(), decimal.Decimal("0.5"), ("z",)):
            self.refused(kovacic.WrongType, kovacic.solve, value)
        self.assertIn("Fraction(1, 2)", self.refused(kovacic.WrongType, kovacic.solve, 0.5))
        self.refused(kovacic.InvalidArgument, kovacic.solve)
        self.refused(kovacic.InvalidArgument, kovacic.solve, "z", r="z")
        self.refused(kovacic.InvalidArgument, kovacic.solve, p="z")
        self.refused(kovacic.WrongType, kovacic.solve, "z", timeout="1")
        self.refused(kovacic.WrongType, kovacic.solve, "z", set=["a"])
        self.refused(kovacic.WrongType, kovacic.solve, "a*z", parameters=[1])
        self.refused(kovacic.WrongType, kovacic.solve, "z", assume=[None])
        self.refused(kovacic.WrongType, kovacic.solve, "z", assume=7)
        self.refused(kovacic.InvalidArgument, kovacic.solve, "z", method="best")
        self.refused(kovacic.InvalidArgument, kovacic.solve, "z", only_case=5)
        self.refused(kovacic.WrongType, kovacic.solve, "z", max_degree=1.5)
        self.refused(kovacic.InvalidArgument, kovacic.solve, "z", max_degree=10**30)
        self.refused(kovacic.WrongType, kovacic.check, None)
        self.refused(kovacic.WrongType, kovacic.prove, 3)
        self.refused(kovacic.WrongType, kovacic.verify, None)
        self.refused(kovacic.InvalidArgument, kovacic.verify, "/nowhere/at/all.json")
        self.refused(kovacic.WrongType, kovacic.monodromy, "z", digits="30")
        self.refused(kovacic.InvalidArgument, kovacic.monodromy, "z", digits=0)
        self.refused(kovacic.WrongType, kovacic.prove, "a\0b")
        with self.assertRaises(TypeError):
            kovacic.solve("z", tiemout=3)

    def test_caret(self):
        with self.assertRaises(kovacic.InputError) as caught:
            kovacic.solve("z^2 + 1/2z")
        error = caught.exception
        self.assertEqual((error.line, error.column), (1, 9))
        self.assertIn("^", str(error).splitlines()[2])
        self.assertIn("2*z", str(error))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.column), (str(error), 9))

    def test_text(self):
        for text in ("", " ", "z\0", "\ud800", "(" * 10**5, "1/0", "z^(10^30)", "2^(2^100)",
                     "'", "=", "z=", "y'' = y'' + z*y", "\n", "z; import os"):
            with self.assertRaises(kovacic.Error, msg=repr(text[:20])):
                answer = kovacic.solve(text, timeout=5)
                if answer.undecided is not None:
                    raise kovacic.OutOfBudget
        for text in ("\n", "a\nb", "[system\n", "x = 1\n", "[ode]\nr = 'z'\nR = 'z'\n"):
            with self.assertRaises(kovacic.Error, msg=repr(text)):
                kovacic.check(text)
        with self.assertRaises(kovacic.Error):
            kovacic.section("[body]\n")
        with self.assertRaises(kovacic.Error):
            kovacic.check("/nowhere.toml")


class Threads(unittest.TestCase):
    def test_side_by_side(self):
        asked = [("z^2 + 3", "Borel"), ("z", "SL2"), ("-3/(16*z^2) + 1/z", "Dinf"), ("c/z^2", "Gm")] * 12
        found = [None] * len(asked)

        def work(i):
            r = asked[i][0]
            found[i] = repr(kovacic.solve(r, set={"c": "sqrt(2)"} if "c" in r else None).group)
            kovacic.solve("z + a", parameters="a")

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(asked))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [f"GaloisGroup('{group}')" for _, group in asked])

    def test_one_answer_in_many_threads(self):
        answer = kovacic.solve("z^2 + a*z + b", parameters="a b", certificate=True)
        texts = set()
        threads = [threading.Thread(target=lambda: texts.add(str(answer) + str(answer.certificate))) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(texts), 1)

    def test_others_run_meanwhile(self):
        ticks, done = [], threading.Event()

        def work():
            kovacic.solve(SLOW, timeout=5)
            done.set()

        worker = threading.Thread(target=work)
        worker.start()
        while not done.wait(0.02):
            ticks.append(time.monotonic())
        worker.join()
        self.assertGreater(len(ticks), 3)

    def test_fork(self):
        kovacic.solve("z + a", parameters="a")
        busy = threading.Thread(target=kovacic.solve, args=(SLOW,), kwargs={"timeout": 1})
        busy.start()
        child = os.fork()
        if child == 0:
            code = 1
            try:
                code = 0 if kovacic.solve("z^2 + 3").abelian is Truth.no else 2
            finally:
                os._exit(code)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)
        busy.join()


class CtrlC(unittest.TestCase):
    def interrupted(self, call):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        begun = time.monotonic()
        with self.assertRaises(KeyboardInterrupt) as caught:
            call()
            time.sleep(5)  # it had ended before the signal
        timer.join()
        self.assertLess(time.monotonic() - begun, 60)
        return caught.exception

    def test_partial_answer(self):
        stopped = self.interrupted(lambda: [kovacic.solve(SLOW, timeout=None) for _ in range(1000)])
        if isinstance(stopped, kovacic.Interrupted) and stopped.answer is not None:
            self.assertIsInstance(stopped.answer, kovacic.Decision)

    def test_every_long_call(self):
        cases = pathlib.Path(os.environ["KOV_SOURCE"]) / "cases"
        scene = (cases / "sliding_top/scenes/asymmetric_sliding.toml").read_text(encoding="utf-8")
        scene = re.sub(r"crossings *= *\d+", "crossings = 100000", scene)
        for call in (lambda: kovacic.prove(cases / "sliding_top/main_theorem.toml"), lambda: kovacic.section(scene),
                     lambda: kovacic.fixed_points(scene), lambda: kovacic.monodromy("z^5 + 1/(z^3-2)", digits=3000),
                     lambda: kovacic.check(cases / "sliding_top/gravity.toml", timeout=None)):
            stopped = self.interrupted(lambda: [call() for _ in range(1000)])
            answer = getattr(stopped, "answer", None)
            if isinstance(answer, kovacic.SystemSection):
                self.assertTrue(answer.stopped)

    def test_at_any_time(self):
        theorem = pathlib.Path(os.environ["KOV_SOURCE"]) / "cases/sliding_top/main_theorem.toml"
        begun = time.monotonic()
        kovacic.prove(theorem)
        whole = time.monotonic() - begun
        for part in range(1, 8):  # also while a library computes that has a handler of its own
            timer = threading.Timer(whole * part / 10, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                for _ in range(3):
                    kovacic.prove(theorem)
            timer.join()

    def test_signal_that_another_thread_gets(self):
        done = threading.Event()
        other = threading.Thread(target=done.wait)
        other.start()
        timer = threading.Timer(0.3, lambda: signal.pthread_kill(other.ident, signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                for _ in range(1000):
                    kovacic.solve(SLOW, timeout=None)
        finally:
            timer.join()
            done.set()
            other.join()

    def test_own_handler_that_raises_nothing(self):
        seen = []
        before = signal.signal(signal.SIGINT, lambda *_: seen.append(1))
        try:
            timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            while not seen:
                try:
                    answer = kovacic.solve(SLOW, timeout=None)
                except kovacic.OutOfBudget as early:  # on a busy machine: the equation was not read yet
                    answer = str(early)
            timer.join()
        finally:
            signal.signal(signal.SIGINT, before)
        if isinstance(answer, str):
            self.assertIn("stopped on request", answer)
        else:
            self.assertIsNotNone(answer)

    def test_handler_is_restored(self):
        before = signal.getsignal(signal.SIGINT)
        kovacic.solve("z")
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        with self.assertRaises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(1)


class Process(unittest.TestCase):
    def run_python(self, code):
        return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)

    def test_end_of_the_interpreter(self):
        code = ("import kovacic, threading\n"
                "keep = kovacic.solve('z^2 + a', parameters='a')\n"
                "threading.Thread(target=kovacic.solve, args=('z',), daemon=True).start()\n"
                "print(keep.strata[0].where)\n")
        ran = self.run_python(code)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))

    def test_memory(self):
        code = ("import kovacic, resource\n"
                "def peak(): return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
                "def work(n):\n"
                "    for _ in range(n): str(kovacic.solve('1/(z^2+1)^2 + 3/z', solutions=True))\n"
                "work(500); before = peak(); work(3000); print(peak() - before)\n")
        ran = self.run_python(code)
        self.assertEqual(ran.stderr, "")
        self.assertLess(int(ran.stdout), 4000)  # KiB

    def test_without_numpy_and_sympy(self):
        code = ("import sys\nsys.modules['numpy'] = None; sys.modules['sympy'] = None\n"
                "import kovacic\nprint(kovacic.solve('z').group)\n")
        self.assertEqual(self.run_python(code).stdout, "SL(2, C)\n")

    def test_import_is_cheap(self):
        code = "import sys, kovacic\nprint([m for m in ('numpy', 'sympy', 'unittest') if m in sys.modules])\n"
        self.assertEqual(self.run_python(code).stdout, "[]\n")


if __name__ == "__main__":
    unittest.main()
