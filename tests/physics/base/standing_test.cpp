// Who stands after a substep, row by row.
#include "base/standing.h"

#include <catch2/catch.hpp>

namespace cairn::physics {
namespace {

constexpr float kH_s = 1.0f / 240;
constexpr float kSlow_m_s = 0.5f * kStillSpeed_m_s;  // still
constexpr float kFast_m_s = 1.5f * kStillSpeed_m_s;  // not

// Rows of 1 kg and 1 kg m2 that reach 1 m, before and after a substep.
struct Rows {
    Motions motions;

    explicit Rows(int count) {
        for (int i = 0; i <= count; ++i) {
            motions.add({}, 0, i == kWorldRow ? 0.0f : 1.0f, 1);
            motions.set_row(i, {}, 0, i == kWorldRow ? 0.0f : 1.0f, 1, 1);
            motions.mover[i] = i == kWorldRow ? MovedBy::Flight : MovedBy::Substeps;
        }
    }

    Stillness begin() {
        motions.standing.resize(static_cast<std::size_t>(motions.size()));
        const Stillness all = note_still(motions, 0, motions.size());
        begin_standing(motions, all);
        return all;
    }
    int note() { return note_standing(motions, kH_s, 0, motions.size()); }
    [[nodiscard]] bool stands(int row) const { return motions.standing[row] == kStands; }
};

}  // namespace

TEST_CASE("what is still before and after the first substep, and has not been moved by it, stands") {
    Rows rows(12);
    Motions& m = rows.motions;
    m.velocity[6].v.x = kFast_m_s;  // came with it, and was stopped
    rows.begin();
    m.velocity[6].v.x = 0;
    m.velocity[2].v = {kFast_m_s, 0};
    m.velocity[3].w = kFast_m_s;
    m.pose[4].d = {0, kFast_m_s * kH_s};  // pushed out of an overlap
    m.pose[5].theta = kFast_m_s * kH_s;
    m.mover[7] = MovedBy::Jointed;
    m.velocity[8].v = {0, kSlow_m_s};
    keep_moving(m, 9);
    m.mover[10] = MovedBy::Flight;
    m.velocity[11].w = m.velocity[11].v.x = 0.8f * kStillSpeed_m_s;  // together too fast
    m.velocity[12].w = kSlow_m_s;
    CHECK(rows.note() == 8);  // 2 to 7, 9 and 11: what flies is not asked
    for (const int row : {kWorldRow, 1, 8, 12}) CHECK(rows.stands(row));
    for (const int row : {2, 3, 4, 5, 6, 7, 9, 10, 11}) CHECK_FALSE(rows.stands(row));
}

TEST_CASE("what stands is where it was, and all that moves is where the substep left it") {
    Rows rows(2);
    Motions& m = rows.motions;
    rows.begin();
    m.velocity[1].v = {0, kSlow_m_s};
    m.pose[1].d = {0, kSlow_m_s * kH_s};
    m.pose[1].theta = -kSlow_m_s * kH_s;
    m.velocity[2].v = {0, 1};
    m.pose[2].d = {0, kH_s};
    CHECK(rows.note() == 1);
    CHECK(m.pose[1].d == Vec2{});
    CHECK(m.pose[1].theta == 0);
    CHECK(m.pose[2].d == Vec2{0, kH_s});
}

TEST_CASE("a body is still by the speed of its farthest point, whatever its mass and inertia") {
    Motions m;
    for (const float mass : {1e-3f, 1e3f}) {
        for (const float gyration : {0.01f, 1.0f}) {  // m
            m.add({}, 0, 1 / mass, 1 / (mass * gyration * gyration));
            const int row = m.size() - 1;
            for (const float reach : {0.1f, 1.0f}) {
                const float inertia = mass * gyration * gyration;
                m.set_row(row, {}, kSlow_m_s / reach, 1 / mass, 1 / inertia, reach);
                CHECK(is_still(m, row));
                m.set_row(row, {}, kFast_m_s / reach, 1 / mass, 1 / inertia, reach);
                CHECK_FALSE(is_still(m, row));
            }
        }
    }
}

TEST_CASE(
    "what has infinite mass stands only when it does not move at all, and while it creeps nothing does") {
    Rows rows(3);
    Motions& m = rows.motions;
    m.velocity[1].inverse_mass = 0;
    CHECK_FALSE(rows.begin().creeps);
    CHECK(rows.note() == 0);
    CHECK(rows.stands(1));
    m.velocity[1].v = {1e-9f, 0};
    CHECK(rows.begin().creeps);
    CHECK(m.standing.empty());
    m.velocity[1] = {{}, 1e-9f, 0};
    CHECK(rows.begin().creeps);
    m.velocity[1].v = {1, 0};  // it carries what is not still then
    CHECK_FALSE(rows.begin().creeps);
    CHECK(rows.note() == 1);
    CHECK_FALSE(rows.stands(1));
}

TEST_CASE("what stands is looked for where at least half of the rows are still") {
    Rows rows(9);
    for (int i = 5; i < 10; ++i) rows.motions.velocity[i].v = {1, 0};
    CHECK(rows.begin().still == 5);
    CHECK(rows.motions.standing.size() == 10);
    CHECK(rows.stands(kWorldRow));
    rows.motions.velocity[4].v = {1, 0};
    CHECK(rows.begin().still == 4);
    CHECK(rows.motions.standing.empty());
}

}  // namespace cairn::physics
