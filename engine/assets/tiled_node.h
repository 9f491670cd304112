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
    int line = 0;  ///< from 1; 0: not known
};

/// A value of the file with the way to it, for messages: that of its author, `object 3 "crate" in layer
/// "things"`, and from there that of the file, "chunks[2]". Members of lists are counted from 1, as in Lua
/// and in the messages about levels.
class Node {
  public:
    /// All of a file.
    explicit Node(const Json& json) : Node(json, "", "", 0) {}

    /// The same value, which its author knows by a name.
    Node called(std::string owner) const { return Node(json_, std::move(owner), "", line_); }

    [[noreturn]] void fail(const std::string& rule) const {
        const std::string told = place();
        throw Fault{(told.empty() ? "" : told + ": ") + rule, line_};  // the file as a whole has no place
    }
    [[noreturn]] void fail(const char* field, const std::string& rule) const {
        const auto found = json_.find(field);
        const std::string value = found == json_.end() ? "missing" : excerpt(*found);
        throw Fault{(owner_.empty() ? "" : owner_ + ": ") + path_to(field) + " is " + value + ", but " + rule,
                    line_};
    }

    /// Empty for all of a file.
    std::string place() const {
        if (owner_.empty() || path_.empty()) return owner_ + path_;
        return owner_ + ": " + path_;
    }
    /// What the author knows by name, and this is a part of; empty: nothing.
    const std::string& owner() const { return owner_; }
    /// Of the innermost object around it whose line is known; 0: none.
    int line() const { return line_; }
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
    /// The object that it has there.
    Node child(const char* field) const { return Node(json_[field], owner_, path_to(field), line_); }
    std::vector<Node> list(const char* field) const {
        std::vector<Node> nodes;
        if (!has(field)) return nodes;
        if (!json_[field].is_array()) fail(field, "must be a list");
        for (std::size_t i = 0; i < json_[field].size(); ++i)
            nodes.push_back(
                Node(json_[field][i], owner_, path_to(field) + '[' + std::to_string(i + 1) + ']', line_));
        return nodes;
    }

  private:
    Node(const Json& json, std::string owner, std::string path, int line_around)
        : json_(json), owner_(std::move(owner)), path_(std::move(path)), line_(line_around) {
        if (!json_.is_object()) fail("must be an object");
        if (const auto line = json_.find(kLineMember); line != json_.end()) line_ = line->get<int>();
    }
    std::string path_to(const char* field) const { return (path_.empty() ? "" : path_ + '.') + field; }

    const Json& json_;
    std::string owner_;
    std::string path_;
    int line_;
};

}  // namespace cairn::engine
