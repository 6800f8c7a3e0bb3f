#pragma once
// Steps 2 and 3 as lines of the trace.

#include "kovacic/families.hpp"
#include "kovacic/trace.hpp"

#include "exact/poly.hpp"

#include <functional>
#include <string>
#include <vector>

namespace kov::kovacic {

/// Step 2: how many families pass.
void note_families(Trace* trace, int kovacic_case, const std::string& what,
                   const Families& families);

/// Step 3: the families tried, the first hundred of them in words.
class FamilyLog {
public:
  FamilyLog(Trace* trace, int kovacic_case) : trace_(trace), case_(kovacic_case) {}
  void tried(const std::vector<Poly>& P, long degree, const std::function<std::string()>& family);

private:
  Trace* trace_;
  int case_;
  int count_ = 0;
};

} // namespace kov::kovacic
