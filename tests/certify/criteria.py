"""Leaves that rest on the closed criterion of a classical equation (strata_certificates.md 7.8): right ones of each family,
and each with one entry changed.  Parameters are A, B, C."""
import copy
import json


def fraction(num, den="1"):
    return {"num": num, "den": den}


def square(text, root=None, den="1"):
    return {"square": fraction(text, den)} | ({"root": fraction(root)} if root else {})


def shown(value, integral, times=1, i=0):
    return {"value": value, "integral": integral, "times": str(times), "membership": str(i)}


def certificate(r, by, numbers, said="where", equation=None, change=None, factors=None, given=(), known=(), rational=(),
                names="ABC", nonzero=()):
    leaf = {"node": "leaf", "abelian": said, "by": by, "change": change or fraction("z"), "equation": dict(equation or r),
            "numbers": numbers}
    leaf |= ({"factors": factors} if factors else {}) | ({"shown": list(known)} if known else {})
    top = {"format": "kovacic-strata/1", "variable": "z", "parameters": list(names), "real": [],
           "assumptions": [{"p": p, "sign": "nonzero"} for p in nonzero], "generic": [], "r": r,
           "claim": {"abelian": None}, "tree": leaf}
    if given:
        top["memberships"] = [value | {"integral": integral} for value, integral in given]
    return top | ({"rational": list(rational)} if rational else {})


BESSEL = fraction("4*A^2 - 4*z^2 - 1", "4*z^2")
ORDER = [square("0"), square("A^2", "A")]
WHITTAKER = fraction("z^2 - 4*A*z + 4*B^2 - 1", "4*z^2")
PAIR = [square("A^2", "A"), square("B^2", "B")]
RAMIFIED = fraction("4*B*z + A^2 - 1", "4*z^2")
LEGENDRE = fraction("A^2*z^2 + A*z^2 - A^2 - A - 1", "z^4 - 2*z^2 + 1")
INDEX = square("4*A^2 + 4*A + 1", "2*A + 1")
RIEMANN = fraction("C^2*z^2 + B^2*z - C^2*z - A^2*z - z^2 + A^2 + z - 1", "4*z^4 - 8*z^3 + 4*z^2")
THREE = [*PAIR, square("C^2", "C")]
LAME = fraction("64*A^2*z^4 + 64*A*z^4 - 48*z^4 + 64*z^3 - 64*A^2*z^2 - 64*A*z^2 - 96*z^2 - 64*z - 48",
                "256*z^6 - 512*z^4 + 256*z^2")
FOURS = [square("1", None, "4"), INDEX]
HALF, ODD = fraction("2*A - 1", "2"), fraction("A + B + C - 1", "2")


def two(said, value, integral, given, is_in, times=1):
    return {"said": said, "known": [shown(value, integral, times)], "given": [(given, is_in)]}


def right():
    yield "bessel", certificate(BESSEL, "whittaker", ORDER)
    yield "bessel yes", certificate(BESSEL, "whittaker", ORDER, **two("yes", HALF, True, HALF, True))
    yield "bessel no", certificate(BESSEL, "whittaker", ORDER, **two("no", HALF, False, fraction("2*A"), False, 2))
    yield "bessel m", certificate(fraction("16*m^2 - 4*z^2 + 16*m + 3", "4*z^2"), "whittaker",
                                  [square("0"), square("4*m^2 + 4*m + 1", "2*m + 1")], names="m")
    yield "bessel often", certificate(BESSEL, "whittaker", ORDER, "yes", known=[shown(HALF, True)] * 1000,
                                      given=[(HALF, True)])
    yield "square", certificate(fraction("16*A^2 - 16*z^4 - 1", "4*z^2"), "whittaker", ORDER, equation=BESSEL,
                                change=fraction("z^2"))
    yield "turned", certificate(fraction("4*A^2*z^2 - z^2 - 4", "4*z^4"), "whittaker", ORDER, equation=BESSEL,
                                change=fraction("1", "z"))
    yield "scaled", certificate(fraction("4*A^2 - 4*B^2*z^2 - 1", "4*z^2"), "whittaker", ORDER, equation=BESSEL,
                                change=fraction("B*z"), nonzero=["B"])
    yield "whittaker", certificate(WHITTAKER, "whittaker", PAIR)
    for value in (fraction("2*A + 2*B - 1", "2"), fraction("2*A - 2*B - 1", "2"), fraction("2*A"), fraction("2*B")):
        yield "whittaker no", certificate(WHITTAKER, "whittaker", PAIR, **two("no", value, False, value, False))
    for k, m, said in (("4", "9", "yes"), ("4", "1", "no"), ("0", "9", "yes"), ("9", "9", "no"), ("4", "3", "no"),
                       ("2", "9", "no"), ("16", "25", "yes"), ("36", "9", "no")):
        # k^2/4 and m^2/4 are given: a = B^2, b = -2 k B, c = m^2 - 1 over 4 z^2
        root = {"0": "0", "4": "2", "9": "3", "16": "4", "36": "6"}.get(k)
        r = fraction(f"B^2*z^2 - {2 * int(root)}*B*z + {int(m) - 1}" if root and root != "0" else
                     f"B^2*z^2 + {int(m) - 1}", "4*z^2") if root else fraction(f"2*B^2*z^2 + 4*B*z + {int(m) - 1}", "4*z^2")
        yield f"numbers {k} {m}", certificate(r, "whittaker", [square(k, None, "4"), square(m, None, "4")], said,
                                              nonzero=["B"])
    yield "ramified", certificate(RAMIFIED, "bessel", [square("A^2", "A")], nonzero=["B"])
    yield "ramified yes", certificate(RAMIFIED, "bessel", [square("A^2", "A")], nonzero=["B"],
                                      **two("yes", HALF, True, HALF, True))
    yield "legendre", certificate(LEGENDRE, "riemann", [square("0"), INDEX], factors=["z^2 - 1"])
    index = fraction("A")
    for said, integral in (("yes", True), ("no", False)):
        yield f"legendre {said}", certificate(LEGENDRE, "riemann", [square("0"), INDEX], factors=["z^2 - 1"],
                                              **two(said, index, integral, index, integral))
    yield "riemann", certificate(RIEMANN, "riemann", THREE, factors=["z", "z - 1"])
    yield "riemann yes", certificate(RIEMANN, "riemann", THREE, factors=["z", "z - 1"], rational=["A", "B"],
                                     **two("yes", ODD, True, ODD, True))
    halves = [shown(HALF, True), shown(fraction("2*B - 1", "2"), True, 1, 1)]
    yield "riemann halves", certificate(RIEMANN, "riemann", THREE, "yes", factors=["z", "z - 1"], known=halves,
                                        given=[(HALF, True), (fraction("2*B - 1", "2"), True)])
    none = [ODD, fraction("A + B - C - 1", "2"), fraction("A - B + C - 1", "2"), fraction("A - B - C - 1", "2"),
            HALF, fraction("2*B - 1", "2"), fraction("60*C")]
    yield "riemann no", certificate(RIEMANN, "riemann", THREE, "no", factors=["z", "z - 1"],
                                    known=[shown(f, False, 1, i) for i, f in enumerate(none)],
                                    given=[(f, False) for f in none])
    yield "lame", certificate(LAME, "lame", FOURS, factors=["z^3 - z"])
    yield "lame yes", certificate(LAME, "lame", FOURS, factors=["z^3 - z"], **two("yes", index, True, index, True))
    yield "lame no", certificate(LAME, "lame", FOURS, factors=["z^3 - z"],
                                 **two("no", fraction("60*A"), False, fraction("60*A"), False))


# (name, path, what is put there): each makes a certificate false
WRONG = [
    ("bessel", ["tree", "abelian"], "yes"), ("bessel", ["tree", "abelian"], "no"), ("bessel", ["tree", "abelian"], "open"),
    ("bessel", ["tree", "by"], "bessel"), ("bessel", ["tree", "by"], "riemann"), ("bessel", ["tree", "by"], "airy"),
    ("bessel", ["tree", "equation", "num"], "4*A^2 + 4*z^2 - 1"), ("bessel", ["tree", "change", "num"], "A"),
    ("bessel", ["tree", "change", "num"], "2*z"), ("bessel", ["tree", "change", "den"], "0"),
    ("bessel", ["tree", "equation", "den"], "0"),
    ("bessel", ["tree", "numbers", 1, "square", "num"], "A^2 + 1"), ("bessel", ["tree", "numbers", 1, "root", "num"], "2*A"),
    ("bessel", ["tree", "numbers", 1, "square", "den"], "4"), ("bessel", ["tree", "numbers", 0, "square", "num"], "1"),
    ("bessel", ["tree", "numbers"], []), ("bessel", ["tree", "numbers"], ORDER[:1]), ("bessel", ["tree", "factors"], ["z"]),
    ("bessel", ["claim", "abelian"], True), ("bessel", ["claim", "abelian"], False),
    ("bessel yes", ["tree", "abelian"], "no"), ("bessel yes", ["memberships", 0, "integral"], False),
    ("bessel yes", ["memberships", 0, "num"], "2*A"), ("bessel yes", ["memberships", 0, "num"], "A"),
    ("bessel yes", ["memberships", 0, "den"], "4"), ("bessel yes", ["tree", "shown", 0, "membership"], "1"),
    ("bessel yes", ["tree", "shown", 0, "membership"], "-1"), ("bessel yes", ["tree", "shown", 0, "times"], "2"),
    ("bessel yes", ["tree", "shown", 0, "times"], "0"), ("bessel yes", ["tree", "shown", 0, "value", "num"], "2*A"),
    ("bessel yes", ["tree", "shown", 0, "integral"], False), ("bessel yes", ["tree", "shown"], []),
    ("bessel yes", ["claim", "abelian"], False),
    ("bessel no", ["tree", "abelian"], "yes"), ("bessel no", ["tree", "shown", 0, "times"], "1"),
    ("bessel no", ["memberships", 0, "integral"], True), ("bessel no", ["memberships", 0, "num"], "A"),
    ("bessel no", ["tree", "shown", 0, "integral"], True),
    ("bessel often", ["tree", "shown"], [shown(HALF, True)] * 1001), ("bessel m", ["tree", "numbers", 1, "root", "num"], "m"),
    ("bessel", ["tree", "equation", "num"], "z^9999"), ("bessel", ["tree", "equation", "den"], "z^9999 + 1"),
    ("square", ["r", "num"], "16*A^2 - 16*z^4 - 4"), ("square", ["tree", "change", "num"], "z^3"),
    ("turned", ["tree", "change", "den"], "z^2"), ("scaled", ["assumptions"], []),
    ("scaled", ["assumptions", 0, "sign"], "nonnegative"),
    ("whittaker", ["tree", "abelian"], "no"), ("whittaker", ["tree", "numbers", 0, "square", "num"], "4*A^2"),
    ("whittaker", ["tree", "numbers"], PAIR[::-1]),
    ("whittaker no", ["tree", "abelian"], "yes"), ("whittaker no", ["memberships", 0, "integral"], True),
    ("numbers 4 9", ["tree", "abelian"], "no"), ("numbers 4 1", ["tree", "abelian"], "yes"),
    ("numbers 9 9", ["tree", "abelian"], "yes"), ("numbers 36 9", ["tree", "abelian"], "yes"),
    ("numbers 4 3", ["tree", "abelian"], "yes"), ("numbers 2 9", ["tree", "abelian"], "yes"),
    ("numbers 0 9", ["tree", "abelian"], "no"), ("numbers 4 9", ["assumptions"], []),
    ("ramified", ["assumptions"], []), ("ramified", ["tree", "numbers", 0, "square", "num"], "4*A^2"),
    ("ramified", ["tree", "by"], "whittaker"), ("ramified yes", ["memberships", 0, "num"], "A - 1"),
    ("legendre", ["tree", "factors"], ["z - 1"]), ("legendre", ["tree", "factors"], ["z^2 - 2*z + 1"]),
    ("legendre", ["tree", "factors"], ["z^2 - 2"]), ("legendre", ["tree", "factors"], ["A*z^2 - A"]),
    ("legendre", ["tree", "factors"], ["z - 1", "z + 1"]), ("legendre", ["tree", "numbers", 0, "square", "num"], "1"),
    ("legendre", ["tree", "numbers"], [square("0")]), ("legendre", ["tree", "by"], "lame"),
    ("legendre yes", ["tree", "abelian"], "no"), ("legendre no", ["tree", "abelian"], "yes"),
    ("legendre yes", ["memberships", 0, "num"], "2*A"), ("legendre no", ["memberships", 0, "den"], "2"),
    ("riemann", ["tree", "abelian"], "yes"), ("riemann", ["tree", "abelian"], "no"),
    ("riemann", ["tree", "factors"], ["z - 1", "z"]), ("riemann", ["tree", "factors"], ["z", "z - 1", "z - 2"]),
    ("riemann", ["tree", "numbers"], PAIR), ("riemann", ["tree", "numbers", 2, "square", "num"], "C^2 + 1"),
    ("riemann yes", ["rational"], ["A"]), ("riemann yes", ["memberships", 0, "num"], "A + B + C"),
    ("riemann yes", ["tree", "abelian"], "no"), ("riemann halves", ["tree", "shown"], [shown(HALF, True)]),
    ("riemann halves", ["tree", "shown", 1, "membership"], "0"),
    *(("riemann no", ["tree", "shown", i, "value", "num"], "A*B*C") for i in range(7)),
    *(("riemann no", ["memberships", i, "integral"], True) for i in range(7)),
    ("lame", ["tree", "abelian"], "yes"), ("lame", ["tree", "numbers", 0, "square", "den"], "9"),
    ("lame", ["tree", "numbers", 1, "square", "num"], "A^2 + A + 1"), ("lame", ["tree", "by"], "riemann"),
    ("lame", ["tree", "factors"], ["z^3 - 2*z"]), ("lame", ["tree", "factors"], ["z^2 - z"]),
    ("lame yes", ["memberships", 0, "num"], "2*A"), ("lame yes", ["tree", "abelian"], "no"),
    ("lame no", ["memberships", 0, "num"], "A"), ("lame no", ["tree", "shown", 0, "value", "num"], "6*A"),
    ("lame no", ["tree", "abelian"], "yes")]


def changed(text, path, value):
    text = copy.deepcopy(text)
    at = text
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return text


def certificates():
    good = {}
    for name, text in right():
        good[name] = text
        yield name, json.dumps(text), True
    for name, path, value in WRONG:
        yield f"{name}: {'.'.join(map(str, path))} = {str(value)[:40]}", json.dumps(changed(good[name], path, value)), False
