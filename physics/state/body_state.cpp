// Bodies as bytes: in the order of the slots what each is made of, unless it is made as the one before it,
// and what it has of its own; then the rows, column by column.
#include <algorithm>
#include <cmath>
#include <limits>

#include "state/sections.h"
#include "state/slots.h"

namespace cairn::physics {
namespace {

// Flags that mean nothing between steps: groups that are solved directly are chosen anew in each.
constexpr std::uint32_t kKeptFlags = place_flag::kFast | place_flag::kTurnsFar | place_flag::kBoxesMoved |
                                     place_flag::kRouses | place_flag::kHasWay | place_flag::kHasty;

constexpr std::size_t kMakeBytes = packed_size<BodyRecord>() + packed_size<MassLedger::Entry>();

// What a body has: a byte ahead of it tells.
constexpr std::uint8_t kIsNew = 1;  // a make that is not that of the body before
constexpr std::uint8_t kHasJointInertia = 2;
constexpr std::uint8_t kSleeps = 4;  // and another after it
constexpr std::uint8_t kHasUserData = 8;

constexpr std::size_t size_of_body(std::uint8_t has) {
    if (has == 0) return packed_size<Place>();  // most
    return packed_size<Place>() + ((has & kIsNew) != 0 ? kMakeBytes : 0) +
           ((has & kHasJointInertia) != 0 ? sizeof(BodyRecord::joint_inertia) : 0) +
           ((has & kSleeps) != 0 ? sizeof(BodyRecord::next_sleeper) : 0) +
           ((has & kHasUserData) != 0 ? sizeof(BodyRecord::user_data) : 0);
}
constexpr std::uint8_t kHasAll = kIsNew | kHasJointInertia | kSleeps | kHasUserData;
constexpr std::size_t kMostBytes = 1 + size_of_body(kHasAll);

template <class T>
bool all_zero(const std::vector<T>& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    return std::all_of(bytes, bytes + values.size() * sizeof(T), [](unsigned char b) { return b == 0; });
}

// Forces are rare, and last for one step only.
void save_rows(const BodyRows& rows, Writer& out) {
    const auto& [moved, rotation_before, velocity, spin, force, torque, rest_time, box_slack, body] = rows;
    const bool acts = !all_zero(force) || !all_zero(torque);
    out.list(body);
    out.value(acts);
    constexpr std::size_t kRowBytes = 4 * sizeof(Vec2) + 4 * sizeof(float);
    std::byte* at = out.room(body.size() * kRowBytes);
    const auto write = [&](const auto& column) { at = put_all(at, std::span(column)); };
    write(moved);
    write(rotation_before);
    write(velocity);
    write(spin);
    write(rest_time);
    write(box_slack);
    if (acts) {
        write(force);
        write(torque);
    }
    out.end(at);
}

// Without leaving early, so that many are looked at together.
template <class T>
bool all_finite(const std::vector<T>& column) {
    const auto* numbers = reinterpret_cast<const float*>(column.data());
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < column.size() * sizeof(T) / sizeof(float); ++i)
        any |= static_cast<std::uint32_t>(!(std::fabs(numbers[i]) <= std::numeric_limits<float>::max()));
    return any == 0;
}

void load_rows(Reader& in, BodyRows& rows) {
    auto& [moved, rotation_before, velocity, spin, force, torque, rest_time, box_slack, body] = rows;
    in.list(body);
    bool acts = false;
    in.value(acts);
    const std::size_t count = in.ok() ? body.size() : 0;
    const auto read = [&](auto& column) {
        column.resize(count);
        in.all(std::span(column));
    };
    read(moved);
    read(rotation_before);
    read(velocity);
    read(spin);
    read(rest_time);
    read(box_slack);
    if (acts) {
        read(force);
        read(torque);
    } else {
        force.assign(count, {});
        torque.assign(count, 0);
    }
    in.require(all_finite(moved) && all_finite(velocity) && all_finite(spin) && all_finite(force) &&
                   all_finite(torque),
               "a body moves infinitely fast or far");
    in.settle();
}

// Every body gets its row, and no other.
void take_rows(Reader& in, BodyStore& bodies, RowSet set) {
    const Lookup records(bodies.slots);
    int row = 0;
    for (const int b : bodies.rows(set).body) {
        BodyRecord* const found = records.find(b);
        if (!in.require(found != nullptr && found->row == kNone,
                        "a row is of no body, or of one that has a row already"))
            return;
        BodyRecord& record = *found;
        if (!in.require((record.type == BodyType::Static) == (set == RowSet::Static),
                        "a static body is among those that move, or the other way round"))
            return;
        if (!in.require((record.next_sleeper == kNone) == (set != RowSet::Asleep),
                        "a body that does not sleep is among those that do, or the other way round"))
            return;
        record.set = set;
        record.row = row;
        bodies.places[static_cast<std::size_t>(b)].row = set == RowSet::Awake ? row + 1 : kWorldRow;
        ++row;
    }
}

// Every rule is looked at: to leave early would cost more.
bool is_sound(const BodyRecord& body) {
    constexpr float kMost = std::numeric_limits<float>::max();
    bool sound = true;
    for (const float x : {body.linear_damping_1_s, body.angular_damping_1_s, body.sleep_speed_m_s,
                          body.inverse_mass, body.inverse_inertia})
        sound &= (x >= 0) & (x <= kMost);
    sound &= std::fabs(body.gravity_scale) <= kMost;
    sound &= (body.extent_m >= 0) & (body.extent_m <= kMostExtent_m);
    for (const float arm_m : {body.turn_arm_m, body.center_arm_m})
        sound &= (arm_m >= 0) & (arm_m <= kMostExtent_m);
    sound &=
        (body.inner_radius_m >= 0) & !std::signbit(body.inner_radius_m);  // which would divide to -infinity
    sound &= (body.type == BodyType::Dynamic) | ((body.inverse_mass == 0) & (body.inverse_inertia == 0));
    return sound && is_within_reach(body.mass.center_m);
}

bool is_sound(const Place& place) {
    constexpr double kMost = std::numeric_limits<double>::max();
    const float turned = place.rotation.c * place.rotation.c + place.rotation.s * place.rotation.s;
    return ((place.flags & ~kKeptFlags) == 0) & (std::fabs(turned - 1) < 1e-3f) &
           (std::fabs(place.center.x) <= kMost) & (std::fabs(place.center.y) <= kMost);
}

void load_records(Reader& in, Stores& stores) {
    BodyStore& bodies = stores.bodies;
    std::vector<MassLedger::Entry>& masses = stores.masses.entries;
    const auto slots = static_cast<std::size_t>(bodies.slots.end_index());
    bodies.places.resize(slots);
    masses.resize(slots);
    if (slots > static_cast<std::size_t>(bodies.slots.size())) {  // places of bodies that are gone
        std::fill(bodies.places.begin(), bodies.places.end(), Place{});
        std::fill(masses.begin(), masses.end(), MassLedger::Entry{});
    }
    BodyRecord make;
    MassLedger::Entry mass;
    bool is_made = false;
    bool all_sound = true;
    const std::byte* at = in.rest().data();
    std::size_t left = in.rest().size();
    Reading reading;
    for_each_alive(bodies.slots, [&](int body, BodyRecord& record) {
        if (!in.ok()) return;
        const auto has = left > 0 ? std::to_integer<std::uint8_t>(*at) : std::uint8_t{0};
        const std::size_t size = 1 + size_of_body(has);
        if (!in.require(size <= left, "it ends in the middle of the bodies")) return;
        if (!in.require(has <= kHasAll, "a body has what no body has")) return;
        left -= size;
        ++at;
        if ((has & kIsNew) != 0) {
            at = get(get(at, make, reading), mass, reading);
            is_made = true;
            if (!in.require(is_sound(make), "a body has a mass or an extent that no body has")) return;
        } else if (!in.require(is_made, "the first body is as one before it")) {
            return;
        }
        const auto slot = static_cast<std::size_t>(body);
        record = make;
        masses[slot] = mass;
        Place& place = bodies.places[slot];
        at = get_unchecked(get_unchecked(at, place.center), place.rotation);
        at = get_unchecked(at, place.flags);
        all_sound &= is_sound(place);
        if (has == 0) return;
        if ((has & kHasJointInertia) != 0) at = get(at, record.joint_inertia, reading);
        if ((has & kSleeps) != 0) at = get(at, record.next_sleeper, reading);
        if ((has & kHasUserData) != 0) at = get(at, record.user_data, reading);
        all_sound &=
            (record.joint_inertia >= 0) & (record.joint_inertia <= std::numeric_limits<float>::max());
    });
    if (!in.require(all_sound, "a body is at no place in the world, or as heavy for joints as no body is"))
        return;
    in.end(at);
    in.reading.bad |= reading.bad;
    in.settle();
}

// Rings: each sleeper is followed by one, and follows one.
void check_sleepers(Reader& in, const BodyStore& bodies, std::vector<std::uint8_t>& followed) {
    followed.assign(static_cast<std::size_t>(bodies.slots.end_index()), 0);
    for (const int body : bodies.rows(RowSet::Asleep).body) {
        const int next = bodies.slots[body].next_sleeper;
        const bool sleeps = names(bodies.slots, next) && bodies.slots[next].set == RowSet::Asleep;
        if (!in.require(sleeps && followed[static_cast<std::size_t>(next)] == 0,
                        "bodies that sleep together do not form a ring"))
            return;
        followed[static_cast<std::size_t>(next)] = 1;
    }
}

}  // namespace

void save_bodies(const Stores& stores, Writer& out) {
    const BodyStore& bodies = stores.bodies;
    save_slots(bodies.slots, out);
    std::byte* at = out.room(static_cast<std::size_t>(bodies.slots.size()) * kMostBytes);
    const BodyRecord* last = nullptr;
    const MassLedger::Entry* last_mass = nullptr;
    for_each_alive(bodies.slots, [&](int body, const BodyRecord& record) {
        const auto slot = static_cast<std::size_t>(body);
        const MassLedger::Entry& mass = stores.masses.entries[slot];
        const bool is_new =
            last == nullptr || (differing_bits(*last, record) | differing_bits(*last_mass, mass)) != 0;
        const auto has = static_cast<std::uint8_t>(
            (is_new ? kIsNew : 0) | (record.joint_inertia != 0 ? kHasJointInertia : 0) |
            (record.next_sleeper != kNone ? kSleeps : 0) | (record.user_data != 0 ? kHasUserData : 0));
        at = put(at, has);
        if (is_new) at = put(put(at, record), mass);
        last = &record;
        last_mass = &mass;
        Place place = bodies.places[slot];
        place.flags &= kKeptFlags;
        at = put(at, place);
        if ((has & kHasJointInertia) != 0) at = put(at, record.joint_inertia);
        if ((has & kSleeps) != 0) at = put(at, record.next_sleeper);
        if ((has & kHasUserData) != 0) at = put(at, record.user_data);
    });
    out.end(at);
    for (const RowSet set : {RowSet::Static, RowSet::Awake, RowSet::Asleep}) save_rows(bodies.rows(set), out);
    out.list(stores.boxes_moved);
    out.list(stores.masses.reshaped);
}

void load_bodies(Reader& in, RestoreSpace& to) {
    Stores& stores = to.stores;
    BodyStore& bodies = stores.bodies;
    in.begin("bodies");
    load_slots(in, bodies.slots);
    if (in.ok()) load_records(in, stores);
    if (!in.ok()) return;

    in.begin("rows of bodies");
    for (const RowSet set : {RowSet::Static, RowSet::Awake, RowSet::Asleep}) {
        load_rows(in, bodies.rows(set));
        if (in.ok()) take_rows(in, bodies, set);
    }
    if (!in.ok()) return;
    std::size_t rows = 0;
    for (const RowSet set : {RowSet::Static, RowSet::Awake, RowSet::Asleep})
        rows += bodies.rows(set).body.size();
    in.require(rows == static_cast<std::size_t>(bodies.slots.size()), "a body has no row");
    if (in.ok()) check_sleepers(in, bodies, to.marks);

    in.list(stores.boxes_moved);
    in.list(stores.masses.reshaped);
    if (!in.ok()) return;
    const auto is_slot = [&](int body) { return body >= 0 && body < bodies.slots.end_index(); };
    to.marks.assign(static_cast<std::size_t>(bodies.slots.end_index()), 0);
    for (const int body : stores.boxes_moved) {
        if (!in.require(is_slot(body) && to.marks[static_cast<std::size_t>(body)] == 0,
                        "a box was moved of no body, or a body is listed twice"))
            return;
        to.marks[static_cast<std::size_t>(body)] = 1;
        bodies.places[static_cast<std::size_t>(body)].flags |= place_flag::kBoxesMoved;
    }
    for (const int body : stores.masses.reshaped) {
        if (!in.require(is_slot(body) && !stores.masses.entries[static_cast<std::size_t>(body)].is_listed,
                        "a body is listed as reshaped that there is not, or twice"))
            return;
        stores.masses.entries[static_cast<std::size_t>(body)].is_listed = true;
    }
}

}  // namespace cairn::physics
