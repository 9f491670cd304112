// Fields of parts that name other parts. Invariant: what is named can be made before what names it, or a
// fault is told of the field; but for the number of a prefab's bodies, which shows when it is made.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "level/check.h"
#include "level/reader.h"

namespace cairn::scripting {

class PartReferences {
  public:
    /// Bodies and joints that a part names, which is going to be that one of the level.
    void note(LevelPart& part, std::size_t number, const Layer& entry, std::span<const Field* const> fields);
    /// The name of a part could not be read, which is told: then a name that is unknown may be that.
    void note_lost_name() { lacks_names_ = true; }
    /// A name that no part may have, which is told where it is given.
    void note_refused_name(const std::string& name) { refused_names_.insert(name); }

    /// When all parts are known. Parts with a wrong one become faulty.
    void check(Level& level, LevelChecker& check) const;

  private:
    struct Waiting {
        Layer layer;
        const Field* field;
        Value name;
        std::size_t part;
    };
    /// Whether it is good; else it is told, unless something else is to blame.
    bool check_one(const Waiting& waiting, const Level& level, LevelChecker& check) const;

    std::vector<Waiting> waiting_;
    std::set<std::string> refused_names_;
    bool lacks_names_ = false;
};

}  // namespace cairn::scripting
