// The table of what this build has. Its values are definitions that features.cmake gives to this file alone,
// so that builds with different features share the object files of everything else.
#include "world/features.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace cairn::physics {
namespace {

struct Entry {
    std::string_view name;
    bool built_in;
};

// In the order of Feature.
constexpr std::array<Entry, kFeatures.size()> kEntries{{
    {"joints", CAIRN_WITH_JOINTS},
    {"direct_solver", CAIRN_WITH_DIRECT_SOLVER},
    {"sensors", CAIRN_WITH_SENSORS},
    {"chains", CAIRN_WITH_CHAINS},
    {"events", CAIRN_WITH_EVENTS},
    {"fracture", CAIRN_WITH_FRACTURE},
    {"restitution", CAIRN_WITH_RESTITUTION},
    {"rolling_resistance", CAIRN_WITH_ROLLING_RESISTANCE},
    {"surface_speed", CAIRN_WITH_SURFACE_SPEED},
    {"effects", CAIRN_WITH_EFFECTS},
    {"mover", CAIRN_WITH_MOVER},
    {"snapshots", CAIRN_WITH_SNAPSHOTS},
    {"prefabs", CAIRN_WITH_PREFABS},
}};

const Entry& entry(Feature feature) {
    return kEntries[static_cast<std::size_t>(feature)];
}

}  // namespace

std::string_view name(Feature feature) {
    return entry(feature).name;
}

bool is_built_in(Feature feature) {
    return entry(feature).built_in;
}

Error absence(Feature feature) {
    std::string words(name(feature));
    std::string option = words;
    std::replace(words.begin(), words.end(), '_', ' ');
    for (char& c : option) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const char* const verb = words.back() == 's' ? " were" : " was";
    return {words + verb + " left out of this build, which was made with CAIRN_WITH_" + option + "=OFF"};
}

check::Fault require_built_in(Feature feature, bool used) {
    if (!used || is_built_in(feature)) return {};
    return absence(feature);
}

}  // namespace cairn::physics
