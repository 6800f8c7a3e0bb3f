"""Sections of any system: System.section, and kovacic.section of a system file with scenes."""

from array import array

from . import _convert, _core, _system
from ._errors import InvalidArgument, WrongType


class SystemSection:
    """Points of a section of any system.  For the eye: nothing here is a proof.

        >>> S = kovacic.System("(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3", "x y", "u v")
        >>> s = S.section("x", {"H": "1/12"}, plot=["y", "v"], seeds=[(0, "1/10")], crossings=50)
        >>> len(s.x), s.labels, len(s.orbits)
        (50, ('y', 'v'), 1)

    x, y, t, orbit: numpy arrays where numpy is installed, else array.array; `points` is the matrix of x and y.
    """

    __slots__ = ("title", "labels", "indicator", "allowed_drift", "orbit", "t", "x", "y", "orbits", "integrals", "drifts",
                 "drift", "arithmetic", "skipped", "stopped", "cut_short")

    def __init__(self, scene, data):
        self.title, self.labels, self.indicator = scene.title, tuple(scene.plot), scene.indicator or None
        self.allowed_drift = scene.allowed_drift
        self.orbit = column("q", data.orbit)
        self.t, self.x, self.y = (column("d", c) for c in (data.t, data.x, data.y))
        self.orbits, self.integrals, self.drifts = data.orbits, data.integrals, data.drifts
        self.drift, self.arithmetic, self.skipped = data.drift, data.arithmetic, data.skipped
        self.stopped, self.cut_short = data.stopped, data.cut_short

    @property
    def points(self):
        """x and y as the two columns of a numpy array.

            >>> s = kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3)
            >>> s.points.shape
            (3, 2)
        """
        import numpy

        return numpy.column_stack([self.x, self.y])

    @property
    def colors(self):
        """The indicator of each point's orbit, or None where the scene has none.

            >>> s = kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3)
            >>> s.colors is None
            True
        """
        if self.indicator is None:
            return None
        values = [getattr(orbit, self.indicator) for orbit in self.orbits]
        return column("d", array("d", [values[i] for i in self.orbit]).tobytes())

    def plot(self, ax=None, **options):
        """The points in a picture of matplotlib, coloured by the indicator; `options` are those of Axes.scatter.  Returns
        the axes.

            >>> ax = S.section("q1", {"H": 1}, set={"b": 1}, plot=["q2", "p2"], seeds=[(0, 0)], crossings=5).plot()  # matplotlib
            >>> ax.get_xlabel()
            '$q_{2}$'
        """
        if self.drift > self.allowed_drift:
            raise InvalidArgument(f"the integrals drift by {self.drift:.1e}, more than the {self.allowed_drift:.1e} that the "
                                  "scene allows: no picture")
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.figure().add_subplot()
        own = bool({"c", "color"} & options.keys())
        colors = None if own else self.colors
        shown = {"s": 1, "linewidths": 0}
        if not own:
            shown |= {"c": self.orbit, "cmap": "tab10"} if colors is None else {"c": colors, **colour_scale(self.indicator)}
        drawn = ax.scatter(self.x, self.y, **{**shown, **options})
        if colors is not None:
            bar = ax.figure.colorbar(drawn, ax=ax, label=INDICATORS.get(self.indicator, self.indicator))
            if self.indicator == "megno" and not {"cmap", "norm"} & options.keys():
                bar.set_ticks([0.1, 0.5, 1, 2, 4, 10, 40], labels=["0.1", "0.5", "1", "2", "4", "10", "40"])
        ax.set(xlabel=axis_label(self.labels[0]), ylabel=axis_label(self.labels[1]), title=self.title)
        return ax

    def _repr_html_(self):
        from . import _show

        return _show.section(self)

    def __bool__(self):
        raise TypeError("a SystemSection is not a truth value; ask for len(section.x), .stopped, ...")

    def __repr__(self):
        partial = "PARTIAL, " if self.stopped or self.cut_short else ""
        return f"<SystemSection: {partial}{len(self.orbits)} orbits, {len(self.x)} points, drift {self.drift:.1e}>"


INDICATORS = {"megno": "mean MEGNO (2: regular)", "lyapunov": "largest Lyapunov exponent", "fli": "fast Lyapunov indicator"}
# As in the pictures of `kovacic section`: what is regular is dark; MEGNO has 2, regular motion, in the middle.
AROUND_TWO = [(0, "#4fb99f"), (0.25, "#127a6b"), (0.5, "#22304a"), (0.62, "#5b1d72"), (0.75, "#a5317e"), (0.88, "#e2505f"),
              (1, "#fb9a62")]
FROM_DARK = [(0, "#22304a"), (0.25, "#5b1d72"), (0.5, "#a5317e"), (0.75, "#e2505f"), (1, "#fb9a62")]


def colour_scale(indicator):
    from matplotlib.colors import LinearSegmentedColormap, LogNorm

    if indicator == "megno":
        return {"cmap": LinearSegmentedColormap.from_list("megno", AROUND_TWO), "norm": LogNorm(0.1, 40)}
    return {"cmap": LinearSegmentedColormap.from_list("indicator", FROM_DARK)}


def axis_label(text):
    """A name or a formula as it is typeset; what is no formula stays text."""
    if len(text) == 2 and text[0] == "p" and text[1].isalpha():
        return f"$p_{{{text[1]}}}$"
    try:
        return _core.latex(text)
    except Exception:
        return text


def column(code, data):
    try:
        import numpy
    except ImportError:
        values = array(code)
        values.frombytes(data)
        return values
    return numpy.frombuffer(data, dtype={"q": numpy.int64, "d": numpy.float64}[code])


def scene_of(source, name):
    """The scene of this name, or the only one."""
    scenes = _core.system_scenes(source)
    if name is None and len(scenes) != 1:
        raise InvalidArgument(f"{len(scenes)} scenes: scene=... is one of {', '.join(s.name for s in scenes)}")
    chosen = [s for s in scenes if name is None or s.name == name]
    if not chosen:
        raise InvalidArgument(f"no scene is called {name!r}: {', '.join(s.name for s in scenes)}")
    return chosen[0]


def computed(limits, scene, threads, progress):
    from ._errors import Interrupted

    if progress is not None and not callable(progress):
        raise WrongType(f"progress: a function of (done, all) is expected, and not {progress!r}")
    try:
        return SystemSection(scene, _core.system_section(limits, scene, threads, progress))
    except Interrupted as stopped:
        if stopped.answer is not None:
            stopped.answer = SystemSection(scene, stopped.answer)
        raise


# ---- the text of a scene

_LISTS = ("plot", "start", "angles")
_PLACES = ("range", "seeds", "states", "grid")
_NUMBERS = ("random", "crossings", "skip", "digits")
_WORDS = ("direction", "indicator", "title", "name")


def scene_text(section, levels, options):
    """A [scene] table; numbers are exact, so that floats are refused here as everywhere."""
    lines = ["", "[scene]", f"section = {_formula(section, 'section')}"]
    if levels:
        lines.append("levels = " + _table(levels, "levels"))
    for key, value in options.items():
        if value is not None:
            lines.append(f"{key} = {_value(key, value)}")
    return "\n".join(lines) + "\n"


def _value(key, value):
    if key in _LISTS:
        values = [value] if isinstance(value, str) or _convert.is_sympy(value) else value
        return "[" + ", ".join(_formula(x, key) for x in values) + "]"
    if key in _PLACES:
        return _places(value, key)
    if key in _NUMBERS:
        if not isinstance(value, int) or isinstance(value, bool):
            raise WrongType(f"{key}: an int is expected, and not {value!r}")
        return str(value)
    if key == "set":
        return _table(value, key)
    if key in _WORDS:
        return _system.quoted(value)
    return _formula(value, key)  # where, and the values


def _formula(value, what):
    return _system.quoted(_convert.formula(value, what))


def _table(values, what):
    return "{ " + ", ".join(f"{_system.quoted(_convert.formula(k, what))} = {_formula(v, what)}" for k, v in values.items()) + " }"


def _places(value, what):
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_places(x, what) for x in value) + "]"
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else _formula(value, what)


__all__ = ["SystemSection"]
