#include "integrability/way.hpp"

#include "algebraize/tower.hpp"
#include "certify/system/check.hpp"
#include "exact/error.hpp"
#include "integrability/curve_rows.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov {
namespace {

using certify::CurveFunction;
using certify::PhaseFunction;
using Element = FunctionField::Element;
using Row = CurveRows::Row;

// Denominators as products of powers, each written once.
class Factors {
public:
  /// den = content * prod all()[k]^exponents[k]
  struct Product {
    Integer content{1};
    std::vector<unsigned long> exponents;
  };
  Product of(const MPoly& den) {
    Product product;
    if (is_constant(den)) {
      product.content = den.coefficient(0);
      return product;
    }
    auto [content, factors] = factor(den);
    product.content = content;
    for (auto& [base, exponent] : factors) {
      const auto at = std::find(all_.begin(), all_.end(), base);
      const auto k = static_cast<std::size_t>(at - all_.begin());
      if (at == all_.end()) all_.push_back(base);
      if (product.exponents.size() <= k) product.exponents.resize(k + 1, 0);
      product.exponents[k] = static_cast<unsigned long>(exponent);
    }
    return product;
  }
  [[nodiscard]] const std::vector<MPoly>& all() const { return all_; }

private:
  std::vector<MPoly> all_;
};

// Polynomials in the phase names; what is divided by becomes a symbol.
class PhaseWriter {
public:
  explicit PhaseWriter(const System& s) : s_(s), v_(s.field) {}

  /// To be called for everything that is written later.
  void divide(const MFraction& f) { factors_.of(f.den()); }

  void make_ring() {
    std::vector<std::string> names;
    const auto add = [&](std::size_t i) { names.push_back(s_.ring()->name(i)); };
    for (const std::size_t i : v_.coordinates)
      add(i);
    for (const FunctionSymbol& f : v_.functions)
      add(f.variable);
    for (const std::size_t i : v_.constants)
      add(i);
    for (std::size_t k = 0; k < factors_.all().size(); ++k)
      names.push_back(fresh("u" + std::to_string(k + 1)));
    for (const std::size_t i : v_.parameters)
      add(i);
    ring_ = kov::make_ring(names);
  }

  [[nodiscard]] PhaseFunction write(const MFraction& f) {
    if (is_zero(f)) return {MPoly(ring_), Integer(1)};
    const Factors::Product den = factors_.of(f.den());
    MPoly p = moved(f.num());
    for (std::size_t k = 0; k < den.exponents.size(); ++k)
      p *= pow(MPoly::variable(ring_, first_inverse() + k), den.exponents[k]);
    return {p, den.content};
  }
  [[nodiscard]] MPoly moved(const MPoly& f) const {
    return is_zero(f) ? MPoly(ring_) : transfer(MFraction(f), ring_).num();
  }
  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const std::vector<MPoly>& divisors() const { return factors_.all(); }
  [[nodiscard]] std::size_t first_inverse() const {
    return v_.dimension() + v_.functions.size() + v_.constants.size();
  }
  /// The variable of the system with this place in the ring; not for inverses.
  [[nodiscard]] std::size_t original(std::size_t i) const {
    return s_.ring()->index(ring_->name(i));
  }

private:
  [[nodiscard]] std::string fresh(std::string name) const {
    while (s_.ring()->find(name))
      name += "_";
    return name;
  }

  const System& s_;
  const VectorField& v_;
  Factors factors_;
  Ring ring_;
};

// Elements of the function field in the names of the tower.
class CurveWriter {
public:
  CurveWriter(const System& s, std::size_t z, const Tower& tower) : tower_(tower) {
    std::vector<std::string> names;
    for (const Tower::Step& step : tower.steps())
      names.insert(names.begin(), s.ring()->name(step.variable));
    names.push_back(s.ring()->name(z));
    for (const std::size_t i : s.field.parameters)
      names.push_back(s.ring()->name(i));
    ring_ = kov::make_ring(names);
  }

  [[nodiscard]] CurveFunction write(const Element& a) {
    const auto c = tower_.coordinates(a);
    std::vector<Factors::Product> dens;
    Factors::Product common;
    for (const MFraction& x : c) {
      dens.push_back(is_zero(x) ? Factors::Product{} : factors_.of(x.den()));
      common = together(common, dens.back());
    }
    MPoly sum(ring_);
    for (std::size_t k = 0; k < c.size(); ++k) {
      if (is_zero(c[k])) continue;
      MPoly term = moved(c[k].num());
      term *= MPoly(ring_, exact_div(common.content, dens[k].content));
      for (std::size_t i = 0; i < common.exponents.size(); ++i)
        if (const auto e = common.exponents[i] - at(dens[k].exponents, i); e > 0)
          term *= moved(pow(factors_.all()[i], e));
      sum += term * monomial(tower_.monomials()[k]);
    }
    return {sum, common.content, common.exponents};
  }
  [[nodiscard]] certify::CurveRow write(const Row& row) {
    certify::CurveRow all;
    for (const Element& a : row)
      all.push_back(write(a));
    return all;
  }
  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const std::vector<MPoly>& denominators() const { return factors_.all(); }
  [[nodiscard]] MPoly moved(const MPoly& f) const { return transfer(MFraction(f), ring_).num(); }

private:
  static unsigned long at(const std::vector<unsigned long>& e, std::size_t k) {
    return k < e.size() ? e[k] : 0;
  }
  static Factors::Product together(Factors::Product a, const Factors::Product& b) {
    a.content = lcm(a.content, b.content);
    a.exponents.resize(std::max(a.exponents.size(), b.exponents.size()), 0);
    for (std::size_t k = 0; k < b.exponents.size(); ++k)
      a.exponents[k] = std::max(a.exponents[k], b.exponents[k]);
    return a;
  }
  [[nodiscard]] MPoly monomial(const Tower::Exponents& e) const {
    MPoly m(ring_, Integer(1));
    for (std::size_t i = 0; i < e.size(); ++i)
      m *= pow(MPoly::variable(ring_, e.size() - 1 - i), e[i]);
    return m;
  }

  const Tower& tower_;
  Factors factors_;
  Ring ring_;
};

// Covectors that vanish where the variational equation is restricted: the differentials of the
// integrals that eliminate, and those of the unknowns to which the block leads.
class Annihilators {
public:
  Annihilators(const ManifoldReport& m, const CurveRows& rows) : m_(m), rows_(rows) {
    for (const std::size_t i : m.normal.equations)
      df_.push_back(rows.gradient(m.manifold->equations[i].difference));
  }

  [[nodiscard]] const Row& of_unknown(const std::string& name) const {
    const auto& names = m_.normal.system.names;
    const auto at = std::find(names.begin(), names.end(), name);
    KOV_ENSURE(at != names.end());
    return df_[static_cast<std::size_t>(at - names.begin())];
  }

  /// The differentials of the integrals that were used, in their order.
  [[nodiscard]] std::vector<Row> of_integrals() const {
    std::vector<Row> all;
    auto next = m_.normal.integrals.begin();
    for (const Elimination& e : m_.reduced.eliminations) {
      while (next != m_.normal.integrals.end() && next->name != e.integral)
        ++next;
      KOV_ENSURE(next != m_.normal.integrals.end());
      all.push_back(combined(next->coefficients));
      ++next;
    }
    return all;
  }

  /// Those of the unknowns outside the block on which its equations depend.
  [[nodiscard]] std::vector<Row> of_other_blocks(const std::vector<std::string>& block) const {
    const LinearSystem& r = m_.reduced.system;
    const auto inside = [&](std::size_t i) {
      return std::find(block.begin(), block.end(), r.names[i]) != block.end();
    };
    std::vector<bool> reached(r.names.size());
    for (std::size_t round = 0; round < r.names.size(); ++round)
      for (std::size_t i = 0; i < r.names.size(); ++i)
        for (std::size_t j = 0; j < r.names.size(); ++j)
          if ((inside(i) || reached[i]) && !inside(j) && !reached[j] &&
              !m_.manifold->vanishes_on_curve(r.a[i][j]))
            reached[j] = true;
    std::vector<Row> all;
    for (std::size_t j = 0; j < r.names.size(); ++j)
      if (reached[j]) all.push_back(of_unknown(r.names[j]));
    return all;
  }

private:
  [[nodiscard]] Row combined(const std::vector<MFraction>& c) const {
    Row sum(df_.front().size(), rows_.constant(0));
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (is_zero(c[i])) continue;
      const Element factor = rows_.value(c[i]);
      for (std::size_t k = 0; k < sum.size(); ++k)
        if (!is_zero(df_[i][k])) sum[k] = sum[k] + rows_.times(factor, df_[i][k]);
    }
    return sum;
  }

  const ManifoldReport& m_;
  const CurveRows& rows_;
  std::vector<Row> df_;
};

// The identity of N1 to N3 in the function field.
struct Identity {
  std::vector<Row> annihilators, matrices;
  Row row, rest;
  Element p, q;
  std::vector<Row> vectors;
};

class WayWriter {
public:
  WayWriter(const Study& study, const ManifoldReport& report, const BlockReport& block)
      : study_(study), s_(study.system), v_(s_.field), m_(report), block_(block), ode_(*block.ode),
        f_(*ode_.field), rows_(v_, f_) {}

  std::optional<WayToR> operator()(std::string& none) {
    if (!find_identity()) {
      none = "the covectors of the block span no subsystem of which it is a quotient";
      return std::nullopt;
    }
    const auto tower = Tower::make(f_);
    if (!tower) {
      none = "the function field of the curve has no tower: it has components of different degrees";
      return std::nullopt;
    }
    CurveWriter curve(s_, ode_.z, *tower);
    PhaseWriter phase(s_);
    write_system(phase);
    write_curve(phase, curve, *tower);
    write_normal(curve);
    find_root(curve);
    for (const MPoly& d : curve.denominators())
      way_.way.curve.denominators.push_back(curve.moved(d));
    find_exceptions(curve);
    way_.leaves_out = !moving_and_left_out(s_, *m_.manifold).empty();
    return way_;
  }

private:
  // ---- the identity

  [[nodiscard]] const NormalVariationalEquation& scalar() const {
    const auto at = std::find_if(block_.scalar.begin(), block_.scalar.end(),
                                 [&](const auto& e) { return e.unknown == ode_.unknown; });
    KOV_ENSURE(at != block_.scalar.end());
    return *at;
  }

  bool find_identity() {
    const auto square = rows_.times(f_.inverse_z_dot(), f_.inverse_z_dot());
    id_.p = rows_.times(f_.z_ddot() + rows_.times(rows_.value(scalar().a1), f_.z_dot()), square);
    id_.q = rows_.times(rows_.value(scalar().a0), square);
    const Annihilators found(m_, rows_);
    id_.row = found.of_unknown(ode_.unknown);
    const Row first = rows_.nabla(id_.row);
    Row left = rows_.nabla(first);
    for (std::size_t k = 0; k < left.size(); ++k)
      left[k] = left[k] + rows_.times(id_.p, first[k]) + rows_.times(id_.q, id_.row[k]);
    auto all = found.of_integrals();
    if (!restrict_to(all, left)) {
      for (Row& row : found.of_other_blocks(block_.unknowns))
        all.push_back(std::move(row));
      if (!restrict_to(all, left)) return false;
    }
    return find_vectors(first);
  }

  // left = sum rest_l lambda_l, with the fewest of these annihilators that span a subsystem.
  bool restrict_to(const std::vector<Row>& all, const Row& left) {
    const auto c = rows_.combination(all, left);
    if (!c) return false;
    std::vector<Row> matrices;
    std::vector<bool> needed;
    for (const Element& x : *c)
      needed.push_back(!is_zero(x));
    for (const Row& row : all) {
      auto a = rows_.combination(all, rows_.nabla(row));
      if (!a) return false;
      matrices.push_back(*std::move(a));
    }
    for (std::size_t round = 0; round < all.size(); ++round)
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < all.size() && needed[i]; ++j)
          if (!is_zero(matrices[i][j])) needed[j] = true;
    const auto chosen = [&](const Row& row) {
      Row part;
      for (std::size_t j = 0; j < all.size(); ++j)
        if (needed[j]) part.push_back(row[j]);
      return part;
    };
    id_.rest = chosen(*c);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (needed[i]) {
        id_.annihilators.push_back(all[i]);
        id_.matrices.push_back(chosen(matrices[i]));
      }
    return true;
  }

  bool find_vectors(const Row& first) {
    std::vector<Row> rows;
    rows.push_back(rows_.through_bracket(id_.row));
    rows.push_back(rows_.through_bracket(first));
    for (const Row& l : id_.annihilators)
      rows.push_back(rows_.through_bracket(l));
    for (std::size_t i = 0; i < 2; ++i) {
      Row right(rows.size(), rows_.constant(0));
      right[i] = rows_.constant(1);
      auto x = rows_.solve(rows, right);
      if (!x) return false;
      id_.vectors.push_back(*std::move(x));
    }
    return true;
  }

  // ---- the system

  [[nodiscard]] bool has_bracket() const { return v_.poisson && v_.hamiltonian; }

  void write_system(PhaseWriter& phase) {
    std::vector<const MFraction*> all{&ode_.phi};
    if (has_bracket()) all.push_back(&*v_.hamiltonian);
    if (has_bracket())
      for (const auto& row : *v_.poisson)
        for (const MFraction& p : row)
          all.push_back(&p);
    else
      for (const MFraction& x : v_.components)
        all.push_back(&x);
    for (const FunctionSymbol& f : v_.functions)
      for (const MFraction& g : f.gradient)
        all.push_back(&g);
    for (const auto* list : {&m_.manifold->equations, &m_.manifold->levels})
      for (const Equation& e : *list)
        all.push_back(&e.difference);
    const auto claims = claimed();
    for (const SystemClaim* c : claims)
      all.push_back(&c->value);
    for (const MFraction* f : all)
      if (!is_zero(*f)) phase.divide(*f);
    phase.make_ring();
    way_.way.title = title();
    write_field(phase);
    for (const SystemClaim* c : claims)
      way_.way.claims.push_back(
          {c->kind == SystemClaim::Kind::casimir, c->name, phase.write(c->value), {}});
  }

  [[nodiscard]] std::string title() const {
    std::string text = s_.file;
    for (const auto& [name, value] : s_.values)
      text += ", " + name + " = " + to_string(value);
    return text;
  }

  void write_field(PhaseWriter& phase) {
    certify::PhaseSystem& x = way_.way.system;
    x.ring = phase.ring();
    x.dimension = v_.dimension();
    for (const FunctionSymbol& f : v_.functions) {
      certify::PhaseSymbol& symbol = x.functions.emplace_back();
      symbol.meaning = f.meaning;
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        if (!is_zero(f.gradient[j])) symbol.gradient.emplace_back(j, phase.write(f.gradient[j]));
    }
    for (std::size_t i = 0; i < v_.constants.size(); ++i)
      x.functions.push_back({"an algebraic constant", {}});
    for (const MPoly& d : phase.divisors())
      x.inverses.push_back(phase.moved(d));
    for (const MPoly& r : v_.relations)
      x.relations.push_back(phase.moved(r));
    if (!has_bracket()) {
      for (const MFraction& f : v_.components)
        x.field.push_back(phase.write(f));
      return;
    }
    x.hamiltonian = phase.write(*v_.hamiltonian);
    for (std::size_t i = 0; i < v_.dimension(); ++i)
      for (std::size_t j = i + 1; j < v_.dimension(); ++j)
        if (const MFraction& p = (*v_.poisson)[i][j]; !is_zero(p))
          x.brackets.push_back({i, j, phase.write(p)});
  }

  // Those whose identity needs no relation.
  [[nodiscard]] std::vector<const SystemClaim*> claimed() const {
    std::vector<const SystemClaim*> all;
    for (const ClaimReport& c : study_.claims) {
      if (!c.result.proved || !c.claim.on.empty()) continue;
      const bool casimir = c.claim.kind == SystemClaim::Kind::casimir;
      if (casimir && has_bracket()) {
        const auto x = hamiltonian_field(v_, *v_.poisson, c.claim.value);
        if (std::all_of(x.begin(), x.end(), [](const MFraction& f) { return is_zero(f); }))
          all.push_back(&c.claim);
      }
      if (c.claim.kind == SystemClaim::Kind::integral && is_zero(lie_derivative(v_, c.claim.value)))
        all.push_back(&c.claim);
    }
    return all;
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
    x.change = phase.write(ode_.phi);
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
    const auto is_main = [&](std::size_t i) {
      return std::find(main.begin(), main.end(), i) != main.end();
    };
    for (std::size_t i = 0; i < phase.first_inverse(); ++i)
      if (const std::size_t x = phase.original(i); is_main(x))
        values.emplace_back(i, curve.write(rows_.value(MFraction::variable(s_.ring(), x))));
    for (std::size_t k = 0; k < phase.divisors().size(); ++k) {
      const MFraction one(s_.ring(), Rational(1));
      try {
        const Element u = rows_.value(one / MFraction(phase.divisors()[k]));
        values.emplace_back(phase.first_inverse() + k, curve.write(u));
      } catch (const DomainError&) { // left out, and refused where it is needed
      }
    }
  }

  // ---- the equation

  void write_normal(CurveWriter& curve) {
    certify::NormalIdentity& x = way_.way.normal;
    for (std::size_t l = 0; l < id_.annihilators.size(); ++l)
      x.annihilators.push_back({curve.write(id_.annihilators[l]), curve.write(id_.matrices[l])});
    x.row = curve.write(id_.row);
    x.p = curve.write(id_.p);
    x.q = curve.write(id_.q);
    x.rest = curve.write(id_.rest);
    for (const Row& a : id_.vectors)
      x.vectors.push_back(curve.write(a));
  }

  // The generator of the field of the constants, where one of them is linear in it.
  void find_root(CurveWriter& curve) {
    if (v_.constants.empty()) return;
    const ConstantField constants = ConstantField::make(v_);
    if (constants.field()->is_rational()) return;
    for (const std::size_t i : v_.constants) {
      const MFraction c = MFraction::variable(s_.ring(), i);
      const NfElem a = constants.convert(c, ode_.z).num().coeff(0);
      const Rational factor = a.coeff(1);
      const NfElem rest = a - NfElem(a.coeff(0)) - NfElem(factor) * NfElem::generator(a.field());
      if (is_zero(factor) || !is_zero(rest)) continue;
      const MFraction shift(s_.ring(), a.coeff(0));
      way_.root = curve.write(rows_.value(Rational(1) / factor * (c - shift)));
      return;
    }
  }

  // Where all coefficients of a denominator may be 0.  Those of the level only are chosen elsewhere;
  // what r itself was divided by is excluded in its strata, and studied anew.
  void find_exceptions(const CurveWriter& curve) {
    const auto levels = level_parameters(s_);
    const auto chosen = [&](std::size_t i) {
      return i != ode_.z && !uses(ode_.r, i) &&
             std::find(levels.begin(), levels.end(), i) != levels.end();
    };
    std::vector<MPoly> generic;
    for (const MPoly& g : ode_.generic)
      for (MPoly& part : irreducible_parts(g))
        generic.push_back(std::move(part));
    for (const MPoly& d : curve.denominators()) {
      const auto used = used_variables(d);
      if (!std::all_of(used.begin(), used.end(), chosen) &&
          std::find(generic.begin(), generic.end(), d) == generic.end() && may_vanish(d))
        way_.exceptions.push_back(d);
    }
  }

  // For some parameters that the file admits all coefficients of d in z are 0.
  [[nodiscard]] bool may_vanish(const MPoly& d) const {
    const Ideal together(s_.ring(), v_.parameters, coefficients(d, ode_.z), {},
                         study_.options.decide.budget);
    if (together.is_unit()) return false;
    const auto& basis = together.basis();
    return std::none_of(basis.begin(), basis.end(), [&](const KPoly& g) {
      return not_excluded(s_, {together.from_kpoly(g).num()}).empty();
    });
  }

  const Study& study_;
  const System& s_;
  const VectorField& v_;
  const ManifoldReport& m_;
  const BlockReport& block_;
  const AlgebraicOde& ode_;
  const FunctionField& f_;
  CurveRows rows_;
  Identity id_;
  WayToR way_;
};

} // namespace

std::optional<WayToR> way_to_r(const Study& study, const ManifoldReport& report,
                               const BlockReport& block, std::string& none) {
  try {
    auto way = WayWriter(study, report, block)(none);
    if (!way) return std::nullopt;
    const auto no = certify::objection(way->way, {block.ode->r.num(), block.ode->r.den()});
    if (!no) return way;
    none = "the checker refuses it, " + no->step + ": " + no->why;
  } catch (const DomainError& why) {
    none = why.what();
  } catch (const InvalidArgument& why) {
    none = why.what();
  }
  return std::nullopt;
}

void find_way(const Study& study, const ManifoldReport& report, BlockReport& block) {
  const Options& decide = study.options.decide;
  if (!block.ode || study.options.stop_at_r || !(decide.want_certificate || decide.ask_the_judge))
    return;
  try {
    if (auto way = way_to_r(study, report, block, block.no_way))
      block.way = std::make_shared<const WayToR>(*std::move(way));
  } catch (const OutOfBudget& limit) {
    block.no_way = limit.what();
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
  return is_certified(b.way) && (!b.way->leaves_out || !m.without.empty());
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

std::vector<std::string> uncertified_way(const ManifoldReport& m) {
  const bool excluded = m.verdict == VerdictKind::non_integrable;
  const std::string along = ", along the manifold " + m.name;
  std::vector<std::string> all;
  bool any = false;
  for (const BlockReport& b : m.blocks) {
    if (!b.ode || (excluded && !m.matrices && b.abelian != Truth::no)) continue;
    any = true;
    if (m.matrices || !is_certified(m, b)) // of the whole there is no certificate
      all.push_back("the way from the system to r(z)" + along + exceptions(b));
    for (const auto& special : b.special_studies) {
      if (special->verdict == VerdictKind::no_obstruction && m.verdict != special->verdict)
        continue; // an exception, in which nothing is said
      for (std::string& step : uncertified_way(*special))
        all.push_back(std::move(step));
    }
  }
  if (any && m.verdict == VerdictKind::no_obstruction)
    all.push_back("that the blocks are all of the variational equation" + along);
  return all;
}

} // namespace kov
