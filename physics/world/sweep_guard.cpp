// The corners of each shape, rounded or not, are followed as they move in the frame of the other, in pieces
// so short that the arcs between count as straight. What was on one side of a shape and is on the other, and
// crossed the line between within the shape, went through it.
#include "world/sweep_guard.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "world/edge_list.h"
#include "world/fast_guard.h"
#include "world/finalize.h"
#include "world/new_contacts.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// rad. The arc of a piece is off by an eighth of its square times the arm: of long blades pieces are shorter,
// so that it is no more than a quarter of what is solid.
constexpr float kLongestPiece_rad = 0.2f;
constexpr int kMostPieces = 64;

// How a body went through the last step.
class Course {
  public:
    Course(const BodyStore& bodies, int body) : local_center_(bodies.slots[body].mass.center_m) {
        const BodyRecord& record = bodies.slots[body];
        const Place& place = bodies.places[body];
        start_ = place.center;
        rotation_ = place.rotation;
        if (place.row == kWorldRow) return;
        const BodyRows& awake = bodies.rows(RowSet::Awake);
        moved_ = awake.moved[place.row - 1];
        start_ = place.center + -moved_;
        rotation_ = awake.rotation_before[place.row - 1];
        if (rotation_ != place.rotation)
            turned_rad_ = static_cast<double>((inverse(rotation_) * place.rotation).angle_rad());
        if (turned_rad_ == 0) return;
        const float piece_rad =
            std::min(kLongestPiece_rad, std::sqrt(2 * record.inner_radius_m / record.turn_arm_m));
        pieces_ = std::fabs(static_cast<float>(turned_rad_)) / piece_rad;
    }

    /// Of those that are short enough, how many it takes.
    [[nodiscard]] float pieces() const { return pieces_; }

    /// After a share of the step.
    [[nodiscard]] Transform at(float share) const {
        const Rotation q = turned_rad_ == 0
                               ? rotation_
                               : Rotation::from_angle(static_cast<double>(share) * turned_rad_) * rotation_;
        return {start_ + (share * moved_ - rotate(q, local_center_)), q};
    }

  private:
    Vec2 local_center_;
    Position start_;
    Vec2 moved_;
    Rotation rotation_;
    double turned_rad_ = 0;
    float pieces_ = 0;
};

// The side of a shape on which a point lies: the line through the shape's middle, seen from there.
struct Side {
    Vec2 normal;     // 0 where it cannot be told
    float height_m;  // of the surface above the line

    [[nodiscard]] float above(const Convex& shape, Vec2 point) const {
        return dot(normal, point - shape.centroid);
    }
};

Vec2 side_normal(const Convex& shape, Vec2 point) {
    if (shape.count() == 1) {
        const Vec2 from = point - shape.centroid;
        const float distance = length(from);
        return distance > 0 ? (1 / distance) * from : Vec2{};
    }
    // Chains are solid from their front alone.
    const int sides = shape.is_chained() ? 1 : shape.count();
    float farthest = shape.is_chained() ? 0 : -std::numeric_limits<float>::infinity();
    Vec2 normal;
    for (int i = 0; i < sides; ++i) {
        const float distance = dot(shape.normals[i], point - shape.point(i));
        if (distance < farthest) continue;
        farthest = distance;
        normal = shape.normals[i];
    }
    return normal;
}

Side side_of(const Convex& shape, Vec2 point) {
    Side side{side_normal(shape, point), 0};
    for (int i = 0; i < shape.count(); ++i)
        side.height_m = std::max(side.height_m, side.above(shape, shape.point(i)));
    side.height_m += shape.radius();
    return side;
}

// Of a point on the line through its middle.
bool is_within(const Convex& shape, Vec2 point) {
    if (shape.count() != 2) return contains_point(shape, point);
    const Vec2 axis = shape.point(1) - shape.point(0);
    const float along = dot(point - shape.point(0), axis);
    const float room = shape.radius() * length(axis);
    return along >= -room && along <= length_squared(axis) + room;
}

// The corners of one shape, on their way past another.
class Passage {
  public:
    Passage(const Convex& moving, const Convex& other, const Transform& moving_at, const Transform& other_at)
        : moving_(moving), other_(other) {
        for (int i = 0; i < moving.count(); ++i) {
            Corner& corner = corners_[static_cast<std::size_t>(i)];
            corner.at = local(i, moving_at, other_at);
            corner.side = side_of(other, corner.at);
            corner.above = corner.side.above(other, corner.at);
            corner.kept = std::min(corner.above, corner.side.height_m + moving.radius());
        }
    }

    /// From one share of the step to the next.
    void go_on(const Transform& moving_at, const Transform& other_at, float from, float to) {
        for (int i = 0; i < moving_.count(); ++i) {
            Corner& corner = corners_[static_cast<std::size_t>(i)];
            const Vec2 at = local(i, moving_at, other_at);
            const float above = corner.side.above(other_, at);
            if (corner.above >= corner.kept && above < corner.kept)
                corner.free_share =
                    from + (to - from) * (corner.above - corner.kept) / (corner.above - above);
            if (corner.above > 0 && above <= 0) {
                const float met = corner.above / (corner.above - above);
                if (is_within(other_, corner.at + met * (at - corner.at))) {
                    free_share_ = std::min(free_share_, corner.free_share);
                    corner.passed = true;
                }
            }
            corner.at = at;
            corner.above = above;
        }
    }

    /// Up to which the shape was free to go; 1 while none of its corners has passed.
    [[nodiscard]] float free_share() const { return free_share_; }

    /// By how much the shape is to move, as seen from the other, to be on the side where it was: for the
    /// corner that is farthest beyond.
    [[nodiscard]] Vec2 way_back() const {
        Vec2 way;
        float farthest = 0;
        for (int i = 0; i < moving_.count(); ++i) {
            const Corner& corner = corners_[static_cast<std::size_t>(i)];
            const float beyond = corner.kept - corner.above;
            if (!corner.passed || beyond <= farthest) continue;
            farthest = beyond;
            way = beyond * corner.side.normal;
        }
        return way;
    }

  private:
    struct Corner {
        Vec2 at;  // as seen from the other shape
        Side side;
        float above = 0;
        float kept = 0;        // m above the middle: where the two meet, or began
        float free_share = 0;  // of the step, up to which it was there
        bool passed = false;
    };

    [[nodiscard]] Vec2 local(int corner, const Transform& moving_at, const Transform& other_at) const {
        return inverse_transform_point(other_at, transform_point(moving_at, moving_.point(corner)));
    }

    const Convex& moving_;
    const Convex& other_;
    std::array<Corner, kMaxPolygonVertices> corners_;
    float free_share_ = 1;
};

// What the corners of two shapes did to each other in the last step.
struct Encounter {
    Passage of_a;
    Passage of_b;

    [[nodiscard]] float free_share() const { return std::min(of_a.free_share(), of_b.free_share()); }
};

// Chains are solid from their front: what came from behind passes them.
bool comes_from_behind(const Convex& chain, const Transform& chain_at, const Convex& other,
                       const Transform& other_at) {
    if (!chain.is_chained()) return false;
    const Vec2 seen = inverse_transform_point(chain_at, transform_point(other_at, other.centroid));
    return dot(chain.normals[0], seen - chain.point(0)) < 0;
}

Encounter follow(const Course& of_a, const Convex& a, const Course& of_b, const Convex& b) {
    const float wanted = std::min(std::ceil(of_a.pieces() + of_b.pieces()), float{kMostPieces});
    int pieces = std::max(static_cast<int>(wanted), 1);
    const Transform start_a = of_a.at(0);
    const Transform start_b = of_b.at(0);
    Encounter encounter{{a, b, start_a, start_b}, {b, a, start_b, start_a}};
    if (comes_from_behind(a, start_a, b, start_b) || comes_from_behind(b, start_b, a, start_a)) pieces = 0;
    float from = 0;
    for (int i = 1; i <= pieces; ++i) {
        const float to = static_cast<float>(i) / static_cast<float>(pieces);
        const Transform at_a = of_a.at(to);
        const Transform at_b = of_b.at(to);
        encounter.of_a.go_on(at_a, at_b, from, to);
        encounter.of_b.go_on(at_b, at_a, from, to);
        from = to;
    }
    return encounter;
}

// Calls visit(own shape, other body, other shape) for all that a body touches or may have touched.
template <class Visit>
void for_each_met(const Stores& stores, int body, const Visit& visit) {
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        if (special::has(c, special::kRefused | special::kPassing)) return;
        if (side == 0) {
            visit(c.shape_a, c.body_b, c.shape_b);
        } else {
            visit(c.shape_b, c.body_a, c.shape_a);
        }
    });
}

bool is_paddle(const Stores& stores, int body) {
    return (stores.bodies.places[body].flags & (place_flag::kSweeps | place_flag::kFast)) != 0 &&
           stores.bodies.slots[body].type == BodyType::Kinematic;
}

float free_share_of(const Stores& stores, int body) {
    const Course course(stores.bodies, body);
    float free = 1;
    for_each_met(stores, body, [&](int shape, int other_body, int other) {
        if (is_paddle(stores, other_body)) return;  // that carried the body with it
        const Encounter met = follow(course, stores.shapes[shape].convex(), {stores.bodies, other_body},
                                     stores.shapes[other].convex());
        free = std::min(free, met.free_share());
    });
    return free;
}

// Moves a body on, as if it had gone there within the step: guarded as what is fast.
void carry(Stores& stores, StepScratch& scratch, int body, Vec2 way) {
    way = without_locked(way, locked_axes(stores.bodies.slots[body]));
    Place& place = stores.bodies.places[body];
    place.center = place.center + way;
    stores.bodies.rows(RowSet::Awake).moved[stores.bodies.slots[body].row] += way;
    if ((place.flags & place_flag::kFast) == 0) scratch.fast.push_back(body);
    place.flags |= place_flag::kFast | place_flag::kLost;
    update_boxes(stores, body);
}

}  // namespace

bool hangs_on_what_moves(const Stores& stores, int body) {
    bool hangs = false;
    for_each_edge(stores.joints.slots, stores.bodies.slots[body].first_joint, [&](int joint, int side) {
        const JointRecord& j = stores.joints.slots[joint];
        hangs |= stores.bodies.slots[side == 0 ? j.body_b : j.body_a].type != BodyType::Static;
    });
    return hangs;
}

bool is_carried(const Stores& stores, int shape, int paddle_shape) {
    return is_paddle(stores, stores.shapes[paddle_shape].body) &&
           !hangs_on_what_moves(stores, stores.shapes[shape].body) &&
           has_contact(stores, shape, paddle_shape);
}

void carry_swept_bodies(Stores& stores, StepScratch& scratch) {
    for (const int paddle : scratch.paddles) {
        const Course course(stores.bodies, paddle);
        for_each_met(stores, paddle, [&](int shape, int body, int carried) {
            if (!stores.bodies.is_awake(body) || stores.bodies.slots[body].type != BodyType::Dynamic) return;
            if (hangs_on_what_moves(stores, body)) return;
            const Course other(stores.bodies, body);
            const Encounter met =
                follow(other, stores.shapes[carried].convex(), course, stores.shapes[shape].convex());
            if (met.free_share() == 1) return;
            // Seen from the paddle the body goes back, or seen from the body the paddle does.
            const Vec2 way = met.of_a.free_share() < 1 ? rotate(course.at(1).q, met.of_a.way_back())
                                                       : -rotate(other.at(1).q, met.of_b.way_back());
            carry(stores, scratch, body, way);
        });
    }
}

void hold_sweeping_bodies(Stores& stores, StepScratch& scratch) {
    if (scratch.fast.empty()) return;
    scratch.ways->sweeping.for_each([&](int body) {
        if (hangs_on_what_moves(stores, body)) return;
        if (std::fabs(scratch.motions.angle(stores.bodies.places[body].row)) >= kPi) return;
        const float share = free_share_of(stores, body);
        if (share < 1) put_back(stores, body, share, true);
    });
}

}  // namespace cairn::physics
