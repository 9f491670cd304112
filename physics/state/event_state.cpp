// Events as bytes. Those of the last step can still be read after a restore; those that wait will be told
// with the next step.
#include "state/sections.h"

namespace cairn::physics {
namespace {

struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

// Pieces are part of a list of all.
void save_pieces(const Events& events, const BodyBreak& event, Writer& out) {
    const bool any = !event.pieces.empty();
    out.value(static_cast<std::uint32_t>(any ? event.pieces.data() - events.broken_pieces.data() : 0));
    out.value(static_cast<std::uint32_t>(event.pieces.size()));
}

void load_pieces(Reader& in, const Events& events, BodyBreak& event) {
    Range range;
    in.value(range.first);
    in.value(range.count);
    const std::size_t all = events.broken_pieces.size();
    if (!in.require(range.first <= all && range.count <= all - range.first,
                    "a body broke into pieces that there are not"))
        return;
    event.pieces = std::span(events.broken_pieces).subspan(range.first, range.count);
}

}  // namespace

void save_events(const Events& events, Writer& out) {
    const auto& [begins, ends, hits, joint_breaks, sensor_begins, sensor_ends, breaks, overloads,
                 broken_pieces, quarantined, pending_ends, pending_sensor_ends] = events;
    out.list(begins);
    out.list(ends);
    out.list(hits);
    out.list(joint_breaks);
    out.list(sensor_begins);
    out.list(sensor_ends);
    out.list(broken_pieces);
    out.list(breaks);
    for (const BodyBreak& event : breaks) save_pieces(events, event, out);
    out.list(overloads);
    for (const Overload& overload : overloads) save_pieces(events, overload.event, out);
    out.list(quarantined);
    out.list(pending_ends);
    out.list(pending_sensor_ends);
}

void load_events(Reader& in, Events& events) {
    in.begin("events");
    auto& [begins, ends, hits, joint_breaks, sensor_begins, sensor_ends, breaks, overloads, broken_pieces,
           quarantined, pending_ends, pending_sensor_ends] = events;
    in.list(begins);
    in.list(ends);
    in.list(hits);
    in.list(joint_breaks);
    in.list(sensor_begins);
    in.list(sensor_ends);
    in.list(broken_pieces);
    in.list(breaks);
    for (BodyBreak& event : breaks) load_pieces(in, events, event);
    in.list(overloads);
    for (Overload& overload : overloads) load_pieces(in, events, overload.event);
    in.list(quarantined);
    in.list(pending_ends);
    in.list(pending_sensor_ends);
    in.settle();
}

}  // namespace cairn::physics
