"""Formulas in running text, typeset: docs/ writes them as one types them, e.g. Delta^2, T_n, e^((p+1)/2), y'' = r y.

Raised and lowered characters, Greek letters, primes and relations; names of one letter in italics.  This is plain HTML:
no script, no font, no network.  Code stays as it is.
"""

import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

GREEK = {name: chr(code) for code, name in enumerate(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigmaf sigma tau upsilon "
    "phi chi psi omega".split(), 0x3B1)}
GREEK.update({name.capitalize(): chr(ord(letter) - 32) for name, letter in GREEK.items()
              if name in "gamma delta theta lambda xi pi sigma phi psi omega".split()})
GREEK["eps"] = GREEK["epsilon"]
SIGNS = {"<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "+-": "±", "=>": "⇒", "<=>": "⇔"}

GROUP = r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)|\{[^{}]*\}"
PIECE = re.compile(
    r"(?P<page>\b\w+\.md\b|\b\w+\.\w+pp\b|\w+_\w+\.\w+)"
    rf"|(?P<up>(?<=[\w)\]}}²′″°⁰])\^(?:{GROUP}|[-+−]?\w+(?:/\d+)?|[+*⊥−-]))"
    rf"|(?P<down>(?<=[A-Za-z)α-ωΑ-Ω])_(?:\{{[^{{}}]*\}}|\([^()]*\)|[A-Za-z0-9]{{1,3}}(?![\w])))"
    r"|(?P<primes>(?<=[\w)])'{1,3}(?![\w']))"
    rf"|(?P<greek>(?<![\w'-])(?:{'|'.join(sorted(GREEK, key=len, reverse=True))})(?=[_^0-9']|(?![\w-])))"
    r"|(?P<sign>(?<=\s)(?:<=>|<=|>=|!=|->|=>)(?=\s)|\+-(?=\w))"
    r"|(?P<numbered>(?<![\w'’.\-/])[b-hj-z][0-9](?![\w.]))"
    r"|(?P<letter>(?<![\w'’.\-/])[b-hj-zB-HJ-Z](?=[_^]|(?![\w'’.\-]))|(?<![\w'’.\-/])[a-zA-Z](?='{1,3}(?![\w']))"
    r"|(?<![\w'’.\-/])[b-hj-zB-HJ-Z](?=[.](?:\s|$)))")
UPRIGHT = set("CQZNRK")  # the fields, which formulas name far more often than constants


def typeset(text, page_of=lambda name: None):
    """A list of nodes for a piece of running text; `page_of` gives the address of a page that is named in it."""
    made, at = [], 0
    for found in PIECE.finditer(text):
        if found.start() > at:
            made.append(nodes.Text(text[at:found.start()]))
        address = page_of(found.group()) if found.lastgroup == "page" else None
        made.append(nodes.reference("", found.group().removesuffix(".md"), refuri=address, internal=True) if address
                    else node_of(found))
        at = found.end()
    return made + ([nodes.Text(text[at:])] if at < len(text) else []) if made else []


def node_of(found):
    kind, word = found.lastgroup, found.group()
    if kind == "page":
        return nodes.Text(word)
    if kind == "numbered":
        return nodes.inline("", "", nodes.emphasis("", word[0], classes=["variable"]), nodes.subscript("", word[1]))
    if kind in ("up", "down"):
        inside = word[1:]
        if inside[0] in "({" and inside[-1] in ")}":
            inside = inside[1:-1]
        made = nodes.superscript() if kind == "up" else nodes.subscript()
        inside = {"inf": "∞"}.get(inside, inside)
        made.extend(typeset(inside) or [nodes.Text(inside)])
        return made
    if kind == "primes":
        return nodes.Text("′″‴"[len(word) - 1])
    if kind == "greek":
        return nodes.Text(GREEK[word])
    if kind == "sign":
        return nodes.Text(SIGNS[word])
    return nodes.Text(word) if word in UPRIGHT else nodes.emphasis("", word, classes=["variable"])


class Formulas(SphinxTransform):
    default_priority = 820

    def apply(self, **_):
        if not self.env.docname.startswith(("theory/", "guide/", "gallery", "glossary", "accuracy", "index", "tasks")):
            return
        for text in list(self.document.findall(nodes.Text)):
            if not any(isinstance(parent, (nodes.literal, nodes.FixedTextElement, nodes.raw, nodes.comment, nodes.image))
                       for parent in ancestors(text)):
                inside_link = any(isinstance(parent, nodes.reference) for parent in ancestors(text))
                made = typeset(text.astext(), (lambda name: None) if inside_link else self.page_of)
                if made:
                    text.parent.replace(text, made)


    def page_of(self, name):
        """The address of theory/name.html from a page of theory."""
        here = self.env.docname
        theory = here.startswith("theory/") and f"theory/{name[:-3]}" in self.env.found_docs and name.endswith(".md")
        return self.app.builder.get_relative_uri(here, f"theory/{name[:-3]}") if theory else None


def ancestors(node):
    while node.parent is not None:
        node = node.parent
        yield node


def setup(app):
    app.add_transform(Formulas)
    return {"parallel_read_safe": True}
