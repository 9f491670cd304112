// Sparse symmetric systems of small blocks, factored as L D L^T without exchanging rows.
//
// Made for the systems of joints, [ M  J^T ; J  -E ] with M of bodies and E >= 0 of joints: quasi-definite,
// so any order works; an order in which a joint comes after one of its bodies keeps pivots of ordinary size,
// whatever E. Nodes are eliminated by least degree, so a tree has no fill, and a chain is block-tridiagonal.
// A column is factored from its own values and from what columns before it left for it, so those below which
// nothing changed are kept: states of contacts that change over, and structures that stand still, cost
// little. Invariant: values and unknowns stand in the order of elimination, so that all passes stream through
// them. Sources: Vanderbei, "Symmetric Quasidefinite Matrices" (1995); George and Liu, "The Evolution of the
// Minimum Degree Ordering Algorithm" (1989); Baraff, "Linear-Time Dynamics using Lagrange Multipliers"
// (1996).
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn::physics {

/// The most unknowns that a node may have.
inline constexpr int kMaxBlock = 8;

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
    [[nodiscard]] std::int64_t products() const { return static_cast<std::int64_t>(updates_.size()); }
    /// Unknowns in all.
    [[nodiscard]] int size() const { return size_; }
    /// Where the unknowns of a node begin.
    [[nodiscard]] int offset(int node) const { return offsets_[static_cast<std::size_t>(node)]; }

    /// The values that factor() starts from: the block of a node, of which the lower triangle counts, and the
    /// block of an edge, with the rows of its node b and the columns of its node a. All are 0 after the order
    /// was found, and stay until they are set anew.
    struct BlockValues {
        double* values;
        std::uint8_t* changed;  // of the column
        int row_stride;
        int column_stride;
        void set(int row, int column, double value) const {
            double& place = values[row * row_stride + column * column_stride];
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
    void factor();
    /// Solves in place for a right-hand side in the order of offset().
    void solve(std::span<double> x) const;

  private:
    struct Block {       // below the diagonal: rows of a later node, columns of an earlier one
        int at = 0;      // in values_
        int rows = 0;    // how many
        int offset = 0;  // of the rows, among the unknowns
    };
    struct Update {  // values[target] -= L[left] D L[right]^T
        int left = 0;
        int right = 0;   // in scaled_
        int target = 0;  // in values_
        std::int16_t rows = 0;
        std::int16_t inner = 0;  // columns of L
    };
    struct Column {
        int size = 0;
        int diagonal = 0;  // in values_
        int end = 0;       // of the blocks, in values_
        int offset = 0;    // among the unknowns
        int parent = -1;   // the first column that this one is subtracted from
        int first_block = 0, last_block = 0;
        int first_update = 0,
            last_update = 0;  // what is subtracted from this one, in the order of its columns
    };
    struct Place {
        int column = 0;
        int at = 0;  // in source_
        int row_stride = 0;
        int column_stride = 0;
    };

    struct Waiting {
        int degree = 0;
        int node = 0;
        auto operator<=>(const Waiting&) const = default;
    };

    [[nodiscard]] BlockValues block(const Place& place) {
        return {source_.data() + place.at, changed_.data() + place.column, place.row_stride,
                place.column_stride};
    }
    void eliminate();
    [[nodiscard]] const Block& find_block(int row, int column) const;
    void list_updates();
    template <int N>
    void factor_column(const Column& column);
    template <int N>
    void forward(const Column& column, double* x) const;
    template <int N>
    void backward(const Column& column, double* x) const;

    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<int> offsets_;     // by node
    std::vector<Column> columns_;  // in the order of elimination
    std::vector<Block> blocks_;
    std::vector<Update> updates_;
    std::vector<Place> of_nodes_;
    std::vector<Place> of_edges_;
    std::vector<double> source_;         // as they were set
    std::vector<double> values_;         // 1/D and L
    std::vector<double> scaled_;         // D L^T beside L
    std::vector<std::uint8_t> changed_;  // by column
    int size_ = 0;
    // While analyzing.
    std::vector<std::vector<int>> neighbours_;  // by node, sorted
    std::vector<int> order_;
    std::vector<int> rank_;  // by node
    std::vector<Waiting> waiting_;
};

}  // namespace cairn::physics
