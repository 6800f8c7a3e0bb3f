"""Seeded families y'' = r(z; parameters) y with assumptions, as lines for `kovacic solve --batch`: every kind of
assumption that a certificate has to carry, and equations whose verdict depends on it."""
import json
import random

VALUES = ["1/2", "1/3", "2/3", "3/2", "1", "2", "-1", "5/4"]


def linear(rng, xs):
    """A polynomial of degree 1 in some of the parameters"""
    terms = [f"{rng.choice([1, 1, 2, 3, -1, -2])}*{x}" for x in rng.sample(xs, rng.randint(1, len(xs)))]
    return "+".join([*terms, str(rng.randint(-3, 3))]).replace("+-", "-")


def small(rng, xs):
    return rng.choice([lambda: linear(rng, xs), lambda: f"{rng.choice(xs)}^2-{rng.randint(1, 5)}",
                       lambda: f"({linear(rng, xs)})*({linear(rng, xs)})", lambda: rng.choice(xs),
                       lambda: f"{rng.choice(xs)}^2+{rng.randint(1, 3)}"])()


def equation(rng, xs):
    a, b, c = (small(rng, xs) for _ in range(3))
    k = rng.choice(VALUES)
    return rng.choice([
        f"({a})*z", f"({a})*z+({b})", f"z^2+({a})", f"(({a})^2-1)/(4*z^2)", f"({a})/(z^3-z)", f"({a})/z^2+({b})/z",
        f"({a})/z^2+({k})", f"(({k})^2-1)/(4*z^2)+({a})/z", f"(({a})^2-1)/(4*z^2)+({k})/(z-1)",
        f"(({a})^2-1)/(4*z^2)+(({k})^2-1)/(4*(z-1)^2)+({b})/(z*(z-1))", f"(({a})*z^2+({b}))/(z^2-1)^2",
        f"(({a})*z+({b}))/(z^2*({c}))", f"-3/(16*z^2)-3/(16*(z-1)^2)+({a})/(z*(z-1))",
        f"-(4*z+1-({xs[0]})^2)/(4*z^2)", f"z^2/4-1/2-({xs[0]})", f"({a})*z^3+({b})*z", f"({a})/z^4+({k})/z^3"])


def assumption(rng, xs):
    x = rng.choice(xs)
    return rng.choice([
        lambda: f"{x} > 0", lambda: f"{small(rng, xs)} != 0", lambda: f"{linear(rng, xs)} = 0", lambda: f"{x} real",
        lambda: f"{x} rational", lambda: f"{x} integer", lambda: f"{x} not an integer", lambda: f"{x} >= 1",
        lambda: f"{x} not in 1/2+Z", lambda: f"({linear(rng, [x])})/{rng.randint(2, 3)} not an integer",
        lambda: f"{x}^2-{rng.choice([2, 3, 4])} = 0"])()


def family(rng):
    xs = ["a", "b", "c"][:rng.choice([1, 1, 2, 2, 3])]
    given = list(dict.fromkeys(assumption(rng, xs) for _ in range(rng.choice([0, 1, 1, 2, 3]))))
    return {"r": equation(rng, xs), "parameters": xs, "assumptions": given}


def lines(seed, count):
    rng = random.Random(seed)
    return [json.dumps({"id": f"f{i}", **family(rng)}) for i in range(count)]
