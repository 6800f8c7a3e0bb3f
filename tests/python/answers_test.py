"""Answers as values: equality, copies, and pickles, which hold the question."""

import copy
import multiprocessing
import pickle
import unittest

import kovacic

SYSTEM = kovacic.System("p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3", "q1 q2", "p1 p2")


def every_kind():
    """Functions whose answers are different from each other."""
    spectrum = kovacic.spectrum("x^2 - E")
    certificate = kovacic.solve("z", certificate=True).certificate
    return [kovacic.solve("z"), kovacic.solve("z^2"), kovacic.solve("z^2 + 3"), kovacic.solve("2*z"), kovacic.solve("sqrt(2)*z"),
            kovacic.solve("y'' + y' + y = 0"), kovacic.solve("y'' + 2*y' + y = 0"), kovacic.solve("-3/(16*z^2) - 2/(9*(z-1)^2) + 3/(16*z*(z-1))"),
            kovacic.solve("z^2 + a", parameters="a"), kovacic.solve("z^2 + a", parameters="a", assume="a > 0"),
            kovacic.solve("a*z", parameters="a"), kovacic.solve("z^4 + 2002*z", max_degree=100),
            SYSTEM.classify(set={"b": 6}), SYSTEM.classify(set={"b": 1}), SYSTEM.integrals(), SYSTEM.check(set={"b": 3}),
            SYSTEM.check(set={"b": 4}), spectrum, kovacic.monodromy("z", digits=5), kovacic.verify(certificate), kovacic.verify(certificate.replace('"SL2"', '"Borel"')),
            kovacic.lame(1, 0, 1, 0), kovacic.lame(2, 0, 1, 0), kovacic.lame(1)]


class Answers(unittest.TestCase):
    def test_equal_where_they_say_the_same(self):
        first, second = every_kind(), every_kind()
        for i, a in enumerate(first):
            for j, b in enumerate(second):
                self.assertEqual(a == b, i == j, (a, b))
                if i == j:
                    self.assertEqual(hash(a), hash(b))
        self.assertNotEqual(kovacic.solve("z"), "z")
        self.assertEqual(kovacic.solve("z").group, kovacic.solve("z^3").group)
        self.assertEqual(kovacic.solve("z + a", parameters="a").strata, kovacic.solve("z + a", parameters="a").strata)

    def test_copies(self):
        for answer in every_kind():
            self.assertIs(copy.copy(answer), answer)
            self.assertIs(copy.deepcopy([answer])[0], answer)
        for value in (kovacic.solve("z").r, kovacic.solve("a*z", parameters="a").r, kovacic.solve("z").group):
            self.assertEqual(copy.deepcopy(value), value)

    def test_a_pickle_asks_again(self):
        for answer in every_kind():
            again = pickle.loads(pickle.dumps(answer))
            self.assertIs(type(again), type(answer))
            self.assertEqual(again, answer)
            self.assertEqual(str(again), str(answer))
            self.assertEqual(pickle.loads(pickle.dumps(again)), answer)
        families = kovacic.lame(n="m")
        self.assertEqual(pickle.loads(pickle.dumps(families)), families)
        with self.assertRaisesRegex(TypeError, "pickle the answer"):
            pickle.dumps(kovacic.solve("a*z", parameters="a").strata[0])
        for value in (kovacic.solve("z").group, kovacic.solve("2/z^2").group, kovacic.solve("z").abelian):
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)

    def test_a_pool(self):
        with multiprocessing.Pool(2) as pool:
            answers = pool.map(kovacic.solve, ["z", "z^2", "0"])
        self.assertEqual(answers, [kovacic.solve(r) for r in ("z", "z^2", "0")])
        self.assertEqual(repr(answers[0].group), "GaloisGroup('SL2')")

    def test_sections_are_numbers(self):
        s = kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=5)
        for again in (pickle.loads(pickle.dumps(s)), copy.deepcopy(s)):
            self.assertEqual([list(c) for c in (again.x, again.y, again.t, again.orbit)],
                             [list(c) for c in (s.x, s.y, s.t, s.orbit)])
            self.assertEqual((again.labels, again.drift, again.integrals, again.arithmetic), (s.labels, s.drift, s.integrals, s.arithmetic))
            self.assertEqual(again.orbits, s.orbits)

    def test_formulas_have_one_pair_of_dollars(self):
        shown = [kovacic.solve(r)._repr_latex_() for r in ("z", "z^2 + 3", "sqrt(2)*z", "a_1*z")[:3]]
        shown += [f._repr_latex_() for f in (kovacic.solve("z/(z+1)").r, kovacic.solve("a*z", parameters="a").r, kovacic.solve("1").liouvillian[0])]
        for text in shown:
            self.assertNotIn("$$", text)
            self.assertEqual(text.count("$"), 2, text)
        self.assertRegex(SYSTEM._repr_latex_(), r"^\$\$[^$]*\$\$$")


if __name__ == "__main__":
    unittest.main()
