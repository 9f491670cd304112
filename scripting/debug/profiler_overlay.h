// The profiler as it is seen (F3): milliseconds of the frame, the scripts and each stage of the step, and
// beside them how exact the physics was for it.
#pragma once

#include <cairn/physics/world.h>

#include "debug/frame_meter.h"

namespace cairn::scripting {

class ProfilerOverlay {
  public:
    /// At the top left of the picture.
    void draw(const FrameMeter& meter, const Context& context, std::size_t lua_bytes, engine::FontId font);

  private:
    /// What takes a walk over the worlds to know; found now and then.
    struct Slow {
        physics::Counts counts;
        double penetration_m = 0;
        double joint_error_m = 0;
        double joint_error_rad = 0;
        int islands = 0;
        double resident_mb = 0;
    };
    void update_slow(const Context& context);

    Slow slow_;
    int frames_until_slow_ = 0;
};

}  // namespace cairn::scripting
