// The numbers of a sparse L D L^T (block_ldl.h), and the passes over them, with SIMD.
//
// A column is a node when it is eliminated. Its blocks are what joins it to later nodes. They are cut into
// strips of kStripRows rows, filled up with rows of zeros, and a strip is stored column by column, so that a
// register takes whole columns of it: those of bodies, joints and contacts are a strip each. Invariant: every
// level of SIMD gives the same bits.
#pragma once

#include <cstdint>
#include <vector>

namespace cairn::physics {

/// The most unknowns that a node may have.
inline constexpr int kMaxBlock = 8;
inline constexpr int kStripRows = 4;

/// Rows of the strips that hold so many rows.
constexpr int in_strips(int rows) {
    return (rows + kStripRows - 1) / kStripRows * kStripRows;
}

struct LdlNumbers {
    struct Strip {       // below the diagonal
        int at = 0;      // in values
        int offset = 0;  // of its rows, among the unknowns
    };
    struct Update {      // values[target] -= L[left] D L[right]^T
        int left = 0;    // a strip
        int right = 0;   // in scaled, the first strip
        int target = 0;  // a strip
        int inner = 0;   // columns of L
    };
    struct Column {
        int size = 0;
        int diagonal = 0;  // in values
        int below = 0;     // the strips below the diagonal, in values
        int end = 0;       // of them
        int offset = 0;    // among the unknowns
        int parent = -1;   // the first column that this one is subtracted from
        int first_strip = 0, last_strip = 0;
        int first_update = 0,
            last_update = 0;  // what is subtracted from this one, in the order of its columns
    };

    std::vector<Column> columns;  // in the order of elimination
    std::vector<Strip> strips;
    std::vector<Update> updates;
    std::vector<double> source;         // as they were set
    std::vector<double> values;         // 1/D and L
    std::vector<double> scaled;         // D L^T beside L
    std::vector<std::uint8_t> changed;  // by column

    /// For so many numbers, of which none is set.
    void resize(int count);
};

/// Anew only the columns that changed, and those above them in the elimination tree.
void factor(LdlNumbers& numbers);
/// Solves in place for a right-hand side, in which each node has the places of whole strips;
/// those beyond its unknowns stay as they are.
void solve(const LdlNumbers& numbers, double* x);

}  // namespace cairn::physics
