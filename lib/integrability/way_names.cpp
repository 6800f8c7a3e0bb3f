#include "integrability/way_names.hpp"

#include <algorithm>

namespace kov {

void PhaseWriter::make_ring() {
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

certify::PhaseFunction PhaseWriter::write(const MFraction& f) {
  if (is_zero(f)) return {MPoly(ring_), Integer(1)};
  const Factors::Product den = factors_.of(f.den());
  MPoly p = moved(f.num());
  for (std::size_t k = 0; k < den.exponents.size(); ++k)
    p *= pow(MPoly::variable(ring_, first_inverse() + k), den.exponents[k]);
  return {p, den.content};
}

void PhaseWriter::divide(const VectorField& v) {
  if (has_bracket(v)) {
    divide(*v.hamiltonian);
    for (const auto& row : *v.poisson)
      for (const MFraction& f : row)
        divide(f);
  } else {
    for (const MFraction& f : v.components)
      divide(f);
  }
  for (const FunctionSymbol& f : v.functions)
    for (const MFraction& g : f.gradient)
      divide(g);
}

certify::PhaseSystem PhaseWriter::write(const VectorField& v) {
  certify::PhaseSystem x;
  x.ring = ring_;
  x.dimension = v.dimension();
  for (const FunctionSymbol& f : v.functions) {
    certify::PhaseSymbol& symbol = x.functions.emplace_back();
    symbol.meaning = f.meaning;
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (!is_zero(f.gradient[j])) symbol.gradient.emplace_back(j, write(f.gradient[j]));
  }
  for (std::size_t i = 0; i < v.constants.size(); ++i)
    x.functions.push_back({"an algebraic constant", {}});
  for (const MPoly& d : divisors())
    x.inverses.push_back(moved(d));
  for (const MPoly& r : v.relations)
    x.relations.push_back(moved(r));
  if (!has_bracket(v)) {
    for (const MFraction& f : v.components)
      x.field.push_back(write(f));
    return x;
  }
  x.hamiltonian = write(*v.hamiltonian);
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t j = i + 1; j < v.dimension(); ++j)
      if (const MFraction& p = (*v.poisson)[i][j]; !is_zero(p))
        x.brackets.push_back({i, j, write(p)});
  return x;
}

MPoly PhaseWriter::moved(const MPoly& f) const {
  return is_zero(f) ? MPoly(ring_) : transfer(MFraction(f), ring_).num();
}

std::string PhaseWriter::fresh(std::string name) const {
  while (s_.ring()->find(name))
    name += "_";
  return name;
}

CurveWriter::CurveWriter(const System& s, std::size_t z, const Tower& tower) : tower_(tower) {
  std::vector<std::string> names;
  for (const Tower::Step& step : tower.steps())
    names.insert(names.begin(), s.ring()->name(step.variable));
  names.push_back(s.ring()->name(z));
  for (const std::size_t i : s.field.parameters)
    names.push_back(s.ring()->name(i));
  ring_ = kov::make_ring(names);
}

namespace {

unsigned long at(const std::vector<unsigned long>& e, std::size_t k) {
  return k < e.size() ? e[k] : 0;
}

Factors::Product together(Factors::Product a, const Factors::Product& b) {
  a.content = lcm(a.content, b.content);
  a.exponents.resize(std::max(a.exponents.size(), b.exponents.size()), 0);
  for (std::size_t k = 0; k < b.exponents.size(); ++k)
    a.exponents[k] = std::max(a.exponents[k], b.exponents[k]);
  return a;
}

} // namespace

certify::CurveFunction CurveWriter::write(const FunctionField::Element& a) {
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

certify::CurveRow CurveWriter::write(const CurveRows::Row& row) {
  certify::CurveRow all;
  for (const FunctionField::Element& a : row)
    all.push_back(write(a));
  return all;
}

MPoly CurveWriter::monomial(const Tower::Exponents& e) const {
  MPoly m(ring_, Integer(1));
  for (std::size_t i = 0; i < e.size(); ++i)
    m *= pow(MPoly::variable(ring_, e.size() - 1 - i), e[i]);
  return m;
}

} // namespace kov
