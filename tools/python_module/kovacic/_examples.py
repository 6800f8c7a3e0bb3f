"""Examples of the values that compiled classes have, shown by help() below what they mean.  @ is the value of the class.
S is a System, text that of a system file with one manifold, theorem a TheoremResult about it, orbits the FixedPoints of a free
top; tests/python/section_test.py runs all of them."""

import re

TEXT = r"""
Accepted: kovacic.verify(kovacic.solve("z", certificate=True).certificate)
    @.trusted_steps -> 0
    len(@.statement) -> 2
BlockReport: kovacic.check(text).manifolds[0].blocks[0]
    @.unknowns -> ['x', 'u']
    @.unknown -> 'x'
    @.change -> 'z = v'
    @.r -> MFraction('(-14*z^2 + 12)/(9*z^4 - 36*z^2 + 36)')
    @.answer -> <Decision: G = SL(2, C), identity component SL2, not abelian>
    @.abelian -> Truth.no
    @.merging -> []
    @.levels -> []
    @.note -> ''
ByEngines: kovacic.solve("z + 1/z").because
    @.argument -> Argument.torus_no_line
    @.kind -> Trichotomy.irregular_or_irrational
    @.place -> 'infinity'
    @.exponential is None -> True
    @.pair is None -> True
    @.invariants -> []
    @.no_invariants -> [4]
    @.no_exponential -> 'the order of r at infinity is odd (-1), so that no exponential solution exists'
    @.p_curvature is None -> True
    @.undecided is None -> True
    @.reason[:24] -> 'the equation is irregula'
CheckReport: kovacic.check(text)
    @.verdict -> VerdictKind.non_integrable
    @.complete -> True
    @.integrals -> 'meromorphic'
    @.title -> 'a Hamiltonian system'
    @.file -> 'text'
    @.values -> {}
    @.assumptions -> []
    @.claims -> []
    @.manifolds -> [<ManifoldReport M: non-integrable>]
    @.together -> <Classification: non-integrable>
    len(@.certificates) -> 1
    @.seconds >= 0 -> True
Classification: S.classify()
    @.status -> ClassificationStatus.depends
    @.statement[:24] -> 'The system is integrable'
    len(@.strata) -> 7
    @.integrals_class[:24] -> 'meromorphic also at the '
    @.almost_all is None -> True
    @.assumptions -> []
    @.theorems -> ['Morales-Ruiz and Ramis (2001)', 'Morales-Ruiz, Ramis and Simo (2007)']
    len(@.trusted_steps) -> 3
    @.notes -> []
    len(@.stages) -> 5
    @.complete -> True
    @.seconds >= 0 -> True
ClassifiedStratum: S.classify().strata[0]
    @.conditions -> ['b = 1']
    @.status -> StratumStatus.integrable
    len(@.integrals) -> 2
    @.fields -> []
    @.by -> []
    @.open_after -> []
Decision: kovacic.solve("z^2 + 3")
    @.r -> RationalFunction('z^2 + 3')
    @.headline[:24] -> 'G = the full Borel group'
    @.variable -> 'z'
    @.group -> GaloisGroup('Borel')
    @.component -> Connected.borel
    @.abelian -> Truth.no
    @.kovacic_case -> 1
    type(@.because).__name__ -> 'ByEngines'
    @.reason[:24] -> 'the equation is irregula'
    @.undecided is None -> True
    @.withdrawn is None -> True
    @.second_opinion is None -> True
    @.liouvillian -> [LiouvillianSolution('z*exp(z^2/2)')]
    @.basis -> ('z*exp(z^2/2)', 'z*exp(z^2/2)*((-1/z)*exp(-z^2) - sqrt(pi)*erf(z))')
    @.polynomial_of_y is None -> True
    @.no_solutions is None -> True
    @.only_case is None -> True
    @.trace -> []
    @.certificate is None -> True
    @.no_certificate -> ''
    @.refused -> ''
    @.seconds >= 0 -> True
ExclusionReason: [s for s in S.classify().strata if s.by][0].by[0]
    @.solution -> 'q1 = 0, p1 = 0'
    @.level -> 'all levels of the first integrals except special ones'
    @.order -> 1
    @.reason[:24] -> 'variation of q1, p1: wit'
    @.theorems -> ['Morales-Ruiz and Ramis (2001)']
    @.trusted -> ['the classical criterion of a known equation, without a certificate']
    @.not_checked -> ''
    @.statement[:24] -> 'not integrable with firs'
    @.integrals_class[:24] -> 'meromorphic also at the '
FoundIntegral: kovacic.integrals(S, 3).sets[0].integrals[0]
    @.value -> MFraction('(6*q1^2*q2 + 2*q2^3*b + 3*p1^2 + 3*p2^2)/6')
    @.logarithms -> []
    @.degree -> 2
    @.casimir -> False
    @.hamiltonian -> True
FoundManifold: S.find_manifolds()[0]
    @.equations -> ['q1 = 0', 'p1 = 0']
    @.kind -> 'coordinate subspace'
    @.dimension -> 2
    @.leaf_dimension -> 1
    @.equilibria -> False
GaloisGroup: kovacic.solve("z").group
    @.type -> GroupType.SL2
    @.n is None -> True
    @.identity_component -> Connected.sl2
    @.kovacic_case -> 4
IntegralSearch: kovacic.integrals(S, 3)
    @.searched -> ''
    @.sets -> [<IntegralsOfSet b - 1 = 0: 2>, <IntegralsOfSet b - 6 = 0: 2>]
    @.elsewhere -> <IntegralsOfSet everywhere: 1>
    @.not_covered -> []
    @.assumed -> []
    @.assumed_equations -> []
    @.finished -> True
IntegralsOfSet: kovacic.integrals(S, 3).sets[0]
    @.searched -> 'polynomials of degree <= 3 in the momenta'
    @.equations -> ['b - 1']
    @.inequations -> []
    len(@.integrals) -> 2
    @.commuting -> [0, 1]
    @.liouville -> True
    @.only_declared_relations -> False
    @.complete -> True
    @.complete_for_smooth -> True
    @.values[1] -> MFraction('q1^3 + 3*q1*q2^2 + 3*p1*p2')
    @.open is None -> True
LameAnswer: kovacic.lame(1, 0, 4, 0)
    @.decision -> <Decision: G = T_4 = {(c d; 0 1/c) : c^4 = 1}, identity component Ga, abelian>
    @.abelian -> Truth.yes
    @.group -> GaloisGroup('T_4')
    @.closed -> 'n = 1 is an integer and w^2 = 0: one solution is a Lame function'
LameConditions: kovacic.lame(1)
    @.n -> Fraction(1, 1)
    @.discriminant -> MFraction('g2^3 - 27*g3^2')
    @.polynomials -> []
    @.always -> True
    @.never -> False
    @.abelian -> Truth.unknown
    @.reducible -> MFraction('4*B^3 - B*g2 - g3')
    @.octahedral -> []
LameFamily: kovacic.lame("m")[0]
    @.numerator -> 1
    @.denominator -> 1
    @.which -> 'j odd (n an integer): always'
LiouvillianSolution: kovacic.solve("z^2 + 3").liouvillian[0]
    @.y -> 'z*exp(z^2/2)'
    @.minimal_polynomial -> []
    @.omega -> RationalFunction('(z^2 + 1)/z')
    @.note -> ''
    @.generator is None -> True
MFraction: kovacic.solve("z^2 + a", parameters="a").r
    @.names -> ['a', 'z']
ManifoldReport: kovacic.check(text).manifolds[0]
    @.name -> 'M'
    @.verdict -> VerdictKind.non_integrable
    @.failure is None -> True
    @.by -> <TheoremUsed Morales-Ramis>
    @.integrals -> 'meromorphic'
    @.statement -> "not integrable in Liouville's sense with first integrals that are meromorphic"
    @.not_checked is None -> True
    len(@.reasons) -> 1
    @.blocks -> [<BlockReport>]
    @.matrices is None -> True
    @.notes -> []
    @.trusted_steps -> []
    @.not_studied is None -> True
    @.headline[:24] -> 'NON-INTEGRABLE (Morales-'
Monodromy: kovacic.monodromy("-3/(16*z^2)")
    @.base -> ('0', '-3')
    len(@.loops) -> 1
    len(@.self_tests) -> 3
    @.proves is None -> True
    @.words is None -> True
RationalFunction: kovacic.solve("z^2 + 3").r
    @.variable -> 'z'
    @.num -> [Fraction(3, 1), Fraction(0, 1), Fraction(1, 1)]
    @.den -> [Fraction(1, 1)]
    @.generator is None -> True
Rejected: kovacic.verify(kovacic.solve("z", certificate=True).certificate.replace('"SL2"', '"Borel"'))
    @.step -> ''
    @.why -> 'the claim does not follow: group'
    @.limit -> False
Spectrum: kovacic.spectrum("x^2 - E")
    @.pieces -> [<SpectrumPiece always>]
    @.energy -> 'E'
    @.decided -> True
    @.assumptions -> []
    @.trusted_steps -> ['the conditions solved for the parameter, which have no certificate']
    @.not_studied -> []
SpectrumLevel: kovacic.spectrum("x^2 - E").pieces[0].series[0].levels[0]
    @.n -> 0
    @.fixed -> ('E', MFraction('1'))
    @.equations -> []
    @.y -> 'exp(-x^2/2)'
SpectrumPiece: kovacic.spectrum("x^2 - E").pieces[0]
    @.status -> SpectrumStatus.conditions
    @.conditions -> 'always'
    @.where -> ['E is an odd integer']
    @.series -> [<SpectrumSeries E = 2*N + 1, for some integer N>]
    @.unsolved -> []
    @.families -> []
    @.groups -> [GaloisGroup('Borel')]
    @.why -> ''
SpectrumSeries: kovacic.spectrum("x^2 - E").pieces[0].series[0]
    @.equation -> MFraction('E - 2*N - 1')
    @.value -> MFraction('2*N + 1')
    @.integer -> 'N'
    @.every_energy -> False
    len(@.levels) -> 4
StrataAnswer: kovacic.solve("z^2 + a", parameters="a")
    @.abelian -> Truth.no
    @.group is None -> True
    @.domain -> []
    @.assumed -> []
    @.unvisited -> []
    @.trusted -> []
    @.pruned -> []
    @.contradictory -> False
    @.refused -> ''
    @.decided -> True
    @.elsewhere -> []
    @.r -> MFraction('a + z^2')
    @.variable -> 'z'
    @.family -> <SymbolicFamily>
    len(@.strata) -> 2
    @.certificate[:28] -> '{"format":"kovacic-strata/1"'
    @.seconds >= 0 -> True
Stratum: kovacic.solve("z^2 + a", parameters="a").strata[0]
    @.conditions -> ['a is an odd integer']
    @.where -> 'a is an odd integer'
    @.abelian -> Truth.no
    @.group -> GaloisGroup('Borel')
    @.group_text -> 'the full Borel group (all triangular matrices)'
    @.reason[:24] -> 'the equation is irregula'
    type(@.because[0]).__name__ -> 'IrregularPlace'
    @.undecided is None -> True
    @.no_equation -> False
    @.trace -> []
SymbolicFamily: kovacic.solve("z^2 + a", parameters="a").family
    @.family -> 'Weber'
    @.equation -> "y'' = (u x^2 + w) y, a = w/sqrt(u)"
    @.parameters -> {'a': 'a'}
    @.generic -> []
    @.summary -> 'the identity component is never abelian'
    @.cases[0] -> ('a is an odd integer', GroupType.Borel, Truth.no)
DrawnOrbit: kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3).orbits[0]
    @.start -> [1.0, 0.0]
    @.crossings -> 3
    @.tangencies -> 0
    @.steps -> 17
    @.time >= 0 -> True
    @.drift >= 0 -> True
    @.ended -> Ended.crossings
    @.megno >= 0 -> True
    @.lyapunov >= 0 -> True
    @.fli >= 0 -> True
AlgebraicNumber: kovacic.solve("sqrt(2)*z").r.num[1]
    @.letter -> 'sqrt(2)'
    @.minpoly -> [-2, 0, 1]
    @.generator is None -> True
ByFormula: kovacic.solve("z^2 - 2001", max_degree=10).because
    @.family -> 'Weber'
    @.equation -> "y'' = (u x^2 + w) y, a = w/sqrt(u)"
    @.parameters -> {'u': '1', 'w': '-2001', 'a': '-2001'}
    @.reason -> 'a is an odd integer: one exponential solution'
    @.engines -> Unable('degree limit: a polynomial of degree 1000 would be needed, the limit is 10')
Unable: kovacic.solve("z^2 - 2001", max_degree=10).because.engines
    @.why -> Why.budget
    @.detail[:12] -> 'degree limit'
ClaimReport: kovacic.check(text + '\n[[integral]]\nname = "H"\n').claims[0]
    @.name -> 'H'
    @.text -> 'H'
    @.proved -> Truth.yes
    @.generic -> []
    @.detail -> 'd/dt H = 0 identically'
Loop: kovacic.monodromy("-3/(16*z^2)").loops[0]
    str(@)[:15] -> "Loop(place='0',"
SpectrumFamily: kovacic.spectrum("x^6 + E*x^2").pieces[0].families[0]
    @.degree -> MFraction('(E - 3)/2')
    len(@.levels) -> 2
    @.open -> 'N >= 4 was not looked at (--levels)'
TheoremUsed: kovacic.check(text).manifolds[0].by
    @.id -> 'Morales-Ramis'
    @.name -> 'Morales-Ruiz and Ramis (2001)'
    @.statement[:24] -> 'If a Hamiltonian system '
    @.cite -> 'MoralesRamis2001'
    len(@.hypotheses) -> 4
    @.integrals -> 'meromorphic'
TheoremHypothesis: kovacic.check(text).manifolds[0].by.hypotheses[0]
    @.text -> 'the system is Hamiltonian on the leaves of a Poisson structure'
    @.settled -> Settled.checked
    @.how -> "Jacobi's identity, when the system is read"
Solved: kovacic.solve("z^2 + 3")
    @.basis -> ('z*exp(z^2/2)', 'z*exp(z^2/2)*((-1/z)*exp(-z^2) - sqrt(pi)*erf(z))')
    @.polynomial_of_y is None -> True
    @.constants -> {}
    @.p -> RationalFunction('0')
    @.q -> RationalFunction('-z^2 - 3')
TheoremResult: theorem
    @.title -> 'One case'
    @.nodes -> [<NodeResult only: proved>]
    @.statement[:11] -> 'The system '
    @.verdict -> 'PROVED'
    @.conclusion[:44] -> 'PROVED, given 1 theorem of the literature; 1'
    @.complete -> True
    @.theorems -> [<TheoremUsed Morales-Ramis>]
    @.trusted_steps -> []
    @.unchecked_hypotheses -> []
    @.seconds >= 0 -> True
NodeResult: theorem.nodes[0]
    @.id -> 'only'
    @.title -> 'only'
    @.kind -> 'case'
    @.needs -> []
    @.status -> NodeStatus.proved
    @.statement[:11] -> 'The system '
    @.summary[:16] -> 'non-integrable: '
    @.rests_on_open -> False
    @.steps_on_trust -> 0
    @.integrals -> ''
    @.excluded -> ['meromorphic']
    @.theorems -> [<TheoremUsed Morales-Ramis>]
    @.trusted -> []
    @.certificates[0][:30] -> '{"format":"kovacic-system/1","'
    @.seconds >= 0 -> True
FixedPoints: orbits
    len(@.points) -> 4
    @.index_sum -> 0
    @.cells -> 1872
    @.cells_without_index -> 0
    @.unexplained_cells -> 0
    @.stopped -> False
    @.degenerate -> False
FixedPoint: orbits.points[1]
    [round(x, 6) for x in @.at] -> [1.570796, 0.0]
    len(@.x) -> 6
    round(@.period, 6) -> 3.627599
    round(@.trace, 6) -> -0.532511
    abs(complex(*@.multiplier)) - 1 < 1e-9 -> True
    @.stability -> Stability.elliptic
    @.proved -> True
    @.error < 1e-9 -> True
    @.trace_error < 1e-9 -> True
    @.why -> ''
Truth: kovacic.solve("z").abelian
    @ -> Truth.no
GroupType: kovacic.solve("z").group.type
    @ -> GroupType.SL2
Connected: kovacic.solve("z").component
    @ -> Connected.sl2
Argument: kovacic.solve("z + 1/z").because.argument
    @ -> Argument.torus_no_line
Trichotomy: kovacic.solve("z + 1/z").because.kind
    @ -> Trichotomy.irregular_or_irrational
ClassificationStatus: S.classify().status
    @ -> ClassificationStatus.depends
StratumStatus: S.classify().strata[0].status
    @ -> StratumStatus.integrable
SpectrumStatus: kovacic.spectrum("x^2 - E").pieces[0].status
    @ -> SpectrumStatus.conditions
VerdictKind: kovacic.check(text).verdict
    @ -> VerdictKind.non_integrable
Ended: kovacic.System("p^2/2 + q^2/2", "q", "p").section("q", states=[[1, 0]], plot=["q", "p"], crossings=3).orbits[0].ended
    @ -> Ended.crossings
Settled: kovacic.check(text).manifolds[0].by.hypotheses[0].settled
    @ -> Settled.checked
Method: kovacic.Method["kovacic"]
    @ -> Method.kovacic
Why: list(kovacic.Why)[0]
    @ -> Why.parameter
Stability: list(kovacic.Stability)[0]
    @ -> Stability.elliptic
NodeStatus: list(kovacic.NodeStatus)[0]
    @ -> NodeStatus.proved
"""


def attach(names):
    """Each example behind the documentation of its member, and the first one of a class behind that of the class."""
    for line in TEXT.strip().splitlines():
        if not line.startswith(" "):
            name, root = line.split(": ", 1)
            targets = [names[name]]
            continue
        call, value = line.strip().split(" -> ", 1)
        member = re.search(r"@\.(\w+)", call)
        if member:
            targets.append(vars(names[name])[member[1]])
        for target in targets:
            target.__doc__ = f"{(target.__doc__ or '').rstrip()}\n\n    >>> {call.replace('@', root)}\n    {value}\n"
        targets = []
