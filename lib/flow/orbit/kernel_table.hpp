#pragma once
// Instantiates the kernels of every set of effects for one pack type, and the loop that uses them.

#include "flow/orbit/kernels.hpp"

#include <utility>

namespace kov::flow {
inline namespace KOV_ISA {

/// The sets of effects that are compiled for T.
template <class T> inline constexpr const auto& sets_of = effect_sets;
template <class P> inline constexpr const auto& sets_of<Twin<P>> = coarse_sets;

template <class T> struct KernelTable { Kernel<T> of[sets_of<T>.size()]; };

template <class T, std::size_t... I>
constexpr KernelTable<T> make_table(std::index_sequence<I...>) {
  return {{{&jets<sets_of<T>[I], T>, &section_jets<sets_of<T>[I], T>}...}};
}

template <class T>
inline constexpr KernelTable<T>
    kernel_table = make_table<T>(std::make_index_sequence<sets_of<T>.size()>{});

template <class T>
void integrate_with(std::size_t set, const Model<typename Lanes<T>::Real>& model, bool sliding,
                    const Run<typename Lanes<T>::Real>& run, T* storage) {
  Stepper<T> stepper(kernel_table<T>.of[set], model, sliding, run, storage);
  stepper.integrate();
}

/// How many T the Stepper's storage needs.
template <class T> constexpr std::size_t storage_size(int order) {
  return static_cast<std::size_t>(Jet<T>::count) * static_cast<std::size_t>(order + 2);
}

} // namespace KOV_ISA
} // namespace kov::flow
