// Oracle: the list itself. What happens to a body that is moved does so in the order of the list.
#include "world/plain_groups.h"

#include <catch2/catch.hpp>

#include "base/split_mix.h"

namespace cairn::physics {
namespace {

constexpr int kRows = 400;

// Row 0 is the world; some others only turn, or do not move at all.
Motions make_motions() {
    Motions motions;
    for (int row = 0; row < kRows; ++row) {
        const bool moves = row > 0 && row % 7 != 0;
        const bool turns = moves || row % 14 == 7;
        motions.add({}, 0, moves ? 1.0f : 0.0f, turns ? 1.0f : 0.0f);
    }
    return motions;
}

bool is_moved(const Motions& motions, int row) {
    return motions.velocity[row].inverse_mass > 0 || motions.inverse_inertia[row] > 0;
}

// Among rows, many of which have few contacts and one of which has many.
std::vector<ContactConstraint> make_contacts(int count, std::uint64_t seed) {
    SplitMix random(seed);
    std::vector<ContactConstraint> contacts(static_cast<std::size_t>(count));
    for (ContactConstraint& c : contacts) {
        c.a = static_cast<int>(random.real(0, 1.1) * kRows);
        if (c.a >= kRows) c.a = 5;
        c.b = static_cast<int>(random.real(0, kRows));
    }
    return contacts;
}

// Which contacts each moved row is in, one after the other.
using Histories = std::vector<std::vector<int>>;

void note(Histories& histories, const ContactConstraint& c, int place, const Motions& motions) {
    for (const int row : {c.a, c.b}) {
        if (is_moved(motions, row)) histories[static_cast<std::size_t>(row)].push_back(place);
    }
}

}  // namespace

TEST_CASE("contacts in groups are solved each once, and those of a body in their order") {
    const Motions motions = make_motions();
    for (const int threads : {1, 2, 4}) {
        TaskPool tasks(threads);
        PlainGroups groups;
        for (const int count : {0, 1, 30, 60, 150, 700}) {
            const std::vector<ContactConstraint> contacts =
                make_contacts(2 * count, static_cast<std::uint64_t>(count));
            std::vector<int> plain;  // every other one
            for (int i = 0; i < count; ++i) plain.push_back(2 * i + i % 2);
            Histories expected(kRows);
            for (const int place : plain)
                note(expected, contacts[static_cast<std::size_t>(place)], place, motions);

            groups.divide(plain, contacts, motions, tasks);
            Histories found(kRows);
            std::vector<int> times(contacts.size(), 0);
            groups.for_each(tasks, [&](int place) {
                note(found, contacts[static_cast<std::size_t>(place)], place, motions);
                ++times[static_cast<std::size_t>(place)];
            });
            INFO(threads << " threads, " << count << " contacts");
            CHECK(found == expected);
            std::vector<int> once(contacts.size(), 0);
            for (const int place : plain) once[static_cast<std::size_t>(place)] = 1;
            CHECK(times == once);
            CHECK((groups.parts() > 1) == (threads > 1 && count >= 60));
        }
    }
}

}  // namespace cairn::physics
