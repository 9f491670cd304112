// A value of a map's file with the way to it, for messages. Invariant: what is given out has the type and the
// range that was asked for; else a Fault names the place, the value and the rule.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "assets/json_text.h"

namespace cairn::engine {

using Json = nlohmann::ordered_json;

/// Thrown while a part of a map is read and caught by whoever reads its parts one by one: a fault can lie
/// deep.
struct Fault {
    std::string message;
};

/// A value of the file with the way to it, "layers[2].objects[5]", for messages. Members of lists are counted
/// from 1, as in Lua and in the messages about levels.
class Node {
  public:
    Node(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
        if (!json_.is_object()) fail("must be an object");
    }

    [[noreturn]] void fail(const std::string& rule) const {
        throw Fault{(place_.empty() ? "" : place_ + ": ") + rule};  // the file as a whole has no place
    }
    [[noreturn]] void fail(const char* field, const std::string& rule) const {
        const auto found = json_.find(field);
        const std::string value = found == json_.end() ? "missing" : excerpt(*found);
        throw Fault{(place_.empty() ? "" : place_ + '.') + field + " is " + value + ", but " + rule};
    }

    const std::string& place() const { return place_; }
    bool has(const char* field) const { return json_.contains(field) && !json_[field].is_null(); }
    const Json& at(const char* field) const { return json_[field]; }

    double number(const char* field, double otherwise) const {
        return has(field) ? number(field) : otherwise;
    }
    double number(const char* field) const {
        if (!has(field) || !json_[field].is_number() || !std::isfinite(json_[field].get<double>()))
            fail(field, "must be a number");
        return json_[field].get<double>();
    }
    int whole(const char* field, int low, int high) const {
        const double value = number(field);
        if (value != std::floor(value) || value < low || value > high)
            fail(field, "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
        return static_cast<int>(value);
    }
    int whole(const char* field, int low, int high, int otherwise) const {
        return has(field) ? whole(field, low, high) : otherwise;
    }
    std::uint32_t tile_bits(const char* field) const {
        const double value = number(field);
        if (value != std::floor(value) || value < 0 || value > 4294967295.0)
            fail(field, "must be a tile number");
        return static_cast<std::uint32_t>(value);
    }
    std::string text(const char* field, const std::string& otherwise = "") const {
        if (!has(field)) return otherwise;
        if (!json_[field].is_string()) fail(field, "must be a text");
        return json_[field].get<std::string>();
    }
    bool flag(const char* field, bool otherwise) const {
        if (!has(field)) return otherwise;
        if (!json_[field].is_boolean()) fail(field, "must be true or false");
        return json_[field].get<bool>();
    }
    std::vector<Node> list(const char* field) const {
        std::vector<Node> nodes;
        if (!has(field)) return nodes;
        if (!json_[field].is_array()) fail(field, "must be a list");
        const std::string place = (place_.empty() ? "" : place_ + '.') + field + '[';
        for (std::size_t i = 0; i < json_[field].size(); ++i)
            nodes.emplace_back(json_[field][i], place + std::to_string(i + 1) + ']');
        return nodes;
    }

  private:
    const Json& json_;
    std::string place_;
};

}  // namespace cairn::engine
