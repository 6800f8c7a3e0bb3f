"""Properties of certificate_format.py of the Python checker: what each kind of value is, and what it is not."""


def refused(m, kind, *values):
    f = m["certificate_format"]
    for v in values:
        try:
            f.read(kind, v, "")
            return False
        except f.Malformed:
            pass
    return True


def kinds(m):
    read = m["certificate_format"].read
    return (refused(m, {"a?": "text"}, [], "", "a", None, ["a"], {"b": "1"}) and read({"a?": "text"}, {}, "") == {"a": None}
            and refused(m, ["text"], "", {}, "ab", None, {"a": "b"}) and read(["text"], [], "") == []
            and read("place", "infinity", "") == "infinity" and read("place", "7", "") == 7 and refused(m, "place", "zero", "", ["1"])
            and refused(m, "int", "infinity", "1/2", None, True) and refused(m, "residue", "infinity", "-1", str(2**62))
            and read("residue", "0", "") == 0 and read("residue", str(2**62 - 1), "") == 2**62 - 1
            and read({"by": {"a": {"n": "int"}, "b": {}}}, {"by": "a", "n": "5"}, "") == {"by": "a", "n": 5}
            and refused(m, {"by": {"a": {}}}, {"by": "c"}, {"by": ["a"]}, {"by": None}, {}))


def polynomials(m):
    f = m["certificate_format"]
    f.K.m, f.K.d, f.K.s = [0, 1], 1, 1
    return (refused(m, "poly", "", None, [[["1"]]], [[None]], [["1", "1"]], [[]], ["1", "0"], [True], ["1/0"])
            and f.read("poly", ["1/2", "-1/3"], "") == f.Poly([3, -2], 6) and f.read("poly", [], "") == f.Poly([]))


def properties():
    """(name, function, True)"""
    return [(f"kinds.{f.__name__}", f, True) for f in (kinds, polynomials)]
