"""A Hamiltonian with its manifolds as the text of a system file (docs/guide/system-files.md)."""

import json
import re

from . import _convert
from ._errors import InvalidArgument, WrongType

DOMAINS = ["real", "rational", "integer"]  # each in the one before
SIGNS = {"positive": ">", "negative": "<", "nonnegative": ">=", "nonzero": "!="}
KEYS = {"name", "equations", "level", "change", "variable", "nonzero"}


def quoted(text):
    return json.dumps(str(text), ensure_ascii=False).replace("\x7f", "\\u007F")


def listed(texts):
    return "[" + ", ".join(quoted(t) for t in texts) + "]"


def formulas(x, what):
    """One or several equations: text, or SymPy (an expression means expression = 0)."""
    several = x if isinstance(x, (list, tuple)) else [x]
    found = []
    for one in several:
        text = _convert.formula(one, what)
        found.append(text if "=" in text else text + " = 0")
    return found


def hamiltonian(H, coordinates, momenta, parameters, manifolds, assume, title, set):
    q, p = _convert.names(coordinates, "coordinates"), _convert.names(momenta, "momenta")
    names, sentences = _convert.names(parameters, "parameters"), _convert.texts(assume, "assume")
    if _convert.is_sympy(H):
        free = {n: s for n, s in _convert.symbols_of(H).items() if n not in q and n not in p}
        names += [n for n in sorted(free) if n not in names]
        sentences = _convert.assumptions_of(free) + sentences
    lines = ['format = "equation/1"', f"title = {quoted(title or 'a Hamiltonian system')}", "", "[system]",
             'kind = "hamiltonian"', f"coordinates = {listed(q)}", f"momenta = {listed(p)}",
             f"parameters = {listed(names)}", f"hamiltonian = {quoted(_convert.formula(H, 'H'))}"]
    values = _convert.values(set)
    if values:
        lines += ["", "[set]"] + [f"{name} = {quoted(value)}" for name, value in values]
    if sentences:
        lines += ["", "[assume]"] + assumed(sentences)
    for m in [manifolds] if isinstance(manifolds, dict) else manifolds:
        lines += manifold(m)
    return "\n".join(lines) + "\n"


def assumed(sentences):
    """"a integer" is a key of its own, everything else one of the conditions."""
    words, conditions = {}, []
    for sentence in sentences:
        one = re.fullmatch(r"\s*(\w+)\s+(?:is\s+)?(\w+)\s*", sentence)
        if one and one[2] in DOMAINS:
            words[one[1]] = max(words.get(one[1], "real"), one[2], key=DOMAINS.index)
        elif one and one[2] in SIGNS:
            conditions.append(f"{one[1]} {SIGNS[one[2]]} 0")
        else:
            conditions.append(sentence)
    return [f"{n} = {quoted(word)}" for n, word in words.items()] + [f"conditions = {listed(conditions)}"] * bool(conditions)


def manifold(m):
    if not isinstance(m, dict):
        raise WrongType(f"manifolds: dicts are expected, and not {m!r}")
    if extra := [key for key in m if key not in KEYS]:
        raise InvalidArgument(f"a manifold has no {extra[0]!r}; it has {', '.join(sorted(KEYS))}")
    name = m.get("name", "M")
    lines = ["", "[[manifold]]", f"name = {quoted(name)}", f"equations = {listed(formulas(m.get('equations', []), 'equations'))}"]
    if "level" in m:
        lines.append(f"level = {listed(formulas(m['level'], 'level'))}")
    if "nonzero" in m:
        lines.append(f"nonzero = {listed(_convert.formula(x, 'nonzero') for x in m['nonzero'])}")
    if "change" in m or "variable" in m:
        lines += ["", "[[reduce]]", f"manifold = {quoted(name)}"]
        if "variable" in m:
            lines.append(f"variable = {quoted(_convert.name(m['variable']))}")
        if "change" in m:
            change = _convert.formula(m["change"], "change")
            lines.append(f"change = {quoted(change if '=' in change else 'z = ' + change)}")
    return lines
