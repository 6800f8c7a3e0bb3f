#include "kovacic/family_log.hpp"

namespace kov::kovacic {

void note_families(Trace* trace, int kovacic_case, const std::string& what,
                   const Families& families) {
  if (trace == nullptr) return;
  note(trace, kovacic_case, 2,
       what + ": " + std::to_string(families.admissible.size()) + " of " +
           to_string(families.total) + (families.total == Integer(1) ? " family" : " families") +
           " (counted up to integers) with a natural number d.");
}

void FamilyLog::tried(const std::vector<Poly>& P, long degree,
                      const std::function<std::string()>& family) {
  constexpr int in_words = 100;
  if (trace_ == nullptr) return;
  if (++count_ <= in_words || !P.empty()) {
    const std::string found = P.empty() ? "no polynomial." : "P = " + to_string(P.front()) + ".";
    note(trace_, case_, 3,
         family() + ", degree of P at most " + std::to_string(degree) + ": " + found);
  } else if (count_ == in_words + 1) {
    note(trace_, case_, 3, "Further families are tried in the same way.");
  }
}

} // namespace kov::kovacic
