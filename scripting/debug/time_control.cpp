// Speeds are powers of two, from 1/16 to 4: a picture can catch up five updates (FixedStep), so faster would
// lose time.
#include "debug/time_control.h"

#include <algorithm>
#include <cmath>

namespace cairn::scripting {

bool TimeControl::press(engine::Key key) {
    constexpr int kSlowest = -4;
    constexpr int kFastest = 2;
    switch (key) {
        case engine::Key::F4:
            goes_back_ = true;
            is_paused_ = false;
            return true;
        case engine::Key::F6:
            is_paused_ = !is_paused_;
            return true;
        case engine::Key::F7:
            is_paused_ = true;
            ++steps_;
            return true;
        case engine::Key::F8:
            doublings_ = std::max(kSlowest, doublings_ - 1);
            return true;
        case engine::Key::F9:
            doublings_ = std::min(kFastest, doublings_ + 1);
            return true;
        default:
            return false;
    }
}

void TimeControl::release(engine::Key key) {
    if (key != engine::Key::F4 || !goes_back_) return;
    goes_back_ = false;
    is_paused_ = true;
}

double TimeControl::speed() const {
    return std::ldexp(1.0, doublings_);
}

std::string TimeControl::label() const {
    std::string label = goes_back_ ? "going back" : is_paused_ ? "paused" : "";
    if (doublings_ == 0) return label;
    if (!label.empty()) label += ", ";
    const std::string times = std::to_string(1 << std::abs(doublings_));
    return label + "speed " + (doublings_ < 0 ? "1/" + times : times);
}

}  // namespace cairn::scripting
