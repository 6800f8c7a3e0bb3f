#!/usr/bin/env python3
"""One system has one verdict, one class of first integrals and one number of steps on trust in every output.

usage: formats_test.py KOVACIC [all | FILE...]

Without files: those of cases/classify that are classified in a moment, formulas of the command line, and a
galaxy of which one step has a certificate that is itself on trust in part.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "cases/classify"
QUICK = ["anisotropic_kepler", "equatorial_top", "euler", "ramani", "shimizu_morioka", "stark", "stoermer", "toda",
         "yang_mills"]
FORMULAS = ["(p1^2+p2^2)/2 + q1^2*q2 + b*q2^3/3",
            # three classes of first integrals that are one
            "(p1^2+p2^2)/2 + (q1^2+q2^2)/2 + q1^2*q2 + b*q2^3/3",
            # a case that `prove` of the theorem file does not find again, with the rule of Darboux points
            "(p1^2+p2^2)/2 + q1^2*q2/2 + a*q1^3/3 + q2^3/3",
            # for c = 0 only exponent differences exclude, on trust: the theorem leaves it open, the answer does not
            "(p1^2+p2^2)/2 + q1^2*(1 + b*p2^2/q2^2)/2",
            "(p1^2+p2^2)/2 + q1^2*(1 + b*p2^2/q2^2)/2 + c*(q1^4 + q1^2*q2^2)"]
GALAXY = """format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["R", "z"]
momenta = ["pR", "pz"]
parameters = ["a", "b", "L"]
hamiltonian = "(pR^2+pz^2)/2 + L^2/(2*R^2) - 1/sqrt(R^2 + (a + sqrt(z^2+b^2))^2)"
[assume]
a = "positive"
b = "positive"
L = "positive"
"""
HEADLINES = {"integrable": "INTEGRABLE", "non-integrable": "NON-INTEGRABLE", "open": "OPEN",
             "depends": "DEPENDS ON THE PARAMETERS"}


def run(*command, **more):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, cwd=ROOT, **more)
    return done.returncode, done.stdout, done.stderr


def count(pattern, text):
    found = re.search(pattern, text)
    return int(found.group(1)) if found else 0


def status_of_the_root(page):
    """What the first step is, if it is proved, and how many steps on trust it has"""
    found = re.search(r'[\[{>"](proved|in part)(?:, with (\d+) steps? on trust)?[\]}<",]', page)
    return found and (found.group(1), int(found.group(2) or 0))


def plain_class(text):
    """A certificate has names for roots that the answer writes out"""
    return re.sub(r"\(in the coordinates and .*\)", "(in the coordinates and functions)", text)


def differences(kovacic, question, directory):
    """What differs between the answers to one question, as sentences."""
    certificate, theorem = directory / "certificate.json", directory / "theorem.toml"
    exit_code, out, err = run(kovacic, "classify", *question, "--format", "json", "--certificate", certificate,
                              "--as-theorem", theorem)
    if not out:
        return [f"no answer: {err}"]
    answer = json.loads(out)
    wanted = (exit_code, answer["status"], answer["integrals_class"], len(answer["trusted"]))
    wrong = []

    def compare(what, *found):
        if found != wanted[:1] + wanted[4 - len(found) + 1:]:
            wrong.append(f"{what}: {found}, JSON with a certificate: {wanted}")

    code, out, _ = run(kovacic, "classify", *question, "--format", "json")
    plain = json.loads(out)
    compare("JSON", code, plain["status"], plain["integrals_class"], len(plain["trusted"]))
    code, out, _ = run(kovacic, "classify", *question)
    if f"\n  {HEADLINES[answer['status']]}\n" not in out:
        wrong.append("the headline of the text")
    compare("text", code, count(r"\n  trusted +(\d+) step", out))
    for kind, pattern in (("html", r", (\d+) other steps? on trust,"), ("tex", r"(\d+) other steps? on trust")):
        code, out, _ = run(kovacic, "classify", *question, "--format", kind)
        compare(kind, code, count(pattern, out))
        if not out.lstrip().startswith(("<!DOCTYPE", "\\documentclass")):
            wrong.append(f"{kind}: another format")
        status = status_of_the_root(out)
        if certificate.exists() and status and status[1] != wanted[3]:
            wrong.append(f"{kind}: the first step is {status}")
    open_regions = answer["certificate"].get("open_regions", 0)
    if theorem.exists():
        code, out, _ = run(kovacic, "prove", theorem, "--format", "json")
        proof = json.loads(out)
        # Steps that only the file names are told as such: they prove nothing, and nothing contradicts them.
        words = count(r"^PROVED, except (\d+) steps? that the file takes on trust", proof["verdict"])
        on_trust = len(proof["trusted_steps"])
        if not open_regions and certificate.exists():
            if code != (3 if words else exit_code) or on_trust != wanted[3]:
                wrong.append(f"prove: {code}, {on_trust} on trust, wanted {wanted}")
            if not proof["verdict"].startswith("PROVED"):
                wrong.append(f"prove: {proof['verdict']}")
        if code == 0 and words + sum(n["kind"] == "trusted" and n["steps_on_trust"] > 0 for n in proof["nodes"]):
            wrong.append("prove: words of a file have proved the theorem")
        for node in proof["nodes"]:
            if node["status"].startswith("proved") and node["rests_on_open"]:
                wrong.append(f"{node['id']} is proved and rests on something open")
        pages = {kind: run(kovacic, "prove", theorem, "--format", kind)[1] for kind in ("text", "html", "tex")}
        for kind, page in {"JSON": f'"{proof["nodes"][0]["status"]}"', **pages}.items():
            status = status_of_the_root(page)
            if status and status[1] != on_trust:
                wrong.append(f"prove, {kind}: the first step is {status}, and {on_trust} steps are on trust")
    if not certificate.exists():
        return wrong
    for judge in ([kovacic, "verify"], [sys.executable, "-B", ROOT / "tools/verify/kovacic_verify.py"]):
        code, out, _ = run(*judge, certificate)
        trusted = count(r"(\d+) trusted step", out)
        if code != 0 or trusted != answer["certificate"]["trusted_steps"]:
            wrong.append(f"{judge[-1]}: exit {code}, {trusted} trusted steps")
        said = re.search(r"\n  is not integrable with first integrals that are (.*), where the denominators", out)
        if answer["integrals_class"] and said and plain_class(answer["integrals_class"]) != plain_class(said.group(1)):
            wrong.append(f"{judge[-1]}: {said.group(1)}, wanted {answer['integrals_class']}")
    if answer["certificate"]["trusted_steps"] != wanted[3] and not open_regions:
        wrong.append(f"{answer['certificate']['trusted_steps']} trusted steps in the certificate, wanted {wanted[3]}")
    return wrong


def main():
    kovacic, files = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    names = sorted(f.stem for f in CASES.glob("*.toml")) if files == ["all"] else [] if files else QUICK
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        galaxy = pathlib.Path(folder) / "galaxy.toml"
        galaxy.write_text(GALAXY)
        questions = [[CASES / f"{name}.toml"] for name in names]
        questions += [[f] for f in files] if not names else [*(["-H", f] for f in FORMULAS), [galaxy]]
        for number, question in enumerate(questions):
            directory = pathlib.Path(folder) / str(number)
            directory.mkdir()
            for wrong in differences(kovacic, question, directory):
                failed = True
                print(f"{question[-1]}: {wrong}", flush=True)
    sys.exit(failed)


main()
