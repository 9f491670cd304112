// Which joints make a row of pins, and what it is like when a step begins.
#include <algorithm>
#include <limits>
#include <utility>

#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"
#include "resolve/direct/pin_chain.h"

namespace cairn::physics {
namespace {

constexpr int kNoJoint = -1;

bool moves(const Motions& motions, int row) {
    return motions.velocity[row].inverse_mass > 0 || motions.inverse_inertia[row] > 0;
}

// Held at a point, by all that is there to hold it, and nothing else.
bool is_plain_pin(const JointConstraint& c) {
    return c.kind == JointKind::Revolute && c.bodies == 2 && c.law_count == 1 &&
           c.laws[0].kind == LawKind::Hold && c.laws[0].count == 2 && c.laws[0].rigid;
}

bool is_plain_body(const Motions& motions, int row) {
    return motions.velocity[row].inverse_mass > 0 && motions.locked_axes(row) == 0;
}

}  // namespace

// The places of joints in the order of the row, and which way each looks.
bool PinChain::line_up(std::span<const int> joints, const DirectScene& scene, std::vector<int>& body_of_row) {
    const Motions& motions = scene.motions;
    rows_.clear();
    pins_.clear();
    joints_of_.clear();
    // Bodies as they come, each with up to two joints.
    int ends = 0;  // where a joint holds what cannot be moved
    int start = kNoJoint;
    bool fits = true;
    for (std::size_t j = 0; j < joints.size() && fits; ++j) {
        const JointConstraint& c = scene.joints[at(joints[j])];
        fits = is_plain_pin(c);
        for (int i = 0; i < 2 && fits; ++i) {
            const int row = c.rows[at(i)];
            if (!moves(motions, row)) {
                ++ends;
                start = start == kNoJoint ? static_cast<int>(j) : start;
                continue;
            }
            int& body = body_of_row[at(row)];
            if (body < 0) {
                body = static_cast<int>(rows_.size());
                rows_.push_back(row);
                joints_of_.insert(joints_of_.end(), {kNoJoint, kNoJoint});
                fits = is_plain_body(motions, row);
            }
            int* own = joints_of_.data() + 2 * body;
            fits = fits && own[1] == kNoJoint;
            own[own[0] == kNoJoint ? 0 : 1] = static_cast<int>(j);
        }
    }
    // Of a row in the air, the first body with a single joint begins it.
    int from = kWorldRow;
    if (fits && start == kNoJoint) {
        for (std::size_t b = 0; b < rows_.size() && start == kNoJoint; ++b) {
            if (joints_of_[2 * b + 1] != kNoJoint) continue;
            start = joints_of_[2 * b];
            from = rows_[b];
        }
    }
    fits = fits && start != kNoJoint && ends <= 2;
    std::swap(rows_, found_);
    rows_.clear();
    for (int j = fits ? start : kNoJoint; j != kNoJoint;) {
        const JointConstraint& c = scene.joints[at(joints[at(j)])];
        if (rows_.empty()) {
            if (ends > 0) from = moves(motions, c.rows[0]) ? c.rows[1] : c.rows[0];
            rows_.push_back(from);
        }
        Pin pin;
        pin.place = joints[at(j)];
        pin.reversed = c.rows[1] == rows_.back() && c.rows[0] != rows_.back();
        const int next = c.rows[pin.reversed ? 0 : 1];
        rows_.push_back(next);
        pins_.push_back(pin);
        if (!moves(motions, next)) break;
        const int* own = joints_of_.data() + 2 * body_of_row[at(next)];
        j = own[0] == j ? own[1] : own[0];
    }
    for (const int row : found_) body_of_row[at(row)] = -1;
    return fits && pins_.size() == joints.size();
}

// As in the last step: nearly always.
bool PinChain::is_same_row(std::span<const int> joints, const DirectScene& scene) const {
    if (pins_.empty() || !std::equal(joints.begin(), joints.end(), given_.begin(), given_.end()))
        return false;
    const Motions& motions = scene.motions;
    for (std::size_t j = 0; j < pins_.size(); ++j) {
        const JointConstraint& c = scene.joints[at(pins_[j].place)];
        const int reversed = pins_[j].reversed ? 1 : 0;
        if (!is_plain_pin(c) || c.rows[at(reversed)] != rows_[j] || c.rows[at(1 - reversed)] != rows_[j + 1])
            return false;
    }
    for (std::size_t k = begin_; k < end_; ++k) {
        if (!is_plain_body(motions, rows_[k])) return false;
    }
    return (begin_ == 0 || !moves(motions, rows_.front())) &&
           (end_ == rows_.size() || !moves(motions, rows_.back()));
}

bool PinChain::assemble(std::span<const int> joints, const DirectScene& scene,
                        std::vector<int>& body_of_row) {
    if (is_same_row(joints, scene)) return true;
    given_.assign(joints.begin(), joints.end());
    if (!line_up(joints, scene, body_of_row)) {
        pins_.clear();
        return false;
    }
    const Motions& motions = scene.motions;
    begin_ = moves(motions, rows_.front()) ? 0 : 1;
    end_ = rows_.size() - (moves(motions, rows_.back()) ? 0 : 1);
    // In a loop: chains and trees that hang from one thing have as many joints as bodies.
    fastest_rad_s_ = pins_.size() > end_ - begin_ ? kTurning_rad_s : std::numeric_limits<double>::infinity();
    line_.resize(pins_.size());
    return true;
}

void PinChain::start(const DirectScene& scene, std::span<const float> inertia_before) {
    const Motions& motions = scene.motions;
    whole_mass_ = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const float inverse_mass = motions.velocity[rows_[k]].inverse_mass;
        const float inverse_inertia = motions.inverse_inertia[rows_[k]];
        line_.mass[k] = inverse_mass > 0 ? 1 / d(inverse_mass) : 0;
        line_.inverse_mass[k] = d(inverse_mass);
        line_.own_inertia[k] = inverse_inertia > 0 ? 1 / d(inverse_inertia) : 1;
        line_.inverse_own_inertia[k] = line_.inverse_inertia[k] = d(inverse_inertia);
        line_.inertia[k] = line_.own_inertia[k];
        if (inverse_inertia > 0)
            line_.inertia[k] = std::max(d(inertia_before[at(rows_[k])]), line_.own_inertia[k]);
        whole_mass_ += line_.mass[k];
        const bool is_turned = inverse_inertia > 0;
        const Drive& drive = scene.drives[at(rows_[k])];
        line_.kick.x[k] = d(scene.h_s) / 2 * d(drive.acceleration.x);
        line_.kick.y[k] = d(scene.h_s) / 2 * d(drive.acceleration.y);
        line_.twist[k] =
            is_turned ? d(scene.h_s) / 2 * d(drive.angular_acceleration) * line_.own_inertia[k] : 0;
    }
    for (std::size_t j = 0; j < pins_.size(); ++j) {
        const bool reversed = pins_[j].reversed;
        const JointConstraint& c = scene.joints[at(pins_[j].place)];
        const Vec2 before = reversed ? c.anchors.r_b : c.anchors.r_a;
        const Vec2 after = reversed ? c.anchors.r_a : c.anchors.r_b;
        const Vec2 offset = reversed ? -c.anchors.center_offset : c.anchors.center_offset;
        line_.start.before_x[j] = d(before.x);
        line_.start.before_y[j] = d(before.y);
        line_.start.after_x[j] = d(after.x);
        line_.start.after_y[j] = d(after.y);
        line_.offset_x[j] = d(offset.x);
        line_.offset_y[j] = d(offset.y);
        // What does not turn gets no inertia by its arms.
        line_.arm_before[j] = line_.inverse_own_inertia[j] > 0 ? d(length(before)) : 0;
        line_.arm_after[j] = line_.inverse_own_inertia[j + 1] > 0 ? d(length(after)) : 0;
        line_.impulse_x[j] = d(c.impulse[at(impulse_index(0, Role::HoldOrSpring))]);
        line_.impulse_y[j] = d(c.impulse[at(impulse_index(1, Role::HoldOrSpring))]);
        line_.total_x[j] = line_.total_y[j] = 0;
    }
    // About half of it was given while closing.
    measure_pulls(line_, line_.pulled);
    for (double& pull : line_.pulled) pull /= 2;
    line_.closed = line_.pulled;
    sum_levers(line_);
    read_poses(motions, 0, rows_.size());
    read(motions);
    line_.now = line_.before;
    greatest_error_ = place(line_);
}

void PinChain::finish(std::span<JointConstraint> joints) const {
    for (std::size_t j = 0; j < pins_.size(); ++j) {
        JointConstraint& c = joints[at(pins_[j].place)];
        const float sign = pins_[j].reversed ? -1.0f : 1.0f;
        c.impulse[at(impulse_index(0, Role::HoldOrSpring))] = sign * static_cast<float>(line_.sum_x[j]);
        c.impulse[at(impulse_index(1, Role::HoldOrSpring))] = sign * static_cast<float>(line_.sum_y[j]);
        c.total_impulse +=
            sign * Vec2{static_cast<float>(line_.total_x[j]), static_cast<float>(line_.total_y[j])};
    }
}

}  // namespace cairn::physics
