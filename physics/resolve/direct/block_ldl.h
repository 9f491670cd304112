// Sparse symmetric systems of small blocks, factored as L D L^T without exchanging rows.
//
// Made for the systems of joints, [ M  J^T ; J  -E ] with M of bodies and E >= 0 of joints: quasi-definite,
// so any order works; an order in which a joint comes after one of its bodies keeps pivots of ordinary size,
// whatever E. Nodes are eliminated by least degree, so a tree has no fill, and a chain is block-tridiagonal;
// among equals by a low elimination tree.
// A column is factored from its own values and from what columns before it left for it, so those below which
// nothing changed are kept: states of contacts that change over, and structures that stand still, cost
// little. Invariant: values and unknowns stand in the order of elimination, so that all passes stream through
// them (ldl_numbers.h). Sources: Vanderbei, "Symmetric Quasidefinite Matrices" (1995); George and Liu, "The
// Evolution of the Minimum Degree Ordering Algorithm" (1989); Baraff, "Linear-Time Dynamics using Lagrange
// Multipliers" (1996).
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "resolve/direct/ldl_numbers.h"

namespace cairn::physics {

class BlockLdl {
  public:
    struct Node {
        int size = 0;       // unknowns, 1 to kMaxBlock
        bool late = false;  // comes after one of its neighbours
        bool operator==(const Node&) const = default;
    };
    struct Edge {
        int a = 0;  // nodes
        int b = 0;
        bool operator==(const Edge&) const = default;
    };

    /// Finds the order and the places of all blocks. Edges join different nodes, each pair at most once.
    /// Does nothing when nodes and edges are those of the last call.
    void analyze(std::span<const Node> nodes, std::span<const Edge> edges);

    /// Products of blocks that one factorization takes: what it costs.
    [[nodiscard]] std::int64_t products() const { return products_; }
    /// Places for unknowns in all.
    [[nodiscard]] int size() const { return size_; }
    /// Where the unknowns of a node begin; it has places for whole strips of them.
    [[nodiscard]] int offset(int node) const { return offsets_[static_cast<std::size_t>(node)]; }

    /// The values that factor() starts from: the block of a node, of which the lower triangle counts, and the
    /// block of an edge, with the rows of its node b and the columns of its node a. All are 0 after the order
    /// was found, and stay until they are set anew.
    struct Strides {
        int one = 0;    // to the next row or column
        int strip = 0;  // more than that, where that is in the next strip
        [[nodiscard]] int to(int i) const { return i * one + i / kStripRows * strip; }
    };
    struct BlockValues {
        double* values;
        std::uint8_t* changed;  // of the column
        Strides rows;
        Strides columns;
        void set(int row, int column, double value) const {
            double& place = values[rows.to(row) + columns.to(column)];
            // By bits: what is kept must be what would come out of it anew.
            const bool differs = std::bit_cast<std::uint64_t>(place) != std::bit_cast<std::uint64_t>(value);
            *changed = static_cast<std::uint8_t>(*changed | static_cast<std::uint8_t>(differs));
            place = value;
        }
    };
    [[nodiscard]] BlockValues diagonal(int node) { return block(of_nodes_[static_cast<std::size_t>(node)]); }
    [[nodiscard]] BlockValues edge(int edge) { return block(of_edges_[static_cast<std::size_t>(edge)]); }

    /// Anew only the columns of which values were set to others since the last time, and those above them in
    /// the elimination tree: the rest is as it was, to the bit.
    void factor() { physics::factor(numbers_); }
    /// Solves in place for a right-hand side in the order of offset().
    void solve(std::span<double> x) const { physics::solve(numbers_, x.data()); }

  private:
    struct Place {
        int column = 0;
        int at = 0;  // in the source
        Strides rows;
        Strides columns;
    };

    struct Waiting {
        int degree = 0;
        int level = 0;
        int node = 0;
        auto operator<=>(const Waiting&) const = default;
    };

    [[nodiscard]] BlockValues block(const Place& place) {
        return {numbers_.source.data() + place.at, numbers_.changed.data() + place.column, place.rows,
                place.columns};
    }
    void eliminate();
    [[nodiscard]] static Place place(int column, int at, int columns, bool as_stored);
    [[nodiscard]] int find_block(int row, int column) const;
    void list_updates();

    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<int> offsets_;  // by node
    LdlNumbers numbers_;
    std::vector<Place> of_nodes_;
    std::vector<Place> of_edges_;
    int size_ = 0;
    std::int64_t products_ = 0;
    // While analyzing.
    std::vector<std::vector<int>> neighbours_;  // by node, sorted
    std::vector<int> order_;
    std::vector<int> rank_;   // by node
    std::vector<int> level_;  // by node: the longest way to it in the elimination tree
    std::vector<Waiting> waiting_;
};

}  // namespace cairn::physics
