// Who is at rest after a substep, row by row.
#include "base/rest.h"

#include <catch2/catch.hpp>

namespace cairn::physics {
namespace {

constexpr float kH_s = 1.0f / 240;
constexpr float kSpeed_m_s = 0.5f * kStillSpeed_m_s;  // still
constexpr float kFast_m_s = 1.5f * kStillSpeed_m_s;   // not

// Rows of 1 kg and 1 kg m2 after a substep in which contacts took away what gravity gave.
struct Rows {
    Motions motions;

    explicit Rows(int count) {
        for (int i = 0; i <= count; ++i) motions.add({}, 0, i == kWorldRow ? 0.0f : 1.0f, 1);
        const auto size = static_cast<std::size_t>(motions.size());
        motions.kick.assign(size, {{0, -10 * kH_s}, 0, 0});
        for (std::size_t i = 0; i < size; ++i) {
            motions.mover[i] = i == kWorldRow ? Mover::Flight : Mover::Substeps;
            motions.without_contacts[i] = {{0, -10 * kH_s}, 0, motions.velocity[i].inverse_mass};
        }
        begin_rest(motions, motions.size());
    }

    int note() { return note_rest(motions, kH_s, 0, motions.size()); }
    [[nodiscard]] bool rests(int row) const { return motions.resting[row] == kAtRest; }
};

}  // namespace

TEST_CASE("what is still before and after the first substep, and has not been moved by it, is at rest") {
    Rows rows(10);
    Motions& m = rows.motions;
    m.velocity[2].v = {kFast_m_s, 0};
    m.velocity[3].w = kFast_m_s;
    m.pose[4].d = {0, kFast_m_s * kH_s};  // pushed out of an overlap
    m.pose[5].theta = kFast_m_s * kH_s;
    m.without_contacts[6].v.x = kFast_m_s;  // came with it, and was stopped
    m.mover[7] = Mover::Jointed;
    m.velocity[8].v = m.pose[8].d = {};
    m.velocity[8].v = {0, kSpeed_m_s};
    keep_from_rest(m, 9);
    m.mover[10] = Mover::Flight;
    CHECK(rows.note() == 7);  // 2 to 7 and 9: what flies is not asked
    for (const int row : {kWorldRow, 1, 8}) CHECK(rows.rests(row));
    for (const int row : {2, 3, 4, 5, 6, 7, 9, 10}) CHECK_FALSE(rows.rests(row));
}

TEST_CASE("what is at rest is where it was, and all that moves is where the substep left it") {
    Rows rows(2);
    Motions& m = rows.motions;
    m.velocity[1] = {{0, kSpeed_m_s}, 0, 1};
    m.pose[1].d = {0, kSpeed_m_s * kH_s};
    m.velocity[2] = {{0, 1}, 0, 1};
    m.pose[2].d = {0, kH_s};
    CHECK(rows.note() == 1);
    CHECK(m.pose[1].d == Vec2{});
    CHECK(m.pose[2].d == Vec2{0, kH_s});
}

TEST_CASE(
    "what has infinite mass is at rest only when it stands: a platform goes on however slowly it goes") {
    Rows rows(3);
    Motions& m = rows.motions;
    for (int i = 1; i <= 3; ++i) {
        m.velocity[i].inverse_mass = 0;
        m.kick[i] = m.without_contacts[i] = {};
    }
    m.velocity[1].v = m.without_contacts[1].v = {1e-9f, 0};
    m.velocity[2].w = m.without_contacts[2].w = 1e-9f;
    CHECK(rows.note() == 2);
    CHECK_FALSE(rows.rests(1));
    CHECK_FALSE(rows.rests(2));
    CHECK(rows.rests(3));
}

TEST_CASE("a heavy or light body is still by its speed, and by that of its radius of gyration") {
    Motions m;
    for (const float mass : {1e-3f, 1e3f}) {
        // w times sqrt(I): at a radius of gyration of 0.1 m, 1e-5 rad/s are 1e-6 m/s.
        const float inertia = mass * 0.01f;
        CHECK(is_still({}, 1e-5f * std::sqrt(inertia), 1 / mass));
        CHECK_FALSE(is_still({}, 3e-5f * std::sqrt(inertia), 1 / mass));
    }
}

TEST_CASE("damping of a body that stands is not taken for motion") {
    Rows rows(1);
    Motions& m = rows.motions;
    m.kept.assign(2, {{0.5f, 0.5f}, 0.5f, 1});
    m.without_contacts[1].v = {0, -5 * kH_s};
    CHECK(rows.note() == 0);
    CHECK(rows.rests(1));
}

TEST_CASE("rest is looked for where at least half of the rows are still") {
    Motions m;
    for (int i = 0; i < 10; ++i) m.add({}, 0, i == kWorldRow ? 0.0f : 1.0f, 1);
    for (int i = 5; i < 10; ++i) m.velocity[i].v = {1, 0};
    CHECK(count_still(m, 0, 10) == 5);
    CHECK(count_still(m, 4, 6) == 1);
    begin_rest(m, 5);
    CHECK(m.resting.size() == 10);
    CHECK(m.resting[kWorldRow] == kAtRest);
    begin_rest(m, 4);
    CHECK(m.resting.empty());
}

}  // namespace cairn::physics
