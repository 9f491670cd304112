// Pieces lie as in a honeycomb: those at the six corner directions of a hexagon of each ring, and between
// them. Each is welded to those that it touches.
#include <cairn/physics/prefabs/blob.h>

#include "prefabs/builder.h"

namespace cairn::physics {
namespace {

struct Piece {
    int column, row;  // along two axes that are 60 degrees apart
    BodyId body{};
};

// Half of the six neighbours: the others have this one as theirs.
constexpr std::array<std::array<int, 2>, 3> kNeighbours = {{{1, 0}, {0, 1}, {-1, 1}}};

/// How many rings a place is away from the middle.
int ring_of(int column, int row) {
    return (std::abs(column) + std::abs(row) + std::abs(column + row)) / 2;
}

}  // namespace

Result<Blob> create_blob(World& world, const BlobDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("blob.position_m", def.position_m),
        check_count("blob.rings", def.rings, 1, 50),
        check::positive("blob.piece_radius_m", as_double(def.piece_radius_m)),
        check::positive("blob.stiffness_hz", as_double(def.stiffness_hz)),
        check::not_negative("blob.damping_ratio", as_double(def.damping_ratio)),
    });
    const float apart = 2 * def.piece_radius_m;
    constexpr float kHalfRoot3 = 0.8660254f;
    std::vector<Piece> pieces;
    const auto place_of = [&](int column, int row) {
        return def.position_m + apart * Vec2{static_cast<float>(column) + 0.5f * static_cast<float>(row),
                                             kHalfRoot3 * static_cast<float>(row)};
    };
    for (int ring = 0; builder.good() && ring <= def.rings; ++ring) {
        for (int row = -ring; row <= ring; ++row) {
            for (int column = -ring; column <= ring; ++column) {
                if (ring_of(column, row) != ring) continue;
                const BodyId body = builder.body({.position_m = place_of(column, row)});
                builder.shape(body, Circle{.radius_m = def.piece_radius_m}, def.shape);
                pieces.push_back({column, row, body});
            }
        }
    }
    const auto piece_at = [&](int column, int row) -> const Piece* {
        for (const Piece& piece : pieces) {
            if (piece.column == column && piece.row == row) return &piece;
        }
        return nullptr;
    };
    for (const Piece& piece : pieces) {
        for (const auto& step : kNeighbours) {
            const Piece* other = piece_at(piece.column + step[0], piece.row + step[1]);
            if (other == nullptr) continue;
            const Position from = place_of(piece.column, piece.row);
            WeldJointDef weld;
            builder.place(weld, piece.body, other->body,
                          from + 0.5f * (place_of(other->column, other->row) - from));
            weld.linear_frequency_hz = weld.angular_frequency_hz = def.stiffness_hz;
            weld.linear_damping_ratio = weld.angular_damping_ratio = def.damping_ratio;
            weld.strength = def.strength;
            builder.joint(weld);
        }
    }
    return builder.finish(Blob{});
}

}  // namespace cairn::physics
