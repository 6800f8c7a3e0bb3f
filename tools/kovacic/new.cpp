// kovacic new KIND: an annotated file to start from, on standard output.

#include "commands.hpp"
#include "symbol/suggest.hpp"

namespace kov::cli {
namespace {

constexpr const char* ode_file =
    R"TOML(# One scalar equation.  Solve it with:  kovacic solve THIS_FILE
format = "equation/1"
title  = "Bessel's equation of order 1/2"
cite   = []                      # keys of your bibliography

[ode]
variable = "z"
# One of three forms:
#   ode = "z^2*y'' + z*y' + (z^2 - 1/4)*y = 0"     any linear equation of second order
#   p = "1/z"  and  q = "1 - 1/(4*z^2)"            y'' + p y' + q y = 0
#   r = "-1"                                       y'' = r y
# Numbers are exact: 1/2, I, sqrt(2), root(x^3 - 2, 1.26).  Products are written out: 2*z.
ode = "z^2*y'' + z*y' + (z^2 - 1/4)*y = 0"
# minpoly = "a^2 - 5"            # a name for one algebraic constant, by its polynomial

# [assume]                       # names without a value, and what is known about them
# n = "rational"

[[expect]]                       # each block is a test:  kovacic test THIS_FILE
group  = "Gm"                    # SL2 Borel T_n Ga Gm C_n trivial Dinf D_n A4 S4 A5
case   = 1                       # Kovacic's case, 1 to 4
source = "Kovacic1986, section 1"
)TOML";

} // namespace

int make_new(const Settings& settings, const std::string& kind) {
  static const std::vector<std::string> kinds{"ode"};
  if (kind == "ode") {
    write_output(settings, ode_file);
    return exit_decided;
  }
  const auto near = nearest(kind, kinds);
  complain(settings, "there is no starting file of the kind '" + kind + "'",
           near ? "did you mean " + *near + "?" : "kinds: " + enumerate(kinds));
  return exit_input;
}

} // namespace kov::cli
