#!/usr/bin/env python3
"""What a terminal shows: colours with a meaning, lines that fit, progress, and what Ctrl-C keeps.

usage: terminal_test.py PROGRAM
"""

import fcntl
import os
import pathlib
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
FILES = pathlib.Path(__file__).parent / "files"
ESCAPES = re.compile(r"\033\[[0-9;]*[A-Za-z]")


def on_terminal(arguments, columns=80, interrupt=None, seconds=60):
    """What the program writes on a terminal of so many columns; Ctrl-C after `interrupt` seconds."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
    environment = dict(os.environ, TERM="xterm")
    environment.pop("NO_COLOR", None)
    run = subprocess.Popen([PROGRAM, *arguments], stdin=theirs, stdout=theirs, stderr=theirs, env=environment, cwd=FILES,
                           start_new_session=True, preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
    os.close(theirs)
    begun, said, sent = time.monotonic(), b"", False
    while time.monotonic() < begun + seconds:
        if interrupt is not None and not sent and time.monotonic() > begun + interrupt:
            os.killpg(run.pid, signal.SIGINT)
            sent = True
        if select.select([ours], [], [], 0.1)[0]:
            try:
                part = os.read(ours, 65536)
            except OSError:
                break
            if not part:
                break
            said += part
    os.close(ours)
    run.kill()
    run.wait()
    return said.decode("utf-8", "replace").replace("\r\n", "\n")


class Terminal(unittest.TestCase):
    def test_colours_have_a_meaning(self):
        for arguments, colour in [(["-r", "z"], "1;31"), (["-r", "1"], "1;32"), (["-r", "a*z", "--assume", "a > 0"], "1;31"),
                                  (["-r", "a*z + b", "--parameter", "a", "--parameter", "b"], "1;33"),
                                  (["-r", "z^101", "--max-degree", "100"], "1;33")]:
            with self.subTest(arguments=arguments):
                self.assertIn(f"\033[{colour}m", on_terminal(["solve", *arguments]))
        self.assertIn("\033[1;31mNON-INTEGRABLE", on_terminal(["classify", "cubic.toml"]))
        self.assertIn("\033[1;33mDEPENDS ON", on_terminal(["classify", "-H", "p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3"]))
        self.assertIn("\033[1;31mNON-INTEGRABLE", on_terminal(["check", "cubic.toml", "--set", "h=1"]))

    def test_nothing_is_wider_than_the_terminal(self):
        for columns in (60, 80, 120):
            for arguments in (["solve", "-r", "2/z^2 + 1"], ["solve", "-r", "a*z + b", "--parameter", "a", "--parameter", "b"],
                              ["potential", "--degree", "3"], ["monodromy", "-r", "-3/16/z^2", "--digits", "8"], ["--help"],
                              ["lame", "-n", "1/4"], ["explain", "SL2"], ["explain"], ["explain", "nothing like it"],
                              ["spectrum", "-r", "z^2 - E", "--levels", "2"], ["find-manifolds", "plane.toml"],
                              ["check", "plane.toml", "--set", "b=3", "--set", "A=1", "--set", "B=2", "--set", "h=1"]):
                with self.subTest(arguments=arguments, columns=columns):
                    shown = ESCAPES.sub("", on_terminal(arguments, columns)).split("\n")
                    # a formula without blanks is not broken
                    self.assertEqual([line for line in shown if len(line) > columns and len(line.split()) > 1
                                      and max(map(len, line.split())) < columns - 20], [] if arguments != ["--help"] or columns > 90
                                     else [line for line in shown if len(line) > columns])

    def test_a_long_question_shows_that_it_works(self):
        with tempfile.TemporaryDirectory():
            said = on_terminal(["integrals", "henon_heiles_parameters.toml", "--degree", "12"], interrupt=5, seconds=20)
        self.assertRegex(said, r"integrals: \d+ s of at most \d+; Ctrl-C keeps what is proved")
        quiet = on_terminal(["classify", "galactic.toml", "-q"], interrupt=4, seconds=20)
        self.assertNotIn("Ctrl-C keeps", quiet)

    def test_ctrl_c_keeps_what_a_limit_keeps(self):
        said = on_terminal(["classify", "uncoupled.toml"], interrupt=0.5, seconds=20)
        self.assertIn("interrupted", said)
        self.assertIn("uncoupled.toml", said)
        said = on_terminal(["integrals", "henon_heiles_parameters.toml", "--degree", "12"], interrupt=3, seconds=20)
        self.assertIn("henon_heiles_parameters.toml\n", said)
        self.assertIn("interrupted", said)

    def test_sigterm_keeps_what_ctrl_c_keeps(self):
        """Sent to the program alone, to all its processes, and to both at once, as timeout(1) does."""
        everyone = {"one": lambda p, n: p.send_signal(n), "all": lambda p, n: os.killpg(p.pid, n),
                    "both": lambda p, n: [p.send_signal(n), os.killpg(p.pid, n)]}
        for arguments, kept in ((["classify", "uncoupled.toml"], "uncoupled.toml"),
                                (["integrals", "henon_heiles_parameters.toml", "--degree", "12"], "henon_heiles_parameters.toml\n")):
            for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
                for name, send in everyone.items():
                    with self.subTest(arguments=arguments, number=number, to=name), tempfile.TemporaryFile("w+") as said:
                        run = subprocess.Popen([PROGRAM, *arguments], stdout=said, stderr=said, cwd=FILES, start_new_session=True)
                        time.sleep(3)
                        send(run, number)
                        self.assertEqual(run.wait(30), code)
                        said.seek(0)
                        text = said.read()
                        self.assertIn(kept, text)
                        self.assertIn("interrupted", text)

    def test_sigterm_keeps_the_orbits_of_a_section(self):
        text = (FILES / "small_scene.toml").read_text(encoding="utf-8").replace("crossings = 20", "crossings = 2000")
        text = re.sub("seeds.*", "grid = [64, 64]", text)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "long.toml").write_text(text, encoding="utf-8")
            run = subprocess.Popen([PROGRAM, "section", "long.toml", "--pictures", "none", "-o", "out"], cwd=folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(5)
            run.send_signal(signal.SIGTERM)
            self.assertEqual(run.wait(60), 143)
            self.assertIn("\n", (pathlib.Path(folder) / "out/long.orbits.dat").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
