// A field of a prefab and the member of its definition that it sets, as one constant:
// `parameter<&RopeDef::from_m, &Position::x>(kX)`.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "bind/fields.h"
#include "bind/member_path.h"

namespace cairn::scripting {

/// A number or a boolean of a definition.
template <class Def>
struct PrefabParameter {
    const Field* field = nullptr;
    void (*set)(Def& def, double value) = nullptr;
};

template <auto First, auto... Rest>
constexpr auto parameter(const Field& field) {
    using Def = decltype(owner_of(First));
    return PrefabParameter<Def>{&field, [](Def& def, double value) {
                                    auto& place = member<First, Rest...>(def);
                                    place = static_cast<std::remove_reference_t<decltype(place)>>(value);
                                }};
}

template <class Def, std::size_t kCount>
void read_parameters(const FieldReader& reader, const std::array<PrefabParameter<Def>, kCount>& parameters,
                     Def& def) {
    for (const PrefabParameter<Def>& parameter : parameters) {
        const Field& field = *parameter.field;
        if (!reader.has(field)) continue;
        switch (field.type) {
            case FieldType::Boolean:
                parameter.set(def, reader.boolean(field) ? 1 : 0);
                break;
            case FieldType::Integer:
                parameter.set(def, static_cast<double>(reader.integer(field)));
                break;
            default:
                parameter.set(def, reader.number(field));
        }
    }
}

template <const auto& kParameters, std::size_t kMore = 0>
constexpr auto fields_with(const std::array<const Field*, kMore>& more = {}) {
    std::array<const Field*, kParameters.size() + kMore> fields{};
    std::size_t next = 0;
    for (const auto& parameter : kParameters) fields[next++] = parameter.field;
    for (const Field* field : more) fields[next++] = field;
    return fields;
}

}  // namespace cairn::scripting
