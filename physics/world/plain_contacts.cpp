// Contacts in plain form.
#include "world/plain_contacts.h"

#include <algorithm>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "resolve/deep_overlap.h"
#include "world/awaited_contacts.h"
#include "world/sweeping_contacts.h"

namespace cairn::physics {
namespace {

constexpr float kCalm_m_s = 1;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

bool is_calm(const Motions& motions, int row) {
    return length_squared(motions.velocity[row].v) < kCalm_m_s * kCalm_m_s;
}

void PlainContacts::begin() {
    scratch_.contacts.clear();
    scratch_.scalar_contacts.clear();
    scratch_.deep.clear();
    scratch_.awaited.clear();
    scratch_.bent.bends.clear();
    scratch_.sweeping.clear();
    mark_what_was_put_in();
}

ContactConstraint PlainContacts::form_of(ContactInput input, const ContactBlock& block, int lane) const {
    for (int i = 0; i < input.count; ++i) input.points[i].impulse = block.points[i].impulse[lane];
    input.friction_impulse = block.friction_impulse[lane];
    return make_contact(input, scratch_.motions, rules_);
}

void PlainContacts::add_beside(const ContactConstraint& constraint, int lane, bool is_loose) {
    scratch_.contacts.push_back(constraint);
    ContactLanes& lanes = stores_.contacts.lanes;
    const bool pushed_apart = is_pushed_apart(constraint);
    if (pushed_apart) {
        note_deep();
        hide_overlap(lanes.block(lane / kLanes), lane % kLanes);
    }
    if (!is_loose) return;
    if (!pushed_apart && sweeps(constraint)) {
        add_sweeping(scratch_, 0);
    } else {
        solve_last();
    }
    lanes.blank(lane);
}

void PlainContacts::add(ContactInput input, const ContactMemory& memory) {
    bool carried = false;
    std::array<bool, 2> known{};
    for (int i = 0; i < input.count; ++i) {
        for (int j = 0; j < 2; ++j) {
            if (memory.features[j] != input.points[i].feature) continue;
            input.points[i].impulse = memory.impulse[j];
            known[i] = carried = true;
        }
    }
    input.friction_impulse = carried ? memory.friction_impulse : 0;
    ContactConstraint constraint = make_contact(input, scratch_.motions, rules_);
    for (int i = 0; i < input.count; ++i) {
        const ContactPointConstraint& p = constraint.points[i];
        const bool rests = p.separation <= 0.1f * input.unit * tuning::kLinearSlop_m &&
                           std::fabs(p.closing_velocity) < input.unit * kRestSpeed_m_s;
        if (!known[i] && rests) constraint.points[i].normal_impulse = kUnknownImpulse;
    }
    scratch_.contacts.push_back(constraint);
    const bool pushed_apart = is_pushed_apart(constraint);
    if (pushed_apart) note_deep();
    const ContactRecord& c = stores_.contacts.slots[input.contact];
    const bool awaits = input.reached_s > 0 && (whirls(c.body_a) || whirls(c.body_b)) && !is_direct(c);
    if (awaits) await_contact(input, stores_.bodies.center_offset(c.body_a, c.body_b), time_, scratch_);
    if (!pushed_apart && sweeps(constraint)) {
        add_sweeping(scratch_, awaits ? scratch_.awaited.back().substep + 1 : 0);
    } else if (!awaits) {
        solve_last();
    }
}

void PlainContacts::leave_to_groups() {
    bool some = false;
    const auto is_in_group = [&](int contact) {
        const bool in_group = is_direct(stores_.contacts.slots[scratch_.contacts[at(contact)].contact]);
        some = some || in_group;
        return in_group;
    };
    const auto leave = [&](const auto& noted) {
        if (!is_in_group(noted.contact)) return false;
        scratch_.scalar_contacts.push_back(noted.contact);
        return true;
    };
    std::erase_if(scratch_.sweeping, leave);
    std::erase_if(scratch_.awaited, leave);
    std::erase_if(scratch_.deep, [&](const DeepOverlap& overlap) {
        if (!is_in_group(overlap.contact)) return false;
        show_overlap(scratch_.contacts[at(overlap.contact)], overlap);
        return true;
    });
    if (!some) return;
    // One may have been awaited and sweeping from then on.
    std::vector<int>& solved = scratch_.scalar_contacts;
    std::ranges::sort(solved);
    solved.erase(std::unique(solved.begin(), solved.end()), solved.end());
}

// The constraint that was added last is solved itself: no lane does it.
void PlainContacts::solve_last() {
    scratch_.contacts.back().in_lane = false;
    scratch_.scalar_contacts.push_back(static_cast<int>(scratch_.contacts.size()) - 1);
}

// Of the constraint that was added last.
void PlainContacts::note_deep() {
    ContactConstraint& c = scratch_.contacts.back();
    scratch_.deep.push_back(
        {static_cast<int>(scratch_.contacts.size()) - 1, {c.points[0].separation, c.points[1].separation}});
    hide_overlap(c);
}

// What is solved with a structure of joints is moved by that alone. What was pressed together by others is
// parted by velocities, which reach through all of them.
bool PlainContacts::is_pushed_apart(const ContactConstraint& c) const {
    const ContactRecord& record = stores_.contacts.slots[c.contact];
    return was_put_in(record) && overlaps_deeply(c, time_.dt_s) && is_calm(scratch_.motions, c.a) &&
           is_calm(scratch_.motions, c.b) && !is_direct(record);
}

// Bodies that are moved apart press others into each other.
void PlainContacts::mark_what_was_put_in() {
    scratch_.pushed.clear();
    for (const int contact : stores_.contacts.put_in) {
        const ContactRecord& c = stores_.contacts.slots[contact];
        if (!c.put_in) continue;
        for (const int body : {c.body_a, c.body_b}) {
            if (stores_.bodies.slots[body].type != BodyType::Dynamic) continue;
            stores_.bodies.places[body].flags |= place_flag::kPushed;
            scratch_.pushed.push_back(body);
        }
    }
}

bool PlainContacts::was_put_in(const ContactRecord& record) const {
    return record.put_in || has_flag(record, place_flag::kPushed);
}

// What overlaps deeply counts as put in as long as it has points.
void PlainContacts::end() {
    ContactStore& contacts = stores_.contacts;
    for (const int body : scratch_.pushed) stores_.bodies.places[body].flags &= ~place_flag::kPushed;
    for (const int contact : contacts.put_in) contacts.slots[contact].put_in = false;
    contacts.put_in.clear();
    for (const DeepOverlap& overlap : scratch_.deep) {
        const int contact = scratch_.contacts[static_cast<std::size_t>(overlap.contact)].contact;
        contacts.slots[contact].put_in = true;
        contacts.put_in.push_back(contact);
    }
}

bool PlainContacts::is_direct(const ContactRecord& record) const {
    return has_flag(record, place_flag::kDirect);
}

bool PlainContacts::sweeps(const ContactConstraint& c) const {
    const ContactRecord& record = stores_.contacts.slots[c.contact];
    return has_flag(record, place_flag::kSweeps) && c.unit == 1 && !is_direct(record);
}

// What is round meets nothing by turning.
bool PlainContacts::whirls(int body) const {
    return (stores_.bodies.places[body].flags & place_flag::kWhirls) != 0 &&
           stores_.bodies.slots[body].turn_arm_m > tuning::kLinearSlop_m;
}

bool PlainContacts::has_flag(const ContactRecord& record, std::uint32_t flag) const {
    const auto flags = [&](int body) { return stores_.bodies.places[body].flags; };
    return ((flags(record.body_a) | flags(record.body_b)) & flag) != 0;
}

}  // namespace cairn::physics
