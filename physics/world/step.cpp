// The table of contents of a step: every stage in its order, and no logic. physics/README.md is the tour.
#include "world/step.h"

#include <optional>

#include "base/stage_clock.h"
#include "integrator/integrate.h"
#include "world/awaited_contacts.h"
#include "world/batches.h"
#include "world/bent_ways.h"
#include "world/bounce_energy.h"
#include "world/bounces.h"
#include "world/breakables.h"
#include "world/contact_events.h"
#include "world/contact_order.h"
#include "world/contact_update.h"
#include "world/contacts.h"
#include "world/direct_groups.h"
#include "world/direct_solve.h"
#include "world/domains.h"
#include "world/faint_bounces.h"
#include "world/fast_bodies.h"
#include "world/fast_guard.h"
#include "world/finalize.h"
#include "world/impact_groups.h"
#include "world/joint_constraints.h"
#include "world/joint_lists.h"
#include "world/pin_loads.h"
#include "world/prepare.h"
#include "world/sensors.h"
#include "world/sleep.h"
#include "world/solve.h"
#include "world/statics.h"
#include "world/sweep_guard.h"
#include "world/sweeping_contacts.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {

void step_world(WorldState& world, float dt_s) {
    Stores& stores = world.stores;
    StepScratch& scratch = world.scratch;
    TaskPool& tasks = world.tasks;
    const WorldDef& def = world.def;
    // A world in which all sleeps wakes no threads.
    std::optional<TaskPool::Region> together;
    if (stores.bodies.rows(RowSet::Awake).size() > 0) together.emplace(tasks);
    StageClock clock(world.profiling ? &world.profile : nullptr);
    clock.enter(Stage::Pairs);
    start_events(world.events);
    settle_reshaped(stores);
    divide_into_domains(stores, world.step_count, scratch);
    order_contacts(stores, world.step_count, scratch);
    cover_fast_ways(stores, def.gravity_m_s2, dt_s, scratch, tasks);
    find_new_pairs(stores, scratch, tasks);
    const int substeps = substeps_under(length(def.gravity_m_s2), dt_s, def.substeps, least_unit(stores));
    const StepTime time = make_step_time(dt_s, substeps, world.last);
    choose_direct_groups(stores, def.joint_solver, time.most_swept_hz, world.direct);
    prepare_motions(stores.bodies, def.gravity_m_s2, dt_s, scratch, tasks);
    clock.enter(Stage::Contacts);
    const ContactRules rules =
        make_contact_rules(time.h_s, def.max_push_out_speed_m_s, def.restitution_speed_m_s);
    update_contacts(world, time, rules);

    clock.enter(Stage::Prepare);
    seat_joints(stores, time, scratch);
    order_joints(stores, world.step_count, scratch);
    estimate_pin_loads(stores, def.gravity_m_s2, time, world.direct);
    choose_movers(stores, scratch);
    prepare_joints(stores, time, scratch, tasks);
    StaticsEstimate statics(stores, def.gravity_m_s2, time, scratch, tasks);
    if (world.direct.count > 0) statics.finish(tasks);
    start_direct_solve(stores, rules, time, scratch, world.direct, tasks);
    scratch.plain_groups.divide(scratch.scalar_contacts, scratch.contacts, scratch.motions, tasks);

    clock.enter(Stage::Solve);
    const Acting acting = what_acts(stores, scratch);
    const int acting_substeps = substeps_of(time, acting, scratch, world.direct);
    if (acting_substeps > 0)
        prepare_kicks(def.gravity_m_s2, time, rules, scratch, tasks, [&] { statics.share_loads(); });
    statics.finish(tasks);
    cut_into_batches(stores, acting_substeps, scratch);
    solve_batches(scratch, acting_substeps, rules, time, tasks);
    leave_resting(scratch, acting_substeps, acting, world.direct);
    keep_impulses(scratch, acting_substeps, tasks);
    for (int substep = 0; is_made(scratch, substep, acting_substeps); ++substep) {
        note_spring_speeds(stores.joints.lanes, scratch, tasks);
        integrate_velocities(scratch, acting, substep, tasks);
        solve_direct(world.direct, scratch, rules, time.h_s, acting, tasks);
        if (substep == 0) warm_start_contacts(scratch, time, tasks);
        reach_contacts(scratch, substep, rules, time);
        collide_sweeping(stores, scratch, substep, rules, time.h_s);
        solve(stores, scratch, rules, time.h_s, acting, Pass::Biased, substep, tasks);
        integrate_positions(scratch, time.h_s, tasks);
        move_direct(world.direct, scratch, rules, time.h_s, acting, tasks);
        solve(stores, scratch, rules, time.h_s, acting, Pass::Relax, substep, tasks);
        note_standing(scratch, substep, time.h_s, tasks);
    }
    return_rest(scratch, acting_substeps);
    note_resting(acting_substeps, scratch);
    clock.enter(Stage::Store);
    fly_freely(scratch, def.gravity_m_s2, time.dt_s, world.step_count, tasks);
    bounce_in_lanes(stores.contacts, scratch, time, rules, tasks);
    collect_outcomes(stores.contacts, scratch, tasks);
    place_bounces(stores.bodies.rows(RowSet::Awake), scratch, time, rules);
    pass_impacts_on(stores, scratch, time, rules);
    give_back_speed(stores, scratch, rules);
    push_apart(scratch.deep, scratch.contacts, def.max_push_out_speed_m_s * dt_s, scratch.motions);
    close_tears(scratch.torn, scratch.motions);

    halt_lost_bodies(stores.bodies, scratch, world.events.quarantined, tasks);
    turn_arms_back(scratch, acting_substeps);
    report_contacts(stores, scratch, def.hit_speed_m_s, world.events);
    find_overloads(stores, scratch, world.events);
    store_contact_impulses(stores.contacts, time, scratch);
    store_direct(world.direct, stores, scratch);
    store_joint_impulses(stores.joints, time, scratch);
    clock.enter(Stage::Finalize);
    finalize_bodies(stores, scratch, time.dt_s, def.enable_sleep, tasks);
    clock.enter(Stage::Continuous);
    carry_swept_bodies(stores, scratch);
    hold_bent_ways(stores, scratch, time.dt_s, tasks);
    hold_fast_bodies(stores, scratch, tasks);
    hold_sweeping_bodies(stores, scratch);
    hold_pressed_bodies(stores, scratch, tasks);
    forget_halted(stores, world.events.quarantined);
    break_joints(stores, scratch, world.events);
    clock.enter(Stage::Sensors);
    update_sensors(stores, scratch.fast, world.events);
    clock.enter(Stage::Sleep);
    sleep_islands(stores, world.step_count, scratch);
    break_overloaded(world);
    note_step(time, world.last);
    ++world.step_count;
}

}  // namespace cairn::physics
