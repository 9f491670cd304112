// The contacts (or joints) of one body, as a doubly linked list through the records themselves.
// Invariant: the key of an edge is 2 * record + side; side 0 belongs to body a, side 1 to body b.
#pragma once

#include <array>

#include "base/slot_map.h"

namespace cairn::physics {

struct Edge {
    int previous = kNone;
    int next = kNone;
};

/// Both ends of a record, in the lists of its two bodies.
using Edges = std::array<Edge, 2>;

inline int edge_record(int key) {
    return key / 2;
}
inline int edge_side(int key) {
    return key & 1;
}

template <class Records>
void link_edge(Records& records, int& head, int record, int side) {
    Edge& edge = records[record].edges[side];
    edge = {kNone, head};
    const int key = 2 * record + side;
    if (head != kNone) records[edge_record(head)].edges[edge_side(head)].previous = key;
    head = key;
}

template <class Records>
void unlink_edge(Records& records, int& head, int record, int side) {
    const Edge edge = records[record].edges[side];
    if (edge.previous == kNone) {
        head = edge.next;
    } else {
        records[edge_record(edge.previous)].edges[edge_side(edge.previous)].next = edge.next;
    }
    if (edge.next != kNone)
        records[edge_record(edge.next)].edges[edge_side(edge.next)].previous = edge.previous;
}

/// Calls visit(record, side) for each; visit may unlink the one it is given.
template <class Records, class Visit>
void for_each_edge(const Records& records, int head, Visit&& visit) {
    for (int key = head; key != kNone;) {
        const int next = records[edge_record(key)].edges[edge_side(key)].next;
        visit(edge_record(key), edge_side(key));
        key = next;
    }
}

}  // namespace cairn::physics
