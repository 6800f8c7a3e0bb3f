"""How an equation with a known group is made: each function returns the text of r in y'' = r y."""

from fractions import Fraction as Q

from .rational import Rational, Z, add, derivative, poly, product, scale, text


def partial_fractions(terms):
    """The sum of a/(z-c)^2 + b/(z-c) for the triples (c, a, b)."""
    parts = []
    for c, a, b in terms:
        if a:
            parts.append(f"({a})/(z-({c}))^2")
        if b:
            parts.append(f"({b})/(z-({c}))")
    return "+".join(parts) or "0"


def exponential(residues):
    """r = w' + w^2 for w = sum rho/(z-c), given {c: rho} as pairs."""
    terms = []
    for i, (c, rho) in enumerate(residues):
        b = sum((2 * rho * s / (c - d) for j, (d, s) in enumerate(residues) if j != i), Q(0))
        terms.append((c, rho * rho - rho, b))
    return partial_fractions(terms)


def from_omega(w):
    return str(w.derivative() + w * w)


def from_square(f, w_squared):
    """r of the solutions with (y1 y2)^2 = f and Wronskian w: w^2/(4 f) + phi'/2 + phi^2/4, phi = f'/(2 f)."""
    # = (4 w^2 f + 4 f f'' - 3 f'^2) / (16 f^2), f squarefree
    d = derivative(f)
    num = add(add(scale(f, 4 * w_squared), scale(product([f, derivative(d)]), Q(4))),
              scale(product([d, d]), Q(-3)))
    return f"({text(num)})/(16*({text(f)})^2)"


def riemann(at0, at1, at_inf):
    """Exponent differences at 0, 1, infinity."""
    at0, at1, at_inf = Q(at0), Q(at1), Q(at_inf)
    one_z = add(poly(1), scale(Z, Q(-1)))
    num = add(add(scale(product([one_z, one_z]), at0**2 - 1), scale(product([Z, Z]), at1**2 - 1)),
              scale(product([Z, one_z]), at0**2 + at1**2 - at_inf**2 - 1))
    return Rational(num, scale(product([Z, Z, one_z, one_z]), Q(4)))


def pull_back(r, f):
    """r(f) f'^2 - S(f)/2 with the Schwarzian S: the same equation after z -> f(z)."""
    d = f.derivative()
    u = d.derivative() / d
    return r.after(f) * d * d - (u.derivative() - u * u * Q(1, 2)) * Q(1, 2)


def gauge(r, a):
    """The equation of u = (a y + y')/sqrt(g), g = r + a' - a^2: same projective group, apparent singularities
    at the zeros of g."""
    g = r + a.derivative() - a * a
    p = g.derivative() / g * -1
    q = (r + a.derivative() * 2) * -1 - p * a
    return p * p * Q(1, 4) + p.derivative() * Q(1, 2) - q


def no_solution(n):
    """sum -2/9/(z-i)^2 + 1/prod(z-i): every finite exponent difference 1/3, group SL2."""
    return ("+".join(f"(-2/9)/(z-{i})^2" for i in range(1, n + 1)) + "+1/("
            + "*".join(f"(z-{i})" for i in range(1, n + 1)) + ")")


def selmer(n):
    """z^n - z - 1, irreducible over Q for every n >= 2."""
    return poly(-1, -1, *[0] * (n - 2), 1)
