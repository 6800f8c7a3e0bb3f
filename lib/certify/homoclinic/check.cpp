#include "certify/homoclinic/check.hpp"

#include "certify/homoclinic/surface.hpp"
#include "exact/flint_matrix.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>
#include <cstdio>

namespace kov::certify {
namespace {

using Matrix = std::vector<std::vector<Interval>>;
using Vector = std::vector<Interval>;

constexpr long nearness = -20;     // binary logarithm: a guess is better than that
constexpr long first_radius = -90; // the same, of the box around the fixed point
constexpr int attempts = 4;        // boxes that are tried
constexpr long smallest_cone = -40, largest_cone = -4; // binary logarithms of kappa

// Some matrix near the inverse: any will do.
Matrix approximate_inverse(const Matrix& m) {
  const auto n = static_cast<long>(m.size());
  Matrix inverse = m;
  arb_mat_t a;
  arb_mat_init(a, n, n);
  const auto each = [&](auto visit) {
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < n; ++j)
        visit(arb_mat_entry(a, i, j),
              inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  };
  each([](arb_struct* entry, const Interval& x) { arb_set(entry, x.raw()); });
  const bool is_regular = arb_mat_approx_inv(a, a, Interval::bits) != 0;
  each([](const arb_struct* entry, Interval& x) { arb_get_mid_arb(x.raw(), entry); });
  arb_mat_clear(a);
  need(is_regular, "a matrix is singular, or nearly");
  return inverse;
}

// (2) K - m of Krawczyk's test for each unknown: -C F(m) + (1 - C J) [-r, r]
Vector contraction(const Matrix& c, const Vector& value, const Matrix& slope,
                   const Vector& radius) {
  const std::size_t n = value.size();
  Vector shift(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vector row(n);
    row[i] = Interval(1);
    for (std::size_t k = 0; k < n; ++k) {
      shift[i] = shift[i] - c[i][k] * value[k];
      for (std::size_t j = 0; j < n; ++j)
        if (arb_is_zero(slope[k][j].raw()) == 0) row[j] = row[j] - c[i][k] * slope[k][j];
    }
    for (std::size_t j = 0; j < n; ++j)
      shift[i] = shift[i] + row[j] * Interval::around_zero(radius[j]);
  }
  return shift;
}

bool all_below(const Vector& shift, const Vector& radius) {
  for (std::size_t i = 0; i < shift.size(); ++i)
    if (!(shift[i].most() < radius[i])) return false;
  return true;
}

// (3.1) The least kappa = 2^-k for which all matrices keep the cone around the first axis and stretch it.
Interval cone(const TwoRows& m) {
  const Interval a = m[0][0].sign() < 0 ? -m[0][0] : m[0][0];
  for (long k = smallest_cone; k <= largest_cone; ++k) {
    const Interval kappa = power_of_two(k), stretch = a - m[0][1].most() * kappa;
    if (Interval() < a && Interval(1) < stretch &&
        m[1][0].most() + m[1][1].most() * kappa < kappa * stretch)
      return kappa;
  }
  throw Refused{"no cone is kept"};
}

class HomoclinicCheck {
public:
  HomoclinicCheck(const HomoclinicCertificate& c, std::string& section)
      : c_(c), section_(section), surface_(c), near_(point(c.point)) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        axes_[i][j] = Interval(c.axes[i][j]).middle(); // any matrix will do
  }

  HomoclinicAccepted operator()() {
    section_ = "2";
    find_fixed_point();
    section_ = "3";
    find_manifolds();
    section_ = "4";
    connect();
    CheckedSteps::add_labels("kovacic-homoclinic/1", {"fixed-point", "manifolds", "crossing"});
    return {1, {p_[0].about(), p_[1].about()}};
  }

private:
  static State point(const FourNumbers& x) {
    State p;
    for (const Rational& q : x)
      p.push_back(Interval(q).middle());
    return p;
  }

  // ---- p

  void find_fixed_point() {
    const Chart& chart = c_.chart;
    const TwoNumbers middle{near_[chart[0]], near_[chart[1]]};
    Carried image;
    Vector radius(2, power_of_two(first_radius));
    const Vector shift = solved("the fixed point", radius, [&] {
      at_p_ =
          surface_.patch(chart, {middle[0].wider(radius[0]), middle[1].wider(radius[1])}, near_);
      image = surface_.carried(at_p_);
      const TwoRows d = image.by_chart(chart);
      return Equations{{image.middle[chart[0]] - middle[0], image.middle[chart[1]] - middle[1]},
                       {{d[0][0] - Interval(1), d[0][1]}, {d[1][0], d[1][1] - Interval(1)}}};
    });
    need(at_p_.holds(image.at), "the orbit may close on another sheet");
    p_ = {middle[0] + shift[0], middle[1] + shift[1]};
  }

  // Values at the middles of the unknowns, derivatives over their boxes.
  struct Equations {
    Vector value;
    Matrix slope;
  };
  // Krawczyk's test of equations over boxes of these radii, which grow: the solution minus the middle.
  template <class At> static Vector solved(const std::string& what, Vector& radius, At at) {
    Matrix c;
    for (int i = 0; i < attempts; ++i) {
      const Equations f = at();
      if (c.empty()) c = approximate_inverse(f.slope);
      Vector shift = contraction(c, f.value, f.slope, radius);
      if (!all_below(shift, Vector(shift.size(), power_of_two(nearness))))
        throw Refused{what + " is not near its guess"};
      if (all_below(shift, radius)) return shift;
      for (std::size_t k = 0; k < radius.size(); ++k) {
        const Interval s = shift[k].most(), r = radius[k] < s ? s : radius[k];
        radius[k] = (Interval(2) * r + power_of_two(-Interval::bits)).most();
      }
    }
    throw Refused{what + " is not proved"};
  }

  // ---- the graphs

  void find_manifolds() {
    const Interval reach(c_.reach);
    reach_ = reach - Interval::around_zero(power_of_two(-Interval::bits) * reach).most();
    const Interval r = Interval::around_zero(reach.most());
    TwoNumbers box;
    for (std::size_t i = 0; i < 2; ++i)
      box[i] = p_[i] + axes_[i][0] * r + axes_[i][1] * r;
    region_ = surface_.patch(c_.chart, box, near_);
    need(region_.holds(at_p_.at), "the fixed point may lie on another sheet");
    for (const int way : {1, -1}) {
      const Carried image = surface_.carried(region_, way);
      need(region_.holds(image.at), "the region may come back on another sheet");
      const TwoRows m = inverse(axes_) * (image.by_chart(c_.chart) * axes_);
      kappa_[way > 0 ? 0 : 1] =
          cone(way > 0 ? m : TwoRows{{{m[1][1], m[1][0]}, {m[0][1], m[0][0]}}});
    }
  }

  // Encloses all possible graphs: their points over an interval of the axis, and their tangents.
  [[nodiscard]] TwoNumbers on_graph(std::size_t axis, const Interval& along) const {
    const Interval off = Interval::around_zero(kappa_[axis]) * along;
    TwoNumbers z;
    for (std::size_t i = 0; i < 2; ++i)
      z[i] = p_[i] + axes_[i][axis] * along + axes_[i][1 - axis] * off;
    return z;
  }
  [[nodiscard]] TwoNumbers tangent(std::size_t axis) const {
    TwoNumbers t;
    for (std::size_t i = 0; i < 2; ++i)
      t[i] = axes_[i][axis] + axes_[i][1 - axis] * Interval::around_zero(kappa_[axis]);
    return t;
  }

  // ---- the orbit from one to the other

  void connect() {
    xi_ = Interval(c_.xi).middle();
    eta_ = Interval(c_.eta).middle();
    charts_ = {c_.chart};
    for (const FourNumbers& z : c_.orbit) {
      points_.push_back(point(z));
      charts_.push_back(surface_.chart_at(points_.back()));
    }
    charts_.push_back(c_.chart);
    Vector radius(2 * (points_.size() + 1));
    solved("the homoclinic orbit", radius, [&] {
      carry(radius);
      return equations();
    });
    look_at_ends(radius);
  }

  // The map over boxes around the z_k.
  void carry(const Vector& radius) {
    patches_ = {surface_.patch(c_.chart, on_graph(0, xi_.wider(radius[0])), near_)};
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const Chart& c = charts_[k + 1];
      const TwoNumbers box{points_[k][c[0]].wider(radius[2 * k + 1]),
                           points_[k][c[1]].wider(radius[2 * k + 2])};
      patches_.push_back(surface_.patch(c, box, points_[k]));
    }
    images_.clear();
    for (const SurfacePatch& p : patches_)
      images_.push_back(surface_.carried(p));
  }

  // At the middles of the unknowns, for all pairs of graphs.
  [[nodiscard]] Equations equations() const {
    const std::size_t n = images_.size();
    const TwoNumbers u = tangent(0), s = tangent(1), last = on_graph(1, eta_);
    TwoNumbers first = on_graph(0, xi_);
    for (std::size_t j = 0; j < 2; ++j)
      first[j] = first[j] - patches_[0].box[j].middle();
    Equations f{{}, Matrix(2 * n, Vector(2 * n))};
    for (std::size_t k = 0; k < n; ++k) {
      const Chart& c = charts_[k + 1];
      const TwoRows by = images_[k].by_chart(c);
      for (std::size_t i = 0; i < 2; ++i) {
        Vector& row = f.slope[2 * k + i];
        Interval at = images_[k].middle[c[i]] - (k + 1 < n ? points_[k][c[i]] : last[i]);
        if (k == 0) {
          at = at + (by * first)[i];
          row[0] = (by * u)[i];
        } else {
          row[2 * k - 1] = by[i][0];
          row[2 * k] = by[i][1];
        }
        row[k + 1 < n ? 2 * k + 1 + i : 2 * n - 1] = k + 1 < n ? Interval(-1) : -s[i];
        f.value.push_back(at);
      }
    }
    return f;
  }

  // The solution is an orbit on its sheets, from one graph to the other, and not p.
  void look_at_ends(const Vector& radius) const {
    for (const auto& [x, r] : {std::pair(xi_, radius.front()), std::pair(eta_, radius.back())}) {
      const Interval end = x.wider(r);
      need(end.sign() != 0 && end.most() < reach_,
           "an end is the fixed point, or outside of the region");
    }
    need(region_.holds(patches_[0].at), "the orbit may begin on another sheet");
    for (std::size_t k = 0; k < images_.size(); ++k)
      need((k + 1 < patches_.size() ? patches_[k + 1] : region_).holds(images_[k].at),
           "the orbit may come back on another sheet");
  }

  const HomoclinicCertificate& c_;
  std::string& section_; ///< the one that was last begun
  LevelSurface surface_;
  State near_; ///< p, guessed
  TwoRows axes_;
  TwoNumbers p_; ///< in the chart
  SurfacePatch at_p_, region_;
  Interval reach_;
  TwoNumbers kappa_;
  Interval xi_, eta_;
  std::vector<State> points_; ///< z_1 ... z_(n-1), guessed
  std::vector<Chart> charts_; ///< of z_0 ... z_n
  std::vector<SurfacePatch> patches_;
  std::vector<Carried> images_;
};

std::string rounded(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.12g", std::abs(x) < 1e-12 ? 0.0 : x);
  return text.data();
}

std::string over(const PhaseFunction& f) { return "(" + to_string(f.p) + ")/" + to_string(f.n); }

} // namespace

std::variant<HomoclinicAccepted, Rejected> check_homoclinic(const HomoclinicCertificate& c) {
  const CheckedSteps::File file;
  std::string section = "1";
  return verdict_at(section, [&] { return HomoclinicCheck(c, section)(); });
}

std::vector<std::string> statement(const HomoclinicCertificate& c,
                                   const HomoclinicAccepted& found) {
  const auto name = [&](std::size_t i) { return c.ring->name(i); };
  std::string at;
  for (std::size_t k = 0; k < 2; ++k)
    at += (k == 0 ? "" : ", ") + name(c.chart[k]) + " = " + rounded(found.fixed_point[k]);
  return {
      "H = " + over(c.hamiltonian) + " with " + name(0) + "' = dH/d" + name(2) +
          ", ..., on the level H = " + to_string(c.level) + ";",
      "the map of the section " + over(c.section) + " = 0, " + (c.rising ? "upward" : "downward") +
          (c.where ? ", where " + over(*c.where) + " > 0" : "") +
          (c.period > 1 ? ", to the power " + std::to_string(c.period) : ""),
      "has a hyperbolic fixed point at " + at + " and a transverse homoclinic point to it.",
      "So (trusted: Smale, Moser) it has a horseshoe, and every real-analytic first integral on "
      "a connected open part of the level around",
      "the closure of the homoclinic orbit is constant."};
}

} // namespace kov::certify
