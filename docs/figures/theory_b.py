#!/usr/bin/env python3
"""Figures of docs/theory, the pages from moves to work; theory_a.py has those before them.

usage: python3 docs/figures/theory_b.py [FOLDER]

Writes docs/figures/NAME.svg (or FOLDER/NAME.svg); what is committed is what this writes (tests/documents/figures_test.py).
"""

import decimal
import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from svg import BLUE, GREEN, GREY, ORANGE, RED, VIOLET, Figure, run  # noqa: E402


def normal_form():
    f = Figure(262, "The closed subgroups of SL(2)")
    top = f.box(270, 14, 100, ["*G* ⊆ SL(2)"], colour=GREY)
    kinds = [(["(1) *G* ⊆ *B*", "a stable line:", "*ω*′ + *ω*^2 = *r*, *ω* in *C*(*z*)"], 8, 196, BLUE),
             (["(2) irreducible,", "*G* ⊆ *N*(*T*)", "*D*_{∞};  *D*_n, *n* ≥ 2"], 214, 136, BLUE),
             (["(3) finite, primitive", "*A*_4~, *S*_4~, *A*_5~", "orders 24, 48, 120"], 360, 152, BLUE),
             (["(4)", "SL(2)", "all of it"], 522, 110, RED)]
    below = [(["*G*^0 = 1, *G*_{a}, *T*: abelian", "*G*^0 = *B*: not abelian"], ORANGE), (["*G*^0 = *T* or 1", "abelian"], GREEN),
             (["*G*^0 = 1", "abelian"], GREEN), (["*G*^0 = SL(2)", "not abelian"], RED)]
    f.line([top.side("bottom"), (320, 68)])
    f.line([(kinds[0][1] + kinds[0][2] / 2, 68), (kinds[3][1] + kinds[3][2] / 2, 68)])
    for (lines, x, width, colour), (said, tone) in zip(kinds, below):
        kind = f.box(x, 92, width, lines, colour=colour, size=13)
        f.arrow([(x + width / 2, 68), kind.side("top")])
        group = f.box(x, 200, width, said, colour=tone, size=13)
        f.join(kind, "bottom", group, "top")
    return f


def p_curvature():
    f = Figure(312, "What one prime proves")
    start = f.box(20, 14, 290, ["a good prime *p* ≥ 7;  *B*_p = −det *A*_p", "*B*_p den^{2p} = *b*^p, *b* a polynomial (1)"], size=13)
    zero = f.box(80, 98, 170, ["*b* = 0?"])
    remove = f.box(20, 168, 290, ["take from *b* the places that", "may exchange two lines"], size=13)
    square = f.box(20, 252, 290, ["the rest a constant times a square, and", "deg *b* even or ∞ such a place?"], size=13)
    nothing = f.box(430, 98, 200, ["nothing follows"], colour=GREY)
    allowed = f.box(430, 168, 200, ["SL(2) not proved; perhaps", "irreducible by (5)"], colour=ORANGE, size=13)
    full = f.box(430, 252, 200, ["*G* = SL(2)  (4)"], height=50, colour=GREEN)
    f.join(start, "bottom", zero, "top")
    f.join(zero, "right", nothing, "left", "yes")
    f.join(zero, "bottom", remove, "top", "no", dx=8, dy=5, anchor="start")
    f.join(remove, "bottom", square, "top")
    f.join(square, "right", allowed, "left", "yes", along=0.25, dx=-22, dy=20)
    f.join(square, "right", full, "left", "no", along=0.7, onto=0.7, dx=24)
    f.texts(530, 30, ["Case 1 makes *B*_p a square;", "finite, of order prime to *p*,", "makes it 0 (Theorem P)."], size=13)
    return f


def henon_errors(start, count):
    """Henon's map of the plane in double precision, twice, and in 80 digits: the estimate and the error at each step."""
    decimal.getcontext().prec = 80
    cosine = decimal.Decimal("0.24")
    sine = (1 - cosine * cosine).sqrt()

    def step(x, y, c, s):
        return x * c - (y - x * x) * s, x * s + (y - x * x) * c

    c, s = float(cosine), float(sine)
    exact, first, second = tuple(map(decimal.Decimal, start)), start, (math.nextafter(start[0], 1), start[1])
    differences, found = [], []
    for n in range(count):
        exact, first = step(*exact, cosine, sine), step(*first, c, s)
        x, y = second
        second = (c * x - s * y + s * x * x, s * x + c * y - c * x * x)  # summed in another order
        differences.append(math.dist(first, second))
        estimate = 2 * max(differences[-(n // 4 + 4):])
        error = math.hypot(float(decimal.Decimal(first[0]) - exact[0]), float(decimal.Decimal(first[1]) - exact[1]))
        found.append((estimate, error))
    return found


def point_errors():
    f = Figure(290, "Errors of the points of two orbits of a map")
    left, bottom, count = 90, 240, 330

    def place(n, value):
        return left + 480 * n / count, bottom - 12.5 * (math.log10(max(value, 1e-17)) + 17)

    f.axes(left, bottom, 500, 220)
    f.text(left + 508, bottom + 5, "*n*", anchor="start")
    for power in (-15, -10, -5, 0):
        y = place(0, 10.0 ** power)[1]
        f.line([(left - 4, y), (left, y)])
        f.text(left - 8, y + 5, "1" if power == 0 else "10^{%s}" % str(power).replace("-", "−"), anchor="end", size=13)
    for start, colour in (((0.2, 0.0), BLUE), ((-0.7, 0.48), RED)):
        found = henon_errors(start, count)
        f.line([place(n, estimate) for n, (estimate, _) in enumerate(found) if n % 6 == 0], colour=colour, width=2)
        for n in range(2, count, 13):
            f.circle(*place(n, found[n][1]), 1.5, colour=colour, width=1)
    y = place(0, 1e-3)[1]
    f.line([(left, y), (left + 480, y)], dash="4 4")
    f.text(left + 8, y - 5, "above: drawn lighter, statistical", anchor="start", size=13)
    f.text(left + 90, 90, "a chaotic orbit", colour=RED, anchor="start")
    f.text(left + 300, 198, "a regular orbit", colour=BLUE, anchor="start")
    f.text(left + 240, 272, "lines: the estimate from a second run;  circles: the error, by 80 digits", size=13)
    return f


def pullback():
    f = Figure(250, "From a named equation to E")
    a = f.box(12, 20, 170, ["*S*: *u*″ = *R*(*x*) *u*", "Airy, Weber, Whittaker,", "Bessel, Riemann"], colour=GREEN, size=13)
    b = f.box(262, 20, 150, ["*U*″ = *r*_1 *U*", "*U* = *u*(*f*) / √*f*′"], height=68, size=13)
    c = f.box(500, 20, 128, ["*E*: *y*″ = *r* *y*", "group SL(2)"], height=68, size=13)
    f.join(a, "right", b, "left", "*x* = *f*(*z*)")
    f.join(b, "right", c, "left", "gauge (1)")
    f.text(320, 112, "*r*_1 = *f*′^2 *R*(*f*) − *S*(*f*)/2", size=13)
    f.text(537, 112, "*y* = *αU* + *βU*′", size=13)
    steps = [(["*f* from irregular", "places (3), or from", "the fibres (6)"], 12, 140), (["the constants", "of *S* (4)"], 177, 110),
             (["bounds of *α*, *β* (2):", "a linear system"], 312, 150), (["differentiate twice:", "the proof"], 487, 141)]
    boxes = [f.box(x, 150, width, lines, height=68, colour=GREEN if "proof" in lines[-1] else BLUE, size=13) for lines, x, width in steps]
    for one, other in zip(boxes, boxes[1:]):
        f.join(one, "right", other, "left")
    f.text(320, 241, "What is not found is not excluded: the group stays SL(2).", size=13)
    return f


def quadratures():
    f = Figure(290, "One integral, and a second one above it")
    names = [(["*K* = *C*(*z*)"], 226), (["*L* = *K*(*I*),  *I*′ = *u*"], 156), (["*L*(*F*),  *F*′ = *f* in *L*"], 86),
             (["*E*, the field of VE_k"], 16)]
    boxes = [f.box(20, y, 200, lines, colour=GREY if k == 3 else BLUE) for k, (lines, y) in enumerate(names)]
    for one, other in zip(boxes, boxes[1:]):
        f.join(one, "top", other, "bottom")
    f.text(132, 209, "*u* is no derivative in *K*", anchor="start", size=13)
    ask = f.box(330, 20, 280, ["first *k* at which some *f* of Φ^{−1}*S*_k", "is no derivative in *L*"], size=13)
    test = f.box(360, 116, 220, ["is d*f*/d*I* a derivative", "in *L* for all these *f*?"], size=13)
    no = f.box(300, 216, 170, ["identity component", "of *G*_k not abelian"], colour=GREEN, size=13)
    yes = f.box(490, 216, 140, ["nothing follows,", "the search ends"], colour=GREY, size=13)
    f.join(ask, "bottom", test, "top")
    f.join(test, "bottom", no, "top", "no", along=0.2, dx=-16, dy=8)
    f.join(test, "bottom", yes, "top", "yes", along=0.8, dx=20, dy=8)
    f.text(470, 284, "not abelian (some *k*): not integrable", size=13)
    return f


def recognition():
    f = Figure(306, "Which classical equation")
    start = f.box(10, 120, 130, ["*y*″ = *r*(*z*) *y*", "its places"], size=14)
    rows = [(["three regular places,", "no others (2)"], ["Riemann", "kimura.md"]),
            (["four regular places,", "Δ^2 = ¼ at three of them (3, 4)"], ["Lamé", "lame.md"]),
            (["one irregular place,", "at most one regular (6)"], ["Whittaker, Bessel, ...", "confluent.md"])]
    for k, (asked, name) in enumerate(rows):
        y = 14 + 76 * k
        a = f.box(200, y, 220, asked, height=50, size=13)
        b = f.box(484, y, 146, name, height=50, colour=GREEN, size=13)
        f.arrow([(140, 145), (170, 145), (170, y + 25), (200, y + 25)])
        f.join(a, "right", b, "left", "= ?")
    f.box(200, 242, 220, ["a function of (*z* − *c*)^2 (5)"], height=44, colour=ORANGE, size=13)
    f.arrow([(140, 145), (170, 145), (170, 264), (200, 264)])
    f.arrow([(200, 278), (75, 278), (75, 170)])
    f.text(80, 298, "*w* = (*z* − *c*)^2, once more", anchor="start", size=13)
    f.text(545, 262, "= ?  the equation is", size=13)
    f.text(545, 280, "built again and compared", size=13)
    return f


def riccati_one_place():
    f = Figure(270, "Two lines at one place, modulo one prime")
    top = f.box(150, 12, 340, ["*ω* has a reduction mod *p* (1); *S* = *t*^ν *ω*"], size=13)
    for k, (x, sign) in enumerate(((20, "+"), (330, "−"))):
        line = f.box(x + 55, 76, 180, ["the line *S*_0 with " + sign + "δ (2)"], size=13)
        f.join(top, "bottom", line, "top", along=0.25 + 0.5 * k)
        log = f.box(x, 140, 135, ["*i* " + sign + " δ = 0, the right", "side is not 0 (2)"], colour=RED, size=13)
        long = f.box(x + 155, 140, 135, ["too long for *A*/*B*:", "complexity > *L* (4)"], colour=RED, size=13)
        f.join(line, "bottom", log, "top", along=0.2)
        f.join(line, "bottom", long, "top", along=0.8)
        f.text(x + 145, 166, "or", size=13)
    f.box(160, 220, 320, ["both lines removed: no exponential solution (5)"], colour=GREEN, size=13, height=36)
    for x in (88, 243, 398, 553):
        f.line([(x, 190), (x, 204)])
    f.line([(88, 204), (553, 204)])
    f.arrow([(320, 204), (320, 220)])
    return f


def second_solution():
    f = Figure(282, "How two solutions are written")
    rows = [(["one line: *y*′/*y* = *ω* in *K*(*z*)"], ["*y*  and  *y* ∫ *y*^{−2}   (1)"], 16),
            (["two lines, *v* = *y*_1*y*_2 in *K*(*z*)"], ["√*v* exp(± (*w*/2) ∫ 1/*v*)   (5)"], 112),
            (["two lines exchanged: *D*_{∞}, *D*_n"], ["*F*^{1/4} exp(± ½ ∫ 1/(*gT*))   (6)"], 196)]
    boxes = []
    for asked, written, y in rows:
        a = f.box(10, y, 240, asked, height=40, size=13)
        b = f.box(300, y, 240, written, height=40, colour=GREEN, size=13)
        f.join(a, "right", b, "left")
        boxes.append(b)
    f.arrow([(420, 56), (420, 78)])
    f.text(330, 94, "∫: reduced (2, 3); then erf, erfi, Ei, log (4)", size=13, anchor="start")
    f.arrow([(420, 236), (420, 256)])
    f.text(300, 273, "finite:  *F*^{1/4} *h*^{±1/(2n)}", anchor="start")
    f.text(10, 273, "*F* = *v*^2,  *T*^2 = *kF*_0/*w*^2", anchor="start", size=13)
    return f


def spectrum():
    f = Figure(330, "The oscillator")
    x0, zero, unit = 222, 206, 24

    def height(energy):
        return zero - unit * energy

    f.axes(x0, zero, 210, 196, "*z*", "", left=210, down=100)
    f.text(x0 + 12, 20, "*E*", anchor="start")
    f.curve(lambda z: (x0 + 70 * z, height(z * z)), -2.75, 2.75, 40, colour=GREY, dash="5 4")
    f.text(x0 - 196, 40, "*z*^2", anchor="end")
    for n, hermite in enumerate((lambda z: 1, lambda z: 1.4 * z, lambda z: 0.7 * (2 * z * z - 1))):
        level = height(2 * n + 1)
        f.line([(x0 - 200, level), (x0 + 200, level)], colour=BLUE, width=1)
        f.curve(lambda z, h=hermite, b=level: (x0 + 70 * z, b - 18 * h(z) * math.exp(-z * z / 2)), -2.8, 2.8, 40, colour=RED)
        name = ("exp(−*z*^2/2)", "*z* exp(−*z*^2/2)", "(2*z*^2 − 1) exp(−*z*^2/2)")[n]
        f.text(x0 + 206, level + 5, f"*E* = {2 * n + 1}:  *y* = {name}", anchor="start", size=13)
    for n in (1, 3):
        level = height(-n)
        f.line([(x0 - 200, level), (x0 + 200, level)], colour=ORANGE, width=1.5, dash="6 4")
        f.text(x0 + 206, level + 5, f"*E* = −{n}:  *y* = " + ("exp(*z*^2/2)" if n == 1 else "*z* exp(*z*^2/2)"), anchor="start", size=13)
    f.text(320, 324, "and so on for every odd *E*; for all other *E* the group is SL(2)", size=13)
    return f


def strata():
    f = Figure(262, "The strata of y'' = (a z + b) y")
    f.axes(120, 130, 105, 100, "*a*", "*b*", left=105, down=100)
    f.line([(120, 40), (120, 220)], colour=BLUE, width=3)
    f.point(120, 130, colour=RED, radius=6)
    f.text(62, 80, "*a* ≠ 0", colour=GREEN)
    f.text(178, 80, "*a* ≠ 0", colour=GREEN)
    f.text(120, 255, "the plane of (*a*, *b*)", size=13)
    top = f.box(392, 12, 110, ["*a* = 0 ?"], colour=GREY)
    airy = f.box(270, 88, 150, ["*a* ≠ 0: SL(2)", "Airy's equation"], colour=GREEN, size=13)
    ask = f.box(480, 92, 110, ["*b* = 0 ?"], colour=GREY)
    torus = f.box(340, 176, 150, ["*a* = 0, *b* ≠ 0:", "*y* = exp(± √*b* *z*)"], colour=BLUE, size=13)
    none = f.box(510, 176, 122, ["*a* = *b* = 0:", "*y* = 1, *z*"], colour=RED, size=13)
    f.join(top, "bottom", airy, "top", "no", along=0.25)
    f.join(top, "bottom", ask, "top", "yes", along=0.75)
    f.join(ask, "bottom", torus, "top", "no", along=0.25)
    f.join(ask, "bottom", none, "top", along=0.75)
    f.text(590, 146, "yes")
    f.text(470, 255, "disjoint, and they cover every (*a*, *b*)", size=13)
    return f


def strata_certificates():
    f = Figure(262, "The tree of a certificate")
    top = f.box(215, 12, 210, ["node: split", "*p* = *a*"], size=13)
    no = f.box(30, 100, 220, ["nonzero: *a* is known ≠ 0", "leaf, abelian: no", "by torus (7)"], colour=RED, size=13)
    zero = f.box(385, 100, 240, ["zero: solve *a* = 0", "*r* becomes 0", "leaf, abelian: yes, by number (6)"], colour=GREEN, size=13)
    f.join(top, "bottom", no, "top", "*a* ≠ 0", along=0.3)
    f.join(top, "bottom", zero, "top", "*a* = 0", along=0.7)
    for box in (no, zero):
        f.line([box.side("bottom"), (box.x + box.width / 2, 184)])
    f.line([(140, 184), (505, 184)])
    f.arrow([(320, 184), (320, 204)])
    f.box(110, 204, 420, ["two checkers: every leaf from its own data, no search",
                          "accepted (2 strata: 1 abelian, 1 not abelian)"], size=13, colour=GREY)
    f.text(320, 100, "*y*″ = *az* *y*")
    return f


def system_certificates():
    f = Figure(290, "From the system to r, by identities")
    rows = [[(["the system (3)", "bracket, *H*, *x*′ = *X*(*x*)"], BLUE), (["the curve *x*(*z*) (4)", "*Dx* = *T X*(*x*)"], BLUE),
             (["covectors *λ*_l (5)", "cut out a subsystem"], BLUE)],
            [(["the class of first", "integrals (7)"], ORANGE), (["*r* = *p*^2/4 + *Dp*/2 − *q*", "*y*″ = *r* *y* (5)"], BLUE),
             (["one covector *w* (5):", "∇∇*w* + *p*∇*w* + *qw*", "= Σ rest_l *λ*_l"], BLUE)]]
    places = [[f.box(12 + 216 * k, 16 + 104 * j, 184, lines, height=68, colour=colour, size=13) for k, (lines, colour) in enumerate(row)]
              for j, row in enumerate(rows)]
    (system, curve, rest), (kind, equation, row) = places
    inner = f.box(228, 226, 184, ["certificate of *y*″ = *r* *y*:", "not abelian (6)"], colour=GREEN, size=13)
    end = f.box(12, 226, 184, ["not integrable", "in this class"], colour=GREEN, size=13)
    f.join(system, "right", curve, "left")
    f.join(curve, "right", rest, "left")
    f.join(rest, "bottom", row, "top")
    f.join(row, "left", equation, "right")
    f.join(equation, "bottom", inner, "top")
    f.join(inner, "left", end, "right")
    f.join(kind, "bottom", end, "top")
    f.texts(536, 240, ["trusted, by name:", "Morales-Ruiz and Ramis;", "Ayoul and Zung"], size=13)
    return f


def theorem_certificates():
    f = Figure(330, "Steps, facts and the cover")
    steps = [("certificate (5)", "*N*", BLUE), ("literature (5, 9)", "*N*", ORANGE), ("splitting (6)", "*N*", BLUE),
             ("lowest-order (7)", "*N* from *N*", BLUE),
             ("integrals (5)", "*I*", GREEN), ("symmetry (4)", "*S*", VIOLET)]
    boxes = [f.box(10, 14 + 44 * k, 210, [f"{name}:  {fact}"], colour=colour, size=13) for k, (name, fact, colour) in enumerate(steps)]
    place = f.box(300, 90, 130, ["place (4)", "a fact about *Y*", "is one about *X*"], size=13)
    cover = f.box(500, 90, 130, ["cover (8)", "all parameters", "lie in a region"], colour=GREEN, size=13)
    for box in boxes[:5]:
        y = box.y + box.height / 2
        f.line([(220, y), (260, y)])
    f.line([(260, 30), (260, boxes[4].y + 16)])
    f.arrow([(260, place.y + 34), (300, place.y + 34)])
    f.join(place, "right", cover, "left")
    f.arrow([boxes[5].side("right"), (565, boxes[5].y + 16), (565, 158)])
    f.text(400, boxes[5].y + 10, "maps regions to regions", size=13)
    f.texts(10, 292, ["*N*: not integrable in a class, on a region;  *I*: first integrals, on a region;  *S*: a symmetry.",
                      "The cover: not integrable, except possibly in the regions of the parts *I*."], anchor="start", size=13)
    return f


def trichotomy():
    f = Figure(330, "The trichotomy")
    one = f.box(10, 16, 210, ["a place of order ≥ 3,", "or an irrational Δ?"], size=13)
    two = f.box(10, 116, 210, ["a logarithm?"], height=50, size=13)
    three = f.box(10, 216, 210, ["regular, Δ rational,", "no logarithm"], size=13)
    f.join(one, "bottom", two, "top", "no", dx=8, dy=5, anchor="start")
    f.join(two, "bottom", three, "top", "no", dx=8, dy=5, anchor="start")
    asked = [(one, ["(T1) Sym^4 has an", "invariant?"], "yes"), (two, ["(T2) an exponential", "solution?"], "yes"),
             (three, ["(T3) reducible, or Sym^{12}", "has an invariant?"], "")]
    yes = f.box(530, 60, 100, ["*G*^0 is", "abelian"], colour=GREEN, height=60)
    no = f.box(530, 196, 100, ["not", "abelian"], colour=RED, height=60)
    for k, (box, lines, word) in enumerate(asked):
        middle = box.y + box.height / 2
        question = f.box(275, middle - 25, 190, lines, height=50, size=13)
        f.join(box, "right", question, "left", word)
        f.line([question.side("right", 0.25), (495, question.y + 12.5)], colour=GREEN)
        f.line([question.side("right", 0.75), (512, question.y + 37.5)], colour=RED)
    f.line([(495, 28.5), (495, 228.5)], colour=GREEN)
    f.line([(512, 53.5), (512, 253.5)], colour=RED)
    f.arrow([(495, 90), (530, 90)], colour=GREEN)
    f.arrow([(512, 226), (530, 226)], colour=RED)
    f.text(480, 22, "yes", size=13, colour=GREEN)
    f.text(480, 70, "no", size=13, colour=RED)
    f.texts(10, 294, ["Not abelian: SL(2), or after (T1) the full Borel group.",
                      "After (T2) abelian means *T*_n, all of *G*_{a} with a character of order *n*."], anchor="start", size=13)
    return f


def whittaker_pull_back():
    f = Figure(310, "A covering by f = z - 1/z")
    f.text(320, 20, "*f* = *z* − 1/*z*")
    f.path("M120,90 a200,45 0 1,0 400,0 a200,45 0 1,0 -400,0", colour=BLUE, fill=BLUE, opacity=0.1)
    f.path("M120,240 a200,40 0 1,0 400,0 a200,40 0 1,0 -400,0", colour=GREEN, fill=GREEN, opacity=0.1)
    f.text(60, 86, "*z*-sphere")
    f.text(60, 104, "*E*: *y*″ = *r* *y*", size=13)
    f.text(60, 236, "*x*-sphere")
    f.text(60, 254, "*W*", size=13)
    for x, below, name, colour in ((205, 230, "1", BLUE), (255, 230, "−1", BLUE), (385, 410, "0", RED), (435, 410, "∞", RED)):
        f.line([(x, 90), (below, 236)], dash="3 4")
        f.point(x, 88, name, colour=colour)
    for x, name in ((305, "*i*"), (340, "−*i*")):
        f.point(x, 96, name, colour=ORANGE, open=True)
    f.point(230, 238, "", colour=BLUE)
    f.text(230, 258, "0")
    f.point(410, 238, "", colour=RED)
    f.text(410, 258, "∞")
    f.arrow([(320, 150), (320, 195)], "*f*", dx=14, dy=5)
    f.text(140, 172, "zeros of *f*", size=13)
    f.text(140, 188, "regular places", size=13)
    f.text(524, 172, "poles of *f*, orders *l*:", size=13)
    f.text(524, 188, "irregular places", size=13)
    f.text(320, 302, "open circles: *f*′ = 0, where Δ = 2 without a logarithm", size=13)
    return f


def work():
    f = Figure(250, "How classify divides its work")
    parts = [(0.30, "30 %", "manifolds of the file", BLUE), (0.05, "5 %", "canonical variables", GREEN),
             (0.02, "2 %", "symmetries", ORANGE),
             (0.15, "15 %", "rounds in the variables of the file", VIOLET), (0.60, "60 %", "rounds in simpler variables", RED)]
    left, length, y = 20.0, 600.0, 34
    f.text(20, 22, "the whole work", anchor="start")
    for share, percent, name, colour in parts:
        width = share * length
        f.raw(f'<rect x="{left:.1f}" y="{y}" width="{width:.1f}" height="24" fill="{colour}" fill-opacity="0.7"/>')
        f.raw(f'<rect x="{left:.1f}" y="{y}" width="{length:.1f}" height="24" fill="none" stroke="{GREY}"/>')
        if left + width < 400:
            f.text(left + width + 8, y + 17, f"{percent}  {name}", anchor="start", size=13)
        else:
            f.text(left - 8, y + 17, f"{percent}  {name}", anchor="end", size=13)
        left, length, y = left + width, length - width, y + 36
    f.text(620, y + 14, "a bar: what the parts above have left, if each uses up its own", anchor="end", size=13)
    return f


def moves():
    f = Figure(282, "A family, carried by a frame")
    cx, cy, radius = 130, 140, 88
    f.axes(cx, cy, 115, 112, "*x*", "*y*", left=115, down=112)
    f.circle(cx, cy, radius, dash="4 4")
    px, py = cx + radius * math.cos(1.0), cy - radius * math.sin(1.0)
    f.point(px, py, "*p* = (*x*, *y*)", colour=BLUE, dx=12, dy=-8, anchor="start")
    f.point(cx + radius, cy, "*p*′ = (*r*, 0)", colour=RED, dx=6, dy=22, anchor="start")
    f.curve(lambda t: (cx + radius * math.cos(t), cy - radius * math.sin(t)), 0.95, 0.12, 16, colour=BLUE, width=2.5)
    f.arrow([(cx + radius * math.cos(t), cy - radius * math.sin(t)) for t in (0.14, 0.06)], colour=BLUE)
    f.point(cx, cy, "", colour=GREEN, radius=6)
    f.texts(cx - 8, cy + 22, ["integrable", "only here"], anchor="end", size=13)
    f.text(cx, 275, "*r*^2 = *x*^2 + *y*^2", size=13)
    rows = [(["symmetries and frames (2): *X*(*p*) is", "*X*(*p*′) in other variables, checked by (1)"], BLUE),
            (["perturbed free bodies (3): small *p*,", "then all *p* by a change of scale"], ORANGE),
            (["part of lowest order (4): integrals near", "the origin; of highest: rational integrals"], VIOLET)]
    for k, (lines, colour) in enumerate(rows):
        f.box(325, 24 + 82 * k, 305, lines, height=56, colour=colour, size=13)
    return f


FIGURES = {make.__name__: make for make in (
    moves, normal_form, p_curvature, point_errors, pullback, quadratures, recognition, riccati_one_place, second_solution, spectrum, strata,
    strata_certificates, system_certificates, theorem_certificates, trichotomy, whittaker_pull_back, work)}

if __name__ == "__main__":
    run(FIGURES, pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent)
