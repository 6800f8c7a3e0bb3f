"""The cover that puts the facts together (docs/theory/calculus.md 5; theorem_certificates.md 8)."""
from core import Cover, Said

FIELDS = {"system": "text", "symmetries": ["text"], "parts": ["text"], "tree": "any"}


def said(theorem, d):
    theorem.symmetries = [theorem.fact(name, "S") for name in d["symmetries"]]
    theorem.parts = [theorem.fact(name, "N", "I", "J", "O") for name in d["parts"]]
    cover = Cover(theorem.family(d), theorem.symmetries, theorem.parts, d["tree"])
    theorem.led = cover.led
    return Said("N", theorem.family(d), [()], cover.classes)
