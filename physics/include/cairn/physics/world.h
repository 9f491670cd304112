// The world: owns bodies, shapes, joints and contacts, and moves them on step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <cairn/physics/body.h>
#include <cairn/physics/chain.h>
#include <cairn/physics/debug.h>
#include <cairn/physics/events.h>
#include <cairn/physics/explosion.h>
#include <cairn/physics/fracture.h>
#include <cairn/physics/ids.h>
#include <cairn/physics/joint.h>
#include <cairn/physics/profile.h>
#include <cairn/physics/query.h>
#include <cairn/physics/report.h>
#include <cairn/physics/result.h>
#include <cairn/physics/rules.h>
#include <cairn/physics/shape.h>
#include <cairn/physics/state.h>
#include <cairn/physics/tasks.h>
#include <cairn/physics/wind.h>

namespace cairn::physics {

struct WorldDef {
    Vec2 gravity_m_s2{0, -10};
    /// At least so many per step, 1..64. Gravity that moves a body at rest by more than 2.5 mm in a substep
    /// (at 1/60 s and 4 substeps: above 144 m/s2) gets more, up to 32.
    int substeps = 4;
    JointSolver joint_solver = JointSolver::Automatic;
    bool enable_sleep = true;
    float hit_speed_m_s = 1;           ///< least approach speed that makes a ContactHit, >= 0
    float restitution_speed_m_s = 1;   ///< slower approaches do not bounce, >= 0
    float max_push_out_speed_m_s = 3;  ///< cap on how fast overlap is undone, > 0
    /// That share a step, the one that calls `World::step` included, 1..64. The results do not depend on it.
    int threads = 1;
    /// Where to run on more than one thread; the world makes threads of its own when this is null. Copied.
    const TaskSystem* tasks = nullptr;
};

/// A body, and where its origin is.
struct BodyTransform {
    BodyId body{};
    Transform transform{};
};

/// A shape of a world, found with `World::shape`. A view, as `Body` is: keep the ShapeId instead.
class Shape {
  public:
    [[nodiscard]] ShapeId id() const { return id_; }
    [[nodiscard]] BodyId body() const;
    [[nodiscard]] ChainId chain() const;  ///< null unless the shape is a segment of a chain
    [[nodiscard]] Outline outline() const;
    [[nodiscard]] float density() const;
    /// >= 0, kg/m^2. The mass of the body follows, and the body wakes. Not for segments of chains.
    Result<void> set_density(float density_kg_m2);
    [[nodiscard]] Material material() const;
    Result<void> set_material(Material material);  ///< from the next step on; wakes what touches it
    [[nodiscard]] Filter filter() const;
    void set_filter(Filter filter);             ///< ends touching that the new filter forbids
    [[nodiscard]] Vec2 one_way_normal() const;  ///< length 1, or (0, 0)
    /// Of any length. What touches the shape is decided anew, and wakes.
    Result<void> set_one_way_normal(Vec2 normal);
    [[nodiscard]] bool is_sensor() const;
    [[nodiscard]] bool is_seen_by_sensors() const;
    void set_seen_by_sensors(bool seen);  ///< sensors notice with the next step
    [[nodiscard]] std::uint64_t user_data() const;
    void set_user_data(std::uint64_t data);

  private:
    friend class World;
    Shape(WorldState& world, ShapeId id) : world_(&world), id_(id) {}

    WorldState* world_;
    ShapeId id_;
};

/// A world of rigid bodies. Movable, not copyable. One thread at a time may change it, and none may read it
/// meanwhile; different worlds are independent. Every function that takes a handle or a number from outside
/// gives an error for a null, stale or foreign handle and for a bad number, naming it, and then changes
/// nothing.
class World {
  public:
    /// Ends the program for a bad definition, as `create(def).value()` does.
    explicit World(const WorldDef& def = {});
    static Result<World> create(const WorldDef& def);
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    /// Advances by dt_s (0 < dt_s <= 1; the design point is 1/60) and replaces the events by those of this
    /// step.
    Result<void> step(float dt_s);

    Result<BodyId> create_body(const BodyDef& def);
    /// With its shapes and joints. What rested on it wakes.
    Result<void> destroy_body(BodyId id);
    /// All of them or, when one definition is bad, none; the error tells which. `ids` has a place for each
    /// and receives the handles in the order of the definitions.
    Result<void> create_bodies(std::span<const BodyDef> defs, std::span<BodyId> ids);
    /// All of them or, when one handle is bad or named twice, none; the error tells which.
    Result<void> destroy_bodies(std::span<const BodyId> ids);
    Result<Body> body(BodyId id);
    /// The same without words about why not, for callers that ask often.
    std::optional<Body> living_body(BodyId id);
    /// What `body(id)->position()` gives, or nothing when there is no such body: for callers that ask very
    /// often.
    std::optional<Position> position_of(BodyId id);
    Result<const Body> body(BodyId id) const;
    [[nodiscard]] bool contains(BodyId id) const;
    [[nodiscard]] std::vector<BodyId> bodies() const;
    /// Where all bodies are after the last step, in the order of `bodies()`; replaces what `out` holds. One
    /// pass over the store: a few nanoseconds for each, and no allocation once `out` has grown.
    void read_transforms(std::vector<BodyTransform>& out) const;

    /// A sleeping body stays asleep.
    Result<ShapeId> create_shape(BodyId body, const Geometry& geometry, const ShapeDef& def = {});
    /// Not for segments of chains: remove points of the chain, or destroy it.
    Result<void> destroy_shape(ShapeId id);
    Result<Shape> shape(ShapeId id);
    Result<const Shape> shape(ShapeId id) const;
    [[nodiscard]] bool contains(ShapeId id) const;

    /// On a body of any type; a chain has no mass. 10^5 points are made in a moment.
    Result<ChainId> create_chain(BodyId body, const ChainDef& def);
    Result<void> destroy_chain(ChainId id);
    Result<Chain> chain(ChainId id);
    Result<const Chain> chain(ChainId id) const;
    [[nodiscard]] bool contains(ChainId id) const;

    /// Of any kind; its bodies wake.
    Result<JointId> create_joint(const JointDef& def);
    Result<void> destroy_joint(JointId id);
    Result<Joint> joint(JointId id);
    Result<const Joint> joint(JointId id) const;
    [[nodiscard]] bool contains(JointId id) const;

    /// Of the last step, in an order that depends only on the history of the world. Valid until the next
    /// step.
    [[nodiscard]] std::span<const ContactBegin> contact_begins() const;
    [[nodiscard]] std::span<const ContactEnd> contact_ends() const;
    [[nodiscard]] std::span<const ContactHit> contact_hits() const;
    /// Joints that the last step loaded beyond their strength, and that are gone now.
    [[nodiscard]] std::span<const JointBreak> joint_breaks() const;

    /// What came to overlap sensors, and what ceased to, from the end of one step to the end of the next.
    /// What passes through a sensor within a step begins with it and ends with the next one. Ordered and
    /// valid as the events of contacts.
    [[nodiscard]] std::span<const SensorBegin> sensor_begins() const;
    [[nodiscard]] std::span<const SensorEnd> sensor_ends() const;
    /// The shapes that overlapped a sensor at the end of the last step, or passed through it within it; those
    /// destroyed since are among them still.
    Result<std::vector<ShapeId>> sensor_overlaps(ShapeId sensor) const;

    /// Bodies whose motion became infinite or NaN in the last step, or led beyond kFarthest_m. They were put
    /// back to where the step found them, and stopped. Empty unless forces or impulses beyond all measure
    /// act.
    [[nodiscard]] std::span<const BodyId> quarantined() const;

    // Queries. Between steps any number of threads may ask at once, as long as none changes the world. Each
    // gives an error for NaN and infinity, for places beyond kFarthest_m and lengths beyond 1e9 m, and for
    // geometry that `create_shape` would refuse. Lists are ordered by fraction or distance, then by slot of
    // the shape. Chains are met from their front only; a shape or box is where its middle is.

    /// The first shape met from origin_m to origin_m + translation_m. A ray without length meets nothing.
    Result<std::optional<RayHit>> cast_ray(Position origin_m, Vec2 translation_m,
                                           QueryFilter filter = {}) const;
    /// All shapes met; each once, where the ray enters it.
    Result<std::vector<RayHit>> cast_ray_all(Position origin_m, Vec2 translation_m,
                                             QueryFilter filter = {}) const;
    /// The first shape met by one that moves, without turning, from `start` on. What it overlaps at the start
    /// is met at fraction 0. Exact for rounded shapes too.
    Result<std::optional<ShapeHit>> cast_shape(const Geometry& geometry, const Transform& start,
                                               Vec2 translation_m, QueryFilter filter = {}) const;
    /// All shapes met; each once, where it is first touched.
    Result<std::vector<ShapeHit>> cast_shape_all(const Geometry& geometry, const Transform& start,
                                                 Vec2 translation_m, QueryFilter filter = {}) const;
    /// A shape that contains the point; of several, always the same one.
    Result<std::optional<ShapeId>> shape_at(Position point_m, QueryFilter filter = {}) const;
    /// The shapes that the geometry touches or overlaps at the pose.
    Result<std::vector<ShapeId>> shapes_overlapping(const Geometry& geometry, const Transform& pose,
                                                    QueryFilter filter = {}) const;
    /// The shapes that touch or overlap the box: the shapes, not their bounds. lower_m <= upper_m.
    Result<std::vector<ShapeId>> shapes_in_box(Position lower_m, Position upper_m,
                                               QueryFilter filter = {}) const;
    /// The nearest surface within radius_m; inside shapes, of the deepest one.
    Result<std::optional<SurfacePoint>> closest_point(Position point_m, float radius_m,
                                                      QueryFilter filter = {}) const;
    /// The nearest point of each shape within radius_m.
    Result<std::vector<SurfacePoint>> closest_points(Position point_m, float radius_m,
                                                     QueryFilter filter = {}) const;
    /// What limits the geometry at the pose: a line for each shape within reach_m, ordered by slot.
    Result<std::vector<CollisionPlane>> collision_planes(const Geometry& geometry, const Transform& pose,
                                                         float reach_m, QueryFilter filter = {}) const;

    /// The host's word on which pairs collide, besides their filters. Pairs that are near each other already
    /// keep the answer they have.
    void set_pair_filter(PairFilter filter);

    /// How materials of two kinds mix, in either order, from the next step on. Wakes what it makes a
    /// difference to.
    Result<void> set_material_rule(int kind_a, int kind_b, const MaterialRule& rule);
    [[nodiscard]] Result<MaterialRule> material_rule(int kind_a, int kind_b) const;

    /// Pushes the dynamic bodies around, asleep or awake, away from a point.
    Result<void> explode(const ExplosionDef& def);
    /// Force of the wind on all dynamic bodies that are awake, during the next step, which takes dt_s. It
    /// keeps none awake that it cannot move, and strong wind never makes a body faster than itself.
    Result<void> apply_wind(const WindDef& def, float dt_s);
    /// The same for one body, which wakes.
    Result<void> apply_wind(BodyId body, const WindDef& def, float dt_s);

    // Fracture: see fracture.h. Bodies of any type whose shapes all have an area, sensors aside, can be
    // divided; with a segment or a chain gives an error. Awake or asleep, what touches the body wakes, and so
    // do the pieces. When pieces are made, the handles of the body and its shapes are stale afterwards.

    /// Cuts the body along the segment. Each shape that the segment crosses from side to side is divided; one
    /// in which it begins or ends is not. The pieces, at least two; of one convex shape first that on the
    /// left of the way. An empty list when the body still hangs together: then nothing has changed.
    Result<std::vector<BodyId>> cut_body(BodyId body, Position from_m, Position to_m);
    /// Breaks the body about the impact (beside the body: the nearest point of its outline). The pieces, or
    /// an empty list when it is too small for two of them: then nothing has changed.
    Result<std::vector<BodyId>> break_body(BodyId body, Position impact_m, const FractureDef& def = {});
    /// From now on, contacts that press harder on the body than it withstands are told as BodyBreak. Replaces
    /// what was set before. The body must be one that can be divided; it wakes.
    Result<void> set_breakable(BodyId body, const BreakableDef& def);
    Result<void> clear_breakable(BodyId body);  ///< does nothing for a body that is not breakable
    Result<std::optional<BreakableDef>> breakable(BodyId body) const;
    /// Of the last step, ordered by slot of the body. Valid until the next step.
    [[nodiscard]] std::span<const BodyBreak> body_breaks() const;
    /// Breaks a body that the last step told about, as its BreakableDef says. The pieces, or an empty list
    /// when it is too small for two of them: then nothing has changed.
    Result<std::vector<BodyId>> break_body(const BodyBreak& event);
    /// The bodies that lie on the segment, in the order in which it enters them, and what `cut_body` would
    /// make of each. For swords, lasers, and lines to show to the player. Changes nothing; sensors are not
    /// seen.
    Result<std::vector<CutHit>> cuts_along(Position from_m, Position to_m, QueryFilter filter = {}) const;

    [[nodiscard]] Vec2 gravity() const;
    Result<void> set_gravity(Vec2 gravity_m_s2);  ///< wakes every body
    [[nodiscard]] Counts counts() const;
    /// As `counts().awake_bodies`, but without walking over all contacts.
    [[nodiscard]] int awake_body_count() const;
    /// How deep two touching shapes overlap at most, as they stand now, m. For tests and tools: it collides
    /// every touching pair anew.
    [[nodiscard]] float max_penetration_m() const;
    /// Errors, energy, momentum and counts as they are now, and the times of the last step that was measured.
    /// Costs about as much as the contacts of a step; steps do nothing for it.
    [[nodiscard]] WorldReport report() const;
    [[nodiscard]] std::uint64_t step_count() const;
    /// Whether steps measure their stages; off at first. Costs a look at the clock per stage.
    void set_profiling(bool enabled);
    /// Of the last step that was measured.
    [[nodiscard]] const Profile& profile() const;
    /// 64 bits over poses, velocities, sleep and remembered impulses: worlds with the same history and inputs
    /// have the same hash on every compiler, build type and processor.
    [[nodiscard]] std::uint64_t state_hash() const;

    /// Writes all that the future depends on (state.h): bodies, shapes, chains, joints, contacts with what
    /// they remember, who sleeps, events, rules of materials, gravity and the other numbers of WorldDef. Not
    /// part of it are threads, the pair filter and the profile. What `into` held before is replaced.
    Result<void> snapshot(Snapshot& into) const;
    [[nodiscard]] Result<Snapshot> snapshot() const;
    /// Puts the world into the state of the snapshot, its own or another world's, as if all since then had
    /// not happened. Handles name what they named when the snapshot was taken (of another world: with this
    /// world's tag, see `own`); handles to what was made since are stale, until the same slot is used again.
    /// An error for bytes that are damaged, of another version or no snapshot; then nothing has changed.
    Result<void> restore(std::span<const std::byte> snapshot);
    /// The handle by which this world, restored from another world's snapshot, knows what that one called so.
    template <class Tag>
    [[nodiscard]] Handle<Tag> own(Handle<Tag> id) const {
        return Handle<Tag>::make(id.index1, id.generation, id ? tag() : 0);
    }

    // For debug drawing and tools: see debug.h. Each walks over the world when it is called.

    /// Those that touch.
    [[nodiscard]] std::vector<DebugContact> debug_contacts() const;
    [[nodiscard]] std::vector<DebugIsland> debug_islands() const;
    /// Of all shapes but sensors, which have none.
    [[nodiscard]] std::vector<DebugBox> debug_boxes() const;

  private:
    explicit World(std::unique_ptr<WorldState> state);
    [[nodiscard]] std::uint16_t tag() const;

    std::unique_ptr<WorldState> state_;
};

}  // namespace cairn::physics
