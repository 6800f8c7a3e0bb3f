// What a canonical change of variables is: exact brackets, the same motion, and a way back.

#include "canonical/simplify.hpp"
#include "canonical/systems.hpp"

namespace kov {
namespace {

using test::Random;
using test::random_rounds;
using test::Step;

/// `now` in the variables of the old system that are written there.
CanonicalChange proposed(const System& old, const System& now,
                         const std::vector<std::string>& variables) {
  CanonicalChange change;
  change.system = now;
  for (const std::string& text : variables)
    change.variables.push_back(formula(old, text));
  return change;
}

System a_planar_one(Random& random) {
  return test::planar(random.one_of(
      std::vector<std::string>{"(u^2 + v^2 + x^2 + a*y^2)/2 + x^2*y - b*y^3/3",
                               "(u^2 + 2*v^2)/2 + a*x/(1 + y^2)", "u*v + x^3 + a*u^2*y"}));
}

MFraction random_function(const System& s, Random& random) {
  const auto x = [&] {
    const auto k = static_cast<std::size_t>(random.between(0, 3));
    return MFraction::variable(s.ring(), s.field.coordinates[k]);
  };
  return Rational(random.between(1, 5), random.between(1, 3)) * x() * x() + x() * x() * x() - x();
}

TEST(CanonicalChange, IsUndoneByItsInverse) {
  random_rounds(20, [](Random& random) {
    const System s = a_planar_one(random);
    const Form given = *form_of(s);
    Form form = given;
    std::vector<Step> word;
    for (int k = 0; k < 3; ++k) {
      word.push_back(test::random_step(form, random));
      form = test::changed(form, word.back());
    }
    while (!word.empty()) {
      form = test::changed(form, inverse(word.back()));
      word.pop_back();
    }
    EXPECT_EQ(form.forward, given.forward);
    EXPECT_EQ(*form.field.hamiltonian, *s.field.hamiltonian);
  });
}

TEST(CanonicalChange, KeepsBracketsAndTheMotion) {
  random_rounds(12, [](Random& random) {
    const System s = a_planar_one(random);
    Form form = *form_of(s);
    for (int k = 0; k < 2; ++k)
      form = test::changed(form, test::random_step(form, random));
    const CanonicalChange change = finished(s, form);
    ASSERT_TRUE(is_canonical(s, change));
    const auto back = [&](const MFraction& f) { return in_old_variables(change, s.ring(), f); };
    const VectorField& now = change.system.field;
    const MFraction f = random_function(change.system, random);
    const MFraction g = random_function(change.system, random);
    EXPECT_EQ(back(poisson_bracket(now, f, g)), poisson_bracket(s.field, back(f), back(g)));
    EXPECT_EQ(back(lie_derivative(now, f)), lie_derivative(s.field, back(f)));
    EXPECT_EQ(back(*now.hamiltonian), *s.field.hamiltonian);
  });
}

// The Hamiltonian goes along, so that the brackets alone object.
TEST(CanonicalChange, StretchesBothOfAPair) {
  random_rounds(12, [](Random& random) {
    const System s = a_planar_one(random);
    Form form = *form_of(s);
    form = test::changed(form, test::random_step(form, random));
    const std::size_t i = form.field.coordinates[static_cast<std::size_t>(random.between(0, 3))];
    const MFraction x = MFraction::variable(s.ring(), i);
    const Rational c = random.once_in(2) ? Rational(-1) : Rational(2, 3);
    form = test::changed(form, Step{{{i, Rational(1) / c * x}}, {{i, c * x}}});
    EXPECT_FALSE(is_canonical(s, finished(s, form)));
  });
}

TEST(CanonicalChange, ExchangesWithASign) {
  const System s = test::planar("(u^2 + v^2)/2 + x^4 + y^2");
  const System exchanged = test::planar("(x^2 + v^2)/2 + u^4 + y^2");
  EXPECT_TRUE(is_canonical(s, proposed(s, exchanged, {"u", "y", "-x", "v"})));
  EXPECT_TRUE(is_canonical(s, proposed(s, exchanged, {"-u", "y", "x", "v"})));
  EXPECT_FALSE(is_canonical(s, proposed(s, exchanged, {"u", "y", "x", "v"})));
  EXPECT_FALSE(is_canonical(s, proposed(s, exchanged, {"x", "y", "u", "v"})));
}

// X = x^2 has U = u/(2x); the brackets of the momenta are looked at, too.
TEST(CanonicalChange, OfCoordinatesDeterminesTheMomenta) {
  const System s = test::planar("(u^2 + v^2)/2 + x^4 + y*x^2");
  const auto accepted = [&](const std::string& h, const std::vector<std::string>& variables) {
    return is_canonical(s, proposed(s, test::planar(h), variables));
  };
  const std::string square = "2*x*u^2 + v^2/2 + x^2 + x*y";
  EXPECT_TRUE(accepted(square, {"x^2", "y", "u/(2*x)", "v"}));
  EXPECT_FALSE(accepted(square, {"x^2", "y", "u/x", "v"}));
  EXPECT_FALSE(accepted("x*u^2/2 + v^2/2 + x^2 + x*y", {"x^2", "y", "u/x", "v"}));
  EXPECT_FALSE(accepted("2*x*(u - y)^2 + v^2/2 + x^2 + x*y", {"x^2", "y", "u/(2*x) + y", "v"}));
  EXPECT_TRUE(
      accepted("2*x*(u - y)^2 + (v - x)^2/2 + x^2 + x*y", {"x^2", "y", "u/(2*x) + y", "v + x^2"}));
}

TEST(CanonicalChange, ByAParameterHoldsForAllOfItsValues) {
  const System s = test::planar("(u^2 + v^2)/2 + x^2*y");
  const System scaled = test::planar("(a^2*u^2 + v^2)/2 + x^2*y/a^2");
  EXPECT_TRUE(is_canonical(s, proposed(s, scaled, {"a*x", "y", "u/a", "v"})));
  EXPECT_FALSE(is_canonical(s, proposed(s, scaled, {"a*x", "y", "u/b", "v"})));
  EXPECT_FALSE(is_canonical(s, proposed(s, scaled, {"x", "y", "u", "v"}))); // true for a = 1 alone
}

TEST(CanonicalChange, IsRefusedWhereSomethingHasNoValue) {
  const System s = test::planar("(u^2 + v^2)/2 + x^4");
  const System pole = test::planar("(u^2 + v^2)/2 + x^4 + 1/(x - y)");
  EXPECT_FALSE(is_canonical(s, proposed(s, pole, {"x", "x", "u", "v"})));
  EXPECT_FALSE(is_canonical(s, proposed(s, s, {"x", "y", "u"})));
  const System one = test::hamiltonian("'x'", "'u'", "u^2/2 + x^4");
  EXPECT_FALSE(is_canonical(s, proposed(s, one, {"x", "u"})));
  const System field = read_system(parse_document(
      "[system]\nkind = 'vector-field'\ncoordinates = ['x', 'u']\n[system.field]\nx = 'u'\n"
      "u = '-4*x^3'\n",
      "field.toml"));
  EXPECT_FALSE(is_canonical(field, proposed(field, one, {"x", "u"})));
  EXPECT_FALSE(is_canonical(one, proposed(one, field, {"x", "u"})));
}

// R = sqrt(X^2 + Y^2) is r: its square and its derivatives say so.
TEST(CanonicalChange, ASquareRootIsTheOneThatIsMeant) {
  const System kepler =
      test::lagrangian("'r', 't'", "'vr', 'vt'", "(vr^2 + r^2*vt^2)/2 + 1/r - a*r*cos(t)");
  const CanonicalChange right = *simplified(kepler);
  ASSERT_EQ(right.functions.size(), 1U);
  const auto with = [&](auto spoil) {
    CanonicalChange other = right;
    for (auto& [i, value] : other.functions)
      value = spoil(value);
    return is_canonical(kepler, other);
  };
  EXPECT_TRUE(with([](const MFraction& r) { return r; }));
  EXPECT_FALSE(with([](const MFraction& r) { return -r; }));
  EXPECT_FALSE(with([](const MFraction& r) { return Rational(2) * r; }));
  EXPECT_FALSE(with([](const MFraction& r) { return r + MFraction(r.ring(), Rational(1)); }));
  // the other root, with its Hamiltonian
  CanonicalChange other = right;
  VectorField& v = other.system.field;
  const std::size_t i = other.functions.begin()->first;
  v.hamiltonian = substitute(*v.hamiltonian, {{i, -MFraction::variable(v.ring, i)}});
  v.components = hamiltonian_field(v, *v.poisson, *v.hamiltonian);
  other.functions[i] = -other.functions[i];
  EXPECT_TRUE(is_canonical(kepler, other));
}

} // namespace
} // namespace kov
