#include "canonical/flat.hpp"

#include "canonical/elementary.hpp"
#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

constexpr std::size_t most_monomials = 120;
constexpr long most_sheets = 32; // of the old coordinates over the new ones

/// X(q) with {{X, T}, T} = 0, T the kinetic term.
class FlatFunctions {
public:
  FlatFunctions(const Form& form, const Matrix& g, const Budget& budget)
      : form_(form), v_(form.field), g_(g), budget_(budget),
        relations_(v_.ring, v_.main_variables(), v_.relations, {}, budget) {}

  std::vector<MFraction> run() {
    make_monomials();
    const auto rows = equations();
    std::vector<MFraction> all;
    for (const auto& solution : null_space(rows, monomials_.size(), v_.ring, budget_)) {
      MFraction x(v_.ring);
      for (std::size_t m = 0; m < monomials_.size(); ++m)
        x += solution[m] * monomials_[m];
      all.push_back(std::move(x));
    }
    return orthogonal(std::move(all));
  }

private:
  // Monomials of degree 1 and 2 in what moves; exponentials also with the degree -1.
  void make_monomials() {
    std::vector<MFraction> first;
    for (std::size_t i = 0; i < form_.degrees(); ++i)
      first.push_back(form_.variable(form_.q(i)));
    for (const FunctionSymbol& f : v_.functions) {
      const MFraction x = form_.variable(f.variable);
      first.push_back(x);
      const bool exponential = std::ranges::all_of(f.gradient, [&](const MFraction& slope) {
        return form_.is_constant_of_motion(slope / x);
      });
      if (exponential) first.push_back(MFraction(v_.ring, Rational(1)) / x);
    }
    for (const MFraction& x : first)
      add(x);
    for (std::size_t i = 0; i < first.size(); ++i)
      for (std::size_t k = 0; k <= i; ++k)
        add(first[i] * first[k]);
  }
  void add(const MFraction& x) {
    const bool known = is_among(x, monomials_);
    const bool standard =
        x.num().length() == 1 && relations_.normal_form(MFraction(x.num())) == MFraction(x.num());
    if (!form_.is_constant_of_motion(x) && !known && standard && monomials_.size() < most_monomials)
      monomials_.push_back(x);
  }

  // grad X, raised.
  [[nodiscard]] std::vector<MFraction> velocity(const MFraction& x) const {
    std::vector<MFraction> all;
    for (const auto& row : g_) {
      all.emplace_back(v_.ring);
      for (std::size_t k = 0; k < row.size(); ++k)
        if (!is_zero(row[k])) all.back() += row[k] * partial(v_, x, k);
    }
    return all;
  }

  // Twice {{X, T}, T}, T = p.Gp/2: the second derivatives along the geodesics.
  [[nodiscard]] MFraction second_derivative(const MFraction& x) const {
    const std::size_t n = form_.degrees();
    const auto w = velocity(x); // {X, T} = w.p
    MFraction sum(v_.ring);
    for (std::size_t i = 0; i < n; ++i) {
      const MFraction p = form_.variable(form_.p(i));
      const auto along = velocity(w[i]);
      for (std::size_t k = 0; k < n; ++k) {
        sum += p * along[k] * form_.variable(form_.p(k));
        for (std::size_t l = 0; l < n; ++l) // p_i' = -dT/dq_i
          if (const MFraction slope = partial(v_, g_[k][l], i); !is_zero(slope))
            sum += Rational(Integer(-1), Integer(2)) *
                   (w[i] * slope * form_.variable(form_.p(k)) * form_.variable(form_.p(l)));
      }
    }
    return sum;
  }

  // For the coefficients of the monomials: one for each monomial of the result.
  [[nodiscard]] Matrix equations() const {
    std::vector<MFraction> all;
    MPoly common(v_.ring, Integer(1));
    for (const MFraction& m : monomials_) {
      budget_.check();
      all.push_back(second_derivative(m));
      const MPoly den = is_zero(all.back()) ? MPoly(v_.ring, Integer(1)) : all.back().den();
      common = common * exact_div(den, gcd(common, den));
    }
    std::map<Monomial, std::vector<MFraction>> rows;
    for (std::size_t m = 0; m < all.size(); ++m)
      for (const auto& [monomial, c] : relations_.reduce(all[m] * MFraction(common)))
        rows.try_emplace(monomial, all.size(), MFraction(v_.ring)).first->second[m] = c;
    Matrix matrix;
    for (auto& [monomial, row] : rows)
      matrix.push_back(std::move(row));
    return matrix;
  }

  // grad X . grad Y, if it is a constant as it should be.
  [[nodiscard]] std::optional<MFraction> product(const MFraction& x, const MFraction& y) const {
    const auto w = velocity(x);
    MFraction sum(v_.ring);
    for (std::size_t k = 0; k < w.size(); ++k)
      sum += w[k] * partial(v_, y, k);
    if (is_zero(sum)) return sum;
    const MFraction n = relations_.normal_form(MFraction(sum.num()));
    const MFraction d = relations_.normal_form(MFraction(sum.den()));
    if (is_zero(d)) return std::nullopt;
    const MFraction value = n / d;
    if (form_.is_constant_of_motion(value)) return value;
    return std::nullopt;
  }

  // By Gram and Schmidt; of one length, where rational numbers suffice.
  [[nodiscard]] std::vector<MFraction> orthogonal(std::vector<MFraction> all) const {
    std::vector<MFraction> basis, squares;
    for (MFraction& x : all) {
      for (std::size_t a = 0; a < basis.size(); ++a) {
        const auto c = product(basis[a], x);
        if (!c) return {};
        x -= *c / squares[a] * basis[a];
      }
      if (is_zero(relations_.normal_form(MFraction(x.num())))) continue;
      const auto square = product(x, x);
      if (!square || is_zero(*square)) return {};
      basis.push_back(x);
      squares.push_back(*square);
    }
    const MFraction one(v_.ring, Rational(1));
    for (const MFraction& length : {squares.empty() ? one : squares.front(), one})
      for (std::size_t a = 0; a < basis.size(); ++a)
        if (const MFraction ratio = squares[a] / length; is_constant(ratio))
          if (const auto root = exact_sqrt(to_rational(ratio))) {
            basis[a] = (Rational(1) / *root) * basis[a];
            squares[a] = length;
          }
    return basis;
  }

  const Form& form_;
  const VectorField& v_;
  const Matrix& g_;
  const Budget& budget_;
  Ideal relations_;
  std::vector<MFraction> monomials_;
};

/// H in the new variables, by elimination of the old ones.
class Elimination {
public:
  Elimination(const Form& form, const FlatNames& names, const std::vector<MFraction>& x,
              const Budget& budget)
      : form_(form), names_(names), x_(x), budget_(budget) {}

  [[nodiscard]] std::optional<Form> run() const {
    const VectorField& v = form_.field;
    const FiniteAlgebra old(over_new_coordinates(), most_sheets);
    const auto whole = old.evaluate(hamiltonian());
    if (!whole) return std::nullopt;
    if (const auto h = old.in_base_field(*whole)) return with(*h, {});
    Substitution at_rest;
    for (const std::size_t p : names_.momenta)
      at_rest[p] = MFraction(v.ring);
    const MFraction potential = substitute(hamiltonian(), at_rest);
    const auto moving = old.evaluate(hamiltonian() - potential);
    const auto value = old.evaluate(potential);
    const auto kinetic = moving ? old.in_base_field(*moving) : std::nullopt;
    if (!kinetic || !value) return std::nullopt;
    return with_root(*kinetic, old.minimal_polynomial(*value, 2), potential);
  }

private:
  // p_i = sum of P_a dX_a/dq_i.
  [[nodiscard]] MFraction hamiltonian() const {
    Substitution momenta;
    for (std::size_t i = 0; i < form_.degrees(); ++i) {
      MFraction p(form_.field.ring);
      for (std::size_t a = 0; a < x_.size(); ++a)
        p += form_.variable(names_.momenta[a]) * partial(form_.field, x_[a], i);
      momenta[form_.p(i)] = p;
    }
    return substitute(*form_.field.hamiltonian, momenta);
  }

  [[nodiscard]] Ideal over_new_coordinates() const {
    const VectorField& v = form_.field;
    std::vector<MPoly> equations(v.relations), nonzero;
    for (std::size_t a = 0; a < x_.size(); ++a) {
      equations.push_back((x_[a] - form_.variable(names_.coordinates[a])).num());
      if (!is_constant(MFraction(x_[a].den()))) nonzero.push_back(x_[a].den());
    }
    std::set<std::size_t> used;
    for (const MPoly& f : equations)
      for (const std::size_t i : used_variables(f))
        used.insert(i);
    std::vector<std::size_t> main = v.main_variables();
    std::erase_if(main, [&](std::size_t i) { return !used.contains(i); });
    return {v.ring, main, equations, nonzero, budget_};
  }

  // V^2 = s V + t: V = s/2 + c r with r^2 = d, free of squares.
  [[nodiscard]] std::optional<Form> with_root(const MFraction& kinetic,
                                              const std::optional<std::vector<MFraction>>& minimal,
                                              const MFraction& potential) const {
    if (!minimal || minimal->size() != 3) return std::nullopt;
    const Rational half(Integer(1), Integer(2));
    const MFraction middle = -(half * (*minimal)[1]);
    const MFraction square = middle * middle - (*minimal)[0]; // (V - s/2)^2
    const auto [content, factors] = factor(square.num() * square.den());
    MPoly d(square.ring(), content);
    MFraction c(MPoly(square.ring(), Integer(1)), square.den());
    for (const MFactor& x : factors) {
      c *= pow(MFraction(x.base), x.exponent / 2);
      if (x.exponent % 2 != 0) d = d * x.base;
    }
    return with(kinetic + middle + c * form_.variable(names_.root),
                Root{d, (potential - middle) / c});
  }

  struct Root {
    MPoly radicand;
    MFraction value; ///< in the old coordinates
  };

  [[nodiscard]] std::optional<Form> with(const MFraction& h,
                                         const std::optional<Root>& root) const {
    const VectorField& v = form_.field;
    Form next = form_;
    VectorField& now = next.field;
    now.coordinates = names_.coordinates;
    now.coordinates.insert(now.coordinates.end(), names_.momenta.begin(), names_.momenta.end());
    now.functions.clear();
    std::erase_if(now.relations, [&](const MPoly& r) {
      return std::ranges::any_of(v.functions, [&](const auto& f) { return uses(r, f.variable); });
    });
    now.hamiltonian = h;
    for (const FunctionSymbol& f : v.functions)
      if (uses(h, f.variable)) return std::nullopt;
    Substitution user;
    for (std::size_t k = 0; k < v.dimension(); ++k)
      user[v.coordinates[k]] = form_.forward[k];
    next.forward.clear();
    for (const MFraction& x : x_)
      next.forward.push_back(substitute(x, user));
    const auto momenta = new_momenta();
    if (!momenta) return std::nullopt;
    for (const MFraction& p : *momenta)
      next.forward.push_back(substitute(p, user));
    if (root) add(*root, user, next);
    return next;
  }

  void add(const Root& root, const Substitution& user, Form& next) const {
    VectorField& v = next.field;
    const MFraction r = form_.variable(names_.root);
    FunctionSymbol f{names_.root, "sqrt(" + to_string(root.radicand) + ")", {}};
    for (const std::size_t i : v.coordinates)
      f.gradient.push_back(MFraction(derivative(root.radicand, i)) /
                           (MFraction(v.ring, Rational(2)) * r));
    v.functions.push_back(std::move(f));
    v.relations.push_back((r * r - MFraction(root.radicand)).num());
    Substitution back = user; // the radicand and V are told in the user's variables
    for (std::size_t a = 0; a < x_.size(); ++a)
      back[names_.coordinates[a]] = next.forward[a];
    next.functions[names_.root] = substitute(root.value, back);
  }

  // P = (dX/dq)^-T p.
  [[nodiscard]] std::optional<std::vector<MFraction>> new_momenta() const {
    Matrix jacobian;
    std::vector<MFraction> p;
    for (std::size_t i = 0; i < form_.degrees(); ++i) {
      jacobian.emplace_back();
      for (const MFraction& x : x_)
        jacobian.back().push_back(partial(form_.field, x, i));
      p.push_back(form_.variable(form_.p(i)));
    }
    return solve_linear(jacobian, p, budget_);
  }

  const Form& form_;
  const FlatNames& names_;
  const std::vector<MFraction>& x_;
  const Budget& budget_;
};

} // namespace

std::optional<Form> in_flat_coordinates(const Form& form, const FlatNames& names,
                                        const Budget& budget) {
  const auto g = kinetic_matrix(form);
  if (!g) return std::nullopt;
  const bool constant = std::ranges::all_of(*g, [&](const auto& row) {
    return std::ranges::all_of(row,
                               [&](const MFraction& x) { return form.is_constant_of_motion(x); });
  });
  if (constant) return std::nullopt;
  const auto x = FlatFunctions(form, *g, budget).run();
  if (x.size() != form.degrees()) return std::nullopt;
  return Elimination(form, names, x, budget).run();
}

} // namespace kov
