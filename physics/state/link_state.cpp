// What bodies have, as bytes: for each body that is alive a byte that tells which lists it has, then these,
// item by item, the last one marked. Reading links the records anew, so no list can run in a circle or meet
// another, whatever the bytes say.
#include <cstring>

#include "state/sections.h"
#include "state/slots.h"

namespace cairn::physics {
namespace {

constexpr std::uint8_t kHasShapes = 1;
constexpr std::uint8_t kHasSensors = 2;
constexpr std::uint8_t kHasContacts = 4;
constexpr std::uint8_t kHasJoints = 8;
constexpr std::uint8_t kHasNextShape = 16;  // only the shape after that of the body before, and no list
constexpr std::uint8_t kHasAll = 31;
constexpr std::uint32_t kLastBit = 0x80000000u;
constexpr const char* kWrongShape = "a body has a shape that there is not, or that another has";

// next(item) leads on; kNone ends the list.
template <class Next>
std::byte* put_list(std::byte* at, int first, const Next& next) {
    for (int item = first; item != kNone;) {
        const int following = next(item);
        at = put(at, static_cast<std::uint32_t>(item) | (following == kNone ? kLastBit : 0));
        item = following;
    }
    return at;
}

template <class Records>
auto along_edges(const Records& records) {
    return [&records](int key) { return records[edge_record(key)].edges[edge_side(key)].next; };
}

class Linking {
  public:
    Linking(Reader& in, Stores& stores)
        : in_(in),
          stores_(stores),
          shapes_(stores.shapes),
          contacts_(stores.contacts.slots),
          joints_(stores.joints.slots),
          rest_(in.rest()) {}

    // After a fault nothing is read any more.
    void link(int body, BodyRecord& record) {
        if (at_ >= rest_.size()) return fail("it ends before the lists of all bodies");
        const auto lists = std::to_integer<std::uint8_t>(rest_[at_++]);
        if ((lists & kHasNextShape) != 0) take_next_shape(body, record);
        if ((lists & kHasShapes) != 0) read_shapes(body, record);
        if ((lists & kHasSensors) != 0) read_sensors(body, record);
        if ((lists & kHasContacts) != 0) {
            read_edges(contacts_, body, record.first_contact, edges_of_contacts_,
                       "a body has an edge of a contact that there is not, or another has it");
        }
        if ((lists & kHasJoints) != 0) {
            read_edges(joints_, body, record.first_joint, edges_of_joints_,
                       "a body has an edge of a joint that there is not, or another has it");
        }
        if (lists > kHasAll) fail("a body has lists that there are not");
    }

    void finish() {
        if (in_.ok()) in_.end(rest_.data() + at_);
        in_.require(shapes_read_ == stores_.shapes.size(), "a shape is of no body");
        in_.require(edges_of_contacts_ == 2 * stores_.contacts.slots.size(),
                    "a contact is not between two bodies");
        in_.require(edges_of_joints_ == 2 * stores_.joints.slots.size(), "a joint is not between two bodies");
    }

  private:
    void fail(const char* what) {
        if (in_.ok()) in_.end(rest_.data() + at_);
        in_.fail(what);
        at_ = rest_.size();
    }

    // Calls take(item), which tells whether the item may stand there, for each item of a list.
    template <class Take>
    [[gnu::always_inline]] void for_each_listed(const char* fault, const Take& take) {
        const std::byte* const bytes = rest_.data();
        const std::size_t end = rest_.size();
        for (std::size_t at = at_; at + sizeof(std::uint32_t) <= end;) {
            std::uint32_t word = 0;
            std::memcpy(&word, bytes + at, sizeof word);
            at += sizeof word;
            const bool fits = take(static_cast<int>(word & ~kLastBit));
            if (fits && (word & kLastBit) == 0) continue;
            at_ = at;
            if (!fits) fail(fault);
            return;
        }
        fail("it ends in the middle of a list");
    }

    // Null for one that may not stand there.
    ShapeRecord* take_shape(int body, int shape, bool sensor) {
        ShapeRecord* const record = shapes_.find(shape);
        if (record == nullptr || record->body != kNone || record->def().sensor != sensor) return nullptr;
        record->body = body;
        ++shapes_read_;
        return record;
    }

    void take_next_shape(int body, BodyRecord& record) {
        if (take_shape(body, next_shape_, false) == nullptr) return fail(kWrongShape);
        record.first_shape = record.last_shape = next_shape_++;
    }

    void read_shapes(int body, BodyRecord& record) {
        if (record.first_shape != kNone) return fail("a body has shapes in two ways");
        int* link = &record.first_shape;
        int previous = kNone;
        for_each_listed(kWrongShape, [&](int shape) {
            ShapeRecord* const taken = take_shape(body, shape, false);
            if (taken == nullptr) return false;
            taken->previous_of_body = previous;
            *link = shape;
            link = &taken->next_of_body;
            previous = shape;
            return true;
        });
        record.last_shape = previous;
        next_shape_ = previous + 1;
    }

    void read_sensors(int body, BodyRecord& record) {
        int* link = &record.first_sensor;
        for_each_listed(kWrongShape, [&](int shape) {
            ShapeRecord* const taken = take_shape(body, shape, true);
            if (taken == nullptr) return false;
            *link = shape;
            link = &taken->next_of_body;
            return true;
        });
    }

    template <class Records>
    [[gnu::always_inline]] void read_edges(const Records& records, int body, int& first, int& count,
                                           const char* fault) {
        int* link = &first;
        int previous = kNone;
        int read = 0;
        for_each_listed(fault, [&](int key) {
            const int side = edge_side(key);
            auto* const record = records.find(edge_record(key));
            if (record == nullptr) return false;
            int& end = side == 0 ? record->body_a : record->body_b;
            if (end != kNone || (side == 0 ? record->body_b : record->body_a) == body) return false;
            end = body;
            record->edges[side] = {previous, kNone};
            *link = key;
            link = &record->edges[side].next;
            previous = key;
            ++read;
            return true;
        });
        count += read;
    }

    Reader& in_;
    Stores& stores_;
    Lookup<ShapeStore> shapes_;
    Lookup<decltype(ContactStore::slots)> contacts_;
    Lookup<decltype(JointStore::slots)> joints_;
    std::span<const std::byte> rest_;
    std::size_t at_ = 0;  // of rest_
    int next_shape_ = 0;
    int shapes_read_ = 0;
    int edges_of_contacts_ = 0;
    int edges_of_joints_ = 0;
};

}  // namespace

void save_links(const Stores& stores, Writer& out) {
    const auto count = [](const auto& slots) { return static_cast<std::size_t>(slots.size()); };
    std::byte* at =
        out.room(count(stores.bodies.slots) +
                 sizeof(std::uint32_t) * (count(stores.shapes) + 2 * count(stores.contacts.slots) +
                                          2 * count(stores.joints.slots)));
    const auto next_shape = [&](int shape) { return stores.shapes[shape].next_of_body; };
    const auto next_contact = along_edges(stores.contacts.slots);
    const auto next_joint = along_edges(stores.joints.slots);
    int after_last_shape = 0;
    for_each_alive(stores.bodies.slots, [&](int, const BodyRecord& body) {
        const bool has_shapes = body.first_shape != kNone;
        const bool is_next = body.first_shape == after_last_shape && body.last_shape == after_last_shape;
        if (has_shapes) after_last_shape = body.last_shape + 1;
        at = put(at, static_cast<std::uint8_t>((is_next ? kHasNextShape : 0) |
                                               (has_shapes && !is_next ? kHasShapes : 0) |
                                               (body.first_sensor != kNone ? kHasSensors : 0) |
                                               (body.first_contact != kNone ? kHasContacts : 0) |
                                               (body.first_joint != kNone ? kHasJoints : 0)));
        if (!is_next) at = put_list(at, body.first_shape, next_shape);
        at = put_list(at, body.first_sensor, next_shape);
        at = put_list(at, body.first_contact, next_contact);
        at = put_list(at, body.first_joint, next_joint);
    });
    out.end(at);
}

void load_links(Reader& in, Stores& stores) {
    in.begin("links of bodies");
    Linking linking(in, stores);
    for_each_alive(stores.bodies.slots, [&](int body, BodyRecord& record) {
        if (in.ok()) linking.link(body, record);
    });
    if (in.ok()) linking.finish();
    if (!in.ok()) return;
    for_each_alive(stores.chains, [&](int, const ChainRecord& chain) {
        for (const int shape : chain.segments)
            in.require(stores.shapes[shape].body == chain.body, "a chain has a segment on another body");
    });
}

}  // namespace cairn::physics
