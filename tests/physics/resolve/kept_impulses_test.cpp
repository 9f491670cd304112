// Impulses kept before the first substep and put back after it, lane by lane.
#include "resolve/kept_impulses.h"

#include <array>
#include <catch2/catch.hpp>

namespace cairn::physics {
namespace {

constexpr float kRounding_m_s = 1e-6f;

// Seven bodies of 2 kg in a row on the world, each on the one before: contact i is lane i.
struct Row {
    Motions motions;
    ContactBlock block{};
    std::array<ContactBlock*, 1> blocks{&block};
    std::array<KeptImpulses, 1> kept{};

    Row() {
        for (int i = 0; i < kLanes; ++i) motions.add({}, 0, i == kWorldRow ? 0.0f : 0.5f, 1);
        motions.standing.assign(kLanes, kRests);
        motions.rounding_m_s.assign(kLanes, kRounding_m_s);
        motions.rounding_m_s[kWorldRow] = 0;
        for (int lane = 0; lane < kLanes - 1; ++lane) {
            block.a[lane] = lane;
            block.b[lane] = lane + 1;
            for (ContactBlockPoint& point : block.points) point.impulse[lane] = 1;
            block.friction_impulse[lane] = -0.25f;
        }
        keep_impulses(blocks, kept);
    }

    void rouse() { rouse_shifting(blocks, kept, motions); }
    void put_back() { put_impulses_back(blocks, kept, motions); }
};

}  // namespace

TEST_CASE("contacts between bodies that rest take all their impulses back, and others none") {
    Row row;
    row.motions.standing[3] = kStands;
    row.motions.standing[6] = kMovesAnyway;
    for (int lane = 0; lane < kLanes - 1; ++lane) {
        for (ContactBlockPoint& point : row.block.points) point.impulse[lane] = 2;
        row.block.friction_impulse[lane] = 0.5f;
    }
    row.put_back();
    for (const int lane : {0, 1, 4}) {
        for (const ContactBlockPoint& point : row.block.points) CHECK(point.impulse[lane] == 1);
        CHECK(row.block.friction_impulse[lane] == -0.25f);
    }
    for (const int lane : {2, 3, 5, 6}) {
        for (const ContactBlockPoint& point : row.block.points) CHECK(point.impulse[lane] == 2);
        CHECK(row.block.friction_impulse[lane] == 0.5f);
    }
}

TEST_CASE("both bodies of a contact of which an impulse changes by more than rounding stand only") {
    // N s, of the rounding of both bodies, by the sum of their inverse masses.
    const float most = 2 * kRounding_m_s / (0.5f + 0.5f);
    for (const float change : {0.9f * most, 1.1f * most}) {
        for (int which = 0; which < 3; ++which) {
            Row row;
            Lanes<float>& impulses = which < 2 ? row.block.points[which].impulse : row.block.friction_impulse;
            impulses[2] = 0;
            row.kept[0] = {{row.block.points[0].impulse, row.block.points[1].impulse},
                           row.block.friction_impulse};
            impulses[2] -= change;
            row.rouse();
            const std::uint8_t expected = change > most ? kStands : kRests;
            for (int body = 1; body < kLanes; ++body)
                CHECK(row.motions.standing[body] == (body == 2 || body == 3 ? expected : kRests));
            CHECK(row.motions.standing[kWorldRow] == kRests);
        }
    }
}

TEST_CASE("a contact of which nothing was known keeps its bodies from resting, and those that move move on") {
    Row row;
    row.kept[0].normal[0][4] = -1;
    row.motions.standing[5] = kMovesAnyway;
    row.rouse();
    CHECK(row.motions.standing[4] == kStands);
    CHECK(row.motions.standing[5] == kMovesAnyway);
    row.kept[0].normal[1][0] = -1;
    row.rouse();
    CHECK(row.motions.standing[1] == kStands);
    CHECK(row.motions.standing[kWorldRow] == kRests);
}

}  // namespace cairn::physics
