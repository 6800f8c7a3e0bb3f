#!/usr/bin/env python3
"""Bundles of `kovacic classify`: both checkers accept them and state the same, and refuse each forged one; the theorem file that
`classify` writes is proved and says what `classify` says.

usage: classification_python_test.py KOVACIC"""
import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
VERIFY = os.path.join(HERE, "../../tools/verify")
KOVACIC = os.path.abspath(sys.argv.pop(1))

CUBIC = """
[system]
kind        = "hamiltonian"
coordinates = ["q1", "q2"]
momenta     = ["p1", "p2"]
parameters  = ["a"]
hamiltonian = "(p1^2 + p2^2)/2 + a*q1^2*q2 + q2^3/3"
"""
SECOND = CUBIC.replace("a*q1^2*q2 + q2^3/3", "q1^2/2 + a*q1*q2 + q2^2/2")
TOP = """
[system]
kind        = "poisson"
coordinates = ["m1", "m2", "m3"]
parameters  = ["a", "b"]
bracket     = [["0", "-m3", "m2"], ["m3", "0", "-m1"], ["-m2", "m1", "0"]]
hamiltonian = "(m1^2 + a*m2^2 + b*m3^2)/2"
"""
FIELD = """
[system]
kind        = "vector-field"
coordinates = ["x", "y", "z"]
parameters  = ["a", "b", "c"]
[system.field]
x = "a*y*z"
y = "b*x*z"
z = "c*x*y"
"""
CONSTANT = """
[system]
kind        = "hamiltonian"
coordinates = ["q1", "q2"]
momenta     = ["p1", "p2"]
parameters  = ["a", "k"]
hamiltonian = "(p1^2 + p2^2)/2 + k*q1^2*q2 + a*q2^3/3"
[assume]
conditions = ["k^2 = -1"]
"""
BODY = """
[system]
kind        = "euler-poisson"
coordinates = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
parameters  = ["A", "B", "C", "L1", "L2", "L3"]
hamiltonian = "M1^2/(2*A) + M2^2/(2*B) + M3^2/(2*C) + Gamma1*L1 + Gamma2*L2 + Gamma3*L3"
[assume]
A  = "positive"
B  = "positive"
C  = "positive"
L1 = "real"
L2 = "real"
L3 = "real"
conditions = ["A > B", "B > C"]
[[casimir]]
name  = "F1"
value = "Gamma1^2 + Gamma2^2 + Gamma3^2"
[[casimir]]
name  = "F2"
value = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"
"""
QUARTIC = """
[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
parameters  = ["a", "b"]
hamiltonian = "(u^2 + v^2)/2 - (x^2 + y^2)/2 - a/4*(x^2 + y^2)^2 - b/2*x^2*y^2"
[assume]
a = "nonzero"
"""
# integrable for a root of a polynomial: (a = b^2, b a root) and only there
ROOTS = """
[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
parameters  = ["a"]
hamiltonian = "(u^2 + v^2)/2 + x^2*y/2 + a*x^3/3 + y^3"
"""
LATTICE = """
[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
hamiltonian = "(u^2 + v^2)/2 + exp(x) + exp(y - x)"
"""
# x <-> y, l <-> g: what is on trust at (l, g) = (8/3, 1/136) is so once
SWAP = """
[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
parameters  = ["l", "g"]
hamiltonian = "(u^2 + v^2)/2 + x^2*y^2/2 + l*x^4/4 + g*y^4/4"
[assume]
l = "real"
g = "real"
"""
FILES = {"swap": SWAP, "roots": ROOTS, "lattice": LATTICE, "cubic": CUBIC, "second": SECOND, "top": TOP, "field": FIELD, "constant": CONSTANT, "body": BODY, "quartic": QUARTIC, "open": CUBIC}


def kovacic(*arguments, cwd=None):
    p = subprocess.run([KOVACIC, *arguments], capture_output=True, text=True, cwd=cwd)
    return p.returncode, p.stdout, p.stderr


def checked(path):
    """The exit code and the lines below the first, of both checkers"""
    said = []
    for command in ([KOVACIC, "verify"], [sys.executable, os.path.join(VERIFY, "kovacic_verify.py")]):
        p = subprocess.run([*command, path], capture_output=True, text=True)
        said.append((p.returncode, p.stdout.splitlines()[1:], p.stdout + p.stderr))
    return said


class Classifications(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.bundles = {}
        for name, text in FILES.items():
            path = cls.path(f"{name}.toml")
            with open(path, "w") as f:
                f.write('format = "equation/1"\n' + text)
            code, out, _ = kovacic("classify", path, "--certificate", cls.path(f"{name}.json"), "--as-theorem",
                                   cls.path(f"{name}-theorem.toml"), "--timeout", "0", "--degree", "3" if name == "open" else "4")
            cls.bundles[name] = code, out

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    def bundle(self, name):
        with open(self.path(f"{name}.json")) as f:
            return json.load(f)

    def both(self, top):
        with open(self.path("forged.json"), "w") as f:
            json.dump(top, f)
        return checked(self.path("forged.json"))

    def forged(self, top, why=None):
        with open(self.path("forged.json"), "w") as f:
            json.dump(top, f)
        for code, _, said in checked(self.path("forged.json")):
            self.assertIn(code, (1, 2), said)
            if why:
                self.assertIn(why, said)

    def steps(self, top, rule):
        return [s for s in top["steps"] if s["rule"] == rule]

    def test_both_accept_and_state_the_same(self):
        for name in ("cubic", "second", "top", "field", "constant", "body", "quartic", "roots", "lattice", "swap"):
            (one, lines, said), (other, same, more) = checked(self.path(f"{name}.json"))
            self.assertEqual((one, other), (0, 0), name + said + more)
            self.assertEqual(lines, same, name)

    def test_a_class_that_contains_another_one_is_not_named(self):
        """On trust for all parameters: what both judges say of several classes is what they say of those that are left"""
        plain = {"kind": "meromorphic", "near": "curve", "on_leaf": "no", "liouville": "yes", "functions": [], "without": [],
                 "through": [], "frame": ""}
        classes = {"curve": {}, "ends": {"near": "closed curve"}, "origin": {"near": "origin"}, "leaf": {"on_leaf": "yes"},
                   "rational": {"kind": "rational", "near": "phase space"}, "s": {"functions": ["s"]},
                   "analytic": {"kind": "real-analytic", "near": "phase space"}, "fields": {"liouville": "no"},
                   "ends s": {"near": "closed curve", "functions": ["s"]}, "frame": {"frame": "X = q1 - 1"},
                   "rational s": {"kind": "rational", "near": "phase space", "functions": ["s"]},
                   "no q1": {"without": ["q1"]}, "q1 in s": {"without": ["q1"], "through": ["s"]}}
        systems = self.bundle("cubic")["systems"]

        def said(names):
            ids = [f"step-{k}" for k in range(len(names))]
            steps = [{"id": id, "rule": "trusted", "system": systems[0]["name"], "says": "not integrable", "step": "so it is",
                      "regions": [[]], "class": plain | classes[name]} for id, name in zip(ids, names)]
            tree = {"node": "part", "part": "0", "word": [], "shown": [], "region": "0"}
            cover = {"id": "main", "rule": "cover", "system": systems[0]["name"], "symmetries": [], "parts": ids, "tree": tree}
            top = {"format": "kovacic-theorem/1", "title": "classes", "systems": systems, "steps": [*steps, cover]}
            (one, lines, more), (other, same, _) = self.both(top)
            self.assertEqual((one, other, lines), (0, 0, same), more)
            return [line for line in lines if line.startswith("  is not integrable")]
        for names, left in (
                ("curve", "curve"), ("curve, ends, rational", "rational"), ("rational, ends, curve", "rational"),
                ("ends, curve, ends", "ends"), ("rational, origin", "rational"), ("rational, analytic", "rational, analytic"),
                ("origin, curve", "origin, curve"), ("curve, leaf", "leaf"), ("s, curve", "curve"), ("s, ends", "ends"),
                ("ends s, curve", "ends s, curve"), ("ends s, s", "ends s"), ("rational s, s", "rational s"),
                ("rational s, ends s", "rational s, ends s"), ("rational, ends s", "rational"), ("curve, no q1", "no q1"),
                ("no q1, q1 in s", "no q1"), ("curve, q1 in s", "curve, q1 in s"), ("rational, no q1", "rational, no q1"),
                ("curve, fields", "curve, fields"), ("rational, frame", "rational, frame")):
            self.assertEqual(said(names.split(", ")), said(left.split(", ")), names)

    def test_a_leaf_that_is_open_leaves_no_trust_for_the_others(self):
        """At B = 0 the curve is another one, and at the energy 0 a criterion is left; the top falls apart at one level only"""
        for name in ("yang_mills", "tilted_top"):
            path, source = self.path(f"{name}.json"), os.path.join(HERE, "../../cases/classify", f"{name}.toml")
            code, out, _ = kovacic("classify", source, "-q", "--certificate", path)
            self.assertIn("accepted, with 0 trusted steps", out)
            (one, lines, said), (other, same, more) = checked(path)
            self.assertEqual((code, one, other), (0, 0, 0), said + more)
            self.assertEqual(lines, same)
            with open(path) as f:
                top = json.load(f)
            self.assertTrue(self.steps(top, "leaf"))
            self.assertEqual(any("levels" in s for s in self.steps(top, "place")), name == "tilted_top")

    def test_the_class_is_that_of_the_classification(self):
        everywhere = "real-analytic on the whole real phase space"
        self.assertIn(everywhere, " ".join(self.bundles["body"][1].split()))
        for verdict, lines, _ in checked(self.path("body.json")):
            self.assertEqual(verdict, 0)
            said = [x for x in lines if "is not integrable with" in x]
            self.assertIn("first integrals that are " + everywhere + ",", said[0])
        systems = self.bundle("body")["systems"][:1]
        step = {"id": "all", "rule": "trusted", "system": systems[0]["name"], "says": "not integrable", "step": "so it is", "regions": [[]],
                "class": {"kind": "real-analytic", "near": "phase space", "on_leaf": "no", "liouville": "yes", "functions": [],
                          "without": [], "through": [], "frame": ""}}
        tree = {"node": "part", "part": "0", "word": [], "shown": [], "region": "0"}
        cover = {"id": "main", "rule": "cover", "system": systems[0]["name"], "symmetries": [], "parts": ["all"], "tree": tree}
        top = {"format": "kovacic-theorem/1", "title": "classes", "systems": systems, "steps": [step, cover]}
        self.assertEqual([verdict for verdict, _, _ in self.both(top)], [0, 0])
        for kind, near in (("meromorphic", "phase space"), ("real-analytic", "curve"), ("real-analytic", "level"), ("analytic", "curve")):
            step["class"] |= {"kind": kind, "near": near}
            self.forged(top)

    def test_what_is_open_is_said_and_nothing_else(self):
        code, out = self.bundles["open"]
        self.assertIn("OPEN", out)
        if os.path.exists(self.path("open.json")):
            for verdict, lines, _ in checked(self.path("open.json")):
                self.assertEqual(verdict, 0)
                self.assertTrue(any("nothing is said" in x for x in lines))
        else:
            self.assertIn("no certificate: ", out)
        _, proved, _ = kovacic("prove", self.path("open-theorem.toml"))
        self.assertNotIn("PROVED,", proved)
        self.assertNotIn("\nPROVED", proved)

    def test_the_theorem_file_says_the_same(self):
        for name in ("cubic", "constant"):
            code, out, _ = kovacic("prove", self.path(f"{name}-theorem.toml"), "--format", "json")
            classes = [x for x in checked(self.path(f"{name}.json"))[0][1] if "is not integrable with" in x]
            said = classes[0].split("first integrals that are ")[1].split(", where the")[0]
            self.assertEqual(said in out.replace(" at once", ""), True, name)
            trusted = " 0 trusted steps" not in checked(self.path(f"{name}.json"))[0][2]
            self.assertEqual((code, "PROVED, except " in out), (3, True) if trusted else (0, False), name)

    def test_the_verdict_says_that_it_rests_on_trust(self):
        for name in ("cubic", "second", "top", "field", "constant", "body"):
            for _, lines, whole in checked(self.path(f"{name}.json")):
                verdict = next(x for x in lines if "integrable" in x)
                self.assertEqual("if what is marked TRUSTED holds" in verdict, " TRUSTED: " in whole or "(TRUSTED: " in whole, name)

    def test_words_of_a_file_prove_nothing(self):
        """Integrable for a = 1 (and nothing is known of it here): neither a step on trust nor the words for a case make it a theorem"""
        manifold = '[[node.manifold]]\nname = "N"\nequations = ["q1 = 0", "p1 = 0"]\nlevel = ["H = E"]\n'
        class_ = 'step = "because I say so"\nintegrals = { kind = "meromorphic", near = "curve" }\n'
        trusted = '[[node]]\nid = "t"\nkind = "trusted"\ntitle = "t"\n' + class_
        case = f'[[node]]\nid = "c"\nkind = "case"\ntitle = "c"\nfile = "lie-system.toml"\nwhere = {{ a = "1" }}\nat = {{ a = "1" }}\nlevels = ["E"]\n{class_}{manifold}'
        claims = ('[[node]]\nid = "i"\nkind = "claims"\ntitle = "i"\nfile = "lie-system.toml"\nintegrable = true\nstep = "so it is"\n'
                  '[[node.integral]]\nname = "F"\nvalue = "q1"\n')
        with open(self.path("lie-system.toml"), "w", encoding="utf-8") as f:
            f.write(CUBIC)
        for needs, nodes in ((["t"], trusted + 'regions = [[]]\n'), (["t", "c"], trusted + 'regions = [["a != 1"]]\n' + case), (["i"], claims)):
            with open(self.path("lie.toml"), "w", encoding="utf-8") as f:
                f.write(f'format = "theorem/1"\ntitle = "a lie"\nsystem = "lie-system.toml"\n[[node]]\nid = "main"\nkind = "cover"\ntitle = "all"\n'
                        f'needs = {json.dumps(needs)}\n{nodes}')
            code, out, err = kovacic("prove", self.path("lie.toml"))
            self.assertEqual((code, err), (3 if needs != ["i"] else code, ""), out)
            self.assertNotEqual(code, 0, out)
            verdict = next(x for x in out.splitlines() if "PROVED" in x)
            self.assertEqual(verdict.startswith("PROVED, except 1 step that the file takes on trust"), needs == ["t"], out)
            self.assertTrue(needs == ["t"] or verdict.startswith("NOT PROVED: "), out)

    def test_a_part_is_missing(self):
        top = self.bundle("cubic")
        for k in range(len(top["steps"][-1]["parts"])):
            less = copy.deepcopy(top)
            del less["steps"][-1]["parts"][k]
            self.forged(less)

    def test_another_stratum(self):
        top = self.bundle("cubic")
        for k, s in enumerate(top["steps"]):
            if s["rule"] not in ("place", "integrable"):
                continue
            for row in range(len(s["at"])):
                other = copy.deepcopy(top)
                other["steps"][k]["at"][row][1] = "7"
                self.forged(other)
            for row in range(len(s["region"])):
                other = copy.deepcopy(top)
                other["steps"][k]["region"][row]["p"] = "a + 11"
                self.forged(other)

    def test_dependent_or_wrong_integrals(self):
        top = self.bundle("cubic")
        k = next(k for k, s in enumerate(top["steps"]) if s["rule"] == "integrable")
        claims = top["steps"][k]["claims"]
        dependent = copy.deepcopy(top)
        dependent["steps"][k]["claims"][1]["value"] = claims[0]["value"]
        self.forged(dependent, "another value")
        wrong = copy.deepcopy(top)
        wrong["steps"][k]["claims"][1]["value"] = "q1*p2 - q2*p1"
        self.forged(wrong, "not a first integral")
        one = copy.deepcopy(top)
        del one["steps"][k]["claims"][1]
        self.forged(one)
        some = [s for s in self.steps(top, "integrable")]
        if len(some) > 1:
            swapped = copy.deepcopy(top)
            mine = [s for s in swapped["steps"] if s["rule"] == "integrable"]
            mine[0]["claims"], mine[1]["claims"] = mine[1]["claims"], mine[0]["claims"]
            self.forged(swapped)

    def test_integrals_at_a_root_and_with_functions(self):
        """12 a^2 + 1 = 0 is not solved; a minor with exponentials has terms without them"""
        top = self.bundle("roots")
        k = next(k for k, s in enumerate(top["steps"]) if s["rule"] == "integrable" and any("a^2" in c["p"] for c in s["region"]))
        other = copy.deepcopy(top)
        other["steps"][k]["region"][0]["p"] = "12*a^2 + 2"
        self.forged(other)
        other = copy.deepcopy(top)
        other["steps"][k]["claims"][1]["value"] = top["steps"][k]["claims"][1]["value"].replace("a", "a^2")
        self.forged(other, "not a first integral")
        step = self.steps(self.bundle("lattice"), "integrable")[0]
        self.assertIsNotNone(step["independent"])

    def test_a_symmetry_in_a_cover(self):
        """A rotation that holds where B = A, used for one leaf: in another order, elsewhere or changed it shows nothing"""
        with open(os.path.join(HERE, "false/theorem/rotation-with-one-root.true.json"), encoding="utf-8") as f:
            top = json.load(f)
        k = next(k for k, s in enumerate(top["steps"]) if s["rule"] == "symmetry")

        def leaves(node):
            yield from [node] if node["node"] == "part" else []
            for key in ("zero", "nonzero", "positive", "negative"):
                yield from leaves(node[key]) if key in node else []
        moved = [i for i, x in enumerate(leaves(top["steps"][-1]["tree"])) if x["word"]]
        self.assertTrue(moved)
        for word in ([], ["0", "0"], ["1"], ["-1"]):
            other = copy.deepcopy(top)
            list(leaves(other["steps"][-1]["tree"]))[moved[0]]["word"] = word
            self.forged(other)
        for key, value in (("a", "a"), ("b", "-b"), ("q1", "q1"), ("p2", "2*p2")):
            other = copy.deepcopy(top)
            other["steps"][k]["values"][key] = value
            self.forged(other)
        other = copy.deepcopy(top)
        other["systems"][0]["complex"] = ["a"]
        self.forged(other)
        for row in range(len(top["steps"][k]["at"])):
            other = copy.deepcopy(top)
            del other["steps"][k]["at"][row]
            self.forged(other)

    def test_not_in_involution(self):
        top = self.bundle("second")
        k = next(k for k, s in enumerate(top["steps"]) if s["rule"] == "integrable")
        more = copy.deepcopy(top)
        more["steps"][k]["claims"].append({"name": "J", "value": "q1"})
        self.forged(more)

    def test_fields_that_do_not_commute(self):
        top = self.bundle("field")
        for k, s in enumerate(top["steps"]):
            if s["rule"] == "integrable":
                other = copy.deepcopy(top)
                other["steps"][k]["fields"].append(["1", "0", "0"])
                self.forged(other)

    def test_the_rank_of_the_bracket(self):
        top = self.bundle("top")
        k = next(k for k, s in enumerate(top["steps"]) if s["rule"] == "integrable")
        other = copy.deepcopy(top)
        other["steps"][k]["rank"]["columns"] = other["steps"][k]["rank"]["columns"][:1]
        self.forged(other)

    def test_a_trusted_step_is_counted_and_has_a_class(self):
        top = self.bundle("cubic")
        trusted = [k for k, s in enumerate(top["steps"]) if s["rule"] == "trusted"]
        self.assertIn(f"{len(trusted)} trusted step", self.bundles["cubic"][1])
        for k in trusted:
            for key, value in (("near", "everywhere"), ("kind", "smooth"), ("liouville", "maybe"), ("frame", "a\nb")):
                other = copy.deepcopy(top)
                other["steps"][k]["class"][key] = value
                self.forged(other)
            less = copy.deepcopy(top)
            del less["steps"][k]["class"]
            self.forged(less)
            empty = copy.deepcopy(top)
            empty["steps"][k]["regions"] = []
            self.forged(empty)

    def test_complex_parameters_have_no_signs(self):
        """a^2 + 1 = 0 has no real point and two complex ones"""
        top = self.bundle("cubic")
        cover = top["steps"][-1]
        gap = {"node": "empty", "terms": [["1", "1"], ["1", "a"]], "zeros": [[str(len(top["systems"][0]["assumptions"])), "-1"]]}
        other = copy.deepcopy(top)
        other["steps"][-1]["tree"] = {"node": "zero", "p": "a^2 + 1", "zero": gap, "nonzero": gap}
        real = copy.deepcopy(other)
        real["systems"][0]["complex"] = []
        for said in (x[2] for x in self.both(other)):
            self.assertTrue(any(words in said for words in ("has no sign", "not one of sign zero", "is not real")), said)
        for said in (x[2] for x in self.both(real)):                    # of real numbers the first branch is empty
            self.assertNotIn("has no sign", said)
        other["steps"][-1]["tree"] = {"node": "sign", "p": "a", "positive": cover["tree"], "zero": cover["tree"],
                                      "negative": cover["tree"]}
        self.forged(other, "the sign of what need not be real")

    def test_another_system(self):
        top = self.bundle("cubic")
        if self.steps(top, "place"):
            other = copy.deepcopy(top)
            h = other["systems"][0]["system"]["hamiltonian"]
            other["systems"][0]["system"]["hamiltonian"] = [h[0] + " + q1^4", h[1]] if isinstance(h, list) else h + " + q1^4"
            self.forged(other)

    def test_an_answer_without_a_certificate_is_kept(self):
        """Excluded but where sqrt((l^2 + 4)/a^2) - 1/2 is an integer: the format has no word for that, and the answer stays."""
        path = self.path("bessel.toml")
        with open(path, "w", encoding="utf-8") as f:
            f.write('format = "equation/1"\n[system]\nkind = "vector-field"\ncoordinates = ["x", "y", "z"]\nparameters = ["l", "a"]\n'
                    '[system.field]\nx = "y"\ny = "x - l*y - x*z"\nz = "-a*z + x^2"\n')
        _, out, _ = kovacic("classify", path, "--certificate", self.path("bessel.json"))
        self.assertNotIn("nothing is claimed", out)
        self.assertIn("excluded", out)
        self.assertTrue("no certificate: " in out or os.path.exists(self.path("bessel.json")), out)

    def test_inputs(self):
        path = self.path("cubic.toml")
        code, _, err = kovacic("classify", path, "--certificate", self.path("no/such/folder/c.json"), "--max-work", "1e6")
        self.assertEqual(code, 2, err)
        code, _, err = kovacic("classify", path, "--as-theorem", self.path("no/such/folder/c.toml"), "--max-work", "1e6")
        self.assertEqual(code, 2, err)
        plain = self.path("plain.toml")
        with open(plain, "w") as f:
            f.write('format = "equation/1"\n' + CUBIC.replace('parameters  = ["a"]', "").replace("a*q1", "2*q1"))
        code, out, _ = kovacic("classify", plain, "--certificate", self.path("plain.json"), "--timeout", "0")
        self.assertEqual([x[0] for x in checked(self.path("plain.json"))], [0, 0], out)


if __name__ == "__main__":
    unittest.main()
