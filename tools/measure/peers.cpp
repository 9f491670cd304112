// Which other engines this program was built with.
#include "engine.h"

namespace cairn::measure {

std::unique_ptr<Engine> make_box2d(const WorldSetting& setting);
std::unique_ptr<Engine> make_chipmunk(const WorldSetting& setting);

std::span<const EngineKind> peers() {
    static const std::vector<EngineKind> found{
#ifdef CAIRN_MEASURE_BOX2D
        {"box2d 2.4", make_box2d, 8},
#endif
#ifdef CAIRN_MEASURE_CHIPMUNK
        {"chipmunk 7", make_chipmunk, 10},
#endif
    };
    return found;
}

std::span<const std::string_view> absent_peers() {
    static const std::vector<std::string_view> absent{
#ifndef CAIRN_MEASURE_BOX2D
        "box2d 2.4",
#endif
#ifndef CAIRN_MEASURE_CHIPMUNK
        "chipmunk 7",
#endif
    };
    return absent;
}

}  // namespace cairn::measure
