// A whole world as bytes, and back. What is read goes into stores that nobody uses yet; only when all of it
// has been found sound do they change places with the world's own, which become the stores to read into next
// time. So a refused snapshot changes nothing, and a restore that has warmed up allocates nothing.
#include <utility>

#include <cairn/physics/state.h>
#include <cairn/physics/world.h>

#include "state/frame.h"
#include "state/sections.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

constexpr FrameKind kSnapshot{"CairnSta", "snapshot", 8};

// Everything of a world. What is not part of the state: threads, what is measured, and what the host is
// asked.
void save(const WorldState& world, Writer& out) {
    const auto& [def, stores, events, scratch, direct, step_count, stepping, profile, profiling, last, tasks,
                 restore_space] = world;
    out.value(def);
    out.value(step_count);
    out.value(last);
    const auto& [bodies, prototypes, shapes, fat_boxes, chains, contacts, joints, domains, broad, boxes_moved,
                 masses, rules, sensors, breakables, filter_calls] = stores;
    save_bodies(stores, out);
    save_shapes(stores, out);
    save_contacts(contacts, out);
    save_joints(joints, out);
    save_links(stores, out);
    save_contact_lists(stores, out);
    save_joint_lists(joints, out);
    save_broad(stores, out);
    save_events(events, out);
}

void load(Reader& in, RestoreSpace& to) {
    in.begin("settings");
    in.value(to.def);
    in.value(to.step_count);
    in.value(to.last);
    in.require(std::isfinite(to.last.longest_h_s), "the longest substep has no length");
    if (!in.settle()) return;
    if (const check::Fault fault = validate(to.def)) return in.fail(fault->message);
    Stores& stores = to.stores;
    load_bodies(in, to);
    if (in.ok()) load_shapes(in, to);
    if (in.ok()) load_contacts(in, stores.contacts);
    if (in.ok()) load_joints(in, stores.joints);
    if (in.ok()) load_links(in, stores);
    if (in.ok()) load_contact_lists(in, stores);
    if (in.ok()) load_joint_lists(in, stores);
    if (in.ok()) load_broad(in, stores);
    if (in.ok()) load_events(in, to.events);
    if (in.ok()) in.require(in.at_end(), "there is more than there should be");
}

// Groups of the last step are of bodies that are gone.
void forget_groups(DirectGroups& direct) {
    for (std::size_t g = 0; g < static_cast<std::size_t>(direct.count); ++g) {
        for (const int body : direct.groups[g].bodies) direct.of_body[static_cast<std::size_t>(body)] = kNone;
    }
    direct.joints.clear();
    direct.count = 0;
    direct.version = DirectGroups::kUnknown;
}

void take_over(WorldState& world, RestoreSpace& from) {
    std::swap(from.stores.rules.filter, world.stores.rules.filter);
    std::swap(world.stores, from.stores);
    std::swap(world.events, from.events);
    const TaskSystem* const tasks = world.def.tasks;
    const int threads = world.def.threads;
    world.def = from.def;
    world.def.tasks = tasks;
    world.def.threads = threads;
    world.step_count = from.step_count;
    world.last = from.last;
    forget_groups(world.direct);
    if (world.scratch.batches) world.scratch.batches->forget();
    if (world.scratch.standing) world.scratch.standing->unmoved.forget();
}

}  // namespace

Result<void> World::snapshot(Snapshot& into) const {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    Writer out(into);
    begin_frame(out);
    save(*state_, out);
    end_frame(out, kSnapshot);
    return {};
}

Result<Snapshot> World::snapshot() const {
    Snapshot made;
    if (const Result<void> done = snapshot(made); !done) return done.error();
    return made;
}

std::uint16_t World::tag() const {
    return state_->stores.bodies.slots.world_tag();
}

Result<void> World::restore(std::span<const std::byte> bytes) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (auto fault = validate_frame(bytes, kSnapshot)) return *fault;
    if (!state_->restore_space) state_->restore_space = std::make_unique<RestoreSpace>(tag());
    Reader in(bytes, kFrameBytes, tag(), kSnapshot.name);
    load(in, *state_->restore_space);
    if (in.fault()) return *in.fault();
    take_over(*state_, *state_->restore_space);
    return {};
}

}  // namespace cairn::physics
