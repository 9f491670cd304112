// Order, places and numbers of a sparse L D L^T. Glossary: a column is a node when it is eliminated; its
// blocks are what joins it to later nodes.
#include "resolve/direct/block_ldl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>

#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

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
            for (int k = 0; k < j; ++k) sum -= scaled[static_cast<std::size_t>(k)] * a[j * N + k];
            scaled[static_cast<std::size_t>(j)] = sum;
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

// c -= a b^T, with a of m x N and b of n x N, all row by row.
template <int N, class M, class Rows>
void subtract(double* c, const double* a, const double* b, M m, Rows n) {
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j) {
            double sum = 0;
            for (int k = 0; k < N; ++k) sum += a[i * N + k] * b[j * N + k];
            c[i * n + j] -= sum;
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
        add_sorted(neighbours_[static_cast<std::size_t>(edge.a)], edge.b);
        add_sorted(neighbours_[static_cast<std::size_t>(edge.b)], edge.a);
    }
    eliminate();
    const std::vector<int>& order = order_;
    std::vector<int>& rank = rank_;
    rank.resize(nodes_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    const auto size_of = [&](int node) { return nodes_[static_cast<std::size_t>(node)].size; };
    offsets_.assign(nodes_.size(), 0);
    diagonals_.assign(nodes_.size(), 0);
    columns_.clear();
    blocks_.clear();
    updates_.clear();
    places_.clear();
    size_ = 0;
    for (const int node : order) {
        offsets_[static_cast<std::size_t>(node)] = size_;
        size_ += size_of(node);
    }
    // Blocks of each column in the order of their rows' elimination.
    int values = 0;
    for (const int node : order) {
        std::vector<int>& later = neighbours_[static_cast<std::size_t>(node)];
        std::sort(later.begin(), later.end(), [&](int a, int b) {
            return rank[static_cast<std::size_t>(a)] < rank[static_cast<std::size_t>(b)];
        });
        Column column;
        column.size = size_of(node);
        column.offset = offset(node);
        column.diagonal = diagonals_[static_cast<std::size_t>(node)] = values;
        values += column.size * column.size;
        column.first_block = static_cast<int>(blocks_.size());
        for (const int row : later) {
            blocks_.push_back({values, size_of(row), offset(row)});
            values += size_of(row) * column.size;
        }
        column.last_block = static_cast<int>(blocks_.size());
        columns_.push_back(column);
    }
    const auto find_block = [&](int row, int column) -> const Block& {
        const Column& c = columns_[static_cast<std::size_t>(rank[static_cast<std::size_t>(column)])];
        const auto first = blocks_.begin() + c.first_block;
        return *std::lower_bound(first, blocks_.begin() + c.last_block, offset(row),
                                 [](const Block& block, int offset) { return block.offset < offset; });
    };
    for (std::size_t c = 0; c < order.size(); ++c) {
        columns_[c].first_update = static_cast<int>(updates_.size());
        const std::vector<int>& later = neighbours_[static_cast<std::size_t>(order[c])];
        for (std::size_t i = 0; i < later.size(); ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                const int target = i == j ? diagonals_[static_cast<std::size_t>(later[i])]
                                          : find_block(later[i], later[j]).at;
                updates_.push_back({columns_[c].first_block + static_cast<int>(i),
                                    columns_[c].first_block + static_cast<int>(j), target});
            }
        }
        columns_[c].last_update = static_cast<int>(updates_.size());
    }
    for (const Edge& edge : edges) {
        if (offset(edge.b) > offset(edge.a)) {
            places_.push_back({find_block(edge.b, edge.a).at, size_of(edge.a), 1});
        } else {
            places_.push_back({find_block(edge.a, edge.b).at, 1, size_of(edge.b)});
        }
    }
    values_.assign(static_cast<std::size_t>(values), 0);
    scaled_.assign(static_cast<std::size_t>(values), 0);
}

// By least degree, ties by number, what may be eliminated. Leaves the order, and of each node the neighbours
// that are eliminated after it.
void BlockLdl::eliminate() {
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
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

void BlockLdl::clear() {
    std::fill(values_.begin(), values_.end(), 0.0);
}

template <int N>
void BlockLdl::factor_column(const Column& column) {
    double* diagonal = values_.data() + column.diagonal;
    factor_dense<N>(diagonal);
    for (int b = column.first_block; b < column.last_block; ++b) {
        const Block& block = blocks_[static_cast<std::size_t>(b)];
        double* values = values_.data() + block.at;
        double* scaled = scaled_.data() + block.at;
        with_count(block.rows, [=](auto rows) {
            for (int i = 0; i < rows * N; ++i) scaled[i] = values[i];
            for (int row = 0; row < rows; ++row) solve_dense<N>(diagonal, values + row * N);
        });
    }
    for (int u = column.first_update; u < column.last_update; ++u) {
        const Update& update = updates_[static_cast<std::size_t>(u)];
        const Block& left = blocks_[static_cast<std::size_t>(update.left)];
        const Block& right = blocks_[static_cast<std::size_t>(update.right)];
        double* target = values_.data() + update.target;
        const double* a = values_.data() + left.at;
        const double* b = scaled_.data() + right.at;
        with_count(left.rows,
                   [=](auto m) { with_count(right.rows, [=](auto n) { subtract<N>(target, a, b, m, n); }); });
    }
}

template <int N>
void BlockLdl::forward(const Column& column, double* x) const {
    const double* from = x + column.offset;
    for (int b = column.first_block; b < column.last_block; ++b) {
        const Block& block = blocks_[static_cast<std::size_t>(b)];
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
        const Block& block = blocks_[static_cast<std::size_t>(b)];
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
    for (const Column& column : columns_) {
        with_size(column.size, [&](auto size) { factor_column<size>(column); });
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
