// An ordered map is enough: games have tens of timers, not thousands.
#include "bind/timers.h"

#include <algorithm>
#include <cmath>

namespace cairn::scripting {

std::uint64_t Timers::frames_of(double time_s, int updates_per_second) {
    // The tolerance lets 0.1 s be 6 updates although 0.1 * 60 is a little more than 6 in binary.
    const double frames = std::ceil(time_s * updates_per_second - 1e-6);
    constexpr double kMost = 1e15;  // half a million years
    return static_cast<std::uint64_t>(std::clamp(frames, 1.0, kMost));
}

std::uint64_t Timers::add(std::uint64_t now, std::uint64_t delay, bool repeats, int function) {
    const Timer timer{++made_, function, repeats ? delay : 0};
    waiting_[{now + delay, timer.number}] = timer;
    return timer.number;
}

std::optional<int> Timers::cancel(std::uint64_t number) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const auto& entry) { return entry.second.number == number; });
    if (found == waiting_.end()) return std::nullopt;
    const int function = found->second.function;
    waiting_.erase(found);
    return function;
}

std::optional<Timers::Timer> Timers::take_due(std::uint64_t now) {
    if (waiting_.empty() || waiting_.begin()->first.first > now) return std::nullopt;
    const Timer timer = waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
    return timer;
}

std::vector<int> Timers::take_all() {
    std::vector<int> functions;
    for (const auto& [due, timer] : waiting_) functions.push_back(timer.function);
    waiting_.clear();
    return functions;
}

void Timers::repeat(const Timer& timer, std::uint64_t now) {
    waiting_[{now + timer.period, timer.number}] = timer;
}

}  // namespace cairn::scripting
