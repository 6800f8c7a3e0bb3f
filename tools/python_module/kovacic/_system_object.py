"""A mechanical system as a Python object: System(H, q, p), System.lagrangian, System.poisson, System.field."""

import functools
import re

from . import _convert, _core, _section, _system
from ._errors import InvalidArgument


def _letters(formula, coordinates, rates, name, which):
    """The formula with its coordinates and momenta or velocities; guessed where neither is given."""
    if coordinates is not None or rates is not None:
        return formula, _convert.names(coordinates, "coordinates"), _convert.names(rates, which)
    if isinstance(formula, str) and formula.endswith((".toml", ".json")):
        raise InvalidArgument(f"{name}: a formula is expected; the functions classify, check, ... take the file {formula!r} itself")
    text, q, p = _core.one_line(_convert.formula(formula, name), name)
    return text if isinstance(formula, str) else formula, q, p


class System:
    """A system from formulas: SymPy expressions, or text as in system files.

        >>> S = kovacic.System("(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3", ["q1", "q2"], ["p1", "p2"])
        >>> S.parameters
        ['b']
        >>> S == kovacic.System("p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3", "q1 q2", "p1 p2")
        True

        >>> kovacic.System("H = (p1^2 + p2^2)/2 + q1^2 q2 + b q2^3/3") == S
        True

    Without coordinates and momenta these are guessed from their letters, as the command's -H does.  Names besides them are parameters, and what SymPy assumes of them is assumed.  A System does
    not change; methods answer with the classes of the functions of the same name.  See also System.lagrangian,
    System.poisson and System.field.

    parameters: names (else all that are left); assume: sentences such as "a > 0", or SymPy relations; set: values of
    parameters; title: for reports; manifolds: dicts as for kovacic.hamiltonian.
    """

    __slots__ = ("_text", "_data", "_motion")

    def __init__(self, H, coordinates=None, momenta=None, *, parameters=None, assume=None, set=None, title="", manifolds=()):
        H, q, p = _letters(H, coordinates, momenta, "H", "momenta")
        if len(q) != len(p):
            raise InvalidArgument(f"{len(q)} coordinates and {len(p)} momenta: each coordinate needs one")
        self._make("hamiltonian", {"hamiltonian": H}, {"coordinates": q, "momenta": p}, q + p, parameters, assume, set, title,
                   manifolds)

    @classmethod
    def lagrangian(cls, L, coordinates=None, velocities=None, *, parameters=None, assume=None, set=None, title="", manifolds=()):
        """A system from L(q, q'), quadratic in the velocities.

            >>> kovacic.System.lagrangian("m*v^2/2 - k*x^2/2", ["x"], ["v"]).parameters
            ['k', 'm']
        """
        L, q, v = _letters(L, coordinates, velocities, "L", "velocities")
        if len(q) != len(v):
            raise InvalidArgument(f"{len(q)} coordinates and {len(v)} velocities: each coordinate needs one")
        self = object.__new__(cls)
        self._make("lagrangian", {"lagrangian": L}, {"coordinates": q, "velocities": v}, q + v, parameters, assume, set, title,
                   manifolds)
        return self

    @classmethod
    def poisson(cls, H, coordinates, bracket, *, parameters=None, assume=None, set=None, title="", manifolds=()):
        """A system from H and the matrix of the brackets {x_i, x_j}; the Jacobi identity is checked.

            >>> top = kovacic.System.poisson("x^2/a + y^2/b + z^2/c", "x y z", [[0, "-z", "y"], ["z", 0, "-x"], ["-y", "x", 0]])
            >>> top.parameters
            ['a', 'b', 'c']
        """
        self = object.__new__(cls)
        matrix = [list(bracket[i, :]) for i in range(bracket.rows)] if hasattr(bracket, "rows") else [list(row) for row in bracket]
        self._make("poisson", {"hamiltonian": H}, {"coordinates": _convert.names(coordinates, "coordinates"), "bracket": matrix},
                   _convert.names(coordinates, "coordinates"), parameters, assume, set, title, manifolds)
        return self

    @classmethod
    def field(cls, field, coordinates=None, *, parameters=None, assume=None, set=None, title="", manifolds=()):
        """A system from a vector field: {x: x', ...}, or a list in the order of the coordinates.

            >>> kovacic.System.field({"x": "s*(y - x)", "y": "r*x - y - x*z", "z": "x*y - b*z"}).parameters
            ['b', 'r', 's']
        """
        if hasattr(field, "items"):
            pairs = [(_convert.name(key, "field"), value) for key, value in field.items()]
            order = [name for name, _ in pairs] if coordinates is None else _convert.names(coordinates, "coordinates")
        else:
            order = _convert.names(coordinates, "coordinates")
            pairs = list(zip(order, field, strict=True))
        if sorted(order) != sorted(name for name, _ in pairs):
            raise InvalidArgument("each coordinate needs one derivative")
        self = object.__new__(cls)
        self._make("vector-field", dict(pairs), {"coordinates": order}, order, parameters, assume, set, title, manifolds)
        return self

    @classmethod
    def from_text(cls, text):
        """A system file, by its text (docs/guide/system-files.md); what to_text() of another one is.

            >>> kovacic.System.from_text(S.to_text()) == S
            True
        """
        self = object.__new__(cls)
        self._text, self._motion = _convert.plain(text, "the text"), None
        if "\n" not in text:
            raise InvalidArgument("the text of a system file is expected; a path is for kovacic.check and the others")
        self._data = None
        return self

    def _make(self, kind, formulas, lists, moving, parameters, assume, set, title, manifolds):
        names, sentences = _convert.names(parameters, "parameters"), _convert.texts(assume, "assume")
        values = list(formulas.values()) + [x for row in lists.get("bracket", []) for x in row]
        free = {}
        for value in values:
            free |= _names_of(value)
        own = {n: s for n, s in free.items() if n not in moving}
        names += [n for n in sorted(own) if n not in names and n != "I"]
        sentences = _convert.assumptions_of({n: s for n, s in own.items() if s is not None}) + sentences
        texts = {key: _convert.formula(value, key) for key, value in formulas.items()}
        lines = ['format = "equation/1"', *([f"title = {_system.quoted(title)}"] if title else []), "", "[system]", f'kind = "{kind}"']
        for key, value in lists.items():
            if key == "bracket":
                lines.append("bracket = [" + ", ".join(_system.listed(_convert.formula(x, "bracket") for x in row) for row in value) + "]")
            else:
                lines.append(f"{key} = {_system.listed(value)}")
        lines.append(f"parameters = {_system.listed(names)}")
        if kind == "vector-field":
            lines += ["", "[system.field]"]
        lines += [f"{key} = {_system.quoted(text)}" for key, text in texts.items()]
        pairs = _convert.values(set)
        if pairs:
            lines += ["", "[set]"] + [f"{name} = {_system.quoted(value)}" for name, value in pairs]
        if sentences:
            lines += ["", "[assume]"] + _system.assumed(sentences)
        for m in [manifolds] if isinstance(manifolds, dict) else manifolds:
            lines += _system.manifold(m)
        self._text, self._motion = "\n".join(lines) + "\n", None
        self._data = {"kind": kind, **lists, "parameters": names, **({"field": texts} if kind == "vector-field" else texts),
                      **({"set": dict(pairs)} if pairs else {}), **({"assume": sentences} if sentences else {})}

    # ---- what it is

    @property
    def kind(self):
        """hamiltonian, lagrangian, poisson or vector-field.

            >>> S.kind
            'hamiltonian'
        """
        return self._data["kind"] if self._data else self._motion_().kind

    @property
    def coordinates(self):
        """The phase variables, momenta included.

            >>> S.coordinates
            ['q1', 'q2', 'p1', 'p2']
        """
        return list(self._motion_().coordinates)

    @property
    def parameters(self):
        """The free constants.

            >>> S.parameters
            ['b']
        """
        return list(self._motion_().parameters)

    @property
    def hamiltonian(self):
        """H as a function of coordinates and momenta, also of a Lagrangian system; None for a vector field.

            >>> str(S.hamiltonian)
            '(6*q1^2*q2 + 2*q2^3*b + 3*p1^2 + 3*p2^2)/6'
        """
        return self._motion_().hamiltonian

    def to_text(self):
        """The system file, as kovacic.check and the command read it.

            >>> print(S.to_text().splitlines()[3])
            kind = "hamiltonian"
        """
        return self._text

    def to_dict(self):
        """Kind, names and formulas as a dict of lists and strings.

            >>> S.to_dict()["momenta"]
            ['p1', 'p2']
        """
        if self._data is None:
            m = self._motion_()
            return {"kind": m.kind, "coordinates": list(m.coordinates), "parameters": list(m.parameters),
                    "field": dict(zip(m.coordinates, map(str, m.components)))}
        return {key: (value.copy() if isinstance(value, (list, dict)) else value) for key, value in self._data.items()}

    def latex(self):
        r"""The equations of motion in LaTeX; needs SymPy.

            >>> S.latex().splitlines()[1]
            '\\dot{q}_{1} &= p_{1} \\\\'
        """
        import sympy

        lines = [rf"{_dotted(sympy.latex(sympy.Symbol(x)))} &= {sympy.latex(f)} \\"
                 for x, f in self.equations(sympy=True).items()]
        return "\n".join([r"\begin{aligned}", *lines, r"\end{aligned}"])

    def _repr_latex_(self):
        return "$$" + self.latex() + "$$"

    def __repr__(self):
        m = self._motion_()
        what = f"H = {m.hamiltonian}" if m.hamiltonian is not None else "; ".join(
            f"{x}' = {f}" for x, f in zip(m.coordinates, m.components))
        what = what if len(what) <= 80 else what[:77] + "..."
        free = f"; parameters {', '.join(m.parameters)}" if m.parameters else ""
        return f"<System ({self.kind}): {what}{free}>"

    def _key(self):
        """Two systems are equal where kind, names, field, Hamiltonian, and what is assumed or set, are."""
        m = self._motion_()
        others = tuple(line for line in self._text.splitlines()[self._text.splitlines().index("[system]"):]
                       if not re.match(r"(kind|hamiltonian|lagrangian|coordinates|momenta|velocities|parameters|bracket)\s*=", line))
        field = () if m.kind == "vector-field" else others
        own = tuple(line for line in field if line.strip() and line != "[system]")
        return (m.kind, tuple(m.coordinates), tuple(sorted(m.parameters)), tuple(map(str, m.components)), str(m.hamiltonian), own)

    def __eq__(self, other):
        return self._key() == other._key() if isinstance(other, System) else NotImplemented

    def __hash__(self):
        return hash(self._key())

    def __bool__(self):
        raise TypeError("a System is not a truth value; ask .classify(), .check(), ...")

    def __reduce__(self):
        return _restored, (self._text, self._data)

    def _motion_(self):
        if self._motion is None:
            self._motion = _core.motion(self._source(), [])
        return self._motion

    def _source(self):
        return _core.Source(self._text, "system")

    # ---- questions

    def equations(self, sympy=False):
        """The equations of motion as {variable: derivative}; sympy=True: as SymPy expressions.

            >>> S.equations()["p1"]
            MFraction('-2*q1*q2')
        """
        m = self._motion_()
        field = dict(zip(m.coordinates, m.components))
        if not sympy:
            return field
        return {x: _with_functions(_convert.to_sympy(str(f)), m.functions) for x, f in field.items()}

    def variational_equations(self):
        """The first variational equations along a solution, xi' = J xi: J as a SymPy matrix, the rows and columns in the
        order of .coordinates.

            >>> S.variational_equations()[2, 0]
            -2*q2
        """
        import sympy

        variables = [sympy.Symbol(x) for x in self.coordinates]
        return sympy.Matrix(list(self.equations(sympy=True).values())).jacobian(variables)

    def classify(self, **options):
        """For which parameters is it integrable?  kovacic.classify of this system.

            >>> [s.conditions for s in S.classify().strata if s.status is kovacic.StratumStatus.integrable]
            [['b = 1'], ['b = 6'], ['b = 16']]
        """
        return _package().classify(self, **options)

    def check(self, **options):
        """What follows from each manifold; where the system has none, from those of with_manifolds().  kovacic.check of
        this system.

            >>> print(S.check(set={"b": 3}).verdict)
            VerdictKind.non_integrable
        """
        given = self if "[[manifold]]" in self._text else self.with_manifolds()
        return _package().check(given, **options)

    def with_manifolds(self, manifolds=None):
        """The same system with manifolds: those given, or those of find_manifolds() that are phase curves, or become
        phase curves on each level H = h.

            >>> S.with_manifolds().to_text().count("[[manifold]]") > 0
            True
        """
        if manifolds is not None:
            return _restored(_with_blocks(self._text, manifolds), self._data)
        level = next(n for n in ("h", "E", "h0", "level_h") if n not in self.coordinates + self.parameters)
        found = [m for m in self.find_manifolds() if not m.equilibria and m.dimension <= 1 + (self.hamiltonian is not None)]
        blocks = [{"name": f"M{i + 1}", "equations": m.equations, **({"level": [f"H = {level}"]} if m.dimension == 2 else {})}
                  for i, m in enumerate(found)]
        text = self._text
        if any("level" in block for block in blocks):
            names = _system.listed([*self.parameters, level])
            text = re.sub(r"^parameters\s*=.*$", lambda _: f"parameters = {names}", text, count=1, flags=re.M)
        return _restored(_with_blocks(text, blocks), self._data)

    def integrals(self, degree=2, **options):
        """First integrals of this degree in the momenta.  kovacic.integrals of this system.

            >>> kovacic.System("p^2/2 + q^4", "q", "p").integrals().finished
            True
        """
        return _package().integrals(self, degree, **options)

    def find_manifolds(self, *, timeout=60, max_work=None):
        """Invariant sets that can be read off the vector field, each proved: FoundManifold with .equations, .kind, ...

            >>> [m.equations for m in S.find_manifolds()][0]
            ['q1 = 0', 'p1 = 0']
        """
        return _core.find_manifolds(_package()._limits(timeout, max_work), self._source(), [])

    def section(self, section, levels=None, *, plot, range=None, grid=None, seeds=None, random=None, states=None,
                crossings=None, time=None, threads=1, progress=None, timeout=None, **more):
        """Where orbits meet the set `section` = 0: a SystemSection, with points and .plot().

            >>> H = kovacic.System("(p1^2 + p2^2 + q1^2 + q2^2)/2 + q1^2*q2 - q2^3/3", "q1 q2", "p1 p2")
            >>> s = H.section("q1", {"H": "1/12"}, plot=["q2", "p2"], seeds=[(0, "1/10")], crossings=20)
            >>> len(s.points), s.stopped
            (20, False)

        levels: values of H and of other integrals; plot: the two formulas that are drawn; seeds=[(u, v), ...] or
        grid=(columns, rows) or random=orbits inside of range=[(a, b), (c, d)]: where orbits start in the picture; or
        states=[[x1, x2, ...], ...].  `more` are the other keys of docs/guide/sections.md: direction, where, start, angles, skip,
        set, tolerance, drift, digits, indicator ("megno", ...), title.  progress(done, all) is called after each orbit.
        """
        places = {"range": range, "grid": grid, "seeds": seeds, "random": random, "states": states}
        ends = {"crossings": 300 if crossings is None and time is None else crossings, "time": time}
        text = self._text + _section.scene_text(section, levels, {"plot": plot, **places, **ends, **more})
        scene = _section.scene_of(_core.Source(text, "system"), None)
        return _section.computed(_package()._limits(timeout, None), scene, threads, progress)


def _with_blocks(text, manifolds):
    lines = []
    for m in [manifolds] if isinstance(manifolds, dict) else manifolds:
        lines += _system.manifold(m)
    return text + "\n".join(lines) + "\n" if lines else text


def _restored(text, data):
    self = System.from_text(text)
    self._data = data
    return self


def _package():
    import kovacic

    return kovacic


def _names_of(value):
    """{name: Symbol, or None for a text}"""
    if _convert.is_sympy(value):
        return _convert.symbols_of(value)
    if not isinstance(value, str):
        return {}
    return {name: None for name in re.findall(r"[A-Za-z_]\w*(?!\w*\s*\()", value)}


def _dotted(letter):
    return re.sub(r"^(\\?[A-Za-z]+)", r"\\dot{\1}", letter)


def _with_functions(expression, functions):
    """Symbols for sin(q), ... by what they mean."""
    import sympy

    known = {sympy.Symbol(name): _meaning(text) for name, text in functions.items()}
    return expression.subs(known) if known else expression


@functools.lru_cache(maxsize=None)
def _meaning(text):
    import sympy

    names = {n: sympy.Symbol(n) for n in re.findall(r"[A-Za-z_]\w*", text) if not hasattr(sympy, n) or len(n) == 1}
    return sympy.sympify(text.replace("^", "**"), locals=names, rational=True)


__all__ = ["System"]
