#include "world/box_cover.h"

#include <algorithm>
#include <limits>

namespace cairn::physics {

void BoxCover::add_shapes(int body, const AheadLanes& ahead, int lane, bool goes_along) {
    const BodyRecord& record = stores_.bodies.slots[body];
    stores_.bodies.rows(RowSet::Awake).box_slack[record.row] = std::numeric_limits<float>::infinity();
    for (int shape = record.first_shape; shape != kNone;) {
        if (count_ == kLanes) flush();
        stores_.shapes.ask_for(shape);
        const int to = count_++;
        lanes_.way_x[to] = ahead.way_x[lane];
        lanes_.way_y[to] = ahead.way_y[lane];
        lanes_.turn[to] = ahead.turn[lane];
        lanes_.room[to] = ahead.room[lane];
        lanes_.places[to] = &stores_.bodies.places[body];
        lanes_.centers[to] = &record.mass.center_m;
        lanes_.going_along = static_cast<LaneBits>(lanes_.going_along | (goes_along ? 1 : 0) << to);
        shapes_[to] = shape;
        rows_[to] = record.row;
        rounding_[to] = ahead.rounding[lane];
        // Most bodies have one shape, which need not be waited for here.
        shape = shape == record.last_shape ? kNone : stores_.shapes[shape].next_of_body;
    }
}

void BoxCover::look_at_shapes() {
    for (int lane = 0; lane < count_; ++lane) {
        const ShapeRecord& shape = stores_.shapes[shapes_[lane]];
        const Convex& convex = shape.convex();
        lanes_.margin[lane] = shape.margin_m;
        lanes_.radius[lane] = convex.radius();
        lanes_.count[lane] = convex.count();
        lanes_.shapes[lane] = &convex;
        lanes_.boxes[lane] = &stores_.fat_boxes[shapes_[lane]];
        lanes_.right_boxes = static_cast<LaneBits>(lanes_.right_boxes | (convex.is_box ? 1 : 0) << lane);
        if (!convex.is_box) lanes_.most_points = std::max(lanes_.most_points, convex.count());
    }
}

void BoxCover::flush() {
    look_at_shapes();
    // Lanes without a shape of their own look at that of the last one, and find a box that nobody asks for.
    const int last = count_ - 1;
    for (int lane = count_; lane < kLanes; ++lane) {
        lanes_.places[lane] = lanes_.places[last];
        lanes_.centers[lane] = lanes_.centers[last];
        lanes_.shapes[lane] = lanes_.shapes[last];
        lanes_.boxes[lane] = &unasked_;
        copy_lane_bit(lanes_.right_boxes, lane, lanes_.right_boxes, last);
    }
    const LaneBits anew = cover_boxes(lanes_, moving_);
    std::vector<float>& slack = stores_.bodies.rows(RowSet::Awake).box_slack;
    for (int lane = 0; lane < count_; ++lane) {
        if ((anew >> lane & 1) != 0) untold_.push_back(shapes_[lane]);
        // Long ways are rounded when they are added up.
        slack[rows_[lane]] = std::min(slack[rows_[lane]], lanes_.slack[lane] - rounding_[lane]);
    }
    count_ = 0;
    lanes_.right_boxes = lanes_.going_along = 0;
    lanes_.most_points = 0;
}

}  // namespace cairn::physics
