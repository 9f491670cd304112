// Contacts that are solved in plain form, divided into groups that share no body that is moved: threads solve
// groups at once, and each group in its order, so what comes out is what one thread makes of the whole list.
#pragma once

#include <span>
#include <vector>

#include "base/motion.h"
#include "base/task_pool.h"
#include "base/union_find.h"
#include "resolve/contact_constraint.h"

namespace cairn::physics {

class PlainGroups {
  public:
    /// `plain` are places among the contacts, in the order in which they are solved. One thread needs no
    /// groups, and a few contacts are not worth them: then all are one.
    void divide(std::span<const int> plain, std::span<const ContactConstraint> contacts,
                const Motions& motions, const TaskPool& tasks);

    /// How many pieces of work threads may take.
    [[nodiscard]] std::size_t parts() const { return parts_.size(); }
    /// Calls solve(place) for all contacts, as they were divided.
    template <class Solve>
    void for_each(TaskPool& tasks, const Solve& solve) const {
        tasks.parallel_for(static_cast<int>(parts_.size()), 1, [&](const Chunk& chunk) {
            for (int p = chunk.begin; p < chunk.end; ++p) {
                const Part& part = parts_[static_cast<std::size_t>(p)];
                for (std::size_t i = part.begin; i < part.end; ++i) solve(order_[i]);
            }
        });
    }

  private:
    // Whole groups, as many as are worth a thread's while.
    struct Part {
        std::size_t begin;
        std::size_t end;
    };

    void find_groups(std::span<const int> plain, std::span<const ContactConstraint> contacts,
                     const Motions& motions);

    std::vector<int> order_;  // places among the contacts, group by group
    std::vector<Part> parts_;
    UnionFind sets_;             // of rows
    std::vector<int> group_of_;  // by row that is the root of a set
    std::vector<int> groups_;    // beside the plain ones
    std::vector<int> ends_;      // of each group, in the order
};

}  // namespace cairn::physics
