#include "world/box_cover.h"

#include <algorithm>
#include <limits>

namespace cairn::physics {

void BoxCover::add(int body, const AheadLanes& ahead, int lane, bool goes_along) {
    moving_ = true;
    add(body, {{ahead.way_x[lane], ahead.way_y[lane]},
               ahead.turn[lane],
               ahead.room[lane],
               ahead.rounding[lane],
               goes_along});
}

void BoxCover::add(int body, const Way& way) {
    const int shape = stores_.bodies.slots[body].first_shape;
    if (shape != kNone) stores_.shapes.ask_for(shape);
    if (waiting_count_ == kLanes) take_waiting();
    waiting_[waiting_count_] = body;
    ways_[waiting_count_++] = way;
}

void BoxCover::take_waiting() {
    for (int i = 0; i < waiting_count_; ++i) take(waiting_[i], ways_[i]);
    waiting_count_ = 0;
}

void BoxCover::take(int body, const Way& way) {
    const BodyRecord& record = stores_.bodies.slots[body];
    stores_.bodies.rows(RowSet::Awake).box_slack[record.row] = std::numeric_limits<float>::infinity();
    for (int s = record.first_shape; s != kNone; s = stores_.shapes[s].next_of_body) {
        if (count_ == kLanes) flush();
        const ShapeRecord& shape = stores_.shapes[s];
        const int lane = count_++;
        lanes_.way_x[lane] = way.way_m.x;
        lanes_.way_y[lane] = way.way_m.y;
        lanes_.turn[lane] = way.turn_rad;
        lanes_.room[lane] = way.room_m;
        lanes_.margin[lane] = shape.margin_m;
        lanes_.radius[lane] = shape.convex().radius();
        lanes_.count[lane] = shape.convex().count();
        lanes_.places[lane] = &stores_.bodies.places[body];
        lanes_.centers[lane] = &record.mass.center_m;
        lanes_.shapes[lane] = &shape.convex();
        lanes_.boxes[lane] = &stores_.fat_boxes[s];
        // From the lane on, so that lanes without a shape of their own are as the last one.
        const unsigned onward = kAllLanes << lane & kAllLanes;
        lanes_.right_boxes =
            static_cast<LaneBits>((lanes_.right_boxes & ~onward) | (shape.convex().is_box ? onward : 0));
        lanes_.going_along =
            static_cast<LaneBits>((lanes_.going_along & ~onward) | (way.goes_along ? onward : 0));
        if (!shape.convex().is_box) lanes_.most_points = std::max(lanes_.most_points, shape.convex().count());
        shapes_[lane] = s;
        rows_[lane] = record.row;
        rounding_[lane] = way.rounding_m;
    }
}

void BoxCover::flush() {
    // Lanes without a shape of their own do what the last one does.
    const int last = count_ - 1;
    for (int lane = count_; lane < kLanes; ++lane) {
        lanes_.way_x[lane] = lanes_.way_x[last];
        lanes_.way_y[lane] = lanes_.way_y[last];
        lanes_.turn[lane] = lanes_.turn[last];
        lanes_.room[lane] = lanes_.room[last];
        lanes_.margin[lane] = lanes_.margin[last];
        lanes_.radius[lane] = lanes_.radius[last];
        lanes_.count[lane] = lanes_.count[last];
        lanes_.places[lane] = lanes_.places[last];
        lanes_.centers[lane] = lanes_.centers[last];
        lanes_.shapes[lane] = lanes_.shapes[last];
        lanes_.boxes[lane] = lanes_.boxes[last];
    }
    const LaneBits anew = cover_boxes(lanes_, moving_);
    std::vector<float>& slack = stores_.bodies.rows(RowSet::Awake).box_slack;
    for (int lane = 0; lane < count_; ++lane) {
        if ((anew >> lane & 1) != 0) untold_.push_back(shapes_[lane]);
        // Long ways are rounded when they are added up.
        slack[rows_[lane]] = std::min(slack[rows_[lane]], lanes_.slack[lane] - rounding_[lane]);
    }
    count_ = 0;
    lanes_.most_points = 0;
}

}  // namespace cairn::physics
