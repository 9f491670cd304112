// What pins bear when everything stands still: the forces that leave no acceleration where bodies are pinned
// together. With a the accelerations by gravity, J the Jacobian of the pins and M the masses,
//     J 1/M J^T f = -J a.
// Redundant pins leave many solutions; this is the one which pins that all give alike (by their effective
// inverse mass K, as resolve/soft.h has it) would end with: least f^T K f.
// Method: conjugate gradients (Hestenes and Stiefel 1952) with the 2 x 2 blocks K as preconditioner, which
// from f = 0 stay within the range of K^-1 J and so end in that solution; nothing is assembled or factored,
// so loops cost nothing more. A grid of n x n pins takes some 4 n rounds.
#pragma once

#include <vector>

#include <cairn/physics/math.h>

namespace cairn::physics {

class PinStatics {
  public:
    /// What no pin can move.
    static constexpr int kFixed = 0;

    void clear();
    /// The result is its number.
    int add_body(float inverse_mass, float inverse_inertia, Vec2 acceleration_m_s2);
    /// Arms are from the centres of mass, in the axes of the world. The force is on b, N, where to start.
    void add_pin(int a, int b, Vec2 arm_a, Vec2 arm_b, Vec2 force);
    /// Until the residual is this share of what it is without forces, both measured by K^-1, or the rounds
    /// are used up. What is left is borne softly. The result is the rounds that it took.
    int solve(double tolerance = 1e-3);
    [[nodiscard]] Vec2 force(int pin) const;

  private:
    struct Pair {
        double x = 0;
        double y = 0;
    };
    struct Speed {
        double x = 0;
        double y = 0;
        double w = 0;
    };
    struct Body {
        double inverse_mass = 0;
        double inverse_inertia = 0;
        Pair acceleration;
    };
    struct Pin {
        int a = 0;
        int b = 0;
        Pair arm_a;
        Pair arm_b;
        double k00 = 0;  // K^-1
        double k01 = 0;
        double k11 = 0;
    };

    void respond(const std::vector<Pair>& force);
    [[nodiscard]] Pair opening(const Pin& pin) const;
    static Pair precondition(const Pin& pin, Pair residual);

    std::vector<Body> bodies_;
    std::vector<Pin> pins_;
    std::vector<Pair> forces_;
    std::vector<Speed> speeds_;  // what forces do to bodies
    std::vector<Pair> residual_;
    std::vector<Pair> along_;  // of the search
    std::vector<Pair> image_;
};

}  // namespace cairn::physics
