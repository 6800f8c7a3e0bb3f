// The smallest program: without CMake, g++ airy.cpp $(pkg-config --cflags --libs kovacic).
#include "decide/decide.hpp"

#include <iostream>

int main() {
  const kov::Decision airy = kov::decide({.r = kov::Poly::z(), .p = kov::RationalFunction()});
  std::cout << kov::to_string(*airy.component) << '\n';
  return airy.abelian == kov::Truth::no ? 0 : 1;
}
