"""Properties of condition.py of the Python checker: functions of its modules (sys.modules) that are True.  A NODE for
conditions on a and b, each right one beside a wrong one."""


def proved(m, given, node, show=None):
    M, S = m["multivariate"], m["condition"].ConditionSet
    M.Work.left, S.nodes = 10**6, 1000
    names = {"a": 0, "b": M.FIELD}
    s = S(names).also(*((M.parse(f, names), sign) for f, sign in given))
    try:
        if show:
            s.show(s.poly(show[0]), show[1], node)
        else:
            s.absent(node)
        return True
    except (m["certificate_format"].Rejected, m["certificate_format"].Malformed):
        return False


def empty(*terms, zeros=()):
    return {"node": "empty", "terms": list(terms), "zeros": list(zeros)}


def term(c, i, e=1, q="1"):
    return [str(c), q, [str(i), str(e)]]


def terms(m):
    def accepts(node, *given):
        return proved(m, given, node)
    a, less, no_more, more = ("a", "positive"), ("-a", "nonnegative"), ("-a", "positive"), ("a", "nonnegative")
    both = empty(term(1, 0), term(1, 1))
    return (accepts(both, a, less) and accepts(both, a, no_more) and accepts(both, more, no_more) and not accepts(both, more, less)
            and not accepts(both, ("a", "nonzero"), less) and not accepts(both, ("a", "zero"), less)
            and not accepts(both, a, ("-2*a", "nonnegative"))
            and accepts(empty(term("2/3", 0), term("1/3", 1)), a, ("-2*a", "nonnegative"))
            and accepts(empty(term("1/2", 0), term("1/3", 1), term("1/6", 1)), a, less)
            and accepts(empty(term(5, 0), term(5, 1)), a, less) and not accepts(empty(term(-1, 0), term(-1, 1)), a, less)
            and not accepts(empty(term(0, 0), term(0, 1)), a, less) and not accepts(empty(term(0, 0)), a)
            and not accepts(empty(term(1, 0, 1, "0")), a) and not accepts(empty(), a) and not accepts(empty(["1", "0"]), a)
            and not accepts(empty(["1", "b", ["0", "1"]], ["1", "b", ["1", "1"]]), a, less)        # b may be 0
            and accepts(empty(["1", "3", ["0", "1"]], ["9", "1", ["1", "1"]]), a, less)
            and accepts(empty(term(1, 0, 2), term(1, 1)), ("a", "nonzero"), ("-a^2", "nonnegative"))
            and accepts(empty(term(1, 0, 100), term(1, 1)), ("a", "nonzero"), ("-a^100", "nonnegative"))
            and not accepts(empty(term(1, 0, 102), term(1, 1)), ("a", "nonzero"), ("-a^102", "nonnegative"))
            and not accepts(empty(term(1, 0, 3), term(1, 1)), ("a", "nonzero"), ("-a^3", "nonnegative"))
            and accepts(empty(term(1, 0, 3), term(1, 1)), a, ("-a^3", "nonnegative"))
            and not accepts(empty(term(1, 0, 0)), a) and not accepts(empty(term(1, 2)), a, less)
            and not accepts(empty(term(1, -1)), a, less)
            and not accepts(empty(["1"]), a) and not accepts(empty(["1", "1", ["0"]]), a) and not accepts(empty("1", "1"), a)
            and accepts(empty(["1", "1"], zeros=[["0", "-1"]]), ("1", "zero"))
            and not accepts(empty(["1/2", "1"], zeros=[["0", "-1"]]), ("2", "zero"), a)
            and not accepts(empty(["1", "1"], zeros=[["0", "-1"]]), ("1", "nonnegative"))
            and accepts(empty(["1/2", "1"], ["1/2", "1"], zeros=[["1", "-1"]]), a, ("1", "zero"))
            and accepts(empty(["3", "b"], ["1", "1", ["1", "1"]], zeros=[["0", "-3*b^2 - a"]]), ("1", "zero"), a)
            and not accepts(empty(["3", "b"], zeros=[["0", "-3*b^2"]]), ("1", "zero")) and not accepts(empty(term(1, 0), zeros=[["0"]]), a)
            and not accepts(empty(term(1, 0), zeros=["0"]), ("0", "positive")) and accepts(empty(term(1, 0)), ("0", "positive")))


def cases(m):
    def node(**branches):
        return {"node": "sign" if "positive" in branches else "zero", "p": "a"} | branches
    both = empty(term(1, 0), term(1, 1))
    given = [("-a", "nonnegative")]
    no = ("-a^2", "positive")
    yes = empty(term(1, 0), ["1", "a"])
    return (proved(m, [no], yes) and proved(m, [no], node(positive=yes, zero=yes, negative=yes))
            and proved(m, given + [("a - 1", "nonnegative")], node(
                positive=empty(term(1, 0), term(1, 2)), zero=empty(["1", "1"], term(1, 1), zeros=[["2", "-1"]]),
                negative=empty(term(1, 1), term(1, 2), ["1", "1"])))
            and not proved(m, given, node(positive=both, zero=both, negative=both))
            and not proved(m, given, empty(term(1, 0), term(1, 1)))
            and not proved(m, [("a^2", "zero")], node(nonzero=empty(term(1, 1, 2), zeros=[["0", "-1"]]), zero=empty(["1", "1"])))
            and proved(m, [("a^2", "zero"), ("b - a", "positive"), ("-b", "nonnegative")], node(
                nonzero=empty(term(1, 3, 2), zeros=[["0", "-1"]]), zero=empty(term(1, 1), term(1, 2), zeros=[["3", "1"]])))
            and not proved(m, [no], {"node": "zero", "p": "a", "nonzero": yes}) and not proved(m, [no], {"node": "other"})
            and not proved(m, [no], None) and not proved(m, [no], yes | {"more": "1"}))


def shown(m):
    """(f, sign) is shown by refuting its negation, the last condition"""
    def accepts(f, sign, node, *given):
        return proved(m, given, node, (f, sign))
    a = ("a", "positive")
    sums = empty(term(1, 0), term(1, 1))
    return (accepts("a", "positive", sums, a) and accepts("a", "nonnegative", sums, a) and not accepts("-a", "positive", sums, a)
            and accepts("a", "nonnegative", sums, ("a", "nonnegative")) and not accepts("a", "positive", sums, ("a", "nonnegative"))
            and not accepts("-a", "nonnegative", sums, a) and not accepts("2*a", "positive", sums, a)
            and accepts("a", "nonzero", empty(term(1, 0), zeros=[["1", "-1"]]), a)
            and not accepts("a", "nonzero", empty(term(1, 0), zeros=[["1", "-1"]]), ("a", "nonnegative"))
            and accepts("a", "zero", empty(term(1, 1, 2), zeros=[["0", "-a"]]), ("a", "zero"))
            and not accepts("b", "zero", empty(term(1, 1, 2), zeros=[["0", "-a"]]), ("a", "zero")))


def limits(m):
    """The numbers of nodes, their depth, and an exponent"""
    S, M = m["condition"].ConditionSet, m["multivariate"]
    names = {"a": 0, "b": M.FIELD}
    M.Work.left = 10**6
    given = S(names).also((M.parse("-a^2", names), "positive"))
    yes = empty(term(1, 0), ["1", "a"])
    tree = {"node": "zero", "p": "a", "nonzero": yes, "zero": {"node": "zero", "p": "b", "nonzero": yes, "zero": yes}}

    def accepts(left, depth):
        S.nodes = left
        return not rejected(m, lambda: given.absent(tree, None, depth))
    return (accepts(5, 3) and not accepts(4, 3) and not accepts(5, 2) and accepts(5, 64)
            and proved(m, [("a", "positive"), ("-a^99", "nonnegative")], empty(term(1, 0, 99), term(1, 1)))
            and not proved(m, [("a", "positive"), ("-a^101", "nonnegative")], empty(term(1, 0, 101), term(1, 1))))


def rejected(m, f):
    try:
        f()
    except (m["certificate_format"].Rejected, m["certificate_format"].Malformed):
        return True
    return False


def malformed(m):
    """Terms, zeros, nodes and signs of another shape"""
    R, M, F = m["condition"], m["multivariate"], m["certificate_format"]
    names, a = {"a": 0}, ("a", "positive")
    M.Work.left = 10**6
    pairs, zero = ["1", "1", ["0", "1"]], ("1", "zero")
    leaves, s = [], R.ConditionSet(names)
    return (proved(m, [a, ("-a", "nonnegative")], empty(pairs, ["1", "1", ["1", "1"]])) and not proved(m, [a, ("-a", "nonnegative")], empty(
                ["1", "1", "01"], ["1", "1", ["1", "1"]]))
            and proved(m, [("-1", "positive")], empty(["1", "1"], ["1", "1", ["0", "1"]])) and not proved(m, [("-1", "positive")], empty(
                "11", ["1", "1", ["0", "1"]])) and not proved(m, [("-1", "positive")], empty({"0": "1", "1": "1"}, ["1", "1", ["0", "1"]]))
            and not any(proved(m, [zero], empty(["1", "1"], zeros=[v])) for v in (["0", "-1", "0"], ["0"], "0", {"0": "0", "1": "-1"}, {},
                None))
            and rejected(m, lambda: F.read(F.COND, {"p": "a", "sign": "negative"}, ""))
            and [sign for _, sign in R.conditions([F.read(F.COND, {"p": "a", "sign": x}, "") for x in F.COND["sign"]], lambda p: M.parse(p, names))] == list(F.COND["sign"])
            and all(rejected(m, lambda v=v: s.absent({"node": v}, lambda v, given: leaves.append(v))) for v in (None, True, [], {}, 1))
            and rejected(m, lambda: s.absent("empty", lambda v, given: leaves.append(v))) and not leaves
            and not rejected(m, lambda: s.absent({"node": "part"}, lambda v, given: leaves.append(v))) and len(leaves) == 1)


def properties():
    """(name, function, True)"""
    return [(f"signs.{f.__name__}", f, True) for f in (terms, cases, shown, limits, malformed)]
