#pragma once
// Several functions as one, for std::visit.

namespace kov {

/// Given   const Overloaded two{[](bool) { return 1; }, [](const char*) { return 2; }};
/// Example two(true)  // -> 1
template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };
template <class... Ts> Overloaded(Ts...) -> Overloaded<Ts...>;

} // namespace kov
