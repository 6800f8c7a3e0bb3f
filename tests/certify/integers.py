"""Leaves whose criterion follows from several memberships together, or from the sign of an integer
(strata_certificates.md 7.8): right ones, and each with one entry changed.  Parameters are A and B."""
import json

from criteria import BESSEL, HALF, ORDER, PAIR, WHITTAKER, certificate, changed, fraction


def together(value, integral, times, i, *rest):
    """rest: pairs of a multiple and a membership"""
    return {"value": value, "integral": integral, "times": str(times), "membership": str(i),
            "with": [{"times": str(n), "membership": str(j)} for n, j in rest]}


def bessel(said, known, *given):
    return certificate(BESSEL, "whittaker", ORDER, said, known=[known], given=given)


def whittaker(said, known, given, signs=(), real="AB"):
    """signs: (polynomial, sign)"""
    top = certificate(WHITTAKER, "whittaker", PAIR, said, known=known, given=given, names="AB")
    top["real"], top["assumptions"] = list(real), [{"p": p, "sign": sign} for p, sign in signs]
    return top


def plain(value, i):
    return {"value": value, "integral": True, "times": "1", "membership": str(i)}


P, Q = fraction("2*A + 2*B - 1", "2"), fraction("2*A - 2*B - 1", "2")
BOTH = [plain(P, 0), plain(Q, 1)], [(P, True), (Q, True)]
UP, DOWN = "2*A + 2*B + 1", "2*B - 2*A + 1"             # 2 (P + 1), -2 Q
LARGE = "2*A - 2*B + 1"                                 # 2 (Q + 1)
BELOW = "1 - 2*A - 2*B"                                 # -2 P


def right():
    a, b = fraction("6*A - 1", "2"), fraction("10*A - 1", "2")
    # A - 1/2 = 2 (3 A - 1/2) - (5 A - 1/2)
    yield "sum", bessel("yes", together(HALF, True, 2, 0, (-1, 1)), (a, True), (b, True))
    yield "sum of three", bessel("yes", together(HALF, True, -1, 2, (2, 0), (1, 1), (-1, 1)), (a, True), (b, True), (b, True))
    # 6 A is an integer and 10 A is half of an odd one: 2 A would be half of an odd one, so A - 1/2 is none
    ten = fraction("20*A - 1", "2")
    yield "no constant", bessel("no", together(HALF, False, 4, 1, (1, 0)), (fraction("6*A"), True), (ten, True))
    # if A - 1/2 were an integer, 2 A + 3 A + ... would be, too
    yield "would be", bessel("no", together(HALF, False, 2, 1, (1, 0)), (fraction("3*A + B"), True), (fraction("5*A + B"), False))
    yield "no sum", whittaker("no", [together(fraction("2*B"), False, 1, 1, (1, 0))],
                              [(fraction("A - B"), True), (fraction("4*A + 4*B - 1", "4"), True)])
    for name, said, first, second in (("between", "yes", UP, DOWN), ("above", "no", UP, LARGE), ("below", "no", BELOW, DOWN),
                                      ("beside", "yes", BELOW, LARGE)):
        yield name, whittaker(said, *BOTH, [(first, "positive"), (second, "positive")])


WRONG = [
    ("sum", ["memberships", 0, "integral"], False), ("sum", ["memberships", 1, "integral"], False),
    ("sum", ["tree", "shown", 0, "times"], "1"), ("sum", ["tree", "shown", 0, "times"], "3"),
    ("sum", ["tree", "shown", 0, "with", 0, "times"], "1"), ("sum", ["tree", "shown", 0, "with", 0, "membership"], "0"),
    ("sum", ["tree", "shown", 0, "with", 0, "membership"], "2"), ("sum", ["tree", "shown", 0, "with", 0, "membership"], "-1"),
    ("sum", ["tree", "shown", 0, "with"], []), ("sum", ["tree", "shown", 0, "with", 0, "times"], "-10000001"),
    ("sum", ["tree", "shown", 0, "with", 0], {"times": "-1"}), ("sum", ["tree", "shown", 0, "with", 0, "times"], "-1/1"),
    ("sum", ["tree", "shown", 0, "with"], [{"times": "0", "membership": "1"}] * 100 + [{"times": "-1", "membership": "1"}]),
    ("sum", ["tree", "shown", 0, "integral"], False), ("sum", ["memberships", 1, "num"], "5*A - 1"),
    ("sum", ["tree", "abelian"], "no"), ("sum of three", ["tree", "shown", 0, "with", 2, "times"], "0"),
    ("no constant", ["tree", "shown", 0, "integral"], True), ("no constant", ["tree", "shown", 0, "times"], "5"),
    ("no constant", ["memberships", 1, "num"], "20*A"), ("no constant", ["memberships", 0, "integral"], False),
    ("no constant", ["memberships", 1, "integral"], False), ("no constant", ["tree", "shown", 0, "with", 0, "times"], "0"),
    ("no constant", ["tree", "abelian"], "yes"),
    ("would be", ["memberships", 1, "integral"], True), ("would be", ["memberships", 0, "integral"], False),
    ("would be", ["tree", "shown", 0, "times"], "1"), ("would be", ["tree", "shown", 0, "with", 0, "times"], "2"),
    ("would be", ["memberships", 1, "num"], "4*A + B"), ("would be", ["memberships", 1, "num"], "10*A + 2*B + 1"),
    ("would be", ["tree", "abelian"], "yes"),
    ("no sum", ["memberships", 1, "num"], "2*A + 2*B"), ("no sum", ["tree", "shown", 0, "with", 0, "times"], "2"),
    ("between", ["tree", "abelian"], "no"), ("above", ["tree", "abelian"], "yes"), ("below", ["tree", "abelian"], "yes"),
    ("beside", ["tree", "abelian"], "no"), ("between", ["assumptions", 0, "sign"], "nonnegative"),
    ("between", ["assumptions", 0, "sign"], "nonzero"), ("between", ["assumptions", 1, "sign"], "nonzero"),
    ("between", ["assumptions", 0, "p"], "2*A + 2*B + 3"), ("between", ["assumptions", 1, "p"], "2*B - 2*A + 3"),
    ("above", ["assumptions", 1, "p"], "2*A - 2*B + 3"), ("below", ["assumptions", 0, "p"], "3 - 2*A - 2*B"),
    ("between", ["memberships", 0, "num"], "2*A + 2*B"), ("between", ["memberships", 1, "num"], "A - B"),
    ("between", ["tree", "shown"], BOTH[0][:1]), ("between", ["tree", "shown"], BOTH[0][1:]),
    ("between", ["assumptions"], [{"p": UP, "sign": "positive"}]), ("between", ["assumptions"], [{"p": DOWN, "sign": "positive"}])]


def certificates():
    good = {}
    for name, top in right():
        good[name] = top
        yield name, json.dumps(top), True
    yield "a hundred", json.dumps(changed(good["sum"], ["tree", "shown", 0, "with"], [{"times": "0", "membership": "1"}] * 99 + [
        {"times": "-1", "membership": "1"}])), True
    for n in (10, 11):
        many = together(HALF, True, 2, 0, *[(0, 1)] * 99, (-1, 1))
        top = changed(good["sum"], ["tree", "shown"], [many] * 10 + [together(HALF, True, 2, 0, (-1, 1))] * (n - 10))
        yield f"many memberships, {n}", json.dumps(top), n == 10
    yield "twice the bound", json.dumps(changed(good["between"], ["assumptions", 0, "p"], "4*A + 4*B + 2")), True
    for name, path, value in WRONG:
        yield f"{name}: {'.'.join(map(str, path))} = {str(value)[:40]}", json.dumps(changed(good[name], path, value)), False
