// Values of a level that come from a map of Tiled, each with its origin: what its author calls it, and as the
// editor shows it. What could not be read of the map stands as an unreadable value, for it is told already.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/tile_map.h>

#include "bind/fields.h"
#include "data/value.h"

namespace cairn::scripting {

/// What the author of a map sees values of: an object, a layer, or the map.
struct TiledThing {
    std::string name;
    int line = 0;
    /// What of it was told when the map was read, as MapObject has it.
    const std::set<std::string, std::less<>>* unreadable = nullptr;

    [[nodiscard]] bool lacks(std::string_view what) const;
    [[nodiscard]] bool lacks_any(std::initializer_list<std::string_view> what) const;
};

/// Whole numbers are integers: the editor does not tell 1 from 1.0, and bit sets and counts are integers
/// here.
Value to_value(double number);
Value to_value(const std::string& text);
Value to_value(bool is_true);
Value new_table();
Value unreadable_value();

/// The value as one of a thing's.
Value value_of(const TiledThing& thing, Value value, ValueOrigin origin = {});
/// An empty one.
Value table_of(const TiledThing& thing);
Value property_value(const TiledThing& thing, const std::string& name, const engine::TileProperty& property);

/// "-16 pixels".
std::string written_number(float number, std::string_view unit);

bool is_field(const std::vector<const Field*>& fields, std::string_view name);
/// Sets those that are fields and are not there yet; the others go into `data`.
void set_properties(Value& table, const TiledThing& thing, const engine::TileProperties& properties,
                    const std::vector<const Field*>& fields);
/// Stands for the fields whose properties could not be read.
void set_unreadable(Value& table, const TiledThing& thing, const std::vector<const Field*>& fields);

}  // namespace cairn::scripting
