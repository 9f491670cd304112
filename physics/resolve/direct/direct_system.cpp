// Principal pivoting over a sparse factorization.
#include "resolve/direct/direct_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

// So often all may change over without fewer being wrong.
constexpr int kChances = 3;
constexpr int kMaxFrictionRounds = 4;
// Of a bound of friction: smaller changes are not worth another solution.
constexpr double kSameBound = 1e-2;
// Speeds this near what is wanted are met, m/s or rad/s; and impulses this near a bound, times 1 kg.
constexpr double kSame = 1e-9;

}  // namespace

void DirectSystem::clear() {
    bodies.clear();
    members.clear();
    links.clear();
    equations.clear();
}

void DirectSystem::begin_member() {
    Member m;
    m.first_link = m.last_link = static_cast<int>(links.size());
    m.first_equation = m.last_equation = static_cast<int>(equations.size());
    members.push_back(m);
}

void DirectSystem::add_link(int body) {
    links.push_back({body, 0});
    members.back().last_link = static_cast<int>(links.size());
}

int DirectSystem::add_equation() {
    equations.push_back({});
    members.back().last_equation = static_cast<int>(equations.size());
    return static_cast<int>(equations.size()) - 1;
}

void DirectSystem::arrange() {
    std::vector<BlockLdl::Node>& nodes = nodes_;
    std::vector<BlockLdl::Edge>& edges = edges_;
    nodes.assign(bodies.size(), {3, false});
    edges.clear();
    int numbers = 0;
    for (Member& m : members) {
        const int node = static_cast<int>(nodes.size());
        nodes.push_back({m.equations(), true});
        m.first_j = numbers;
        numbers += 3 * (m.last_link - m.first_link) * m.equations();
        for (int l = m.first_link; l < m.last_link; ++l) {
            links[at(l)].edge = static_cast<int>(edges.size());
            edges.push_back({links[at(l)].body, node});
        }
    }
    factors_.analyze(nodes, edges);
    j_.assign(at(numbers), 0);
    velocity.assign(3 * bodies.size(), 0);
    x_.assign(at(factors_.size()), 0);
    momentum_before_.assign(x_.size(), 0);
}

void DirectSystem::weigh() {
    for (const Member& m : members) {
        for (int e = m.first_equation; e < m.last_equation; ++e) equations[at(e)].inverse_mass = 0;
        const double* j = j_.data() + m.first_j;
        for (int l = m.first_link; l < m.last_link; ++l) {
            const DirectBody& body = bodies[at(links[at(l)].body)];
            const double by_mass = 1 / body.mass;
            const double by_inertia = 1 / body.own_inertia;
            for (int e = m.first_equation; e < m.last_equation; ++e, j += 3) {
                equations[at(e)].inverse_mass +=
                    (j[0] * j[0] + j[1] * j[1]) * by_mass + j[2] * j[2] * by_inertia;
            }
        }
    }
}

double DirectSystem::speed(int member, int equation, std::span<const double> of_bodies) const {
    const Member& m = members[at(member)];
    double sum = equations[at(equation)].drift;
    const double* j = j_.data() + m.first_j + 3 * (equation - m.first_equation);
    for (int l = m.first_link; l < m.last_link; ++l, j += 3 * m.equations()) {
        const double* v = of_bodies.data() + 3 * links[at(l)].body;
        sum += j[0] * v[0] + j[1] * v[1] + j[2] * v[2];
    }
    return sum;
}

void DirectSystem::factor(BlockLdl& factors) const {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const BlockLdl::BlockValues diagonal = factors.diagonal(static_cast<int>(b));
        diagonal.set(0, 0, bodies[b].mass);
        diagonal.set(1, 1, bodies[b].mass);
        diagonal.set(2, 2, bodies[b].inertia);
    }
    for (int m = 0; m < static_cast<int>(members.size()); ++m) set_member(factors, m);
    factors.factor();
}

void DirectSystem::set_member(BlockLdl& factors, int member) const {
    const Member& m = members[at(member)];
    const BlockLdl::BlockValues diagonal = factors.diagonal(static_cast<int>(bodies.size()) + member);
    const DirectEquation* const own = equations.data() + m.first_equation;
    with_count(m.equations(), [&](auto n) {
        for (int row = 0; row < n; ++row)
            diagonal.set(row, row, own[row].state == State::Acts ? -own[row].give : -1);
        const double* j = j_.data() + m.first_j;
        for (int l = m.first_link; l < m.last_link; ++l) {
            const BlockLdl::BlockValues edge = factors.edge(links[at(l)].edge);
            for (int row = 0; row < n; ++row, j += 3) {
                const bool acts = own[row].state == State::Acts;
                for (int column = 0; column < 3; ++column) edge.set(row, column, acts ? j[column] : 0);
            }
        }
    });
}

void DirectSystem::renew_factors() {
    factor(factors_);
    --factorizations_left_;
    is_stale_ = false;
}

// Where nothing but the states of those that were wrong changed since the last time.
void DirectSystem::renew_factors_of_wrong() {
    for (const Place& w : wrong_) set_member(factors_, w.member);
    factors_.factor();
    --factorizations_left_;
}

// Momentum that an impulse gives, into the right-hand side.
void DirectSystem::push(const Member& m, int equation, double impulse) {
    const double* j = j_.data() + m.first_j + 3 * (equation - m.first_equation);
    for (int l = m.first_link; l < m.last_link; ++l, j += 3 * m.equations()) {
        double* x = x_.data() + place_of_body(links[at(l)].body);
        for (int i = 0; i < 3; ++i) x[i] += j[i] * impulse;
    }
}

// Velocities and impulses that fulfil the equations as they are now; with their factors.
void DirectSystem::balance(const BlockLdl& factors) {
    x_ = momentum_before_;
    for (std::size_t m = 0; m < members.size(); ++m) {
        double* x = x_.data() + place_of_member(static_cast<int>(m));
        for (int i = members[m].first_equation; i < members[m].last_equation; ++i, ++x) {
            DirectEquation& e = equations[at(i)];
            if (e.state == State::Acts) {
                *x = e.wanted - e.drift;
                continue;
            }
            if (e.state == State::Idle) e.impulse = 0;
            if (e.state == State::AtLow) e.impulse = e.low - e.before;
            if (e.state == State::AtHigh) e.impulse = e.high - e.before;
            if (e.impulse != 0) push(members[m], i, e.impulse);
        }
    }
    factors.solve(x_);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const double* x = x_.data() + place_of_body(static_cast<int>(b));
        for (std::size_t i = 0; i < 3; ++i) velocity[3 * b + i] = x[i];
    }
    for (std::size_t m = 0; m < members.size(); ++m) {
        const double* x = x_.data() + place_of_member(static_cast<int>(m));
        DirectEquation* const last = equations.data() + members[m].last_equation;
        for (DirectEquation* e = equations.data() + members[m].first_equation; e != last; ++e, ++x) {
            if (e->state == State::Acts) e->impulse = -*x;
        }
    }
}

bool DirectSystem::is_wrong(const DirectEquation& e, int member, int equation) const {
    if (e.state == State::Given) return false;
    const double whole = e.before + e.impulse;
    if (e.bound == Bound::Round) {
        const double partner = equations[at(equation + 1)].before + equations[at(equation + 1)].impulse;
        return whole * whole + partner * partner > e.high * e.high;
    }
    if (e.state == State::Acts) {
        const double same = kSame * std::fabs(whole);
        return whole < e.low - same || whole > e.high + same;
    }
    if (!(e.low < e.high)) return false;
    const double over = speed(member, equation) + e.give * e.impulse - e.wanted;
    return e.state == State::AtLow ? over < -kSame : over > kSame;
}

// Renewing the factors is left to the caller.
void DirectSystem::change_over(int equation) {
    DirectEquation& e = equations[at(equation)];
    if (e.bound == Bound::Round) {  // shortened once and for all
        DirectEquation& other = equations[at(equation + 1)];
        const double x = e.before + e.impulse;
        const double y = other.before + other.impulse;
        const double scale = e.high / std::sqrt(x * x + y * y);
        e.impulse = scale * x - e.before;
        other.impulse = scale * y - other.before;
        e.state = other.state = State::Given;
    } else if (e.state == State::Acts) {
        e.state = e.before + e.impulse < e.low ? State::AtLow : State::AtHigh;
    } else {
        e.state = State::Acts;
    }
}

void DirectSystem::find_wrong() {
    wrong_.clear();
    for (const Place& p : limited_) {
        if (is_wrong(equations[at(p.equation)], p.member, p.equation)) wrong_.push_back(p);
    }
}

// All that are wrong change over, as long as that makes fewer wrong now and then; whether none is left.
bool DirectSystem::pivot() {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    if (is_stale_) renew_factors();
    for (int chances = kChances; chances >= 0;) {
        balance(factors_);
        find_wrong();
        if (wrong_.empty()) return true;
        if (factorizations_left_ <= 0) return false;
        if (wrong_.size() < fewest) {
            fewest = wrong_.size();
            chances = kChances;
        } else {
            --chances;
        }
        for (const Place& w : wrong_) change_over(w.equation);
        if (chances >= 0) renew_factors_of_wrong();
    }
    is_stale_ = true;
    return false;
}

// Bounds by what presses now; whether they are others than before.
bool DirectSystem::renew_friction() {
    bool changed = false;
    for (DirectEquation& e : equations) {
        if (e.bound != Bound::Friction || e.state == State::Idle) continue;
        double pressed = 0;
        for (int i = e.first_push; i < e.last_push; ++i) {
            pressed += std::max(equations[at(i)].before + equations[at(i)].impulse, 0.0);
        }
        const double bound = e.coefficient * pressed;
        const bool matters = e.state != State::Acts || std::fabs(e.before + e.impulse) > bound;
        changed = changed || (matters && std::fabs(bound - e.high) > kSameBound * bound);
        if (e.state == State::Acts || e.high > 0) {
            e.low = -bound;
            e.high = bound;
        } else if (bound > 0) {  // it did not press before: nobody knows to which side
            e.state = State::Acts;
            is_stale_ = true;
            e.low = -bound;
            e.high = bound;
        }
    }
    return changed;
}

void DirectSystem::start(std::span<const double> velocity_before) {
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        const double* v = velocity_before.data() + 3 * b;
        double* momentum = momentum_before_.data() + place_of_body(b);
        momentum[0] = bodies[at(b)].mass * v[0];
        momentum[1] = bodies[at(b)].mass * v[1];
        momentum[2] = bodies[at(b)].inertia * v[2];
    }
    limited_.clear();
    for (int m = 0; m < static_cast<int>(members.size()); ++m) {
        for (int i = members[at(m)].first_equation; i < members[at(m)].last_equation; ++i) {
            const DirectEquation& e = equations[at(i)];
            if (e.bound != Bound::None && e.state != State::Idle) limited_.push_back({m, i});
        }
    }
}

int DirectSystem::satisfy(std::span<const double> velocity_before, int most_factorizations) {
    start(velocity_before);
    is_stale_ = true;
    factorizations_left_ = most_factorizations;
    for (int round = 0; round < kMaxFrictionRounds; ++round) {
        if (!pivot()) descend();
        if (factorizations_left_ <= 0 || !renew_friction()) break;
    }
    return most_factorizations - factorizations_left_;
}

}  // namespace cairn::physics
