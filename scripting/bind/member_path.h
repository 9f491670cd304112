// Members of definitions as template arguments: `member<&Def::stiffness,
// &JointStiffness::frequency_hz>(def)`; and lists of what is described by them.
#pragma once

#include <array>
#include <cstddef>

namespace cairn::scripting {

/// The class that a pointer to member belongs to: `decltype(owner_of(&Def::length_m))`.
template <class T, class Owner>
Owner owner_of(T Owner::*);

template <auto First, auto... Rest, class Object>
constexpr auto& member(Object& object) {
    if constexpr (sizeof...(Rest) == 0) {
        return object.*First;
    } else {
        return member<Rest...>(object.*First);
    }
}

/// Arrays one after the other: parameters that several definitions share.
template <class T, std::size_t... kSizes>
constexpr auto joined(const std::array<T, kSizes>&... parts) {
    std::array<T, (kSizes + ...)> all{};
    std::size_t next = 0;
    const auto add = [&](const auto& part) {
        for (const T& element : part) all[next++] = element;
    };
    (add(parts), ...);
    return all;
}

}  // namespace cairn::scripting
