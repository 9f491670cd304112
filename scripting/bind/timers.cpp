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

std::uint64_t Timers::add(std::uint64_t now, double delay_s, bool repeats, int function) {
    const Timer timer{++made_, function, repeats, delay_s, now, 0};
    waiting_[{now + frames_of(delay_s, updates_per_second_), timer.number}] = timer;
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

void Timers::repeat(Timer timer, std::uint64_t now) {
    ++timer.turns;
    const double passed_s = static_cast<double>(timer.turns + 1) * timer.period_s;
    const std::uint64_t due = std::max(now + 1, timer.start + frames_of(passed_s, updates_per_second_));
    waiting_[{due, timer.number}] = timer;
}

}  // namespace cairn::scripting
