"""What kovacic_verify.py prints and returns: a function of its modules (sys.modules) that is True."""
import contextlib
import io
import json
import os
import tempfile

import traps


def printed(v, args):
    """The exit code and the lines on both streams"""
    out, err = io.TextIOWrapper(io.BytesIO(), encoding="ascii"), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = v.main(args)
    out.flush()
    return code, out.buffer.getvalue().decode().splitlines(), err.getvalue().splitlines()


def from_standard_input(v, path):
    with open(path, "rb") as f:
        kept = os.dup(0)
        try:
            os.dup2(f.fileno(), 0)
            said = v.judge("-", False)
            os.fstat(0)                     # is left open
            return said
        finally:
            os.dup2(kept, 0)
            os.close(kept)


def command_line(modules):
    v, airy = modules["kovacic_verify"], json.loads(traps.read("data", "airy-naive.json"))
    group = ["y'' = z y", "the differential Galois group is SL2, its identity component is SL2, not abelian"]
    trusted = traps.changed(airy, ["steps", "+"], {"id": "t", "rule": "apply-theorem", "premises": [airy["steps"][-1]["id"]],
                                                   "data": {"theorem": "a\nbook", "statement": "so it is"}})
    with tempfile.TemporaryDirectory() as folder:
        def path(name):
            return os.path.join(folder, name)
        for name, text in (("airy", json.dumps(airy).encode()), ("trusted", json.dumps(trusted).encode()), ("bytes", b"\xff"), ("text", b"[\x1b"),
                           ("false", json.dumps(traps.changed(airy, ["claim", "abelian"], True)).encode())):
            with open(path(name), "wb") as f:
                f.write(text)
        once = group + ['trusted, "a?book": "so it is"']
        code, missing, nothing = v.judge(path("not there"), False)
        lines = [f"{path('airy')}: accepted (0 trusted steps)", *("  " + x for x in group),
                 f"{path('false')}: rejected: the claim does not follow: abelian"]
        return ((v.judge(path("airy"), False), v.judge(path("airy"), True)) == ((0, "accepted (0 trusted steps)", group),) * 2
                and v.judge(path("trusted"), False) == (0, "accepted (1 trusted step)", once)
                and v.judge(path("trusted"), True) == (1, "rejected: 1 trusted steps, refused by --strict", [])
                and v.judge(path("false"), False) == (1, "rejected: the claim does not follow: abelian", [])
                and (code, nothing) == (2, []) and missing.startswith("malformed: ") and "\n" not in missing
                and all(v.judge(path(x), False)[0] == 2 and v.judge(path(x), False)[1].isprintable() for x in ("bytes", "text"))
                and from_standard_input(v, path("airy")) == (0, "accepted (0 trusted steps)", group)
                and printed(v, [path("airy")]) == (0, ["accepted (0 trusted steps)", *("  " + x for x in group)], [])
                and printed(v, [path("airy"), path("false")]) == (1, lines, [])
                and printed(v, [path("false"), path("text"), path("airy")])[0] == 2
                and printed(v, [path("airy"), path("\u00e9")])[0] == 2
                and printed(v, ["--strict", path("trusted")]) == (1, ["rejected: 1 trusted steps, refused by --strict"], [])
                and printed(v, []) == (2, [], [*str(v.__doc__).splitlines(), ""]) and printed(v, ["--strict"])[0] == 2
                and v.shown("a\nb\x7f") == "a?b?" and v.shown("x" * 1001) == "x" * 1000
                and v.check(json.dumps(trusted)) == (1, "", once))


def strict(modules):
    """Hypotheses may be unchecked unless it is said"""
    v, theorem, text = modules["kovacic_verify"], modules["theorem"], '{"format": "kovacic-theorem/1"}'
    verify, theorem.verify = theorem.verify, lambda top, prove, strict: strict
    try:
        return v.check(text) is False and v.check(text, False) is False and v.check(text, True) is True
    finally:
        theorem.verify = verify


def properties():
    """(name, function, True)"""
    return [("command_line", command_line, True), ("command_line.strict", strict, True)]
