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

constexpr const char* hamiltonian_file =
    R"TOML(# A Hamiltonian system.  kovacic find-manifolds THIS_FILE proposes manifolds, kovacic show THIS_FILE --stage r
# shows how far it goes, kovacic check THIS_FILE decides, kovacic test THIS_FILE runs the [[expect]] blocks.
format = "equation/1"
title  = "Henon-Heiles family"
cite   = []                      # keys of your bibliography

[system]
kind        = "hamiltonian"
coordinates = ["q1", "q2"]
momenta     = ["p1", "p2"]       # in the same order
parameters  = ["b", "h"]         # free constants; h will be the energy
hamiltonian = "(p1^2 + p2^2)/2 + (q1^2 + q2^2)/2 + q1^2*q2 + b/3*q2^3"
# sin, cos, exp, log, sqrt and x^(1/2) may be written as they are; other functions: docs/guide/system-files.md

[assume]                         # quoted in the answer; values that violate one are refused
b = "nonzero"

[[integral]]                     # a claim; it is proved or refuted
name = "H"

[[manifold]]                     # proved invariant
name      = "q2-axis"
equations = ["q1 = 0", "p1 = 0"]
level     = "H = h"              # cuts out the phase curves

[reduce]
manifold = "q2-axis"
variable = "q1"                  # the scalar equation is for its variation
change   = "z = q2"              # without this line a change of variable is proposed
# energy = "auto"                # also study the levels where singular places meet

[[expect]]                       # each block is a test
where   = { b = "-1", h = "1" }
verdict = "non-integrable"       # non-integrable, no-obstruction or undecided
group   = "SL2"
source  = "Ito1985"
)TOML";

constexpr const char* euler_poisson_file =
    R"TOML(# A rigid body: M' = M x dH/dM + Gamma x dH/dGamma, Gamma' = Gamma x dH/dM.
# kovacic find-manifolds THIS_FILE proposes manifolds, kovacic check THIS_FILE decides.
format = "equation/1"
title  = "Heavy top with two equal moments, centre of mass in the equatorial plane"
cite   = []

[system]
kind        = "euler-poisson"
coordinates = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
parameters  = ["A", "C", "h"]    # units with m g |L| = 1
hamiltonian = "(M1^2 + M2^2)/(2*A) + M3^2/(2*C) + Gamma1"
# gyrostat  = ["0", "0", "B"]    # the constant angular momentum of a rotor

[assume]
A = "positive"
C = "positive"

[[casimir]]
name  = "F1"
value = "Gamma1^2 + Gamma2^2 + Gamma3^2"

[[casimir]]
name  = "F2"
value = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"

[[manifold]]
name      = "pendulum"
equations = ["M1 = 0", "M3 = 0", "Gamma2 = 0"]
level     = ["F1 = 1", "H = h"]

[reduce]
manifold = "pendulum"
variable = "M1"
change   = "z = Gamma3/(1 + Gamma1)"

[[expect]]
where   = { A = "3", C = "1", h = "2" }
verdict = "non-integrable"
source  = "Ziglin1983"
)TOML";

constexpr const char* vector_field_file =
    R"TOML(# Any rational vector field.  Non-integrability is then in the sense of Ayoul and Zung: no complete set of
# commuting fields and first integrals.  kovacic check THIS_FILE decides.
format = "equation/1"
title  = "Lorenz equations along the w axis"
cite   = []

[system]
kind        = "vector-field"
coordinates = ["x", "y", "w"]
parameters  = ["sigma", "rho", "beta"]

[system.field]                   # one line for each coordinate
x = "sigma*(y - x)"
y = "x*(rho - w) - y"
w = "x*y - beta*w"

[[manifold]]
name      = "axis"
equations = ["x = 0", "y = 0"]

[reduce]
manifold = "axis"
variable = "x"

[[expect]]
where   = { sigma = "10", rho = "28", beta = "8/3" }
verdict = "non-integrable"
source  = "this program"
)TOML";

constexpr const char* lagrangian_file =
    R"TOML(# A Lagrangian system: the program goes over to momenta by itself (Legendre's transformation).
# kovacic classify THIS_FILE asks for which parameters it is integrable, kovacic check THIS_FILE decides along a manifold.
format = "equation/1"
title  = "Two coupled oscillators"
cite   = []

[system]
kind        = "lagrangian"
coordinates = ["x", "y"]
velocities  = ["x_dot", "y_dot"] # in the same order
parameters  = ["k", "h"]         # h will be the energy
lagrangian  = "(x_dot^2 + y_dot^2)/2 - (x^2 + y^2)/2 - k*x^2*y^2"

[[manifold]]                     # coordinates and their momenta p_x, p_y
name      = "one moves"
equations = ["x = 0", "p_x = 0"]
level     = "H = h"

[[expect]]                       # each block is a test
where   = { k = "1", h = "1" }
verdict = "non-integrable"
source  = "this program"
)TOML";

constexpr const char* poisson_file =
    R"TOML(# Any Poisson bracket: the entry in row i, column j is {x_i, x_j}; Jacobi's identity is checked.
# kovacic classify THIS_FILE asks for which parameters it is integrable, kovacic find-manifolds THIS_FILE proposes manifolds.
format = "equation/1"
title  = "A free body"
cite   = []

[system]
kind        = "poisson"
coordinates = ["M1", "M2", "M3"]
parameters  = ["a", "b", "c"]    # the moments of inertia
hamiltonian = "(M1^2/a + M2^2/b + M3^2/c)/2"
bracket = [
  ["0", "-M3", "M2"],
  ["M3", "0", "-M1"],
  ["-M2", "M1", "0"],
]

[[casimir]]                      # a claim; it is proved or refuted
name  = "F"
value = "M1^2 + M2^2 + M3^2"
)TOML";

constexpr const char* theorem_file =
    R"TOML(# A theorem from its steps: kovacic prove THIS_FILE, or -o proof.html.  docs/guide/theorem-files.md has all kinds of steps.
# kovacic classify FILE --as-theorem THIS_FILE writes one from what it finds.
format = "theorem/1"
title  = "The Henon-Heiles system with b = -1 is not integrable"
system = "henon_heiles.toml"     # kovacic new hamiltonian > henon_heiles.toml

[[node]]                         # the first one is the theorem
id     = "main"
title  = "Not integrable on one level, so not at all"
kind   = "case"                  # kovacic check, with these values
file   = "henon_heiles.toml"
where  = { b = "-1", h = "1" }
at     = { b = "-1" }            # where the step stands in the theorem's system
expect = "non-integrable"
needs  = ["energy"]

[[node]]
id    = "energy"
title = "The energy"
kind  = "claims"                 # every claim of the file holds exactly
file  = "henon_heiles.toml"
)TOML";

constexpr const char* scene_file =
    R"TOML(# A system and what is to be seen of it.  kovacic section THIS_FILE -o DIR writes points and pictures.
format = "equation/1"
title  = "Henon-Heiles"

[system]
kind        = "hamiltonian"      # or vector-field, poisson, euler-poisson, lagrangian
coordinates = ["x", "y"]
momenta     = ["u", "v"]
parameters  = ["b"]
hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - b/3*y^3"

[[scene]]                        # as many as you like; each with a name
name      = "energy_8"           # of the files that are written
title     = "Henon-Heiles, E = 1/8"
set       = { b = 1 }            # parameters; fractions, sqrt(2) and pi too
section   = "x"                  # seen where this formula is 0
direction = "upward"             # while it grows; or downward, both
# where   = "u"                  # and where this is positive
levels    = { H = "1/8" }        # of H and other functions
plot      = ["y", "v"]           # what is drawn; angles = [...]: modulo 2 pi
range     = [["-1/2", "7/10"], ["-1/2", "1/2"]]
grid      = [8, 8]               # starts; or seeds = [[0, "1/10"], ...], random = 50, states = [[x, y, u, v], ...]
crossings = 300                  # of each orbit; or time = 1000
indicator = "megno"              # colour by chaos: megno, lyapunov, fli
tolerance = "10^-15"             # of a step, relative to the scales of the coordinates
drift     = "10^-11"             # of the integrals, beyond which nothing is drawn
)TOML";

constexpr const char* scan_file =
    R"TOML(# One number of each orbit over a plane of starts or parameters.  kovacic section THIS_FILE -o DIR writes a matrix
# (NAME.npy, for numpy.load), a picture and, with --pictures html, a page; after a kill: the same line with --resume.
format = "equation/1"
title  = "Henon-Heiles"

[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
parameters  = ["b"]
hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - b/3*y^3"

[[scene]]
name      = "megno_8"
title     = "Henon-Heiles, E = 1/8"
set       = { b = 1 }
section   = "x"
levels    = { H = "1/8" }
plot      = ["y", "v"]
crossings = 100
tolerance = "10^-9"

[scene.scan]
of   = "megno"                   # or lyapunov, fli, crossings, time (of the end)
over = { y = ["-1/2", "7/10", 150], v = ["-1/2", "1/2", 125] }   # [from, to, cells]: one axis or two
# What is drawn is scanned over starts on the level.  Parameters of the system that 'set' leaves open: from one
# start, seeds = [[0, "1/10"]].  Coordinates: with states = [[x, y, u, v]], whose other coordinates stay.

[[scene]]
name      = "megno_b"
title     = "Henon-Heiles with b y^3/3, E = 1/8, y = 1/10"
section   = "x"
levels    = { H = "1/8" }
plot      = ["y", "v"]
seeds     = [["1/10", 0]]        # what no axis scans
crossings = 100
tolerance = "10^-9"
scan      = { of = "megno", over = { b = [-1, 1, 150], v = ["-9/20", "9/20", 125] } }
)TOML";

struct StartingFile {
  std::string kind;
  const char* text;
};

const std::vector<StartingFile> starting_files{{"ode", ode_file},
                                               {"hamiltonian", hamiltonian_file},
                                               {"euler-poisson", euler_poisson_file},
                                               {"lagrangian", lagrangian_file},
                                               {"poisson", poisson_file},
                                               {"vector-field", vector_field_file},
                                               {"theorem", theorem_file},
                                               {"scene", scene_file},
                                               {"scan", scan_file}};

} // namespace

int make_new(const Settings& settings, const std::string& kind) {
  if (settings.given) {
    write_output(settings, *settings.given);
    return exit_decided;
  }
  std::vector<std::string> kinds;
  for (const StartingFile& file : starting_files) {
    if (file.kind == kind) {
      write_output(settings, file.text);
      return exit_decided;
    }
    kinds.push_back(file.kind);
  }
  const auto near = nearest(kind, kinds);
  complain(settings, "there is no starting file of the kind '" + kind + "'",
           near ? "did you mean " + *near + "?" : "kinds: " + enumerate(kinds));
  return exit_input;
}

} // namespace kov::cli
