// Union-find over the rows that contacts join, and then the contacts by their sets, in the order of the
// first of each.
#include "world/plain_groups.h"

#include <algorithm>

#include "base/ample.h"
#include "base/slot_map.h"

namespace cairn::physics {
namespace {

// To hand work to another thread takes half a microsecond, a contact a sixth of one.
constexpr std::size_t kFew = 48;
constexpr std::size_t kContactsPerPart = 16;

bool moves(const Motions& motions, int row) {
    return motions.velocity[row].inverse_mass > 0 || motions.inverse_inertia[row] > 0;
}

}  // namespace

void PlainGroups::divide(std::span<const int> plain, std::span<const ContactConstraint> contacts,
                         const Motions& motions, const TaskPool& tasks) {
    parts_.clear();
    resize_amply(order_, plain.size());
    if (plain.empty()) return;
    if (tasks.threads() == 1 || plain.size() < kFew) {
        std::ranges::copy(plain, order_.begin());
        return push_amply(parts_, {0, plain.size()});
    }
    find_groups(plain, contacts, motions);
    std::size_t begin = 0;
    for (const int end : ends_) {
        const auto here = static_cast<std::size_t>(end);
        if (here - begin < kContactsPerPart && here < plain.size()) continue;
        push_amply(parts_, {begin, here});
        begin = here;
    }
}

void PlainGroups::find_groups(std::span<const int> plain, std::span<const ContactConstraint> contacts,
                              const Motions& motions) {
    sets_.reset(motions.size());
    for (const int place : plain) {
        const ContactConstraint& c = contacts[static_cast<std::size_t>(place)];
        if (moves(motions, c.a) && moves(motions, c.b)) sets_.unite(c.a, c.b);
    }
    // How many contacts each group has; then where it ends, once all are counted and put in their places.
    assign_amply(group_of_, static_cast<std::size_t>(motions.size()), kNone);
    resize_amply(groups_, plain.size());
    ends_.clear();
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const ContactConstraint& c = contacts[static_cast<std::size_t>(plain[i])];
        int& group = group_of_[static_cast<std::size_t>(sets_.find(moves(motions, c.a) ? c.a : c.b))];
        if (group == kNone) {
            group = static_cast<int>(ends_.size());
            push_amply(ends_, 0);
        }
        groups_[i] = group;
        ++ends_[static_cast<std::size_t>(group)];
    }
    int begin = 0;
    for (int& end : ends_) {
        const int count = end;
        end = begin;
        begin += count;
    }
    for (std::size_t i = 0; i < plain.size(); ++i)
        order_[static_cast<std::size_t>(ends_[static_cast<std::size_t>(groups_[i])]++)] = plain[i];
}

}  // namespace cairn::physics
