// Order, places and numbers of a sparse L D L^T. Glossary: a column is a node when it is eliminated; its
// blocks are what joins it to later nodes.
#include "resolve/direct/block_ldl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

#include "resolve/direct/numbers.h"

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

// Calls work(size) with the size as a constant.
template <class Work>
void with_size(int size, const Work& work) {
    switch (size) {
        case 1:
            return work(std::integral_constant<int, 1>{});
        case 2:
            return work(std::integral_constant<int, 2>{});
        case 3:
            return work(std::integral_constant<int, 3>{});
        case 4:
            return work(std::integral_constant<int, 4>{});
        case 5:
            return work(std::integral_constant<int, 5>{});
        case 6:
            return work(std::integral_constant<int, 6>{});
        case 7:
            return work(std::integral_constant<int, 7>{});
        default:
            return work(std::integral_constant<int, 8>{});
    }
}

// The pivots of a block on the diagonal: in place, L below, 1/D on the diagonal.
template <int N>
void factor_dense(double* a) {
    std::array<double, N> scaled{};  // L D of the row in work
    for (int i = 0; i < N; ++i) {
        double pivot = a[i * N + i];
        for (int j = 0; j < i; ++j) {
            double sum = a[i * N + j];
            for (int k = 0; k < j; ++k) sum -= scaled[index(k)] * a[j * N + k];
            scaled[index(j)] = sum;
            a[i * N + j] = sum * a[j * N + j];
            pivot -= a[i * N + j] * sum;
        }
        a[i * N + i] = 1 / pivot;
    }
}

// b := A^-1 b.
template <int N>
void solve_dense(const double* a, double* b) {
    for (int i = 1; i < N; ++i) {
        for (int j = 0; j < i; ++j) b[i] -= a[i * N + j] * b[j];
    }
    for (int i = 0; i < N; ++i) b[i] *= a[i * N + i];
    for (int i = N - 2; i >= 0; --i) {
        for (int j = i + 1; j < N; ++j) b[i] -= a[j * N + i] * b[j];
    }
}

// c -= a b^T, with a of m x inner and b of N x inner, all row by row.
template <int N, class Rows, class Inner>
void subtract(double* c, const double* a, const double* b, Rows m, Inner inner) {
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < N; ++j) {
            double sum = 0;
            for (int k = 0; k < inner; ++k) sum += a[i * inner + k] * b[j * inner + k];
            c[i * N + j] -= sum;
        }
    }
}

// The same for a block on the diagonal, of which the lower triangle counts.
template <int N, class Inner>
void subtract_lower(double* c, const double* a, const double* b, Inner inner) {
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = 0; k < inner; ++k) sum += a[i * inner + k] * b[j * inner + k];
            c[i * N + j] -= sum;
        }
    }
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
    columns_.clear();
    blocks_.clear();
    size_ = 0;
    for (const int node : order_) {
        offsets_[index(node)] = size_;
        size_ += size_of(node);
    }
    // Blocks of each column in the order of their rows' elimination.
    int values = 0;
    for (const int node : order_) {
        std::vector<int>& later = neighbours_[index(node)];
        std::sort(later.begin(), later.end(),
                  [&](int a, int b) { return rank_[index(a)] < rank_[index(b)]; });
        Column column;
        column.size = size_of(node);
        column.offset = offset(node);
        column.diagonal = values;
        of_nodes_[index(node)] = {rank_[index(node)], values, column.size, 1};
        values += column.size * column.size;
        column.first_block = static_cast<int>(blocks_.size());
        for (const int row : later) {
            blocks_.push_back({values, size_of(row), offset(row)});
            values += size_of(row) * column.size;
        }
        column.last_block = static_cast<int>(blocks_.size());
        column.end = values;
        if (!later.empty()) column.parent = rank_[index(later.front())];
        columns_.push_back(column);
    }
    for (const Edge& edge : edges) {
        const bool a_is_first = offset(edge.a) < offset(edge.b);
        const int row = a_is_first ? edge.b : edge.a;
        const int column = a_is_first ? edge.a : edge.b;
        const int stride = size_of(column);
        of_edges_.push_back({rank_[index(column)], find_block(row, column).at, a_is_first ? stride : 1,
                             a_is_first ? 1 : stride});
    }
    list_updates();
    source_.assign(index(values), 0);
    values_.assign(index(values), 0);
    scaled_.assign(index(values), 0);
    changed_.assign(columns_.size(), 1);
}

const BlockLdl::Block& BlockLdl::find_block(int row, int column) const {
    const Column& c = columns_[index(rank_[index(column)])];
    const auto first = blocks_.begin() + c.first_block;
    return *std::lower_bound(first, blocks_.begin() + c.last_block, offset(row),
                             [](const Block& block, int offset) { return block.offset < offset; });
}

// For each column, what is subtracted from it.
void BlockLdl::list_updates() {
    // Counted, then filled in: last_update is where the next one goes.
    for (const int node : order_) {
        const std::vector<int>& later = neighbours_[index(node)];
        for (std::size_t i = 0; i < later.size(); ++i)
            columns_[index(rank_[index(later[i])])].last_update += static_cast<int>(later.size() - i);
    }
    int updates = 0;
    for (Column& column : columns_) {
        column.first_update = updates;
        updates += std::exchange(column.last_update, updates);
    }
    updates_.resize(index(updates));
    for (const int node : order_) {
        const Column& from = columns_[index(rank_[index(node)])];
        const std::vector<int>& later = neighbours_[index(node)];
        for (std::size_t j = 0; j < later.size(); ++j) {
            Column& to = columns_[index(rank_[index(later[j])])];
            const int right = blocks_[index(from.first_block) + j].at;
            for (std::size_t i = j; i < later.size(); ++i) {
                const Block& left = blocks_[index(from.first_block) + i];
                const int target = i == j ? to.diagonal : find_block(later[i], later[j]).at;
                updates_[index(to.last_update++)] = {left.at, right, target,
                                                     static_cast<std::int16_t>(left.rows),
                                                     static_cast<std::int16_t>(from.size)};
            }
        }
    }
}

// By least degree, ties by number, what may be eliminated. Leaves the order, and of each node the neighbours
// that are eliminated after it.
void BlockLdl::eliminate() {
    const auto degree = [&](int i) { return static_cast<int>(neighbours_[index(i)].size()); };
    order_.clear();
    waiting_.clear();
    const auto wait = [&](int node) {
        waiting_.push_back({degree(node), node});
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
        // Degrees change while nodes wait: then they wait again, with the new one.
        if (rank_[index(node)] >= 0 || next.degree != degree(node)) continue;
        rank_[index(node)] = static_cast<int>(order_.size());
        order_.push_back(node);
        const std::vector<int>& around = neighbours_[index(node)];
        for (const int i : around) {
            std::vector<int>& list = neighbours_[index(i)];
            remove_sorted(list, node);
            for (const int j : around) {
                if (j != i) add_sorted(list, j);
            }
        }
        for (const int i : around) wait(i);
    }
}

template <int N>
void BlockLdl::factor_column(const Column& column) {
    std::copy(source_.begin() + column.diagonal, source_.begin() + column.end,
              values_.begin() + column.diagonal);
    for (int u = column.first_update; u < column.last_update; ++u) {
        const Update& update = updates_[index(u)];
        double* target = values_.data() + update.target;
        const double* a = values_.data() + update.left;
        const double* b = scaled_.data() + update.right;
        with_count(update.inner, [=](auto inner) {
            if (update.left == update.right) return subtract_lower<N>(target, a, b, inner);
            with_count(update.rows, [=](auto rows) { subtract<N>(target, a, b, rows, inner); });
        });
    }
    double* diagonal = values_.data() + column.diagonal;
    factor_dense<N>(diagonal);
    for (int b = column.first_block; b < column.last_block; ++b) {
        const Block& block = blocks_[index(b)];
        double* values = values_.data() + block.at;
        double* scaled = scaled_.data() + block.at;
        with_count(block.rows, [=](auto rows) {
            for (int i = 0; i < rows * N; ++i) scaled[i] = values[i];
            for (int row = 0; row < rows; ++row) solve_dense<N>(diagonal, values + row * N);
        });
    }
}

template <int N>
void BlockLdl::forward(const Column& column, double* x) const {
    const double* from = x + column.offset;
    for (int b = column.first_block; b < column.last_block; ++b) {
        const Block& block = blocks_[index(b)];
        const double* values = values_.data() + block.at;
        double* to = x + block.offset;
        with_count(block.rows, [=](auto rows) {
            for (int i = 0; i < rows; ++i) {
                double sum = 0;
                for (int j = 0; j < N; ++j) sum += values[i * N + j] * from[j];
                to[i] -= sum;
            }
        });
    }
}

template <int N>
void BlockLdl::backward(const Column& column, double* x) const {
    double* to = x + column.offset;
    solve_dense<N>(values_.data() + column.diagonal, to);
    for (int b = column.first_block; b < column.last_block; ++b) {
        const Block& block = blocks_[index(b)];
        const double* values = values_.data() + block.at;
        const double* from = x + block.offset;
        with_count(block.rows, [=](auto rows) {
            for (int i = 0; i < rows; ++i) {
                for (int j = 0; j < N; ++j) to[j] -= values[i * N + j] * from[i];
            }
        });
    }
}

void BlockLdl::factor() {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (changed_[c] == 0) continue;
        changed_[c] = 0;
        const Column& column = columns_[c];
        with_size(column.size, [&](auto size) { factor_column<size>(column); });
        if (column.parent >= 0) changed_[index(column.parent)] = 1;
    }
}

void BlockLdl::solve(std::span<double> x) const {
    for (const Column& column : columns_) {
        with_size(column.size, [&](auto size) { forward<size>(column, x.data()); });
    }
    for (std::size_t c = columns_.size(); c-- > 0;) {
        with_size(columns_[c].size, [&](auto size) { backward<size>(columns_[c], x.data()); });
    }
}

}  // namespace cairn::physics
