// Members of definitions as template arguments: `member<&Def::stiffness,
// &JointStiffness::frequency_hz>(def)`.
#pragma once

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

}  // namespace cairn::scripting
