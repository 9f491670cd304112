// Compares data with described fields and notes every fault, where the Lua bindings stop at the first.
// Invariant: a fault names the file, line and column of the value, the path of the field, the value, the rule
// and, for a name that does not exist, the nearest one that does.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "bind/fields.h"
#include "data/value.h"

namespace cairn::scripting {

/// Some of the fields of an entry, with where they stand. An entry, its template and its material are three.
struct Layer {
    const Value* table = nullptr;
    std::string path;  ///< "bodies[3]", "templates.crate"
    std::string file;
};

/// "levels/one.lua:12:5: bodies[3]"; of what Tiled has made `levels/one.tmx:9: object 3 "crate" in layer
/// "a"`.
std::string place_of(const Layer& entry);
/// "levels/one.lua:12:9: bodies[3].radius"; `levels/one.tmx:9: object 3 "crate" in layer "a": width`.
std::string place_of(const Layer& entry, const Value& value, const std::string& field);
/// The entry as others are told of it: "bodies[3]", `object 3 "crate" in layer "a"`.
std::string told_name(const Layer& entry);
/// The value as its author wrote it: -1, "-16 pixels"; empty for tables.
std::string as_written(const Value& value);

class LevelChecker {
  public:
    /// "PLACE = VALUE: RULE". The value is left out for tables.
    void fault(const Layer& where, const Value& value, const std::string& field, const std::string& rule);
    /// Of the entry as a whole.
    void fault(const Layer& where, const std::string& rule);
    void fault_of_file(const std::string& file, const std::string& message);
    /// Of a line of the file.
    void fault_of_line(const std::string& file, int line, const std::string& message);
    /// The file whose faults come first.
    void begin(const std::string& file) { files_ = {file}; }

    /// Types, ranges and names of what is there.
    void check_fields(const Layer& layer, std::span<const Field* const> fields);
    /// The same, but for names: the table may have other fields too.
    void check_known_fields(const Layer& layer, std::span<const Field* const> fields);
    /// `"FIELD" is missing`, and the rest of the sentence.
    void missing(const Layer& where, std::string_view field, const std::string& rest);
    /// Required fields that none of the layers has. `exempt`: a field that may be absent nevertheless.
    void check_missing(std::span<const Layer> layers, std::span<const Field* const> fields,
                       std::string_view exempt = {});
    /// "no such WHAT; did you mean ...".
    void check_one_of(const Layer& layer, const Value& value, const std::string& field,
                      const std::string& what, std::span<const std::string> names);

    /// How often a fault was told; one that several parts share, as of their template, with each of them.
    [[nodiscard]] std::size_t count() const { return told_; }
    /// Whether a fault of that very table was told.
    [[nodiscard]] bool is_faulty(const Layer& layer) const { return faulty_.contains(layer.table); }
    /// Whether one was told of that very value, or of what it holds.
    [[nodiscard]] bool is_faulty(const Value& value) const { return faulty_.contains(&value); }
    /// Each once; those of the file that was read first come first, from its beginning to its end.
    [[nodiscard]] std::vector<std::string> faults() const;

  private:
    void check_value(const Layer& layer, const Value& value, const Field& field);
    void check_points(const Layer& layer, const Value& value, const std::string& field);

    struct Fault {
        std::size_t file;  ///< in the order in which files showed faults
        int line;
        int column;
        std::string text;
    };
    void add(const std::string& file, const Value& place, std::string text);

    std::vector<Fault> faults_;
    std::vector<std::string> files_;
    std::set<std::string> known_;
    std::set<const Value*> faulty_;
    std::size_t told_ = 0;
};

/// "bodies[3]" for the third one, whose index is 2.
std::string item_path(const std::string& list, std::size_t index);

/// Whether it is { x, y }.
bool is_point(const Value& value);

/// The value of the first layer that has the field, or null; `found_in` receives the layer.
const Value* find_in(std::span<const Layer> layers, std::string_view field, const Layer** found_in = nullptr);

}  // namespace cairn::scripting
