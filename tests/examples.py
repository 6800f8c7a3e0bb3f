"""The examples of the headers as tests.  Usage: examples.py SOURCE_DIR ROOM OUTPUT.cpp

In the documentation of lib/ROOM/*.hpp the lines

    /// Given   const Ring ring = make_ring({"x", "y"});
    /// Example gcd(Integer(12), Integer(-18))  // -> 6
    /// Example inverse(NfElem(0))  // -> throws DomainError

become one test for each header: the text of each value (tests/support/shown.hpp) is compared with what stands
behind the arrow.  An example may go on in the lines below it; declarations may stand before its expression, each
with a semicolon.  What is Given holds for all examples below it in the header; z = Poly::z() always, but in namespace
kov::strata (and lib/parameters, lib/spectrum) z, a, one are elements of Q(z, a), and `everywhere` is the region of all a.
"""
import os
import re
import sys

# Headers without examples, and why.
excused = {
    "exact/flint.hpp": "includes only",
    "exact/flint_matrix.hpp": "includes only",
    "exact/memory.hpp": "memory for FLINT",
    "exact/quick_size.hpp": "of FLINT's structures",
    "symbol/pasted_passes.hpp": "a part of pasted.hpp",
    "integrability/block.hpp": "a stage of check.hpp",
    "integrability/curve_rows.hpp": "a part of way.hpp",
    "integrability/regular_leaf.hpp": "an example needs a system file",
    "integrability/way.hpp": "an example needs a system file",
    "integrability/way_names.hpp": "a part of way.hpp",
    "integrability/normal_identity.hpp": "a part of way.hpp",
    "galois/infinite_torsion.hpp": "a part of dihedral.cpp",
    "closed/arithmetic.hpp": "decides statements for parts.hpp",
    "closed/whittaker_pull_back.hpp": "a part of decide.cpp",
    "integrability/change_search.hpp": "a stage of check.hpp",
    "integrability/components.hpp": "a stage of check.hpp",
    "integrability/conclude.hpp": "a stage of check.hpp",
    "integrability/linearise.hpp": "a stage of check.hpp",
    "integrability/matrices.hpp": "a stage of check.hpp",
    "integrability/special_strata.hpp": "a stage of check.hpp",
    "integrability/report.hpp": "the results of check.hpp",
    "integrability/study.hpp": "what the stages of check.hpp are handed",
    "integrability/loops_certificate.hpp": "a stage of monodromy_opinion.hpp",
    "integrability/monodromy_opinion.hpp": "an example needs a system file",
    "integrability/variational_monodromy.hpp": "an example needs a system file",
    "kovacic/family_log.hpp": "two steps of the trace, used by the cases",
    "kovacic/polynomial_kernel.hpp": "a part of polynomial.cpp, compiled for two fields",
    "pullback/zeros.hpp": "a part of the searches of standard.hpp",
    "closed/recognize_families.hpp": "the parts of recognize.cpp",
    "strata/classical_certificate.hpp": "a part of leaf_certificate.cpp",
    "strata/needed.hpp": "a part of decide_leaf.cpp and of study/exclusion.cpp",
    "strata/open_exponent.hpp": "a part of decide_leaf.cpp",
    "symbol/tokens.hpp": "a part of expression.cpp",
    "symbol/given_text.hpp": "texts for child processes",
    "system/read_system.hpp": "the parts of read_system.cpp",
    "decide/words.hpp": "the sentences of decide.hpp",
    "decide/witness.hpp": "the searches of certificate.cpp",
}

own_namespace = {"answer", "elementary", "kovacic", "pullback", "spectrum"}  # the others are in namespace kov or kov::strata

names = """[[maybe_unused]] const Poly z = Poly::z();
"""
names_of_strata = """const Ring ring = make_ring({"z", "a"});
const MFraction z = MFraction::variable(ring, "z"), a = MFraction::variable(ring, "a"), one(ring, 1);
const ParametrisedSet everywhere(ring, {});
"""


class Example:
    def __init__(self, line, text, expected=None):
        self.line, self.text, self.expected = line, text, expected  # expected None: Given


def examples(lines):
    """The examples of a header, in its order."""
    found, open_one = [], None
    for number, line in enumerate(lines, 1):
        start = re.match(r"\s*/// (Given|Example)\s+(.*)", line)
        further = re.match(r"\s*///\s+(.*)", line)
        if start:
            if open_one:
                raise SystemExit(f"line {open_one.line}: an example without '// -> VALUE'")
            open_one, rest, given = Example(number, ""), start[2], start[1] == "Given"
        elif open_one and further:
            rest = further[1]
        elif open_one:
            raise SystemExit(f"line {open_one.line}: an example without end")
        else:
            continue
        code, arrow, value = re.fullmatch(r"(.*?)(?:(?:^|\s+)(// -> )(.*))?", rest).groups()
        open_one.text += code + "\n"
        if arrow:
            open_one.expected = value.strip()
        if arrow or (given and code.rstrip().endswith(";")):
            found.append(open_one)
            open_one = None
    return found


def function_body(code):
    """The declarations, then the value of the last expression."""
    declarations, semicolon, expression = code.strip().rpartition(";")
    return f"{declarations}{semicolon} return {expression.strip()};"


def speaks_of_parameters(room, text):
    return room in ("parameters", "spectrum") or re.search(r"^namespace kov::strata\b", text, re.M) is not None


def test(room, header, text, found):
    name = header.removesuffix(".hpp")
    path = f"{room}/{header}"
    yield f"TEST(Examples, {room}_{name}) {{\n"
    if found and path in excused:
        yield f'  FAIL() << "{path} has examples and need not be excused";\n'
    if not found and path not in excused:
        yield f'  FAIL() << "lib/{path} has no example";\n'
    if found and room in own_namespace:
        yield f"  using namespace {room};\n"
    if found and "namespace kov::strata" in text:
        yield "  using namespace strata;\n"
    for e in found:
        yield f'#line {e.line} "lib/{path}"\n'
        if e.expected is None:
            yield e.text
        else:
            yield f"  example(__FILE__, __LINE__, [&] {{ {function_body(e.text)} }},\n"
            yield f'          R"~({e.expected})~");\n'
    yield "}\n"


def main(source, room, output):
    folder = os.path.join(source, "lib", room)
    headers = sorted(name for name in os.listdir(folder) if name.endswith(".hpp"))
    out = [f"// The examples of lib/{room}, written by tests/examples.py.\n"]
    out += [f'#include "{room}/{h}"\n' for h in headers]
    out += ['#include "exact/poly.hpp"\n', '#include "support/shown.hpp"\n']
    out += ["namespace kov {\n", "using testing::example;\n"]
    texts = {}
    for header in headers:
        with open(os.path.join(folder, header), encoding="utf-8") as file:
            texts[header] = file.read()
    for with_parameters in (False, True):
        chosen = [h for h in headers if speaks_of_parameters(room, texts[h]) == with_parameters]
        if not chosen:
            continue
        out += [f"namespace examples_of_{room}{'_with_parameters' if with_parameters else ''} {{\n",
                names_of_strata if with_parameters else names]
        for header in chosen:
            try:
                found = examples(texts[header].split("\n"))
            except SystemExit as mistake:
                raise SystemExit(f"lib/{room}/{header}: {mistake}") from None
            out += test(room, header, texts[header], found)
        out += ["} // namespace\n"]
    gone = [p for p in excused if p.startswith(room + "/") and p.split("/")[1] not in headers]
    out += [f'TEST(Examples, {room}_excuses) {{ FAIL() << "there is no lib/{p}"; }}\n' for p in gone]
    out += ["} // namespace kov\n"]
    with open(output, "w", encoding="utf-8") as file:
        file.write("".join(out))


if __name__ == "__main__":
    main(*sys.argv[1:4])
