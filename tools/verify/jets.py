"""Checks certificates of higher variational equations, kovacic-jets/1 (docs/theory/jet_certificates.md; J1 to J7 are its rules).

Nothing is searched for: motion.py puts the series into the equations of motion again and compares the residues at the first
resonance that fails; normal_group.py has the reasons why the group of the normal equation is infinite."""
import checked
from certificate_format import refusing
from jets_format import FORMAT, read_jets
from jets_statement import statement
from motion import Jets
from normal_group import NormalGroup

__all__ = ["FORMAT", "accept", "verify"]


@checked.file
def accept(top, prove):
    """What was read, checked: the series and why the group is infinite.  prove checks ordinary certificates."""
    d = read_jets(top)
    with refusing():
        jets = Jets(d)
        group = NormalGroup(jets, d["group"], prove)
    checked.label(FORMAT, "J1 J2 J3 J4 J5 J6")
    checked.add(FORMAT, "by", d["group"]["by"])
    return d, jets, group


def verify(top, prove):
    """The number of trusted steps, a summary and the statement"""
    d, jets, group = accept(top, prove)
    checked.conclude(["Morales-Ramis-Simo"], "first integrals that are meromorphic near the phase curve, at the energies and for "
                     "the parameters of the statement")
    return group.trust, "not integrable; ", list(statement(d, jets, group))
