"""Checks certificates of higher variational equations, kovacic-jets/1 (docs/theory/jet_certificates.md; J1 to J7 are its rules).

Nothing is searched for: motion.py puts the series into the equations of motion again and compares the residues at the first
resonance that fails; normal_group.py has the reasons why the group of the normal equation is infinite."""
from certificate_format import Rejected
from jets_format import FORMAT, read_jets
from jets_statement import statement
from motion import Jets
from normal_group import NormalGroup

__all__ = ["FORMAT", "verify"]


def verify(top, prove):
    """The number of trusted steps, a summary and the statement; prove checks ordinary certificates."""
    d = read_jets(top)
    try:
        jets = Jets(d)
        group = NormalGroup(jets, d["group"], prove)
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
        raise Rejected(f"{type(why).__name__}: {why}") from None
    return group.trust, "not integrable; ", list(statement(d, jets, group))
