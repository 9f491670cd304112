// Boxes of the broad phase brought up to date for many bodies, eight shapes at a time.
#pragma once

#include <vector>

#include "world/body_lanes.h"
#include "world/box_cover_kernel.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Takes awake bodies one after another, and makes those of their boxes anew that no longer hold what they
/// must, and sets what the bodies may move before that has to be looked at again. A box holds its shape on
/// all of the way that the body is expected to go, which is none unless it is told. Several threads may have
/// one each, with bodies of their own. All is done when `finish` returns; `untold` then names the shapes
/// whose boxes the broad phase is to be told, in the order of the bodies.
class BoxCover {
  public:
    BoxCover(Stores& stores, std::vector<int>& untold) : stores_(stores), untold_(untold) {}

    /// Boxes about where the body is.
    void add(int body) { add_shapes(body, kStands, 0, false); }
    /// Boxes about its way within the step, which is that of a lane. `goes_along`: they are made anew, and
    /// hold each shape in each of its turns at any place of the way (broad/box_way.h).
    void add(int body, const AheadLanes& ahead, int lane, bool goes_along) {
        moving_ = true;
        add_shapes(body, ahead, lane, goes_along);
    }
    void finish() {
        if (count_ > 0) flush();
    }

  private:
    static constexpr AheadLanes kStands{};

    void add_shapes(int body, const AheadLanes& ahead, int lane, bool goes_along);
    void look_at_shapes();
    void flush();

    Stores& stores_;
    std::vector<int>& untold_;
    CoverLanes lanes_;
    Aabb unasked_{};
    // Shapes that have been asked for, and how their bodies are known.
    Lanes<int> shapes_{};
    Lanes<int> rows_{};
    Lanes<float> rounding_{};
    int count_ = 0;
    bool moving_ = false;
};

}  // namespace cairn::physics
