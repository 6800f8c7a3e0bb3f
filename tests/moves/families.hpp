#pragma once
// Families of systems on which the moves are tried.

#include "system/read_system.hpp"
#include "system/system.hpp"

#include <string>

namespace kov {

inline System on_e3(const std::string& parameters, const std::string& hamiltonian,
                    const std::string& assume = "") {
  return read_system(parse_document("[system]\nkind = 'euler-poisson'\n"
                                    "coordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
                                    "parameters = [" +
                                        parameters + "]\nhamiltonian = '" + hamiltonian + "'\n" +
                                        assume,
                                    "test.toml"));
}
inline System in_the_plane(const std::string& parameters, const std::string& hamiltonian,
                           const std::string& assume = "") {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['q1', 'q2']\n"
                                    "momenta = ['p1', 'p2']\nparameters = [" +
                                        parameters + "]\nhamiltonian = '" + hamiltonian + "'\n" +
                                        assume,
                                    "test.toml"));
}

inline const std::string free_top = "M1^2/(2*A) + M2^2/(2*B) + M3^2/(2*C)";
inline const std::string weight = "L1*G1 + L2*G2 + L3*G3";
inline const std::string body_assumed = "[assume]\nA = 'positive'\nB = 'positive'\nC = 'positive'\n"
                                        "L1 = 'real'\nL2 = 'real'\nL3 = 'real'\n";

inline System heavy_top_family(const std::string& assume = body_assumed) {
  return on_e3("'A', 'B', 'C', 'L1', 'L2', 'L3'", free_top + " + " + weight, assume);
}

} // namespace kov
