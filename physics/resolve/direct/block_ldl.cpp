// Order and places of a sparse L D L^T. Glossary: a column is a node when it is eliminated; its blocks are
// what joins it to later nodes.
#include "resolve/direct/block_ldl.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace cairn::physics {
namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

void add_sorted(std::vector<int>& list, int item) {
    const auto at = std::lower_bound(list.begin(), list.end(), item);
    if (at == list.end() || *at != item) list.insert(at, item);
}

void remove_sorted(std::vector<int>& list, int item) {
    const auto at = std::lower_bound(list.begin(), list.end(), item);
    if (at != list.end() && *at == item) list.erase(at);
}

}  // namespace

void BlockLdl::analyze(std::span<const Node> nodes, std::span<const Edge> edges) {
    if (std::equal(nodes.begin(), nodes.end(), nodes_.begin(), nodes_.end()) &&
        std::equal(edges.begin(), edges.end(), edges_.begin(), edges_.end())) {
        return;
    }
    nodes_.assign(nodes.begin(), nodes.end());
    edges_.assign(edges.begin(), edges.end());
    if (neighbours_.size() < nodes_.size()) neighbours_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) neighbours_[i].clear();
    for (const Edge& edge : edges) {
        add_sorted(neighbours_[index(edge.a)], edge.b);
        add_sorted(neighbours_[index(edge.b)], edge.a);
    }
    eliminate();
    const auto size_of = [&](int node) { return nodes_[index(node)].size; };
    offsets_.assign(nodes_.size(), 0);
    of_nodes_.assign(nodes_.size(), {});
    of_edges_.clear();
    numbers_.columns.clear();
    numbers_.strips.clear();
    size_ = 0;
    for (const int node : order_) {
        offsets_[index(node)] = size_;
        size_ += in_strips(size_of(node));
    }
    // Blocks of each column in the order of their rows' elimination.
    int values = 0;
    for (const int node : order_) {
        std::vector<int>& later = neighbours_[index(node)];
        std::sort(later.begin(), later.end(),
                  [&](int a, int b) { return rank_[index(a)] < rank_[index(b)]; });
        LdlNumbers::Column column;
        column.size = size_of(node);
        column.offset = offset(node);
        column.diagonal = values;
        of_nodes_[index(node)] = place(rank_[index(node)], values, column.size, true);
        values += in_strips(column.size) * column.size;
        column.below = values;
        column.first_strip = static_cast<int>(numbers_.strips.size());
        for (const int row : later) {
            for (int i = 0; i < size_of(row); i += kStripRows) {
                numbers_.strips.push_back({values, offset(row) + i});
                values += kStripRows * column.size;
            }
        }
        column.last_strip = static_cast<int>(numbers_.strips.size());
        column.end = values;
        if (!later.empty()) column.parent = rank_[index(later.front())];
        numbers_.columns.push_back(column);
    }
    for (const Edge& edge : edges) {
        const bool a_is_first = offset(edge.a) < offset(edge.b);
        const int row = a_is_first ? edge.b : edge.a;
        const int column = a_is_first ? edge.a : edge.b;
        of_edges_.push_back(
            place(rank_[index(column)], find_block(row, column), size_of(column), a_is_first));
    }
    list_updates();
    numbers_.resize(values);
}

BlockLdl::Place BlockLdl::place(int column, int at, int columns, bool as_stored) {
    const Strides along_rows{1, kStripRows * (columns - 1)};
    const Strides along_columns{kStripRows, 0};
    return {column, at, as_stored ? along_rows : along_columns, as_stored ? along_columns : along_rows};
}

// Where its strips begin.
int BlockLdl::find_block(int row, int column) const {
    const LdlNumbers::Column& c = numbers_.columns[index(rank_[index(column)])];
    const auto first = numbers_.strips.begin() + c.first_strip;
    const auto found =
        std::lower_bound(first, numbers_.strips.begin() + c.last_strip, offset(row),
                         [](const LdlNumbers::Strip& strip, int offset) { return strip.offset < offset; });
    return found->at;
}

// For each column, what is subtracted from it.
void BlockLdl::list_updates() {
    // Counted, then filled in: last_update is where the next one goes.
    const auto strips_of = [&](int node) { return in_strips(nodes_[index(node)].size) / kStripRows; };
    products_ = 0;
    for (const int node : order_) {
        int strips = 0;
        for (auto i = neighbours_[index(node)].rbegin(); i != neighbours_[index(node)].rend(); ++i) {
            strips += strips_of(*i);
            numbers_.columns[index(rank_[index(*i)])].last_update += strips;
        }
        const auto blocks = static_cast<std::int64_t>(neighbours_[index(node)].size());
        products_ += blocks * (blocks + 1) / 2;
    }
    int updates = 0;
    for (LdlNumbers::Column& column : numbers_.columns) {
        column.first_update = updates;
        updates += std::exchange(column.last_update, updates);
    }
    numbers_.updates.resize(index(updates));
    for (const int node : order_) {
        const LdlNumbers::Column& from = numbers_.columns[index(rank_[index(node)])];
        const std::vector<int>& later = neighbours_[index(node)];
        int strip = from.first_strip;
        for (auto j = later.begin(); j != later.end(); strip += strips_of(*j), ++j) {
            LdlNumbers::Column& to = numbers_.columns[index(rank_[index(*j)])];
            const int right = numbers_.strips[index(strip)].at;
            int left = strip;
            for (auto i = j; i != later.end(); ++i) {
                int target = i == j ? to.diagonal : find_block(*i, *j);
                for (int part = 0; part < strips_of(*i); ++part, ++left, target += kStripRows * to.size) {
                    numbers_.updates[index(to.last_update++)] = {numbers_.strips[index(left)].at, right,
                                                                 target, from.size};
                }
            }
        }
    }
}

// By least degree, what may be eliminated; of equals the lowest in the elimination tree, so that branches
// grow together and the ways to the root are short; and then by number. Leaves the order, and of each node
// the neighbours that are eliminated after it.
void BlockLdl::eliminate() {
    const auto degree = [&](int i) { return static_cast<int>(neighbours_[index(i)].size()); };
    order_.clear();
    waiting_.clear();
    level_.assign(nodes_.size(), 0);
    const auto wait = [&](int node) {
        waiting_.push_back({degree(node), level_[index(node)], node});
        std::push_heap(waiting_.begin(), waiting_.end(), std::greater<>());
    };
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
        if (!nodes_[index(i)].late || neighbours_[index(i)].empty()) wait(i);
    }
    rank_.assign(nodes_.size(), -1);
    while (!waiting_.empty()) {
        std::pop_heap(waiting_.begin(), waiting_.end(), std::greater<>());
        const Waiting next = waiting_.back();
        waiting_.pop_back();
        const int node = next.node;
        // Degrees and levels change while nodes wait: then they wait again, with the new ones.
        if (rank_[index(node)] >= 0 || next.degree != degree(node) || next.level != level_[index(node)])
            continue;
        rank_[index(node)] = static_cast<int>(order_.size());
        order_.push_back(node);
        const std::vector<int>& around = neighbours_[index(node)];
        for (const int i : around) {
            std::vector<int>& list = neighbours_[index(i)];
            remove_sorted(list, node);
            level_[index(i)] = std::max(level_[index(i)], next.level + 1);
            for (const int j : around) {
                if (j != i) add_sorted(list, j);
            }
        }
        for (const int i : around) wait(i);
    }
}

}  // namespace cairn::physics
