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
        const auto rows = static_cast<std::size_t>(motions.size());
        motions.standing.resize(rows);
        motions.kick.assign(rows, {});
        motions.rounding_m_s.assign(rows, -1);
        const Stillness all = note_still(motions, 0, motions.size());
        begin_standing(motions, all);
        return all;
    }
    // As integrate_velocities and contacts leave a row that is kicked and held, but for what is left over.
    void hold(int row, Vec2 kick_m_s, Vec2 left_over_m_s, float left_over_w = 0) {
        motions.kick[row] = {kick_m_s, 0, 0};
        motions.without_contacts[row] = {kick_m_s, 0, 1};
        motions.velocity[row] = {left_over_m_s, left_over_w, 1};
    }

    int note() { return note_standing(motions, kH_s, 0, motions.size()).moving; }
    [[nodiscard]] bool stands(int row) const { return physics::stands(motions.standing[row]); }
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

TEST_CASE("what stands rests if nothing is left over of a substep but rounding, and is stopped") {
    constexpr float kRounding_m_s = 1e-7f;
    Rows rows(6);
    Motions& m = rows.motions;
    rows.begin();
    m.rounding_m_s.assign(7, kRounding_m_s);
    m.rounding_m_s[4] = -1;
    const Vec2 kick_m_s{0, -0.0625f};
    rows.hold(1, kick_m_s, {0, 0.9f * kRounding_m_s});
    rows.hold(2, kick_m_s, {1.1f * kRounding_m_s, 0});
    rows.hold(3, kick_m_s, {0, 0.6f * kRounding_m_s}, 0.6f * kRounding_m_s);
    rows.hold(4, kick_m_s, {});
    rows.hold(5, kick_m_s, {0, kFast_m_s});
    m.rounding_m_s[5] = 1;
    rows.hold(6, kick_m_s, {-0.5f * kRounding_m_s, 0}, -0.4f * kRounding_m_s);
    const Standing found = note_standing(m, kH_s, 0, m.size());
    CHECK(found.moving == 1);
    CHECK(found.resting == 2);
    stop_resting(m, 0, m.size());
    for (const int row : {1, 6}) {
        CHECK(m.standing[row] == kRests);
        CHECK(m.velocity[row].v == Vec2{});
        CHECK(m.velocity[row].w == 0);
        CHECK(m.velocity[row].inverse_mass == 1);
    }
    for (const int row : {2, 3, 4}) {
        CHECK(m.standing[row] == kStands);
        CHECK((m.velocity[row].v != Vec2{} || row == 4));
    }
    CHECK(m.standing[5] == kMoves);
}

TEST_CASE("what a damped body keeps of a kick is what must be held of it") {
    Rows rows(1);
    Motions& m = rows.motions;
    rows.begin();
    m.kept.assign(2, {{0.5f, 0.5f}, 1, 1});
    m.kick[1] = {{0, -0.25f}, 0, 0};
    m.rounding_m_s[1] = 1e-7f;
    m.without_contacts[1] = {{0, -0.125f}, 0, 1};
    CHECK(note_standing(m, kH_s, 0, 2).resting == 1);
    m.kept.clear();
    m.standing[1] = kMoves;
    CHECK(note_standing(m, kH_s, 0, 2).resting == 0);
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
