"""Schemas of kovacic-strata/1 (docs/theory/strata_certificates.md 2, 4 to 7): syntax and types; nothing is judged."""
import re

from certificate_format import read, right

FORMAT = "kovacic-strata/1"
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,999}\Z")
FRACTION = {"num": "text", "den": "text"}
TOP = {"format": "text", "variable": "text", "parameters": ["text"], "real": ["text"], "rational?": ["text"],
       "assumptions": [{"p": "text", "sign": "text"}], "generic": [["text"]], "r": FRACTION,
       "memberships?": [FRACTION | {"integral": "truth"}],
       "claim": {"abelian": "any"}, "tree": "any"}
VIOLATED = {"membership?": "int", "value?": "rational"}
LEMMA = VIOLATED | {"p": "text", "times?": "text", "sign": "text", "terms?": ["any"], "prime?": "int"}
REGULAR = {"chi?": ["text"], "irrational?": "text", "log?": "true", "bound?": "rational"}
PLACED = {"content": "text", "places": [REGULAR | {"q": "text", "order": "int"}], "infinity": REGULAR,
          "absent?": [{"m": "int", "minors": [{"rows": ["int"], "times": "text"}], "prime?": "int"}],
          "growth?": {"factor": "rational", "shift": "rational"}}
FACTOR = {"q": "text", "order": "int", "e": "int"}
LEAVES = {"number": {"certificate": "any"},
          "invariant": {"content": "text", "places": [FACTOR], "m": "int", "p": "text"}}
LEAVES |= dict.fromkeys(("torus-log", "torus", "irreducible-log", "rational", "one-open", "open", "separated"), PLACED)
NUMBER = {"square": FRACTION, "root?": FRACTION}
MULTIPLE = {"times": "int", "membership": "int"}
CLASSICAL = {"change": FRACTION, "equation": FRACTION, "factors?": ["text"], "numbers": [NUMBER],
             "shown?": [{"value": FRACTION, "integral": "truth", "with?": [MULTIPLE]} | MULTIPLE]}
CRITERIA = ("whittaker", "bessel", "riemann", "lame")
LEAVES |= dict.fromkeys(CRITERIA, CLASSICAL)
ENDS = {"empty": VIOLATED | {"terms?": ["any"]}, "outside": {"generic?": "int"}, "open": {"reason": "text"},
        "trusted": {"abelian": "text", "theorem": "text", "statement": "text"}}
NODES = ENDS | {"split": {"p": "text", "nonzero": "any", "zero": "any"},
                "assumed": {"condition": "int", "p": "text", "zero": "any"},
                "lemmas": {"lemmas": [LEMMA], "then": "any"}, "leaf": {"abelian": "text", "by": LEAVES}}
ZEROS = ENDS | {"solve": {"variable": "text", "r?": FRACTION, "then": "any"},
                "root": {"variable": "text", "certificate": "any", "abelian": "text"}}


def choose(table, key, v):
    """The name of the variant, and its data."""
    name = v.get(key) if isinstance(v, dict) else None
    right(isinstance(name, str) and name in table, f"{key!r} is unknown: {str(name)[:60]!r}")
    return name, read(table[name] | {key: "text"}, v, name)
