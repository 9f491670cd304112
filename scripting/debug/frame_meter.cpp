// The ring of the last frames.
#include "debug/frame_meter.h"

#include <algorithm>

#include "bind/physics_objects.h"

namespace cairn::scripting {

void FrameMeter::turn(bool on, const Context& context) {
    is_on_ = on;
    frames_.clear();
    next_ = 0;
    now_ = {};
    totals_ = {};
    frame_start_ = {};
    for (WorldObject* world : context.worlds) world->world->set_profiling(on || world->is_profiled);
}

void FrameMeter::end_frame(const Context& context, std::uint64_t lua_allocated) {
    if (!is_on_) return;
    steps_before_.resize(context.worlds.size(), 0);
    for (std::size_t i = 0; i < context.worlds.size(); ++i) {
        physics::World& world = *context.worlds[i]->world;
        world.set_profiling(true);  // it may be new
        const std::uint64_t steps = world.step_count() - std::min(world.step_count(), steps_before_[i]);
        steps_before_[i] = world.step_count();
        const physics::Profile& profile = world.profile();
        for (const physics::Stage stage : physics::kStages)
            now_.stages[stage] += static_cast<double>(steps) * profile[stage];
        now_.physics_ms += static_cast<double>(steps) * profile.total_ms();
    }
    const bool is_first = frame_start_ == Clock::time_point{};
    if (!is_first) {
        now_.frame_ms = ms_since(frame_start_);
        now_.lua_allocated = lua_allocated - std::min(lua_allocated, lua_allocated_before_);
        ++totals_.frames;
        totals_.work_ms += now_.work_ms();
        if (now_.work_ms() > totals_.slowest.work_ms()) totals_.slowest = now_;
        totals_.draw_calls = std::max(totals_.draw_calls, context.services.renderer.stats().draw_calls);
        if (frames_.size() < kHistory) {
            frames_.push_back(now_);
        } else {
            frames_[next_] = now_;
            next_ = (next_ + 1) % kHistory;
        }
    }
    now_ = {};
    frame_start_ = Clock::now();
    lua_allocated_before_ = lua_allocated;
}

std::vector<FrameFigures> FrameMeter::history() const {
    std::vector<FrameFigures> frames(frames_.begin() + static_cast<std::ptrdiff_t>(next_), frames_.end());
    frames.insert(frames.end(), frames_.begin(), frames_.begin() + static_cast<std::ptrdiff_t>(next_));
    return frames;
}

FrameFigures FrameMeter::mean() const {
    constexpr std::size_t kFrames = 15;
    const std::vector<FrameFigures> frames = history();
    const std::size_t count = std::min(kFrames, frames.size());
    FrameFigures sum;
    for (std::size_t i = frames.size() - count; i < frames.size(); ++i) {
        const FrameFigures& frame = frames[i];
        const double share = 1.0 / static_cast<double>(count);
        sum.frame_ms += share * frame.frame_ms;
        sum.physics_ms += share * frame.physics_ms;
        for (std::size_t part = 0; part < kFrameParts; ++part)
            sum.part_ms[part] += share * frame.part_ms[part];
        for (const physics::Stage stage : physics::kStages) sum.stages[stage] += share * frame.stages[stage];
        sum.lua_allocated += frame.lua_allocated;
    }
    if (count > 0) sum.lua_allocated /= count;
    return sum;
}

}  // namespace cairn::scripting
