#include "level/match.h"

#include <map>
#include <string>

namespace cairn::scripting {
namespace {

// By name, and those without one in the order in which equal ones stand.
std::vector<std::size_t> match_equal(const Level& before, const Level& now) {
    std::map<std::string, std::vector<std::size_t>> nameless;
    for (std::size_t i = before.parts.size(); i-- > 0;) {
        if (before.parts[i].name.empty()) nameless[signature_of(before.parts[i])].push_back(i);
    }
    std::vector<std::size_t> matches(now.parts.size(), kNoPart);
    for (std::size_t i = 0; i < now.parts.size(); ++i) {
        const LevelPart& part = now.parts[i];
        if (part.name.empty()) {
            const auto found = nameless.find(signature_of(part));
            if (found == nameless.end() || found->second.empty()) continue;
            matches[i] = found->second.back();
            found->second.pop_back();
        } else if (const auto found = before.find(part.kind, part.name);
                   found && signature_of(before.parts[*found]) == signature_of(part)) {
            matches[i] = *found;
        }
    }
    return matches;
}

// A joint that is made anew takes its frames from where its bodies stand, so these go back to where the
// level has them; and what else holds to them follows.
void spread_changes(const Level& now, std::vector<std::size_t>& matches) {
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (std::size_t i = 0; i < now.parts.size(); ++i) {
            for (const PartReference& reference : now.parts[i].references) {
                const auto other = now.find(split_part_name(reference.name).name);
                if (!other || (matches[i] == kNoPart) == (matches[*other] == kNoPart)) continue;
                matches[i] = matches[*other] = kNoPart;
                has_changed = true;
            }
        }
    }
}

}  // namespace

std::vector<std::size_t> match_parts(const Level& before, const Level& now) {
    std::vector<std::size_t> matches = match_equal(before, now);
    spread_changes(now, matches);
    return matches;
}

}  // namespace cairn::scripting
