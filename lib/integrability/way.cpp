#include "integrability/way.hpp"

#include "certify/system/check.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "integrability/constants.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/normal_identity.hpp"
#include "integrability/parameters.hpp"
#include "integrability/preserved_relations.hpp"
#include "integrability/way_names.hpp"

#include <algorithm>

namespace kov {

namespace {

using Element = FunctionField::Element;
using Row = CurveRows::Row;

bool holds_without_relations(const System& s, const VectorField& v) {
  const Ideal no_relations(s.ring(), v.main_variables(), {});
  if (has_bracket(v) && structure_failure(v, *v.poisson, no_relations)) return false;
  const auto closed = [&](const FunctionSymbol& f) {
    for (std::size_t i = 0; i < v.dimension(); ++i)
      for (std::size_t j = i + 1; j < v.dimension(); ++j)
        if (!(partial(v, f.gradient[i], j) == partial(v, f.gradient[j], i))) return false;
    return true;
  };
  return std::ranges::all_of(v.functions, closed);
}

// The claims whose identity needs no relation.
std::vector<const SystemClaim*> claimed(const std::vector<ClaimReport>& claims,
                                        const VectorField& v) {
  std::vector<const SystemClaim*> all;
  for (const ClaimReport& c : claims) {
    if (!c.result.proved || !c.claim.on.empty()) continue;
    const bool casimir = c.claim.kind == SystemClaim::Kind::casimir;
    if (casimir && has_bracket(v)) {
      const auto x = hamiltonian_field(v, *v.poisson, c.claim.value);
      if (std::ranges::all_of(x, [](const MFraction& f) { return is_zero(f); }))
        all.push_back(&c.claim);
    }
    if (c.claim.kind == SystemClaim::Kind::integral && is_zero(lie_derivative(v, c.claim.value)))
      all.push_back(&c.claim);
  }
  return all;
}

certify::NormalIdentity in_names(const NormalIdentity& id, CurveWriter& curve) {
  certify::NormalIdentity x;
  for (std::size_t l = 0; l < id.annihilators.size(); ++l)
    x.annihilators.push_back({curve.write(id.annihilators[l]), curve.write(id.matrices[l])});
  for (const Row& a : id.rows)
    x.rows.push_back(curve.write(a));
  for (const Row& a : id.rests)
    x.rests.push_back(curve.write(a));
  x.is_system = id.p.empty();
  if (!x.is_system) {
    x.p = curve.write(id.p);
    x.q = curve.write(id.q);
  }
  for (const Row& a : id.vectors)
    x.vectors.push_back(curve.write(a));
  return x;
}

class WayWriter {
public:
  WayWriter(const Study& study, const ManifoldReport& report, std::size_t z, const MFraction& phi,
            const FunctionField& f)
      : study_(study), s_(study.system), v_(s_.field), written_(with_preserved_relations(v_)),
        m_(report), z_(z), phi_(phi), f_(f), rows_(v_, f_) {}

  [[nodiscard]] const CurveRows& rows() const { return rows_; }

  std::optional<WayToR> operator()(std::optional<NormalIdentity> identity, std::string& none) {
    if (!holds_without_relations(s_, written_)) {
      none = "Jacobi's identity, or what makes a gradient closed, holds only modulo the relations "
             "of the functions, for which the format has no rule";
      return std::nullopt;
    }
    if (!identity) {
      none = "the covectors of the block span no subsystem of which it is a quotient";
      return std::nullopt;
    }
    id_ = *std::move(identity);
    const auto tower = Tower::make(f_);
    if (!tower) {
      none = "the function field of the curve has no tower: it has components of different degrees";
      return std::nullopt;
    }
    CurveWriter curve(s_, z_, *tower);
    PhaseWriter phase(s_);
    write_system(phase);
    write_curve(phase, curve, *tower);
    way_.way.normal = in_names(id_, curve);
    find_root(curve);
    denominators_ = curve.denominators();
    for (const MPoly& d : denominators_)
      way_.way.curve.denominators.push_back(curve.moved(d));
    way_.leaves_out = !moving_and_left_out(s_, *m_.manifold).empty();
    return way_;
  }

  // Finds where all coefficients of a denominator may be 0.  Those of the level only are chosen
  // elsewhere; what r itself was divided by is excluded in its strata, and studied anew.
  void find_exceptions(const AlgebraicOde& ode, WayToR& way) const {
    const auto levels = level_parameters(s_);
    const auto chosen = [&](std::size_t i) {
      return i != z_ && !uses(ode.r, i) && is_among(i, levels);
    };
    std::vector<MPoly> generic;
    for (const MPoly& g : ode.generic)
      for (MPoly& part : irreducible_parts(g))
        generic.push_back(std::move(part));
    for (const MPoly& d : denominators_) {
      const auto used = used_variables(d);
      if (!std::ranges::all_of(used, chosen) && !is_among(d, generic) && may_vanish(d))
        way.exceptions.push_back(d);
    }
  }

private:
  // ---- the system

  void write_system(PhaseWriter& phase) {
    phase.divide(phi_);
    phase.divide(written_);
    for (const auto* list : {&m_.manifold->equations, &m_.manifold->levels})
      for (const Equation& e : *list)
        phase.divide(e.difference);
    const auto claims = claimed(study_.claims, written_);
    for (const SystemClaim* c : claims)
      phase.divide(c->value);
    phase.make_ring();
    way_.way.title = title_of(s_);
    way_.way.system = phase.write(written_);
    for (const SystemClaim* c : claims)
      way_.way.claims.push_back(
          {c->kind == SystemClaim::Kind::casimir, c->name, phase.write(c->value), {}});
  }

  // ---- the curve

  void write_curve(PhaseWriter& phase, CurveWriter& curve, const Tower& tower) {
    certify::PhaseCurve& x = way_.way.curve;
    x.ring = curve.ring();
    x.manifold = m_.name;
    for (const Equation& e : m_.manifold->equations)
      x.equations.push_back(phase.write(e.difference));
    for (const Equation& e : m_.manifold->levels)
      x.levels.push_back(phase.write(e.difference));
    x.change = phase.write(phi_);
    for (const Tower::Step& step : tower.steps()) {
      const Element w = rows_.value(MFraction::variable(s_.ring(), step.variable));
      Element power = w;
      for (std::size_t d = 1; d < step.degree; ++d)
        power = rows_.times(power, w);
      x.tower.push_back({step.degree, curve.write(power), curve.write(f_.derivative(w))});
    }
    write_values(phase, curve);
    x.time = curve.write(f_.inverse_z_dot());
  }

  void write_values(PhaseWriter& phase, CurveWriter& curve) {
    auto& values = way_.way.curve.values;
    const auto& main = f_.algebra().ideal().main();
    const auto is_main = [&](std::size_t i) { return is_among(i, main); };
    for (std::size_t i = 0; i < phase.first_inverse(); ++i)
      if (const std::size_t x = phase.original(i); is_main(x))
        values.emplace_back(i, curve.write(rows_.value(MFraction::variable(s_.ring(), x))));
    for (std::size_t k = 0; k < phase.divisors().size(); ++k) {
      const MFraction one(s_.ring(), Rational(1));
      tried<DomainError>([&] { // else left out, and refused where it is needed
        const Element u = rows_.value(one / MFraction(phase.divisors()[k]));
        values.emplace_back(phase.first_inverse() + k, curve.write(u));
      });
    }
  }

  // ---- the equation

  void find_root(CurveWriter& curve) {
    if (v_.constants.empty() || !constants_are_numbers(v_)) return; // parameters of the strata then
    const ConstantField constants = ConstantField::make(v_);
    if (constants.field()->is_rational()) return;
    way_.root = curve.write(rows_.value(constants.generator()));
  }

  // For some parameters that the file admits all coefficients of d in z are 0.
  [[nodiscard]] bool may_vanish(const MPoly& d) const {
    const Ideal together(s_.ring(), v_.parameters, coefficients(d, z_), {},
                         study_.options.decide.budget);
    if (together.is_unit()) return false;
    const auto& basis = together.basis();
    return std::ranges::none_of(basis, [&](const KPoly& g) {
      return not_excluded(s_, {together.from_kpoly(g).num()}).empty();
    });
  }

  const Study& study_;
  const System& s_;
  const VectorField& v_;
  const VectorField written_; ///< with the gradients that the certificate states
  const ManifoldReport& m_;
  std::size_t z_;
  const MFraction& phi_;
  const FunctionField& f_;
  CurveRows rows_;
  NormalIdentity id_;
  std::vector<MPoly> denominators_;
  WayToR way_;
};

} // namespace

void find_way(const Study& study, const ManifoldReport& report, BlockReport& block) {
  const Options& decide = study.options.decide;
  if (!block.ode || study.options.stop_at_r || !(decide.want_certificate || decide.ask_the_judge))
    return;
  try {
    std::string none;
    WayWriter writer(study, report, block.ode->z, block.ode->phi, *block.ode->field);
    auto way = writer(normal_identity(report, block, writer.rows()), none);
    if (way) writer.find_exceptions(*block.ode, *way);
    if (!way) return void(block.no_way = NoWay{NoWay::Why::no_rule, none});
    const auto no = certify::objection(way->way, {block.ode->r.num(), block.ode->r.den()});
    if (!no) {
      block.way = std::make_shared<const WayToR>(*std::move(way));
      return;
    }
    block.no_way =
        NoWay{no->limit ? NoWay::Why::too_large : NoWay::Why::refused, no->step + ": " + no->why};
  } catch (const DomainError& why) {
    block.no_way = NoWay{NoWay::Why::no_rule, why.what()};
  } catch (const InvalidArgument& why) {
    block.no_way = NoWay{NoWay::Why::no_rule, why.what()};
  } catch (const OutOfBudget& limit) {
    block.no_way = NoWay{NoWay::Why::failed, limit.what()};
  }
}

void withdraw_refused(std::vector<BlockReport>& blocks) {
  for (BlockReport& b : blocks) {
    if (!b.no_way || b.no_way->why != NoWay::Why::refused) continue;
    const bool found = b.decision || b.strata || !b.energies.empty();
    b.decision.reset();
    b.strata.reset();
    b.energies.clear();
    b.special_studies.clear();
    b.abelian = Truth::unknown;
    if (found) b.missing = {{Missing::What::refused_way, b.no_way->of}};
  }
}

namespace {

certify::SystemCertificate assembled(const WayToR& way, const std::string& equation) {
  certify::SystemCertificate c{way.way, certify::Certificate{}, {}, false};
  if (certify::format_of(equation) == "kovacic-strata/1") {
    auto strata = certify::read_strata_certificate(equation);
    c.not_integrable = strata.abelian == false;
    c.equation = std::move(strata);
    return c;
  }
  auto inner = certify::read_certificate(equation);
  c.not_integrable = inner.claim.abelian == false;
  if (!inner.field->is_rational()) c.root = way.root;
  c.equation = std::move(inner);
  return c;
}

} // namespace

LoopsOfWay certificate_of(const Study& study, const ManifoldReport& report,
                          const RationalSystem& system, const MFraction& phi,
                          const UnknownsOfSystem& unknowns, const std::string& loops) {
  if (loops.empty()) return {};
  const LoopsOfWay alone{loops, false};
  const auto whole = [&]() -> LoopsOfWay {
    const System& s = study.system;
    auto field = FunctionField::make(s.field, *report.manifold, system.z, phi, {});
    if (std::holds_alternative<ChangeFailure>(field)) return alone;
    WayWriter writer(study, report, system.z, phi, std::get<FunctionField>(field));
    std::string none;
    auto way = writer(normal_identity(system, unknowns, writer.rows()), none);
    if (!way) return alone;
    way->way.normal.whole = unknowns.whole;
    certify::SystemCertificate c{way->way, certify::read_loops_certificate(loops), {}, true};
    if (!std::get<certify::LoopsCertificate>(c.equation).field->is_rational()) c.root = way->root;
    if (certify::objection(c)) return alone;
    return {certify::write_system_certificate(c), true};
  };
  auto found = tried<DomainError, InvalidArgument, OutOfBudget>(whole);
  return found.text.empty() ? alone : found;
}

std::optional<std::string> certificate_of(const WayToR& way, const std::string& equation,
                                          std::string& none) {
  try {
    const std::string text = certify::write_system_certificate(assembled(way, equation));
    const auto verdict = certify::check_way(certify::read_system_certificate(text));
    const auto* no = std::get_if<certify::Rejected>(&verdict);
    if (!no) return text;
    none = "the checker refuses it, " + no->step + ": " + no->why;
  } catch (const InvalidArgument& why) {
    none = why.what();
  }
  return std::nullopt;
}

namespace {

bool is_certified(const std::shared_ptr<const WayToR>& way) {
  return way && way->exceptions.empty();
}

// With the class of integrals that is said: strata are not known to have the group SL(2).
bool strata_are_certified(const ManifoldReport& m, const BlockReport& b) {
  return is_certified(b.way) && (!b.way->leaves_out || (m.by && !m.by->integrals.without.empty()));
}

bool is_certified(const ManifoldReport& m, const BlockReport& b) {
  for (const EnergyResult& e : b.energies) {
    if (e.decision && e.decision->abelian == Truth::no) return is_certified(e.way);
    if (e.strata && e.strata->abelian() == Truth::no) return strata_are_certified(m, b);
  }
  return b.strata ? strata_are_certified(m, b) : is_certified(b.way);
}

// " where A - C = 0": what the way says nothing of.
std::string exceptions(const BlockReport& b) {
  std::string text;
  if (b.way)
    for (const MPoly& d : b.way->exceptions)
      text += (text.empty() ? ", where " : " or ") + to_string(d) + " = 0";
  return text;
}

} // namespace

std::vector<Trusted> uncertified_way(const ManifoldReport& m) {
  const bool excluded = m.verdict == Verdict::non_integrable;
  const std::string along = ", along the manifold " + m.name;
  std::vector<Trusted> all;
  bool any = false;
  for (const BlockReport& b : m.blocks) {
    if (!b.ode || (excluded && !m.matrices && b.abelian != Truth::no)) continue;
    any = true;
    if (m.matrices ? !m.matrices->has_way : !is_certified(m, b))
      all.push_back({Trusted::Step::way_to_r, along + exceptions(b)});
    for (const auto& special : b.special_studies) {
      if (special->verdict == Verdict::no_obstruction && m.verdict != special->verdict)
        continue; // an exception, in which nothing is said
      add_each_once(all, uncertified_way(*special));
    }
  }
  if (any && m.verdict == Verdict::no_obstruction)
    all.push_back({Trusted::Step::whole_variation, along});
  return all;
}

} // namespace kov
