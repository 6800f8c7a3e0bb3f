"""Sections of any system from Python, pictures of them, strata as a frame, and the documentation of every member."""

import doctest
import enum
import inspect
import io
import pathlib
import tempfile
import unittest

import kovacic
from kovacic import InputError, InvalidArgument, WrongType

try:
    import numpy
except ImportError:
    numpy = None
try:
    import matplotlib
    matplotlib.use("Agg")
except ImportError:
    matplotlib = None
try:
    import pandas
except ImportError:
    pandas = None

THEOREM = """
format = "theorem/1"
title = "One case"
system = "system.toml"
[[node]]
id = "only"
kind = "case"
file = "system.toml"
"""
FREE_TOP = """
format = "scene/1"
[body]
inertia = [1, "2/3", "1/2"]
lever = ["8/9", 0, 0]
mass = 1
gravity = 0
tip = "fixed"
[levels]
H = "3/2"
F1 = 1
F2 = "1/20"
[section]
angle = "pi/2"
direction = "upward"
axis = 3
[orbits]
grid = [2, 2]
crossings = 3
[accuracy]
tolerance = "10^-16"
drift = "10^-11"
"""


def henon():
    return kovacic.System("(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3", "x y", "u v")


class Sections(unittest.TestCase):
    def setUp(self):
        self.options = {"plot": ["y", "v"], "seeds": [(0, "1/10"), ("1/5", 0)], "crossings": 40}

    def test_points(self):
        s = henon().section("x", {"H": "1/12"}, **self.options)
        self.assertEqual((len(s.x), len(s.y), len(s.t), len(s.orbit)), (80, 80, 80, 80))
        self.assertEqual((s.labels, len(s.orbits), s.stopped, s.cut_short), (("y", "v"), 2, False, 0))
        self.assertEqual([set(list(s.orbit)[i:i + 40]) for i in (0, 40)], [{0}, {1}])
        self.assertLess(s.drift, 1e-11)
        self.assertTrue(all(a < b for a, b in zip(s.t[:40], s.t[1:40])))
        self.assertIsNone(s.colors)
        self.assertIn("2 orbits, 80 points", repr(s))
        with self.assertRaises(TypeError):
            bool(s)

    # Second opinion: the energy that each point leaves for u^2/2 is not negative, and a linear system is known.
    def test_they_are_right(self):
        s = henon().section("x", {"H": "1/12"}, **self.options)
        for y, v in zip(s.x, s.y):
            self.assertGreaterEqual(1 / 12 - v * v / 2 - y * y / 2 + y**3 / 3, -1e-12)
        s = kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3)
        for k, (t, q, p) in enumerate(zip(s.t, s.x, s.y)):  # q = cos t grows through 0
            self.assertAlmostEqual(t, 3 * 3.141592653589793 / 2 + 2 * 3.141592653589793 * k)
            self.assertAlmostEqual(q, 0)
            self.assertAlmostEqual(p, 1)

    def test_kinds(self):
        lorenz = kovacic.System.field({"x": "10*(y - x)", "y": "28*x - y - x*z", "z": "x*y - 8*z/3"})
        s = lorenz.section("z - 27", plot=["x", "y"], states=[[1, 1, 20]], crossings=10, direction="both")
        self.assertEqual(len(s.x), 10)
        pendulum = kovacic.System.lagrangian("m*v^2/2 + cos(x)", ["x"], ["v"])
        s = pendulum.section("p_x", plot=["x", "p_x"], states=[["1/2", 0]], crossings=4, set={"m": 1}, direction="both")
        self.assertEqual(len(s.x), 4)
        s = henon().section("x", {"H": "1/12"}, indicator="megno", time=30, **{**self.options, "crossings": None})
        self.assertEqual(len(s.colors), len(s.x))
        s = henon().section("x", {"H": "1/12"}, plot=["y", "v"], grid=(2, 2), range=[("-1/4", "1/4"), ("-1/4", "1/4")], crossings=2)
        self.assertEqual((len(s.orbits), len(s.x)), (4, 8))

    def test_same_as_a_file(self):
        text = henon().to_text() + '[[scene]]\nname = "one"\nsection = "x"\nlevels = { H = "1/12" }\nplot = ["y", "v"]\n' \
            'seeds = [[0, "1/10"]]\ncrossings = 5\n[[scene]]\nname = "two"\nsection = "y"\nlevels = { H = "1/12" }\n' \
            'plot = ["x", "u"]\nseeds = [[0, "1/10"]]\ncrossings = 6\n'
        one = kovacic.section(text, scene="one")
        own = henon().section("x", {"H": "1/12"}, plot=["y", "v"], seeds=[(0, "1/10")], crossings=5)
        self.assertEqual(list(one.x), list(own.x))
        self.assertEqual(len(kovacic.section(text, scene="two").x), 6)
        for wrong in (None, "three"):
            with self.assertRaises(InvalidArgument):
                kovacic.section(text, scene=wrong)

    def test_progress(self):
        seen = []
        henon().section("x", {"H": "1/12"}, progress=lambda done, all: seen.append((done, all)), **self.options)
        self.assertEqual(seen[-1], (2, 2))
        for threads in (1, 2):
            with self.assertRaises(ZeroDivisionError):
                henon().section("x", {"H": "1/12"}, progress=lambda done, all: 1 / 0, threads=threads, **self.options)
        with self.assertRaises(WrongType):
            henon().section("x", {"H": "1/12"}, progress=3, **self.options)

    def test_mistakes(self):
        for more, error in (({"plot": ["y", "w"]}, InputError), ({"seeds": [(0, 0.1)]}, WrongType), ({"speed": 1}, InputError),
                            ({"crossings": "many"}, WrongType), ({"direction": "sideways"}, InputError),
                            ({"threads": 0}, InvalidArgument), ({"indicator": "none of ours"}, InputError)):
            with self.assertRaises(error, msg=str(more)):
                henon().section("x", {"H": "1/12"}, **{**self.options, **more})
        with self.assertRaises(InputError):  # a parameter without a value
            kovacic.System("p^2/2 + a*q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3)

    @unittest.skipUnless(numpy, "needs NumPy")
    def test_numpy(self):
        s = henon().section("x", {"H": "1/12"}, **self.options)
        self.assertEqual((s.points.shape, s.points.dtype, s.x.dtype), ((80, 2), numpy.float64, numpy.float64))

    @unittest.skipUnless(matplotlib, "needs matplotlib")
    def test_plot(self):
        from matplotlib import pyplot

        for indicator in (None, "megno"):
            s = henon().section("x", {"H": "1/12"}, indicator=indicator, title="E = 1/12", **self.options)
            ax = s.plot()
            self.assertEqual((ax.get_xlabel(), ax.get_ylabel(), ax.get_title()), ("$y$", "$v$", "E = 1/12"))
            self.assertEqual(len(ax.collections[0].get_offsets()), 80)
            self.assertEqual(len(ax.figure.axes), 2 if indicator else 1)  # with a colour bar
            own = pyplot.figure().add_subplot()
            self.assertIs(s.plot(own, s=3, color="black"), own)
            ax.figure.savefig(io.BytesIO())
        s.drift = 1.0  # a picture of an orbit that left its level is refused
        with self.assertRaises(InvalidArgument):
            s.plot()

    @unittest.skipUnless(pandas, "needs pandas")
    def test_frame(self):
        found = kovacic.System("(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3", ["q1", "q2"], ["p1", "p2"]).classify()
        frame = found.to_frame()
        self.assertEqual(len(frame), len(found.strata))
        self.assertEqual(sorted(frame[frame.status == "integrable"].conditions), ["b = 1", "b = 16", "b = 6"])


def members():
    """(name, object) of everything public: functions, classes, and what the classes define."""
    for name in kovacic.__all__:
        value = getattr(kovacic, name)
        yield name, value
        if inspect.isclass(value) and value.__module__.startswith("kovacic") and not issubclass(value, BaseException):
            for attribute, member in vars(value).items():
                if not attribute.startswith("_") and (callable(member) or isinstance(member, (property, classmethod, staticmethod))):
                    yield f"{name}.{attribute}", member


def documentation(member):
    text = inspect.getdoc(member) or ""
    return "" if text == inspect.getdoc(enum.Enum) else text  # inherited


class Documentation(unittest.TestCase):
    def test_members_without_an_example(self):
        self.assertEqual([name for name, member in members() if ">>>" not in documentation(member)], [])

    def test_examples_run(self):
        text = kovacic.hamiltonian("(u^2 + v^2)/2 + x^2*y - y^3/3", "x y", "u v",
                                   manifolds=[{"equations": ["x = 0", "u = 0"], "level": "H = 1"}])
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "system.toml").write_text(text, encoding="utf-8")
            (pathlib.Path(folder) / "theorem.toml").write_text(THEOREM, encoding="utf-8")
            theorem = kovacic.prove(pathlib.Path(folder) / "theorem.toml")
        names = {"kovacic": kovacic, "text": text, "theorem": theorem, "orbits": kovacic.fixed_points(FREE_TOP),
                 "S": kovacic.System("(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3", ["q1", "q2"], ["p1", "p2"])}
        finder, said = doctest.DocTestParser(), io.StringIO()
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
        for name, member in members():
            text = documentation(member)
            needs = [module for word, module in ((".points", numpy), ("to_frame", pandas), ("matplotlib", matplotlib)) if word in text]
            if ">>>" in text and all(needs):
                runner.run(finder.get_doctest(text, dict(names), name, None, 0), out=said.write)
        self.assertEqual(runner.failures, 0, said.getvalue())

    def test_version(self):
        self.assertRegex(kovacic.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
