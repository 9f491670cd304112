// How the laws of joints are kept, whatever the kind. Glossary: J v speed along a direction, K = J 1/M J^T
// the inverse effective mass, p impulse of a law in this substep.
//     held and limits:   p += -K^-1 mass_scale (J v + bias_rate C) - impulse_scale p        (resolve/soft.h)
//     motors:            p += -K^-1 (J v - speed)
//     springs:           p+ = -R^-1 (d1 (J v + K (p+ - p)) + d0 Jv_before + stiffness C) (exact_spring.h),
//                        with R the K that they are made for                          (spring_mobility.h)
// Springs are left alone while relaxing: that would take their force out again, a damping that nobody asked
// for. Stiff ones that bear are solved then once more with the C of before the bodies moved, which leaves
// their force in. Crowded springs are swept apart, with the same law.
//
// On rails (wheel and prismatic joints, and welds that hold an angle) a spring at a lever and what is held
// across it call for each other, and swept one after the other they fed each other
// (docs/adr/012-direct-solver.md). With h for what is held and w = K_hh^-1 K_hs, an impulse p of the spring
// comes with -w p of what is held, which leaves the held speeds alone, and J v stands for J v - w J_h v,
// which no impulse of what is held changes: K - K_sh w answers. The law is that of K all the same, as when
// solved directly, so that both draw alike. Where the spring loses energy, C stands for C - w C_h, so that it
// does not draw against the rail while that is pushed straight.
#include "resolve/joints/joint_solver.h"

#include <algorithm>
#include <cmath>

#include "base/ample.h"
#include "resolve/joints/kinds.h"
#include "resolve/joints/small_system.h"
#include "resolve/joints/spring_mobility.h"

namespace cairn::physics {
namespace {

using Values = std::array<float, kMaxDirections>;

// Of one body in K.
float share(const Motion& body, const Jacobian& d, const Jacobian& e) {
    return dot(d.linear, velocity_change(body, e.linear)) + body.inverse_inertia * d.angular * e.angular;
}

// How the bodies of one joint move along its directions while it is worked on, and what they were pushed.
// Laws need no more: K says what an impulse along one direction does along the others, and bodies get all
// impulses at the end. There are two bodies, or up to so many.
template <int kMany>
class Along {
  public:
    Along(const JointConstraint& c, const JointPlace& at, const Motions& motions) : c_(c), at_(at) {
        for (int d = 0; d < kMaxDirections; ++d) speed_[d] = speed_of(c, at.directions[d], motions);
    }

    static float speed_of(const JointConstraint& c, const Direction& d, const Motions& motions) {
        float sum = 0;
        for (int i = 0; i < count(c); ++i) {
            const int row = c.rows[i];
            sum += dot(d.j[i].linear, motions.velocity[row].v) + d.j[i].angular * motions.spin(row);
        }
        return sum;
    }

    [[nodiscard]] float speed(int direction) const { return speed_[direction]; }

    void push(int direction, float impulse) {
        pushed_[direction] += impulse;
        for (int d = 0; d < kMaxDirections; ++d) speed_[d] += at_.inverse_mass[direction][d] * impulse;
    }

    void write(Motions& motions) const {
        for (int i = 0; i < count(c_); ++i) {
            Vec2 linear;
            float angular = 0;
            for (int d = 0; d < kMaxDirections; ++d) {
                linear += pushed_[d] * at_.directions[d].j[i].linear;
                angular += pushed_[d] * at_.directions[d].j[i].angular;
            }
            const int row = c_.rows[i];
            VelocityRow& velocity = motions.velocity[row];
            // An infinite impulse times no inverse mass is NaN, and would reach all that touches the world.
            if (velocity.inverse_mass > 0)
                velocity.v += velocity.inverse_mass * without_locked(linear, motions.locked_axes(row));
            // 1/I over the scale of the row, which is its root.
            if (motions.inverse_inertia[row] > 0) velocity.w += motions.pose[row].k * angular;
        }
    }

  private:
    static int count(const JointConstraint& c) { return kMany == 2 ? 2 : c.bodies; }

    const JointConstraint& c_;
    const JointPlace& at_;
    std::array<float, kMaxDirections> speed_;
    std::array<float, kMaxDirections> pushed_{};
};

// Calls work(along) for the joint and writes what comes of it; nearly all have two bodies.
template <class Work>
void with_bodies(const JointConstraint& c, const JointPlace& at, Motions& motions, Work&& work) {
    if (c.bodies == 2) {
        Along<2> along(c, at, motions);
        work(along);
        along.write(motions);
    } else {
        Along<kMaxJointBodies> along(c, at, motions);
        work(along);
        along.write(motions);
    }
}

// One law with its directions, of which there are so many.
template <int kCount>
struct Task {
    JointConstraint& c;
    JointLaw& law;
    const JointPlace& place;
    const Direction* directions;  // the first
    float sign;                   // upper limits look back

    [[nodiscard]] float& impulse(int i) const {
        return c.impulse[static_cast<std::size_t>(impulse_index(law.direction + i, role_of(law.kind)))];
    }
    [[nodiscard]] float error(int i) const { return sign * (directions[i].q - law.target); }
};

template <int kCount>
Task<kCount> task_of(JointConstraint& c, JointLaw& law, const JointPlace& place) {
    return {c, law, place, &place.directions[law.direction], law.kind == LawKind::Upper ? -1.0f : 1.0f};
}

// Calls work(task) with the law's directions counted when this is compiled.
template <class Work>
void with_task(JointConstraint& c, JointLaw& law, const JointPlace& place, Work&& work) {
    if (law.count == 1) return work(task_of<1>(c, law, place));
    if (law.count == 2) return work(task_of<2>(c, law, place));
    work(task_of<3>(c, law, place));
}

// Directions that a joint has not are 0 altogether.
void place_joint(const JointConstraint& c, std::span<const JointConstraint> all, const Motions& motions,
                 JointPlace& at) {
    place(c, all, motions, at.directions);
    for (int i = c.directions; i < kMaxDirections; ++i) at.directions[i] = {};
    at.inverse_mass = {};
    bool locked = false;
    float inverse_mass = 0;
    for (int b = 0; b < c.bodies; ++b) {
        const Motion body = motions.get(c.rows[b]);
        locked = locked || body.locked != 0;
        inverse_mass += body.inverse_mass;
        for (int i = 0; i < c.directions; ++i) {
            for (int j = 0; j <= i; ++j)
                at.inverse_mass[i][j] += share(body, at.directions[i].j[b], at.directions[j].j[b]);
        }
    }
    for (int i = 0; i < kMaxDirections; ++i) {
        for (int j = 0; j < i; ++j) at.inverse_mass[j][i] = at.inverse_mass[i][j];
    }
    at.least_mobility = locked ? kLeastMobility * inverse_mass : 0;
}

// K x = b.
template <int kCount>
Values solve(const Task<kCount>& task, const Values& b) {
    return solve_small<kCount>(task.place.inverse_mass, task.law.direction, b, task.place.least_mobility);
}

template <int kCount, int kMany>
void apply(const Task<kCount>& task, Along<kMany>& along, const Values& wanted) {
    for (int i = 0; i < kCount; ++i) {
        along.push(task.law.direction + i, task.sign * (wanted[i] - task.impulse(i)));
        task.impulse(i) = wanted[i];
    }
}

// Impulses as the caps allow them.
void clamp(const JointLaw& law, Values& wanted) {
    if (law.round) {
        const float size = length(Vec2{wanted[0], wanted[1]});
        if (size > law.high) {
            for (float& p : wanted) p *= law.high / size;
        }
    } else {
        wanted[0] = std::clamp(wanted[0], law.low, law.high);
    }
}

template <int kCount, int kMany>
Values solve_soft(const Task<kCount>& task, const Along<kMany>& along, const Softness& soft) {
    Values rhs{};
    for (int i = 0; i < kCount; ++i) {
        rhs[i] = -(along.speed(task.law.direction + i) * task.sign + soft.bias_rate * task.error(i));
    }
    Values change = solve(task, rhs);
    for (int i = 0; i < kCount; ++i) {
        change[i] = soft.mass_scale * change[i] + (1 - soft.impulse_scale) * task.impulse(i);
    }
    return change;
}

template <int kCount, int kMany>
void solve_hold(const Task<kCount>& task, Along<kMany>& along, Pass pass) {
    apply(task, along, solve_soft(task, along, pass == Pass::Biased ? task.law.softness : kRigid));
}

// A gap may close, but no further.
template <int kCount, int kMany>
void solve_limit(const Task<kCount>& task, Along<kMany>& along, float h_s, Pass pass) {
    const float gap = task.error(0);
    Softness soft = pass == Pass::Biased ? task.law.softness : kRigid;
    if (gap > 0) soft = {1 / h_s, 1, 0};
    // Most limits have nothing to do: they bear nothing, and nothing comes to them within the substep.
    const bool comes = along.speed(task.law.direction) * task.sign + soft.bias_rate * gap <= 0;
    if (!comes && task.impulse(0) == 0) return;
    Values wanted = solve_soft(task, along, soft);
    wanted[0] = std::max(wanted[0], 0.0f);
    apply(task, along, wanted);
}

// At limits it stops: one that pushed on would hold them open, by as much as they are soft.
template <int kCount>
float motor_speed(const Task<kCount>& task, int part, float h_s, Pass pass) {
    float speed = task.law.speed[part];
    for (int l = 0; l < task.c.law_count; ++l) {
        const JointLaw& limit = task.c.laws[l];
        const bool is_limit = limit.kind == LawKind::Lower || limit.kind == LawKind::Upper;
        if (!is_limit || limit.direction != task.law.direction + part) continue;
        const float way = limit.target - task.directions[part].q;  // to the limit
        const bool apart = limit.kind == LawKind::Upper ? way > 0 : way < 0;
        const float rate = apart ? 1 / h_s : pass == Pass::Biased ? limit.softness.bias_rate : 0;
        speed = limit.kind == LawKind::Upper ? std::min(speed, rate * way) : std::max(speed, rate * way);
    }
    return speed;
}

template <int kCount, int kMany>
void solve_motor(const Task<kCount>& task, Along<kMany>& along, float h_s, Pass pass) {
    Values rhs{};
    for (int i = 0; i < kCount; ++i)
        rhs[i] = motor_speed(task, i, h_s, pass) - along.speed(task.law.direction + i);
    Values wanted = solve(task, rhs);
    for (int i = 0; i < kCount; ++i) wanted[i] += task.impulse(i);
    clamp(task.law, wanted);
    apply(task, along, wanted);
}

// The law of a spring that had the impulse p, at this speed, which follows further impulses by `answering`.
template <int kCount>
Values spring_impulse(const Task<kCount>& task, const Values& speed, const Values& error,
                      const SmallMatrix& answering, const Values& p) {
    const ExactSpring& spring = task.law.spring;
    const SpringMobility own = mobility_of(task.law, task.place);
    SmallMatrix k{};
    k[0][0] = own.xx;
    k[0][1] = k[1][0] = own.xy;
    k[1][1] = own.yy;
    Values rhs{};
    for (int i = 0; i < kCount; ++i) {
        rhs[i] = -(spring.d1 * speed[i] + spring.d0 * task.law.speed_before[i] +
                   spring.stiffness_per_s * error[i]);
        for (int j = 0; j < kCount; ++j) {
            k[i][j] += spring.d1 * answering[i][j];
            rhs[i] += spring.d1 * answering[i][j] * p[j];
        }
    }
    return solve_small<kCount>(k, 0, rhs, task.place.least_mobility);
}

template <int kCount>
Values errors(const Task<kCount>& task) {
    Values error{};
    for (int i = 0; i < kCount; ++i) error[i] = task.error(i);
    return error;
}

// What is held across a spring, and answers with it.
struct Rail {
    int first = 0;  // of the directions that are held
    int held = 0;
    std::array<Values, 2> answer{};  // w, of each direction of the spring
    SmallMatrix answering{};         // of K, what answers
};

bool holds_angle(const JointConstraint& weld) {
    return std::any_of(weld.laws.begin(), weld.laws.begin() + weld.law_count,
                       [](const JointLaw& law) { return law.kind == LawKind::Hold && law.direction == 2; });
}

template <int kCount>
Rail rail_of(const Task<kCount>& task) {
    Rail rail;
    const auto& k = task.place.inverse_mass;
    const int spring = task.law.direction;
    for (int i = 0; i < kCount; ++i) {
        for (int j = 0; j < kCount; ++j) rail.answering[i][j] = k[spring + i][spring + j];
    }
    if (task.c.kind == JointKind::Wheel) rail.held = 1;
    if (task.c.kind == JointKind::Prismatic) rail.held = 2;
    if (task.c.kind == JointKind::Weld && spring == 0 && holds_angle(task.c)) {
        rail.first = 2;
        rail.held = 1;
    }
    if (rail.held == 0) return rail;
    for (int i = 0; i < kCount; ++i) {
        Values across{};
        for (int h = 0; h < rail.held; ++h) across[h] = k[spring + i][rail.first + h];
        rail.answer[i] = solve_small(k, rail.first, rail.held, across, task.place.least_mobility);
        for (int h = 0; h < rail.held; ++h) {
            for (int j = 0; j < kCount; ++j)
                rail.answering[i][j] -= rail.answer[i][h] * k[rail.first + h][spring + j];
        }
        rail.answering[i][i] = std::max(rail.answering[i][i], 0.0f);
    }
    return rail;
}

// What the rail gives with a change of the spring's impulse.
template <int kCount>
void take_of_rail(const Task<kCount>& task, const Rail& rail, const Values& change) {
    for (int h = 0; h < rail.held; ++h) {
        float& impulse =
            task.c.impulse[static_cast<std::size_t>(impulse_index(rail.first + h, Role::HoldOrSpring))];
        for (int i = 0; i < kCount; ++i) impulse -= rail.answer[i][h] * change[i];
    }
}

template <int kCount, int kMany>
void solve_spring(const Task<kCount>& task, Along<kMany>& along, Pass pass) {
    const Rail rail = rail_of(task);
    Values speed{};
    Values error = errors(task);
    Values before{};
    for (int i = 0; i < kCount; ++i) {
        before[i] = task.impulse(i);
        speed[i] = along.speed(task.law.direction + i);
        for (int h = 0; h < rail.held; ++h) {
            speed[i] -= rail.answer[i][h] * along.speed(rail.first + h);
            if (task.law.spring.damped)
                error[i] -= rail.answer[i][h] * task.place.directions[rail.first + h].q;
        }
    }
    if (task.law.spring.relaxes) {
        for (int i = 0; i < kCount; ++i) {
            float& start = task.law.start_error[i];
            if (pass == Pass::Biased) start = error[i];
            error[i] = start;
        }
    }
    Values wanted = spring_impulse(task, speed, error, rail.answering, before);
    clamp(task.law, wanted);
    Values change{};
    for (int i = 0; i < kCount; ++i) change[i] = wanted[i] - before[i];
    for (int h = 0; h < rail.held; ++h) {
        float answer = 0;
        for (int i = 0; i < kCount; ++i) answer -= rail.answer[i][h] * change[i];
        along.push(rail.first + h, answer);
    }
    take_of_rail(task, rail, change);
    apply(task, along, wanted);
}

// A cap of the substep is twice that of half an impulse.
template <int kCount, int kMany>
void start_spring(const Task<kCount>& task, Along<kMany>& along, float h_s) {
    Values change{};
    for (int i = 0; i < kCount; ++i) {
        change[i] = 2 * starting_speed(static_cast<double>(task.law.spring_frequency_hz),
                                       static_cast<double>(task.law.spring_damping_ratio),
                                       static_cast<double>(h_s), static_cast<double>(task.error(i)),
                                       static_cast<double>(along.speed(task.law.direction + i)));
    }
    Values impulse = solve(task, change);
    clamp(task.law, impulse);
    for (int i = 0; i < kCount; ++i) along.push(task.law.direction + i, 0.5f * impulse[i]);
}

// The impulse of the last substep is a quarter of a period late for what swings freely. What the rail gives
// with it changes as well, so that this comes before anything is pushed.
template <int kCount>
void guess_spring(const Task<kCount>& task) {
    const ExactSpring& spring = task.law.spring;
    if (spring.damped && !spring.crowded) return;
    Values guess{};
    if (!spring.crowded) {
        guess =
            spring_impulse(task, {task.law.speed_before[0], task.law.speed_before[1]}, errors(task), {}, {});
        clamp(task.law, guess);
    }
    Values change{};
    for (int i = 0; i < kCount; ++i) {
        change[i] = guess[i] - task.impulse(i);
        task.impulse(i) = guess[i];
    }
    take_of_rail(task, rail_of(task), change);
}

template <int kCount, int kMany>
void push_law(const Task<kCount>& task, Along<kMany>& along) {
    for (int i = 0; i < kCount; ++i) {
        if (task.impulse(i) != 0) along.push(task.law.direction + i, task.sign * task.impulse(i));
    }
}

template <int kMany>
void warm_start(JointConstraint& c, const JointPlace& at, Along<kMany>& along) {
    for (int l = 0; c.has_spring && l < c.law_count; ++l) {
        if (c.laws[l].kind == LawKind::Spring)
            with_task(c, c.laws[l], at, [](const auto& task) { guess_spring(task); });
    }
    for (int l = 0; l < c.law_count; ++l)
        with_task(c, c.laws[l], at, [&](const auto& task) { push_law(task, along); });
}

template <int kCount, int kMany>
void solve_law(const Task<kCount>& task, Along<kMany>& along, float h_s, Pass pass) {
    switch (task.law.kind) {
        case LawKind::Hold:
            return solve_hold(task, along, pass);
        case LawKind::Spring:
            if (task.law.spring.crowded) return;
            if (pass == Pass::Biased || task.law.spring.relaxes) solve_spring(task, along, pass);
            return;
        case LawKind::Motor:
            return solve_motor(task, along, h_s, pass);
        case LawKind::Lower:
        case LawKind::Upper:
            return solve_limit(task, along, h_s, pass);
    }
}

template <int kMany>
void solve_laws(JointConstraint& c, const JointPlace& at, Along<kMany>& along, float h_s, Pass pass) {
    for (int l = 0; l < c.law_count; ++l)
        with_task(c, c.laws[l], at, [&](const auto& task) { solve_law(task, along, h_s, pass); });
}

// What the joint gave body b in this substep, as a force at its anchor and a torque.
void add_reaction(JointConstraint& c, const Directions& directions, const Motions& motions) {
    const Vec2 arm = rotate(motions.turned[c.anchors.b], c.anchors.r_b);
    for (int d = 0; d < c.directions; ++d) {
        const auto p = [&](Role role) { return c.impulse[static_cast<std::size_t>(impulse_index(d, role))]; };
        const float sum = p(Role::HoldOrSpring) + p(Role::Motor) + p(Role::Lower) - p(Role::Upper);
        const Jacobian& j = directions[static_cast<std::size_t>(d)].j[static_cast<std::size_t>(c.b)];
        c.total_impulse += sum * j.linear;
        c.total_angular_impulse += sum * (j.angular - cross(arm, j.linear));
    }
}

// Calls visit(number of the joint, law) for the springs.
template <class Joints, class Visit>
void for_each_spring(Joints joints, Visit&& visit) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i].has_spring) continue;
        for (int l = 0; l < joints[i].law_count; ++l) {
            if (joints[i].laws[l].kind == LawKind::Spring) visit(i, joints[i].laws[l]);
        }
    }
}

}  // namespace

void place_joints(std::span<const JointConstraint> joints, const Motions& motions,
                  std::vector<JointPlace>& places) {
    resize_amply(places, joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i].direct || joints[i].has_spring) place_joint(joints[i], joints, motions, places[i]);
    }
}

void add_spring_loads(std::span<const JointConstraint> joints, std::span<const JointPlace> places,
                      const Motions& motions, std::vector<SpringLoad>& loads) {
    for_each_spring(joints, [&](std::size_t joint, const JointLaw& law) {
        const JointConstraint& c = joints[joint];
        const Direction* d = &places[joint].directions[law.direction];
        const double w = 2 * static_cast<double>(kPi) * static_cast<double>(law.spring_frequency_hz);
        const SpringMobility own = mobility_of(law, places[joint]);
        for (int i = 0; own.xx > 0 && i < c.bodies; ++i) {
            const Motion body = motions.get(c.rows[i]);
            const auto of_body = [&](int e, int f) {
                return static_cast<double>(share(body, d[e].j[i], d[f].j[i]));
            };
            const auto xx = static_cast<double>(own.xx);
            double part = of_body(0, 0) / xx;
            if (law.count == 2 && own.yy > 0) {
                const auto yy = static_cast<double>(own.yy);
                part = greatest_eigenvalue(part, of_body(0, 1) / std::sqrt(xx * yy), of_body(1, 1) / yy);
            }
            if (!(part > 0)) continue;
            SpringLoad& load = loads[static_cast<std::size_t>(c.rows[i])];
            load.together_1_s2 += w * w * part;
            ++load.springs;
        }
    });
}

bool make_springs(std::span<JointConstraint> joints, float h_s, const std::vector<SpringLoad>& loads) {
    // One spring follows another that is mostly alike.
    float last_frequency_hz = 0;
    float last_damping_ratio = 0;
    ExactSpring alone;
    bool some_crowded = false;
    for_each_spring(joints, [&](std::size_t joint, JointLaw& law) {
        const JointConstraint& c = joints[joint];
        const double frequency = static_cast<double>(law.spring_frequency_hz);
        const double w = 2 * static_cast<double>(kPi) * frequency;
        double sum = 0;
        bool is_crowded = false;
        for (int i = 0; i < c.bodies; ++i) {
            const SpringLoad& load = loads[static_cast<std::size_t>(c.rows[i])];
            sum += load.together_1_s2;
            is_crowded = is_crowded || is_crowd(load, static_cast<double>(h_s));
        }
        if (law.spring_frequency_hz != last_frequency_hz || law.spring_damping_ratio != last_damping_ratio) {
            last_frequency_hz = law.spring_frequency_hz;
            last_damping_ratio = law.spring_damping_ratio;
            alone = make_exact_spring(frequency, static_cast<double>(last_damping_ratio),
                                      static_cast<double>(h_s), 1);
        }
        const double angle = w * static_cast<double>(h_s);
        law.spring = calmed(alone, angle * angle, std::max(sum / (w * w), 1.0));
        const double damping = 2 * static_cast<double>(law.spring_damping_ratio) * angle;
        if (c.direct) {
            law.spring = in_structure(law.spring, angle * angle, damping, c.softened_hz > 0, is_crowded);
        } else if (law.bears) {
            law.spring = bearing(law.spring, angle * angle, damping);
        } else if (is_crowded) {
            law.spring = crowded(law.spring, angle * angle, damping);
            some_crowded = true;
        }
    });
    return some_crowded;
}

void start_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places, float h_s,
                   Motions& motions) {
    for_each_spring(joints, [&](std::size_t joint, JointLaw& law) {
        JointConstraint& c = joints[joint];
        if (!c.is_new) return;
        with_bodies(c, places[joint], motions, [&](auto& along) {
            with_task(c, law, places[joint], [&](const auto& task) { start_spring(task, along, h_s); });
        });
    });
}

void note_spring_speeds(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                        const Motions& motions) {
    for_each_spring(joints, [&](std::size_t joint, JointLaw& law) {
        if (joints[joint].direct) return;
        for (int i = 0; i < law.count; ++i) {
            const Direction& direction = places[joint].directions[law.direction + i];
            law.speed_before[i] = joints[joint].bodies == 2
                                      ? Along<2>::speed_of(joints[joint], direction, motions)
                                      : Along<kMaxJointBodies>::speed_of(joints[joint], direction, motions);
        }
    });
}

void warm_start_joints(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                       Motions& motions) {
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        JointConstraint& c = joints[joint];
        if (c.direct) continue;
        with_bodies(c, places[joint], motions, [&](auto& along) { warm_start(c, places[joint], along); });
    }
}

void sweep_crowded_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                           Motions& motions, bool back) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const std::size_t joint = back ? joints.size() - 1 - i : i;
        JointConstraint& c = joints[joint];
        if (!c.has_spring) continue;
        for (int l = 0; l < c.law_count; ++l) {
            JointLaw& law = c.laws[back ? c.law_count - 1 - l : l];
            if (law.kind != LawKind::Spring || !law.spring.crowded) continue;
            with_bodies(c, places[joint], motions, [&](auto& along) {
                with_task(c, law, places[joint],
                          [&](const auto& task) { solve_spring(task, along, Pass::Biased); });
            });
        }
    }
}

void solve_joints(std::span<JointConstraint> joints, std::span<JointPlace> places, Motions& motions,
                  float h_s, Pass pass) {
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        JointConstraint& c = joints[joint];
        if (c.direct) continue;
        JointPlace& at = places[joint];
        if (pass == Pass::Relax) place_joint(c, joints, motions, at);
        with_bodies(c, at, motions, [&](auto& along) { solve_laws(c, at, along, h_s, pass); });
        if (pass == Pass::Relax) add_reaction(c, at.directions, motions);
    }
}

}  // namespace cairn::physics
