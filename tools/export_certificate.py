#!/usr/bin/env python3
"""The data of a certificate as definitions for another program, with the identities that it states.

usage: export_certificate.py --to sympy|maxima|sage FILE      (- is standard input)

r, and of every step its polynomials and numbers, named STEP_KEY; of an exponential solution omega, and of an
invariant of degree 2 its function v, what is left of each in its equation is printed: 0.  Only the format is read
(docs/theory/certificates.md); the proof is checked by kovacic_verify.py and `kovacic verify`.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "verify"))
from certificate_format import RULES, Malformed, parse  # noqa: E402

POWER = {"sympy": "**", "maxima": "^", "sage": "^"}


class Export:
    def __init__(self, program, certificate):
        self.program, self.certificate, self.lines = program, certificate, []
        self.generator = certificate["field"]["name"]

    def text(self):
        r, claim = self.certificate["r"], self.certificate["claim"]
        self.comment(f"y'' = r(z) y: group {claim['group']}, identity component {claim['component']}, "
                     f"abelian: {claim['abelian']}")
        self.begin()
        self.define("r", f"({self.polynomial(r['num'])})/({self.polynomial(r['den'])})")
        for step in self.certificate["steps"]:
            self.comment(f"{step['id']}: {step['rule']}" + "".join(f", from {name}" for name in step["premises"]))
            if step["rule"] in RULES:
                self.data(identifier(step["id"]), step["data"], RULES[step["rule"]])
            getattr(self, step["rule"].replace("-", "_"), lambda *_: None)(identifier(step["id"]), step["data"])
        return "\n".join(self.lines) + "\n"

    def comment(self, words):
        words = words.replace("\n", " ").replace("*/", "* /")
        self.lines.append(f"/* {words} */" if self.program == "maxima" else f"# {words}")

    def define(self, name, value):
        self.lines.append(f"{name} : {value}$" if self.program == "maxima" else f"{name} = {value}")

    def begin(self):
        minimal = self.polynomial(self.certificate["field"]["minpoly"], "t") if self.generator else None
        if self.program == "sympy":
            self.lines.append("from sympy import *")
            self.define("z", "Symbol('z')")
            if minimal:
                self.define(self.generator, f"rootof((lambda t: {minimal})(Symbol('t')), 0)")
        elif self.program == "sage":
            self.define("z", "var('z')")
            if minimal:
                self.define(self.generator, f"QQ['t']({minimal}).roots(QQbar, multiplicities=False)[0]")
        elif minimal:
            self.lines.append(f"tellrat({self.polynomial(self.certificate['field']['minpoly'], self.generator)})$")
            self.lines.append("algebraic : true$")

    def data(self, name, value, kind):
        """Everything below a schema of certificate_format.RULES that is a polynomial or a number."""
        if isinstance(kind, dict):
            if isinstance(kind.get("by"), dict):
                kind = kind | kind["by"][value["by"]] | {"by": "text"}
            for key, inner in kind.items():
                if value.get(key.rstrip("?")) is not None:
                    self.data(f"{name}_{key.rstrip('?')}", value[key.rstrip("?")], inner)
        elif isinstance(kind, list):
            for number, item in enumerate(value, 1):
                self.data(f"{name}{number}", item, kind[0])
        elif kind == "poly":
            self.define(name, self.polynomial(value))
        elif kind in ("int", "rational", "residue"):
            self.define(name, self.number(value))
        else:
            self.comment(f"{name}: {value}")

    def exponential(self, name, _):
        self.define(f"{name}_omega", f"{name}_num/{name}_den + diff({name}_p, z)/{name}_p")
        self.vanishes(f"diff({name}_omega, z) + {name}_omega{POWER[self.program]}2 - r")

    def invariant(self, name, data):
        factors = "".join(f"*{name}_factors{i}_q{POWER[self.program]}({name}_factors{i}_e)"
                          for i in range(1, len(data["factors"]) + 1))
        self.define(f"{name}_v", f"{name}_p{factors}")
        if data["m"] == "2":
            self.vanishes(f"diff({name}_v, z, 3) - 4*r*diff({name}_v, z) - 2*diff(r, z)*{name}_v")

    def vanishes(self, left):
        self.lines.append({"sympy": f"print(simplify({left}))  # 0", "maxima": f"ratsimp({left});",
                           "sage": f"print(({left}).simplify_full())  # 0"}[self.program])

    def number(self, text):
        return re.sub(r"(\d+)", r"Integer(\1)", text) if self.program == "sympy" else text

    def polynomial(self, coefficients, variable="z"):
        terms = [f"({self.element(c)})*{variable}{POWER[self.program]}{i}" for i, c in enumerate(coefficients)]
        return " + ".join(terms) or self.number("0")

    def element(self, value):
        if isinstance(value, str):
            return self.number(value)
        return " + ".join(f"({self.number(x)})*{self.generator}{POWER[self.program]}{i}" for i, x in enumerate(value))


def identifier(name):
    return "s_" + re.sub(r"\W", "_", name)


def main():
    if len(sys.argv) != 4 or sys.argv[1] != "--to" or sys.argv[2] not in POWER:
        sys.exit("usage: export_certificate.py --to sympy|maxima|sage FILE")
    try:
        text = sys.stdin.read() if sys.argv[3] == "-" else open(sys.argv[3], encoding="utf-8").read()
        certificate = parse(text)
        if certificate.get("format") != "kovacic-certificate/1":
            raise Malformed("a certificate of the format kovacic-certificate/1 is expected")
        print(Export(sys.argv[2], certificate).text(), end="")
    except (Malformed, OSError, KeyError, TypeError, AttributeError) as error:
        print(f"export_certificate.py: {sys.argv[3]}: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
