#!/usr/bin/env python3
"""Figures of docs/theory, first half of the pages by name; theory_b.py has the others.

usage: python3 docs/figures/theory_a.py

Writes NAME.svg beside itself; what is committed is what this writes (tests/documents/figures_test.py).
"""

import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from svg import BLUE, GREEN, GREY, ORANGE, RED, VIOLET, Figure, run  # noqa: E402


def algebraic_solution():
    figure = Figure(250, "The octahedron whose corners are the zeros of the ground form of degree 6")
    cx, cy = 150, 125
    at = {"0": (cx, cy + 95), "∞": (cx, cy - 95), "1": (cx + 95, cy + 8), "−1": (cx - 95, cy - 8),
          "i": (cx + 34, cy - 22), "−i": (cx - 34, cy + 22)}
    figure.circle(cx, cy, 97, dash="3 4")
    for end in ("0", "∞"):
        for corner in ("1", "−1", "−i"):
            figure.line([at[end], at[corner]], colour=BLUE)
        figure.line([at[end], at["i"]], colour=BLUE, dash="4 4", width=1)
    figure.line([at["−1"], at["−i"], at["1"]], colour=BLUE)
    figure.line([at["−1"], at["i"], at["1"]], colour=BLUE, dash="4 4", width=1)
    places = {"0": (0, 20), "∞": (0, -10), "1": (14, 5), "−1": (-17, 5), "i": (12, -6), "−i": (19, 17)}
    for name, (x, y) in at.items():
        figure.point(x, y, name, dx=places[name][0], dy=places[name][1])
    figure.text(300, 40, "*F* = *xy*(*x*^{4} − *y*^{4}) vanishes at the 6 corners", anchor="start")
    columns = (320, 405, 480, 570)
    for x, head in zip(columns, ("group", "*m*", "*k*", "|*G*| = *k m*")):
        figure.text(x, 85, head)
    figure.line([(290, 96), (625, 96)])
    for row, cells in enumerate((("*A*_{4}", "6", "4", "24"), ("*S*_{4}", "6", "8", "48"), ("*A*_{5}", "12", "10", "120"))):
        for x, cell in zip(columns, cells):
            figure.text(x, 120 + 26 * row, cell)
    figure.texts(300, 212, ["*m* lines, the factors of *F* (1);", "each has a stabiliser of order *k* (3)"], anchor="start")
    return figure


def canonical():
    figure = Figure(235, "A change of canonical variables, what it asks and what it gives back")
    user = figure.box(10, 30, 165, ["*H*(*q*, *p*)", "the user's variables"], height=150)
    new = figure.box(465, 30, 165, ["*H'*(*Q*, *P*)", "fewer terms"], height=150, colour=GREEN)
    for y, marked, colour, back in ((55, "exchange (2), square (3),", BLUE, False), (115, "*F*(*Q*, *P*) is an integral (1.1)", GREEN, True),
                                    (160, "excluded, in *Q* and *P* (1.2)", RED, True)):
        ends = [(user.side("right")[0], y), (new.side("left")[0], y)]
        figure.arrow(ends[::-1] if back else ends, marked, colour=colour)
    figure.text(320, 73, "origin (4), flat coordinates (5)")
    figure.text(320, 213, "checked: {*Q*_{i}, *Q*_{j}} = {*P*_{i}, *P*_{j}} = 0,  {*Q*_{i}, *P*_{j}} = δ_{ij},  *H* = *H'*(*Q*, *P*)")
    return figure


def certificates():
    figure = Figure(280, "The steps of a certificate for the octahedral group")
    local = figure.box(15, 70, 120, ["local", "the places"], height=70)
    steps = [figure.box(215, 10 + 52 * k, 165, [line], height=36) for k, line in
             enumerate(("no-exponential", "no-invariant, *m* = 4", "no-invariant, *m* = 6"))]
    invariant = figure.box(215, 166, 165, ["invariant, *m* = 8"], height=36, colour=GREEN)
    end = figure.box(475, 66, 150, ["conclude", "octahedral:", "*G* = *S*_{4}"], height=86, colour=RED)
    for k, step in enumerate(steps):
        figure.arrow([local.side("right", 0.25 + 0.25 * k), step.side("left")])
    for k, step in enumerate(steps + [invariant]):
        figure.arrow([step.side("right"), end.side("left", 0.2 + 0.2 * k)])
    figure.text(75, 189, "from *r* alone")
    figure.arrow([(130, 184), invariant.side("left")])
    figure.text(320, 236, "Each step is checked from *r*, its own data and its premises (arrows),")
    figure.text(320, 258, "by two checkers, one in C++ and one in Python.")
    return figure


def classify():
    figure = Figure(275, "A plane of parameters that is divided into strata")
    x, y = 40, 235
    figure.line([(x, y), (x, y - 195), (x + 265, y - 195), (x + 265, y)], colour=RED, width=0.1, fill=RED, opacity=0.12, closed=True)
    figure.axes(x, y, 275, 205, "*μ*_{1}", "*μ*_{2}")

    def curve(t):
        return x + 265 * t, y - 25 - 150 * t * t

    figure.curve(curve, 0, 1, colour=GREEN, width=3)
    figure.point(*curve(0.55), colour=ORANGE, radius=6)
    figure.text(x + 55, y - 150, "*p* ≠ 0", colour=RED)
    figure.text(x + 215, y - 45, "*p* ≠ 0", colour=RED)
    figure.text(x + 195, y - 142, "*p* = 0", colour=GREEN)
    figure.text(x + 130, y - 92, "*p* = *f* = 0", anchor="end", colour=ORANGE)
    for row, (colour, head, lines) in enumerate((
            (RED, "excluded", ["a solution whose variational equation", "has no abelian *G*^{0} (1, 3, 4, 6)"]),
            (GREEN, "integrable", ["first integrals, proved (5)"]),
            (ORANGE, "open", ["neither was found: what was tried;", "this proves nothing"]))):
        top = 52 + 75 * row
        figure.point(368, top - 5, colour=colour, radius=6)
        figure.text(384, top, head, anchor="start", bold=True)
        figure.texts(368, top + 20, lines, anchor="start", size=13)
    figure.text(173, 264, "each exclusion cuts a piece in two (7)", size=13)
    return figure


def composition():
    figure = Figure(255, "Regions of steps that cover the parameters of a theorem")
    left, top, width, height = 250, 45, 375, 170
    figure.text(left + width / 2, 32, "all real *p* that satisfy the assumptions (2.1)")
    for points, colour in (([(0, 0), (225, 0), (165, height), (0, height)], BLUE),
                           ([(205, 0), (width, 0), (width, 95), (172, 95)], GREEN),
                           ([(185, 75), (width, 75), (width, height), (140, height)], VIOLET)):
        figure.line([(left + a, top + b) for a, b in points], colour=colour, fill=colour, opacity=0.15, closed=True)
    figure.text(left + 90, top + 90, "*R*_{1}", bold=True)
    figure.text(left + 290, top + 45, "*R*_{2}", bold=True)
    figure.text(left + 275, top + 130, "{ *p* : *g*(*p*) ∈ *R*_{1} }")
    figure.arrow([(left + 180, top + 140), (left + 105, top + 100)], "*g*", dx=-6, dy=16)
    step = figure.box(10, 45, 160, ["a step: *Y*(*q*)", "not integrable"], colour=BLUE)
    place = figure.box(10, 140, 160, ["in place: *X*(*p*),", "*p* in *R*_{1}  (1)"], colour=BLUE)
    figure.join(step, "bottom", place, "top", "(1.1)", dx=26, dy=4)
    figure.arrow([place.side("right"), (left, place.side("right")[1])], colour=BLUE)
    figure.text(320, 240, "Each *p* lies in a region, or a symmetry *g* takes it into one: *X*(*p*) is not integrable.", size=13)
    return figure


def confluent():
    figure = Figure(335, "Whittaker's equation in the plane of P and Q")
    cx, cy, step = 175, 172, 32
    for k in range(-4, 5):
        figure.line([(cx + k * step, cy - 4.4 * step), (cx + k * step, cy + 4.4 * step)], colour=BLUE, width=1.5)
        figure.line([(cx - 4.4 * step, cy + k * step), (cx + 4.4 * step, cy + k * step)], colour=BLUE, width=1.5)
    for p in range(-4, 5):
        for q in range(-4, 5):
            if (p >= 0) != (q >= 0):
                figure.raw(f'<circle cx="{cx + p * step}" cy="{cy - q * step}" r="5" fill="{RED}"/>')
    for k in range(-4, 5):
        figure.text(cx + k * step, cy + 4.4 * step + 16, str(k).replace("-", "−"), size=13)
        figure.text(cx - 4.4 * step - 8, cy - k * step + 5, str(k).replace("-", "−"), anchor="end", size=13)
    figure.text(cx + 4.4 * step + 14, cy + 5, "*P*")
    figure.text(cx, cy - 4.4 * step - 8, "*Q*")
    x = 365
    figure.texts(x, 40, ["*P* = *κ* + *μ* − ½,   *Q* = *κ* − *μ* − ½"], anchor="start")
    figure.line([(x, 80), (x + 34, 80)], colour=BLUE, width=2)
    figure.texts(x + 44, 85, ["*P* or *Q* is an integer:", "reducible, the Borel group,"], anchor="start")
    figure.point(x + 17, 143, radius=5)
    figure.texts(x + 44, 148, ["but at these points both signs", "*s* occur: diagonal, *G* = Gm"], anchor="start")
    figure.raw(f'<rect x="{x + 5}" y="198" width="24" height="24" fill="none" stroke="{GREY}"/>')
    figure.texts(x + 44, 215, ["elsewhere: *G* = SL(2)"], anchor="start")
    figure.texts(x, 262, ["(drawn for real *κ* and *μ*; the pattern", "continues in all directions)"], anchor="start", size=13)
    return figure


def descent():
    figure = Figure(330, "The cases of the algorithm in the order in which they are tried")
    start = figure.box(15, 15, 150, ["*y''* = *r y*", "over *K*(*z*)"], height=50)
    cases = [figure.box(15, 95 + 75 * k, 210, [head, line], height=50) for k, (head, line) in enumerate((
        ("case 1: lines (5)", "Sym^{2}, or one *ω* in *K*(*z*)"), ("case 2: pairs of lines (7)", "*v* = *y*_{1}*y*_{2}, *v*^{2} rational"),
        ("case 3: finite primitive (8)", "forms of degree 6 and 12")))]
    found = [figure.box(435, 95 + 75 * k, 190, [line], height=50, colour=GREEN) for k, line in enumerate((
        "*G* is triangular", "*G* = *D*_{n} or *D*_{∞}", "*A*_{4}, *S*_{4} or *A*_{5}"))]
    figure.arrow([start.side("bottom"), (start.side("bottom")[0], 95)])
    for one, other in zip(cases, found):
        figure.join(one, "right", other, "left", "found, put back (9)", dx=14)
    for one, other in zip(cases, cases[1:]):
        figure.arrow([one.side("bottom", 0.36), other.side("top", 0.36)], "none", dx=24, dy=5)
    end = figure.box(435, 15, 190, ["case 4: *G* = SL(2, *C*)"], height=50, colour=RED)
    x = 250
    figure.arrow([cases[2].side("right", 0.86), (x, cases[2].side("right", 0.86)[1]), (x, 40), end.side("left")], colour=RED)
    figure.text(x + 9, 58, "none of them (8)", anchor="start", size=13)
    figure.arrow([cases[0].side("right", 0.86), (x, cases[0].side("right", 0.86)[1])], colour=RED)
    figure.text(x + 9, 141, "a logarithm (3)", anchor="start", size=13)
    figure.text(320, 322, "Conjugate poles stay one place *q*; every *P* is found by linear algebra over *K* (6).", size=13)
    return figure


def dihedral_torsion():
    figure = Figure(340, "How it is decided whether an imprimitive group is finite")
    asked = [("some place irregular or Δ irrational?", "(2)", "*G* = *D*_{∞}", RED),
             ("*v* = *c* ∏ *q*^{e}, all *e* ≤ ½, Σ *e* deg *q* ≥ 3/2?", "(8)", "*G* = *D*_{∞}", RED),
             ("genus 0: deg *F*_{0} ≤ 2?", "(5)", "*n* = *L*", GREEN),
             ("*h* in *C*(*C*) with *h'* = *n*(*w*/*v*)*h*, *n* least?", "(6, 9)", "this *n*", GREEN),
             ("∏ *p* > (*q* + 2 + ⌊2√*q*⌋)^{g}, all *B*_{p} ≠ 0?", "(7)", "*G* = *D*_{∞}", RED)]
    boxes = [figure.box(15, 12 + 54 * k, 370, [line], height=34) for k, (line, *_) in enumerate(asked)]
    for box, (_, section, answer, colour) in zip(boxes, asked):
        end = figure.box(500, box.y, 125, [answer], height=34, colour=colour)
        figure.join(box, "right", end, "left", f"yes {section}")
    for one, other in zip(boxes, boxes[1:]):
        figure.arrow([one.side("bottom", 0.2), other.side("top", 0.2)], "no", dx=18, dy=5)
    figure.arrow([boxes[-1].side("bottom", 0.2), (89, 290)], "no", dx=18, dy=5)
    figure.texts(89, 306, ["else (9),", "or undecided"], size=13)
    figure.text(170, 306, "*G* = *D*_{n}, of order 4*n* (cyclic of order 4 for *n* = 1); curve *C*: *s*^{2} = *F*_{0}", anchor="start", size=13)
    figure.text(170, 328, "*L*: least common denominator of the Δ at places without branching (4)", anchor="start", size=13)
    return figure


def integrals():
    figure = Figure(300, "Sets of parameters are divided until each pivot vanishes nowhere")
    top = figure.box(215, 12, 210, ["parameters *S*,", "rows of *X*(*N*/*W*) = 0 (1)"])
    one = figure.box(70, 112, 150, ["*f* ≠ 0", "*f* is a pivot"], colour=GREEN)
    two = figure.box(420, 112, 150, ["*f* = 0", "other entries"], colour=ORANGE)
    figure.join(top, "left", one, "top")
    figure.join(top, "right", two, "top")
    figure.text(320, 88, "*f*: a factor of an entry (2)")
    ends = [figure.box(15, 215, 130, ["a basis of *N*"], height=34, colour=GREEN),
            figure.box(165, 215, 130, ["kernel 0"], height=34, colour=RED),
            figure.box(345, 215, 130, ["*f* = 0, *g* ≠ 0"], height=34, colour=GREEN),
            figure.box(495, 215, 130, ["*f* = *g* = 0"], height=34, colour=ORANGE)]
    figure.arrow([one.side("bottom", 0.3), ends[0].side("top")], "or", dx=56, dy=4)
    figure.arrow([one.side("bottom", 0.7), ends[1].side("top")])
    figure.arrow([two.side("bottom", 0.3), ends[2].side("top")])
    figure.arrow([two.side("bottom", 0.7), ends[3].side("top")])
    figure.texts(80, 268, ["integrals; are they", "independent? (3)"], size=13)
    figure.texts(230, 268, ["no new one in", "the class (2, 4)"], size=13)
    figure.texts(485, 268, ["and so on: the parts are disjoint", "and cover *S* (Theorem 1)"], size=13)
    return figure


def invariants_one_point():
    figure = Figure(280, "The matrix of coefficients whose rank excludes an invariant")
    x, y, cell, rows, low, high = 165, 60, 36, 4, 5, 7
    for row in range(rows):
        for column in range(low + high):
            colour = GREY if column < low else BLUE
            figure.raw(f'<rect x="{x + column * cell}" y="{y + row * cell}" width="{cell - 3}" height="{cell - 3}" rx="3" '
                       f'fill="{colour}" fill-opacity="{0.12 if column < low else 0.35}"/>')
    for row, name in enumerate(("*y*_{2}^{m} / *V*", "*y*_{1} *y*_{2}^{m−1} / *V*", "…", "*y*_{1}^{m} / *V*")):
        figure.text(x - 12, y + row * cell + 22, name, anchor="end")
    for column, name in ((0, "1"), (1, "*t*"), (2, "…"), (low - 1.05, "*t*^{D}"), (low + 0.05, "*t*^{D+1}"), (low + 2, "…"),
                         (low + high - 1, "*t*^{T−1}")):
        figure.text(x + column * cell + 17, y - 12, name)
    middle, base = x + low * cell - 2, y + rows * cell
    figure.line([(middle, y - 34), (middle, base + 8)], colour=RED, dash="5 4")
    figure.texts(x + low * cell / 2, base + 20, ["a polynomial of", "degree ≤ *D* = *D*_{m}"])
    figure.texts(x + (low + high / 2) * cell, base + 20, ["an invariant: rows depend here;", "rank *m* + 1 excludes it (1)"])
    figure.text(320, 268, "Power series in *t* = *z* − *x*_{0} modulo a prime *p*; *V* = ∏ *q*^{e} as *q* runs over the poles.", size=13)
    return figure


def jet_certificates():
    figure = Figure(280, "The rules of a certificate and what each of them gives")
    names = (("*J*_{1}", "line", "*x* = 0"), ("*J*_{2}", "place", "*y*(*t*), free *e*"), ("*J*_{3}", "normal eq.", "*u*_{1}, *u*_{2}"),
             ("*J*_{4}", "jets", "no logarithm"), ("*J*_{5}", "residues", "form *R*"))
    boxes = [figure.box(8 + 128 * k, 20, 112, [f"{rule}  {what}", gives], height=56) for k, (rule, what, gives) in enumerate(names)]
    for one, other in zip(boxes, boxes[1:]):
        figure.join(one, "right", other, "left")
    six = figure.box(350, 115, 282, ["*J*_{6}  obstruction: no quadratic form", "but 0 commutes with *R*, or *R* ≠ 0"], height=54, colour=ORANGE)
    seven = figure.box(8, 115, 282, ["*J*_{7}  the group of the", "normal equation is infinite"], height=54, colour=ORANGE)
    figure.arrow([boxes[4].side("bottom"), (boxes[4].side("bottom")[0], 115)])
    figure.arrow([boxes[2].side("bottom", 0.3), (boxes[2].side("bottom", 0.3)[0], 95), (149, 95), seven.side("top")])
    end = figure.box(150, 210, 340, ["not integrable near the phase curve", "(Morales-Ruiz, Ramis and Simó)"], height=54, colour=RED)
    for box in (six, seven):
        middle = box.side("bottom")[0]
        figure.arrow([(middle, 169), (middle, 190), (320 + (8 if box is six else -8), 190), (320 + (8 if box is six else -8), 210)])
    return figure


def kimura():
    figure = Figure(330, "Three singular places with their exponent differences, and the group")
    for x, name, difference, matrix in ((120, "0", "*l*", "*M*_{0}"), (320, "1", "*m*", "*M*_{1}"), (520, "∞", "*n*", "*M*_{∞}")):
        figure.circle(x, 55, 24, colour=BLUE, dash="4 3")
        figure.point(x, 55)
        figure.text(x, 22, matrix)
        figure.text(x - 36, 74, name)
        figure.text(x + 36, 74, difference, colour=RED, bold=True)
    figure.line([(20, 55), (620, 55)], width=1)
    figure.text(320, 108, "*M*_{0} *M*_{1} *M*_{∞} = 1,   tr *M*_{0} = −2 cos *πl*, and so on (1)")
    asked = [("some *l* ± *m* ± *n* is an odd integer?", "(1.3)", "reducible (2)", GREEN),
             ("two of *l*, *m*, *n* in ½ + *Z*?", "(3.1)", "*D*_{q} or *D*_{∞}", GREEN),
             ("rational, and in the table?", "(3.2)", "*A*_{4}, *S*_{4}, *A*_{5}", GREEN)]
    boxes = [figure.box(25, 132 + 50 * k, 290, [line], height=32) for k, (line, *_) in enumerate(asked)]
    for box, (_, section, answer, colour) in zip(boxes, asked):
        figure.join(box, "right", figure.box(460, box.y, 150, [answer], height=32, colour=colour), "left", f"yes {section}")
    for one, other in zip(boxes, boxes[1:]):
        figure.arrow([one.side("bottom", 0.2), other.side("top", 0.2)], "no", dx=18, dy=5)
    end = figure.box(25, 282, 290, ["*G* = SL(2)  (3.4)"], height=32, colour=RED)
    figure.arrow([boxes[-1].side("bottom", 0.2), end.side("top", 0.2)], "no", dx=18, dy=5)
    return figure


def kovacic1986():
    figure = Figure(290, "Three cases with three steps each")
    heads = ("§3: case 1", "§4: case 2", "§5: case 3")
    steps = (("1: exponents", ("*α*_{c}^{±}, *α*_{∞}^{±}", "*E*_{c}, *E*_{∞}", "*E*_{c}, *E*_{∞}")),
             ("2: families", ("*d* = *α*_{∞} − Σ*α*_{c}", "*d* = ½(*e*_{∞} − Σ*e*_{c})", "*d* = (*n*/12)(*e*_{∞} − Σ*e*_{c})")),
             ("3: *P*, deg *d*", ("*P''* + 2*ωP'* + … = 0", "*P'''* + 3*θP''* + … = 0", "*P*_{n}, …, *P*_{−1} = 0")))
    columns = [figure.box(105 + 180 * k, 42, 170, [], height=186, fill=0.06) for k in range(3)]
    for k, head in enumerate(heads):
        figure.text(190 + 180 * k, 62, head, bold=True)
    for row, (name, cells) in enumerate(steps):
        figure.text(8, 103 + 50 * row, name, anchor="start", size=13)
        boxes = [figure.box(111 + 180 * k, 80 + 50 * row, 158, [cell], height=34, size=13) for k, cell in enumerate(cells)]
        if row < 2:
            for box in boxes:
                figure.arrow([box.side("bottom"), (box.side("bottom")[0], box.y + 50)])
    figure.text(8, 26, "§2.1: the orders of the poles leave some of the cases", anchor="start")
    ends = [figure.box(111 + 180 * k, 250, 158, [line], height=32, size=13, colour=GREEN) for k, line in
            enumerate(("*ω* in *C*(*z*)", "*ω* of degree 2", "*ω* of degree 4, 6, 12"))]
    for column, end in zip(columns, ends):
        figure.join(column, "bottom", end, "top")
    for k in range(2):
        figure.arrow([(275 + 180 * k, 58), (285 + 180 * k, 58)])
    figure.arrow([(565, 42), (565, 22)], colour=RED)
    figure.text(558, 20, "none: case 4, SL(2)", anchor="end", colour=RED)
    return figure


def lame():
    figure = Figure(285, "The values of n for which the identity component can be abelian")
    left, scale = 175, 142

    def at(n):
        return left + (n + 0.5) * scale

    rows = ((1, "*n* in *Z*", "always (2)", GREEN), (2, "*n* + ½ in *Z*", "*Q*_{m} = 0 (3)", BLUE), (4, "*n* + ½ = *k*/4", "*S*_{4} (4)", VIOLET),
            (3, "*n* + ½ = *k*/3", "*S*_{4}, *A*_{5} (4)", VIOLET), (5, "*n* + ½ = *k*/5", "*A*_{5} (4)", VIOLET))
    for row, (kind, name, what, colour) in enumerate(rows):
        y = 40 + 38 * row
        figure.line([(at(-0.5), y), (at(2.6), y)], width=0.7)
        figure.text(8, y - 2, name, anchor="start", size=13)
        figure.text(22, y + 14, what, anchor="start", size=13, colour=colour)
        if kind == 1:
            values = [(n, False) for n in range(3)]
        elif kind == 2:
            values = [(m - 0.5, m == 0) for m in range(4)]
        else:
            values = [(k / kind - 0.5, k / kind < 0.5) for k in range(1, 3 * kind + 1) if math.gcd(k, kind) == 1]
            values = [(n, n in never(kind)) for n, _ in values]
        for n, hollow in values:
            figure.point(at(n), y, colour=colour, open=hollow)
    y = 230
    figure.arrow([(at(-0.5) - 8, y), (at(2.6) + 8, y)])
    for n, name in ((-0.5, "−½"), (0, "0"), (0.5, "½"), (1, "1"), (1.5, "3/2"), (2, "2"), (2.5, "5/2")):
        figure.line([(at(n), y - 4), (at(n), y + 4)])
        figure.text(at(n), y + 20, name, size=13)
    figure.text(at(2.6) + 8, y - 8, "*n*", anchor="end")
    figure.text(320, 276, "Full dots: for all, or at most for some *B*, *g*_{2}, *g*_{3} (disc ≠ 0); circles, other *n*: never, SL(2).", size=13)
    return figure


def never(kind):
    """The n of lame.md 4.3 at which no growth exponent is a natural number."""
    return {3: [1 / 3 - 0.5], 4: [1 / 4 - 0.5], 5: [1 / 5 - 0.5, 2 / 5 - 0.5]}[kind]


def local_exponents():
    figure = Figure(295, "Kinds of places by the order of the pole of r")
    y = 115
    figure.arrow([(20, y), (628, y)])
    figure.text(20, y - 22, "order of the pole of *r* at the place:", anchor="start")
    kinds = ((GREY, 8, 74, (45,), ["ordinary", "0, 1"]), (BLUE, 92, 86, (130,), ["0, 1", "log (1.2)"]),
             (BLUE, 188, 132, (245,), ["(1 ± Δ)/2  (1.3)", "log? (1.4)"]),
             (RED, 338, 294, (430, 570), ["even, 2*ν* (1.5): exp(±∫[√*r*]) *t*^{α}(1 + …)", "*α* = (*ν* ± *ε*)/2"]),
             (ORANGE, 338, 294, (360, 500), ["odd, *k* (1.6): exp(±*Q*(*t*^{1/2})) *t*^{k/4}(1 + …)", "exchanged: no exponential solution"]))
    for colour, left, width, places, lines in kinds:
        top = 15 if colour == ORANGE else 172
        figure.box(left, top, width, lines, height=52, colour=colour, size=13)
        for x in places:
            figure.arrow([(x, y - 8), (x, top + 52)] if colour == ORANGE else [(x, y + 28), (x, top)], colour=colour)
    for k, x in enumerate((45, 130, 245, 360, 430, 500, 570)):
        figure.point(x, y, str(k), colour=GREY if not k else BLUE if k < 3 else ORANGE if k % 2 else RED, dy=22)
    figure.text(165, 248, "regular: exponents of the solutions", size=13)
    figure.text(485, 248, "irregular: formal solutions", size=13)
    figure.text(320, 282, "Infinity is *t* = 0 of *t*^{−4} *r*(1/*t*), of order 4 − *o*.  The exponents bound the degrees (2, 3).", size=13)
    return figure


def loop_certificates():
    figure = Figure(270, "Two closed polygons from one base and the enclosure of an entry")
    base = (175, 215)
    for side, name in ((-1, "*A*"), (1, "*B*")):
        points = [base] + [(base[0] + side * a, base[1] - b) for a, b in ((25, 90), (20, 135), (55, 165), (105, 150), (110, 95), (70, 60))] + [base]
        figure.line(points, colour=BLUE)
        for point in points[1:-1]:
            figure.point(*point, colour=BLUE, radius=2.5)
        figure.point(base[0] + side * 65, base[1] - 112, colour=RED)
        figure.text(base[0] + side * 132, base[1] - 130, name)
    figure.point(*base, "base", colour=GREY, radius=5, dy=22)
    figure.text(175, 260, "continued along the polygons (3)", size=13)
    figure.arrow([(315, 120), (370, 120)])
    x, y = 420, 150
    figure.axes(x, y, 185, 105, left=35, down=35)
    figure.raw(f'<rect x="{x + 85}" y="{y - 75}" width="44" height="36" fill="{GREEN}" fill-opacity="0.3" stroke="{GREEN}"/>')
    figure.text(x + 107, y - 84, "an enclosure")
    figure.point(x, y, "0", dx=-12, dy=18)
    figure.texts(495, 212, ["it does not contain 0:", "the group is SL(2) up to scalars,", "or its component not abelian (4)"])
    return figure


def mechanics():
    figure = Figure(300, "From a vector field to an equation of order two and back to a verdict")
    first = [("*X*, relations", "prime ideal (1)"), ("manifold *N*", "invariant (4)"), ("phase curve *Γ*", "*N* with levels (4)")]
    second = [("*ξ'* = *J ξ*", "along *Γ* (5)"), ("*y'* = *C y*", "normal part (5)"), ("*y*_{zz} = *r y*", "*z* = *φ* on *Γ* (6)")]
    above = [figure.box(20 + 215 * k, 15, 170, list(lines), height=54) for k, lines in enumerate(first)]
    below = [figure.box(450 - 215 * k, 110, 170, list(lines), height=54, colour=VIOLET) for k, lines in enumerate(second)]
    for boxes, side, towards in ((above, "right", "left"), (below, "left", "right")):
        for one, other in zip(boxes, boxes[1:]):
            figure.join(one, side, other, towards)
    figure.join(above[2], "bottom", below[0], "top")
    group = figure.box(20, 205, 170, ["*G*^{0} abelian?", "*G*: group of *r*"], height=54, colour=ORANGE)
    figure.join(below[2], "bottom", group, "top")
    not_integrable = figure.box(300, 190, 325, ["not integrable, in a class of integrals (6)"], height=34, colour=RED)
    nothing = figure.box(300, 240, 325, ["no obstruction: nothing follows"], height=34, colour=GREY)
    figure.arrow([group.side("right", 0.3), (245, group.side("right", 0.3)[1]), (245, 207), not_integrable.side("left")])
    figure.arrow([group.side("right", 0.7), (245, group.side("right", 0.7)[1]), (245, 257), nothing.side("left")])
    figure.text(272, 199, "no", size=13)
    figure.text(272, 275, "yes", size=13)
    return figure


def calculus():
    figure = Figure(250, "Rules say, one function makes facts")
    data = figure.box(10, 20, 150, ["the data of a step"], height=40, size=13)
    earlier = figure.box(10, 100, 150, ["earlier facts:", "uses, trusts apart"], height=54, colour=GREY, size=13)
    rule = figure.box(230, 52, 150, ["a rule checks,", "and says something"], height=54, size=13)
    derive = figure.box(450, 52, 180, ["one function adds", "uses and trusts of all", "that was looked at"], height=74, colour=ORANGE, size=13)
    figure.join(data, "right", rule, "left")
    figure.join(earlier, "right", rule, "left")
    figure.join(rule, "right", derive, "left")
    figure.arrow([(160, 140), (420, 140), (420, 115), (450, 115)])
    fact = figure.box(450, 176, 180, ["a fact, on a region"], height=40, colour=GREEN, size=13)
    cover = figure.box(230, 176, 150, ["cover: each point", "is in some region"], height=54, colour=VIOLET, size=13)
    said = figure.box(10, 183, 150, ["the statement"], height=40, colour=GREEN, size=13)
    figure.join(derive, "bottom", fact, "top")
    figure.join(fact, "left", cover, "right")
    figure.join(cover, "left", said, "right")
    return figure


FIGURES = {make.__name__: make for make in (
    algebraic_solution, calculus, canonical, certificates, classify, composition, confluent, descent, dihedral_torsion, integrals,
    invariants_one_point, jet_certificates, kimura, kovacic1986, lame, local_exponents, loop_certificates, mechanics)}

if __name__ == "__main__":
    run(FIGURES, pathlib.Path(__file__).resolve().parent)
