// Sequential impacts. Glossary: n, t normal and tangent; arm = k (r x n); K inverse effective mass:
//     Jv = n . (vB - vA) + armB wB - armA wA,    K_ij = 1/mA + 1/mB + armA_i armA_j + armB_i armB_j
// An impact of one point gives p = (1 + e) max(-Jv, 0) / K.
#include "resolve/impacts.h"

#include <algorithm>
#include <cmath>

namespace cairn::physics {
namespace {

// Of the fastest impact: what closes in slower has come to rest, for the next step to hold.
constexpr float kRestShare = 1e-5f;

// Rounds besides one for each contact, which a row of equal balls may need. What bounces a little needs more
// than one, what rests on others many.
constexpr int kSpareRounds = 16;

// Of the energy: what rounding may add.
constexpr double kRoundingShare = 1e-6;

struct Row {
    Vec2 axis;
    float arm_a;
    float arm_b;
};

Row normal_row(const Impact& hit, int point) {
    return {hit.normal, hit.points[point].arm_a, hit.points[point].arm_b};
}

float velocity_along(const Row& row, const VelocityRow& a, const VelocityRow& b) {
    return dot(row.axis, b.v - a.v) + row.arm_b * b.w - row.arm_a * a.w;
}

// Of two rows with the same axis, or of a row with itself.
float coupling(const Row& row, const Row& other, const VelocityRow& a, const VelocityRow& b) {
    float k = a.inverse_mass + b.inverse_mass;
    if (a.inverse_mass > 0) k += row.arm_a * other.arm_a;
    if (b.inverse_mass > 0) k += row.arm_b * other.arm_b;
    return k;
}

void push(const Row& row, VelocityRow& a, VelocityRow& b, float impulse) {
    if (a.inverse_mass > 0) {
        a.v -= a.inverse_mass * impulse * row.axis;
        a.w -= row.arm_a * impulse;
    }
    if (b.inverse_mass > 0) {
        b.v += b.inverse_mass * impulse * row.axis;
        b.w += row.arm_b * impulse;
    }
}

class Sequence {
  public:
    Sequence(std::span<Impact> impacts, Motions& motions) : impacts_(impacts), motions_(motions) {}

    // Whether all has come to rest.
    bool run() {
        const int rounds = static_cast<int>(impacts_.size()) + kSpareRounds;
        for (int round = 0; round < rounds; ++round) {
            bool any = false;
            for (Impact& hit : impacts_) any = happens(hit) || any;
            if (!any) return true;
        }
        return false;
    }

  private:
    VelocityRow& velocity(int row) { return motions_.velocity[static_cast<std::size_t>(row)]; }

    bool happens(Impact& hit) {
        VelocityRow& a = velocity(hit.a);
        VelocityRow& b = velocity(hit.b);
        std::array<float, 2> closing{};
        for (int i = 0; i < hit.count; ++i) closing[i] = -velocity_along(normal_row(hit, i), a, b);
        const float fastest = std::max(closing[0], closing[1]);
        fastest_m_s_ = std::max(fastest_m_s_, fastest);
        if (!(fastest > kRestShare * fastest_m_s_)) return false;

        std::array<float, 2> given{};
        const int first = closing[0] >= closing[1] ? 0 : 1;
        if (!both(hit, closing, given)) {
            const Row row = normal_row(hit, first);
            given[first] = lost_speed(hit, closing[first]) / coupling(row, row, a, b);
        }
        for (int i = 0; i < hit.count; ++i) {
            push(normal_row(hit, i), a, b, given[i]);
            hit.points[i].impulse += given[i];
        }
        rub(hit, given[0] + given[1], a, b);
        return true;
    }

    static float lost_speed(const Impact& hit, float closing_m_s) {
        return closing_m_s > hit.slow_m_s ? (1 + hit.restitution) * closing_m_s : closing_m_s;
    }

    // Two points that close in at once, and both push.
    bool both(const Impact& hit, const std::array<float, 2>& closing, std::array<float, 2>& given) {
        if (hit.count < 2 || !(closing[0] > 0) || !(closing[1] > 0)) return false;
        const VelocityRow& a = velocity(hit.a);
        const VelocityRow& b = velocity(hit.b);
        const Row p = normal_row(hit, 0);
        const Row q = normal_row(hit, 1);
        const float k00 = coupling(p, p, a, b);
        const float k11 = coupling(q, q, a, b);
        const float k01 = coupling(p, q, a, b);
        const float determinant = k00 * k11 - k01 * k01;
        if (!(determinant > 1e-3f * k00 * k11)) return false;  // too near each other to be told apart
        const float lost0 = lost_speed(hit, closing[0]);
        const float lost1 = lost_speed(hit, closing[1]);
        given = {(k11 * lost0 - k01 * lost1) / determinant, (k00 * lost1 - k01 * lost0) / determinant};
        if (given[0] >= 0 && given[1] >= 0) return true;
        given = {};
        return false;
    }

    static void rub(const Impact& hit, float normal_impulse, VelocityRow& a, VelocityRow& b) {
        if (hit.friction == 0) return;
        const Row row{right_perp(hit.normal), hit.tangent_arm_a, hit.tangent_arm_b};
        const float limit = hit.friction * normal_impulse;
        push(row, a, b, std::clamp(-velocity_along(row, a, b) / coupling(row, row, a, b), -limit, limit));
    }

    std::span<Impact> impacts_;
    Motions& motions_;
    float fastest_m_s_ = 0;
};

// Of what can be moved. Scaled spins are energies as they are.
double kinetic_energy(std::span<const int> rows, const Motions& motions) {
    double sum = 0;
    for (const int row : rows) {
        const VelocityRow& m = motions.velocity[static_cast<std::size_t>(row)];
        const auto spin = static_cast<double>(m.w);
        sum += static_cast<double>(length_squared(m.v)) / static_cast<double>(m.inverse_mass) + spin * spin;
    }
    return sum;
}

}  // namespace

bool let_happen(std::span<Impact> impacts, std::span<const int> rows, Motions& motions) {
    const double before = kinetic_energy(rows, motions);
    return Sequence(impacts, motions).run() && kinetic_energy(rows, motions) <= (1 + kRoundingShare) * before;
}

}  // namespace cairn::physics
